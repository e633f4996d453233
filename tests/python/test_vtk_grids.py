"""VTK's data sets: shared, cut as vtkCutter does, or refused in one line."""
import gc

import numpy as np
import pytest

import vprobe
from conftest import address, hexahedra, lattice

pytest.importorskip('vtkmodules.vtkFiltersCore', reason='no VTK for Python')
from vtkmodules import vtkCommonCore as core  # noqa: E402
from vtkmodules import vtkCommonDataModel as model  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkFiltersCore import vtkCutter, vtkMassProperties, vtkTriangleFilter  # noqa: E402

PLANE = dict(normal=(.3, .5, .8))
N = 11, 10, 9
FACES = (0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)


def named(values, name):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    return array


def with_arrays(mesh):
    points = np.array([mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())])
    mesh.GetPointData().AddArray(named(np.sin(points[:, 0]) + points[:, 1] * points[:, 2], 'p'))
    mesh.GetPointData().AddArray(named(points.astype(np.float32), 'v'))
    mesh.GetCellData().AddArray(named(np.arange(mesh.GetNumberOfCells(), dtype=np.int32), 'number'))
    return mesh


def bent(points):
    x, y, z = points.reshape(-1, 3).T
    return np.stack([x + .1 * np.sin(3 * y), y + .1 * z * z, z], axis=1)


def vtk_points(points):
    made = core.vtkPoints()
    made.SetData(numpy_to_vtk(points, deep=True))
    return made


def cell_array(offsets, connectivity):
    cells = model.vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(connectivity, deep=True))
    return cells


def image():
    mesh = model.vtkImageData()
    mesh.SetExtent(2, 1 + N[0], -1, N[1] - 2, 0, N[2] - 1)
    mesh.SetSpacing(.1, .12, .11)
    mesh.SetOrigin(.3, 0, -1)
    return with_arrays(mesh)


def rectilinear():
    mesh = model.vtkRectilinearGrid()
    mesh.SetDimensions(N)
    for axis, put in enumerate((mesh.SetXCoordinates, mesh.SetYCoordinates, mesh.SetZCoordinates)):
        put(numpy_to_vtk(np.linspace(0, 1, N[axis]) ** 2, deep=True))
    return with_arrays(mesh)


def structured():
    mesh = model.vtkStructuredGrid()
    mesh.SetDimensions(N)
    mesh.SetPoints(vtk_points(bent(lattice(*N)[0])))
    return with_arrays(mesh)


def explicit():
    mesh = model.vtkExplicitStructuredGrid()
    mesh.SetDimensions(N)
    mesh.SetPoints(vtk_points(bent(lattice(*N)[0])))
    cells = hexahedra(*N)
    mesh.SetCells(cell_array(np.arange(0, cells.size + 1, 8), cells.ravel()))
    return with_arrays(mesh)


def unstructured(types=12, split=None):
    cells = hexahedra(*N)
    if split is not None:
        cells = cells[:, split].reshape(-1, len(split[0]))
    mesh = model.vtkUnstructuredGrid()
    mesh.SetPoints(vtk_points(bent(lattice(*N)[0]).astype(np.float32)))
    size = cells.shape[1]
    mesh.SetCells(types, cell_array(np.arange(0, cells.size + 1, size), cells.ravel()))
    return with_arrays(mesh)


def tetrahedra():
    return unstructured(10, [[0, 1, 3, 7], [0, 1, 7, 4], [1, 2, 3, 7], [1, 2, 7, 6], [1, 4, 5, 7], [1, 5, 6, 7]])


def polyhedra():
    """Polyhedra among hexahedra."""
    mesh = model.vtkUnstructuredGrid()
    mesh.SetPoints(vtk_points(bent(lattice(*N)[0])))
    for number, cell in enumerate(hexahedra(*N).tolist()):
        if number % 3:
            mesh.InsertNextCell(12, 8, cell)
            continue
        faces = core.vtkIdList()
        faces.InsertNextId(6)
        for face in FACES:
            faces.InsertNextId(4)
            for corner in face:
                faces.InsertNextId(cell[corner])
        mesh.InsertNextCell(42, faces)
    return with_arrays(mesh)


def elongated():
    """A structured grid with its shortest edges along the last axis: for many cuts the library turns the axes."""
    mesh = model.vtkStructuredGrid()
    mesh.SetDimensions(7, 8, 40)
    mesh.SetPoints(vtk_points(bent(lattice(7, 8, 40)[0])))
    return with_arrays(mesh)


KINDS = image, rectilinear, structured, explicit, unstructured, tetrahedra, polyhedra


