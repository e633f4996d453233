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
