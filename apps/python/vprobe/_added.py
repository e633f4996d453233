"""Arrays that are added to a data set or to a copy of a slice: of points or of cells, by their length."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from ._arguments import shown
from ._errors import InputError

if TYPE_CHECKING:
    from ._answers import Block

Array = npt.NDArray[Any]


def place_of(name: str, length: int, points: int, cells: int, of_cells: str) -> Tuple[str, str]:
    """``point`` or ``cell`` and the name without it, by the name or by the length. of_cells: what cells are called."""
    place, _, rest = name.partition(':')
    if place in ('point', 'cell') and rest:
        wanted = points if place == 'point' else cells
        if length != wanted:
            raise InputError(f'{name}: {length} values where there are {wanted} {place if place == "point" else of_cells}s')
        return place, rest
    if not name:
        raise InputError('name: an array needs a name')
    if points == cells and length == points:
        raise InputError(f'{name}: there are {points} points and as many {of_cells}s; call it "point:{name}" or '
                         f'"cell:{name}"')
    if length not in (points, cells):
        raise InputError(f'{name}: {length} values, but there are {points} points and {cells} {of_cells}s')
    return 'point' if length == points else 'cell', name


def _counted(values: Array, counts: Sequence[int], name: str) -> Array:
    """As (n,) or (n, components), where the first axes are a lattice of so many."""
    for axes in range(1, values.ndim + 1):
        if int(np.prod(values.shape[:axes])) in counts and values.ndim - axes <= 1:
            return values.reshape(-1, *values.shape[axes:])
    if values.ndim in (1, 2):
        return values
    raise InputError(f'{name} has the shape {values.shape}; it has to be (n,) or (n, components)')


def _parts(name: str, values: Any, blocks: Sequence[Block]) -> List[Any]:
    """The values of each block."""
    if len(blocks) > 1 and isinstance(values, (list, tuple)) and len(values) == len(blocks) and all(
            np.ndim(each) > 0 for each in values):
        return list(values)
    return [values]


def added_fields(name: str, values: Any, blocks: Sequence[Block]) -> List[Tuple[Any, ...]]:
    """What the library takes of an array: a field for each block."""
    from ._grids import usable
    points, cells = [sum(counts) for counts in zip(*((block.n_points, block.n_cells) for block in blocks))]
    parts = []
    for part in _parts(name, values, blocks):
        if not isinstance(part, np.ndarray):
            try:
                part = np.asarray(part)
            except ValueError:
                raise InputError(f'{name}: {shown(part)} cannot be; it takes numbers in an array') from None
        array = usable(part, name, True)
        if array.ndim == 0:
            raise InputError(f'{name}: {shown(values)} cannot be; it takes an array with a value for each point or cell')
        parts.append(array)
    if len(parts) == len(blocks):
        parts = [_counted(part, (block.n_points, block.n_cells), name) for part, block in zip(parts, blocks)]
    else:
        parts = [_counted(part, (points, cells), name) for part in parts]
    place, plain = place_of(name, sum(map(len, parts)), points, cells, 'cell')
    counts = [block.n_points if place == 'point' else block.n_cells for block in blocks]
    if len(parts) != len(blocks):
        ends = np.cumsum(counts)[:-1]
        parts = np.split(parts[0], ends)
    if [len(part) for part in parts] != counts or len({part.shape[1:] for part in parts}) > 1:
        raise InputError(f'{name}: the blocks have {", ".join(map(str, counts))} {place}s; give as many values for each')
    return [(plain, place, part.shape[1] if part.ndim > 1 else 1, np.ascontiguousarray(part), '') for part in parts]


def own_array(name: str, values: Any, points: int, polygons: int) -> Tuple[str, str, Array]:
    """The place, the name and the values of an array over points or polygons, copied."""
    from ._grids import usable
    try:
        given = values if isinstance(values, np.ndarray) else np.asarray(values)
    except ValueError:
        raise InputError(f'{name}: {shown(values)} cannot be; it takes numbers in an array') from None
    array = usable(given, name, True)
    if array.dtype.kind not in 'iuf' or array.ndim not in (1, 2):
        raise InputError(f'{name}: {shown(values)} cannot be; it takes numbers of the shape (n,) or (n, components)')
    place, plain = place_of(name, len(array), points, polygons, 'polygon')
    return place, plain, np.array(array)
