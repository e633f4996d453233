"""Polygons of several processes: a part for each, or one file."""
import csv
import json
import os
import signal
import time

import numpy as np
import pytest

import pieces
import processes
from conftest import own_lines
from pieces import vtk, vtk_to_numpy

OBLIQUE = ('--normal', 0.3, 0.5, 0.8)
TYPES = {'pvtp': vtk.vtkXMLPPolyDataReader, 'vtp': vtk.vtkXMLPolyDataReader, 'vtm': vtk.vtkXMLMultiBlockDataReader}


@pytest.fixture
def case(tmp_path):
    grid = pieces.tetrahedra(6)
    folder = tmp_path / 'data'
    folder.mkdir()
    return pieces.write_pvtu(folder, grid, pieces.slabs(grid, 4))


def opened(path):
    reader = TYPES[path.suffix[1:]]()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetErrorCode() == 0
    return reader.GetOutput()


def polygons_of(data):
    """Each polygon with the places and values of its corners, in an order that does not depend on the file's."""
    points = vtk_to_numpy(data.GetPoints().GetData())
    arrays = [vtk_to_numpy(data.GetPointData().GetArray(i)).reshape(len(points), -1)
              for i in range(data.GetPointData().GetNumberOfArrays())]
    corners = np.hstack([points, *arrays])
    starts = vtk_to_numpy(data.GetPolys().GetOffsetsArray())
    ids = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
    sheets = vtk_to_numpy(data.GetCellData().GetArray('vprobe:sheet'))
    return sorted((int(sheets[p]), corners[ids[starts[p]:starts[p + 1]]].tolist()) for p in range(len(starts) - 1))


def area_of(data):
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(data)
    mass = vtk.vtkMassProperties()
    mass.SetInputConnection(triangles.GetOutputPort())
    mass.Update()
    return mass.GetSurfaceArea()


@pytest.mark.parametrize('ranks', [1, 4])
def test_a_part_for_each_rank(programs, case, tmp_path, ranks):
    asked = (case, '--probe', 'trihedral', '--stats', tmp_path / 'figures.json')
    programs.mpi(ranks, 'slice', *asked, '-o', tmp_path / 'out.pvtp')
    programs.mpi(ranks, 'slice', *asked, '-o', tmp_path / 'out.vtp')
    parts, whole = opened(tmp_path / 'out.pvtp'), opened(tmp_path / 'out.vtp')
    assert polygons_of(parts) == polygons_of(whole)
    figures = json.loads((tmp_path / 'figures.json').read_text())['sheets']
    assert parts.GetNumberOfCells() == sum(sheet['polygons'] for sheet in figures)
    assert area_of(parts) == pytest.approx(sum(sheet['area'] for sheet in figures), rel=1e-12)
    names = [parts.GetCellData().GetArrayName(i) for i in range(parts.GetCellData().GetNumberOfArrays())]
    assert names == [whole.GetCellData().GetArrayName(i) for i in range(whole.GetCellData().GetNumberOfArrays())]
    assert sorted(p.name for p in (tmp_path / 'out').iterdir()) == [f'part_{rank}.vtp' for rank in range(ranks)]
    # Each has what its rank has cut.
    shares = json.loads((tmp_path / 'figures.json').read_text())['ranks']
    for rank, share in enumerate(shares):
        cells = opened(tmp_path / 'out' / f'part_{rank}.vtp').GetNumberOfCells()
        assert (cells > 0) == (sum(sheet['cut_cells'] for sheet in share['sheets']) > 0)


def test_the_plain_program_writes_one_part(programs, case, tmp_path):
    programs.plain('slice', case, *OBLIQUE, '-o', tmp_path / 'out.pvtp')
    programs.plain('slice', case, *OBLIQUE, '-o', tmp_path / 'out.vtp')
    assert (tmp_path / 'out' / 'part_0.vtp').read_bytes() == (tmp_path / 'out.vtp').read_bytes()
    assert polygons_of(opened(tmp_path / 'out.pvtp')) == polygons_of(opened(tmp_path / 'out.vtp'))


def test_ranks_that_cut_nothing(programs, case, tmp_path):
    programs.mpi(4, 'slice', case, '--normal', 'x', '--origin', 0.9, 0, 0, '-o', tmp_path / 'a & b.pvtp')
    programs.plain('slice', case, '--normal', 'x', '--origin', 0.9, 0, 0, '-o', tmp_path / 'out.vtp')
    assert polygons_of(opened(tmp_path / 'a & b.pvtp')) == polygons_of(opened(tmp_path / 'out.vtp'))


