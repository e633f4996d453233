"""PyVista's meshes."""
import numpy as np
import pytest

import vprobe

pv = pytest.importorskip('pyvista', reason='no PyVista')


def mesh():
    grid = pv.ImageData(dimensions=(9, 8, 7)) if hasattr(pv, 'ImageData') else pv.UniformGrid(dimensions=(9, 8, 7))
    grid['p'] = np.linalg.norm(grid.points, axis=1)
    return grid


def test_meshes_are_wrapped_and_given_back():
    piece = vprobe.wrap(mesh(), classify='cpu').slice(normal=(.3, .5, .8))
    cut = piece.to_pyvista()
    assert isinstance(cut, pv.PolyData) and cut.n_points == piece.n_points
    assert cut.area == pytest.approx(piece.area, rel=1e-6)
    assert piece.area == pytest.approx(mesh().slice(normal=(.3, .5, .8)).area, rel=2e-5)
    assert isinstance(vprobe.wrap(mesh()).slice_orthogonal().to_pyvista(), pv.MultiBlock)


def test_the_accessor_keeps_what_it_built():
    if not hasattr(pv, 'register_dataset_accessor'):
        pytest.skip(f'PyVista {pv.__version__} offers no register_dataset_accessor')
    import vprobe.pyvista  # noqa: F401
    grid = mesh().cast_to_unstructured_grid()
    cut = grid.vprobe.slice(normal=(.3, .5, .8))
    assert isinstance(cut, pv.PolyData) and grid.vprobe.data is grid.vprobe.data
