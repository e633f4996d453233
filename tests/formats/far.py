"""One small mesh, far from the origin, in the formats that hold double precision. Its figures have to be those that it
has at the origin, within 1e-7 of the size of a cell."""
import struct

import far_codes
from against import Missing, need
from far_box import FAR, SIDES, STEP, Box, check, text


def grid_of(vtk, box):
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    grid, points, cells = vtk.vtkUnstructuredGrid(), vtk.vtkPoints(), vtk.vtkCellArray()
    points.SetData(numpy_to_vtk(box.points, deep=1))
    rows = box.numpy.insert(box.cells, 0, 8, axis=1).ravel()
    cells.SetCells(len(box.cells), numpy_to_vtkIdTypeArray(rows.astype('i8'), deep=1))
    grid.SetPoints(points)
    grid.SetCells(vtk.VTK_HEXAHEDRON, cells)
    add_values(grid, box)
    return grid


def add_values(data, box):
    from vtkmodules.util.numpy_support import numpy_to_vtk
    for name, values, where in (('u', box.u, data.GetPointData()), ('c', box.c, data.GetCellData())):
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        where.AddArray(array)


def vtk_files(folder, box):
    vtk = need('vtkmodules.all')
    from vtkmodules.util.numpy_support import numpy_to_vtk
    sides = [n + 1 for n in SIDES]
    grid, image, planes, curved = grid_of(vtk, box), vtk.vtkImageData(), vtk.vtkRectilinearGrid(), \
        vtk.vtkStructuredGrid()
    for lattice in (image, planes, curved):
        lattice.SetDimensions(sides)
        add_values(lattice, box)
    image.SetOrigin(FAR)
    image.SetSpacing([STEP] * 3)
    for axis, use in enumerate((planes.SetXCoordinates, planes.SetYCoordinates, planes.SetZCoordinates)):
        use(numpy_to_vtk(box.numpy.unique(box.points[:, axis]), deep=1))
    curved.SetPoints(grid.GetPoints())
    for data, xml in ((grid, 'vtu'), (image, 'vti'), (planes, 'vtr'), (curved, 'vts')):
        writer = {'vtu': vtk.vtkXMLUnstructuredGridWriter, 'vti': vtk.vtkXMLImageDataWriter,
                  'vtr': vtk.vtkXMLRectilinearGridWriter, 'vts': vtk.vtkXMLStructuredGridWriter}[xml]()
        writer.SetFileName(str(folder / f'box.{xml}'))
        writer.SetInputData(data)
        writer.Write()
        legacy = vtk.vtkDataSetWriter()
        legacy.SetFileName(str(folder / f'{xml}.vtk'))
        legacy.SetFileTypeToBinary()
        legacy.SetInputData(data)
        legacy.Write()
        for name in (f'box.{xml}', f'{xml}.vtk'):
            yield name, 'u', 'c'


def hyper_trees(folder, box):
    """Two cells are divided into eight, which have their value."""
    vtk = need('vtkmodules.all')
    from vtkmodules.util.numpy_support import numpy_to_vtk
    trees, values, cursor = vtk.vtkHyperTreeGrid(), vtk.vtkDoubleArray(), vtk.vtkHyperTreeGridNonOrientedCursor()
    trees.SetDimensions([n + 1 for n in SIDES])
    trees.SetBranchFactor(2)
    for axis, use in enumerate((trees.SetXCoordinates, trees.SetYCoordinates, trees.SetZCoordinates)):
        use(numpy_to_vtk(box.numpy.unique(box.points[:, axis]), deep=1))
    values.SetName('c')
    trees.GetCellData().AddArray(values)
    first = 0
    for tree, c in enumerate(box.c):
        trees.InitializeNonOrientedCursor(cursor, tree, True)
        cursor.SetGlobalIndexStart(first)
        values.InsertValue(cursor.GetGlobalNodeIndex(), c)
        divided = tree in (1, 4)
        if divided:
            cursor.SubdivideLeaf()
            for child in range(8):
                cursor.ToChild(child)
                values.InsertValue(cursor.GetGlobalNodeIndex(), c)
                cursor.ToParent()
        first += 9 if divided else 1
    writer = vtk.vtkXMLHyperTreeGridWriter()
    writer.SetFileName(str(folder / 'box.htg'))
    writer.SetInputData(trees)
    writer.Write()
    yield 'box.htg', None, 'c'


