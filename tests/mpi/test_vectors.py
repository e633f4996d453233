"""Particles and flux over several processes: figures, paths and pictures as of one."""
import os

import pytest

import pieces

SMALL = ('--size', '320x240')
LONG = bool(os.environ.get('VPROBE_LONG'))
PLANE = ('--normal', 0.3, 0.5, 0.8)
LINES = ('--vectors', 'lines', '--vector-lattice', 9, '--vector-steps', 40, '--vector-direction', 'both')
KINDS = ['tetrahedra', 'image', 'rectilinear', 'blocks', 'hexahedra']


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
    """Asserts that both programs follow the same paths, to the last bit. Gives the number of lines."""

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
    same_paths([2, 4], cases[kind], *PLANE, *LINES)
