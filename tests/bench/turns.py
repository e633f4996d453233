#!/usr/bin/env python3
"""Several builds of bench_cut in turns on one machine: the median of each row's times in each of them, in milliseconds.

usage: turns.py TURNS FILTER NAME=COMMAND...

FILTER is a regular expression, as --benchmark_filter takes it. Rows stand in the order of the first program; what a
program lacks is a dash.
"""
import json
import shlex
import statistics
import subprocess
import sys
import tempfile


def times(command, pattern):
    """Milliseconds of each row of one run. command: a list."""
    # A descriptor, not a name: a command in another root has other names.
    with tempfile.TemporaryFile() as file:
        subprocess.run([*command, '--benchmark_filter=' + pattern, '--benchmark_out_format=json',
                        f'--benchmark_out=/proc/self/fd/{file.fileno()}'], pass_fds=[file.fileno()],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
        file.seek(0)
        rows = json.load(file)['benchmarks']
    return {row['name'].split('/min_time')[0].split('/iterations')[0]: row['real_time']
            for row in rows if 'error_occurred' not in row and 'skipped' not in row}


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    turns, pattern = int(sys.argv[1]), sys.argv[2]
    programs = dict(argument.split('=', 1) for argument in sys.argv[3:])
    measured = {name: {} for name in programs}
    for turn in range(turns):
        for name, command in programs.items():
            for row, ms in times(shlex.split(command), pattern).items():
                measured[name].setdefault(row, []).append(ms)
        print(f'turn {turn + 1} of {turns} done', file=sys.stderr)
    rows = list(dict.fromkeys(row for name in programs for row in measured[name]))
    print(f'{"ms":44}' + ''.join(f'{name:>14}' for name in programs))
    for row in rows:
        cells = [f'{statistics.median(measured[name][row]):.3f}' if row in measured[name] else '-' for name in programs]
        print(f'{row:44}' + ''.join(f'{cell:>14}' for cell in cells))


if __name__ == '__main__':
    main()
