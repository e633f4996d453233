#!/usr/bin/env python3
"""Do the tests see faults? Mutates the rooms that make figures, and runs the tests on each mutant.

A mutant is one small fault: a comparison turned, a constant moved by one, an index shifted, a call dropped. All mutants
are compiled at once, into a copy of the sources; VPROBE_MUTANT=N turns one of them on. Which tests come by a mutant is
found out first, so that only those run. The first failure ends it, and so does a crash, or a test that takes much longer
than it should.

Mutants that change nothing that anybody could meet are listed in equivalent.txt, each with a reason. A line there names
the function by its text: after a change of the function, --check asks for the reason again.

The exit code is 1 if fewer than 95 % of the others are caught, or if a line of that list is out of date.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import threading
import time

import sites

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
EQUIVALENT = HERE / 'equivalent.txt'
ROOMS = ('cases', 'grid/link', 'seed', 'find', 'mesh', 'measure')
EXPRESSIONS = ('expression', 'placed_expression', 'interval', 'dual')
COPIED = ('CMakeLists.txt', 'CMakePresets.json', 'apps', 'docs', 'engine', 'shaders', 'tests', 'README.md',
          'CHANGELOG.md')
PROGRAMS = ('unit_cases', 'unit_surface', 'unit_grid', 'unit_seed', 'unit_find', 'unit_mesh', 'unit_measure',
            'unit_locate', 'unit_cut', 'unit_contour', 'unit_vectors', 'property_tests', 'oracle_tests', 'cells_tests')
WANTED = 0.95
MEMORY = 6 << 30  # a loop that grows without end is stopped by it


def all_sources():
    for room in ROOMS + ('surface',):
        for path in sorted((ROOT / 'engine' / room).glob('*')):
            if path.suffix in ('.cpp', '.h', '.inl') and (room != 'surface' or path.name.startswith(EXPRESSIONS)):
                yield sites.Source(str(path.relative_to(ROOT)), path.read_text(encoding='utf-8'))


def equivalents():
    """Reasons by key."""
    reasons = {}
    for line in EQUIVALENT.read_text(encoding='utf-8').splitlines():
        if line and not line.startswith('#'):
            key, _, reason = line.partition(' ')
            reasons[key] = reason
    return reasons


def check(sources):
    """Prints the lines of the list that fit no mutant, or have no reason. Returns their number."""
    known = {site.key for source in sources for site in source.sites()}
    wrong = 0
    for key, reason in equivalents().items():
        if key not in known:
            print(f'equivalent.txt: {key}: the function has changed; run mutants.py on its mutants again, and say anew '
                  'why each of them is equivalent')
            wrong += 1
        elif not reason.strip():
            print(f'equivalent.txt: {key}: says no reason')
            wrong += 1
    return wrong


def write_if_changed(path, text):
    if not path.exists() or path.read_text(encoding='utf-8') != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding='utf-8')


class Mutants:
    def __init__(self, options, sources, picked):
        self.options = options
        self.folder = pathlib.Path(options.build).resolve()
        self.copy, self.made = self.folder / 'sources', self.folder / 'made'
        self.sources = {source.file: source for source in sources}
        self.numbered = dict(enumerate(picked, 1))
        self.broken = set()  # numbers of those that do not compile
        self.reach = {}      # number: {program: {test: seconds}}
        self.lock = threading.Lock()

    def copy_sources(self):
        for name in COPIED:
            for path in [ROOT / name] if (ROOT / name).is_file() else (ROOT / name).rglob('*'):
                file = str(path.relative_to(ROOT))
                target = self.copy / file
                if path.is_dir() or '__pycache__' in file:
                    continue
                if file in self.sources:
                    numbered = [(n, s) for n, s in self.numbered.items() if s.file == file and n not in self.broken]
                    write_if_changed(target, sites.mutated(self.sources[file].text, numbered))
                elif not target.exists() or target.stat().st_mtime != path.stat().st_mtime:
                    target.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy2(path, target)

    def build(self):
        """Leaves out the mutants that do not compile."""
        flags = f'-w -include {HERE / "mutant.h"}'
        subprocess.run(['cmake', '-S', self.copy, '-B', self.made, '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release',
                        '-DVPROBE_BENCH=OFF', f'-DCMAKE_CXX_FLAGS={flags}', '-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG'],
                       check=True, stdout=subprocess.DEVNULL)
        while True:
            built = subprocess.run(['ninja', '-C', self.made, '-k', '0', '-j', str(self.options.jobs),
                                    *self.options.programs], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            if built.returncode == 0:
                return
            (self.folder / 'errors.txt').write_text(built.stdout, encoding='utf-8')
            broken = self.broken_by(built.stdout)
            if not broken:
                sys.exit(f'mutants: the copy does not compile; see {self.folder}/errors.txt')
            self.broken |= broken
            print(f'{len(self.broken)} mutants do not compile', flush=True)
            self.copy_sources()

    def broken_by(self, output):
        by_line = {}
        for number, site in self.numbered.items():
            for line in range(site.line, site.last_line + 1):
                by_line.setdefault((site.file, line), set()).add(number)
        broken = set()
        for block in re.split(r'^FAILED: ', output, flags=re.M)[1:]:
            for pattern in (r'([^\s:]+):(\d+):\d+: error', r'([^\s:]+):(\d+):\d+:'):
                found = set()
                for file, line in re.findall(pattern, block):
                    place = re.sub(r'^.*/sources/', '', file)
                    found |= by_line.get((place, int(line)), set()) - self.broken
                if found:
                    broken |= found
                    break
        return broken

    def run(self, program, tests, number=0, reached=None, limit=600.0):
        """Returns whether the tests passed, and the seconds."""
        environment = dict(os.environ, GTEST_FILTER=':'.join(tests), VPROBE_MUTANT=str(number))
        environment.pop('VPROBE_MUTANTS_REACHED', None)
        if reached:
            environment['VPROBE_MUTANTS_REACHED'] = str(reached)
        start = time.monotonic()
        process = subprocess.Popen([self.made / 'bin' / program, '--gtest_fail_fast', '--gtest_brief=1'],
                                   cwd=self.made, env=environment, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, start_new_session=True,
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
        try:
            passed = process.wait(limit) == 0
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            process.wait()
            passed = False
        return passed, time.monotonic() - start

    def find_reach(self):
        """Runs each test once by itself, without a mutant."""
        def reach_of(program, test):
            marks = self.folder / 'marks' / f'{program}.{test}'.replace('/', '_')
            marks.unlink(missing_ok=True)
            passed, seconds = self.run(program, [test], reached=marks)
            if not passed:
                sys.exit(f'mutants: {program} {test} fails without a mutant')
            data = marks.read_bytes() if marks.exists() else b''
            with self.lock:
                for number in self.numbered:
                    if number < len(data) and data[number]:
                        self.reach.setdefault(number, {}).setdefault(program, {})[test] = seconds

        (self.folder / 'marks').mkdir(exist_ok=True)
        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as pool:
            jobs = [pool.submit(reach_of, program, test)
                    for program in self.options.programs for test in self.tests_of(program)]
            for job in jobs:
                job.result()

    def tests_of(self, program):
        listed = subprocess.run([self.made / 'bin' / program, '--gtest_list_tests'], check=True, text=True,
                                stdout=subprocess.PIPE, cwd=self.made).stdout
        suite, tests = '', []
        for line in listed.splitlines():
            if line.startswith('  '):
                tests.append(suite + line.split()[0])
            elif re.fullmatch(r'\S+\.(\s+#.*)?', line):
                suite = line.split()[0]
        return [test for test in tests if 'DISABLED_' not in test]

    def verdict(self, number):
        """Returns what caught the mutant, or nothing."""
        reach = self.reach.get(number, {})
        for program, tests in sorted(reach.items(), key=lambda item: sum(item[1].values())):
            limit = 10.0 + 10.0 * sum(tests.values())
            passed, seconds = self.run(program, tests, number, limit=limit)
            if not passed:
                return f'{program} ({seconds:.1f} s)'
        return None

    def try_all(self):
        """Returns pairs of a number and a verdict, for as long as there is time."""
        found = []
        numbers = [n for n in self.numbered if n not in self.broken]
        # More than asked for were taken, since some do not compile.
        numbers = numbers[:self.options.count] if self.options.count else numbers

        def try_one(number):
            used = sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2]) / 3600
            if used > self.options.hours:
                return
            caught_by = self.verdict(number)
            with self.lock:
                found.append((number, caught_by))
                site = self.numbered[number]
                what = f'caught by {caught_by}' if caught_by else 'SURVIVES' if number in self.reach else 'NOT REACHED'
                print(f'{number} {site.key} line {site.line}, {site.detail}: {what}', flush=True)

        with concurrent.futures.ThreadPoolExecutor(self.options.jobs) as pool:
            list(pool.map(try_one, numbers))
        return found


def report(mutants, found):
    reasons = equivalents()
    survivors = [mutants.numbered[n] for n, caught_by in found if not caught_by]
    judged = [site for site in survivors if site.key in reasons]
    open_ones = [site for site in survivors if site.key not in reasons]
    counted = len(found) - len(judged)
    share = (counted - len(open_ones)) / counted if counted else 1.0
    for site in open_ones:
        line = mutants.sources[site.file].text.split('\n')[site.line - 1].strip()
        print(f'survives: {site.key} line {site.line}, {site.detail}: {line}')
    hours = sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2]) / 3600
    print(f'{len(found)} mutants, {len(mutants.broken)} more do not compile; {len(judged)} are equivalent; '
          f'of the other {counted}, {counted - len(open_ones)} are caught ({100 * share:.1f} %), {len(open_ones)} '
          f'survive; {hours:.2f} hours of processor time')
    (mutants.folder / 'results.json').write_text(json.dumps(
        [{'number': n, 'key': mutants.numbered[n].key, 'caught_by': caught_by} for n, caught_by in sorted(found)],
        indent=1))
    return share >= WANTED


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--check', action='store_true', help='only look whether equivalent.txt fits the sources')
    parser.add_argument('--list', action='store_true', help='only print the mutants that would run')
    parser.add_argument('--build', default=str(ROOT / 'build/mutants'), help='a folder for the copy and its build')
    parser.add_argument('--seed', type=int, default=1, help='chooses the mutants')
    parser.add_argument('--count', type=int, default=200, help='how many mutants')
    parser.add_argument('--rooms', nargs='+', metavar='PATH', default=[''], help='take mutants from these files alone')
    parser.add_argument('--only', nargs='+', metavar='KEY', help='these mutants; a file names all of its mutants')
    parser.add_argument('--programs', nargs='+', default=list(PROGRAMS), help='programs of tests')
    parser.add_argument('--jobs', type=int, default=os.cpu_count(), help='how many at once')
    parser.add_argument('--hours', type=float, default=4.0, help='hours of processor time; then no other mutant starts')
    options = parser.parse_args()

    sources = list(all_sources())
    wrong = check(sources)
    if options.check:
        return 1 if wrong else 0
    every = [site for source in sources for site in source.sites() if site.file.startswith(tuple(options.rooms))]
    if options.only:
        picked = [site for site in every if any(site.key.startswith(key) for key in options.only)]
        options.count = len(picked)
    else:
        picked = sites.chosen(every, options.count + options.count // 5, options.seed)
    if options.list:
        for site in picked:
            print(f'{site.key} line {site.line}, {site.detail}')
        return 0
    mutants = Mutants(options, sources, picked)
    mutants.copy_sources()
    mutants.build()
    mutants.find_reach()
    good = report(mutants, mutants.try_all())
    return 0 if good and not wrong else 1


if __name__ == '__main__':
    sys.exit(main())
