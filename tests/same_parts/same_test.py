#!/usr/bin/env python3
"""Whether tests/same sees what differs, and nothing else. The programs that it compares are shell scripts."""
import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

TESTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS))
from same_parts import main  # noqa: E402
from same_parts.compare import Difference  # noqa: E402
from same_parts.report import Intended  # noqa: E402
from same_parts.scrub import scrub  # noqa: E402

# Prints a warning, figures and times of its own, and writes what -o names.
PROGRAM = """#!/bin/sh
echo 'vprobe: a warning' >&2
echo "area 1.25, cut in $$ ms"
printf '{"area": 1.25, "cells": 7, "ms": {"total": %d}}\\n' $$
while [ $# -gt 0 ]; do
	[ "$1" != -o ] || printf 'polygons\\nof\\n' > "$2"
	shift
done
exit 0
"""
# Runs vprobe as the tests of tests/cli do: with a folder of its own, and with streams that are closed or redirected.
CLI_TEST = """#!/bin/sh
[ "$GTEST_SHARD_INDEX" = 0 ] || exit 0
here=$TEST_TMPDIR/vprobe-cli-$$
mkdir -p "$here" "$here-caught"
echo old > "$here/out.vtp"
"$VPROBE_PROGRAM" slice "$here/in.vtu" -o "$here/out.vtp" > "$here-caught/out" 2> "$here-caught/err"
echo "$?" >> "$here-caught/out"
"$VPROBE_PROGRAM" info a >&- 2> "$here-caught/err2"
"$VPROBE_PROGRAM" info b 2>&-
cp "$here-caught/out" SEEN
(ulimit -f 1; "$VPROBE_PROGRAM" slice c -o "$here/big.vtp")
exit 0
"""
USAGE = 'x\n\nusage: x'
ONE = 'docs: vprobe slice demo:shell:24 --normal x -o cut.vtp'


class Same(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def build(self, name, old='', new='', cli=''):
        """A build whose program is ours, with a change."""
        cli = cli.replace('SEEN', str(self.folder / 'seen'))
        self.assertIn(old, PROGRAM)
        folder = self.folder / name / 'bin'
        folder.mkdir(parents=True)
        for program, text in (('vprobe', PROGRAM.replace(old, new) if old else PROGRAM), ('cli_cpu', cli)):
            if text:
                (folder / program).write_text(text)
                (folder / program).chmod(0o755)
        return folder.parent

    def same(self, *builds, only=ONE, intended=''):
        """The exit code, and what is told."""
        (self.folder / 'intended.txt').write_text(intended)
        words = [*builds, '--only', only, '--intended', self.folder / 'intended.txt']
        told = io.StringIO()
        with contextlib.redirect_stdout(told):
            code = main.main(USAGE, list(map(str, words)))
        return code, told.getvalue()

    def told(self, old, new, **more):
        """What is told of a program with this change; there has to be a difference."""
        code, told = self.same(self.build('before'), self.build('after', old, new), **more)
        self.assertEqual(code, 1, told)
        self.assertIn('\n0 the same, 3 different, ', told)
        return told

    def test_a_program_is_the_same_as_itself(self):
        done = subprocess.run([TESTS / 'same', self.build('before'), self.build('after') / 'bin', '--only', ONE],
                              capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, '3 the same, 0 different, 0 intended, 0 left out\n'), done.stderr)

    def test_a_digit_of_the_figures(self):
        self.assertIn("""\
docs: vprobe slice demo:shell:24 --normal x -o cut.vtp
  standard output: line 1:
    - area 1.25, cut in #
    + area 1.26, cut in #
""", self.told('echo "area 1.25', 'echo "area 1.26'))

    def test_a_digit_of_json(self):
        self.assertIn('  standard output: line 2:\n', self.told('"cells": 7', '"cells": 8'))

    def test_a_warning(self):
        self.assertIn('  standard error: line 1:\n    - vprobe: a warning\n    + \n', self.told("echo 'vprobe: a warning' >&2\n", ''))

    def test_an_exit_code(self):
        self.assertIn('  exit code: line 1:\n    - 0\n    + 2\n', self.told('exit 0', 'exit 2'))

    def test_a_signal(self):
        self.assertIn('    - 0\n    + -9\n', self.told('exit 0', 'kill -9 $$'))

    def test_a_file(self):
        self.assertIn('  cut.vtp: line 2:\n    - of\n    + off\n', self.told('nof', 'noff'))

    def test_bytes(self):
        self.assertIn('  cut.vtp: 12 and 14 bytes, first difference at byte 8\n', self.told('polygons\\nof', 'polygons\\0\\n\\0of'))

    def test_a_file_that_is_not_written(self):
        self.assertIn('  cut.vtp: written by BEFORE alone\n', self.told('[ "$1" != -o ] ||', 'true ||'))

    def test_what_is_wanted(self):
        code, told = self.same(self.build('before'), self.build('after', 'exit 0', 'exit 2'),
                               intended='# why\n*slice*: exit code => 2 is better\n*no such* => gone\n')
        self.assertEqual(code, 0, told)
        self.assertIn('  exit code, intended: 2 is better: line 1:\n', told)
        self.assertIn('\n0 the same, 0 different, 3 intended, ', told)

    def test_another_difference_of_the_same_command_is_not_wanted(self):
        code, told = self.same(self.build('before', 'polygons', 'polygon'), self.build('after', 'exit 0', 'exit 2'),
                               intended='*slice*: exit code => 2 is better\n')
        self.assertEqual(code, 1, told)
        self.assertIn('\n0 the same, 3 different, 0 intended, ', told)

    def test_tests_of_the_command_line(self):
        before, after = self.build('before'), self.build('after', 'exit 0', 'exit 2', cli=CLI_TEST)
        code, told = self.same(before, after, only='cli')
        self.assertEqual(code, 1, told)
        self.assertIn('cli: vprobe slice in.vtu -o out.vtp\n  exit code: line 1:\n    - 0\n    + 2\n', told)
        self.assertIn('\n0 the same, 4 different, 0 intended, 0 left out\n', told)
        self.assertEqual((self.folder / 'seen').read_text().split('\n')[-2:], ['2', ''], 'the test does not see AFTER')

    def test_tests_that_run_another_program_are_told(self):
        build = self.build('before', cli='#!/bin/sh\nexit 0\n')
        self.assertIn('left out: tests/cli: ', self.same(build, build, only='cli')[1])

    def test_wrong_usage(self):
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as ended:
            self.same(self.folder, self.folder)
        self.assertEqual(ended.exception.code, 2)


