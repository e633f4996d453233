"""`mesh.vprobe` for PyVista's meshes: import this module, with PyVista 0.48 or later.

With an older PyVista, `vprobe.wrap` takes its meshes, and `to_pyvista` gives them.
"""
from __future__ import annotations

from typing import Any, Optional

import pyvista

from ._answers import Samples
from ._dataset import Dataset
from ._kept import Kept
from ._picture import Image
from ._probe import Probe

__all__ = ['Accessor']


class Accessor:
    """Cuts of a mesh, as PyVista's meshes. What is built to find cells is kept until points or cells change.

    Examples
    --------
    >>> mesh.vprobe.slice(normal=(.3, .5, .8), array='p')   # doctest: +SKIP
    """

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh
        self._kept = Kept()

    @property
    def data(self) -> Dataset:
        """The mesh as a data set, which has everything else: figures, plans, sweeps and pictures."""
        return self._kept.data_of(self._mesh)

    def __repr__(self) -> str:
        return f'<vprobe.pyvista.Accessor of {self.data!r}>'

    def slice(self, surface: Optional[str] = None, **settings: Any) -> Any:
        """As `Dataset.slice`; a ``pyvista.PolyData``."""
        return self.data.slice(surface, **settings).to_pyvista()

    def slice_orthogonal(self, **settings: Any) -> Any:
        """As `Dataset.slice_orthogonal`; a ``pyvista.MultiBlock``."""
        return self.data.slice_orthogonal(**settings).to_pyvista()

    def slice_along_axis(self, n: int = 5, axis: Any = 'z', **settings: Any) -> Any:
        """As `Dataset.slice_along_axis`; a ``pyvista.MultiBlock``."""
        return self.data.slice_along_axis(n, axis, **settings).to_pyvista()

    def isosurface(self, value: float, array: Optional[str] = None, **settings: Any) -> Any:
        """As `Dataset.isosurface`; a ``pyvista.PolyData``."""
        return self.data.isosurface(value, array, **settings).to_pyvista()

    def sample(self, points: Any, arrays: Any = ()) -> Samples:
        """As `Dataset.sample`."""
        return self.data.sample(points, arrays)

    def render(self, probe: Optional[Probe] = None, **settings: Any) -> Image:
        """As `Dataset.render`."""
        return self.data.render(probe, **settings)


if not hasattr(pyvista, 'register_dataset_accessor'):
    raise ImportError(f'vprobe.pyvista: PyVista {pyvista.__version__} offers no register_dataset_accessor; use '
                      'vprobe.wrap(mesh), and to_pyvista() of what it cuts, or PyVista 0.48')
pyvista.register_dataset_accessor('vprobe', pyvista.DataObject)(Accessor)
