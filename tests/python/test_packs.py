"""Packs: a cut reads the cells that it meets, and what needs more reads all."""
import numpy as np
import pytest

import vprobe

NORMALS = [(.3, .5, .8), (1, 2, 3), (1, 0, 0), (-.2, .9, .1)]
WHOLE = 'demo:tets:12'


@pytest.fixture(scope='module')
def pack(program, tmp_path_factory):
    path = tmp_path_factory.mktemp('packs') / 'tets.vtkhdf'
    program('pack', WHOLE, '-o', path, '--part', '256')
    return path


def figures(piece):
    return [piece.area, piece.mean, piece.min, piece.max, piece.n_points, piece.n_polygons]


def test_figures_are_those_of_the_whole(pack):
    data, whole = vprobe.open(pack), vprobe.open(WHOLE)
    assert (data.n_cells, data.n_points, data.bounds) == (whole.n_cells, whole.n_points, whole.bounds)
    pieces = [(data.slice(normal=normal), whole.slice(normal=normal)) for normal in NORMALS]
    # They are measured when they are asked for, after the other cuts.
    for piece, wanted in pieces:
        assert figures(piece) == pytest.approx(figures(wanted), rel=1e-12)
        assert sorted(piece.cells) == sorted(wanted.cells)
        assert np.array_equal(np.sort(piece['s']), np.sort(wanted['s']))


def test_what_needs_all_reads_it_in_between(pack):
    data, whole = vprobe.open(pack), vprobe.open(WHOLE)
    early = data.slice(normal=(1, 2, 3))
    places = [[0.1, 1.2, 0.3], [-1.0, 0.5, 2.0], [9.0, 9.0, 9.0]]
    found, wanted = data.sample(places), whole.sample(places)
    assert np.array_equal(found.cells, wanted.cells) and (found.cells >= 0).any()
    assert np.allclose(found['s'], wanted['s'], rtol=1e-12, equal_nan=True)
    assert figures(early) == pytest.approx(figures(whole.slice(normal=(1, 2, 3))), rel=1e-12)
    assert data.slice(normal=(1, 2, 3), crinkle=True).n_polygons == whole.slice(normal=(1, 2, 3), crinkle=True).n_polygons


def test_arrays_are_whole(pack):
    data = vprobe.open(pack)
    data.slice(normal=(1, 2, 3))
    values = data['s']
    assert len(values) == data.n_points
    assert np.array_equal(np.sort(values), np.sort(vprobe.open(WHOLE)['s']))


def test_a_picture_is_that_of_the_whole(pack):
    pictures = [vprobe.open(each).render(normal=(.3, .5, .8), size=(200, 150), title='') for each in (pack, WHOLE)]
    assert np.array_equal(*map(np.asarray, pictures))
