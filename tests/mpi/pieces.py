"""Data sets in pieces, as simulations on many processes leave them."""
import numpy as np
import pytest

vtk = pytest.importorskip('vtk', reason='needs python3-vtk9')
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402


def values_at(points):
    """A smooth scalar and a vector, whose values at a place are the same wherever it is computed."""
    x, y, z = points[:, 0], points[:, 1], points[:, 2]
    scalar = np.sin(3 * x) * np.cos(2 * y) + z * z
    return scalar, np.stack([y, -x, 0.3 * np.ones_like(x)], axis=1)


def add_arrays(grid, points):
    scalar, vector = values_at(points)
    for name, values in (('s', scalar), ('v', vector)):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)


def warped(n, twist=0.2):
    """A box of n x n x n hexahedra whose points are moved a little."""
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(n + 1, n + 1, n + 1)
    axis = np.linspace(-1.0, 1.0, n + 1)
    z, y, x = np.meshgrid(axis, axis, axis, indexing='ij')
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    points[:, 2] += twist * np.sin(2 * points[:, 0]) * np.cos(points[:, 1])
    held = vtk.vtkPoints()
    held.SetData(numpy_to_vtk(points, deep=True))
    grid.SetPoints(held)
    add_arrays(grid, points)
    cells = numpy_to_vtk(np.arange(n ** 3, dtype=np.float64), deep=True)
    cells.SetName('c')
    grid.GetCellData().AddArray(cells)
    return grid


def hexahedra(n, twist=0.2):
    append = vtk.vtkAppendFilter()
    append.SetInputData(warped(n, twist))
    append.Update()
    return append.GetOutput()


def tetrahedra(n):
    triangulate = vtk.vtkDataSetTriangleFilter()
    triangulate.SetInputData(warped(n))
    triangulate.Update()
    return triangulate.GetOutput()


def part_of(grid, chosen):
    """The cells with these numbers, with points of their own."""
    ids = vtk.vtkIdList()
    for cell in chosen:
        ids.InsertNextId(int(cell))
    extract = vtk.vtkExtractCells()
    extract.SetInputData(grid)
    extract.SetCellList(ids)
    extract.Update()
    part = extract.GetOutput()
    for data in (part.GetPointData(), part.GetCellData()):
        for i in reversed(range(data.GetNumberOfArrays())):
            if data.GetArrayName(i).startswith('vtkOriginal'):
                data.RemoveArray(i)
    return part


def write(writer, grid, path):
    writer.SetInputData(grid)
    writer.SetFileName(str(path))
    assert writer.Write()


def described(data):
    types = {'double': 'Float64', 'float': 'Float32', 'unsigned char': 'UInt8'}
    return ''.join(f'<PDataArray type="{types[data.GetArray(i).GetDataTypeAsString()]}" Name="{data.GetArrayName(i)}" '
                   f'NumberOfComponents="{data.GetArray(i).GetNumberOfComponents()}"/>'
                   for i in range(data.GetNumberOfArrays()))


def write_index(path, kind, attributes, first, pieces, middle):
    """An index of pieces: (attributes, file name) each."""
    arrays = f'<PPointData>{described(first.GetPointData())}</PPointData>'
    if first.GetCellData().GetNumberOfArrays():
        arrays += f'<PCellData>{described(first.GetCellData())}</PCellData>'
    listed = ''.join(f'<Piece {extent} Source="{name}"/>' for extent, name in pieces)
    path.write_text(f'<VTKFile type="{kind}" version="1.0" byte_order="LittleEndian" header_type="UInt64">'
                    f'<{kind} GhostLevel="0" {attributes}>{arrays}{middle}{listed}</{kind}></VTKFile>')


def write_pvtu(folder, grid, parts):
    """parts: lists of cell numbers. Gives the index."""
    pieces = []
    for number, chosen in enumerate(parts):
        piece = part_of(grid, chosen)
        write(vtk.vtkXMLUnstructuredGridWriter(), piece, folder / f'piece{number}.vtu')
        pieces.append(('', f'piece{number}.vtu'))
    middle = '<PPoints><PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>'
    path = folder / 'case.pvtu'
    write_index(path, 'PUnstructuredGrid', '', part_of(grid, parts[0]), pieces, middle)
    return path


