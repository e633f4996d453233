"""Arrays of one's own: in copies of slices, and in data sets."""
import numpy as np
import pytest

import vprobe
from conftest import lattice
from vprobe import _core

PLANE = dict(normal=(.3, .5, .8))


def cube(n=4):
    """n^3 unit cells of [0, n]^3 with x + 2 y + 3 z."""
    points, values = lattice(n + 1, n + 1, n + 1)
    return vprobe.structured(points * n, {'p': values * n}, classify='cpu')


def test_a_copy_takes_arrays_by_their_length(shell, tmp_path):
    own = shell.slice(**PLANE).copy()
    assert own.n_points != own.n_polygons
    own['twice'] = 2 * own['s']
    own['number'] = np.arange(own.n_polygons)
    own['gradient'] = np.ones((own.n_points, 3), np.float32)
    assert own['twice'] is own.point_data['twice'] and own['number'] is own.cell_data['number']
    assert own.keys() == ['s', 'v', 'twice', 'gradient', 'number']
    given = np.zeros(own.n_points)
    own['given'] = given
    given += 1
    assert not own['given'].any()  # it was copied
    own['given'] = list(range(own.n_points))  # and replaced
    assert own['given'][5] == 5
    again = own.copy()
    again['twice'][:] = 0
    assert own['twice'].any() and again.keys() == own.keys()


def test_what_fits_neither_or_both_is_an_error_that_says_how():
    piece = cube().slice(normal='z', origin=(2, 2, .5))
    own = piece.copy()
    assert (own.n_points, own.n_polygons) == (25, 16)
    with pytest.raises(vprobe.InputError, match='24 values, but there are 25 points and 16 polygons'):
        own['a'] = np.zeros(24)
    with pytest.raises(vprobe.InputError, match='25 values where there are 16 polygons'):
        own['cell:a'] = np.zeros(25)
    for values in ('text', None, np.zeros(25, complex), np.zeros((5, 5, 1)), [[1, 2], [3]], 7.0):
        with pytest.raises(vprobe.InputError, match='^a'):
            own['a'] = values
    with pytest.raises(vprobe.UsageError, match='name'):
        own[5] = np.zeros(25)
    with pytest.raises(vprobe.UsageError, match='read-only; take its copy'):
        piece['a'] = np.zeros(25)
    # A tetrahedron by itself: three points and one polygon; four of them: as many polygons as points.
    prism = vprobe.unstructured(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float), np.array([[0, 1, 2, 3]]),
                                'tetra').slice(origin=(.1, .1, .5)).copy()
    prism['a'] = [1, 2, 3]
    prism['b'] = [4]
    assert list(prism.point_data) == ['a'] and list(prism.cell_data) == ['b']


def test_lengths_that_are_both_need_a_place():
    data = vprobe.image({'p': np.zeros((2, 2, 2))}, cell_data={'q': np.zeros(1)})
    with pytest.raises(vprobe.InputError, match='2 values, but there are 8 points and 1 cells'):
        data['a'] = np.zeros(2)
    single = vprobe.unstructured(np.zeros((8, 3)) + np.array(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float),
        np.tile(np.arange(8), (8, 1)), 'hexahedron')
    with pytest.raises(vprobe.InputError, match='"point:a" or "cell:a"'):
        single['a'] = np.zeros(8)
    single['cell:a'] = np.arange(8.)
    single['point:a'] = np.arange(8.) + 1
    assert [(array.name, array.place) for array in single.arrays] == [('a', 'cell'), ('a', 'point')]
    assert single['cell:a'][7] == 7 and single['point:a'][7] == 8


@pytest.mark.parametrize('ending', ['vtp', 'pvtp', 'ply', 'csv'])
def test_a_copy_is_saved_with_all_it_has(shell, tmp_path, ending):
    own = shell.slice(**PLANE).copy()
    own['twice'] = 2 * own['s']
    own['number'] = np.arange(own.n_polygons)
    file = tmp_path / f'own.{ending}'
    own.save(file)
    assert file.stat().st_size > 500
    if ending == 'csv':
        header = file.read_text().splitlines()[0]
        assert 'twice' in header and 'number' in header
    with pytest.raises(vprobe.UsageError, match='one part'):
        own.save(tmp_path / 'own.vtm')


def test_a_saved_copy_is_what_it_was(shell, tmp_path):
    reader = pytest.importorskip('vtkmodules.vtkIOXML', reason='no VTK for Python').vtkXMLPolyDataReader()
    from vtkmodules.util.numpy_support import vtk_to_numpy
    own = shell.slice(**PLANE).copy()
    own['twice'] = 2 * own['s']
    own['number'] = np.arange(own.n_polygons)
    own.points[:, 2] += 1
    own.save(tmp_path / 'own.vtp')
    reader.SetFileName(str(tmp_path / 'own.vtp'))
    reader.Update()
    mesh = reader.GetOutput()
    assert np.allclose(vtk_to_numpy(mesh.GetPoints().GetData()), own.points)
    assert np.array_equal(vtk_to_numpy(mesh.GetPointData().GetArray('twice')), own['twice'])
    assert np.array_equal(vtk_to_numpy(mesh.GetCellData().GetArray('number')), own['number'])
    assert np.array_equal(vtk_to_numpy(mesh.GetCellData().GetArray('vprobe:cell')), own.cells)


SIZE = dict(size=(160, 120), samples=1)


def alike(a, b):
    """The values of a copy are rounded to single precision, which may turn a color by a step."""
    return np.abs(np.asarray(a).astype(int) - np.asarray(b).astype(int)).max() <= 2


