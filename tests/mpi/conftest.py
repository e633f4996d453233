"""What the tests of vprobe-mpi share: runs of both programs, and data sets in pieces."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile

import pytest

# What docs/CLUSTER.md lists as dependent on how blocks were dealt out; and times, and what only one program tells.
DEPENDENT = {'ms', 'ranks', 'plan', 'device', 'seeds', 'hops', 'boundary_tests', 'tree_tests', 'hot_spot_inside',
             'generations', 'front_max', 'cells_touched', 'cells_scanned'}


def pytest_collection_modifyitems(config, items):
    """Of a test with many cases the first and the last one run, unless VPROBE_LONG asks for all. Errors are quick: all."""
    if os.environ.get('VPROBE_LONG'):
        return
    of_test = {}
    for item in items:
        of_test.setdefault((item.path, item.originalname), []).append(item)
    kept = [item for of_one in of_test.values() for item in of_one
            if item in (of_one[0], of_one[-1]) or item.path.name == 'test_failing.py']
    config.hook.pytest_deselected(items=[item for item in items if item not in kept])
    items[:] = [item for item in items if item in kept]


class Programs:
    """vprobe, and vprobe-mpi under mpiexec."""

    def __init__(self):
        self.program = os.environ.get('VPROBE_PROGRAM')
        self.mpi_program = os.environ.get('VPROBE_MPI_PROGRAM')
        self.mpiexec = os.environ.get('VPROBE_MPIEXEC') or shutil.which('mpiexec')
        if not (self.program and self.mpi_program and self.mpiexec and shutil.which(self.mpiexec)):
            pytest.skip('needs vprobe, vprobe-mpi and mpiexec (openmpi-bin)')
        # mpiexec, too, would look at the displays of other tests, and end with them.
        self.environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT='1', OMPI_ALLOW_RUN_AS_ROOT_CONFIRM='1',
                                HWLOC_COMPONENTS='-gl',
                                # The folder of all runs of a user is made by the first and removed by the last, and a
                                # run that comes between fails. Names of sockets below it may not be long.
                                OMPI_MCA_orte_tmpdir_base=tempfile.mkdtemp(prefix='vprobe-mpi-', dir='/tmp'),
                                # A process that waits leaves its core to the others.
                                OMPI_MCA_mpi_yield_when_idle='1')

    def plain(self, *arguments):
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, encoding='utf-8', timeout=120)
        assert done.returncode == 0, done.stderr
        return done

    def start(self, ranks, *arguments):
        return self.start_each([(ranks, [self.mpi_program, *arguments])])

    def start_each(self, groups):
        """Ranks with commands of their own: (ranks, command) each."""
        command = [self.mpiexec, '--oversubscribe']
        for number, (ranks, words) in enumerate(groups):
            command += [':'] * (number > 0) + ['-n', str(ranks), *map(str, words)]
        return subprocess.Popen(command, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding='utf-8')

    def run(self, ranks, *arguments):
        process = self.start(ranks, *arguments)
        out, errors = process.communicate(timeout=120)
        return subprocess.CompletedProcess(arguments, process.returncode, out, errors)

    def mpi(self, ranks, *arguments):
        done = self.run(ranks, *arguments)
        assert done.returncode == 0, done.stderr
        return done


def own_lines(errors):
    """The lines of the program itself, without mpiexec's."""
    return [line for line in errors.splitlines() if line.startswith('vprobe-mpi: ')]


def without_dependent(document):
    if isinstance(document, dict):
        return {key: without_dependent(value) for key, value in document.items() if key not in DEPENDENT}
    if isinstance(document, list):
        return [without_dependent(value) for value in document]
    return document


@pytest.fixture(scope='session')
def programs():
    made = Programs()
    yield made
    shutil.rmtree(made.environment['OMPI_MCA_orte_tmpdir_base'], ignore_errors=True)


@pytest.fixture(scope='session')
def cases(tmp_path_factory):
    """Data sets in pieces, by kind. Written once."""
    import pieces  # which is skipped where VTK is not

    tetrahedra, hexahedra = pieces.tetrahedra(8), pieces.hexahedra(10)
    folder = tmp_path_factory.mktemp
    return {'tetrahedra': pieces.write_pvtu(folder('tetrahedra'), tetrahedra, pieces.slabs(tetrahedra, 4)),
            'hexahedra': pieces.write_pvtu(folder('hexahedra'), hexahedra, pieces.slabs(hexahedra, 4, axis=1)),
            'image': pieces.write_lattice(folder('image'), 'image', 12, (2, 2, 1)),
            'rectilinear': pieces.write_lattice(folder('rectilinear'), 'rectilinear', 12, (1, 2, 2)),
            'blocks': pieces.write_blocks(folder('blocks'), pieces.warped(10), (2, 2, 1))}


@pytest.fixture
def same_figures(programs, tmp_path):
    """Asserts that both programs tell the same figures, to the last digit. Gives the document of vprobe-mpi."""

    def compare(ranks, *arguments):
        programs.plain('slice', *arguments, '--stats', tmp_path / 'plain.json')
        programs.mpi(ranks, 'slice', *arguments, '--stats', tmp_path / 'mpi.json')
        plain = json.loads((tmp_path / 'plain.json').read_text())
        mpi = json.loads((tmp_path / 'mpi.json').read_text())
        assert without_dependent(mpi) == without_dependent(plain)
        assert len(mpi['ranks']) == ranks
        return mpi

    return compare


@pytest.fixture
def same_pictures(programs, tmp_path):
    """Asserts that both programs draw the same picture, byte by byte."""

    def compare(rank_counts, *arguments):
        programs.plain('render', *arguments, '-o', tmp_path / 'plain.png')
        for ranks in rank_counts:
            programs.mpi(ranks, 'render', *arguments, '-o', tmp_path / f'{ranks}.png')
            assert (tmp_path / f'{ranks}.png').read_bytes() == (tmp_path / 'plain.png').read_bytes(), ranks

    return compare


@pytest.fixture(scope='session')
def shared_data():
    """The folder of data sets that VPROBE_DATA names."""
    folder = os.environ.get('VPROBE_DATA')
    if not folder or not pathlib.Path(folder).is_dir():
        pytest.skip('VPROBE_DATA names no folder of data sets')
    return pathlib.Path(folder)
