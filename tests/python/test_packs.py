"""Packs: a cut reads the cells that it meets, and what needs more reads all."""
import numpy as np
import pytest

import vprobe

NORMALS = [(.3, .5, .8), (1, 2, 3), (1, 0, 0), (-.2, .9, .1)]
WHOLE = 'demo:tets:12'


@pytest.fixture(scope='module')
def pack(program, tmp_path_factory):
    path = tmp_path_factory.mktemp('packs') / 'tets.vtkhdf'
    program('pack', WHOLE, '-o', path, '--part', '256')
    return path


def figures(piece):
    return [piece.area, piece.mean, piece.min, piece.max, piece.n_points, piece.n_polygons]


def test_figures_are_those_of_the_whole(pack):
    data, whole = vprobe.open(pack), vprobe.open(WHOLE)
    assert (data.n_cells, data.n_points, data.bounds) == (whole.n_cells, whole.n_points, whole.bounds)
    pieces = [(data.slice(normal=normal), whole.slice(normal=normal)) for normal in NORMALS]
    # They are measured when they are asked for, after the other cuts.
    for piece, wanted in pieces:
        assert figures(piece) == pytest.approx(figures(wanted), rel=1e-12)
        assert sorted(piece.cells) == sorted(wanted.cells)
        assert np.array_equal(np.sort(piece['s']), np.sort(wanted['s']))


def test_surfaces_of_one_value_are_those_of_the_whole(pack):
    data, whole = vprobe.open(pack), vprobe.open(WHOLE)
    pieces = [(data.isosurface(value), whole.isosurface(value)) for value in (1.9, -1.2, 0.0, 1.9)]
    for piece, wanted in pieces:
        assert figures(piece) == pytest.approx(figures(wanted), rel=1e-9, abs=1e-7)
        assert sorted(piece.cells) == sorted(wanted.cells) and len(piece.cells) > 0


def test_what_needs_all_reads_it_in_between(pack):
    data, whole = vprobe.open(pack), vprobe.open(WHOLE)
    early = data.slice(normal=(1, 2, 3))
    places = [[0.1, 1.2, 0.3], [-1.0, 0.5, 2.0], [9.0, 9.0, 9.0]]
    found, wanted = data.sample(places), whole.sample(places)
    assert np.array_equal(found.cells, wanted.cells) and (found.cells >= 0).any()
    assert np.allclose(found['s'], wanted['s'], rtol=1e-12, equal_nan=True)
    assert figures(early) == pytest.approx(figures(whole.slice(normal=(1, 2, 3))), rel=1e-12)
    assert data.slice(normal=(1, 2, 3), crinkle=True).n_polygons == whole.slice(normal=(1, 2, 3), crinkle=True).n_polygons


def test_arrays_are_whole(pack):
    data = vprobe.open(pack)
    data.slice(normal=(1, 2, 3))
    values = data['s']
    assert len(values) == data.n_points
    assert np.array_equal(np.sort(values), np.sort(vprobe.open(WHOLE)['s']))


def test_a_picture_is_that_of_the_whole(pack):
    pictures = [vprobe.open(each).render(normal=(.3, .5, .8), size=(200, 150), title='') for each in (pack, WHOLE)]
    assert np.array_equal(*map(np.asarray, pictures))


def test_an_indexed_file_is_that_without(program, tmp_path, monkeypatch):
    vtk = pytest.importorskip('vtk')
    packed, path = tmp_path / 'packed.vtu', tmp_path / 'plain.vtu'
    program('convert', WHOLE, '-o', packed)
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(packed))
    reader.Update()
    reader.GetOutput().GetPointData().GetArray('s').GetInformation().Set(vtk.vtkDataArray.UNITS_LABEL(), 'Pa')
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(reader.GetOutput())
    writer.SetCompressorTypeToNone()
    writer.EncodeAppendedDataOff()
    assert writer.Write()
    whole = vprobe.open(path)
    program('index', path, '--part', '256')
    data = vprobe.open(path)
    assert data.arrays == whole.arrays and "Pa" in repr(data.arrays), data.arrays
    for normal in NORMALS:
        piece, wanted = data.slice(normal=normal), whole.slice(normal=normal)
        assert figures(piece) == pytest.approx(figures(wanted), rel=1e-12)
        assert sorted(piece.cells) == sorted(wanted.cells)
    assert np.array_equal(data['v'], whole['v'])  # all of it, in the order of the file


@pytest.fixture(scope='module')
def series(program, tmp_path_factory):
    """A row of cubes along x, with f = x + 100 t at t = 1, 2, 3; and its pack."""
    folder = tmp_path_factory.mktemp('series')
    count = 200
    points = [(x, y, z) for x in range(count + 1) for y in (0, 1) for z in (0, 1)]
    cells = [[4 * c + at for at in (0, 4, 6, 2, 1, 5, 7, 3)] for c in range(count)]

    def array(kind, name, values, components=1):
        return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">'
                f'{" ".join(map(str, values))}</DataArray>')

    steps = ''
    for time in (1, 2, 3):
        (folder / f'{time}.vtu').write_text(
            '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>'
            f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{count}">'
            f'<PointData>{array("Float64", "f", [x + 100 * time for x, _, _ in points])}</PointData>'
            f'<Points>{array("Float32", "Points", np.ravel(points), 3)}</Points>'
            f'<Cells>{array("Int32", "connectivity", np.ravel(cells))}'
            f'{array("Int32", "offsets", range(8, 8 * count + 1, 8))}{array("UInt8", "types", [12] * count)}</Cells>'
            '</Piece></UnstructuredGrid></VTKFile>')
        steps += f'<DataSet timestep="{time}" file="{time}.vtu"/>'
    (folder / 'all.pvd').write_text(f'<VTKFile type="Collection"><Collection>{steps}</Collection></VTKFile>')
    program('pack', folder / 'all.pvd', '-o', folder / 'all.vtkhdf', '--part', '64')
    return folder / 'all.vtkhdf'


def test_times_follow_each_other(series):
    data = vprobe.open(series, time='first')
    assert list(data.times) == [1, 2, 3]
    early = data.slice(normal=(1, 0, 0), origin=(20.5, 0, 0))
    frames = [frame.cut[0] for frame in data.sweep(path='times', draws=False, normal=(1, 0, 0), origin=(150.5, 0, 0))]
    # They are measured when all times have passed.
    assert [piece.mean for piece in frames] == [250.5, 350.5, 450.5]
    assert early.mean == 120.5 and data.slice(normal=(1, 0, 0), origin=(20.5, 0, 0)).mean == 120.5
    assert data.sample([[7.25, 0.5, 0.5]])['f'][0] == 107.25  # reads all parts
    assert [frame.cut[0].mean for frame in data.sweep(path='times', draws=False, normal=(1, 0, 0),
                                                      origin=(150.5, 0, 0))] == [250.5, 350.5, 450.5]
