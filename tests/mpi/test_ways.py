"""One plane through a set of each kind: all strategies and both classifiers, the Python module, several ranks and the
window find the same cells, and areas that agree to 1e-12."""
import json
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
import pytest

import pieces
from pieces import vtk

KINDS = ('hexahedra', 'tetrahedra', 'image', 'rectilinear', 'blocks', 'overlapping', 'contact')
STRATEGIES = ('rows', 'spans', 'cells', 'generations', 'scan')
PLANES = {'oblique': ('--origin', 0.03, 0.11, 0.02, '--normal', 0.3, 0.5, 0.8), 'along': ('--origin', 0, 0, 0, '--normal', 'x')}


def boxes(path, chosen, value):
    """Hexahedra, each (corner, size), that share points where these lie at one place. value: of the array u."""
    grid, places = vtk.vtkUnstructuredGrid(), {}
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for corner, size in chosen:
        ids = []
        for step in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)):
            place = tuple(np.array(corner) + size * np.array(step))
            if place not in places:
                places[place] = points.InsertNextPoint(place)
            ids.append(places[place])
        grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8, ids)
    grid.SetPoints(points)
    array = pieces.numpy_to_vtk(np.array([value(np.array(place)) for place in places]), deep=True)
    array.SetName('u')
    grid.GetPointData().AddArray(array)
    pieces.write(vtk.vtkXMLUnstructuredGridWriter(), grid, path)


def parents_and_children():
    halves = [(x, y, z) for x in (0.0, 0.25) for y in (0.0, 0.25) for z in (0.0, 0.25)]
    parents = [((x, y, z), 0.5) for x in (-0.5, 0.0) for y in (-0.5, 0.0) for z in (-0.5, 0.0)]
    return parents + [(tuple(np.array(corner) + half), 0.25) for corner, _ in parents[::2] for half in halves]


@pytest.fixture(scope='session')
def sets(cases, tmp_path_factory):
    """A data set of each kind."""
    folder = tmp_path_factory.mktemp('ways')
    boxes(folder / 'overlapping.vtu', parents_and_children(), lambda place: place @ [1.0, 2.0, 3.0])
    # Two bodies that touch at y = 0, with faces of different sizes and values that jump.
    boxes(folder / 'coarse.vtu', [((-0.5, 0.0, -0.5), 1.0)], lambda place: 10.0)
    boxes(folder / 'fine.vtu', [((x, -0.5, z), 0.5) for x in (-0.5, 0.0) for z in (-0.5, 0.0)], lambda place: place[0])
    (folder / 'contact.vtm').write_text(
        '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
        '<DataSet index="0" file="coarse.vtu"/><DataSet index="1" file="fine.vtu"/></vtkMultiBlockDataSet></VTKFile>')
    return {**cases, 'overlapping': folder / 'overlapping.vtu', 'contact': folder / 'contact.vtm'}


def sheet_of(printed):
    sheet = json.loads(printed)['sheets'][0]
    return {key: sheet[key] for key in ('cut_cells', 'area', 'mean', 'min', 'max')}


def assert_same(sheet, expected, way):
    largest = max(abs(expected['min']), abs(expected['max']))
    assert sheet['cut_cells'] == expected['cut_cells'], way
    assert sheet['area'] == pytest.approx(expected['area'], rel=1e-12), way
    for key in ('mean', 'min', 'max'):
        assert sheet[key] == pytest.approx(expected[key], abs=1e-12 * largest), (way, key)


@pytest.fixture
def expected(programs, sets):
    def figures(kind, plane):
        return sheet_of(programs.plain('slice', sets[kind], *PLANES[plane], '--stats', '-').stdout)

    return figures


@pytest.mark.parametrize('plane', PLANES)
def test_strategies(programs, sets, expected, plane):
    for kind in KINDS:
        by_plan, ways = expected(kind, plane), 0
        for strategy in STRATEGIES:
            done = subprocess.run([programs.program, 'slice', sets[kind], *map(str, PLANES[plane]), '--strategy', strategy,
                                   '--stats', '-'], capture_output=True, encoding='utf-8', timeout=120)
            if done.returncode == 0:
                assert_same(sheet_of(done.stdout), by_plan, (kind, strategy))
                ways += 1
            else:
                assert done.returncode == 1 and '--strategy' in done.stderr
        assert ways >= 2, kind


@pytest.mark.gpu
def test_the_device_classifies(programs, sets, expected):
    for kind in KINDS:
        done = programs.plain('slice', sets[kind], *PLANES['oblique'], '--classify', 'gpu', '--stats', '-')
        assert_same(sheet_of(done.stdout), expected(kind, 'oblique'), kind)


def test_python(sets, expected):
    pytest.importorskip('vprobe', reason='needs the Python module')
    script = '''
import json, sys, vprobe
for path in sys.argv[1:]:
    cut = vprobe.open(path, classify='cpu').slice(normal=(0.3, 0.5, 0.8), origin=(0.03, 0.11, 0.02))
    print(json.dumps({key: getattr(cut, key) for key in ('cut_cells', 'area', 'mean', 'min', 'max')}))
'''
    done = subprocess.run([sys.executable, '-c', script, *(str(sets[kind]) for kind in KINDS)], capture_output=True,
                          encoding='utf-8', timeout=120)
    assert done.returncode == 0, done.stderr
    for kind, line in zip(KINDS, done.stdout.splitlines()):
        assert_same(json.loads(line), expected(kind, 'oblique'), kind)


# One rank reads a file that is in one piece, and cells of different sizes that meet between ranks are refused.
@pytest.mark.parametrize('kind', [kind for kind in KINDS if kind not in ('overlapping', 'contact')])
def test_ranks(programs, sets, expected, kind):
    done = programs.mpi(3, 'slice', sets[kind], *PLANES['oblique'], '--stats', '-')
    assert_same(sheet_of(done.stdout), expected(kind, 'oblique'), kind)


@pytest.fixture(scope='module')
def display():
    """A screen of its own."""
    if not shutil.which('Xvfb'):
        pytest.skip('needs Xvfb')
    read, write = os.pipe()
    server = subprocess.Popen(['Xvfb', '-displayfd', str(write), '-screen', '0', '640x480x24', '-nolisten', 'tcp'],
                              pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as number:
        name = number.readline().strip()
    if not name:
        pytest.skip('Xvfb does not start')
    yield ':' + name
    server.terminate()
    server.wait()


@pytest.mark.gpu
def test_the_window(programs, sets, expected, display):
    """The window saves its polygons, and VTK tells their area."""
    for kind in ('tetrahedra', 'image', 'overlapping', 'contact'):
        with tempfile.TemporaryDirectory() as folder:
            lines = ['wait', f'save-slice {folder}/cut.vtp', 'wait', 'quit', '']
            done = subprocess.run([programs.program, 'view', sets[kind], *map(str, PLANES['oblique']), '--commands', '-'],
                                  input='\n'.join(lines), capture_output=True, encoding='utf-8', timeout=120,
                                  env=dict(os.environ, DISPLAY=display, XDG_STATE_HOME=folder))
            assert done.returncode == 0, done.stderr
            reader = vtk.vtkXMLPolyDataReader()
            reader.SetFileName(f'{folder}/cut.vtp')
            measure = vtk.vtkCellSizeFilter()
            measure.SetInputConnection(reader.GetOutputPort())
            measure.SetComputeSum(True)
            measure.Update()
        area = measure.GetOutput().GetFieldData().GetArray('Area').GetValue(0)
        assert area == pytest.approx(expected(kind, 'oblique')['area'], rel=1e-12), kind
