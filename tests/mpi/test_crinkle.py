"""Whole cells over several processes: figures, pictures and polygons as of one."""
import os

import numpy as np
import pytest

import pieces
from pieces import vtk_to_numpy
from test_exports import opened

LONG = bool(os.environ.get('VPROBE_LONG'))
SMALL = ('--size', '320x240')
OBLIQUE = ('--normal', 0.3, 0.5, 0.8, '--crinkle')
WINDOW = ('--window', 0.5, 0.4)
# Planes in the borders between ranks, of which one side's cells are cut, and forms that are no planes.
OTHERS = [('tetrahedra', ('--normal', 1, 0, 0)), ('hexahedra', ('--normal', 0, 1, 0)),
          ('hexahedra', ('--normal', 0, -1, 0)),
          ('tetrahedra', ('--surface', 'sphere:0.5')), ('blocks', ('--surface', 'z = 0.2*sin(5*x)'))]


@pytest.mark.parametrize('kind, more', [('tetrahedra', ()), ('hexahedra', WINDOW), ('image', ()), ('blocks', ()),
                                        ('blocks', WINDOW)], ids=str)
def test_figures(same_figures, cases, kind, more):
    told = same_figures(4, cases[kind], *OBLIQUE, *more)
    assert told['sheets'][0]['crinkle']['faces'] > 0


@pytest.mark.parametrize('ranks', [1, 2, 3] if LONG else [2])
def test_figures_of_any_number_of_ranks(same_figures, cases, ranks):
    same_figures(ranks, cases['tetrahedra'], *OBLIQUE)


@pytest.mark.parametrize('kind, sheet', OTHERS if LONG else OTHERS[1:4:2], ids=lambda value: str(value))
def test_other_sheets(same_figures, cases, kind, sheet):
    same_figures(4, cases[kind], *sheet, '--crinkle')


def faces_of(data):
    """Each face by its corners and what it is of, in an order that does not depend on the file's."""
    points = vtk_to_numpy(data.GetPoints().GetData())
    values = vtk_to_numpy(data.GetPointData().GetArray('s'))
    starts = vtk_to_numpy(data.GetPolys().GetOffsetsArray())
    ids = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
    corners = np.hstack([points, values[:, None]])
    return sorted(sorted(corners[ids[starts[p]:starts[p + 1]]].tolist()) for p in range(len(starts) - 1))


def test_exports(programs, cases, tmp_path):
    asked = (cases['tetrahedra'], *OBLIQUE, '--array', 's')
    programs.plain('slice', *asked, '-o', tmp_path / 'plain.vtp')
    plain = faces_of(opened(tmp_path / 'plain.vtp'))
    for ranks in (2, 4):
        programs.mpi(ranks, 'slice', *asked, '-o', tmp_path / f'{ranks}.vtp')
        assert faces_of(opened(tmp_path / f'{ranks}.vtp')) == plain


OPAQUE, TRANSLUCENT, EDGES = (), ('--opacity', 0.5), ('--mesh', '--array', 'cell:c', '--lines', 6, '--no-labels')
LOOKS = [('tetrahedra', OPAQUE), ('blocks', TRANSLUCENT), ('hexahedra', EDGES)]
ALL_LOOKS = [(kind, look) for kind in ('tetrahedra', 'hexahedra', 'image', 'blocks')
             for look in (OPAQUE, TRANSLUCENT, EDGES) if kind == 'hexahedra' or look != EDGES]


@pytest.mark.gpu
@pytest.mark.parametrize('kind, look', ALL_LOOKS if LONG else LOOKS, ids=str)
def test_pictures(same_pictures, cases, kind, look):
    same_pictures([1, 2, 3, 4] if LONG else [4], cases[kind], *OBLIQUE, *look, *SMALL)
