"""Each rank reads its part only: pieces, blocks, or slabs of one lattice. Figures and pictures stay those of one."""
import json

import numpy as np
import pytest

import pieces
from pieces import vtk

OBLIQUE = ('--normal', 0.3, 0.5, 0.8)
SMALL = ('--size', '320x240')


def image_of(n, spacing=(0.1, 0.07, 0.03)):
    image = vtk.vtkImageData()
    image.SetExtent(2, n + 2, -1, n, 5, n + 7)
    image.SetOrigin(-0.7, 0.13, 0.01)
    image.SetSpacing(*spacing)
    points = np.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())])
    pieces.add_arrays(image, points)
    return add_cells(image)


def add_cells(grid):
    cells = pieces.numpy_to_vtk(np.arange(grid.GetNumberOfCells(), dtype=np.float32), deep=True)
    cells.SetName('c')
    grid.GetCellData().AddArray(cells)
    return grid


def rectilinear_of(n):
    grid = vtk.vtkRectilinearGrid()
    grid.SetExtent(0, n, 3, n + 4, 0, n + 2)
    for axis, name in enumerate('XYZ'):
        places = np.linspace(0.0, 1.0, grid.GetDimensions()[axis]) ** (1.1 + 0.3 * axis)
        getattr(grid, f'Set{name}Coordinates')(pieces.numpy_to_vtk(places, deep=True))
    points = np.array([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())])
    pieces.add_arrays(grid, points)
    return add_cells(grid)


LATTICES = {'vti': (image_of, vtk.vtkXMLImageDataWriter), 'vtr': (rectilinear_of, vtk.vtkXMLRectilinearGridWriter),
            'vts': (pieces.warped, vtk.vtkXMLStructuredGridWriter)}


def write_whole(folder, kind, n, packing='raw'):
    make, writer_type = LATTICES[kind]
    writer = writer_type()
    if packing == 'ascii':
        writer.SetDataModeToAscii()
    elif packing == 'inline':
        writer.SetDataModeToBinary()
    else:
        writer.SetDataModeToAppended()
        writer.SetEncodeAppendedData(packing == 'base64')
    if packing == 'raw':
        writer.SetCompressorTypeToNone()
    elif packing == 'lz4':
        writer.SetCompressorTypeToLZ4()
    path = folder / f'whole.{kind}'
    pieces.write(writer, make(n), path)
    return path


def write_pvts(folder, n, counts, overlap=0):
    grid = pieces.warped(n)
    listed = []
    for number, extent in enumerate(pieces.lattice_pieces(n, counts)):
        extent = [max(0, extent[0] - overlap), *extent[1:]]
        crop = vtk.vtkExtractGrid()
        crop.SetInputData(grid)
        crop.SetVOI(*extent)
        crop.Update()
        pieces.write(vtk.vtkXMLStructuredGridWriter(), crop.GetOutput(), folder / f'piece{number}.vts')
        listed.append((f'Extent="{" ".join(map(str, extent))}"', f'piece{number}.vts'))
    middle = '<PPoints><PDataArray type="Float64" Name="Points" NumberOfComponents="3"/></PPoints>'
    path = folder / 'case.pvts'
    pieces.write_index(path, 'PStructuredGrid', f'WholeExtent="0 {n} 0 {n} 0 {n}"', grid, listed, middle)
    return path


@pytest.mark.parametrize('kind, packing', [('vti', 'raw'), ('vti', 'lz4'), ('vtr', 'base64'), ('vts', 'raw'),
                                           ('vts', 'inline')])
def test_slabs_of_a_file(same_figures, tmp_path, kind, packing):
    path = write_whole(tmp_path, kind, 14, packing)
    told = same_figures(4, path, '--probe', 'trihedral')
    assert told['grid']['blocks'] == 1
    assert [rank['parts'] for rank in told['ranks']] == [1, 1, 1, 1]
    assert sum(rank['cells'] for rank in told['ranks']) == told['grid']['cells']
    assert all(sheet['components'] == 1 for sheet in told['sheets'])


@pytest.mark.parametrize('kind', ['vti', 'vtr'])
def test_planes_in_the_seams_of_slabs(same_figures, tmp_path, kind):
    # Of eight layers of points, those where three slabs meet.
    path = write_whole(tmp_path, kind, 6, 'raw')
    grid = LATTICES[kind][0](6)
    layer = grid.GetDimensions()[0] * grid.GetDimensions()[1]
    for k in (3, 6):
        told = same_figures(3, path, '--normal', 'z', '--origin', 0, 0, repr(grid.GetPoint(layer * k)[2]))
        assert told['sheets'][0]['polygons'] > 0


