"""The types that the package tells, by mypy; and that every public thing has its words."""
import doctest
import importlib
import inspect
import os
import pathlib
import subprocess
import sys

import pytest

import vprobe

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / 'apps/python'
MODULES = ['vprobe', 'vprobe._answers', 'vprobe._dataset', 'vprobe._grids', 'vprobe._open', 'vprobe._picture',
           'vprobe._probe', 'vprobe._slice', 'vprobe.vtk']

# What a user writes. The first ten lines are right; of each of the others mypy has to find the mistake.
RIGHT = '''import numpy as np
import vprobe
data: vprobe.Dataset = vprobe.open('demo:shell:16', time=0.5, progress=print)
s: vprobe.Slice = data.slice(normal=(.3, .5, .8), origin='center', array='s', window=(2, 1), lines=7)
area: float = s.area
points: 'np.ndarray[object, np.dtype[np.float64]]' = s.points
image: vprobe.Image = data.render(vprobe.Probe.paddlewheel(3, opacity=.6), size=(640, 480))
pixels: int = image.shape[0] * image.size
for frame in data.sweep(path='spin', frames=3):
    print(frame.cut[0].mean, [each.area for each in frame.cut], data.sample(s.points)['s'].mean())
'''
WRONG = ['vprobe.open(7)', 'data.slice(normal=5)', 'data.slice(window=3)', 's.area.nothing', 'data.render(size=7)',
         'vprobe.Probe.stack("many")', 'data.isosurface("high")', 'data.nothing()', 'for x in data.plan(): x.nothing']


def mypy(*arguments, module='mypy', folder=PACKAGE):
    pytest.importorskip('mypy', reason='no mypy')
    cache = () if module != 'mypy' else ('--config-file', str(PACKAGE / 'mypy.ini'), '--cache-dir', os.devnull)
    return subprocess.run([sys.executable, '-m', module, *cache, *map(str, arguments)], capture_output=True, text=True,
                          check=False, cwd=folder, env={**os.environ, 'MYPYPATH': str(PACKAGE)})


def test_the_package_is_typed_and_users_are_checked(tmp_path):
    user = tmp_path / 'user.py'
    user.write_text(RIGHT + ''.join(line + '\n' for line in WRONG))
    done = mypy('vprobe', user)
    found = {int(line.split(':')[1]) for line in done.stdout.splitlines() if ': error:' in line and 'user.py' in line}
    first = RIGHT.count('\n') + 1
    assert found == set(range(first, first + len(WRONG))), done.stdout
    assert not [line for line in done.stdout.splitlines() if line.startswith('vprobe/') and ': error:' in line], done.stdout
    assert (PACKAGE / 'vprobe/py.typed').exists()


def test_the_stubs_are_those_of_the_module(tmp_path):
    config = tmp_path / 'mypy.ini'
    config.write_text((PACKAGE / 'mypy.ini').read_text().replace('[mypy]', f'[mypy]\nmypy_path = {PACKAGE}', 1))
    allowed = tmp_path / 'allowed'  # pybind11's classes have a type of their own
    allowed.write_text(r'vprobe\._core\.(Cut|Dataset|Mesh|View)(\.__init__)?' '\n')
    done = mypy('vprobe._core', '--mypy-config-file', config, '--allowlist', allowed, module='mypy.stubtest',
                folder=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize('name', MODULES)
def test_examples_in_docstrings_work(name):
    if name == 'vprobe.vtk':
        pytest.importorskip('vtkmodules.vtkImagingCore', reason='no VTK for Python')
    found = doctest.testmod(importlib.import_module(name))
    assert found.failed == 0


def test_every_public_thing_has_its_words():
    missing = []
    for name in vprobe.__all__:
        thing = getattr(vprobe, name)
        if not inspect.isclass(thing) and not inspect.isfunction(thing):
            continue
        members = [(name, thing)] + [
            (f'{name}.{member}', value) for member, value in (vars(thing).items() if inspect.isclass(thing) else ())
            if not member.startswith('_') and (inspect.isfunction(value) or isinstance(value, (property, classmethod)))]
        missing += [path for path, value in members if not inspect.getdoc(value)]
    assert not missing
    for function in (vprobe.open, vprobe.wrap, vprobe.Dataset.slice, vprobe.Dataset.render, vprobe.Dataset.sweep,
                     vprobe.structured, vprobe.image, vprobe.unstructured):
        words = inspect.getdoc(function)
        for parameter in list(inspect.signature(function).parameters)[1:]:
            if parameter not in ('self', 'options', 'settings'):
                assert parameter in words, (function, parameter)
