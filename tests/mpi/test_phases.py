"""One rank ends while it reads, cuts, draws or writes: all end soon, and nothing half-written or left running stays."""
import os
import pathlib
import signal
import time

import pytest

import pieces
import processes
from conftest import own_lines

SOON = 10  # seconds


@pytest.fixture(scope='module')
def case(tmp_path_factory):
    folder = tmp_path_factory.mktemp('case')
    grid = pieces.hexahedra(24)
    return pieces.write_pvtu(folder, grid, pieces.slabs(grid, 4))


class Run:
    """Four ranks at work. What it writes goes into a folder of its own."""

    def __init__(self, programs, out, *arguments):
        self.out = out
        self.process = programs.start(4, *arguments)
        self.ranks = processes.ranks_of(self.process, 4)
        self.readers = set()

    def reader(self, rank):
        """The reader of a rank, stopped amid its work."""

        def stopped():
            for reader in processes.readers_of(self.ranks[rank]):
                os.kill(reader, signal.SIGSTOP)
                self.readers.add(reader)
                return reader
            return None

        return processes.wait_for(stopped)

    def wait_until_read(self):
        """Until all ranks have what their readers hand over."""
        processes.wait_for(lambda: processes.readers_of(self.ranks[-1]))  # the parts have been listed
        processes.wait_for(lambda: not any(processes.readers_of(rank) for rank in self.ranks))

    def ends(self):
        """Asserts that all of it ends soon; gives what it said on standard error."""
        began = time.monotonic()
        errors = self.process.communicate(timeout=30)[1]
        assert time.monotonic() - began < SOON
        assert self.process.returncode != 0
        processes.wait_for(lambda: not any(processes.is_running(p) for p in [*self.ranks, *self.readers]), SOON)
        return errors

    def kill(self, rank):
        os.kill(self.ranks[rank], signal.SIGKILL)
        return self.ends()


def left_in(folder):
    return sorted(path.name for path in folder.rglob('*') if path.is_file()) if folder.exists() else []


@pytest.mark.parametrize('victim', [0, 2])
def test_killed_while_reading(programs, case, tmp_path, victim):
    run = Run(programs, tmp_path, 'slice', case, '-o', tmp_path / 'out.vtp', '--stats', tmp_path / 'out.json')
    run.reader(2)
    run.kill(victim)
    assert left_in(tmp_path) == []


def test_the_reader_of_one_rank_is_killed(programs, case, tmp_path):
    for _ in range(10):
        run = Run(programs, tmp_path, 'slice', case, '-o', tmp_path / 'out.vtp')
        os.kill(run.reader(2), signal.SIGKILL)
        run.process.wait(timeout=30)
        if run.process.returncode != 0:  # else it had handed over all before it was stopped
            break
        (tmp_path / 'out.vtp').unlink()
    lines = own_lines(run.ends())
    assert len(lines) == 1 and f'rank 2: {case}: the reader was killed (signal 9)' in lines[0], lines
    assert left_in(tmp_path) == []


@pytest.mark.parametrize('victim', [0, 3])
def test_killed_while_cutting(programs, case, tmp_path, victim):
    # Sheets enough for some seconds, without a picture.
    run = Run(programs, tmp_path, 'slice', case, '--probe', 'stack', '--sheets', 64, '-o', tmp_path / 'out.csv',
              '--stats', tmp_path / 'out.json')
    run.wait_until_read()
    assert left_in(tmp_path) == []  # so nothing is being written yet
    run.kill(victim)
    assert left_in(tmp_path) == []


@pytest.mark.gpu
@pytest.mark.parametrize('victim', [0, 1])
def test_killed_while_drawing(programs, case, tmp_path, victim):
    run = Run(programs, tmp_path, 'sweep', case, '--path', 'rotate', '--frames', 200, '--size', '1280x720', '-o',
              tmp_path / '{frame}.png')
    processes.wait_for(lambda: len(left_in(tmp_path)) > 2)
    time.sleep(0.05)  # a frame of so small a grid is a few milliseconds of cutting, and some tenths of drawing
    run.kill(victim)
    for picture in tmp_path.glob('*.png'):
        assert picture.read_bytes()[-8:-4] == b'IEND'