def test_cells_that_meet_in_an_edge_alone(same_figures, tmp_path):
    # The plane goes through edges of cells: where it passes from one slab to the next, those share no face on it.
    image = vtk.vtkImageData()
    image.SetDimensions(9, 9, 9)
    image.SetOrigin(-1, -1, -1)
    image.SetSpacing(0.25, 0.25, 0.25)
    pieces.add_arrays(image, np.array([image.GetPoint(i) for i in range(image.GetNumberOfPoints())]))
    pieces.write(uncompressed(vtk.vtkXMLImageDataWriter()), image, tmp_path / 'whole.vti')
    told = same_figures(4, tmp_path / 'whole.vti', '--normal', 1, 0, -1)
    assert told['sheets'][0]['components'] == 1


@pytest.mark.gpu
@pytest.mark.parametrize('kind', ['vti', 'vtr', 'vts'])
def test_pictures_of_slabs(same_pictures, tmp_path, kind):
    path = write_whole(tmp_path, kind, 12, 'raw')
    same_pictures([3], path, '--probe', 'trihedral', '--opacity', 0.6, '--array', 'cell:c', *SMALL)


def test_more_ranks_than_layers(same_figures, tmp_path):
    path = write_whole(tmp_path, 'vts', 2, 'raw')
    told = same_figures(4, path, *OBLIQUE)
    assert sorted(rank['parts'] for rank in told['ranks']) == [0, 0, 1, 1]


def test_slabs_of_other_files(same_figures, tmp_path):
    # Their readers read all, and hand over the layers of a rank.
    ascii_file = write_whole(tmp_path, 'vti', 6, 'ascii')
    same_figures(3, ascii_file, *OBLIQUE)
    legacy = vtk.vtkStructuredGridWriter()
    legacy.SetFileTypeToBinary()
    pieces.write(legacy, pieces.warped(7), tmp_path / 'whole.vtk')
    told = same_figures(3, tmp_path / 'whole.vtk', *OBLIQUE)
    assert [rank['parts'] for rank in told['ranks']] == [1, 1, 1]
    values = np.sin(np.arange(9 * 8 * 7, dtype=np.float32))
    (tmp_path / 'whole.nhdr').write_text('NRRD0004\ntype: float\ndimension: 3\nsizes: 9 8 7\nspacings: 1 0.5 0.25\n'
                                         'encoding: raw\nendian: little\ndata file: whole.raw\n')
    (tmp_path / 'whole.raw').write_bytes(values.tobytes())
    same_figures(3, tmp_path / 'whole.nhdr', *OBLIQUE)
    same_figures(3, tmp_path / 'whole.raw', '--raw-size', '9x8x7', '--raw-type', 'float32', *OBLIQUE)


def test_a_turned_image_stays_whole(same_figures, tmp_path):
    image = image_of(6)
    image.SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1)
    pieces.write(vtk.vtkXMLImageDataWriter(), image, tmp_path / 'turned.vti')
    told = same_figures(3, tmp_path / 'turned.vti', *OBLIQUE)
    assert sorted(rank['parts'] for rank in told['ranks']) == [0, 0, 1]


def test_what_is_left_out_is_counted_over_all_ranks(programs, tmp_path):
    """Three hidden cells in each of four pieces, and two cells with a point without a place, in different pieces."""
    grid = pieces.hexahedra(8)
    slabs = pieces.slabs(grid, 4)
    marks = np.zeros(grid.GetNumberOfCells(), dtype=np.uint8)
    for slab in slabs:
        marks[slab[10:13]] = 32  # hidden
    marks = pieces.numpy_to_vtk(marks, deep=True)
    marks.SetName('vtkGhostType')
    grid.GetCellData().AddArray(marks)
    for point in (0, grid.GetNumberOfPoints() - 1):  # corners of the grid
        grid.GetPoints().SetPoint(point, np.nan, 0, 0)
    asked = ('slice', pieces.write_pvtu(tmp_path, grid, slabs), *OBLIQUE, '-o')
    plain = programs.plain(*asked, tmp_path / 'plain.csv').stderr
    assert '12 ghost or hidden cells are left out' in plain and '2 cells are left out: a point of each' in plain
    for ranks in (2, 4):
        mpi = programs.mpi(ranks, *asked, tmp_path / 'mpi.csv').stderr
        assert mpi.replace('vprobe-mpi: ', 'vprobe: ') == plain


def test_hidden_cells_stay_whole(same_figures, tmp_path):
    image = image_of(6)
    marks = vtk.vtkUnsignedCharArray()
    marks.SetName('vtkGhostType')
    marks.SetNumberOfValues(image.GetNumberOfCells())
    marks.Fill(0)
    for cell in range(0, 100, 3):
        marks.SetValue(cell, 32)
    image.GetCellData().AddArray(marks)
    pieces.write(vtk.vtkXMLImageDataWriter(), image, tmp_path / 'hidden.vti')
    same_figures(3, tmp_path / 'hidden.vti', *OBLIQUE)


