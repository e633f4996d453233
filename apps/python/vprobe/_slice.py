"""Cuts: polygons of a sheet or a surface, with arrays and figures."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union, overload

import numpy as np
import numpy.typing as npt

from . import _core
from ._errors import UsageError

if TYPE_CHECKING:
    from ._dataset import Dataset

Ints = npt.NDArray[np.int64]
Floats = npt.NDArray[np.float64]
Array = npt.NDArray[Any]


class Polygons(NamedTuple):
    """Polygon i has the points ``connectivity[offsets[i]:offsets[i + 1]]``, counter-clockwise seen against the normal."""

    offsets: Ints
    connectivity: Ints

    def __repr__(self) -> str:
        return f'<vprobe.Polygons: {len(self.offsets) - 1} polygons, {len(self.connectivity)} corners>'


class Slice:
    """Polygons that a sheet or a surface cuts from a data set.

    Arrays are read-only views of the library's memory, made when they are asked for first. They live as long as
    somebody has them, whatever becomes of the slice and of its data set. `copy` gives arrays of one's own.

    Attributes
    ----------
    points : (n, 3) float64
        In the grid's units.
    polygons : Polygons
        Offsets and connectivity, int64.
    cells, blocks : (n,) int64 and int32
        For each polygon the cell that it was cut from, as the input numbers it, and the block of that cell.
    area, boundary_area, nan_area : float
        In the grid's units, squared: of all polygons; of boundary faces in the plane, which are no part of the rest;
        where the value is not finite.
    mean, min, max : float or None
        Of the shown array, the mean weighted by area. None where there is no array.
    boundary_mean, boundary_flux : float or None
        The mean of the shown array over the boundary faces in the plane, and the flux through them.
    flux : float or None
        Of vectors through the sheet, where the slice was made with ``vectors=...``.
    components, cut_cells : int
        Pieces that do not touch, and cells that are cut. 0 on a surface that has grown from a sheet.
    origin, normal : (float, float, float)
        Where the sheet stands.
    value : float or None
        Of a contour that has grown from a sheet; None for the sheet itself.
    """

    def __init__(self, cut: _core.Cut, sheet: int, data: Optional[Dataset] = None, view: Optional[_core.View] = None,
                 contour: Optional[int] = None) -> None:
        self._cut: Optional[_core.Cut] = cut
        self._sheet = sheet
        self._data = data
        self._view = view
        self._mesh = cut.mesh(sheet) if contour is None else cut.contour(contour)
        self._figures: Optional[Dict[str, Any]] = None
        self._known: Dict[str, Any] = {}
        self.value = None if contour is None else cut.contour_value(contour)
        self.origin = tuple(cut.origin(sheet))
        self.normal = tuple(cut.normal(sheet))

    def _once(self, name: str, make: Any) -> Any:
        if name not in self._known:
            self._known[name] = make()
        return self._known[name]

    @property
    def n_points(self) -> int:
        """How many points there are."""
        return self._mesh.point_count

    @property
    def n_polygons(self) -> int:
        """How many polygons there are."""
        return self._mesh.polygon_count

    @property
    def points(self) -> Floats:
        """The points, (n, 3), in the grid's units."""
        return self._once('points', lambda: self._mesh.points())  # type: ignore[no-any-return]

    @property
    def polygons(self) -> Polygons:
        """The polygons, as offsets into a list of point numbers."""
        return self._once('polygons', lambda: Polygons(  # type: ignore[no-any-return]
            self._mesh.offsets(), self._mesh.connectivity()))

    @property
    def cells(self) -> Ints:
        """For each polygon the number of the cell that it was cut from."""
        return self._once('cells', lambda: self._mesh.cells())  # type: ignore[no-any-return]

    @property
    def blocks(self) -> npt.NDArray[np.int32]:
        """For each polygon the number of its block."""
        return self._once('blocks', lambda: self._mesh.blocks())  # type: ignore[no-any-return]

    def _arrays(self) -> Dict[str, Dict[str, Array]]:
        def make() -> Dict[str, Dict[str, Array]]:
            arrays: Dict[str, Dict[str, Array]] = {'point': {}, 'cell': {}}
            for name, place, values in self._mesh.arrays():
                arrays[place].setdefault(name, values)
            return arrays
        return self._once('arrays', make)  # type: ignore[no-any-return]

    @property
    def point_data(self) -> Mapping[str, Array]:
        """The arrays over points by their names, interpolated: (n,) or (n, components)."""
        return dict(self._arrays()['point'])

    @property
    def cell_data(self) -> Mapping[str, Array]:
        """The arrays over polygons by their names, taken from the cells: (n,) or (n, components)."""
        return dict(self._arrays()['cell'])

    def keys(self) -> List[str]:
        """The names of all arrays."""
        arrays = self._arrays()
        return [*arrays['point'], *(name for name in arrays['cell'] if name not in arrays['point'])]

    def __contains__(self, name: str) -> bool:
        return name in self.keys()

    def __getitem__(self, name: str) -> Array:
        """The array of this name: ``"p"``, or ``"cell:p"`` where points and cells have one of the name.

        Raises
        ------
        KeyError
            Where there is none.
        """
        arrays = self._arrays()
        for place in ('point', 'cell'):
            if name in arrays[place]:
                return arrays[place][name]
        place, _, rest = name.partition(':')
        if rest in arrays.get(place, {}):
            return arrays[place][rest]
        raise KeyError(f'{name!r}; there are {", ".join(self.keys()) or "no arrays"}')

    def _figure(self, name: str) -> Any:
        if self._figures is None:
            if self.value is None and self._cut is not None:
                self._figures = self._cut.figures(self._sheet)
            else:
                self._figures = {'area': _area(self.points, self.polygons)}
        return self._figures.get(name, 0 if name in ('components', 'cut_cells') else None)

    @property
    def area(self) -> float:
        """Of all polygons, in the grid's units, squared."""
        return float(self._figure('area'))

    @property
    def boundary_area(self) -> float:
        """Of boundary faces in the plane, which are no part of the rest."""
        return float(self._figure('boundary_area') or 0.0)

    @property
    def boundary_mean(self) -> Optional[float]:
        """The mean of the shown array over the boundary faces in the plane; None where there are none, or no array."""
        return self._figure('boundary_mean')  # type: ignore[no-any-return]

    @property
    def boundary_flux(self) -> Optional[float]:
        """The flux through the boundary faces in the plane; None where the slice was made without vectors."""
        return self._figure('boundary_flux')  # type: ignore[no-any-return]

    @property
    def nan_area(self) -> float:
        """Of the area, where the value is not finite."""
        return float(self._figure('nan_area') or 0.0)

    @property
    def mean(self) -> Optional[float]:
        """The mean of the shown array, weighted by area; None where there is none."""
        return self._figure('mean')  # type: ignore[no-any-return]

    @property
    def min(self) -> Optional[float]:
        """The least value of the shown array; None where there is none."""
        return self._figure('min')  # type: ignore[no-any-return]

    @property
    def max(self) -> Optional[float]:
        """The greatest value of the shown array; None where there is none."""
        return self._figure('max')  # type: ignore[no-any-return]

    @property
    def flux(self) -> Optional[float]:
        """Of vectors through the sheet; None where the slice was made without."""
        return self._figure('flux')  # type: ignore[no-any-return]

    @property
    def components(self) -> int:
        """Pieces that do not touch."""
        return int(self._figure('components'))

    @property
    def cut_cells(self) -> int:
        """Cells that are cut."""
        return int(self._figure('cut_cells'))

    def copy(self) -> Slice:
        """A slice with writable arrays of its own, which shares nothing with the library.

        `save` writes what was cut, so a copy cannot be saved; `to_vtk` and `to_pyvista` take it as it is.
        """
        self._figure('area')
        arrays = self._arrays()
        copy: Slice = object.__new__(type(self))
        copy.__dict__.update(self.__dict__)
        copy._cut, copy._data, copy._view = None, None, None
        copy._known = {
            'points': self.points.copy(),
            'polygons': Polygons(*(part.copy() for part in self.polygons)),
            'cells': self.cells.copy(),
            'blocks': self.blocks.copy(),
            'arrays': {place: {name: values.copy() for name, values in of.items()} for place, of in arrays.items()},
        }
        copy._mesh = _Counts(len(self.points), self.n_polygons)  # type: ignore[assignment]
        return copy

    def save(self, file: Union[str, os.PathLike[str]]) -> None:
        """Writes .vtp, .vtm, .pvtp, .ply or .csv, by the name's ending, with every array. Whole or not at all.

        Of a slice that is one sheet of several, or a contour, all that was cut with it is written.

        Raises
        ------
        UsageError
            Another ending, or a copy.
        OutputError
            Where it cannot be written.
        """
        if self._cut is None:
            raise UsageError('save: a copy is not kept by the library; save the slice that it was made of, or use to_vtk()')
        self._cut.save(os.fspath(file))

    def to_vtk(self) -> Any:
        """A ``vtkPolyData`` that shares the arrays; ``vprobe:cell`` and ``vprobe:block`` say where polygons come from."""
        from ._vtk_out import polydata
        return polydata(self)

    def to_pyvista(self) -> Any:
        """A ``pyvista.PolyData`` that shares the arrays."""
        import pyvista
        return pyvista.wrap(self.to_vtk())

    def __repr__(self) -> str:
        what = 'vprobe.Slice' if self.value is None else f'vprobe.Slice contour of {self.value:g}'
        mean = '' if self.mean is None else f', mean {self.mean:.6g}'
        return f'<{what}: {self.n_polygons} polygons, {self.n_points} points, area {self.area:.6g}{mean}>'


