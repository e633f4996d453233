"""The piece of a sheet that its hot spot lies in, over several processes: figures, pictures and polygons as of one."""
import os

import pytest

import pieces
from conftest import own_lines
from test_crinkle import faces_of
from test_exports import opened

LONG = bool(os.environ.get('VPROBE_LONG'))
SMALL = ('--size', '320x240')
ONE = ('--seeds', 'hotspot')
N = 8
# In the lower arm of a U, of which each end lies in the first rank.
IN_ARM = ('--normal', 0.1, 0.2, 0.9, '--origin', -0.9, -0.3, 0.02)
FAR = ('--normal', 0.1, 0.2, 0.9, '--origin', -3, 1, 0.3)


@pytest.fixture(scope='module')
def cases(tmp_path_factory):
    """Data sets in pieces, written once."""

    def folder(name):
        return tmp_path_factory.mktemp(name)

    def kept(parts):
        # Without two walls: one parts an island off, the other leaves a U whose ends are far from each other.
        def stays(cell):
            i, j = cell % N, cell // N % N
            return j != 1 and not (j == 4 and i < 6)
        return [[cell for cell in part if stays(cell)] for part in parts]

    grid = pieces.hexahedra(N)
    return {'u': pieces.write_pvtu(folder('u'), grid, kept(pieces.slabs(grid, 4))),
            'image': pieces.write_lattice(folder('image'), 'image', 12, (2, 2, 1)),
            'blocks': pieces.write_blocks(folder('blocks'), pieces.warped(8), (2, 2, 1))}


@pytest.mark.parametrize('ranks', [1, 2, 4])
def test_a_front_that_comes_back(same_figures, cases, ranks):
    told = same_figures(ranks, cases['u'], *IN_ARM, *ONE)['sheets'][0]
    assert told['hot_spot_inside'] and told['components'] == 1


def test_other_pieces_are_left_out(same_figures, cases):
    told, all_pieces = (same_figures(4, cases['u'], *IN_ARM, *more)['sheets'][0] for more in (ONE, ()))
    assert told['components'] == 1 and all_pieces['components'] == 2
    assert told['polygons'] < all_pieces['polygons']


def test_a_front_that_ends_within_a_rank(same_figures, cases):
    island = ('--normal', 1, 0.1, 0.05, '--origin', -0.9, -0.95, 0)
    told = same_figures(4, cases['u'], *island, *ONE)
    assert [rank['sheets'][0]['cut_cells'] > 0 for rank in told['ranks']] == [True, False, False, False]


SHEETS = [
    ('u', (*IN_ARM, '--window', 0.3, 0.5)), ('u', ('--surface', 'cylinder:0.7')),
    ('u', ('--surface', 'z = y/9', '--threshold', -0.2, 0.8)), ('image', ('--normal', 0.3, 0.5, 0.8)),
    ('blocks', ('--normal', 0, 1, 0, '--window', 0.5, 0.4)), ('u', ('--probe', 'trihedral')),
    ('blocks', ('--surface', 'sphere:0.5')), ('u', ('--surface', 'z = y/9', '--origin', -0.1, -0.3, 0)),
    ('blocks', ('--normal', 0.3, 0.5, 0.8))]


@pytest.mark.parametrize('kind, sheet', SHEETS if LONG else SHEETS[:5], ids=str)
def test_sheets(same_figures, cases, kind, sheet):
    assert same_figures(4, cases[kind], *sheet, *ONE)['sheets'][0]['polygons'] > 0


@pytest.mark.parametrize('more', [ONE, (*ONE, '--outside', 'report'), ('--outside', 'report')], ids=str)
def test_a_hot_spot_outside(programs, cases, tmp_path, more):
    plain = programs.plain('slice', cases['u'], *FAR, *more, '-o', tmp_path / 'plain.vtp')
    mpi = programs.mpi(4, 'slice', cases['u'], *FAR, *more, '-o', tmp_path / 'mpi.vtp')
    told = [run.stderr.replace('vprobe-mpi: ', 'vprobe: ') for run in (plain, mpi)]
    assert 'the hot spot lies outside the grid' in told[0] and told[1] == told[0]
    assert faces_of(opened(tmp_path / 'mpi.vtp')) == faces_of(opened(tmp_path / 'plain.vtp'))


def test_a_hot_spot_outside_is_refused_by_all(programs, cases):
    done = programs.run(4, 'slice', cases['u'], *FAR, '--outside', 'refuse')
    assert done.returncode != 0
    assert len(own_lines(done.stderr)) == 1 and 'the hot spot lies outside the grid' in done.stderr
    programs.mpi(4, 'slice', cases['u'], *IN_ARM, '--outside', 'refuse')


def test_exports(programs, cases, tmp_path):
    asked = (cases['u'], *IN_ARM, *ONE, '--array', 's')
    programs.plain('slice', *asked, '-o', tmp_path / 'plain.vtp')
    programs.mpi(4, 'slice', *asked, '-o', tmp_path / 'mpi.vtp')
    assert faces_of(opened(tmp_path / 'mpi.vtp')) == faces_of(opened(tmp_path / 'plain.vtp'))


@pytest.mark.gpu
def test_pictures(same_pictures, cases):
    same_pictures([4], cases['u'], *IN_ARM, *ONE, *SMALL)


def test_whole_cells(same_figures, cases):
    same_figures(4, cases['u'], *IN_ARM, *ONE, '--crinkle')
