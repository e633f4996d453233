"""What the tests of the Python module share."""
import json
import os
import signal
import subprocess

import numpy as np
import pytest

import vprobe

# A shell starts what it runs in the background with Ctrl-C ignored, and children keep that: nothing could be interrupted.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope='session')
def program():
    """Runs the program, and gives what it prints."""
    path = os.environ.get('VPROBE_PROGRAM')
    if not path:
        pytest.skip('VPROBE_PROGRAM does not name the program')

    def run(*arguments):
        done = subprocess.run([path, *map(str, arguments)], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout
    return run


@pytest.fixture(scope='session')
def sheet_of(program):
    """The figures of the first sheet, as the program has them."""
    def run(*arguments):
        return json.loads(program('slice', *arguments, '--classify', 'cpu', '--stats', '-'))['sheets'][0]
    return run


@pytest.fixture
def shell():
    return vprobe.open('demo:shell:16', classify='cpu')


def lattice(nx, ny, nz):
    """Points of [0, 1]^3 in lattice order, (nz, ny, nx, 3), and x + 2 y + 3 z at them."""
    z, y, x = np.meshgrid(np.linspace(0, 1, nz), np.linspace(0, 1, ny), np.linspace(0, 1, nx), indexing='ij')
    points = np.ascontiguousarray(np.stack([x, y, z], axis=-1))
    return points, np.ascontiguousarray(x + 2 * y + 3 * z)


def hexahedra(nx, ny, nz):
    """The points of each cell of such a lattice, (n, 8)."""
    ids = np.arange(nx * ny * nz, dtype=np.int64).reshape(nz, ny, nx)
    corners = []
    for layer in (ids[:-1], ids[1:]):
        corners += [layer[:, :-1, :-1], layer[:, :-1, 1:], layer[:, 1:, 1:], layer[:, 1:, :-1]]
    return np.stack([corner.ravel() for corner in corners], axis=1)


def address(array):
    return array.__array_interface__['data'][0]
