"""Lattices some of whose cells are hidden: the others are listed."""
from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]
EMPTY_CELL, HEXAHEDRON = 0, 12


def hexahedra(lattice: Tuple[int, ...]) -> Array:
    """The points of each cell of a lattice, in the order of a hexahedron."""
    ids = np.arange(int(np.prod(lattice)), dtype=np.int64).reshape(lattice[::-1])
    low, high = ids[:-1], ids[1:]
    corners: List[Array] = []
    for layer in (low, high):
        corners += [layer[:, :-1, :-1], layer[:, :-1, 1:], layer[:, 1:, 1:], layer[:, 1:, :-1]]
    return np.stack([corner.ravel() for corner in corners], axis=1)


def cells_at_points(marks: Array, lattice: Tuple[int, ...]) -> Array:
    """A mark for each cell of a lattice: whether one of its points is marked."""
    blank = marks.reshape(lattice[::-1])
    of_points = np.zeros(tuple(n - 1 for n in blank.shape), bool)
    for k in (slice(None, -1), slice(1, None)):
        for j in (slice(None, -1), slice(1, None)):
            for i in (slice(None, -1), slice(1, None)):
                of_points |= blank[k, j, i]
    return of_points.ravel()


def points_on_axes(x: Array, y: Array, z: Array) -> Array:
    """The points of a rectilinear grid, x fastest."""
    points = np.empty((len(z), len(y), len(x), 3))
    points[..., 0], points[..., 1], points[..., 2] = x, y[:, None], z[:, None, None]
    return points.reshape(-1, 3)


def visible_cells(points: Array, lattice: Tuple[int, ...], hidden: Array) -> Dict[str, Any]:
    """What the library takes of a lattice without its hidden cells. Points and cells keep their numbers."""
    types = np.where(hidden, EMPTY_CELL, HEXAHEDRON).astype(np.uint8)
    return {'kind': 'unstructured', 'coordinates': points, 'types': types,
            'offsets': np.arange(0, 8 * len(types) + 1, 8, dtype=np.int64),
            'connectivity': hexahedra(lattice).ravel()}
