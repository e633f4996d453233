"""Opening, cutting, arrays, figures, errors, words."""
import gc
import os
import pathlib
import warnings

import numpy as np
import pytest

import vprobe

PLANE = dict(normal=(.3, .5, .8))
OPTIONS = ('--normal', '0.3', '0.5', '0.8')


@pytest.mark.parametrize('demo', ['shell:16', 'tets:8', 'mixed:6', 'blob:12'])
def test_figures_are_those_of_the_program_to_the_last_bit(demo, sheet_of):
    data = vprobe.open(f'demo:{demo}', classify='cpu')
    of_program = sheet_of(f'demo:{demo}', *OPTIONS)
    piece = data.slice(**PLANE)
    for figure in ('area', 'mean', 'min', 'max'):
        assert getattr(piece, figure) == of_program[figure], figure
    # The second cut may go another way, which adds in another order.
    assert data.slice(**PLANE).area == pytest.approx(piece.area, rel=1e-13)


def test_a_slice_has_points_polygons_and_arrays(shell):
    piece = shell.slice(**PLANE, window=(2, 1), threshold=(0, 1), array='s')
    assert piece.points.shape == (piece.n_points, 3) and piece.points.dtype == np.float64
    offsets, corners = piece.polygons
    assert len(offsets) == piece.n_polygons + 1 and offsets[0] == 0 and offsets[-1] == len(corners)
    assert corners.min() >= 0 and corners.max() < piece.n_points
    assert piece['s'].shape == (piece.n_points,) and piece['v'].shape == (piece.n_points, 3)
    assert piece['point:s'] is piece['s'] and 's' in piece and piece.keys() == ['s', 'v']
    assert piece.cells.shape == piece.blocks.shape == (piece.n_polygons,)
    assert piece.cells.max() < shell.n_cells
    assert 0 < piece.area < 2.0 and -1.0 < piece.min < piece.mean < piece.max  # cells with means between 0 and 1
    with pytest.raises(KeyError, match='there are s, v'):
        piece['none']


def test_views_are_made_once_are_read_only_and_outlive_all(shell):
    piece = shell.slice(**PLANE)
    assert piece.points is piece.points and piece['s'] is piece['s'] and piece.polygons is piece.polygons
    for array in (piece.points, *piece.polygons, piece['s'], piece.cells, piece.blocks):
        assert not array.flags.writeable and not array.flags.owndata
        with pytest.raises(ValueError):
            array[0] = 0
    kept, values = piece.points, piece['s']
    before = kept.copy(), values.copy()
    del piece, shell
    gc.collect()
    for _ in range(5):
        vprobe.open('demo:tets:8').slice(**PLANE)['s'].copy()
    assert np.array_equal(kept, before[0]) and np.array_equal(values, before[1])


def test_a_copy_is_ones_own(shell):
    piece = shell.slice(**PLANE)
    own = piece.copy()
    own.points[:] = 0
    own['s'][:] = 7
    own.polygons.offsets[1] = 0
    assert piece.points.any() and (piece['s'] != 7).any()
    assert (own.area, own.n_points, own.n_polygons) == (piece.area, piece.n_points, piece.n_polygons)
    with pytest.raises(vprobe.InputError, match='polygon 0 does not have three corners'):
        own.save('none.vtp')  # since its polygons were spoiled above


