"""A profile of several processes."""
import json

import pytest

import pieces

COUNTED = ('cut_cells_mean', 'polygons_mean', 'vertices_mean', 'empty_planes', 'planes', 'sheets', 'path', 'grid')


@pytest.fixture
def case(tmp_path):
    grid = pieces.hexahedra(8)
    return pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 4))


@pytest.mark.parametrize('ranks', [1, 2, 3])
def test_work_is_that_of_one_process(programs, case, tmp_path, ranks):
    measure = ('profile', case, '--planes', 6, '--no-floor', '--json')
    programs.plain(*measure, tmp_path / 'plain.json')
    programs.mpi(ranks, *measure, tmp_path / 'mpi.json')
    plain = json.loads((tmp_path / 'plain.json').read_text())
    mpi = json.loads((tmp_path / 'mpi.json').read_text())
    assert {key: mpi[key] for key in COUNTED} == {key: plain[key] for key in COUNTED}
    assert set(mpi) == set(plain) | {'ranks'}
    told = mpi['ranks']
    assert len(told) == ranks
    assert sum(rank['cells'] for rank in told) == mpi['grid']['cells']
    # The slowest of each plane counts.
    assert mpi['cut_ms']['median'] >= max(rank['cut_ms']['median'] for rank in told)
    assert mpi['cut_ms']['first'] == max(rank['cut_ms']['first'] for rank in told)
    for key in ('grid', 'peak_rss'):
        assert mpi['memory_bytes'][key] == sum(rank['memory_bytes'][key] for rank in told)


def test_the_table_is_printed_once(programs, case):
    out = programs.mpi(3, 'profile', case, '--planes', 3).stdout
    assert out.count('ms a plane') == 1


@pytest.mark.gpu
def test_whole_frames_and_a_trace(programs, case, tmp_path):
    programs.mpi(2, 'profile', case, '--planes', 2, '--draw', '--size', '160x120', '--json', tmp_path / 'p.json',
                 '--trace', tmp_path / 'trace.json')
    told = json.loads((tmp_path / 'p.json').read_text())
    assert told['frame_ms']['first'] >= told['cut_ms']['first']
    assert any(rank['layer_bytes'] > 0 for rank in told['ranks'])
    assert json.loads((tmp_path / 'trace.json').read_text())
