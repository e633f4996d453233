"""What runs under mpiexec, as /proc tells it: ranks, their readers."""
import os
import pathlib
import time

PROGRAM = 'vprobe-mpi'


def stat_of(folder):
    """The name, and the fields of `stat` behind it; none where the process has gone."""
    try:
        name, fields = (folder / 'stat').read_text().split('(', 1)[1].rsplit(')', 1)
    except (OSError, IndexError):
        return None, []
    return name, fields.split()


def children_of(parent, name):
    """The processes of this name that a process has started, by number; those that have ended left out."""
    found = []
    for entry in pathlib.Path('/proc').iterdir():
        if entry.name.isdigit():
            its_name, fields = stat_of(entry)
            if its_name and its_name.startswith(name) and int(fields[1]) == parent and fields[0] not in 'ZX':
                found.append(int(entry.name))
    return sorted(found)


def is_running(process):
    return stat_of(pathlib.Path(f'/proc/{process}'))[1][:1] not in ([], ['Z'], ['X'])


def rank_of(process):
    """mpiexec numbers its processes in their environment."""
    try:
        held = pathlib.Path(f'/proc/{process}/environ').read_bytes().split(b'\0')
    except OSError:
        return None
    return next((int(entry.split(b'=')[1]) for entry in held if entry.startswith(b'OMPI_COMM_WORLD_RANK=')), None)


def wait_for(what, seconds=60, nap=0.002):
    """Asks until there is an answer."""
    end = time.monotonic() + seconds
    while not (answer := what()):
        assert time.monotonic() < end, 'waited in vain'
        time.sleep(nap)
    return answer


def ranks_of(mpiexec, count):
    """The processes of all ranks, in their order, as soon as they are there."""
    started = wait_for(lambda: (found := children_of(mpiexec.pid, PROGRAM)) and len(found) == count and found)
    of_rank = wait_for(lambda: (all_of := {rank_of(p): p for p in started}) and None not in all_of and all_of)
    return [of_rank[rank] for rank in range(count)]


def readers_of(rank):
    return children_of(rank, 'vprobe-read')
