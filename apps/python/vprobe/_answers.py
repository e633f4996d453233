"""What a data set tells of itself, and what it gives besides cuts."""
from __future__ import annotations

import dataclasses
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from ._picture import Image
from ._slice import Array, Cut


class ArrayInfo(NamedTuple):
    """An array of a data set. `place` is ``point`` or ``cell``."""

    name: str
    place: str
    components: int
    dtype: np.dtype[Any]
    units: str


class Block(NamedTuple):
    """What a data set holds of a block.

    `coordinates` are the points, (n, 3); of a rectilinear grid its three axes; of an image none. `connectivity` is that
    of an unstructured grid, until it is copied. `arrays` have names such as ``point:p``; they have a value for each of
    `n_points` points or `n_cells` cells.
    """

    name: str
    coordinates: List[Array]
    connectivity: Optional[Array]
    arrays: Dict[str, Array]
    n_points: int
    n_cells: int


class Memory(NamedTuple):
    """Bytes that a data set holds.

    `geometry` and `arrays` are shared with the caller where they were wrapped, and `geometry` only until `copied`.
    `built` is what finds cells: neighbors, boundary, trees. `cutter` is what cuts share, `device` lies on the device.
    """

    geometry: int
    arrays: int
    built: int
    cutter: int
    device: int
    copied: bool


class PlanRow(NamedTuple):
    """The way of one sheet in one block."""

    sheet: int
    block: int
    strategy: str
    classifier: str
    reason: str


@dataclasses.dataclass(frozen=True)
class Frame:
    """A frame of a sweep. `image` is None where none is drawn, `time` where the path is not ``times``."""

    index: int
    count: int
    cut: Cut
    image: Optional[Image]
    time: Optional[float]


class Samples(Mapping[str, npt.NDArray[np.float64]]):
    """Values of arrays at points, by the names of the arrays: (n,) or (n, components) float64, NaN outside.

    Attributes
    ----------
    cells : (n,) int64
        The cell that holds each point, as the input numbers it; -1 outside.
    blocks : (n,) int32
        Its block; -1 outside.
    """

    def __init__(self, cells: npt.NDArray[np.int64], blocks: npt.NDArray[np.int32],
                 arrays: Dict[str, npt.NDArray[np.float64]]) -> None:
        self.cells, self.blocks, self._arrays = cells, blocks, arrays

    def __getitem__(self, name: str) -> npt.NDArray[np.float64]:
        return self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __repr__(self) -> str:
        inside = int((self.cells >= 0).sum())
        return f'<vprobe.Samples: {", ".join(self) or "no arrays"} at {len(self.cells)} points, {inside} inside>'
