"""Packs and indices come apart: each rank reads what its share of the sheets meets. Figures and pictures stay those of one."""
import json

import numpy as np
import pytest

import pieces
from conftest import own_lines, without_dependent
from pieces import vtk

OBLIQUE = ('--normal', 0.3, 0.5, 0.8)
SMALL = ('--size', '320x240')


def polyhedra(n):
    """Hexahedra, of which each second layer of cells became polyhedra."""
    grid = pieces.hexahedra(n)
    mixed = vtk.vtkUnstructuredGrid()
    mixed.SetPoints(grid.GetPoints())
    for number in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(number)
        if number // (n * n) % 2 == 0:
            mixed.InsertNextCell(cell.GetCellType(), cell.GetPointIds())
            continue
        stream = vtk.vtkIdList()
        stream.InsertNextId(cell.GetNumberOfFaces())
        for face in range(cell.GetNumberOfFaces()):
            ids = cell.GetFace(face).GetPointIds()
            stream.InsertNextId(ids.GetNumberOfIds())
            for k in range(ids.GetNumberOfIds()):
                stream.InsertNextId(ids.GetId(k))
        mixed.InsertNextCell(vtk.VTK_POLYHEDRON, stream)
    mixed.GetPointData().ShallowCopy(grid.GetPointData())
    mixed.GetCellData().ShallowCopy(grid.GetCellData())
    return mixed


GRIDS = {'tetrahedra': lambda: pieces.tetrahedra(8), 'hexahedra': lambda: pieces.hexahedra(12),
         'straight': lambda: pieces.hexahedra(12, twist=0.0), 'polyhedra': lambda: polyhedra(10)}


@pytest.fixture(scope='module')
def packs(tmp_path_factory, programs):
    """Packs with many parts, by kind, and a file with an index."""
    made = {}
    for kind, make in GRIDS.items():
        folder = tmp_path_factory.mktemp(kind)
        writer = vtk.vtkXMLUnstructuredGridWriter()
        writer.SetEncodeAppendedData(False)
        writer.SetCompressorTypeToNone()
        pieces.write(writer, make(), folder / 'grid.vtu')
        programs.plain('pack', folder / 'grid.vtu', '-o', folder / 'grid.vtkhdf', '--part', 64)
        made[kind] = folder / 'grid.vtkhdf'
    programs.plain('index', folder / 'grid.vtu', '--part', 64)
    return dict(made, index=folder / 'grid.vtu')


@pytest.fixture
def same(programs, tmp_path):
    """Asserts that both programs tell the same figures but for parts, which come apart. Gives both documents."""

    def compare(ranks, command, *arguments):
        documents = []
        for start, count in ((programs.plain, ()), (programs.mpi, (ranks,))):
            start(*count, command, *arguments, '--stats', tmp_path / 'stats.json')
            documents.append(json.loads((tmp_path / 'stats.json').read_text()))
        plain, mpi = documents
        told = [without_parts(without_dependent(each)) for each in documents]
        assert told[0] == told[1], arguments
        return plain, mpi

    return compare


def without_parts(document):
    if isinstance(document, dict):
        return {key: without_parts(value) for key, value in document.items() if key != 'parts'}
    return [without_parts(value) for value in document] if isinstance(document, list) else document


@pytest.mark.parametrize('ranks', [2, 3, 4])
@pytest.mark.parametrize('kind', [*GRIDS, 'index'])
def test_ranks_read_what_their_share_meets(same, packs, kind, ranks):
    plain, mpi = same(ranks, 'slice', packs[kind], '--normal', 0.1, 0.2, 0.9, '--origin', 0, 0, 0.7)
    assert mpi['parts']['all'] == plain['parts']['all'] and mpi['parts']['met'] == plain['parts']['met']
    assert mpi['parts']['bytes_met'] < 1.3 * plain['parts']['bytes_met']  # points of a part may be wanted twice
    assert len(mpi['ranks']) == ranks and all(rank['parts'] == 1 for rank in mpi['ranks'])
    assert sum(rank['cells'] for rank in mpi['ranks']) == mpi['grid']['cells']
    cells = [rank['cells'] for rank in mpi['ranks']]
    assert max(cells) < 1.6 * min(cells), cells


SHEETS = (OBLIQUE, ('--probe', 'trihedral'), ('--probe', 'paddlewheel'), ('--surface', 'sphere:0.6'), ('--iso', 0.3),
          ('--normal', 1, 0, -1), ('--normal', 1, 1, 0), ('--normal', 1, 1, 1), ('--normal', 0, 0, 1),
          ('--normal', 0, 1, 0, '--origin', 0, 1 / 6, 0), ('--window', 0.7, 0.9), (*OBLIQUE, '--array', 'c'),
          (*OBLIQUE, '--crinkle'), (*OBLIQUE, '--threshold', 0.1, 0.6), (*OBLIQUE, '--contour', 0.3),
          ('--normal', 1, 0, 0, '--origin', 9, 0, 0))


@pytest.mark.parametrize('sheet', SHEETS, ids=str)
@pytest.mark.parametrize('kind', ['straight', 'polyhedra', 'tetrahedra'])
def test_figures(same, packs, kind, sheet):
    for ranks in (2, 4):
        same(ranks, 'slice', packs[kind], *sheet)


def test_planes_through_points_and_edges(same, packs):
    """Shares meet in edges and points of the lattice, and a plane through those joins what it cuts on both sides."""
    chance = np.random.default_rng(5)
    for _ in range(3):
        normal = chance.integers(-2, 3, 3)
        origin = chance.integers(-3, 4, 3) / 6
        if normal.any():
            same(4, 'slice', packs['straight'], '--normal', *normal, '--origin', *origin)