class _Counts(NamedTuple):
    point_count: int
    polygon_count: int


def _area(points: Floats, polygons: Polygons) -> float:
    """The sum of the polygons' areas, each by Newell's formula."""
    if len(polygons.connectivity) == 0:
        return 0.0
    here = points[polygons.connectivity]
    following = np.arange(1, len(here) + 1)
    following[polygons.offsets[1:] - 1] = polygons.offsets[:-1]
    # About a point of each polygon, so that a mesh far from the origin loses nothing.
    about = np.repeat(here[polygons.offsets[:-1]], np.diff(polygons.offsets), axis=0)
    crosses = np.cross(here - about, here[following] - about)
    return float(np.linalg.norm(np.add.reduceat(crosses, polygons.offsets[:-1]), axis=1).sum() / 2)


class Cut(Sequence[Slice]):
    """The cut of a probe: a `Slice` for each sheet."""

    def __init__(self, cut: _core.Cut, data: Dataset, view: Optional[_core.View] = None) -> None:
        self._cut = cut
        self._slices = [Slice(cut, sheet, data, view) for sheet in range(cut.sheet_count)]

    def __len__(self) -> int:
        return len(self._slices)

    @overload
    def __getitem__(self, sheet: int) -> Slice: ...

    @overload
    def __getitem__(self, sheet: slice) -> List[Slice]: ...

    def __getitem__(self, sheet: Union[int, slice]) -> Union[Slice, List[Slice]]:
        return self._slices[sheet]

    def __iter__(self) -> Iterator[Slice]:
        return iter(self._slices)

    @property
    def area(self) -> float:
        """Of all sheets, in the grid's units, squared."""
        return sum(each.area for each in self)

    def save(self, file: Union[str, os.PathLike[str]]) -> None:
        """Writes .vtp, .vtm, .pvtp, .ply or .csv, by the name's ending, with every array. Whole or not at all."""
        self._cut.save(os.fspath(file))

    def to_vtk(self) -> Any:
        """A ``vtkMultiBlockDataSet`` with a ``vtkPolyData`` for each sheet."""
        from ._vtk_out import multiblock
        return multiblock(self)

    def to_pyvista(self) -> Any:
        """A ``pyvista.MultiBlock`` with a mesh for each sheet."""
        import pyvista
        return pyvista.MultiBlock([each.to_pyvista() for each in self])

    def __repr__(self) -> str:
        polygons = sum(each.n_polygons for each in self)
        return f'<vprobe.Cut: {len(self)} sheets, {polygons} polygons, area {self.area:.6g}>'


