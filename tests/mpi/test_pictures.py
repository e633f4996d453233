"""Pictures of several processes are those of one, byte by byte."""
import json

import pytest

import pieces
from conftest import without_dependent

pytestmark = pytest.mark.gpu
SMALL = ('--size', '320x240')


@pytest.mark.parametrize('probe', ['single', 'trihedral', 'paddlewheel', 'stack'])
def test_probes(same_pictures, tmp_path, probe):
    grid = pieces.tetrahedra(8)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 4))
    same_pictures([1, 4], case, '--probe', probe, '--opacity', 0.6, *SMALL)


def test_pieces_of_an_image(same_pictures, tmp_path):
    case = pieces.write_lattice(tmp_path, 'image', 12, (2, 2, 1))
    same_pictures([3], case, '--probe', 'trihedral', *SMALL)


def test_pieces_of_a_rectilinear_grid(same_pictures, tmp_path):
    case = pieces.write_lattice(tmp_path, 'rectilinear', 12, (1, 2, 2))
    same_pictures([2], case, '--normal', 0.3, 0.5, 0.8, '--window', 0.4, 0.4, *SMALL)


def test_structured_blocks(same_pictures, tmp_path):
    case = pieces.write_blocks(tmp_path, pieces.warped(10), (2, 2, 1))
    same_pictures([4], case, '--probe', 'trihedral', '--opacity', 0.5, *SMALL)


@pytest.mark.parametrize('look', [('--mesh',), ('--lines', 8, '--no-labels'), ('--bands', 5), ('--range-of', 'slice'),
                                  ('--samples', 1), ('--array', 'cell:c'), ('--log', '--array', 'cell:c'),
                                  ('--camera', 'sheet')])
def test_looks(same_pictures, tmp_path, look):
    grid = pieces.hexahedra(6)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 3))
    same_pictures([3], case, '--normal', 0.3, 0.5, 0.8, *look, *SMALL)


def test_sheets_that_only_some_ranks_cut(same_pictures, tmp_path):
    # The first rank, which colors the picture, has nothing to draw.
    grid = pieces.tetrahedra(5)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 2))
    same_pictures([2, 5], case, '--normal', 'x', '--origin', 0.5, 0, 0, *SMALL)


def test_sweeps(programs, tmp_path):
    grid = pieces.tetrahedra(6)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 3))
    sweep = ('sweep', case, '--path', 'rotate', '--frames', 3, *SMALL)
    programs.plain(*sweep, '-o', tmp_path / 'plain{frame}.png')
    programs.mpi(3, *sweep, '-o', tmp_path / 'mpi{frame}.png')
    for frame in range(3):
        assert (tmp_path / f'mpi{frame}.png').read_bytes() == (tmp_path / f'plain{frame}.png').read_bytes(), frame


@pytest.mark.parametrize('of_neighbors', [(), ('--crinkle',)])
def test_sweeps_over_times(programs, tmp_path, of_neighbors):
    # The grid changes, and the number of its pieces.
    times = ''
    for number, grid in enumerate([pieces.tetrahedra(4), pieces.tetrahedra(4), pieces.hexahedra(5)]):
        folder = tmp_path / f'time{number}'
        folder.mkdir()
        case = pieces.write_pvtu(folder, grid, pieces.slabs(grid, 2 + number))
        times += f'<DataSet timestep="{number / 2}" file="{case.relative_to(tmp_path)}"/>'
    case = tmp_path / 'case.pvd'
    case.write_text(f'<VTKFile type="Collection" version="0.1"><Collection>{times}</Collection></VTKFile>')
    sweep = ('sweep', case, '--path', 'times', '--probe', 'trihedral', '--range', -1, 2, *of_neighbors, *SMALL)
    programs.plain(*sweep, '-o', tmp_path / 'plain{frame}.png', '--stats', tmp_path / 'plain.json')
    programs.mpi(3, *sweep, '-o', tmp_path / 'mpi{frame}.png', '--stats', tmp_path / 'mpi.json')
    plain, mpi = (without_dependent(json.loads((tmp_path / f'{name}.json').read_text())) for name in ('plain', 'mpi'))
    assert mpi['frames'] == plain['frames'] and len(mpi['frames']) == 3
    for frame in range(3):
        assert (tmp_path / f'mpi{frame}.png').read_bytes() == (tmp_path / f'plain{frame}.png').read_bytes(), frame


def test_exposures(programs, tmp_path):
    grid = pieces.tetrahedra(5)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 2))
    for name, run in (('plain', programs.plain), ('mpi', lambda *words: programs.mpi(2, *words))):
        run('sweep', case, '--path', 'rotate', '--frames', 4, *SMALL, '--exposure', tmp_path / f'{name}.png')
    assert (tmp_path / 'mpi.png').read_bytes() == (tmp_path / 'plain.png').read_bytes()


def test_a_sweep_goes_on_where_it_ended(programs, tmp_path):
    grid = pieces.tetrahedra(5)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 2))
    sweep = ('sweep', case, '--path', 'rotate', '--frames', 4, *SMALL)
    for name, run in (('plain', programs.plain), ('mpi', lambda *words: programs.mpi(2, *words))):
        for frame in (0, 2):
            (tmp_path / f'{name}{frame}.png').write_text('is there')
        run(*sweep, '--resume', '-o', tmp_path / f'{name}{{frame}}.png', '--stats', tmp_path / f'{name}.json')
        told = json.loads((tmp_path / f'{name}.json').read_text())
        assert [frame['frame'] for frame in told['frames']] == [1, 3]
    for frame in range(4):
        drawn = (tmp_path / f'mpi{frame}.png').read_bytes()
        assert drawn == (tmp_path / f'plain{frame}.png').read_bytes() and (drawn == b'is there') == (frame in (0, 2))


def test_only_touched_pixels_travel(programs, tmp_path):
    grid = pieces.hexahedra(12)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 4))
    programs.mpi(4, 'render', case, '--probe', 'paddlewheel', '--vanes', 8, '--samples', 1, '--size', '640x360', '-o',
                 tmp_path / 'wheel.png', '--stats', tmp_path / 'stats.json')
    told = json.loads((tmp_path / 'stats.json').read_text())
    sent = sum(rank['layer_bytes'] for rank in told['ranks'])
    full = 4 * 8 * 640 * 360  # a float for each pixel of each layer
    assert 0 < sent <= full * 3 // 4  # three ranks send layers; a quarter of each at most


SHARED = ['multiblock/sqnz/sqnz_s.adf.cgns', 'multiblock/multi_bin/multi-bin-C.xyz', 'time/mug/mug.e',
          'unstructured/multi_element_o1/simple-cube-multi-element-order1.e',
          'unstructured/disk_out_ref/disk_out_ref.ex2', 'polyhedral/ensight_nfaced/TEST_bin.case',
          'polyhedral/flange/flange.foam', 'formats/cavity_foam/case.foam']


@pytest.mark.parametrize('name', SHARED)
def test_shared_data_sets(same_pictures, shared_data, name):
    same_pictures([3], shared_data / name, '--probe', 'trihedral', '--opacity', 0.6, *SMALL)