def test_many_slices_at_once(shell):
    three = shell.slice_orthogonal()
    assert [tuple(map(abs, each.normal)) for each in three] == [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    assert three.area == pytest.approx(sum(each.area for each in three))
    stack = shell.slice_along_axis(4, 'x')
    assert len(stack) == 4
    assert np.allclose([each.origin[0] for each in stack], [-2.25, -.75, .75, 2.25])
    assert all(each.area > 0 for each in stack) and len(stack[1:3]) == 2
    with pytest.raises(IndexError):
        stack[4]


def test_other_surfaces(shell):
    wave = shell.slice('z = sin(x)')
    assert np.abs(wave.points[:, 2] - np.sin(wave.points[:, 0])).max() < 1e-9
    iso = shell.isosurface(.5)
    assert np.abs(iso['s'] - .5).max() < 1e-5
    ball = shell.slice('sphere:2', origin=(0, 0, 0))
    assert np.abs(np.linalg.norm(ball.points, axis=1) - 2).max() < 1e-9
    layer = shell.slice('k=3')
    assert layer.n_polygons == 16 * 16


def test_whole_cells(shell):
    cells = shell.slice(**PLANE, crinkle=True)
    assert cells.n_polygons > shell.slice(**PLANE).n_polygons and cells.area == shell.slice(**PLANE).area


def test_files(shell, tmp_path):
    file = tmp_path / 'cut.vtp'
    shell.slice(**PLANE).save(file)
    assert file.stat().st_size > 1000
    shell.slice_orthogonal().save(str(tmp_path / 'three.vtm'))
    with pytest.raises(vprobe.UsageError, match='vtp'):
        shell.slice().save(tmp_path / 'cut.docx')
    with pytest.raises(vprobe.OutputError):
        shell.slice().save('/proc/none/cut.vtp')


def test_a_data_set_says_what_it_is(shell):
    assert shell.bounds[:4] == (-3.0, 3.0, 0.0, 3.0)
    assert (shell.kind, shell.n_cells, shell.n_blocks, shell.times) == ('curvilinear', 4096, 1, ())
    name = shell.arrays[0]
    assert (name.name, name.place, name.components, name.dtype) == ('s', 'point', 1, np.float32)
    assert shell.memory().geometry > 0 and not shell.memory().copied


def test_each_object_tells_in_one_line_what_it_is(shell):
    probe = vprobe.Probe.paddlewheel(vanes=3, opacity=.6)
    traces = shell.trace(shell.slice(), vector_lattice=4)
    for thing in (shell, shell.slice(), shell.cut(probe), probe, traces, shell.sample([[0, 2, 0]]), shell.memory(),
                  shell.slice().polygons, vprobe.Sheet(), shell.plan()[0], shell.arrays[0]):
        words = repr(thing)
        assert '\n' not in words and ' at 0x' not in words, words
    assert repr(shell) == '<vprobe.Dataset demo:shell:16: curvilinear, 4096 cells, s, v>'
    assert repr(probe) == '<vprobe.Probe paddlewheel, vanes 3, opacity 0.6>'


def test_errors_have_kinds(shell, tmp_path):
    cases = [
        (vprobe.InputError, lambda: vprobe.open(tmp_path / 'absent.vtu'), 'absent.vtu'),
        (vprobe.InputError, lambda: shell.slice(array='none'), 'there are: point:s, point:v'),
        (vprobe.UsageError, lambda: shell.slice(nonsense=1), "there is no setting 'nonsense'"),
        (vprobe.UsageError, lambda: shell.slice(normal=(0, 0, 0)), 'normal'),
        (vprobe.UsageError, lambda: shell.slice(window=(-1, 1)), 'window'),
        (vprobe.UsageError, lambda: shell.slice(array={}), 'takes a text'),
        (vprobe.UsageError, lambda: shell.slice('z = bogus(x)'), 'bogus'),
        (vprobe.UsageError, lambda: shell.cut('single'), 'is no probe'),
        (vprobe.UsageError, lambda: vprobe.open('demo:shell', classify='fast'), 'auto, gpu or cpu'),
        (vprobe.InputError, lambda: shell.sample([1, 2, 3]), r'\(n, 3\)'),
    ]
    for kind, call, words in cases:
        with pytest.raises(kind, match=words) as raised:
            call()
        assert isinstance(raised.value, vprobe.Error) and '\n' not in str(raised.value)
    assert issubclass(vprobe.UsageError, ValueError) and issubclass(vprobe.OutputError, OSError)
    (tmp_path / 'damaged.vtu').write_text('<VTKFile')
    with pytest.raises(vprobe.InputError, match='damaged.vtu'):
        vprobe.open(tmp_path / 'damaged.vtu')


def test_warnings_are_pythons(shell):
    with pytest.warns(vprobe.VprobeWarning, match='is empty'):
        empty = shell.slice(origin=(100, 0, 0), normal='x')
    assert (empty.n_polygons, empty.area, empty.mean) == (0, 0.0, None)
    assert empty.points.shape == (0, 3) and empty['s'].shape == (0,) and empty['v'].shape == (0, 3)
    assert empty.copy().points.shape == (0, 3)
    with warnings.catch_warnings():
        warnings.simplefilter('error')
        with pytest.raises(vprobe.VprobeWarning):
            shell.slice(origin=(100, 0, 0), normal='x')


def test_a_file_is_read_by_the_child_beside_the_module(tmp_path, sheet_of):
    nrrd = tmp_path / 'ramp.nrrd'
    values = np.arange(4 * 5 * 6, dtype=np.float32)
    nrrd.write_bytes(b'NRRD0004\ntype: float\ndimension: 3\nsizes: 6 5 4\nencoding: raw\nendian: little\n\n'
                     + values.tobytes())
    lines = []
    data = vprobe.open(nrrd, progress=lines.append)
    assert any('ramp.nrrd' in line for line in lines), lines
    assert data.kind == 'image' and data.n_points == 120
    assert data.slice(**PLANE).area == sheet_of(nrrd, *OPTIONS)['area']
    assert (pathlib.Path(vprobe.__file__).parent / 'vprobe-read').exists()


def test_save_replaces_no_input(tmp_path):
    file = tmp_path / 'a.vtk'
    file.write_text('# vtk DataFile Version 3.0\na\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n'
                    'ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 8\nSCALARS s float\nLOOKUP_TABLE default\n'
                    '0 1 2 3 4 5 6 7\n')
    kept = file.read_bytes()
    (tmp_path / 'link.vtp').symlink_to(file)
    os.link(file, tmp_path / 'same.vtp')
    data = vprobe.open(file)
    for name in ('link.vtp', 'same.vtp'):
        with pytest.raises(vprobe.OutputError, match='is one of the input files'):
            data.slice(normal='z').save(tmp_path / name)
    assert file.read_bytes() == kept


@pytest.mark.parametrize('settings, options', [
    (dict(normal='x', array='v'), ('--normal', 'x', '--array', 'v')),
    (dict(normal='-x', array='v'), ('--normal', '-x', '--array', 'v')),
    (dict(normal='-z', vector_array='v'), ('--normal', '-z', '--vector-array', 'v')),
    (dict(normal=(.3, -.5, .8), array='s', vectors='tufts'),
     ('--normal', '0.3', '-0.5', '0.8', '--array', 's', '--vectors', 'tufts')),
    (dict(normal='-y', origin=(0, 0, 0), array='v'), ('--normal', '-y', '--origin', '0', '0', '0', '--array', 'v')),
    (dict(normal='z', array='s'), ('--normal', 'z', '--array', 's')),
    (dict(surface='k=3', array='v'), ('--surface', 'k=3', '--array', 'v')),
    (dict(surface='sphere:2', origin=(0, 0, 0), array='v'),
     ('--surface', 'sphere:2', '--origin', '0', '0', '0', '--array', 'v'))])
def test_the_flux_is_that_of_the_program(shell, sheet_of, settings, options):
    of_program = sheet_of('demo:shell:16', *options)
    piece = shell.slice(**settings)
    for figure in ('flux', 'boundary_flux'):
        assert getattr(piece, figure) == of_program[figure], figure
    assert (piece.flux is None) == (of_program['flux'] is None)
    # Whatever was cut before, and by a cut that links the cells, which adds in another order.
    again = shell.slice(**settings).flux
    assert again == of_program['flux'] or again == pytest.approx(of_program['flux'], rel=1e-12, abs=1e-12)


def test_the_flux_follows_the_users_own_normal():
    z, y, x = np.mgrid[0:3, 0:4, 0:5].astype(float)
    data = vprobe.image({'v': np.stack([2 + 0 * x, x, 3 * z], axis=-1)}, classify='cpu')
    assert data.slice(normal='x').flux == pytest.approx(2 * 3 * 2)  # by hand: 2 through 3 x 2
    assert data.slice(normal='-x').flux == pytest.approx(-12)
    assert data.slice(normal='z').flux == pytest.approx(3 * 4 * 3)
    assert data.slice(normal='-z').flux == pytest.approx(-36)
    assert data.slice(normal='z', component='x').flux == pytest.approx(36)
    assert [piece.flux for piece in data.slice_orthogonal()] == pytest.approx([12, 2 * 4 * 2, 36])
