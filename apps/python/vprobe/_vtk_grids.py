"""Data sets that share the arrays of VTK's."""
from __future__ import annotations

from typing import Any, Dict, Iterator, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._dataset import Dataset
from ._errors import InputError
from ._grids import CELL_SIZES
from ._lattices import EMPTY_CELL, HEXAHEDRON, cells_at_points, points_on_axes, visible_cells

Array = npt.NDArray[Any]


class NoVolume(InputError):
    """Surfaces and lines: of a composite they are left out."""


# Bits of vtkGhostType: of cells that are not to be shown (duplicate, refined, hidden), and of blanked points.
HIDDEN_CELL = 1 | 8 | 32
HIDDEN_POINT = 2
GHOSTS = 'vtkGhostType'
POLYHEDRON = 42
# Curved cells that a tolerance refines, by VTK's type: quadratic, Lagrange and Bezier ones.
CURVED_TYPES = (24, 25, 26, 27, 29, 31, 32, 33, 71, 72, 73, 78, 79, 80)
FLAT_TYPES = (*range(0, 10), 21, 22, 23, 28, 30, 34, 35, 36, *range(51, 55), *range(60, 64), 68, 69, 70, 75, 76, 77)


def numpy_of(array: Any, copy: bool, what: str) -> Array:
    """The numbers of a vtkDataArray, shared where they lie side by side."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    if not array.HasStandardMemoryLayout() or array.GetDataType() == 1:  # VTK_BIT
        if not copy:
            raise InputError(f'{what}: a {array.GetClassName()} keeps its values in another way than side by side; '
                             'use copy=True')
        number = 3 if array.GetDataType() == 1 else array.GetDataType()  # VTK_UNSIGNED_CHAR for bits
        plain = array.CreateDataArray(number)
        plain.DeepCopy(array)
        array = plain
    return vtk_to_numpy(array)  # type: ignore[no-any-return]


def fields_of(data: Any, copy: bool) -> List[Tuple[Any, ...]]:
    """What the library takes of the numeric arrays of a data set. Strings are left out."""
    fields: List[Tuple[Any, ...]] = []
    for place, attributes, count in (('point', data.GetPointData(), data.GetNumberOfPoints()),
                                     ('cell', data.GetCellData(), data.GetNumberOfCells())):
        for i in range(attributes.GetNumberOfArrays()):
            array = attributes.GetArray(i)
            if array is None or array.GetName() == GHOSTS:
                continue
            name = array.GetName() or f'array {i}'
            if array.GetNumberOfTuples() != count:
                raise InputError(f'the {place} array {name} has {array.GetNumberOfTuples()} tuples for {count} {place}s')
            fields.append((name, place, array.GetNumberOfComponents(), numpy_of(array, copy, f'the array {name}'),
                           _units_of(array)))
    return fields


def _shape_arrays(data: Any, copy: bool) -> List[Tuple[Any, ...]]:
    """The degrees and rational weights of curved cells that are marked as such and have another name."""
    arrays: List[Tuple[Any, ...]] = []
    for place, attributes, name, array in (
            ('cell', data.GetCellData(), 'HigherOrderDegrees', data.GetCellData().GetHigherOrderDegrees()),
            ('point', data.GetPointData(), 'RationalWeights', data.GetPointData().GetRationalWeights())):
        if array is not None and attributes.GetArray(name) is None:
            arrays.append((name, place, array.GetNumberOfComponents(), numpy_of(array, copy, f'the array {name}'), ''))
    return arrays


def _units_of(array: Any) -> str:
    information = array.GetInformation() if array.HasInformation() else None
    key = array.UNITS_LABEL() if information is not None else None
    return information.Get(key) or '' if information is not None and information.Has(key) else ''


def _hidden_cells(data: Any, lattice: Optional[Tuple[int, ...]]) -> Optional[Array]:
    """A mark for each cell: whether it is hidden, by itself or by a point of a lattice. None where none is."""
    hidden = None
    marks = data.GetCellData().GetArray(GHOSTS)
    if marks is not None:
        hidden = (numpy_of(marks, True, GHOSTS) & HIDDEN_CELL) != 0
    marks = data.GetPointData().GetArray(GHOSTS)
    if marks is not None and lattice is not None:
        of_points = cells_at_points((numpy_of(marks, True, GHOSTS) & HIDDEN_POINT) != 0, lattice)
        hidden = of_points if hidden is None else hidden | of_points
    return hidden if hidden is not None and hidden.any() else None


def _points_of(data: Any) -> Array:
    """The points of an image or a rectilinear grid, made."""
    points = points_on_axes(*_axes_of(data))
    if data.IsA('vtkImageData'):
        turn = np.array([[data.GetDirectionMatrix().GetElement(i, j) for j in range(3)] for i in range(3)])
        origin = np.array(data.GetOrigin())
        points = (points - origin) @ turn.T + origin
    return points


def _axes_of(data: Any) -> Tuple[Array, Array, Array]:
    if data.IsA('vtkImageData'):
        extent = data.GetExtent()
        axes = [data.GetOrigin()[a] + data.GetSpacing()[a] * np.arange(extent[2 * a], extent[2 * a + 1] + 1)
                for a in range(3)]
    else:
        axes = [numpy_of(array, True, 'an axis').astype(np.float64, copy=False) for array in (
            data.GetXCoordinates(), data.GetYCoordinates(), data.GetZCoordinates())]
    return axes[0], axes[1], axes[2]


def _places_of(data: Any, copy: bool) -> Array:
    """The points that a data set lists."""
    if data.GetPoints() is None:
        raise NoVolume(f'a {data.GetClassName()} without points; there is nothing to cut')
    return numpy_of(data.GetPoints().GetData(), copy, 'points')


def _lattice_block(data: Any, copy: bool) -> Dict[str, Any]:
    """An image, a rectilinear or a structured grid."""
    lattice = tuple(data.GetDimensions())
    if min(lattice) < 2:
        raise NoVolume(f'a {data.GetClassName()} of {" x ".join(map(str, lattice))} points is flat; there is no volume '
                         'to cut')
    hidden = _hidden_cells(data, lattice)
    is_image = data.IsA('vtkImageData')
    is_turned = is_image and not data.GetDirectionMatrix().IsIdentity()
    if is_turned and not copy:
        raise InputError('an image with a direction matrix: its points have to be made; use copy=True')
    if hidden is not None:
        points = _places_of(data, copy) if data.IsA('vtkStructuredGrid') else _points_of(data)
        return visible_cells(points, lattice, hidden)
    if is_turned:
        return {'kind': 'structured', 'points': lattice, 'coordinates': _points_of(data)}
    if is_image:
        extent, spacing = data.GetExtent(), data.GetSpacing()
        origin = tuple(data.GetOrigin()[a] + spacing[a] * extent[2 * a] for a in range(3))
        return {'kind': 'image', 'points': lattice, 'origin': origin, 'spacing': spacing}
    if data.IsA('vtkRectilinearGrid'):
        x, y, z = _axes_of(data)
        return {'kind': 'rectilinear', 'x': x, 'y': y, 'z': z}
    return {'kind': 'structured', 'points': lattice,
            'coordinates': _places_of(data, copy)}


def _faces_of(data: Any) -> Dict[str, Array]:
    """The faces of polyhedra, as a stream with offsets for all cells."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    if data.GetFaces() is None:
        raise InputError('polyhedra without faces')
    stream = vtk_to_numpy(data.GetFaces()).astype(np.int64, copy=False)
    starts = vtk_to_numpy(data.GetFaceLocations())
    # Other cells have -1; their faces begin, and end, where those of the next polyhedron begin.
    offsets = np.append(np.where(starts < 0, len(stream), starts), len(stream)).astype(np.int64)
    return {'face_offsets': np.minimum.accumulate(offsets[::-1])[::-1].copy(), 'face_stream': stream}


