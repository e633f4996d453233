"""Sheets that meet a border between ranks in a line or a point alone."""
import pytest

import pieces


@pytest.fixture(scope='module')
def straight(tmp_path_factory):
    grid = pieces.hexahedra(8, 0.0)
    return pieces.write_pvtu(tmp_path_factory.mktemp('straight'), grid, pieces.slabs(grid, 4))


@pytest.mark.parametrize('sheet', [('--normal', 1, 0, -1), ('--normal', -1, 0, 1), ('--surface', 'z=x')],
                         ids=lambda sheet: ' '.join(map(str, sheet)))
def test_cells_on_both_sides_share_a_line_alone(same_figures, straight, sheet):
    # To the left of the border the cells below the line are cut, to its right those above.
    told = same_figures(2, straight, *sheet)
    assert told['sheets'][0]['components'] == 1
    assert told['sheets'][0]['vertices'] == 81


def test_vertices_near_a_grid_point_stay_apart(same_figures, tmp_path):
    # The cylinder runs a rounding beside grid points, where it cuts several edges.
    case = pieces.write_blocks(tmp_path, pieces.warped(10), (2, 2, 1))
    same_figures(3, case, '--surface', 'cylinder:0.4')


def test_each_piece_keeps_values_that_jump(same_figures, tmp_path):
    # In four slabs of equal width the array is 0, 1, 2 and 3: no point between two of them is both.
    grid = pieces.hexahedra(8, 0.0)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 4))
    for number in range(4):
        path = tmp_path / f'piece{number}.vtu'
        reader = pieces.vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        pieces.vtk_to_numpy(reader.GetOutput().GetPointData().GetArray('s'))[:] = number
        pieces.write(pieces.vtk.vtkXMLUnstructuredGridWriter(), reader.GetOutput(), path)
    sheet = same_figures(2, case, '--array', 's', '--normal', 0.1, 0, 1)['sheets'][0]
    assert sheet['mean'] == pytest.approx(1.5, abs=1e-12)
    assert (sheet['min'], sheet['max'], sheet['components']) == (0, 3, 1)
    assert sheet['vertices'] == 4 * 27