def vtk_cut(mesh, origin, normal=PLANE['normal']):
    """Area, and the means of the point arrays over it, of vtkCutter's triangles."""
    plane = model.vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    cutter = vtkCutter()
    cutter.SetCutFunction(plane)
    cutter.SetInputData(mesh)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(cutter.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def area_and_mean(mesh, name):
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[corners[:, i]] for i in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    values = vtk_to_numpy(mesh.GetPointData().GetArray(name))[corners].mean(axis=1)
    return areas.sum(), (areas * values).sum() / areas.sum()


@pytest.mark.parametrize('make', KINDS)
def test_cut_as_vtkcutter_cuts(make):
    mesh = make()
    data = vprobe.wrap(mesh, classify='cpu')
    low, high = np.array(data.bounds).reshape(3, 2).T
    assert np.allclose(data.bounds, mesh.GetBounds())
    values = vtk_to_numpy(mesh.GetPointData().GetArray('p'))
    for share in (.3, .5, .7):
        origin = low + share * (high - low)
        piece = data.slice(**PLANE, origin=origin, array='p')
        area, mean = area_and_mean(vtk_cut(mesh, origin), 'p')
        assert piece.area == pytest.approx(area, rel=2e-5)
        assert abs(piece.mean - mean) <= 2e-4 * np.ptp(values)
        assert np.array_equal(piece['number'], piece.cells)


@pytest.mark.parametrize('make', KINDS)
def test_arrays_are_shared(make):
    mesh = make()
    held = vprobe.wrap(mesh, classify='cpu').block()
    for place, data in (('point:p', mesh.GetPointData().GetArray('p')), ('point:v', mesh.GetPointData().GetArray('v')),
                        ('cell:number', mesh.GetCellData().GetArray('number'))):
        assert address(held.arrays[place]) == address(vtk_to_numpy(data))
    if make is rectilinear:
        assert address(held.coordinates[1]) == address(vtk_to_numpy(mesh.GetYCoordinates()))
    elif make is not image:
        assert address(held.coordinates[0]) == address(vtk_to_numpy(mesh.GetPoints().GetData()))
    if make in (unstructured, tetrahedra, explicit):
        assert address(held.connectivity) == address(vtk_to_numpy(mesh.GetCells().GetConnectivityArray()))


def test_points_of_a_structured_grid_are_shared_until_the_second_cut_turns_its_axes():
    mesh = elongated()
    places = address(vtk_to_numpy(mesh.GetPoints().GetData()))
    data = vprobe.wrap(mesh, classify='cpu')
    first = data.slice(**PLANE, array='p')
    assert address(data.block().coordinates[0]) == places
    second = data.slice(**PLANE, array='p')
    assert address(data.block().coordinates[0]) != places
    assert second.area == pytest.approx(first.area, rel=1e-12) and second.mean == pytest.approx(first.mean, rel=1e-12)
    for piece in (first, second):  # the first still shows the grid as it was
        assert np.array_equal(piece['number'], piece.cells) and piece.components == 1


@pytest.mark.parametrize('make, ending', [(image, 'ImageData'), (rectilinear, 'RectilinearGrid'), (structured, 'StructuredGrid'),
                                          (elongated, 'StructuredGrid'), (unstructured, 'UnstructuredGrid'),
                                          (tetrahedra, 'UnstructuredGrid'), (polyhedra, 'UnstructuredGrid')])
@pytest.mark.parametrize('normal', [(.3, .5, .8), (1, 0, 0), (-.7, .1, .2)])
def test_figures_are_those_of_the_program_to_the_last_bit(make, ending, normal, tmp_path, sheet_of):
    xml = pytest.importorskip('vtkmodules.vtkIOXML', reason='no writers of VTK')
    mesh = make()
    writer = getattr(xml, f'vtkXML{ending}Writer')()
    file = tmp_path / f'mesh.{writer.GetDefaultFileExtension()}'
    writer.SetFileName(str(file))
    writer.SetInputData(mesh)
    assert writer.Write() == 1
    of_program = sheet_of(file, '--normal', *normal)
    for data in (vprobe.open(file, classify='cpu'), vprobe.wrap(mesh, classify='cpu')):
        piece = data.slice(normal=normal)
        for figure in ('area', 'mean', 'min', 'max'):
            assert getattr(piece, figure) == of_program[figure], (data, figure)


@pytest.mark.parametrize('wide', [True, False])
@pytest.mark.parametrize('bad', [-1, 990, 1023, 1024, 2 ** 31 - 1])
@pytest.mark.parametrize('make', [unstructured, tetrahedra])
def test_a_point_that_is_not_there_is_an_error_of_the_first_cut(make, bad, wide):
    mesh = make()
    cells = mesh.GetCells()
    if not wide:
        cells.ConvertTo32BitStorage()
    assert mesh.GetNumberOfPoints() == 990
    vtk_to_numpy(cells.GetConnectivityArray())[-2] = bad
    data = vprobe.wrap(mesh, classify='cpu')
    for call in (lambda: data.slice(**PLANE), lambda: data.slice(normal='x'), lambda: data.sample([[.5, .5, .5]]),
                 lambda: data.slice(**PLANE, crinkle=True), lambda: data.isosurface(1.0)):
        with pytest.raises(vprobe.InputError, match=f'a cell lists point {bad} of 990'):
            call()


@pytest.mark.parametrize('make', KINDS)
def test_what_is_shared_outlives_the_mesh(make):
    mesh = make()
    data = vprobe.wrap(mesh, classify='cpu')
    before = data.slice(**PLANE).area
    del mesh
    gc.collect()
    rubbish = [np.full(10 ** 6, 3.0) for _ in range(5)]
    assert data.slice(**PLANE).area == pytest.approx(before, rel=1e-12)
    assert data.slice(**PLANE)['p'].shape
    del rubbish


def test_composites_give_a_block_for_each_volume():
    parts = model.vtkMultiBlockDataSet()
    inner = model.vtkMultiBlockDataSet()
    inner.SetBlock(0, structured())
    parts.SetBlock(0, image())
    parts.SetBlock(1, inner)
    parts.SetBlock(2, model.vtkPolyData())
    parts.GetMetaData(0).Set(parts.NAME(), 'box')
    data = vprobe.wrap(parts, classify='cpu')
    assert data.n_blocks == 2 and data.block(0).name == 'box'
    assert set(np.unique(data.slice(**PLANE, origin=(.55, .5, -.5)).blocks)) <= {0, 1}
    partitions = model.vtkPartitionedDataSet()
    partitions.SetNumberOfPartitions(1)
    partitions.SetPartition(0, tetrahedra())
    collection = model.vtkPartitionedDataSetCollection()
    collection.SetPartitionedDataSet(0, partitions)
    for each in (partitions, collection):
        assert vprobe.wrap(each, classify='cpu').slice(**PLANE).area > 0


def test_hidden_cells_are_left_out():
    for make in (image, rectilinear, structured, unstructured):
        mesh = make()
        whole = vprobe.wrap(mesh, classify='cpu').slice(**PLANE)
        marks = np.zeros(mesh.GetNumberOfCells(), np.uint8)
        marks[::2] = 32
        mesh.GetCellData().AddArray(named(marks, 'vtkGhostType'))
        data = vprobe.wrap(mesh, classify='cpu')
        half = data.slice(**PLANE, origin=whole.origin)
        assert (half.cells % 2 == 1).all() and 0 < half.area < whole.area
        assert set(half.keys()) == {'p', 'v', 'number'}
        if make is structured:  # vtkCutter shows the hidden cells of the others
            area, _ = area_and_mean(vtk_cut(mesh, whole.origin), 'p')
            assert half.area == pytest.approx(area, rel=2e-5)
        vtk_to_numpy(mesh.GetCellData().GetArray('vtkGhostType'))[:] = 32 - marks
        other = vprobe.wrap(mesh, classify='cpu').slice(**PLANE, origin=whole.origin)
        assert half.area + other.area == pytest.approx(whole.area, rel=1e-9)
        assert (other.cells % 2 == 0).all()


def turned():
    mesh = image()
    mesh.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
    return mesh


def cut_of_image(mesh, origin):
    """What vtkCutter, which knows no directions of images, cuts where the plane is turned instead."""
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    about = np.array(mesh.GetOrigin())
    straight = mesh.NewInstance()
    straight.DeepCopy(mesh)
    straight.SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1)
    return vtk_cut(straight, turn.T @ (np.array(origin) - about) + about, turn.T @ PLANE['normal'])


