"""The command line of tests/same."""
import argparse
import concurrent.futures
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

from . import command_tests, plans
from .builds import Build
from .cases import LeftOut
from .compare import differences
from .desktop import Desktop, missing
from .documents import ROOT, Documents
from .report import Intended, Report, fits
from .run import FACE_PROGRAM, Runner, surroundings

PARTS = pathlib.Path(__file__).parent
EXAMPLES = ROOT / 'tests' / 'python' / 'examples'


def all_cases(full):
    """Cases, and what is left out."""
    yield from Documents(full).cases()
    yield from plans.other_commands()
    yield from plans.plan_cases()
    yield from plans.data_cases()
    yield from plans.rank_cases()
    yield from plans.face_cases(['face'])
    yield from plans.face_cases(['python', str(FACE_PROGRAM)])
    yield from plans.example_cases(sorted(EXAMPLES.glob('*.py')))
    yield from plans.window_cases()


def chosen(cases, pattern):
    """Those with a command that the pattern fits; steps before it run too, since it may need what they write."""
    for case in cases:
        commands = [case.command] if isinstance(case, LeftOut) else [str(step) for step in case.steps]
        if pattern is None or any(fits(f'{case.room}: {command}', f'*{pattern}*') for command in commands):
            yield case


def why_not(case, runner):
    """Why a case cannot run on this machine; None where it can."""
    for step in case.steps:
        program = step.words[0]
        if program == 'vprobe-mpi' and not (all(build.mpi for build in runner.builds) and shutil.which('mpiexec')):
            return 'vprobe-mpi: it needs mpiexec and a vprobe-mpi in both builds'
        if program == 'face' and runner.face is None:
            return 'the C++ face: it needs a compiler, and libvprobe.so in both builds'
        if program == 'python' and not all(build.python for build in runner.builds):
            return 'Python: it needs the module in both builds'
        if step.window and runner.desktop is None:
            return f'windows: they need {", ".join(missing()) or "a desktop"}'
    return None


def compile_face(builds, scratch):
    """The program that asks the C++ face, against the headers of this checkout; None where it cannot be."""
    compiler = shutil.which(os.environ.get('CXX', 'c++'))
    if not compiler or not all(build.library for build in builds):
        return None
    library = next(builds[1].library.glob('libvprobe.so*'))
    program = scratch / 'face'
    done = subprocess.run([compiler, '-std=c++20', f'-I{ROOT / "engine" / "api"}', str(PARTS / 'faces' / 'ask.cpp'), str(library),
                           '-o', str(program)], check=False)
    if done.returncode:
        sys.exit('tests/same: tests/same_parts/faces/ask.cpp does not compile')
    return program


def compare_case(number, case, runner, keep):
    folder = runner.scratch / 'cases' / str(number)
    outcomes = [runner.run(case, build, folder) for build in runner.builds]
    found = differences(case.room, *outcomes)
    if found and keep:
        keep_outcomes(keep / f'{number}', runner.builds, outcomes)
    return found


def keep_outcomes(folder, builds, outcomes):
    for build, outcome in zip(builds, outcomes):
        for number, (command, items) in enumerate(outcome):
            for item, data in items.items():
                path = folder / build.name / str(number) / item
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(data)
            (folder / build.name / str(number) / 'command').write_text(command + '\n')


def run_all(arguments, cases, builds, scratch):
    report = Report(Intended(arguments.intended))
    runner = Runner(builds, scratch)
    (scratch / 'cases').mkdir()
    windows = [case for case in cases if not isinstance(case, LeftOut) and any(step.window for step in case.steps)]
    if any(not isinstance(case, LeftOut) and case.steps[0].words[0] == 'face' for case in cases):
        runner.face = compile_face(builds, scratch)
    desktop = None
    if windows and not missing():
        desktop = Desktop(scratch, runner.environment)
        runner.desktop = desktop.name
    try:
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool, \
                concurrent.futures.ThreadPoolExecutor(1) as one:  # windows would share the keyboard
            running = []
            for number, case in enumerate(cases):
                reason = case.reason if isinstance(case, LeftOut) else why_not(case, runner)
                if reason:
                    report.leave_out(reason, 1 if isinstance(case, LeftOut) else len(case.steps))
                else:
                    where = one if case in windows else pool
                    running.append((case, where.submit(compare_case, number, case, runner, arguments.keep)))
            for case, found in running:
                report.add(len(case.steps), found.result())
    finally:
        if desktop:
            desktop.close()
    if arguments.only is None or arguments.only == 'cli':
        for commands, found, wrong in command_tests.run(builds, scratch, surroundings(scratch), arguments.jobs):
            report.add(commands, found)
            if wrong:
                report.leave_out(wrong)
    return report.finish(tells_stale=arguments.only is None)


def main(usage, words=None):
    parser = argparse.ArgumentParser(usage=usage.split('\n\n', 1)[1], add_help=False)
    parser.add_argument('before')
    parser.add_argument('after')
    parser.add_argument('--only')
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--full', action='store_true')
    parser.add_argument('--list', action='store_true')
    parser.add_argument('--keep', type=pathlib.Path)
    parser.add_argument('--intended', type=pathlib.Path, default=PARTS / 'intended.txt')
    arguments = parser.parse_args(words)
    try:
        builds = [Build('before', arguments.before), Build('after', arguments.after)]
    except FileNotFoundError as error:
        parser.exit(2, f'tests/same: {error}\n')
    cases = [] if arguments.only == 'cli' else list(chosen(all_cases(arguments.full), arguments.only))
    if arguments.list:
        for case in cases:
            for step in [case.command] if isinstance(case, LeftOut) else case.steps:
                print(f'{case.room}: {step}')
        return 0
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))  # folders and desktops go
    with tempfile.TemporaryDirectory(prefix='vprobe-same-') as scratch:
        return 0 if run_all(arguments, cases, builds, pathlib.Path(scratch)) else 1