def slabs(grid, count, axis=0):
    """Numbers of cells in slabs along an axis, whose borders lie where cells meet."""
    centers = vtk.vtkCellCenters()
    centers.SetInputData(grid)
    centers.Update()
    at = vtk_to_numpy(centers.GetOutput().GetPoints().GetData())[:, axis]
    slab = np.clip(((at + 1.0) / 2.0 * count).astype(int), 0, count - 1)
    return [np.flatnonzero(slab == i) for i in range(count)]


def lattice_pieces(n, counts):
    """Extents of pieces of a lattice of n cells a side."""
    ends = [[round(n * i / count) for i in range(count + 1)] for count in counts]
    return [(ends[0][i], ends[0][i + 1], ends[1][j], ends[1][j + 1], ends[2][k], ends[2][k + 1])
            for k in range(counts[2]) for j in range(counts[1]) for i in range(counts[0])]


def write_lattice(folder, kind, n, counts):
    """An image or a rectilinear grid in pieces. Gives the index."""
    is_image = kind == 'image'
    grid = vtk.vtkImageData() if is_image else vtk.vtkRectilinearGrid()
    grid.SetExtent(0, n, 0, n, 0, n)
    if is_image:
        grid.SetOrigin(-0.7, 0.13, 0.01)
        grid.SetSpacing(0.1, 0.07, 0.03)
    else:
        for axis, name in enumerate('XYZ'):
            places = numpy_to_vtk(np.linspace(0.0, 1.0, n + 1) ** (1.1 + 0.3 * axis), deep=True)
            getattr(grid, f'Set{name}Coordinates')(places)
    points = np.array([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())])
    add_arrays(grid, points)
    centers = vtk.vtkCellCenters()
    centers.SetInputData(grid)
    centers.Update()
    flow = numpy_to_vtk(values_at(vtk_to_numpy(centers.GetOutput().GetPoints().GetData()).astype(float))[1], deep=True)
    flow.SetName('flow')
    grid.GetCellData().AddArray(flow)
    ending, index, element = ('vti', 'pvti', 'PImageData') if is_image else ('vtr', 'pvtr', 'PRectilinearGrid')
    pieces = []
    for number, extent in enumerate(lattice_pieces(n, counts)):
        crop = vtk.vtkExtractVOI() if is_image else vtk.vtkExtractRectilinearGrid()
        crop.SetInputData(grid)
        crop.SetVOI(*extent)
        crop.Update()
        writer = vtk.vtkXMLImageDataWriter() if is_image else vtk.vtkXMLRectilinearGridWriter()
        write(writer, crop.GetOutput(), folder / f'piece{number}.{ending}')
        pieces.append((f'Extent="{" ".join(map(str, extent))}"', f'piece{number}.{ending}'))
    attributes = f'WholeExtent="0 {n} 0 {n} 0 {n}"'
    if is_image:
        attributes += ' Origin="-0.7 0.13 0.01" Spacing="0.1 0.07 0.03"'
        middle = ''
    else:
        middle = '<PCoordinates>' + ''.join(
            f'<PDataArray type="Float64" Name="{name}" NumberOfComponents="1"/>' for name in 'xyz') + '</PCoordinates>'
    path = folder / f'case.{index}'
    write_index(path, element, attributes, grid, pieces, middle)
    return path


def write_image(path, n, origin, spacing):
    """An image of n cells a side."""
    grid = vtk.vtkImageData()
    grid.SetDimensions(n + 1, n + 1, n + 1)
    grid.SetOrigin(*origin)
    grid.SetSpacing(spacing, spacing, spacing)
    add_arrays(grid, np.array([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]))
    write(vtk.vtkXMLImageDataWriter(), grid, path)


def write_blocks(folder, grid, counts):
    """A warped box as structured blocks of a .vtm. Gives the index."""
    n = grid.GetDimensions()[0] - 1
    names = []
    for number, extent in enumerate(lattice_pieces(n, counts)):
        crop = vtk.vtkExtractGrid()
        crop.SetInputData(grid)
        crop.SetVOI(*extent)
        crop.Update()
        write(vtk.vtkXMLStructuredGridWriter(), crop.GetOutput(), folder / f'block{number}.vts')
        names.append(f'block{number}.vts')
    path = folder / 'case.vtm'
    listed = ''.join(f'<DataSet index="{i}" name="block {i}" file="{name}"/>' for i, name in enumerate(names))
    path.write_text('<VTKFile type="vtkMultiBlockDataSet" version="1.0" byte_order="LittleEndian">'
                    f'<vtkMultiBlockDataSet>{listed}</vtkMultiBlockDataSet></VTKFile>')
    return path
