"""Contours that go on from one process into another: figures, pictures and files as of one."""
import json
import os

import numpy as np
import pytest

import pieces
from conftest import own_lines, without_dependent
from pieces import vtk, vtk_to_numpy
from test_exports import opened

SMALL = ('--size', '160x120')
LONG = bool(os.environ.get('VPROBE_LONG'))
OBLIQUE = ('--normal', 0.3, 0.5, 0.8)
KINDS = ['tetrahedra', 'hexahedra', 'image', 'rectilinear', 'blocks']


def whole_numbers(points):
    """Noise whose contours touch themselves at grid points, and values that are none."""
    noise = np.abs(np.sin(points @ [127.1, 311.7, 74.7]) * 43758.5453) % 1
    scalar = np.floor(6 * noise) + np.round(2 * np.sin(2 * points[:, 0] + points[:, 1]))
    return scalar, np.zeros_like(points)


def bent_tube(points):
    """How far a place is from a line that bends from left to right and back, and from a ball beside it."""
    x, y, z = points.T
    tube = np.hypot(x + 0.5 - np.cos(np.pi / 1.8 * z), y)
    ball = np.sqrt(x * x + (y - 0.75) ** 2 + (z - 0.3) ** 2)
    return np.minimum(tube, ball), np.zeros_like(points)


@pytest.fixture
def tube(tmp_path, monkeypatch):
    """The line begins in the left half, passes through the right one, and ends in the left one."""
    monkeypatch.setattr(pieces, 'values_at', bent_tube)
    grid = pieces.hexahedra(14, 0.0)
    folder = tmp_path / 'tube'
    folder.mkdir()
    return pieces.write_pvtu(folder, grid, pieces.slabs(grid, 2))


TUBE = ('--origin', 0, 0, -0.8, '--contour', 0.25, '--contour-depth', 4)


@pytest.mark.parametrize('kind', KINDS if LONG else KINDS[::2])
def test_figures(same_figures, cases, kind):
    told = same_figures(3, cases[kind], *OBLIQUE, '--contour', 0.3, 0.6)
    assert all(contour['polygons'] > 0 for contour in told['contours'])


@pytest.mark.parametrize('ranks', [1, 2, 4])
def test_figures_of_any_number_of_ranks(same_figures, cases, ranks):
    told = same_figures(ranks, cases['tetrahedra'], '--probe', 'trihedral', '--contour', 0.3, '--contour-at', 0.4, 0.6)
    assert [contour['sheet'] for contour in told['contours']] == [0, 0, 1, 2]


def test_a_contour_that_comes_back(programs, same_figures, tube, tmp_path):
    # The ball crosses the border, and is no part of the contour.
    assert same_figures(2, tube, *TUBE)['contours'][0]['components'] == 1
    programs.mpi(2, 'slice', tube, *TUBE, '-o', tmp_path / 'out.vtp')
    whole = opened(tmp_path / 'out.vtp')
    x, _, z = vtk_to_numpy(whole.GetPoints().GetData()).T
    assert np.any((x > 0.3) & (abs(z) < 0.2)) and np.any((x < -0.3) & (z > 0.7))


@pytest.mark.parametrize('ranks', [2, 4] if LONG else [4])
def test_a_sheet_in_one_rank_alone(same_figures, cases, ranks):
    told = same_figures(ranks, cases['tetrahedra'], '--normal', 1, 0, 0, '--origin', -0.7, 0, 0, '--contour', 0.3,
                        '--contour-depth', 2.4)
    with_cells = [rank for rank in told['ranks'] if rank['sheets'][0]['cut_cells'] > 0]
    assert len(with_cells) == 1 and told['contours'][0]['polygons'] > 0


