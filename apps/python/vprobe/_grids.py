"""Data sets from numpy arrays."""
from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._dataset import Dataset
from ._arguments import arrays, flag, number, several, shown, text, whole, wrong
from ._arguments import options as known_options
from ._errors import InputError, UsageError
from ._lattices import cells_at_points, points_on_axes, visible_cells
from ._masks import places, refuse_mask, unmasked

Arrays = Optional[Mapping[str, npt.NDArray[Any]]]
Lattice = Tuple[int, int, int]

# VTK's numbers of the cells that can be cut, and how many points they have.
CELL_TYPES = {'tetra': 10, 'voxel': 11, 'hexahedron': 12, 'wedge': 13, 'pyramid': 14, 'pentagonal_prism': 15,
              'hexagonal_prism': 16, 'quadratic_tetra': 24, 'quadratic_hexahedron': 25, 'quadratic_wedge': 26,
              'quadratic_pyramid': 27, 'polyhedron': 42}
CELL_SIZES = {10: 4, 11: 8, 12: 8, 13: 6, 14: 5, 15: 10, 16: 12}


def usable_masked(given: Any, name: str, copy: bool) -> Tuple[npt.NDArray[Any], Optional[npt.NDArray[Any]]]:
    """The array as it is, or, where the library could not use it so and `copy` is true, one that it can.

    Masked floats are NaN in a copy. Of other types the second array tells which values are masked.
    """
    if not flag(copy, 'copy') and not isinstance(given, np.ndarray):
        raise InputError(f'{name}: {type(given).__name__} is no numpy array; use copy=True, or numpy.asarray()')
    try:
        array, mask = unmasked(given, np.asanyarray(given), name)
    except (ValueError, TypeError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f'{name}: {shown(given)} cannot be; it takes numbers in an array') from None
    if array.dtype.kind not in 'biuf' and copy:
        raise InputError(f'{name}: {shown(given)} cannot be; it takes numbers')
    return (_converted(array) if copy else array), mask


def usable(given: Any, name: str, copy: bool) -> npt.NDArray[Any]:
    """The same for arrays whose integers cannot be masked."""
    array, mask = usable_masked(given, name, copy)
    refuse_mask(mask, name, 'integers have no NaN')
    return array