class Told(unittest.TestCase):
    def test_patterns_that_fit_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, 'intended.txt')
            file.write_text('# a remark\n\n*slice [a]*: cut.vtp => why\n*render* => why not\n')
            intended = Intended(file)
            self.assertIsNone(intended.reason(Difference('docs', 'vprobe slice [a] b', 'exit code', [])))
            self.assertEqual(intended.reason(Difference('docs', 'vprobe slice [a] b', 'cut.vtp', [])), 'why')
            self.assertEqual(intended.stale(), ['*render*'])
            file.write_text('no reason\n')
            self.assertRaises(ValueError, Intended, file)


class Scrub(unittest.TestCase):
    def test_durations(self):
        self.assertEqual(scrub('', 'cut in 12.3 ms of 1.05 s, 7 cells, 812 µs\n'.encode()),
                         'cut in # of #, 7 cells, #\n'.encode())

    def test_json(self):
        self.assertEqual(scrub('s.json', b'{"a": 1.0, "ms": {"x": 2, "y": [3, null]}, "b": [4, {"p95": 5, "c": 6}]}'),
                         b'{"a": 1.0, "ms": {"x": #, "y": [#, #]}, "b": [4, {"p95": #, "c": 6}]}')
        self.assertEqual(scrub('p.json', b'{"stage": "cut", "page_faults": 7.0, "computes": 64, "instructions": null}'),
                         b'{"stage": "cut", "page_faults": #, "computes": 64, "instructions": #}')

    def test_tables_of_times(self):
        self.assertEqual(scrub('', b'ms a plane   median  p95\nframe   0.774    1.1\n\n12 cells\n'),
                         b'ms a plane   median  p95\nframe # #\n\n12 cells\n')

    def test_dates_and_traces(self):
        self.assertEqual(scrub('a.pdf', b'%PDF-1.5\0 /CreationDate (D:2026)'), b'%PDF-1.5\0 /CreationDate (#)')
        self.assertEqual(scrub('t.json', b'[{"ph": "X", "ts": 12}]'), b'a trace\n')

    def test_files_stay_as_they_are(self):
        self.assertEqual(scrub('a.csv', b'12 ms\n'), b'12 ms\n')


if __name__ == '__main__':
    unittest.main()
