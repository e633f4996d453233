"""Whole cells over several processes: figures, pictures and polygons as of one."""
import pytest

import pieces
from test_exports import opened, polygons_of

SMALL = ('--size', '320x240')
OBLIQUE = ('--normal', 0.3, 0.5, 0.8, '--crinkle')
WINDOW = ('--window', 0.5, 0.4)


@pytest.fixture(scope='module')
def cases(tmp_path_factory):
    """Data sets in pieces, written once."""

    def folder(name):
        return tmp_path_factory.mktemp(name)

    tetrahedra = pieces.tetrahedra(6)
    hexahedra = pieces.hexahedra(8)
    return {'tetrahedra': pieces.write_pvtu(folder('tetrahedra'), tetrahedra, pieces.slabs(tetrahedra, 4)),
            'hexahedra': pieces.write_pvtu(folder('hexahedra'), hexahedra, pieces.slabs(hexahedra, 4, axis=1)),
            'image': pieces.write_lattice(folder('image'), 'image', 12, (2, 2, 1)),
            'blocks': pieces.write_blocks(folder('blocks'), pieces.warped(8), (2, 2, 1))}


@pytest.mark.parametrize('kind', ['tetrahedra', 'hexahedra', 'image', 'blocks'])
@pytest.mark.parametrize('more', [(), WINDOW], ids=['whole', 'window'])
def test_figures(same_figures, cases, kind, more):
    told = same_figures(4, cases[kind], *OBLIQUE, *more)
    assert told['sheets'][0]['crinkle']['faces'] > 0
