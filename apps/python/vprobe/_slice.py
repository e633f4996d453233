"""Cuts: polygons of a sheet or a surface, with arrays and figures."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Union, overload

import numpy as np
import numpy.typing as npt

from . import _core
from ._added import own_array
from ._arguments import path, shown, text
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
        Of vectors through the sheet, positive toward its normal: of `vector_array`, or of the shown array if it has
        three components. None where there are no vectors.
    components, cut_cells : int
        Pieces that do not touch, and cells that are cut. 0 on a surface that has grown from a sheet.
    origin, normal : (float, float, float)
        Where the sheet stands.
    value : float or None
        Of a contour that has grown from a sheet; None for the sheet itself.
    """

    def __init__(self, cut: _core.Cut, sheet: int, data: Optional[Dataset] = None, view: Optional[_core.View] = None,
                 contour: Optional[int] = None) -> None:
        self._cut: Optional[_core.Cut] = cut  # None of a copy
        self._source = cut
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

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and name in self.keys()

    def __getitem__(self, name: str) -> Array:
        """The array of this name: ``"p"``, or ``"cell:p"`` where points and cells have one of the name.

        Raises
        ------
        KeyError
            Where there is none.
        """
        arrays = self._arrays()
        if isinstance(name, str):
            for place in ('point', 'cell'):
                if name in arrays[place]:
                    return arrays[place][name]
            place, _, rest = name.partition(':')
            if rest in arrays.get(place, {}):
                return arrays[place][rest]
        raise KeyError(f'{shown(name)}; there are {", ".join(self.keys()) or "no arrays"}')

    def __setitem__(self, name: str, values: npt.ArrayLike) -> None:
        """Gives a copy an array over its points or its polygons, by its length, or replaces the one of the name.

        Parameters
        ----------
        name : str
            ``"point:p"`` and ``"cell:p"`` tell of what it is, where there are as many points as polygons.
        values : array_like of shape (n,) or (n, components)
            It is copied.

        Raises
        ------
        UsageError
            Of a slice that is no copy: its arrays are the library's.
        InputError
            Where it fits neither the points nor the polygons, or both.
        """
        if self._cut is not None:
            raise UsageError(f'{shown(name)}: the arrays of a slice are read-only; take its copy(), or add the array to the '
                             'data set')
        place, plain, array = own_array(text(name, 'name'), values, len(self.points), len(self.polygons.offsets) - 1)
        self._arrays()[place][plain] = array

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
        """The flux through the boundary faces in the plane; None where `flux` is."""
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
        """Of vectors through the sheet, positive toward its normal; None where it shows none, and names none."""
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
        """A slice with writable arrays of its own, which takes new ones by ``copy["name"] = values``.

        `save`, `Dataset.render`, `to_vtk` and `to_pyvista` take it as it is. Its figures stay those of what was cut.
        """
        self._figure('area')
        arrays = self._arrays()
        copy: Slice = object.__new__(type(self))
        copy.__dict__.update(self.__dict__)
        copy._cut = None
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
            Another ending.
        OutputError
            Where it cannot be written.
        """
        name = path(file, 'file')
        (self._own_cut() if self._cut is None else self._cut).save(name)

    def _own_cut(self) -> _core.Cut:
        """The cut of a copy, for the library to save and to draw."""
        arrays = self._arrays()
        fields = [(name, place, values.shape[1] if values.ndim > 1 else 1, np.ascontiguousarray(values), '')
                  for place, of in arrays.items() for name, values in of.items()]
        alone = _core.View() if self._data is None or self.value is not None else self._data._view_of(self, 'save')
        return self._source.with_own(self._sheet, alone, {
            'points': np.ascontiguousarray(self.points, dtype=np.float64),
            'offsets': np.ascontiguousarray(self.polygons.offsets, dtype=np.int64),
            'connectivity': np.ascontiguousarray(self.polygons.connectivity, dtype=np.int64),
            'cells': np.ascontiguousarray(self.cells, dtype=np.int64),
            'blocks': np.ascontiguousarray(self.blocks, dtype=np.int32), 'fields': fields})

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
        self._cut.save(path(file, 'file'))

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