def with_soa():
    mesh = structured()
    array = core.vtkSOADataArrayTemplate['float64']() if hasattr(core, 'vtkSOADataArrayTemplate') else None
    if array is None:
        pytest.skip('this VTK makes no array by components in Python')
    array.SetName('soa')
    array.SetNumberOfComponents(1)
    array.SetNumberOfTuples(mesh.GetNumberOfPoints())
    mesh.GetPointData().AddArray(array)
    return mesh


def with_bits():
    mesh = structured()
    bits = core.vtkBitArray()
    bits.SetName('bits')
    bits.SetNumberOfTuples(mesh.GetNumberOfCells())
    for i in range(mesh.GetNumberOfCells()):
        bits.SetValue(i, i % 2)
    mesh.GetCellData().AddArray(bits)
    return mesh


@pytest.mark.parametrize('make, words', [(turned, 'direction matrix'), (with_soa, 'side by side'),
                                         (with_bits, 'side by side')])
def test_what_cannot_be_shared_is_copied_where_that_is_allowed(make, words):
    mesh = make()
    with pytest.raises(vprobe.InputError, match=words):
        vprobe.wrap(mesh)
    data = vprobe.wrap(mesh, copy=True, classify='cpu')
    assert np.allclose(data.bounds, mesh.GetBounds())
    piece = data.slice(**PLANE, array='p')
    area, mean = area_and_mean((cut_of_image if make is turned else vtk_cut)(mesh, piece.origin), 'p')
    assert piece.area == pytest.approx(area, rel=2e-5) and piece.mean == pytest.approx(mean, rel=1e-3)
    if make is with_bits:
        assert np.array_equal(piece['bits'], piece.cells % 2)


