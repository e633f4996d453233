"""Paths of particles."""
from __future__ import annotations

from typing import Any, Iterator, Tuple

from ._slice import Floats, Ints


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
