"""Data sets of VTK's meshes that are kept as long as the points and cells of these do not change."""
from __future__ import annotations

from typing import Any, List, Optional, Tuple

from . import _core
from ._dataset import Dataset
from ._vtk_grids import GHOSTS, blocks_of, fields_of, leaves_of

Stamp = Tuple[Any, ...]


def _stamp_of(thing: Any) -> Stamp:
    return () if thing is None else (thing.__this__, thing.GetMTime())


def _grid_stamp(data: Any) -> Stamp:
    """Changes whenever the points, the cells or the hidden cells of a data set do, by their own times."""
    ghosts = tuple(_stamp_of(attributes.GetArray(GHOSTS)) for attributes in (data.GetPointData(), data.GetCellData()))
    if data.IsA('vtkImageData'):
        matrix = data.GetDirectionMatrix()
        turn = tuple(matrix.GetElement(i, j) for i in range(3) for j in range(3))
        return ghosts, data.GetExtent(), data.GetOrigin(), data.GetSpacing(), turn
    if data.IsA('vtkRectilinearGrid'):
        return ghosts, data.GetDimensions(), *(_stamp_of(axis) for axis in (
            data.GetXCoordinates(), data.GetYCoordinates(), data.GetZCoordinates()))
    points = data.GetPoints() if hasattr(data, 'GetPoints') else None
    places = _stamp_of(points.GetData()) if points is not None else ()
    if data.IsA('vtkStructuredGrid'):
        return ghosts, data.GetDimensions(), places
    cells = data.GetCells() if hasattr(data, 'GetCells') else None
    if cells is None or not hasattr(cells, 'GetConnectivityArray'):
        return ghosts, _stamp_of(data)
    types = data.GetCellTypesArray() if hasattr(data, 'GetCellTypesArray') else None
    faces = data.GetFaces() if hasattr(data, 'GetFaces') else None
    return ghosts, places, *(_stamp_of(each) for each in (
        cells.GetConnectivityArray(), cells.GetOffsetsArray(), types, faces))


def _fields_stamp(data: Any) -> Stamp:
    return tuple((array.GetName(), *_stamp_of(array)) for attributes in (data.GetPointData(), data.GetCellData())
                 for array in map(attributes.GetArray, range(attributes.GetNumberOfArrays())) if array is not None)


class Kept:
    """Gives the data set of a mesh, the one it gave before where only arrays have changed since."""

    def __init__(self, copy: bool = False, classify: str = 'auto', device: str = '') -> None:
        self._options = copy, classify, device
        self._grids: Optional[List[Stamp]] = None
        self._fields: Optional[List[Stamp]] = None
        self._parts: List[int] = []
        self._data: Optional[Dataset] = None

    def data_of(self, mesh: Any) -> Dataset:
        """The data set of a mesh; InputError where it has none."""
        copy, classify, device = self._options
        leaves = [data for _, data in leaves_of(mesh)] if hasattr(mesh, 'IsA') else []
        leaves = [data for data in leaves if data.IsA('vtkDataSet')]
        grids = [_grid_stamp(data) for data in leaves]
        fields = [_fields_stamp(data) for data in leaves]
        if self._data is None or grids != self._grids:
            self._data = None  # its memory is free while the next is made
            blocks = blocks_of(mesh, copy)
            self._data = Dataset(_core.Dataset.wrap([block for _, block in blocks], classify, device))
            self._parts = [next(i for i, leaf in enumerate(leaves) if leaf is data) for data, _ in blocks]
            self._grids = grids
        elif fields != self._fields:
            self._data._core.set_fields([fields_of(leaves[i], copy) for i in self._parts])
        self._fields = fields
        return self._data
