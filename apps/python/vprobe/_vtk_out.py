"""Slices as VTK's data sets, which share the arrays."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Mapping

import numpy as np

if TYPE_CHECKING:
    from ._slice import Array, Ints, Slice
    from ._traces import Traces


def _array(values: Array, name: str) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk
    array = numpy_to_vtk(values)
    array.SetName(name)
    return array


def _ids(values: Ints) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
    return numpy_to_vtkIdTypeArray(values)


def _add(attributes: Any, arrays: Mapping[str, Array]) -> None:
    for name, values in arrays.items():
        attributes.AddArray(_array(values, name))


def _cells(offsets: Ints, connectivity: Ints) -> Any:
    from vtkmodules.vtkCommonDataModel import vtkCellArray
    cells = vtkCellArray()
    cells.SetData(_ids(offsets), _ids(connectivity))
    return cells


def _mesh(points: Array) -> Any:
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    mesh = vtkPolyData()
    places = vtkPoints()
    places.SetData(_array(points, 'Points'))
    mesh.SetPoints(places)
    return mesh


def polydata(piece: Slice) -> Any:
    """See `Slice.to_vtk`."""
    mesh = _mesh(piece.points)
    mesh.SetPolys(_cells(*piece.polygons))
    _add(mesh.GetPointData(), piece.point_data)
    _add(mesh.GetCellData(), {**piece.cell_data, 'vprobe:cell': piece.cells, 'vprobe:block': piece.blocks})
    return mesh


def lines(traces: Traces) -> Any:
    """See `Traces.to_vtk`."""
    mesh = _mesh(traces.points)
    mesh.SetLines(_cells(traces.offsets, np.arange(len(traces.points), dtype=np.int64)))
    _add(mesh.GetPointData(), {'time': traces.times})
    return mesh


def multiblock(pieces: Iterable[Slice]) -> Any:
    """See `Cut.to_vtk`."""
    from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
    blocks = vtkMultiBlockDataSet()
    for number, piece in enumerate(pieces):
        blocks.SetBlock(number, polydata(piece))
        blocks.GetMetaData(number).Set(blocks.NAME(), f'sheet {number}')
    return blocks
