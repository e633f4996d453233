"""Particles and flux over several processes: figures, paths and pictures as of one."""
import os

import pytest

SMALL = ('--size', '200x150')
LONG = bool(os.environ.get('VPROBE_LONG'))
PLANE = ('--normal', 0.3, 0.5, 0.8)
LINES = ('--vectors', 'lines', '--vector-lattice', 9, '--vector-steps', 40, '--vector-direction', 'both')
KINDS = ['image', 'tetrahedra', 'rectilinear', 'blocks', 'hexahedra']


def values(path):
    """What a file of paths has, but for the numbers of cells, which count within what a rank holds."""
    from vtk import vtkXMLPolyDataReader
    from vtk.util.numpy_support import vtk_to_numpy

    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    found = {'points': vtk_to_numpy(data.GetPoints().GetData()).tobytes(),
             'lines': vtk_to_numpy(data.GetLines().GetData()).tobytes(),
             'dots': vtk_to_numpy(data.GetVerts().GetData()).tobytes()}
    for arrays in (data.GetPointData(), data.GetCellData()):
        for i in range(arrays.GetNumberOfArrays()):
            if arrays.GetArrayName(i) != 'vprobe:cell':
                found[arrays.GetArrayName(i)] = vtk_to_numpy(arrays.GetArray(i)).tobytes()
    return found


@pytest.fixture
def same_paths(programs, tmp_path):
    """Asserts that both programs follow the same paths, to the last bit."""

    def compare(rank_counts, *arguments):
        programs.plain('slice', *arguments, '--vectors-out', tmp_path / 'plain.vtp')
        plain = values(tmp_path / 'plain.vtp')
        for ranks in rank_counts:
            programs.mpi(ranks, 'slice', *arguments, '--vectors-out', tmp_path / f'{ranks}.vtp')
            several = values(tmp_path / f'{ranks}.vtp')
            assert several.keys() == plain.keys()
            assert [key for key in plain if several[key] != plain[key]] == [], ranks

    return compare


@pytest.mark.parametrize('kind', KINDS)
def test_paths(same_paths, cases, kind):
    same_paths([1, 2, 3, 4] if LONG else [4], cases[kind], *PLANE, *LINES)


@pytest.mark.parametrize('kind', ['rectilinear', 'image'])
def test_paths_by_vectors_of_cells(same_paths, cases, kind):
    same_paths([2, 4] if LONG else [3], cases[kind], *PLANE, *LINES, '--vector-array', 'cell:flow')


@pytest.mark.parametrize('kind', KINDS)
def test_figures(same_figures, cases, kind):
    told = same_figures(3, cases[kind], *PLANE, *LINES, '--vector-part', 'tangential')
    sheet = told['sheets'][0]
    assert sheet['vectors']['traces'] > 20 and sheet['flux'] != 0


def test_a_window_and_jitter(same_paths, cases):
    same_paths([2], cases['hexahedra'], '--probe', 'trihedral', '--window', 0.9, 0.7, '--vectors', 'tufts',
               '--vector-jitter', 1)


def test_blocks_that_overlap(same_paths, tmp_path):
    import pieces  # which is skipped where VTK is not

    files = [tmp_path / name for name in ('a.vti', 'b.vti')]
    for file, origin, spacing in zip(files, ((0, 0, 0), (0.83, 0.05, 0.02)), (0.1, 0.07)):
        pieces.write_image(file, 10, origin, spacing)
    same_paths([2], *files, '--normal', 0.2, 0.3, 1, *LINES)


@pytest.mark.gpu
@pytest.mark.parametrize('kind, look', [('hexahedra', ('tubes', '--vector-color', 's', '--samples', 1)),
                                        ('image', ('lines',)),
                                        ('tetrahedra', ('tufts', '--vector-opacity', 0.9)),
                                        ('blocks', ('ribbons', '--vector-opacity', 0.5, '--samples', 1))],
                         ids=['tubes', 'lines', 'tufts', 'ribbons'])
def test_pictures(same_pictures, cases, kind, look):
    same_pictures([1, 2, 4] if LONG else [3], cases[kind], *PLANE, '--vectors', *look,
                  '--vector-lattice', 5, '--vector-steps', 4, *SMALL)


SHARED = ['multiblock/multi_bin/multi-bin-C.xyz', 'unstructured/disk_out_ref/disk_out_ref.ex2']


@pytest.mark.parametrize('name', SHARED if LONG else SHARED[1:])
def test_shared_data_sets(same_paths, shared_data, name):
    same_paths([3], shared_data / name, '--normal', 1, 0, 0, '--vectors', 'lines', '--vector-lattice', 6)
