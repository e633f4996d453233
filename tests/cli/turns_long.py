#!/usr/bin/env python3
"""vprobe profile --versus-program, measured under load: against itself, and against builds in which a stage is slower.

usage: turns_long.py VPROBE [RUNS]

A process for each core computes meanwhile. Against itself, at most 21 of 200 intervals of the frame may leave out 1 (10
are expected; more than 21 have a probability of 0.1 %). A stage that takes 5 % longer is found in 95 of 100 runs, and
one that takes 1 % longer never fails a limit of 1.05. A build that is slower is this one, with a program between that
makes one time in its answers longer.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

# Each round starts the programs anew, and they build the grid. So it is small, and a round has many planes.
OPTIONS = ['demo:shell:24', '--classify', 'cpu', '--planes', '200', '--json', '-']
SLOWER = '''#!{python}
import json, subprocess, sys
program = subprocess.Popen(['{vprobe}', *sys.argv[1:]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
print(program.stdout.readline(), end='', flush=True)
for plane in sys.stdin:
    program.stdin.write(plane)
    program.stdin.flush()
    answer = json.loads(program.stdout.readline())
    more = ({factor} - 1) * sum(stage['ms'] for stage in answer['stages'] if stage['stage'] == 'emit')
    for stage in answer['stages']:
        if stage['stage'] in ('frame', 'cut', 'emit'):
            stage['ms'] += more
    print(json.dumps(answer), flush=True)
program.stdin.close()
'''


def measured(vprobe, other, *options):
    """The exit code, and the stages by their names."""
    done = subprocess.run([vprobe, 'profile', *OPTIONS, '--versus-program', other, *options], stdout=subprocess.PIPE,
                          check=False)
    if done.returncode not in (0, 6):
        sys.exit(f'vprobe ended with {done.returncode}')
    return done.returncode, {stage['stage']: stage for stage in json.loads(done.stdout)['versus'][0]['stages']}


def slower(folder, vprobe, factor):
    program = pathlib.Path(folder) / f'slower-{factor}'
    program.write_text(SLOWER.format(python=sys.executable, vprobe=vprobe, factor=factor))
    program.chmod(0o700)
    return program


def main():
    vprobe = sys.argv[1]
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 200 if 'VPROBE_LONG' in os.environ else 20
    load = [subprocess.Popen([sys.executable, '-c', 'while True: sum(range(10000))']) for _ in range(os.cpu_count())]
    try:
        with tempfile.TemporaryDirectory() as folder:
            wrong = 0
            for run in range(runs):
                frame = measured(vprobe, vprobe)[1]['frame']
                wrong += not frame['low'] <= 1 <= frame['high']
                if run % 20 == 19:
                    print(f'{wrong} of {run + 1} so far', flush=True)
            print(f'{wrong} of {runs} runs against itself leave out 1')
            by_five, by_one = slower(folder, vprobe, 1.05), slower(folder, vprobe, 1.01)
            half = runs // 2
            found = sum(measured(vprobe, by_five)[1]['emit']['low'] > 1 for _ in range(half))
            print(f'5 % are found in {found} of {half} runs')
            failed = sum(measured(vprobe, by_one, '--at-most', 'emit=1.05')[0] == 6 for _ in range(half))
            print(f'1 % fail the limit of 1.05 in {failed} of {half} runs')
    finally:
        for process in load:
            process.kill()
            process.wait()
    return wrong > max(3, runs * 21 // 200) or found < half * 95 // 100 or failed > 0


if __name__ == '__main__':
    sys.exit(main())