def test_one_rank_reads_all_where_quads_meet_triangles(same, programs, tmp_path):
    """Tetrahedra above hexahedra. One process adds vertices of the ones to sides of the others, and ranks cannot."""
    whole = pieces.hexahedra(8, twist=0.0)
    heights = [sum(whole.GetCell(c).GetBounds()[4:6]) for c in range(whole.GetNumberOfCells())]
    cut, grid = vtk.vtkDataSetTriangleFilter(), vtk.vtkAppendFilter()
    cut.SetInputData(pieces.part_of(whole, [c for c, z in enumerate(heights) if z > 0]))
    cut.Update()
    grid.MergePointsOn()
    for part in (pieces.part_of(whole, [c for c, z in enumerate(heights) if z < 0]), cut.GetOutput()):
        grid.AddInputData(part)
    grid.Update()
    pieces.write(vtk.vtkXMLUnstructuredGridWriter(), grid.GetOutput(), tmp_path / 'grid.vtu')
    pack = tmp_path / 'grid.vtkhdf'
    programs.plain('pack', tmp_path / 'grid.vtu', '-o', pack, '--part', 64)
    for ranks in (2, 5, 7):
        _, mpi = same(ranks, 'slice', pack, '--normal', 0.6, -0.3, 0.05 * ranks)
        assert [rank['cells'] > 0 for rank in mpi['ranks']].count(True) == 1, mpi['ranks']
    same(2, 'sweep', pack, *OBLIQUE, '--frames', 3)
    told = programs.mpi(2, 'slice', pack, *OBLIQUE).stderr
    assert [line for line in own_lines(told) if 'one of them reads all of the pack' in line], told
    _, mpi = same(2, 'slice', pack, '--normal', 0, 0, 1, '--origin', 0, 0, -0.6)  # among hexahedra alone
    assert all(rank['cells'] > 0 for rank in mpi['ranks']), mpi['ranks']


def test_polygons(programs, packs, tmp_path):
    corners = []
    for start, count, name in ((programs.plain, (), 'plain.vtp'), (programs.mpi, (3,), 'mpi.vtp')):
        start(*count, 'slice', packs['polyhedra'], *OBLIQUE, '-o', tmp_path / name)
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(tmp_path / name))
        reader.Update()
        data = reader.GetOutput()
        numbers = pieces.vtk_to_numpy(data.GetCellData().GetArray('vprobe:cell'))
        corners.append(sorted((int(numbers[c]), sorted(data.GetPoint(data.GetCell(c).GetPointId(i))
                                                       for i in range(data.GetCell(c).GetNumberOfPoints())))
                              for c in range(data.GetNumberOfCells())))
    assert corners[0] == corners[1]


def test_sweeps(same, packs):
    plain, mpi = same(3, 'sweep', packs['hexahedra'], '--normal', 0, 0.1, 1, '--frames', 6)
    one = [frame['parts']['met'] for frame in plain['frames']]
    assert [frame['parts']['met'] for frame in mpi['frames']] == one and max(one) < plain['frames'][0]['parts']['all']


def test_a_time_costs_the_values_of_what_is_cut(same, programs, tmp_path):
    lines = []
    for step in range(3):
        grid = pieces.hexahedra(12)
        values = pieces.vtk_to_numpy(grid.GetPointData().GetArray('s'))
        values += step * values * values
        pieces.write(vtk.vtkXMLUnstructuredGridWriter(), grid, tmp_path / f'{step}.vtu')
        lines.append(f'<DataSet timestep="{step}" file="{step}.vtu"/>')
    (tmp_path / 'all.pvd').write_text(f'<VTKFile type="Collection"><Collection>{"".join(lines)}</Collection></VTKFile>')
    programs.plain('pack', tmp_path / 'all.pvd', '-o', tmp_path / 'all.vtkhdf', '--part', 64)
    for ranks in (3, 8):
        _, mpi = same(ranks, 'sweep', tmp_path / 'all.vtkhdf', '--path', 'times', *OBLIQUE, '--array', 's')
        first, *later = (frame['parts'] for frame in mpi['frames'])
        assert all(0 < each['bytes_read'] < 0.4 * first['bytes_read'] for each in later), mpi['frames']


def test_what_was_left_out_is_told_once(programs, tmp_path):
    grid = pieces.hexahedra(8)
    flat = vtk.vtkIdList()
    for point in (0, 1, 10, 9):
        flat.InsertNextId(point)
    grid.InsertNextCell(vtk.VTK_QUAD, flat)
    grid.GetCellData().GetArray('c').InsertNextTuple1(7.0)
    pieces.write(vtk.vtkXMLUnstructuredGridWriter(), grid, tmp_path / 'grid.vtu')
    programs.plain('pack', tmp_path / 'grid.vtu', '-o', tmp_path / 'grid.vtkhdf', '--part', 64)
    plain = programs.plain('slice', tmp_path / 'grid.vtkhdf', *OBLIQUE)
    mpi = programs.mpi(3, 'slice', tmp_path / 'grid.vtkhdf', *OBLIQUE)
    wanted = [line.removeprefix('vprobe: ') for line in plain.stderr.splitlines()]
    assert wanted == [line.removeprefix('vprobe-mpi: ') for line in own_lines(mpi.stderr)]


@pytest.mark.gpu
@pytest.mark.parametrize('look', [('--probe', 'trihedral', '--opacity', 0.6), ('--range-of', 'slice'),
                                  ('--log', '--array', 'cell:c'), ('--iso', 0.3)], ids=str)
def test_pictures(same_pictures, packs, look):
    same_pictures([3], packs['polyhedra'], *look, *SMALL)