@pytest.mark.parametrize('ranks', [3, 4])
def test_pieces_of_a_curvilinear_grid(same_figures, tmp_path, ranks):
    told = same_figures(ranks, write_pvts(tmp_path, 10, (2, 2, 1)), '--probe', 'trihedral')
    assert told['grid']['kind'] == 'curvilinear'
    assert told['grid']['blocks'] == 1
    assert sum(rank['parts'] for rank in told['ranks']) == 4


@pytest.mark.gpu
def test_pictures_of_curvilinear_pieces(same_pictures, tmp_path):
    same_pictures([4], write_pvts(tmp_path, 10, (2, 1, 2)), '--probe', 'trihedral', '--opacity', 0.6, *SMALL)


def test_pieces_that_overlap_are_read_as_one(same_figures, tmp_path):
    told = same_figures(3, write_pvts(tmp_path, 8, (2, 1, 1), overlap=1), *OBLIQUE)
    assert sum(rank['cells'] for rank in told['ranks']) == told['grid']['cells'] == 512


def quarter_each(told, files):
    """Four ranks read about a quarter each of these bytes. A rank that also lists the parts reads their heads."""
    read = [rank['bytes_read'] for rank in told['ranks']]
    heads = 400_000
    assert all(0.2 * files <= count <= 0.32 * files + heads for count in read), (read, files)


def uncompressed(writer):
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.SetCompressorTypeToNone()
    return writer


def test_bytes_that_each_rank_reads(programs, tmp_path):
    def told(path, *arguments):
        programs.mpi(4, 'slice', path, *OBLIQUE, *arguments, '--stats', tmp_path / 'stats.json')
        return json.loads((tmp_path / 'stats.json').read_text())

    def size(pattern):
        return sum(path.stat().st_size for path in tmp_path.glob(pattern))

    image = vtk.vtkImageData()
    image.SetDimensions(97, 97, 97)
    image.SetSpacing(0.01, 0.01, 0.01)
    values = np.sin(np.arange(97 ** 3) * 1e-3)
    array = pieces.numpy_to_vtk(values, deep=True)
    array.SetName('s')
    image.GetPointData().AddArray(array)
    pieces.write(uncompressed(vtk.vtkXMLImageDataWriter()), image, tmp_path / 'whole.vti')
    quarter_each(told(tmp_path / 'whole.vti'), size('whole.vti'))
    values.tofile(tmp_path / 'whole.raw')
    quarter_each(told(tmp_path / 'whole.raw', '--raw-size', '97x97x97', '--raw-type', 'float64'), size('whole.raw'))

    listed = []
    for number in range(4):
        extent = (0, 96, 0, 96, 24 * number, 24 * number + 24)
        crop = vtk.vtkExtractVOI()
        crop.SetInputData(image)
        crop.SetVOI(*extent)
        crop.Update()
        pieces.write(uncompressed(vtk.vtkXMLImageDataWriter()), crop.GetOutput(), tmp_path / f'piece{number}.vti')
        listed.append((f'Extent="{" ".join(map(str, extent))}"', f'piece{number}.vti'))
    pieces.write_index(tmp_path / 'case.pvti', 'PImageData',
                       'WholeExtent="0 96 0 96 0 96" Origin="0 0 0" Spacing="0.01 0.01 0.01"', image, listed, '')
    quarter_each(told(tmp_path / 'case.pvti'), size('piece*.vti'))
    blocks = ''.join(f'<DataSet index="{i}" file="piece{i}.vti"/>' for i in range(4))
    (tmp_path / 'case.vtm').write_text('<VTKFile type="vtkMultiBlockDataSet" version="1.0" byte_order="LittleEndian">'
                                       f'<vtkMultiBlockDataSet>{blocks}</vtkMultiBlockDataSet></VTKFile>')
    quarter_each(told(tmp_path / 'case.vtm'), size('piece*.vti'))

    for piece in tmp_path.glob('piece*'):
        piece.unlink()
    grid = pieces.hexahedra(40)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 4))
    quarter_each(told(case), size('piece*.vtu'))


def test_a_plan_of_all_ranks(programs, tmp_path):
    grid = pieces.tetrahedra(4)
    case = pieces.write_pvtu(tmp_path, grid, pieces.slabs(grid, 2))
    lines = programs.mpi(3, 'slice', case, '--probe', 'trihedral', '--explain').stdout.splitlines()
    assert lines[0].split()[:4] == ['rank', 'sheet', 'block', 'strategy']
    rows = [line.split()[:2] for line in lines[1:]]
    assert rows == [['0', '0'], ['0', '1'], ['0', '2'], ['1', '0'], ['1', '1'], ['1', '2']]  # the third has no part
