#!/usr/bin/env python3
"""Holds the lines of memory that `vprobe profile` counts for the stages traverse and emit against callgrind, which
simulates a cache: with cold caches, each line that a stage touches is a miss of the last one.
usage: against_callgrind.py COLD_PLANES [INPUT...]    Exits with 77 where valgrind is not installed."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

GRIDS = sys.argv[2:] or ['demo:shell:64', 'demo:tets:48', 'demo:mixed:24', 'demo:hexes:48', 'demo:layer', 'demo:blob:64',
                         'demo:graded:48']
FUNCTIONS = {'traverse': 'vp::find::findInBlock(*', 'emit': 'emitCold(*'}
WITHIN = 0.2


def simulated(program, grid, function, folder):
    """Returns the misses of the last cache within a function, and what the program printed."""
    out = folder / 'out'
    done = subprocess.run(
        ['valgrind', '--tool=callgrind', '--cache-sim=yes', '--LL=16777216,16,64', f'--toggle-collect={function}',
         '--zero-before=beginPlanes()', f'--callgrind-out-file={out}', program, grid, '3'],
        capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f'{grid}: {done.stderr}')
    text = out.read_text()
    events = re.search(r'^events: (.*)$', text, re.M)[1].split()
    totals = [int(word) for word in re.search(r'^totals: (.*)$', text, re.M)[1].split()]
    costs = dict(zip(events, totals))
    return costs['DLmr'] + costs['DLmw'], done.stdout


def main():
    if not shutil.which('valgrind'):
        print('skipped: valgrind is not installed')
        sys.exit(77)
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        for grid in GRIDS:
            for stage, function in FUNCTIONS.items():
                misses, printed = simulated(sys.argv[1], grid, function, pathlib.Path(folder))
                counted = {line.split()[0]: float(line.split()[1]) for line in printed.splitlines()}[stage]
                ratio = counted / misses if misses else 0.0
                print(f'{grid} {stage}: counted {counted:.0f} lines, callgrind {misses}: {ratio:.3f}')
                failed |= abs(ratio - 1.0) > WITHIN
    sys.exit(failed)


if __name__ == '__main__':
    main()