def test_a_file_for_each_sheet(programs, case, tmp_path):
    asked = ('slice', case, '--probe', 'trihedral', '-o')
    programs.mpi(3, *asked, tmp_path / 'mpi.vtm')
    programs.plain(*asked, tmp_path / 'plain.vtm')
    mpi, plain = opened(tmp_path / 'mpi.vtm'), opened(tmp_path / 'plain.vtm')
    assert mpi.GetNumberOfBlocks() == plain.GetNumberOfBlocks() == 3
    for sheet in range(3):
        assert polygons_of(mpi.GetBlock(sheet)) == polygons_of(plain.GetBlock(sheet))


def test_a_file_for_each_frame(programs, case, tmp_path):
    sweep = ('sweep', case, '--path', 'rotate', '--frames', 2, '--probe', 'trihedral', '-o')
    programs.mpi(3, *sweep, tmp_path / 'mpi.pvd')
    programs.plain(*sweep, tmp_path / 'plain.pvd')
    assert (tmp_path / 'mpi.pvd').read_text() == (tmp_path / 'plain.pvd').read_text().replace('plain/', 'mpi/')
    assert sorted(path.name for path in (tmp_path / 'mpi').iterdir()) == ['frame_0000.vtp', 'frame_0001.vtp']
    for frame in ('frame_0000.vtp', 'frame_0001.vtp'):
        assert polygons_of(opened(tmp_path / 'mpi' / frame)) == polygons_of(opened(tmp_path / 'plain' / frame))


def rows_of(path):
    """Without the numbers of cells, which count within what a rank holds."""
    with path.open(newline='') as file:
        return [{name: text for name, text in row.items() if name != 'cell'} for row in csv.DictReader(file)]


@pytest.mark.parametrize('kind', ['tetrahedra', 'hexahedra', 'image', 'blocks'])
def test_values_along_a_line(programs, cases, tmp_path, kind):
    # Through the borders, one of them in the line.
    for line in ((-0.9, -0.4, 1.2, 0.7), (-2, 0, 2, 0)):
        asked = ('slice', cases[kind], *OBLIQUE, '--line', *line, '-o')
        programs.mpi(4, *asked, tmp_path / 'mpi.csv')
        programs.plain(*asked, tmp_path / 'plain.csv')
        assert rows_of(tmp_path / 'mpi.csv') == rows_of(tmp_path / 'plain.csv')
        assert len(rows_of(tmp_path / 'mpi.csv')) > 10


def test_all_parts_or_none(programs, case, tmp_path):
    out = tmp_path / 'out.pvtp'
    (tmp_path / 'out').mkdir()
    (tmp_path / 'out' / 'part_2.vtp').mkdir()  # where one rank is to write
    done = programs.run(4, 'slice', case, *OBLIQUE, '-o', out)
    lines = own_lines(done.stderr)
    assert done.returncode != 0 and len(lines) == 1 and 'rank 2: ' in lines[0] and 'part_2.vtp' in lines[0]
    assert not out.exists()
    # A rank that takes more than a second to clear up is killed by mpiexec.
    assert [path.name for path in tmp_path.rglob('*') if path.is_file() and path.parent.name != 'data'
            and not path.name.startswith('.vprobe-')] == []


def test_a_file_where_the_parts_belong(programs, case, tmp_path):
    (tmp_path / 'out').write_text('')
    for name in ('out.pvtp', 'out.vtm'):
        done = programs.run(2, 'slice', case, *OBLIQUE, '-o', tmp_path / name)
        assert done.returncode != 0 and 'and that is a file; remove it' in own_lines(done.stderr)[0]


def test_nothing_stays_of_parts_where_a_rank_is_killed(programs, case, tmp_path):
    out = tmp_path / 'out.pvtp'
    process = programs.start(4, 'slice', case, '--probe', 'stack', '--sheets', 24, '-o', out)
    ranks = processes.ranks_of(process, 4)
    processes.wait_for(lambda: any(path.stat().st_size > 0 for path in tmp_path.glob('.vprobe-*')))
    os.kill(ranks[1], signal.SIGSTOP)
    time.sleep(0.1)
    others_named = list((tmp_path / 'out').glob('*')) if (tmp_path / 'out').exists() else []
    os.kill(ranks[1], signal.SIGKILL)
    process.communicate(timeout=30)
    assert process.returncode != 0
    assert not out.exists() or others_named