def _cells_block(data: Any, copy: bool, tolerance: float) -> Dict[str, Any]:
    """An unstructured or an explicit structured grid."""
    count = data.GetNumberOfCells()
    if count == 0:
        raise NoVolume(f'a {data.GetClassName()} without cells; there is nothing to cut')
    if data.IsA('vtkUnstructuredGrid'):
        types = numpy_of(data.GetCellTypesArray(), copy, 'cell types')
    else:
        types = np.full(count, HEXAHEDRON, np.uint8)
    # Mostly all cells are of one type, which two passes tell in no time.
    present = [int(types[0])] if types.min() == types.max() else np.flatnonzero(np.bincount(types)).tolist()
    refined = CURVED_TYPES if tolerance else ()
    curved = [each for each in present if each not in CELL_SIZES and each not in (*FLAT_TYPES, *refined, POLYHEDRON)]
    if curved:
        remedy = 'give a tolerance, or ' if all(each in CURVED_TYPES for each in curved) else ''
        raise InputError(f'cells of type {", ".join(map(str, curved))} are curved, or have other faces than cells that '
                         f'can be cut; {remedy}write the grid to a file, and use vprobe.open, which makes linear cells '
                         'of them')
    if all(each in FLAT_TYPES for each in present):
        raise NoVolume(f'a {data.GetClassName()} without cells that have a volume; there is nothing to cut')
    hidden = _hidden_cells(data, None)
    if hidden is not None:
        types = np.where(hidden, EMPTY_CELL, types).astype(np.uint8)
    cells = data.GetCells()
    # VTK's own filters trust the point numbers; the first cut looks at them in passing.
    return {'kind': 'unstructured', 'checks_ids_later': True, 'coordinates': _places_of(data, copy), 'types': types,
            'offsets': numpy_of(cells.GetOffsetsArray(), copy, 'offsets'),
            'connectivity': numpy_of(cells.GetConnectivityArray(), copy, 'connectivity'),
            'tolerance': float(tolerance), **(_faces_of(data) if POLYHEDRON in present else {})}


