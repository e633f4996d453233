"""What a data set holds, and what it tells of itself."""
from __future__ import annotations

from typing import Any, List, Tuple, Union

from . import _core
from ._added import added_fields
from ._answers import ArrayInfo, Block, Memory
from ._arguments import shown, text, whole, wrong
from ._slice import Array


class Contents:
    """Grids and arrays, without what cuts them."""

    def __init__(self, core: _core.Dataset, source: Any = None) -> None:
        self._core = core
        self._source = source

    @property
    def kind(self) -> str:
        """``image``, ``rectilinear``, ``curvilinear``, ``unstructured``, ``block-structured`` or ``hybrid``."""
        return self._core.kind

    @property
    def n_cells(self) -> int:
        """Cells, as the input counts them."""
        return self._core.cell_count

    @property
    def n_points(self) -> int:
        """Points, as the input counts them."""
        return self._core.point_count

    @property
    def n_blocks(self) -> int:
        """Grids that it is made of."""
        return self._core.block_count

    @property
    def bounds(self) -> Tuple[float, float, float, float, float, float]:
        """Low and high of x, y and z, in the grid's units, in VTK's order."""
        low, high = self._core.bounds
        return low[0], high[0], low[1], high[1], low[2], high[2]

    @property
    def times(self) -> Tuple[float, ...]:
        """The times that the files offer, ascending."""
        return tuple(self._core.times)

    @property
    def arrays(self) -> Tuple[ArrayInfo, ...]:
        """What arrays there are."""
        return tuple(ArrayInfo(*row) for row in self._core.arrays())

    def block(self, index: int = 0) -> Block:
        """The arrays that it holds of a block, as read-only views. Where they are shared, they are the caller's."""
        if not 0 <= whole(index, 'index') < self.n_blocks:
            raise wrong('index', index, f'a number from 0 to {self.n_blocks - 1}')
        return Block(*self._core.block(index))

    def memory(self) -> Memory:
        """What it holds, in bytes, and whether points and cells are still shared."""
        return Memory(**self._core.memory())

    def modified(self) -> None:
        """Values of wrapped arrays were changed in place. Slices that were made before may show either."""
        self._core.modified()

    def __getitem__(self, name: str) -> Union[Array, List[Array]]:
        """The array of this name, or ``"cell:p"`` where points and cells have one of the name: read-only, as `block` has it.

        Of several blocks a list, with an array for each block that has it.

        Raises
        ------
        KeyError
            Where there is none.
        """
        known = [f'{array.place}:{array.name}' for array in self.arrays]
        key = next((each for each in (name, f'point:{name}', f'cell:{name}') if each in known), None) if isinstance(
            name, str) else None
        if key is None:
            raise KeyError(f'{shown(name)}; there are {", ".join(known) or "no arrays"}')
        found = [block.arrays[key] for block in map(self.block, range(self.n_blocks)) if key in block.arrays]
        return found[0] if self.n_blocks == 1 else found

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and any(name in (array.name, f'{array.place}:{array.name}') for array in self.arrays)

    __iter__ = None  # otherwise Python would ask for the arrays 0, 1 and so on

    def __setitem__(self, name: str, values: Any) -> None:
        """Adds an array over points or cells, by its length, or replaces the one of the name. It is shared.

        Parameters
        ----------
        name : str
            ``"point:p"`` and ``"cell:p"`` tell of what it is, where there are as many points as cells.
        values : ndarray, or a sequence of them
            Of the shape (n,), or (n, components), n being `n_points` or `n_cells`; or with a lattice in place of n. With
            several blocks one array for all of them, one block after the other, or an array for each.

        Raises
        ------
        InputError
            Where it fits neither the points nor the cells, or both.
        """
        self._core.set_array(added_fields(text(name, 'name'), values, [self.block(b) for b in range(self.n_blocks)]))

    def __repr__(self) -> str:
        names = ', '.join(dict.fromkeys(array.name for array in self.arrays)) or 'no arrays'
        source = '' if self._source is None else f' {self._source}'
        blocks = '' if self.n_blocks == 1 else f' in {self.n_blocks} blocks'
        return f'<vprobe.Dataset{source}: {self.kind}, {self.n_cells} cells{blocks}, {names}>'