def test_pieces_that_touch_in_a_point(same_figures, tmp_path, monkeypatch):
    monkeypatch.setattr(pieces, 'values_at', whole_numbers)
    case = pieces.write_lattice(tmp_path, 'image', 12, (2, 2, 2))
    told = same_figures(4, case, '--normal', -0.378, 2.043, 0.647, '--window', 0.4, 0.2, '--contour', 2, 2.64,
                        '--contour-depth', 0.3)
    assert told['contours'][0]['components'] == 4


@pytest.mark.parametrize('kind', ['tetrahedra', 'blocks'] if LONG else ['blocks'])
def test_values_that_are_none(same_figures, tmp_path, monkeypatch, kind):
    def with_holes(points):
        scalar, vector = whole_numbers(points)
        scalar[np.abs(np.sin(points @ [17.1, 31.7, 4.7]) * 4375.5453) % 1 < 0.03] = np.nan
        return scalar, vector

    monkeypatch.setattr(pieces, 'values_at', with_holes)
    grid = pieces.tetrahedra(6) if kind == 'tetrahedra' else pieces.warped(9)
    case = (pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 4)) if kind == 'tetrahedra'
            else pieces.write_blocks(tmp_path, grid, (2, 2, 1)))
    same_figures(4, case, '--normal', 0.774, 0.281, -0.554, '--contour', 3, 0.75)


def test_the_value_at_a_place_on_a_border(same_figures, cases):
    same_figures(2, cases['hexahedra'], '--window', 0.9, 0.7, '--contour-at', 0.5, 0.5)


def test_a_place_without_a_value(programs, cases):
    asked = ('slice', cases['hexahedra'], '--origin', 0, 0, 0.9, '--window', 5, 5, '--contour-at', 0, 0)
    done = programs.run(3, *asked)
    assert done.returncode == 1
    assert len(own_lines(done.stderr)) == 1 and 'the first sheet has no value there' in own_lines(done.stderr)[0]


def test_a_value_that_no_sheet_has(programs, cases, tmp_path):
    asked = ('slice', cases['hexahedra'], '--window', 0.5, 0.4, '--contour', 9, -9, '-o')
    plain = programs.plain(*asked, tmp_path / 'plain.csv').stderr
    mpi = programs.mpi(3, *asked, tmp_path / 'mpi.csv').stderr
    assert plain.count('is empty: the sheet has s from') == 2
    assert mpi.replace('vprobe-mpi: ', 'vprobe: ') == plain
    assert (tmp_path / 'mpi.csv').read_text().count('contour') == 1


def test_cells_of_different_sizes_between_ranks(programs, tmp_path):
    # The sheet lies within the first block, and what grows from it does not.
    for number, (spacing, origin) in enumerate([(0.25, 0.0), (0.5, 1.0)]):
        image = vtk.vtkImageData()
        image.SetDimensions(*[round(1 / spacing) + 1] * 3)
        image.SetSpacing(spacing, spacing, spacing)
        image.SetOrigin(origin, 0.0, 0.0)
        pieces.add_arrays(image, np.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())]))
        pieces.write(vtk.vtkXMLImageDataWriter(), image, tmp_path / f'block{number}.vti')
    asked = ('slice', tmp_path / 'block0.vti', tmp_path / 'block1.vti', '--normal', 1, 0, 0, '--origin', 0.6, 0, 0,
             '--array', 'v', '--component', 'x', '--contour', 0.4, '--contour-depth', 2)
    programs.mpi(1, *asked)
    done = programs.run(2, *asked)
    assert done.returncode != 0
    assert len(own_lines(done.stderr)) == 1 and 'cells of different sizes meet' in own_lines(done.stderr)[0]


def polygons_of(data):
    """The sheet, the contour and the corners of each polygon, in an order that does not depend on the file's."""
    places = vtk_to_numpy(data.GetPoints().GetData())
    starts = vtk_to_numpy(data.GetPolys().GetOffsetsArray())
    ids = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
    sheets, contours = (vtk_to_numpy(data.GetCellData().GetArray(f'vprobe:{name}')) for name in ('sheet', 'contour'))
    return sorted((int(sheets[p]), repr(float(contours[p])), sorted(places[ids[starts[p]:starts[p + 1]]].tolist()))
                  for p in range(len(starts) - 1))


