"""Arrays that mask some of their values, and coordinates that are no numbers."""
import numpy as np
import pytest

import vprobe
from conftest import address, hexahedra, lattice

N = 4, 4, 4
BOTTOM = dict(normal='z', origin=(.5, .5, 1 / 6))  # of the unit cube: through the lowest of three layers of nine cells


class Wrapped:
    """Something with a mask that is no array of numpy's."""

    def __init__(self, values, mask):
        self.values, self.mask, self.shape, self.ndim = values, mask, values.shape, values.ndim

    def __array__(self, dtype=None, copy=None):
        return self.values if dtype is None else self.values.astype(dtype)


class Lazy:
    """As dask's arrays: the mask appears when the values are computed."""

    def __init__(self, masked):
        self.masked, self.shape, self.ndim = masked, masked.shape, masked.ndim

    def __array__(self, dtype=None, copy=None):
        return self.masked


def made(kind, values=None, numbers=None, points=None, copy=False):
    """The unit cube in 27 cells, with an array of points and one of cells."""
    fields = ({} if values is None else {'value': values}), ({} if numbers is None else {'number': numbers})
    axes = [np.linspace(0, 1, n) for n in N]
    points = lattice(*N)[0] if points is None else points
    if kind == 'image':
        return vprobe.image(*fields, dimensions=N, spacing=[1 / 3] * 3, copy=copy, classify='cpu')
    if kind == 'rectilinear':
        return vprobe.rectilinear(*axes, *fields, copy=copy, classify='cpu')
    if kind == 'structured':
        return vprobe.structured(points, *fields, copy=copy, classify='cpu')
    return vprobe.unstructured(points.reshape(-1, 3), hexahedra(*N), 'hexahedron', *fields, copy=copy, classify='cpu')


LATTICES = 'image', 'rectilinear', 'structured'
KINDS = LATTICES + ('unstructured',)


def masked(dtype, *at):
    mask = np.zeros(N[::-1], bool)
    for each in at:
        mask[each] = True
    return np.ma.masked_array(np.arange(64).reshape(N[::-1]).astype(dtype), mask)


def shaped(kind, array):
    return array if kind in LATTICES else array.reshape(-1)


@pytest.mark.parametrize('kind', KINDS)
def test_masked_floats_are_nan(kind):
    whole = made(kind, shaped(kind, np.zeros(N[::-1]))).slice(**BOTTOM, array='value')
    assert whole.area == pytest.approx(1.0) and whole.nan_area == 0
    values = shaped(kind, masked(float, (0, 0, 0)))
    before = values.data.copy()
    piece = made(kind, values).slice(**BOTTOM, array='value')
    assert piece.area == pytest.approx(1.0)
    assert piece.nan_area == pytest.approx(1 / 9)  # of the one cell with this corner
    assert np.array_equal(values.data, before)
    single = made(kind, shaped(kind, masked(np.float32, (0, 0, 0)))).slice(**BOTTOM, array='value')
    assert single.nan_area == pytest.approx(1 / 9)


@pytest.mark.parametrize('kind', LATTICES)
def test_masked_integers_hide_points_and_cells(kind):
    piece = made(kind, masked(np.int32, (0, 0, 0), (1, 2, 3))).slice(**BOTTOM, array='value')
    assert piece.area == pytest.approx(1 - 3 / 9)  # the cells at the corner, and the two at a point on a side
    assert set(piece.cells) == set(range(9)) - {0, 5, 8}
    marks = np.zeros((3, 3, 3), bool)
    marks[0, 0, 1] = True
    numbers = np.ma.masked_array(np.arange(27, dtype=np.int16).reshape(3, 3, 3), marks)
    piece = made(kind, numbers=numbers).slice(**BOTTOM, array='number')
    assert set(piece.cells) == set(range(9)) - {1}
    assert set(piece['number']) == set(range(9)) - {1}
    both = made(kind, masked(np.uint8, (0, 0, 0)), numbers).slice(**BOTTOM, array='number')
    assert both.area == pytest.approx(1 - 2 / 9)
    with pytest.raises(vprobe.InputError, match='every cell is masked'):
        made(kind, np.ma.masked_array(np.zeros(N[::-1], int), True))


def test_masked_integers_elsewhere_are_refused():
    with pytest.raises(vprobe.InputError, match=r'value: 1 .*masked.*\.filled\(value\)'):
        made('unstructured', masked(int, (0, 0, 0)).reshape(-1))
    cells = np.ma.masked_array(hexahedra(*N), False)
    points, _ = lattice(*N)
    assert vprobe.unstructured(points.reshape(-1, 3), cells, 'hexahedron').n_cells == 27
    cells.mask = np.zeros(cells.shape, bool)
    cells.mask[3, 2] = True
    with pytest.raises(vprobe.InputError, match=r'cells: .*\.filled\(value\)'):
        vprobe.unstructured(points.reshape(-1, 3), cells, 'hexahedron')
    types = np.ma.masked_array(np.full(27, 12), np.arange(27) == 1)
    with pytest.raises(vprobe.InputError, match=r'types: .*\.filled\(value\)'):
        vprobe.unstructured(points.reshape(-1, 3), hexahedra(*N), types)


