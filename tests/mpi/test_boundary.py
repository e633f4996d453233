"""What depends on where the boundary of all the data runs: thresholds of planes, seeds at the boundary, the outline and
the surface of the grid. As of one process, which has joined the pieces."""
import pytest

import pieces

KINDS = ['tetrahedra', 'hexahedra', 'image', 'rectilinear', 'blocks']
OBLIQUE = ('--normal', 0.3, 0.5, 0.8, '--array', 's')


@pytest.mark.parametrize('more', [(), ('--origin', 0.3, 0.2, 0.1), ('--crinkle',), ('--window', 1.6, 1.2)], ids=str)
@pytest.mark.parametrize('kind', KINDS)
def test_thresholds_of_planes(same_figures, cases, kind, more):
    told = same_figures(4, cases[kind], *OBLIQUE, *more, '--threshold', -0.2, 0.25)
    assert told['sheets'][0]['cut_cells'] > 0


@pytest.fixture(scope='module')
def island(tmp_path_factory):
    """An image in one file, which comes apart in slabs. Its values are high in the middle and at one side."""
    image = pieces.vtk.vtkImageData()
    image.SetDimensions(17, 17, 17)
    image.SetOrigin(-1.0, -1.0, -1.0)
    image.SetSpacing(0.125, 0.125, 0.125)
    points = pieces.np.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
    values = pieces.numpy_to_vtk(pieces.np.exp(-8.0 * (points**2).sum(axis=1)) + (points[:, 0] < -0.7), deep=True)
    values.SetName('s')
    image.GetPointData().AddArray(values)
    path = tmp_path_factory.mktemp('island') / 'image.vti'
    pieces.write(pieces.vtk.vtkXMLImageDataWriter(), image, path)
    return path


@pytest.mark.parametrize('seeds, hot_spot, components', [('auto', (0, 0, 0), 2), ('auto', (-0.9, 0.54, 0), 1),
                                                         ('boundary', (0, 0, 0), 1)], ids=str)
def test_what_a_threshold_closes_off(same_figures, island, seeds, hot_spot, components):
    # The middle lies at the border of two ranks. It is a part of the sheet where the hot spot lies there.
    told = same_figures(4, island, '--normal', 0.3, 0.5, 0.8, '--origin', *hot_spot, '--threshold', 0.4, 3, '--seeds', seeds)
    assert told['sheets'][0]['components'] == components


@pytest.mark.parametrize('sheet', [('--surface', 'sphere:0.3'), ('--surface', 'sphere:0.6'),
                                   ('--surface', 'sphere:0.6', '--threshold', 0.3, 0.9), OBLIQUE], ids=str)
def test_seeds_at_the_boundary(same_figures, cases, sheet):
    told = same_figures(4, cases['rectilinear'], *sheet, '--seeds', 'boundary')
    assert (told['sheets'][0]['cut_cells'] == 0) == ('sphere:0.3' in sheet)


@pytest.mark.gpu
@pytest.mark.parametrize('kind', ['rectilinear', 'image', 'hexahedra', 'blocks', 'tetrahedra'])
def test_surface_and_edges_of_the_grid(same_pictures, cases, kind):
    same_pictures([4], cases[kind], *OBLIQUE, '--threshold', -0.2, 0.6, '--outline', 'edges', '--context', 'boundary:0.3',
                  '--size', '160x120')
