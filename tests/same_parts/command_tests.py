"""The command lines of tests/cli: its programs run with both.py in place of vprobe."""
import concurrent.futures
import pathlib
import pickle
import re
import shlex
import shutil
import socket
import subprocess
import tempfile
import threading

from . import folders
from .compare import differences
from .run import cleaned

BOTH = pathlib.Path(__file__).with_name('both.py')
PROGRAMS = ('cli_cpu', 'cli_gpu')
SHARDS = 8  # of each program: enough for all cores to end at about the same time
SECONDS_TO_LIVE = 1200
FOLDER_OF_TEST = re.compile(r'vprobe-cli-\w+/')  # new in each run


class Listener:
    """The other side of both.py: keeps the files of one part of the tests, and compares."""

    def __init__(self, builds, scratch):
        self.builds = builds
        self.files = scratch / 'files'
        self.kept = scratch / 'kept'
        self.commands = 0
        self.found = []
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.bind(str(scratch / 'socket'))
        self.socket.listen()
        self.thread = threading.Thread(target=self.listen)
        self.thread.start()

    def close(self):
        self.socket.shutdown(socket.SHUT_RDWR)
        self.thread.join()
        self.socket.close()

    def listen(self):
        while True:
            try:
                connection, _ = self.socket.accept()
            except OSError:  # closed
                return
            with connection, connection.makefile('rwb') as line:
                try:
                    self.serve(line)
                except (EOFError, OSError):  # the program was interrupted
                    pass

    def serve(self, line):
        def hear():
            return pickle.load(line)

        def answer():
            pickle.dump(None, line)
            line.flush()
        words, streams = hear()
        spared = {pathlib.Path(name) for name in streams}
        with tempfile.TemporaryDirectory(dir=self.kept.parent) as kept:
            start, end = pathlib.Path(kept, 'start'), pathlib.Path(kept, 'end')
            folders.copy(self.files, start)
            marks = folders.marks(self.files)
            answer()
            new = self.outcome(hear(), marks, spared)
            folders.copy(self.files, end)
            folders.restore(self.files, start, spared)
            marks = folders.marks(self.files)
            answer()
            old = self.outcome(hear(), marks, spared)
            folders.restore(self.files, end, spared)
        command = FOLDER_OF_TEST.sub('', shlex.join(['vprobe', *words]).replace(f'{self.files}/', ''))
        self.commands += 1
        self.found += differences('cli', [(command, old)], [(command, new)])
        answer()

    def outcome(self, ended, marks, spared):
        code, out, err = ended
        items = {'exit code': str(code).encode(), 'standard error': cleaned('', err or b'', self.builds),
                 'standard output': cleaned('', out or b'', self.builds)}
        for name, data in folders.changed(self.files, marks).items():
            if self.files / name not in spared:
                items[FOLDER_OF_TEST.sub('', name)] = cleaned(name, data, self.builds)
        return items


def run_part(program, shard, builds, scratch, environment):
    """(number of commands, differences, what went wrong with the test itself)."""
    folder = scratch / f'{program.name}-{shard}'
    (folder / 'files').mkdir(parents=True)
    listener = Listener(builds, folder)
    environment = environment | {
        'TEST_TMPDIR': str(folder / 'files'), 'VPROBE_PROGRAM': str(BOTH), 'VPROBE_SAME_SOCKET': str(folder / 'socket'),
        'VPROBE_SAME_BUILDS': ':'.join(str(build.vprobe) for build in builds),
        'GTEST_TOTAL_SHARDS': str(SHARDS), 'GTEST_SHARD_INDEX': str(shard)}
    try:
        code = subprocess.run([str(program)], env=environment, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, timeout=SECONDS_TO_LIVE).returncode
    except subprocess.TimeoutExpired:
        code = None
    listener.close()
    shutil.rmtree(folder)
    # Tests that fail are for ctest to tell; those that end early leave command lines out.
    wrong = '' if code in (0, 1) else f'{program.name} {"did not end" if code is None else f"ended by exit code {code}"}'
    return listener.commands, listener.found, wrong


def run(builds, scratch, environment, jobs):
    """Yields (number of commands, differences, what went wrong, or '') for each part of the tests."""
    programs = [program for name in PROGRAMS if (program := builds[1].test_program(name))]
    if not programs:
        yield 0, [], f'tests/cli: {builds[1].bin} has no {PROGRAMS[0]}'
        return
    total = 0
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        parts = [pool.submit(run_part, program, shard, builds, scratch, environment)
                 for program in programs for shard in range(SHARDS)]
        for part in concurrent.futures.as_completed(parts):
            commands, found, wrong = part.result()
            total += commands
            yield commands, found, wrong
    if not total:
        yield 0, [], f'tests/cli: {programs[0]} does not run what VPROBE_PROGRAM names'