class Traces:
    """Paths of particles that were launched from a sheet.

    Attributes
    ----------
    points : (n, 3) float64
        In the grid's units, each path from its earliest point to its latest.
    times : (n,) float64
        Of each point, from the launch; negative before it.
    offsets : (paths + 1,) int64
        Path i has the points ``offsets[i]:offsets[i + 1]``.
    """

    def __init__(self, offsets: Ints, points: Floats, times: Floats) -> None:
        self.offsets, self.points, self.times = offsets, points, times

    def __len__(self) -> int:
        return max(0, len(self.offsets) - 1)

    def __iter__(self) -> Iterator[Tuple[Floats, Floats]]:
        """Points and times of each path."""
        for begin, end in zip(self.offsets[:-1], self.offsets[1:]):
            yield self.points[begin:end], self.times[begin:end]

    def to_vtk(self) -> Any:
        """A ``vtkPolyData`` of poly lines, with the point array ``time``."""
        from ._vtk_out import lines
        return lines(self)

    def to_pyvista(self) -> Any:
        """A ``pyvista.PolyData`` of poly lines."""
        import pyvista
        return pyvista.wrap(self.to_vtk())

    def __repr__(self) -> str:
        return f'<vprobe.Traces: {len(self)} paths, {len(self.points)} points>'