def test_every_kind_of_data_set_is_taken_or_refused_in_one_line():
    quadratic = model.vtkUnstructuredGrid()
    quadratic.SetPoints(vtk_points(np.random.default_rng(1).random((10, 3))))
    quadratic.InsertNextCell(24, 10, list(range(10)))
    flat = model.vtkImageData()
    flat.SetDimensions(5, 5, 1)
    triangles = model.vtkUnstructuredGrid()
    triangles.SetPoints(vtk_points(np.random.default_rng(1).random((3, 3))))
    triangles.InsertNextCell(5, 3, [0, 1, 2])
    cases = [(quadratic, 'curved'), (flat, 'is flat'), (triangles, 'without cells that have a volume'),
             (model.vtkPolyData(), 'no volume'), (model.vtkHyperTreeGrid(), 'vtkHyperTreeGridToUnstructuredGrid'),
             (model.vtkOverlappingAMR(), 'vprobe.open'), (model.vtkMultiBlockDataSet(), 'without a data set'),
             (model.vtkUnstructuredGrid(), 'without cells'), (model.vtkTable(), 'no data set of VTK'),
             (model.vtkPath(), 'no volume'), (object(), 'no data set of VTK'), (None, 'no data set of VTK')]
    for mesh, words in cases:
        with pytest.raises(vprobe.InputError, match=words) as raised:
            vprobe.wrap(mesh)
        assert '\n' not in str(raised.value)
    for name in dir(model):
        kind = getattr(model, name)
        if not isinstance(kind, type) or not issubclass(kind, model.vtkDataObject):
            continue
        try:
            empty = kind()
        except TypeError:  # abstract
            continue
        with pytest.raises(vprobe.Error) as raised:
            vprobe.wrap(empty)
        assert '\n' not in str(raised.value), name


def test_results_go_back_to_vtk():
    data = vprobe.wrap(tetrahedra(), classify='cpu')
    piece = data.slice(**PLANE, array='p')
    mesh = piece.to_vtk()
    assert mesh.GetNumberOfPolys() == piece.n_polygons
    assert address(vtk_to_numpy(mesh.GetPoints().GetData())) == address(piece.points)
    assert {mesh.GetCellData().GetArrayName(i) for i in range(mesh.GetCellData().GetNumberOfArrays())} == {
        'number', 'vprobe:cell', 'vprobe:block'}
    triangles = vtkTriangleFilter()
    triangles.SetInputData(mesh)
    area = vtkMassProperties()
    area.SetInputConnection(triangles.GetOutputPort())
    area.Update()
    assert area.GetSurfaceArea() == pytest.approx(piece.area, rel=1e-6)
    own = piece.copy().to_vtk()
    del piece, data
    gc.collect()
    assert area_and_mean(triangles.GetOutput(), 'p')[0] > 0 and own.GetNumberOfPoints() == mesh.GetNumberOfPoints()
    shell = vprobe.open('demo:shell:16')
    assert shell.slice_orthogonal().to_vtk().GetNumberOfBlocks() == 3
    lines = shell.trace(shell.slice(), vector_lattice=5).to_vtk()
    assert lines.GetNumberOfLines() > 0 and lines.GetPointData().GetArray('time')