def vtk_text(folder, box):
    """Text with all digits, which VTK's writers leave out."""
    cells = ' '.join(map(str, box.cells.ravel()))
    offsets = ' '.join(str(8 * (i + 1)) for i in range(len(box.cells)))
    array = '<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="ascii">{}</DataArray>'
    (folder / 'text.vtu').write_text(
        f'<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid><Piece NumberOfPoints="{len(box.points)}" '
        f'NumberOfCells="{len(box.cells)}"><PointData>{array.format("Float64", "u", 1, text(box.u))}</PointData>'
        f'<CellData>{array.format("Float64", "c", 1, text(box.c))}</CellData>'
        f'<Points>{array.format("Float64", "Points", 3, text(box.points))}</Points><Cells>'
        f'{array.format("Int64", "connectivity", 1, cells)}{array.format("Int64", "offsets", 1, offsets)}'
        f'{array.format("UInt8", "types", 1, " ".join(["12"] * len(box.cells)))}'
        '</Cells></Piece></UnstructuredGrid></VTKFile>')
    yield 'text.vtu', 'u', 'c'
    values = (f'POINT_DATA {len(box.points)}\nSCALARS u double\nLOOKUP_TABLE default\n{text(box.u)}\n'
              f'CELL_DATA {len(box.cells)}\nSCALARS c double\nLOOKUP_TABLE default\n{text(box.c)}\n')
    head = '# vtk DataFile Version 3.0\nbox\nASCII\n'
    rows = '\n'.join('8 ' + ' '.join(map(str, cell)) for cell in box.cells)
    (folder / 'text.vtk').write_text(
        f'{head}DATASET UNSTRUCTURED_GRID\nPOINTS {len(box.points)} double\n{text(box.points)}\n'
        f'CELLS {len(box.cells)} {9 * len(box.cells)}\n{rows}\nCELL_TYPES {len(box.cells)}\n'
        + '12\n' * len(box.cells) + values)
    yield 'text.vtk', 'u', 'c'
    sides = ' '.join(str(n + 1) for n in SIDES)
    (folder / 'image.vtk').write_text(
        f'{head}DATASET STRUCTURED_POINTS\nDIMENSIONS {sides}\nORIGIN {text(box.points[0])}\n'
        f'SPACING {STEP} {STEP} {STEP}\n{values}')
    yield 'image.vtk', 'u', 'c'


def by_meshio(folder, box):
    meshio = need('meshio')
    mesh = meshio.Mesh(box.points, [('hexahedron', box.cells)], point_data={'u': box.u}, cell_data={'c': [box.c]})
    written = [('box.msh', {'file_format': 'gmsh22', 'binary': False}),
               ('binary.msh', {'file_format': 'gmsh22', 'binary': True}), ('box.dat', {}), ('box.avs', {}),
               ('box.med', {}), ('xml.xdmf', {'data_format': 'XML'}), ('hdf.xdmf', {'data_format': 'HDF'}),
               ('binary.xdmf', {'data_format': 'Binary'}), ('box.e', {})]
    for name, how in written:
        try:
            mesh.write(folder / name, **how)
        except Exception as error:  # pylint: disable=broad-except
            print(f'far: {name} is left out, {error}')
            continue
        yield name, 'u', None if name == 'box.e' else 'c'


def lattices(folder, box):
    netcdf4, numpy = need('netCDF4'), box.numpy
    sides = [n + 1 for n in SIDES]
    values = box.u.reshape(sides[::-1])
    with netcdf4.Dataset(folder / 'box.nc', 'w') as file:
        for axis, name in enumerate('xyz'):
            file.createDimension(name, sides[axis])
            file.createVariable(name, 'f8', (name,))[:] = numpy.unique(box.points[:, axis])
        file.createVariable('u', 'f8', ('z', 'y', 'x'))[:] = values
    yield 'box.nc', 'u', None
    (folder / 'box.nrrd').write_bytes(
        (f'NRRD0005\ntype: double\ndimension: 3\nsizes: {" ".join(map(str, sides))}\ncontent: u\nendian: little\n'
         f'encoding: raw\nspace dimension: 3\nspace directions: ({STEP},0,0) (0,{STEP},0) (0,0,{STEP})\n'
         f'space origin: ({",".join(map(repr, FAR))})\n\n').encode() + values.astype('<f8').tobytes())
    yield 'box.nrrd', 'u', None
    (folder / 'box.mha').write_bytes(
        (f'ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n'
         f'Offset = {" ".join(map(repr, FAR))}\nElementSpacing = {STEP} {STEP} {STEP}\n'
         f'DimSize = {" ".join(map(str, sides))}\nElementType = MET_DOUBLE\nElementDataFile = LOCAL\n').encode()
        + values.astype('<f8').tobytes())
    yield 'box.mha', 'MetaImage', None
    blocks = struct.pack('<i', 1) + struct.pack('<3i', *sides)
    (folder / 'box.xyz').write_bytes(blocks + box.points.T.astype('<f8').tobytes())
    yield 'box.xyz', None, None
    (folder / 'text.x').write_text(f'1\n{" ".join(map(str, sides))}\n{text(box.points.T)}\n')
    yield 'text.x', None, None


def far_from_the_origin(folder):
    numpy = need('numpy')
    box = Box(numpy)
    for kind in (vtk_files, hyper_trees, vtk_text, by_meshio, lattices, *far_codes.WRITERS):
        place = folder / kind.__name__
        place.mkdir()
        try:
            for name, point, cell in kind(place, box):
                check(box, name, place / name, point, cell)
        except Missing as missing:
            print(f'far: {kind.__name__} is left out, {missing} is not installed')


CASES = [far_from_the_origin]
