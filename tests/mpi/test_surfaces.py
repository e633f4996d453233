"""Surfaces of any form and thresholds over several processes: figures and pictures as of one."""
import json
import os

import pytest

import pieces

SMALL = ('--size', '320x240')
LONG = bool(os.environ.get('VPROBE_LONG'))
SPHERE = ('--surface', 'sphere:0.5')
FORMS = [SPHERE, ('--surface', 'cylinder:0.4'), ('--surface', 'z = 0.2*sin(5*x)'), ('--iso', 0.3)]


KINDS = ['tetrahedra', 'hexahedra', 'image', 'rectilinear', 'blocks']


ALL = [(kind, form) for kind in KINDS for form in FORMS]


@pytest.mark.parametrize('kind, form', ALL if LONG else ALL[::3], ids=lambda value: str(value))
def test_figures(same_figures, cases, kind, form):
    same_figures(3, cases[kind], *form)


@pytest.mark.parametrize('ranks', [1, 2, 4])
def test_figures_of_any_number_of_ranks(same_figures, cases, ranks):
    told = same_figures(ranks, cases['tetrahedra'], *SPHERE)
    assert told['sheets'][0]['components'] == 1


@pytest.mark.parametrize('kind', KINDS if LONG else KINDS[::2])
def test_thresholds(same_figures, cases, kind):
    same_figures(3, cases[kind], *SPHERE, '--threshold', 0.1, 0.5)


def test_a_window_on_a_sphere(same_figures, cases):
    same_figures(3, cases['hexahedra'], *SPHERE, '--window', 0.6, 0.4)


@pytest.mark.gpu
@pytest.mark.parametrize('kind', KINDS if LONG else KINDS[1::2])
def test_opaque_pictures(same_pictures, cases, kind):
    same_pictures([3], cases[kind], *SPHERE, *SMALL)


@pytest.mark.gpu
@pytest.mark.parametrize('form', FORMS if LONG else FORMS[1::2], ids=lambda form: str(form[1]))
def test_translucent_pictures(same_pictures, cases, form):
    same_pictures([1, 2, 3, 4] if LONG else [4], cases['tetrahedra'], *form, '--opacity', 0.5, *SMALL)


@pytest.mark.gpu
@pytest.mark.parametrize('look', [('--samples', 1), ('--mesh',), ('--lines', 8, '--no-labels'),
                                  ('--array', 'cell:c', '--lines', 8, '--no-labels')], ids=lambda look: look[0])
def test_looks(same_pictures, cases, look):
    same_pictures([3], cases['hexahedra'], *SPHERE, *look, *SMALL)


@pytest.mark.gpu
def test_pictures_of_thresholds(same_pictures, cases):
    same_pictures([3], cases['tetrahedra'], *SPHERE, '--threshold', 0.1, 0.5, *SMALL)


SHARED = ['multiblock/sqnz/sqnz_s.adf.cgns', 'multiblock/multi_bin/multi-bin-C.xyz', 'time/mug/mug.e',
          'unstructured/disk_out_ref/disk_out_ref.ex2', 'polyhedral/flange/flange.foam',
          'formats/cavity_foam/case.foam']


def sphere(programs, path):
    """One about the middle that meets the data."""
    bounds = json.loads(programs.plain('info', path, '--json').stdout)['bounds']
    return '--surface', f'sphere:{0.3 * max(bounds[i + 1] - bounds[i] for i in (0, 2, 4))}'


@pytest.mark.parametrize('name', SHARED if LONG else SHARED[::2])
def test_shared_data_sets(programs, same_figures, shared_data, name):
    path = shared_data / name
    same_figures(3, path, *sphere(programs, path))


@pytest.mark.gpu
@pytest.mark.parametrize('name', SHARED if LONG else SHARED[:1])
def test_pictures_of_shared_data_sets(programs, same_pictures, shared_data, name):
    path = shared_data / name
    same_pictures([3], path, *sphere(programs, path), '--opacity', 0.6, *SMALL)


@pytest.mark.parametrize('what', [('--iso', 99), ('--normal', 1, 0, 0, '--origin', 99, 0, 0)], ids=['value', 'plane'])
def test_what_misses_tells_of_all_the_data(programs, cases, tmp_path, what):
    told = [run.stderr.partition(': ')[2] for run in
            (programs.plain('slice', cases['hexahedra'], *what, '-o', tmp_path / 'one.vtp'),
             programs.mpi(3, 'slice', cases['hexahedra'], *what, '-o', tmp_path / 'three.vtp'))]
    assert 'the slice is empty' in told[0] and told[1] == told[0]
