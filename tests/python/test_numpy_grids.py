"""Data sets from numpy arrays: what is shared, and what is refused."""
import gc

import numpy as np
import pytest

import vprobe
from conftest import address, hexahedra, lattice

PLANE = dict(normal=(.3, .5, .8))
N = 9, 8, 7


def made(kind):
    """A box of one kind, its values, and what has to be shared: pairs of an array and what tells where it lies."""
    points, values = lattice(*N)
    numbers = np.arange((N[0] - 1) * (N[1] - 1) * (N[2] - 1), dtype=np.int32)
    fields = {'value': values.ravel()}, {'number': numbers}
    if kind == 'image':
        data = vprobe.image({'value': values}, {'number': numbers}, spacing=[1 / (n - 1) for n in N], classify='cpu')
        shared = []
    elif kind == 'rectilinear':
        axes = [np.linspace(0, 1, n) for n in N]
        data = vprobe.rectilinear(*axes, *fields, classify='cpu')
        shared = list(zip(axes, data.block().coordinates))
    elif kind == 'structured':
        data = vprobe.structured(points, *fields, classify='cpu')
        shared = [(points, data.block().coordinates[0])]
    else:
        cells = hexahedra(*N)
        if kind == 'unstructured':
            data = vprobe.unstructured(points.reshape(-1, 3), cells, 'hexahedron', *fields, classify='cpu')
            shared = [(points, data.block().coordinates[0]), (cells, data.block().connectivity)]
        else:
            faces = [[[c[i] for i in face] for face in FACES] for c in cells.tolist()]
            data = vprobe.polyhedra(points.reshape(-1, 3), faces, *fields, classify='cpu')
            shared = [(points, data.block().coordinates[0])]
    arrays = data.block().arrays
    return data, values, shared + [(values, arrays['point:value']), (numbers, arrays['cell:number'])]


FACES = (0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)
KINDS = 'image', 'rectilinear', 'structured', 'unstructured', 'polyhedra'


@pytest.mark.parametrize('kind', KINDS)
def test_arrays_are_shared_and_slices_are_right(kind):
    data, values, shared = made(kind)
    for source, held in shared:
        assert address(source) == address(held) and source.size == held.size
        assert not held.flags.writeable
    for _ in range(3):
        piece = data.slice(**PLANE, array='value')
        # A plane through the center of the unit cube: its area by the projection of the cross-section.
        exact = piece.points @ (1.0, 2.0, 3.0)
        assert np.abs(piece['value'] - exact).max() < 1e-12
        assert piece.area == pytest.approx(AREA, rel=1e-12)
        assert np.array_equal(piece['number'], piece.cells)
        assert piece.mean == pytest.approx(3.0, rel=1e-12)
    memory = data.memory()
    assert memory.copied == (kind in ('unstructured', 'polyhedra'))
    arrays = data.block().arrays
    assert address(arrays['point:value']) == address(values)


def test_a_memmap_stays_on_the_disk(tmp_path):
    _, values = lattice(*N)
    values.tofile(tmp_path / 'v.raw')
    mapped = np.memmap(tmp_path / 'v.raw', values.dtype, 'r', shape=values.shape)
    data = vprobe.image({'value': mapped}, spacing=[1 / (n - 1) for n in N], classify='cpu')
    piece = data.slice(**PLANE)
    assert np.abs(piece['value'] - piece.points @ (1.0, 2.0, 3.0)).max() < 1e-12
    assert address(data.block().arrays['point:value']) == address(mapped)


def cross_section():
    """The area of the cut of [0, 1]^3 by a plane through its center, by a polygon of the crossed edges."""
    normal = np.array(PLANE['normal']) / np.linalg.norm(PLANE['normal'])
    corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    side = (corners - .5) @ normal
    places = []
    for a in range(8):
        for b in range(a):
            if np.abs(corners[a] - corners[b]).sum() == 1 and side[a] * side[b] < 0:
                places.append(corners[a] + side[a] / (side[a] - side[b]) * (corners[b] - corners[a]))
    places = np.array(places) - np.mean(places, axis=0)
    x = np.cross(normal, (1, 0, 0))
    y = np.cross(normal, x)
    around = places[np.argsort(np.arctan2(places @ y, places @ x))]
    return np.linalg.norm(np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0)) / 2 / 1.0


AREA = cross_section()


@pytest.mark.parametrize('kind', KINDS)
def test_views_outlive_the_names_of_their_sources(kind):
    data, values, shared = made(kind)
    piece = data.slice(**PLANE)
    held = [array for _, array in shared]
    kept = [array.copy() for array in held]
    del data, values, shared
    gc.collect()
    rubbish = [np.full(100000, 7.0) for _ in range(20)]
    assert all(np.array_equal(array, copy) for array, copy in zip(held, kept))
    assert np.abs(piece['value'] - piece.points @ (1.0, 2.0, 3.0)).max() < 1e-12
    del rubbish