def test_files(programs, cases, tmp_path):
    asked = ('slice', cases['tetrahedra'], '--probe', 'trihedral', '--window', 0.9, 0.7, '--contour', 0.3, 0.1, '-o')
    for name in ('one.vtp', 'one.vtm', 'one.csv'):
        programs.plain(*asked, tmp_path / name)
    for name in ('all.vtp', 'all.vtm', 'all.csv', 'all.pvtp'):
        programs.mpi(2, *asked, tmp_path / name)
    one = opened(tmp_path / 'one.vtp')
    assert len({contour for _, contour, _ in polygons_of(one)}) == 3
    assert polygons_of(opened(tmp_path / 'all.vtp')) == polygons_of(one)
    assert polygons_of(opened(tmp_path / 'all.pvtp')) == polygons_of(one)
    sheets, own = opened(tmp_path / 'one.vtm'), opened(tmp_path / 'all.vtm')
    for sheet in range(3):
        assert polygons_of(own.GetBlock(sheet)) == polygons_of(sheets.GetBlock(sheet))
    assert len((tmp_path / 'all.csv').read_text().splitlines()) == len((tmp_path / 'one.csv').read_text().splitlines())
    # Contours stand behind the sheets.
    contours = vtk_to_numpy(opened(tmp_path / 'all.vtp').GetCellData().GetArray('vprobe:contour'))
    assert np.all(np.diff(np.isnan(contours).astype(int)) <= 0)


def test_parts_of_ranks_that_have_nothing(programs, cases, tmp_path):
    asked = ('slice', cases['tetrahedra'], '--normal', 1, 0, 0, '--origin', 0.9, 0, 0, '--contour', 0.3,
             '--contour-depth', 0.1, '-o')
    programs.plain(*asked, tmp_path / 'one.vtp')
    programs.mpi(3, *asked, tmp_path / 'all.pvtp')
    assert opened(tmp_path / 'all' / 'part_0.vtp').GetNumberOfCells() == 0
    assert polygons_of(opened(tmp_path / 'all.pvtp')) == polygons_of(opened(tmp_path / 'one.vtp'))


@pytest.mark.gpu
def test_sweeps(programs, cases, tmp_path):
    asked = ('sweep', cases['hexahedra'], '--frames', 3, '--normal', 0, 1, 0, '--contour', 0.3, '--size', '64x48', '--stats')
    plain = programs.plain(*asked, tmp_path / 'one.json', '-o', tmp_path / 'one' / '{frame}.png')
    mpi = programs.mpi(3, *asked, tmp_path / 'all.json', '-o', tmp_path / 'all' / '{frame}.png')
    assert mpi.stderr.replace('vprobe-mpi: ', 'vprobe: ') == plain.stderr  # as many frames are empty
    one, own = (json.loads((tmp_path / f'{name}.json').read_text())['frames'] for name in ('one', 'all'))
    assert without_dependent(own) == without_dependent(one)
    assert any(frame['contours'][0]['polygons'] > 0 for frame in own)
    for frame in range(3):
        assert (tmp_path / 'all' / f'{frame}.png').read_bytes() == (tmp_path / 'one' / f'{frame}.png').read_bytes()


@pytest.mark.gpu
@pytest.mark.parametrize('kind', KINDS if LONG else ['tetrahedra'])
def test_translucent_pictures(same_pictures, cases, kind):
    same_pictures([1, 2, 4] if LONG else [3], cases[kind], *OBLIQUE, '--contour', 0.3, 0.6, '--contour-opacity', 0.5,
                  *SMALL)


@pytest.mark.gpu
def test_opaque_pictures(same_pictures, tube):
    same_pictures([2], tube, *TUBE, '--mesh', *SMALL)