@pytest.mark.parametrize('dtype', (np.float64, np.int32))
@pytest.mark.parametrize('mask', (np.ma.nomask, False, None))
def test_a_mask_of_nothing_copies_nothing(dtype, mask):
    values = np.zeros(N[::-1], dtype)
    mask = np.zeros(N[::-1], bool) if mask is None else mask
    data = made('image', np.ma.masked_array(values, mask))
    assert address(data.block().arrays['point:value']) == address(values)
    assert data.kind == 'image'


def test_whatever_has_a_mask_counts():
    array = masked(float, (0, 0, 0))
    for given in (Wrapped(array.data, array.mask), Lazy(array), Wrapped(array.data, array.mask.astype(np.uint8))):
        piece = made('image', given, copy=True).slice(**BOTTOM, array='value')
        assert piece.nan_area == pytest.approx(1 / 9)
    # One mark for all components of a tuple, and one for each.
    vectors = np.zeros(N[::-1] + (3,))
    each = np.zeros(vectors.shape, bool)
    each[0, 0, 0, 1] = True
    for given in (Wrapped(vectors, array.mask), np.ma.masked_array(vectors, each)):
        piece = made('image', given, copy=True).slice(**BOTTOM, array='value')
        assert piece.nan_area == pytest.approx(1 / 9)
    with pytest.raises(vprobe.InputError, match='mask has the shape'):
        made('image', Wrapped(array.data, np.ones(5, bool)), copy=True)


def test_a_method_of_the_name_is_no_mask():
    pandas = pytest.importorskip('pandas')
    assert made('unstructured', pandas.Series(np.zeros(64)), copy=True).slice(**BOTTOM, array='value').nan_area == 0


@pytest.mark.parametrize('kind', ('structured', 'unstructured'))
@pytest.mark.parametrize('masks', (True, False))
def test_cells_with_a_point_without_a_place_are_left_out(kind, masks):
    points = lattice(*N)[0]
    at = points.copy()
    if masks:
        at = np.ma.masked_array(at, np.zeros(at.shape, bool))
        at.mask[0, 0, 0, 2] = True
    else:
        at[0, 0, 0, 2] = np.nan
    with pytest.warns(vprobe.VprobeWarning, match='1 cell is left out'):
        data = made(kind, shaped(kind, np.zeros(N[::-1])), points=at)
    assert data.n_cells == 26 and data.bounds == (0, 1, 0, 1, 0, 1)
    for _ in range(2):  # alone, and with neighbors
        piece = data.slice(**BOTTOM, array='value')
        assert piece.area == pytest.approx(8 / 9)
        assert 0 not in piece.cells
    at[...] = np.nan
    with pytest.raises(vprobe.InputError, match='every cell has a point without a place'):
        made(kind, points=at)


def test_points_of_no_cell_may_lie_anywhere(recwarn):
    points = np.vstack([lattice(*N)[0].reshape(-1, 3), [[np.nan] * 3, [np.inf, 0, 0], [1e60, 0, 0]]])
    data = vprobe.unstructured(points, hexahedra(*N), 'hexahedron', classify='cpu')
    assert data.bounds == (0, 1, 0, 1, 0, 1)
    for _ in range(2):
        assert data.slice(**BOTTOM).area == pytest.approx(1.0)
    assert not recwarn.list


def test_axes_and_places_that_are_masked():
    axis = np.ma.masked_array(np.linspace(0, 1, 4), [False, True, False, False])
    with pytest.raises(vprobe.InputError, match='axis is not a finite number'):
        vprobe.rectilinear(axis, axis.data, axis.data)
    values = lattice(*N)[1]
    data = vprobe.image({'value': values}, spacing=[1 / 3] * 3, classify='cpu')
    at = np.ma.masked_array(np.full((2, 3), .5), [[False] * 3, [True, False, False]])
    samples = data.sample(at)
    assert samples['value'][0] == pytest.approx(3.0) and np.isnan(samples['value'][1])


@pytest.mark.parametrize('sides,name,number', ((5, 'pentagonal_prism', 15), (6, 'hexagonal_prism', 16)))
def test_prisms(sides, name, number):
    angles = 2 * np.pi * np.arange(sides) / sides
    points = np.array([[np.cos(a), np.sin(a), z] for z in (0., 1., 2.) for a in angles])
    cells = np.array([range(2 * sides), range(sides, 3 * sides)])
    area = .5 * sides * np.sin(2 * np.pi / sides)
    for types in (name, number, np.array([number] * 2)):
        data = vprobe.unstructured(points, cells, types, {'z': points[:, 2].copy()}, classify='cpu')
        for _ in range(2):
            for height in .25, 1.5:
                piece = data.slice(normal='z', origin=(0, 0, height), array='z')
                assert piece.area == pytest.approx(area, rel=1e-12)
                assert piece.mean == pytest.approx(height)
        assert data.slice(normal='y', origin=(0, 1e-3, 1)).n_polygons == 2
    with pytest.raises(vprobe.InputError, match='prism'):
        vprobe.unstructured(points, np.ascontiguousarray(cells[:, :-2]), number)
