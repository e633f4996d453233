#!/usr/bin/env python3
"""Applies the examples of CONTRIBUTING.md to a copy of the sources and compiles what they touch.

usage: examples.py SOURCE_FOLDER BUILD_FOLDER SCRATCH_FOLDER [--build]

A block with a file's name behind ```cpp is that file. A block with a name behind ```diff has a line that is there and,
with a +, the line to put below it; spaces at the ends of lines do not count. Without --build each file that an example
adds or changes, and each that includes a list with a new line, is compiled by the commands of BUILD_FOLDER. With --build the
program is built in the copy, and what the examples add is used.
"""
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

TREE = ['CMakeLists.txt', 'CMakePresets.json', 'apps', 'engine', 'shaders']


def blocks_of(text, kind):
    """(file, text) of each block of this kind that names a file."""
    return re.findall(r'^```' + kind + r' (\S+)\n(.*?)^```$', text, re.S | re.M)


def insert(path, patch):
    """Puts the patch's new line below the line that it names."""
    old, new = patch.rstrip('\n').split('\n')
    if old[0] != ' ' or new[0] != '+':
        sys.exit(f'{path}: a diff must have one line that is there and one that is new')
    lines = path.read_text().split('\n')
    found = [i for i, line in enumerate(lines) if line.rstrip('\\').strip() == old[1:].strip()]
    if len(found) != 1:
        sys.exit(f'{path}: "{old[1:].strip()}" stands there {len(found)} times')
    continued = '\\' if lines[found[0]].endswith('\\') else ''
    lines.insert(found[0] + 1, f'{new[1:]} {continued}')
    path.write_text('\n'.join(lines))


def compile_alone(source, build, copy, file):
    """Compiles a file of the copy as the build compiles the files of its folder."""
    database = json.loads(subprocess.run(['ninja', '-C', build, '-t', 'compdb'], check=True, capture_output=True,
                                         text=True).stdout)
    folder = 'vprobe.dir' if file.parts[0] == 'apps' else f'vp_{file.parts[1]}.dir'
    command = next((entry['command'] for entry in database
                    if f'/{folder}/' in entry.get('output', '') and entry['file'].endswith('.cxx')), None)
    if command is None:
        sys.exit(f'{file}: the build has no command for files of {folder}')
    words = shlex.split(command)
    words = words[:words.index('-MD')]
    words = [word if word.startswith(f'-I{build}/') else word.replace(f'-I{source}/', f'-I{copy}/') for word in words]
    # Not only its syntax: ccache, where the build has it, keeps what it is told to compile.
    made = copy / 'object.o'
    subprocess.run([*words, '-O0', '-o', str(made), '-c', str(copy / file)], check=True, cwd=build)


def use(program):
    """The examples' subcommand counts, their color map is listed, their setting is an option and a key."""
    counted = subprocess.run([program, 'count', 'demo:hexes:4'], check=True, capture_output=True, text=True).stdout
    if counted.strip() != '64':
        sys.exit(f'count printed {counted!r}')
    refused = subprocess.run([program, 'render', 'demo:hexes:4', '--colormap', 'none', '-o', 'none.png'],
                             capture_output=True, text=True).stderr
    if 'fire' not in refused:
        sys.exit(f'the color map is not listed: {refused}')
    subprocess.run([program, 'slice', 'demo:hexes:4', '--no-rims', '--save', 'rims.json'], check=True)
    if json.loads(pathlib.Path('rims.json').read_text())['look'].get('no_rims') is not True:
        sys.exit('the setting is not kept')
    schema = subprocess.run([program, 'manual', '--schema'], check=True, capture_output=True, text=True).stdout
    if 'no_rims' not in schema:
        sys.exit('the schema lacks the setting')


def main():
    if len(sys.argv) not in (4, 5) or sys.argv[4:] not in ([], ['--build']):
        sys.exit(__doc__)
    source, build, copy = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    shutil.rmtree(copy, ignore_errors=True)
    copy.mkdir(parents=True)
    for name in TREE:
        (shutil.copytree if (source / name).is_dir() else shutil.copy)(source / name, copy / name)
    text = (source / 'CONTRIBUTING.md').read_text()
    added = blocks_of(text, 'cpp')
    changed = blocks_of(text, 'diff')
    if len(added) != 3 or len(changed) != 6:
        sys.exit(f'CONTRIBUTING.md adds {len(added)} files and {len(changed)} lines; it should be 3 and 6')
    for name, content in added:
        (copy / name).write_text(content)
    for name, patch in changed:
        insert(copy / name, patch)

    if sys.argv[4:]:
        subprocess.run(['cmake', '-S', copy, '-B', copy / 'build', '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release',
                        '-DVPROBE_TESTS=OFF'], check=True)
        subprocess.run(['cmake', '--build', copy / 'build', '--target', 'vprobe'], check=True)
        use(copy / 'build/bin/vprobe')
        return
    files = [pathlib.Path(name) for name, _ in added]
    files += [pathlib.Path(name) for name, _ in changed if name.endswith('.cpp')]
    for listed in [pathlib.Path(name) for name, _ in changed if name.endswith(('list.h', 'sections.h', 'commands.h'))]:
        users = [path.relative_to(copy) for path in (copy / listed.parts[0]).rglob('*.cpp')
                 if f'/{listed.name}"' in path.read_text() and '#define VP_' in path.read_text()]
        if not users:
            sys.exit(f'{listed}: no file makes a table of it')
        files += users
    for file in files:
        print(file, flush=True)
        compile_alone(source, build, copy, file)


main()
