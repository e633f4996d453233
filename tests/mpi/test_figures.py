"""Figures and polygons of several processes are those of one."""
import json

import numpy as np
import pytest

import pieces

OBLIQUE = ('--normal', 0.3, 0.5, 0.8)


@pytest.mark.parametrize('ranks', [1, 2, 3, 4, 7])
def test_pieces_of_tetrahedra(same_figures, tmp_path, ranks):
    grid = pieces.tetrahedra(6)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 4))
    told = same_figures(ranks, case, *OBLIQUE)
    assert told['grid']['blocks'] == 1
    assert sum(rank['cells'] for rank in told['ranks']) == told['grid']['cells']


@pytest.mark.parametrize('probe', ['single', 'trihedral', 'paddlewheel', 'stack'])
def test_probes(same_figures, tmp_path, probe):
    grid = pieces.hexahedra(8)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 3, axis=1))
    told = same_figures(3, case, '--probe', probe)
    assert all(sheet['components'] == 1 for sheet in told['sheets'])


def test_a_plane_in_a_seam(same_figures, tmp_path):
    # The middle of the box is where two pieces meet: the faces there are shown once.
    grid = pieces.hexahedra(6, twist=0.0)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 2))
    for normal in ('x', '-x'):
        told = same_figures(2, case, '--normal', *(('-1', '0', '0') if normal == '-x' else ('x',)))
        assert told['sheets'][0]['area'] == pytest.approx(4.0)
        assert told['sheets'][0]['polygons'] == 36


def test_a_plane_in_the_boundary(same_figures, tmp_path):
    grid = pieces.hexahedra(6, twist=0.0)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 3))
    for z, key in ((-1, 'boundary_area'), (1, 'area')):
        sheet = same_figures(3, case, '--normal', 'z', '--origin', 0, 0, z, '--vector-array', 'v')['sheets'][0]
        assert sheet[key] == pytest.approx(4.0)
        assert (sheet['boundary_mean'] is None) == (key == 'area')


def test_scattered_cells(same_figures, tmp_path):
    # Nearly every face is a seam.
    grid = pieces.tetrahedra(4)
    order = np.random.default_rng(1).permutation(grid.GetNumberOfCells())
    case = pieces.write_pvtu(tmp_path, grid, np.array_split(order, 5))
    told = same_figures(4, case, *OBLIQUE)
    assert told['sheets'][0]['components'] == 1


def test_windows(same_figures, tmp_path):
    grid = pieces.hexahedra(8)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 4))
    same_figures(4, case, *OBLIQUE, '--window', 0.9, 0.7)


@pytest.mark.parametrize('kind', ['image', 'rectilinear'])
def test_pieces_of_lattices(same_figures, tmp_path, kind):
    case = pieces.write_lattice(tmp_path, kind, 12, (2, 2, 1))
    told = same_figures(3, case, *OBLIQUE)
    assert told['grid']['kind'] == kind
    same_figures(4, case, '--probe', 'trihedral')


def test_structured_blocks(same_figures, tmp_path):
    case = pieces.write_blocks(tmp_path, pieces.warped(10), (2, 1, 2))
    told = same_figures(4, case, *OBLIQUE)
    assert told['grid']['blocks'] == 4
    assert told['sheets'][0]['components'] == 1


def test_several_inputs(same_figures, tmp_path):
    grid = pieces.hexahedra(6)
    pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 3))
    same_figures(2, *(tmp_path / f'piece{i}.vtu' for i in range(3)), *OBLIQUE)


def test_cell_arrays_and_vectors(same_figures, tmp_path):
    grid = pieces.tetrahedra(5)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 3))
    same_figures(3, case, *OBLIQUE, '--array', 'cell:c')
    told = same_figures(3, case, *OBLIQUE, '--array', 'v', '--component', 'x')
    assert told['sheets'][0]['flux'] is not None