def _converted(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    if array.dtype.kind == 'b':
        array = array.astype(np.uint8)
    elif array.dtype.kind == 'f' and array.dtype.itemsize not in (4, 8):
        array = array.astype(np.float32 if array.dtype.itemsize == 2 else np.float64)
    return np.ascontiguousarray(array, dtype=array.dtype.newbyteorder('='))


def fields_of(values: Arrays, place: str, count: int, lattice: Optional[Lattice], copy: bool,
              hidden: Dict[str, npt.NDArray[Any]]) -> List[Tuple[Any, ...]]:
    """What the library takes of arrays over `count` points or cells; `lattice` is (nx, ny, nz) of them.

    Points and cells of a lattice at which integers are masked are marked in hidden['point'] and hidden['cell'].
    """
    fields: List[Tuple[Any, ...]] = []
    for name, given in arrays(values, f'{place}_data').items():
        array, mask = usable_masked(given, f'the array {name}', copy)
        shapes = [(count,)] + ([lattice[::-1]] if lattice else [])
        shape = next((shape for shape in shapes if array.shape[:len(shape)] == shape), None)
        if shape is None or array.ndim > len(shape) + 1:
            wanted = ' or '.join(str(each) for each in shapes)
            raise InputError(f'the array {name} has the shape {array.shape}; for these {place}s it has to be {wanted}, '
                             'with the components behind')
        if lattice is None:
            refuse_mask(mask, f'the array {name}', 'integers have no NaN')
        elif mask is not None:
            marks = mask.reshape(count, -1).any(axis=1)
            hidden[place] = hidden[place] | marks if place in hidden else marks
        components = array.shape[len(shape)] if array.ndim > len(shape) else 1
        fields.append((name, place, components, array, ''))
    return fields


def _dataset(block: Dict[str, Any], point_data: Arrays, cell_data: Arrays, points: int, cells: int,
             lattice: Optional[Lattice], copy: bool, options: Mapping[str, str]) -> Dataset:
    known_options(options, ('classify', 'device'), 'vprobe')
    of_cells = None if lattice is None else (lattice[0] - 1, lattice[1] - 1, lattice[2] - 1)
    hidden: Dict[str, npt.NDArray[Any]] = {}
    fields = (fields_of(point_data, 'point', points, lattice, copy, hidden)
              + fields_of(cell_data, 'cell', cells, of_cells, copy, hidden))
    if lattice is not None and hidden:
        block = _without_hidden(block, lattice, hidden)
    block['fields'] = fields
    block['name'] = ''
    return Dataset(_core.Dataset.wrap([block], text(options.get('classify', 'auto'), 'classify'),
                                      text(options.get('device', ''), 'device')))


def _without_hidden(block: Dict[str, Any], lattice: Lattice, hidden: Dict[str, npt.NDArray[Any]]) -> Dict[str, Any]:
    """The block of a lattice without the cells that are hidden, by themselves or by a point."""
    cells = np.zeros(_cells_of(lattice), bool)
    if 'point' in hidden:
        cells |= cells_at_points(hidden['point'], lattice)
    if 'cell' in hidden:
        cells |= hidden['cell']
    if cells.all():
        raise InputError('every cell is masked, or has a masked point; there is nothing to cut')
    if block['kind'] == 'image':
        points = points_on_axes(*(block['origin'][a] + block['spacing'][a] * np.arange(lattice[a]) for a in range(3)))
    elif block['kind'] == 'rectilinear':
        points = points_on_axes(block['x'], block['y'], block['z'])
    else:
        points = block['coordinates'].reshape(-1, 3)
    return visible_cells(points, lattice, cells)


def _lattice_of(dimensions: Sequence[int]) -> Lattice:
    try:
        is_lattice = len(dimensions) == 3 and all(whole(n, 'dimensions') >= 2 for n in dimensions)
    except (TypeError, UsageError):
        is_lattice = False
    if not is_lattice:
        raise InputError(f'dimensions {shown(dimensions)}: takes the points along x, y and z, 2 or more each')
    return int(dimensions[0]), int(dimensions[1]), int(dimensions[2])


def _cells_of(lattice: Lattice) -> int:
    return (lattice[0] - 1) * (lattice[1] - 1) * (lattice[2] - 1)


def image(point_data: Arrays = None, cell_data: Arrays = None, *, dimensions: Optional[Sequence[int]] = None,
          origin: Sequence[float] = (0.0, 0.0, 0.0), spacing: Sequence[float] = (1.0, 1.0, 1.0), copy: bool = False,
          **options: str) -> Dataset:
    """An image: points at equal distances along x, y and z.

    Parameters
    ----------
    point_data, cell_data : mapping of str to ndarray, optional
        Arrays of the shape (nz, ny, nx), with components behind, or flat, where x runs fastest. An array that is
        indexed by [i, j, k] in Fortran order is given as ``array.T``. They are shared. Masked values, of numpy.ma or
        of anything else with a ``mask``, are NaN if they are floats, in a copy. Masked integers hide their points or
        cells.
    dimensions : sequence of 3 ints, optional
        Points along x, y and z, 2 or more each. By default those of the first array in `point_data`.
    origin, spacing : sequence of 3 floats
        Place of the first point, and distances, in any unit.
    copy : bool
        Arrays that cannot be shared are copied. If False, they raise InputError.
    **options
        ``classify`` and ``device``, as of `open`.

    Raises
    ------
    InputError
        A shape or a type that does not fit.

    Examples
    --------
    >>> import numpy, vprobe
    >>> z, y, x = numpy.mgrid[0:5, 0:6, 0:7].astype(float)
    >>> vprobe.image({'r': x * x + y * y + z * z}).slice().n_polygons
    30
    """
    if dimensions is None:
        first = next(iter(arrays(point_data, 'point_data').values()), None)
        if first is None or np.ndim(first) not in (3, 4):
            raise InputError('image: give dimensions=(nx, ny, nz), or a point array of the shape (nz, ny, nx)')
        dimensions = np.shape(first)[2::-1]
    lattice = _lattice_of(dimensions)
    block = {'kind': 'image', 'points': lattice, 'origin': several(origin, 'origin', 3),
             'spacing': several(spacing, 'spacing', 3)}
    return _dataset(block, point_data, cell_data, int(np.prod(lattice)), _cells_of(lattice), lattice, copy, options)


def rectilinear(x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike, point_data: Arrays = None,
                cell_data: Arrays = None, *, copy: bool = False, **options: str) -> Dataset:
    """Points at (x[i], y[j], z[k]).

    Parameters
    ----------
    x, y, z : array_like of shape (n,)
        2 or more each, all rising or all falling. Shared where they are float64.
    point_data, cell_data, copy, **options
        As of `image`.
    """
    axes = [places(axis, name) for name, axis in zip('xyz', (x, y, z))]
    for name, axis in zip('xyz', axes):
        if axis.ndim != 1 or len(axis) < 2:
            raise InputError(f'{name} has the shape {axis.shape}; it has to be (n,), with 2 or more')
    lattice = _lattice_of([len(axis) for axis in axes])
    block = {'kind': 'rectilinear', 'x': axes[0], 'y': axes[1], 'z': axes[2]}
    return _dataset(block, point_data, cell_data, int(np.prod(lattice)), _cells_of(lattice), lattice, copy, options)


def structured(points: npt.NDArray[Any], point_data: Arrays = None, cell_data: Arrays = None, *,
               dimensions: Optional[Sequence[int]] = None, copy: bool = False, **options: str) -> Dataset:
    """Points anywhere, in the order of a lattice.

    Parameters
    ----------
    points : ndarray of shape (nk, nj, ni, 3), or (n, 3) with `dimensions`
        float32 or float64; i runs fastest. Shared, unless the library turns the axes of the lattice. Cells with a
        point that is masked, or NaN, are hidden, with a warning.
    dimensions : sequence of 3 ints, optional
        Points along i, j and k.
    point_data, cell_data, copy, **options
        As of `image`; shapes are (nk, nj, ni).
    """
    at = usable(points, 'points', copy)
    if dimensions is None:
        if at.ndim != 4:
            raise InputError(f'points of the shape {at.shape}; it has to be (nk, nj, ni, 3), or give dimensions=')
        dimensions = at.shape[2::-1]
    lattice = _lattice_of(dimensions)
    count = int(np.prod(lattice))
    if at.shape not in ((*lattice[::-1], 3), (count, 3)):
        raise InputError(f'points of the shape {at.shape}; it has to be {(*lattice[::-1], 3)} or {(count, 3)}')
    block = {'kind': 'structured', 'points': lattice, 'coordinates': at}
    return _dataset(block, point_data, cell_data, count, _cells_of(lattice), lattice, copy, options)


def _types_of(types: Union[str, int, npt.NDArray[Any]], cells: int) -> npt.NDArray[np.uint8]:
    if isinstance(types, str):
        if types not in CELL_TYPES:
            raise InputError(f'types: {shown(types)} is no type of cells; there are {", ".join(CELL_TYPES)}, and VTK\'s numbers')
        types = CELL_TYPES[types]
    if isinstance(types, (int, np.integer)) and not isinstance(types, bool):
        if not 0 <= types < 256:
            raise wrong('types', types, 'a number of VTK\'s, 0 to 255')
        return np.full(cells, types, np.uint8)
    array = np.ascontiguousarray(usable(types, 'types', True), dtype=np.uint8)
    if array.shape != (cells,):
        raise InputError(f'types of the shape {array.shape}; it has to be ({cells},), one for each cell')
    return array


def _points_of(points: Any, copy: bool) -> npt.NDArray[Any]:
    at = usable(points, 'points', copy)
    if at.ndim != 2 or at.shape[1] != 3:
        raise InputError(f'points of the shape {at.shape}; it has to be (n, 3)')
    return at


def unstructured(points: npt.NDArray[Any], cells: Union[npt.NDArray[Any], Tuple[npt.NDArray[Any], npt.NDArray[Any]]],
                 types: Union[str, int, npt.NDArray[Any]], point_data: Arrays = None, cell_data: Arrays = None, *,
                 tolerance: float = 0.0, copy: bool = False, **options: str) -> Dataset:
    """Cells of any shape, in VTK's order of points.

    Parameters
    ----------
    points : ndarray of shape (n, 3)
        float32 or float64. Cells with a point that is masked, or NaN, are left out, with a warning.
    cells : ndarray of shape (n, k), or (offsets, connectivity)
        Numbers of points, int32 or int64, in rows of k, or one after the other with n + 1 offsets.
    types : str, int or ndarray of shape (n,)
        ``"tetra"``, ``"hexahedron"``, ``"wedge"``, ``"pyramid"``, ``"voxel"``, ``"pentagonal_prism"``,
        ``"hexagonal_prism"``, ``"quadratic_tetra"``, ``"quadratic_hexahedron"``, ``"quadratic_wedge"``,
        ``"quadratic_pyramid"``, or VTK's numbers, for all cells or for each.
    tolerance : float, optional
        Of curved cells, quadratic, Lagrange and Bezier ones: slices refine those that they meet, until they are off by
        no more than this share of their size, and of the range of the array that is shown.
    point_data, cell_data, copy, **options
        As of `image`; arrays have the shape (n,) or (n, components). Integers cannot be masked.

    Notes
    -----
    Points and cells are shared until a second cut builds what tells the neighbors of cells; from then on the data set
    has its own. `Dataset.memory` tells.

    Examples
    --------
    >>> import numpy, vprobe
    >>> points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
    >>> vprobe.unstructured(points, numpy.array([[0, 1, 2, 3]]), 'tetra').slice(origin=(.1, .1, .5)).area
    0.125
    """
    at = _points_of(points, copy)
    if isinstance(cells, tuple):
        if len(cells) != 2:
            raise wrong('cells', cells, 'an array of the shape (n, k), or (offsets, connectivity)')
        offsets, connectivity = (usable(part, name, copy) for part, name in zip(cells, ('offsets', 'connectivity')))
        if offsets.ndim != 1 or len(offsets) == 0 or connectivity.ndim != 1:
            raise InputError(f'cells: offsets of the shape {offsets.shape} and connectivity of {connectivity.shape}; they '
                             'have to be (n + 1,) and (m,)')
        count = len(offsets) - 1
    else:
        connectivity = usable(cells, 'cells', copy)
        if connectivity.ndim != 2:
            raise InputError(f'cells of the shape {connectivity.shape}; it has to be (n, k), or (offsets, connectivity)')
        count, size = connectivity.shape
        offsets = np.arange(0, count * size + 1, size, dtype=np.int64) if size else np.zeros(count + 1, np.int64)
    block = {'kind': 'unstructured', 'coordinates': at, 'types': _types_of(types, count), 'offsets': offsets,
             'connectivity': connectivity, 'tolerance': number(tolerance, 'tolerance')}
    return _dataset(block, point_data, cell_data, len(at), count, None, copy, options)


def polyhedra(points: npt.NDArray[Any], cells: Union[Sequence[Sequence[Sequence[int]]], Tuple[Any, Any]],
              point_data: Arrays = None, cell_data: Arrays = None, *, copy: bool = False, **options: str) -> Dataset:
    """Polyhedra, each with its faces.

    Parameters
    ----------
    points : ndarray of shape (n, 3)
        float32 or float64.
    cells : sequence, or (face_offsets, face_stream)
        For each cell its faces, and for each face the numbers of its points. Or, as VTK has them, int64 arrays: a
        stream with the number of faces of a cell, then for each face its size and its points, and n + 1 offsets of
        cells into it.
    point_data, cell_data, copy, **options
        As of `unstructured`.
    """
    at = _points_of(points, copy)
    if isinstance(cells, tuple) and len(cells) == 2 and isinstance(cells[0], np.ndarray):
        starts, stream = (np.ascontiguousarray(usable(part, name, True), dtype=np.int64)
                          for part, name in zip(cells, ('face_offsets', 'face_stream')))
        count = len(starts) - 1
        if starts.ndim != 1 or stream.ndim != 1 or count < 0:
            raise wrong('cells', cells, '(face_offsets, face_stream) of the shapes (n + 1,) and (m,)')
    else:
        numbers: List[int] = []
        begins = [0]
        try:
            for faces in cells:
                numbers.append(len(faces))
                for face in faces:
                    numbers += [len(face), *map(int, face)]
                begins.append(len(numbers))
        except (TypeError, ValueError, OverflowError):
            raise wrong('cells', cells, 'for each cell its faces, and for each face the numbers of its points') from None
        try:
            starts, stream, count = np.array(begins, np.int64), np.array(numbers, np.int64), len(begins) - 1
        except OverflowError:
            raise wrong('cells', cells, 'numbers of points') from None
    block = {'kind': 'unstructured', 'coordinates': at, 'types': np.full(count, 42, np.uint8),
             'offsets': np.zeros(count + 1, np.int64), 'connectivity': np.zeros(0, np.int64), 'face_offsets': starts,
             'face_stream': stream}
    return _dataset(block, point_data, cell_data, len(at), count, None, copy, options)