WRITING = ('--probe', 'stack', '--sheets', 64)


def stopped_while_writing(programs, case, out):
    """A run whose first rank has been stopped amid its writing, which takes it some milliseconds only."""
    for _ in range(10):
        out.write_text('an earlier one')
        run = Run(programs, out.parent, 'slice', case, *WRITING, '-o', out)
        processes.wait_for(lambda: any(path.stat().st_size > 0 for path in out.parent.glob('.vprobe-*')), nap=0.0002)
        os.kill(run.ranks[0], signal.SIGSTOP)
        time.sleep(0.01)  # it may have been amid a call of the system
        if list(out.parent.glob('.vprobe-*')) and out.read_text() == 'an earlier one':
            return run
        os.kill(run.ranks[0], signal.SIGCONT)
        run.process.communicate(timeout=30)
    pytest.fail('it always came to its end first')


@pytest.mark.parametrize('victim', [0, 2])
def test_killed_while_writing(programs, case, tmp_path, victim):
    out = tmp_path / 'out.csv'
    run = stopped_while_writing(programs, case, out)
    run.kill(victim)
    if victim == 0:
        assert out.read_text() == 'an earlier one'
        return
    # mpiexec lets the first rank go on, and asks it to end: it clears up, or has come to its end by then. Where it takes
    # more than a second it is killed, and may leave what it was writing.
    assert [name for name in left_in(tmp_path) if not name.startswith('.vprobe-')] == ['out.csv']
    if out.read_text() != 'an earlier one':
        programs.mpi(4, 'slice', case, *WRITING, '-o', tmp_path / 'whole.csv')
        assert out.read_bytes() == (tmp_path / 'whole.csv').read_bytes()


def test_killed_while_it_writes_into_a_pipe(programs, case, tmp_path):
    out = tmp_path / 'out.csv'
    os.mkfifo(out)
    run = Run(programs, tmp_path, 'slice', case, *WRITING, '-o', out)
    with out.open('rb') as pipe:
        assert pipe.read(1)  # and no more: the first rank waits for its reader now
        run.kill(3)


@pytest.mark.parametrize('place, why', [('/dev/full', 'No space left on device; make room'),
                                        ('/sys/out.vtp', 'cannot be written')])
def test_places_without_room_or_right(programs, case, place, why):
    began = time.monotonic()
    done = programs.run(4, 'slice', case, '-o', place)
    assert time.monotonic() - began < SOON
    lines = own_lines(done.stderr)
    assert done.returncode != 0 and len(lines) == 1
    assert f'rank 0: {place}: ' in lines[0] and why in lines[0]


@pytest.mark.parametrize('fault, why', [('VK_DRIVER_FILES=/nonexistent', 'Vulkan'),
                                        ('VPROBE_LAYER_FAULT=lost:5', 'device lost')])
@pytest.mark.gpu
def test_a_rank_whose_device_fails(programs, case, tmp_path, fault, why):
    # Only one of the ranks has it.
    environment = [fault, 'VK_ICD_FILENAMES=/nonexistent'] if fault.startswith('VK_') else [fault]
    if fault.startswith('VPROBE_LAYER'):
        layer = pathlib.Path(programs.program).parents[1] / 'tests' / 'devices' / 'layer'
        if not (layer / 'libvprobe_test_layer.so').exists():
            pytest.skip('needs vprobe_test_layer')
        environment += [f'VK_LAYER_PATH={layer}', 'VK_INSTANCE_LAYERS=VK_LAYER_VPROBE_test']
    draw = [programs.mpi_program, 'render', case, '--size', '320x240', '-o', tmp_path / 'out.png']
    process = programs.start_each([(2, draw), (1, ['env', *environment, *draw]), (1, draw)])
    began = time.monotonic()
    errors = process.communicate(timeout=30)[1]
    assert time.monotonic() - began < 2 * SOON  # from its start
    lines = own_lines(errors)
    assert process.returncode != 0 and len(lines) == 1, errors
    assert 'rank 2: ' in lines[0] and why in lines[0]
    assert left_in(tmp_path) == []
