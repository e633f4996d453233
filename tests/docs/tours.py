"""Runs every command of docs/TOURS.md in a folder with small files: python3 tours.py VPROBE."""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
PAGE = HERE.parents[1] / 'docs' / 'TOURS.md'
SKIPPED = 77  # as tests/run.sh has it


def commands():
    """A recipe's lines follow each other; a line that ends with a backslash goes on."""
    text = PAGE.read_text().replace('\\\n', ' ')
    return [line[4:] for line in text.splitlines() if line.startswith('    ')]


def outputs(command):
    """The files that a command names for writing, as patterns."""
    names = re.findall(r'(?:-o|--stats|--save|--exposure) (\S+)', command) + re.findall(r'> (\S+)', command)
    return [re.sub(r'\{[^}]*\}', '*', name) for name in names if name != '-']


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    for module in ('numpy', 'netCDF4', 'nibabel', 'tifffile'):
        if importlib.util.find_spec(module) is None:
            print(f'skipped: {module} is not installed')
            return SKIPPED
    import tour_files
    listed = commands()
    recipes = PAGE.read_text().count('\n**')
    assert recipes >= 30, f'{recipes} recipes'
    failures = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        tour_files.make(folder)
        environment = dict(os.environ, PATH=f'{program.parent}:{os.environ["PATH"]}')
        for command in listed:
            done = subprocess.run(['sh', '-c', command], cwd=folder, env=environment, capture_output=True, text=True)
            said = [line for line in done.stderr.splitlines() if 'times of one series' not in line]
            missing = [pattern for pattern in outputs(command) if not list(folder.glob(pattern))]
            if done.returncode or said or missing:
                failures.append(f'{command}\n  exit code {done.returncode}, no {missing}, {" ".join(said)}')
    print(f'{len(listed)} commands, {len(failures)} failed')
    print('\n'.join(failures))
    return 1 if failures else 0


if __name__ == '__main__':
    sys.exit(main())