def grid_of(data: Any, copy: bool, tolerance: float = 0.0) -> Dict[str, Any]:
    """What the library takes of the grid of a vtkDataSet; InputError says what it cannot take."""
    if data.IsA('vtkImageData') or data.IsA('vtkRectilinearGrid') or data.IsA('vtkStructuredGrid'):
        return _lattice_block(data, copy)
    if data.IsA('vtkUnstructuredGrid') or data.IsA('vtkExplicitStructuredGrid'):
        return _cells_block(data, copy, tolerance)
    if data.IsA('vtkHyperTreeGrid'):
        raise InputError('a vtkHyperTreeGrid shares no arrays; make an unstructured grid of it by '
                         'vtkHyperTreeGridToUnstructuredGrid, or use vprobe.open')
    raise NoVolume(f'a {data.GetClassName()} has no volume to cut; an image, or a rectilinear, structured or '
                     'unstructured grid has')


def leaves_of(mesh: Any) -> Iterator[Tuple[str, Any]]:
    """The data sets of a composite with their names; of a data set itself."""
    if not mesh.IsA('vtkCompositeDataSet'):
        yield '', mesh
        return
    if mesh.IsA('vtkUniformGridAMR'):
        raise InputError(f'a {mesh.GetClassName()} has coarse cells beneath finer ones; write it to a file, and use '
                         'vprobe.open, which hides them')
    iterator = mesh.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        information = iterator.GetCurrentMetaData() if iterator.HasCurrentMetaData() else None
        name = information.Get(mesh.NAME()) if information is not None and information.Has(mesh.NAME()) else ''
        yield name or '', iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def blocks_of(mesh: Any, copy: bool, tolerance: float = 0.0) -> List[Tuple[Any, Dict[str, Any]]]:
    """The parts of a mesh that have a volume, with what the library takes of each."""
    if not hasattr(mesh, 'IsA') or not (mesh.IsA('vtkDataSet') or mesh.IsA('vtkCompositeDataSet')
                                        or mesh.IsA('vtkHyperTreeGrid')):
        raise InputError(f'{type(mesh).__name__} is no data set of VTK or PyVista; for numpy arrays there are '
                         'vprobe.image, rectilinear, structured, unstructured and polyhedra')
    blocks, refused = [], ''
    for name, data in leaves_of(mesh):
        try:
            block = grid_of(data, copy, tolerance)
        except InputError as error:
            if not mesh.IsA('vtkCompositeDataSet') or not isinstance(error, NoVolume):
                raise
            refused = f'; {error}'
            continue
        block['fields'] = fields_of(data, copy)
        if tolerance:
            block['fields'] += _shape_arrays(data, copy)
        block['name'] = name
        blocks.append((data, block))
    if not blocks:
        raise InputError(f'a {mesh.GetClassName()} without a data set that has a volume{refused}')
    return blocks


def wrap_vtk(mesh: Any, copy: bool, tolerance: float, classify: str, device: str) -> Dataset:
    """See `vprobe.wrap`."""
    blocks = [block for _, block in blocks_of(mesh, copy, tolerance)]
    return Dataset(_core.Dataset.wrap(blocks, classify, device))