def test_ghost_cells(same_figures, tmp_path):
    # Each piece has the neighbors' cells along its border, marked as duplicates.
    grid = pieces.hexahedra(6)
    slabs = pieces.slabs(grid, 2)
    marks = pieces.vtk.vtkUnsignedCharArray()
    marks.SetName('vtkGhostType')
    marks.SetNumberOfValues(grid.GetNumberOfCells())
    marks.Fill(0)
    grid.GetCellData().AddArray(marks)  # so that the index names it
    case = pieces.write_pvtu(tmp_path, grid, slabs)
    shared = pieces.slabs(grid, 6)
    for number, ghosts in ((0, shared[3]), (1, shared[2])):
        piece = pieces.part_of(grid, np.concatenate([slabs[number], ghosts]))
        for ghost in np.flatnonzero(~np.isin(np.sort(np.concatenate([slabs[number], ghosts])), slabs[number])):
            piece.GetCellData().GetArray('vtkGhostType').SetValue(int(ghost), 1)  # a duplicate
        pieces.write(pieces.vtk.vtkXMLUnstructuredGridWriter(), piece, tmp_path / f'piece{number}.vtu')
    whole = same_figures(2, case, *OBLIQUE)
    alone = same_figures(1, pieces.write_pvtu(tmp_path, grid, [range(grid.GetNumberOfCells())]), *OBLIQUE)
    assert whole['sheets'][0]['area'] == pytest.approx(alone['sheets'][0]['area'])
    assert whole['sheets'][0]['cut_cells'] == alone['sheets'][0]['cut_cells']


def test_a_slice_that_misses_the_grid(programs, same_figures, tmp_path):
    grid = pieces.tetrahedra(3)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 2))
    done = programs.mpi(2, 'slice', case, '--normal', 'x', '--origin', 5, 0, 0)
    assert 'the slice is empty' in done.stderr
    # Of two ranks one has nothing to cut.
    same_figures(2, case, '--normal', 'x', '--origin', 0.5, 0, 0)


def test_the_table_is_printed_once(programs, tmp_path):
    grid = pieces.tetrahedra(4)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 4))
    plain = programs.plain('slice', case, *OBLIQUE).stdout.splitlines()
    assert programs.mpi(4, 'slice', case, *OBLIQUE).stdout.splitlines()[:2] == plain[:2]


def test_polygons_in_one_file(programs, tmp_path):
    grid = pieces.hexahedra(6)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 3))
    programs.plain('slice', case, *OBLIQUE, '-o', tmp_path / 'plain.csv')
    programs.mpi(3, 'slice', case, *OBLIQUE, '-o', tmp_path / 'mpi.csv')
    programs.mpi(3, 'slice', case, *OBLIQUE, '-o', tmp_path / 'mpi.vtp')

    def corners(path):
        # Without the numbers of polygons, vertices and cells, which count in the pieces.
        head, *rows = [line.split(',') for line in path.read_text().splitlines()]
        kept = [i for i, name in enumerate(head) if name in {'x', 'y', 'z', 's', 'v_x', 'v_y', 'v_z', 'c'}]
        assert len(kept) == 8
        return sorted(tuple(row[i] for i in kept) for row in rows)

    assert corners(tmp_path / 'mpi.csv') == corners(tmp_path / 'plain.csv')
    reader = pieces.vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / 'mpi.vtp'))
    reader.Update()
    figures = json.loads(programs.plain('slice', case, *OBLIQUE, '--stats', '-').stdout)
    assert reader.GetOutput().GetNumberOfCells() == figures['sheets'][0]['polygons']


SHARED = ['multiblock/sqnz/sqnz_s.adf.cgns', 'multiblock/5blocks_struc/5blocks-struc.cgns',
          'multiblock/multi_bin/multi-bin-C.xyz', 'time/mug/mug.e',
          'unstructured/multi_element_o1/simple-cube-multi-element-order1.e',
          'unstructured/disk_out_ref/disk_out_ref.ex2', 'polyhedral/ensight_nfaced/TEST_bin.case',
          'polyhedral/flange/flange.foam', 'formats/cavity_foam/case.foam',
          'amr/HierarchicalBox/HierarchicalBoxDataset.v1.1.vthb', 'amr/chombo3d/chombo3d.vtm']


@pytest.mark.parametrize('name', SHARED)
def test_shared_data_sets(same_figures, shared_data, name):
    same_figures(3, shared_data / name, *OBLIQUE)