def test_a_copy_is_drawn_as_its_slice_is(shell):
    piece = shell.slice(**PLANE, array='s')
    picture = np.asarray(shell.render(piece, **SIZE))
    own = piece.copy()
    assert alike(shell.render(own, **SIZE), picture)
    own['same'] = own['s'].copy()
    named = shell.render(own, array='same', range=(-1, 1), **SIZE)
    own['s'][:] = 0
    assert not alike(shell.render(own, range=(-1, 1), **SIZE), named)
    own['s'][:] = own['same']
    own['flat'] = np.zeros(own.n_polygons)
    flat = np.asarray(shell.render(own, array='flat', **SIZE))
    assert (flat != picture).any()
    # The data set is as it was.
    assert [array.name for array in shell.arrays] == ['s', 'v']
    assert np.array_equal(np.asarray(shell.render(piece, **SIZE)), picture)


def test_a_copy_of_one_sheet_of_several_is_drawn_alone(shell):
    third = shell.cut(vprobe.Probe.trihedral())[2]
    picture = np.asarray(shell.render(third, **SIZE))
    assert alike(shell.render(third.copy(), **SIZE), picture)


def test_arrays_stay_through_the_times_of_a_file(tmp_path):
    for k in (1, 2):
        np.savez(tmp_path / f'v{k}.npz', p=np.full((3, 3, 3), float(k)))
    data = vprobe.open([tmp_path / 'v1.npz', tmp_path / 'v2.npz'], inputs='times', time='first', classify='cpu')
    data['x'] = np.arange(27.)
    name = data.arrays[0].name
    own = data.slice(array=name).copy()
    own['y'] = np.zeros(own.n_points)
    before = np.asarray(data.render(own, array='y', **SIZE))
    of_times = [(frame.cut[0].mean, frame.cut[0]['x'].max()) for frame in data.sweep(path='times', draws=False, array=name)]
    assert of_times == [(1, 17), (2, 17)]  # the middle layer of 9 to 17
    assert np.array_equal(np.asarray(data.render(own, array='y', **SIZE)), before)
    assert data.slice(array=name).mean == 1 and data.slice(array='x').max == 17


def test_a_copy_is_drawn_where_it_was_cut(shell):
    own = shell.slice(**PLANE).copy()
    with pytest.raises(vprobe.UsageError, match='drawn where it was cut'):
        shell.render(own, normal='x', **SIZE)
    with pytest.raises(vprobe.InputError, match='there are: '):
        shell.render(own, array='none', **SIZE)
    with pytest.raises(vprobe.UsageError, match='takes a slice of this data set'):
        vprobe.open('demo:shell:8', classify='cpu').render(own, **SIZE)
    assert shell.render(shell.slice('sphere:2', origin=(0, 0, 0)).copy(), **SIZE).shape == (120, 160, 4)
    assert shell.render(shell.slice(**PLANE, crinkle=True).copy(), **SIZE).shape == (120, 160, 4)


@pytest.mark.parametrize('make', [
    lambda: vprobe.open('demo:shell:8', classify='cpu'), lambda: vprobe.open('demo:mixed:4', classify='cpu'),
    lambda: vprobe.open('demo:blob:8', classify='cpu'), cube])
def test_a_data_set_takes_arrays_by_their_length(make):
    data = make()
    before = data.slice(**PLANE)
    data.slice(normal='x')  # builds what finds cells, which renumbers them
    x = np.arange(data.n_points, dtype=np.float64)
    data['x'] = x
    data['id'] = np.arange(data.n_cells)
    assert data['x'] is not None and np.shares_memory(data['x'], x)
    piece = data.slice(**PLANE, array='x')
    assert 'x' in piece and 'x' not in before
    assert np.array_equal(piece['id'], piece.cells)
    assert piece.mean is not None and piece.max <= data.n_points - 1
    data['x'] = np.full(data.n_points, 2.5)
    assert data.slice(**PLANE, array='x').mean == pytest.approx(2.5)
    assert data.render(array='x', **SIZE).shape == (120, 160, 4)


def test_an_added_array_is_linear_where_it_should_be():
    data = cube()
    z, y, x = np.mgrid[0:5, 0:5, 0:5].astype(float)
    data['q'] = x + 10 * z  # of the lattice's shape
    piece = data.slice(normal='z', origin=(2, 2, .5), array='q')
    assert piece.area == pytest.approx(16) and piece.mean == pytest.approx(2 + 5)  # by hand
    data['v'] = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    assert data.slice(normal='z', origin=(2, 2, .5), array='v').flux == pytest.approx(8)  # z = 1/2 over 16


def test_several_blocks():
    points = [np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (low, low + 1)], float) for low in (0, 1)]
    blocks = [{'kind': 'structured', 'points': (2, 2, 2), 'coordinates': at, 'fields': [], 'name': ''} for at in points]
    data = vprobe.Dataset(_core.Dataset.wrap(blocks, 'cpu', ''))
    data['p'] = np.arange(16.)
    assert np.array_equal(data['p'][1], np.arange(8.) + 8)
    data['q'] = [np.arange(8.), np.arange(8.) * 2]
    assert data['q'][1][7] == 14
    data['c'] = [5, 6]
    assert data.slice(normal='x', origin=(1.5, .5, .5), array='c').mean == 6
    with pytest.raises(vprobe.InputError, match='3 values, but there are 16 points and 2 cells'):
        data['c'] = np.zeros(3)
    with pytest.raises(KeyError, match='none'):
        data['none']
    assert 'q' in data and 'point:q' in data and 'cell:q' not in data and 5 not in data
    with pytest.raises(TypeError):
        iter(data)
