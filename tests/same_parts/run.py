"""Runs cases by one build or the other, in surroundings that leave nothing to chance."""
import glob
import os
import pathlib
import shutil
import signal
import subprocess
import sys

from . import folders
from .scrub import scrub

SECONDS_TO_LIVE = 300
# The system's, for which the module is built; another that comes first on the path may lack numpy.
PYTHON = '/usr/bin/python3' if os.path.exists('/usr/bin/python3') else sys.executable
FACE_PROGRAM = pathlib.Path(__file__).parent / 'faces' / 'ask.py'
KEPT = ('PATH', 'VPROBE_DATA', 'VPROBE_VALIDATION', 'TMPDIR', 'LD_PRELOAD')


def surroundings(scratch):
    """The environment of all programs."""
    home = scratch / 'home'
    for name in ('config', 'state', 'cache', 'shaders'):
        (home / name).mkdir(parents=True, exist_ok=True)
    (home / 'config' / 'volume-probes').mkdir(exist_ok=True)
    # Hints would lie over pictures of windows.
    (home / 'config' / 'volume-probes' / 'view.json').write_text('{"hints": false}')
    environment = {name: os.environ[name] for name in KEPT if name in os.environ}
    environment.update({
        'HOME': str(home), 'XDG_CONFIG_HOME': str(home / 'config'), 'XDG_STATE_HOME': str(home / 'state'),
        'XDG_CACHE_HOME': str(home / 'cache'), 'XDG_RUNTIME_DIR': str(home), 'MESA_SHADER_CACHE_DIR': str(home / 'shaders'),
        'LC_ALL': 'C.UTF-8', 'TZ': 'UTC', 'SOURCE_DATE_EPOCH': '0', 'PYTHONDONTWRITEBYTECODE': '1',
        'OMPI_ALLOW_RUN_AS_ROOT': '1', 'OMPI_ALLOW_RUN_AS_ROOT_CONFIRM': '1', 'HWLOC_COMPONENTS': '-gl'})
    lavapipe = glob.glob('/usr/share/vulkan/icd.d/lvp_icd*.json')
    if lavapipe:
        environment['VK_DRIVER_FILES'] = environment['VK_ICD_FILENAMES'] = lavapipe[0]
    return environment


def cleaned(name, data, builds):
    """What a program wrote, without what no two runs share, and without the place of the program."""
    for build in builds:
        data = data.replace(str(build.bin).encode(), b'BIN')
    return scrub(name, data)


class Runner:
    def __init__(self, builds, scratch, face=None, desktop=None):
        self.builds = builds
        self.scratch = scratch
        self.environment = surroundings(scratch)
        self.face = face        # the program that asks the C++ face
        self.desktop = desktop  # a name for DISPLAY

    def run(self, case, build, folder):
        """A list of (command, {item: bytes}), without what no two runs share. folder: new, and gone afterwards."""
        folder.mkdir()
        try:
            for name, data in case.files.items():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (folder / name).write_bytes(data)
            return [(str(step), self.step(step, build, folder)) for step in case.steps]
        finally:
            shutil.rmtree(folder)

    def step(self, step, build, folder):
        before = folders.marks(folder)
        command, more = self.command(step, build)
        process = subprocess.Popen(command, cwd=folder, env=self.environment | more, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
                                   executable=str(build.vprobe) if command[0] == 'vprobe' else None)
        try:
            out, err = process.communicate(timeout=SECONDS_TO_LIVE)
            code = str(process.returncode)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            out, err = process.communicate()
            code = f'none after {SECONDS_TO_LIVE} s'
        if step.ranks:  # what mpiexec says of ranks that end depends on which ends first
            err = b''.join(line for line in err.splitlines(keepends=True) if line.startswith(b'vprobe-mpi: '))
        items = {'exit code': code.encode(), 'standard error': cleaned('', err, self.builds),
                 'standard output': cleaned('', out, self.builds)}
        return items | {name: cleaned(name, data, self.builds) for name, data in folders.changed(folder, before).items()}

    def command(self, step, build):
        """What is started, and what it needs in its environment."""
        program, *rest = step.words
        if program == 'vprobe-mpi':
            return ['mpiexec', '--oversubscribe', '-n', str(step.ranks), str(build.mpi), *rest], {}
        if program == 'face':
            return [str(self.face), *rest], {'LD_LIBRARY_PATH': str(build.library)}
        if program == 'python':
            return [PYTHON, *rest], {'PYTHONPATH': str(build.python)}
        return step.words, {'DISPLAY': self.desktop} if step.window else {}