@pytest.mark.parametrize('kind', KINDS)
def test_values_that_change_in_place_are_seen(kind):
    data, values, _ = made(kind)
    before = data.slice(**PLANE).mean
    values *= 2
    data.modified()
    assert data.slice(**PLANE).mean == pytest.approx(2 * before, rel=1e-12)


def test_points_and_cells_are_shared_until_the_second_cut():
    data, _, _ = made('unstructured')
    first = data.slice(**PLANE)
    assert not data.memory().copied and data.block().connectivity is not None
    data.slice(**PLANE)
    assert data.memory().copied and data.block().connectivity is None and data.memory().built > 0
    assert np.array_equal(first['number'], first.cells)  # the first slice keeps its cells as they were


def test_what_does_not_fit_is_told():
    points, values = lattice(*N)
    flat = points.reshape(-1, 3)
    cells = hexahedra(*N)
    bad = cells.copy()
    bad[5, 3] = 10 ** 6
    cases = [
        (lambda: vprobe.image({'p': values[:-1]}, dimensions=N), 'the array p has the shape'),
        (lambda: vprobe.image({}), 'give dimensions'),
        (lambda: vprobe.image({'p': values[:, :, 0]}), 'give dimensions'),
        (lambda: vprobe.image({'p': np.zeros(3)}, dimensions=(1, 3, 1)), '2 or more'),
        (lambda: vprobe.image({'p': values}, spacing=(0, 1, 1)), 'spac'),
        (lambda: vprobe.structured(flat), r'\(nk, nj, ni, 3\)'),
        (lambda: vprobe.structured(points[..., :2]), 'points of the shape'),
        (lambda: vprobe.structured(points.astype(int)), 'number type'),
        (lambda: vprobe.rectilinear([0, 1, .5], [0, 1], [0, 1]), 'rise nor fall'),
        (lambda: vprobe.rectilinear([0], [0, 1], [0, 1]), 'x has the shape'),
        (lambda: vprobe.unstructured(flat, bad, 'hexahedron'), 'lists point 1000000'),
        (lambda: vprobe.unstructured(flat, cells, 'tetra'), 'lists 8 points'),
        (lambda: vprobe.unstructured(flat, cells, 'brick'), 'is no type of cells'),
        (lambda: vprobe.unstructured(flat, cells, 255), 'cell 0 of type 255'),
        (lambda: vprobe.unstructured(flat, cells.astype(float), 'hexahedron'), 'number type'),
        (lambda: vprobe.unstructured(flat, cells, 'hexahedron', {'p': values.ravel().tolist()}), 'copy=True'),
        (lambda: vprobe.polyhedra(flat, [[[0, 1, 2], [0, 1, 10 ** 6]]]), 'polyhedron 0'),
        (lambda: vprobe.structured(points, {'p': values.astype(np.float16)}), 'float16'),
        (lambda: vprobe.structured(points, {'p': values > 1}), 'bool'),
        (lambda: vprobe.structured(points, {'p': values.astype(complex)}), 'complex'),
        (lambda: vprobe.structured(points, {'p': values.astype('>f8')}), 'byte order'),
        (lambda: vprobe.structured(points, {'p': np.repeat(values, 2, axis=2)[:, :, ::2]}), 'side by side'),
        (lambda: vprobe.wrap(points), 'no data set of VTK'),
    ]
    for call, words in cases:
        with pytest.raises(vprobe.InputError, match=words) as raised:
            call()
        assert '\n' not in str(raised.value)


@pytest.mark.parametrize('change', [
    lambda p: p.astype(np.float16), lambda p: p > 3, lambda p: p.astype('>f4'),
    lambda p: np.repeat(p, 2, axis=2)[:, :, ::2], lambda p: p.tolist()])
def test_copies_are_made_where_they_are_allowed(change):
    points, values = lattice(*N)
    data = vprobe.structured(points, {'p': change(values)}, copy=True, classify='cpu')
    wanted = float(np.asarray(change(values)).astype(float).max())
    assert data.sample([[1, 1, 1]])['p'][0] == wanted


def test_nan_and_empty_arrays():
    points, values = lattice(*N)
    values[0] = np.nan
    piece = vprobe.structured(points, {'p': values}, classify='cpu').slice(normal='x')
    assert 0 < piece.nan_area < piece.area == pytest.approx(1) and np.isfinite(piece.mean)
    none = vprobe.structured(points, classify='cpu')
    piece = none.slice(normal='x')
    assert (piece.keys(), piece.mean, none.arrays) == ([], None, ())
    assert piece.area == pytest.approx(1)
    with pytest.raises(vprobe.InputError):
        vprobe.unstructured(np.zeros((0, 3)), np.zeros((0, 4), int), 'tetra')


def test_a_million_owners_come_and_go_in_threads():
    import threading
    points, values = lattice(*N)

    def churn():
        for _ in range(100):
            data = vprobe.structured(points.copy(), {'p': values.copy()}, classify='cpu')
            piece = data.slice(**PLANE)
            del data
            assert piece['p'].shape == (piece.n_points,)
    threads = [threading.Thread(target=churn) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