def test_prisms_and_points_without_a_place():
    """Prisms over a pentagon and a hexagon beside a hexahedron, of which one point is no place."""
    mesh, points, expected = model.vtkUnstructuredGrid(), [], 0
    for cell, sides in enumerate((5, 6, 4)):
        angles = 2 * np.pi * np.arange(sides) / sides
        points += [(3 * cell + np.cos(a), np.sin(a), z) for z in (0, 1) for a in angles]
        expected += .5 * sides * np.sin(2 * np.pi / sides)
    mesh.SetPoints(vtk_points(np.array(points + [(np.nan, 0, 0)])))
    first = 0
    for kind, sides in ((15, 5), (16, 6), (12, 4)):
        mesh.InsertNextCell(kind, 2 * sides, list(range(first, first + 2 * sides)))
        first += 2 * sides
    data = vprobe.wrap(mesh, classify='cpu')
    for _ in range(2):
        assert data.slice(origin=(0, 0, .3), normal='z').area == pytest.approx(expected)
    mesh.GetPoints().SetPoint(0, np.inf, 0, 0)
    with pytest.warns(vprobe.VprobeWarning, match='1 cell is left out'):
        data = vprobe.wrap(mesh, classify='cpu')
    left = expected - 2.5 * np.sin(2 * np.pi / 5)
    assert data.slice(origin=(0, 0, .3), normal='z').area == pytest.approx(left)


@pytest.mark.parametrize('kind, count', ((25, 20), (29, 27), (72, 27), (79, 27)))
def test_curved_hexahedra_are_refined_to_a_tolerance(kind, count):
    step = {0: (0, 0, 0), 1: (1, 0, 0), 2: (1, 1, 0), 3: (0, 1, 0)}
    corners = [np.array(step[i % 4]) + (0, 0, i // 4) for i in range(8)]
    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    faces = [(0, 3, 7, 4), (1, 2, 6, 5), (0, 1, 5, 4), (3, 2, 6, 7), (0, 1, 2, 3), (4, 5, 6, 7), tuple(range(8))]
    places = corners + [np.mean([corners[i] for i in group], axis=0) for group in edges + faces]
    x, y, z = np.array(places[:count], float).T
    middle = (y == .5) if kind == 79 else np.zeros(count, bool)  # handles, which lie where tangents meet
    points = np.column_stack(((1 + x) * np.where(middle, 1, np.cos(y * np.pi / 2)),
                              (1 + x) * np.where(middle, 1, np.sin(y * np.pi / 2)), z))
    mesh = model.vtkUnstructuredGrid()
    mesh.SetPoints(vtk_points(points))
    mesh.InsertNextCell(kind, count, list(range(count)))
    weights = named(np.where(middle, np.sqrt(.5), 1.0), 'w')
    mesh.GetPointData().AddArray(weights)
    mesh.GetPointData().SetRationalWeights(weights)
    off = [abs(vprobe.wrap(mesh, tolerance=each, classify='cpu').slice(origin=(0, 0, .3), normal=(0, 0, 1)).area
               / (.75 * np.pi) - 1) for each in (.3, .01, .0005)]
    assert off[2] < (1e-3 if kind == 79 else .03) and off[0] > off[1]
    with pytest.raises(vprobe.InputError, match='give a tolerance'):
        vprobe.wrap(mesh)


def test_quadratic_tetrahedra_are_refined_to_a_tolerance():
    h = np.sqrt(.5)  # the corner of a ball
    points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (.5, 0, 0), (h, h, 0), (0, .5, 0), (0, 0, .5),
                       (h, 0, h), (0, h, h)])
    mesh = model.vtkUnstructuredGrid()
    mesh.SetPoints(vtk_points(points))
    mesh.InsertNextCell(24, 10, list(range(10)))
    mesh.GetPointData().AddArray(named(points[:, 0] ** 2, 'xx'))
    areas = []
    for tolerance in (.5, .01, .001):
        piece = vprobe.wrap(mesh, tolerance=tolerance, classify='cpu').slice(origin=(0, 0, .3), normal=(0, 0, 1))
        plain = vprobe.unstructured(points, np.arange(10).reshape(1, 10), 'quadratic_tetra', {'xx': points[:, 0] ** 2},
                                    tolerance=tolerance, classify='cpu').slice(origin=(0, 0, .3), normal=(0, 0, 1))
        assert piece.area == plain.area and np.array_equal(piece['xx'], plain['xx'])
        areas.append(piece.area)
    assert areas == sorted(areas) and areas[2] - areas[1] < .02 < areas[1] - areas[0]
    with pytest.raises(vprobe.InputError, match='give a tolerance'):
        vprobe.wrap(mesh)
    with pytest.raises(vprobe.Error, match='threshold'):
        vprobe.wrap(mesh, tolerance=.01, classify='cpu').slice(threshold=(0, 1))
