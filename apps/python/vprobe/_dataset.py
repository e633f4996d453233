"""Data sets: grids with arrays, and what makes cuts of them fast."""
from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

import numpy.typing as npt

from . import _core
from ._answers import Frame, PlanRow, Samples
from ._arguments import flag, number, shown, texts, whole
from ._contents import Contents
from ._errors import InputError, UsageError
from ._masks import places
from ._picture import Image
from ._probe import Probe, Vector
from ._settings import Progress, listener, put, view_of
from ._slice import Cut, Slice
from ._traces import Traces

if TYPE_CHECKING:
    from ._notebook import Viewer

Direction = Union[str, Vector]


def _uncopied(piece: Any, what: str) -> Any:
    if isinstance(piece, Slice) and piece._cut is None:
        raise UsageError(f'{what}: a copy cannot be; it takes a slice of this data set, as the one that was copied')
    return piece


class Dataset(Contents):
    """Grids with arrays. Make one by `vprobe.open`, `vprobe.wrap`, or from numpy arrays by `vprobe.structured` and others.

    Several threads may use one: their calls wait for each other. All calls that take their time let other threads of
    Python run, and end soon after Ctrl-C.

    Any setting of the program is a keyword argument here, by the name of its option with ``_`` for ``-``; the page
    docs/PYTHON.md lists them. A setting that cannot be raises UsageError.
    """

    # Cuts.

    def _view(self, probe: Optional[Probe], settings: Mapping[str, Any]) -> _core.View:
        return view_of(probe, settings)

    def cut(self, probe: Optional[Probe] = None, *, progress: Progress = None, **settings: Any) -> Cut:
        """Cuts by a probe.

        Parameters
        ----------
        probe : Probe, optional
            By default one sheet, the plane through the center of the bounds whose normal is z.
        progress : bool or callable, optional
            True prints what takes its time; a callable is given each such line.
        **settings
            Any setting of the program.

        Returns
        -------
        Cut
            A `Slice` for each sheet.

        Raises
        ------
        UsageError, InputError
            A setting that cannot be, or an array that is not there.

        Examples
        --------
        >>> import vprobe
        >>> data = vprobe.open('demo:shell:16')
        >>> len(data.cut(vprobe.Probe.trihedral()))
        3
        """
        view = self._view(probe, settings)
        return Cut(self._core.cut(view, listener(progress)), self, view)

    def slice(self, surface: Optional[str] = None, *, normal: Optional[Direction] = None,
              origin: Union[str, Vector] = 'center', up: Optional[Direction] = None, array: Optional[str] = None,
              component: Union[int, str, None] = None, window: Optional[Tuple[float, float]] = None,
              threshold: Optional[Tuple[float, float]] = None, crinkle: bool = False, progress: Progress = None,
              **settings: Any) -> Slice:
        """Cuts by one sheet: a plane, or a surface about its place.

        Parameters
        ----------
        surface : str, optional
            Instead of the plane: ``"sphere:R"``, ``"cylinder:R"``, ``"z = sin(x)"`` or any other expression, a grid
            surface such as ``"k=3"``, or ``"patch=NAME"``.
        normal, up : sequence of 3 floats or str, optional
            Directions of any length, or ``"x"``, ``"-z"`` and the like. By default z and y.
        origin : sequence of 3 floats or "center"
            In the grid's units.
        array : str, optional
            What the figures are of: ``"p"``, or ``"cell:p"`` where points and cells have one of the name. By default
            the first array. Every array comes with the slice.
        component : int or str, optional
            Of vectors: ``"x"``, a number from 0, or ``"magnitude"``, which is the default.
        window : (float, float), optional
            Width and height of the sheet. By default it covers the whole cut.
        threshold : (float, float), optional
            The search ends at cells with values outside.
        crinkle : bool
            The cells that are cut, whole.
        progress : bool or callable, optional
            True prints what takes its time; a callable is given each such line.
        **settings
            Any other setting of the program.

        Returns
        -------
        Slice
            Polygons with arrays and figures.

        Raises
        ------
        UsageError, InputError
            A setting that cannot be, or an array that is not there.

        Examples
        --------
        >>> import vprobe
        >>> data = vprobe.open('demo:shell:16')
        >>> s = data.slice(normal=(.3, .5, .8))
        >>> s.points.shape[1], s.points.flags.writeable
        (3, False)
        """
        known: Dict[str, Any] = dict(
            surface=surface, normal=normal, origin=origin, up=up, array=array, component=component, window=window,
            threshold=threshold, crinkle=flag(crinkle, 'crinkle') or None)
        return self.cut(progress=progress, **known, **settings)[0]

    def slice_orthogonal(self, **settings: Any) -> Cut:
        """Three slices at right angles to x, y and z, in this order, through `origin` (the center of the bounds)."""
        return self.cut(Probe.trihedral(), **settings)

    def slice_along_axis(self, n: int = 5, axis: Direction = 'z', **settings: Any) -> Cut:
        """Parallel slices, each in the middle of one of `n` equal slabs of the bounds along `axis`.

        Parameters
        ----------
        n : int
            How many, 1 to 64.
        axis : str or sequence of 3 floats
            The normal of the slices.
        **settings
            As of `cut`.
        """
        return self.cut(Probe.stack(whole(n, 'n'), normal=axis), **settings)

    def isosurface(self, value: float, array: Optional[str] = None, **settings: Any) -> Slice:
        """The surface on which a point array has a value.

        Parameters
        ----------
        value : float
            In the array's units.
        array : str, optional
            By default the first array. Of vectors, their length.
        **settings
            As of `cut`.
        """
        return self.cut(surface=f'iso:{number(value, "value")!r}', array=array, **settings)[0]

    def _view_of(self, piece: Slice, what: str) -> _core.View:
        """The view of this one sheet."""
        if not isinstance(piece, Slice) or piece._data is not self or piece._view is None or piece.value is not None:
            raise UsageError(f'{what}: {shown(piece)} cannot be; it takes a slice of this data set, as slice() and cut() '
                             'give it')
        view = _core.View(piece._view)
        if piece._source.sheet_count > 1:
            sheets = json.loads(self._core.probe_text(view))
            sheets['sheets'] = [sheets['sheets'][piece._sheet]]
            state = json.loads(view.json())
            probe = {key: state['probe'][key] for key in ('array', 'component', 'threshold', 'crinkle')
                     if key in state.get('probe', {})}
            view = _core.View()
            view.read(json.dumps({**state, 'probe': {**probe, 'probe': sheets}}))
        return view

    def grow_contour(self, piece: Slice, value: float, *, depth: Optional[float] = None,
                     progress: Progress = None) -> Slice:
        """Grows the surface of one value from a slice, on both sides of it.

        Parameters
        ----------
        piece : Slice
            A plane sheet of this data set, which shows a point array.
        value : float
            That the slice has somewhere.
        depth : float, optional
            How far the surface goes, in the grid's units. By default it follows from the window.

        Returns
        -------
        Slice
            The surface, with all arrays. `value` tells its value.

        Raises
        ------
        UsageError
            Where the slice does not have the value, or is no plane.
        """
        view = self._view_of(_uncopied(piece, 'grow_contour'), 'grow_contour')
        view.set('contour', repr(number(value, 'value')))
        if depth is not None:
            view.set('contour_depth', repr(number(depth, 'depth')))
        cut = self._core.cut(view, listener(progress))
        if cut.contour_count == 0 or cut.contour(0).polygon_count == 0:
            raise UsageError(f'grow_contour: the slice has no value {value:g}; it has {piece.min} to {piece.max}')
        return Slice(cut, 0, self, view, contour=0)

    def trace(self, piece: Slice, array: Optional[str] = None, *, kind: str = 'lines', progress: Progress = None,
              **settings: Any) -> Traces:
        """Launches particles from a slice, and follows them through a field of vectors.

        Parameters
        ----------
        piece : Slice
            A plane sheet of this data set.
        array : str, optional
            Of three components. By default the velocity by its name or units, else the first such array.
        kind : str
            ``lines``, ``tufts``, ``ribbons`` or ``tubes``: how far they go, and how a picture draws them.
        **settings
            ``vector_lattice``, ``vector_steps``, ``vector_dt``, ``vector_direction`` and others.
        """
        view = self._view_of(_uncopied(piece, 'trace'), 'trace')
        for key, setting in dict(vectors=kind, vector_array=array, **settings).items():
            put(view, key, setting)
        return Traces(*self._core.cut(view, listener(progress)).traces(0))

    def plan(self, probe: Optional[Probe] = None, **settings: Any) -> List[PlanRow]:
        """Why a cut goes the way it goes: the strategy of each sheet in each block, with the reason.

        Parameters are those of `cut`. Nothing is cut.
        """
        return [PlanRow(*row) for row in self._core.plan(self._view(probe, settings))]

    def sample(self, points: npt.ArrayLike, arrays: Sequence[str] = ()) -> Samples:
        """Values at points, interpolated in the cells that hold them.

        Parameters
        ----------
        points : array_like of shape (n, 3)
            In the grid's units.
        arrays : sequence of str
            By default all.

        Returns
        -------
        Samples
            Arrays by name; NaN outside the grid.
        """
        at = places(points, 'points')
        if at.ndim != 2 or at.shape[1] != 3:
            raise InputError(f'points of the shape {at.shape}; it has to be (n, 3)')
        cells, blocks, columns = self._core.sample(at, texts(arrays, 'arrays'))
        return Samples(cells, blocks, {
            name: values if components == 1 else values.reshape(-1, components)
            for name, components, values in columns})

    # Pictures.

    def render(self, probe: Union[Probe, Slice, None] = None, *, size: Tuple[int, int] = (1280, 720),
               progress: Progress = None, **settings: Any) -> Image:
        """Draws a cut, on a Vulkan device that opens for the first picture.

        Parameters
        ----------
        probe : Probe or Slice, optional
            A slice is drawn with the settings that it was made with. A copy is drawn with the arrays that it has.
        size : (int, int)
            Width and height, in pixels.
        progress : bool or callable, optional
            True prints what takes its time; a callable is given each such line.
        **settings
            As of `cut`, and those of the look: ``colormap``, ``camera``, ``opacity``, ``background`` and others.

        Returns
        -------
        Image
            A uint8 array of the shape (height, width, 4).

        Raises
        ------
        DeviceError
            No usable device, or one that was lost. The next picture may open another.
        """
        if isinstance(probe, Slice):
            view = self._view_of(probe, 'render')
            for key, setting in dict(size=size, **settings).items():
                put(view, key, setting)
            cut = probe._cut if probe._cut is not None else probe._own_cut()
            return Image._of(self._core.render(view, cut, listener(progress)))
        view = self._view(probe, dict(size=size, **settings))
        return Image._of(self._core.render(view, None, listener(progress)))

    def sweep(self, probe: Optional[Probe] = None, *, path: Optional[str] = None, frames: Optional[int] = None,
              draws: bool = True, progress: Progress = None, **settings: Any) -> Iterator[Frame]:
        """Moves a probe along a path, and cuts and draws it frame by frame.

        Parameters
        ----------
        probe : Probe, optional
            As of `cut`.
        path : str, optional
            ``translate`` (the default), ``rotate``, ``spin``, ``revolve`` or ``times``, which shows the times of the
            files one by one.
        frames : int, optional
            How many. Not together with ``times``.
        draws : bool
            False: frames have no pictures, and no device is needed.
        progress : bool or callable, optional
            True prints what takes its time; a callable is given each such line.
        **settings
            As of `render`.

        Yields
        ------
        Frame
            Each with its cut and its picture.
        """
        view = self._view(probe, dict(path=path, frames=frames, **settings))
        flag(draws, 'draws')
        index, count = 0, 1
        while index < count:
            count, time, cut, pixels = self._core.frame(view, index, draws, listener(progress))
            yield Frame(index, count, Cut(cut, self), Image._of(pixels) if draws else None, time)
            index += 1

    def view(self, probe: Optional[Probe] = None, **settings: Any) -> Viewer:
        """Shows the cut in a notebook; with ipywidgets there are sliders for position, normal, array and opacity.

        Parameters are those of `render`.
        """
        from ._notebook import Viewer
        return Viewer(self, probe, settings)
