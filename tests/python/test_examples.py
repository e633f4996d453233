"""The examples of docs/PYTHON.md: they run, and the page quotes them with what they print."""
import pathlib
import subprocess
import sys

import pytest

import vprobe

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / 'docs/PYTHON.md'
EXAMPLES = sorted((HERE / 'examples').glob('*.py'))
pytestmark = pytest.mark.gpu


@pytest.mark.parametrize('example', EXAMPLES, ids=lambda path: path.stem)
def test_example(example, tmp_path):
    if example.stem == 'vtk_mesh':
        pytest.importorskip('vtkmodules.vtkFiltersCore', reason='no VTK for Python')
    if example.stem in ('pictures', 'added_arrays'):
        try:
            vprobe.open('demo:shell:8').render(size=(16, 16), samples=1)
        except vprobe.DeviceError as error:
            pytest.skip(str(error))
    done = subprocess.run([sys.executable, example], capture_output=True, text=True, check=False, cwd=tmp_path,
                          timeout=100)
    assert (done.returncode, done.stderr) == (0, '')  # no warnings either
    assert f'```python\n{example.read_text()}```' in PAGE.read_text(), 'docs/PYTHON.md has another text'
    assert f'```\n{done.stdout}```' in PAGE.read_text(), done.stdout
    if example.stem == 'pictures':
        assert len(list(tmp_path.glob('*.png'))) == 5


def test_there_are_six():
    assert len(EXAMPLES) == 6
