"""One small mesh, far from the origin, in the formats that hold double precision. Its figures have to be those that it
has at the origin, within 1e-7 of the size of a cell."""
import gzip
import json
import struct

import against
from against import Missing, need, vprobe

# The usual offsets of maps: an axis each.
FAR = (500000.0, 6700000.0, 10000000.0)
BASE = 6700000.0  # what the values are far from
SIDES = (3, 2, 2)
STEP = 0.37
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
THROUGH = (1.5 * STEP + 0.031, STEP - 0.017, STEP + 0.023)
NEAR = 1e-7 * STEP


class Box:
    """Cubes in three rows, with values at points and at cells that differ little from a large number."""

    def __init__(self, numpy):
        self.numpy = numpy
        nx, ny, nz = (n + 1 for n in SIDES)
        k, j, i = numpy.mgrid[0:nz, 0:ny, 0:nx]
        self.near = numpy.stack([i, j, k], axis=-1).reshape(-1, 3) * STEP
        self.points = self.near + FAR
        ids = numpy.arange(nx * ny * nz).reshape(nz, ny, nx)
        cells = numpy.stack([ids[c:c + nz - 1, b:b + ny - 1, a:a + nx - 1] for a, b, c in CORNERS], axis=-1)
        self.cells = cells.reshape(-1, 8)
        self.u = BASE + self.near @ [1.0, 0.25, 0.5]
        self.c = BASE + 0.1 * numpy.arange(len(self.cells))


def check(name, path, point=None, cell=None, options=(), sizes=None):
    """point, cell: the names of the arrays. sizes: of the box, where it is another one."""
    out = against.scratch / 'stats.json'
    array = ['--array', f'point:{point}'] if point else []
    origin = [repr(f + t) for f, t in zip(FAR, THROUGH)]
    vprobe('slice', path, *options, '--origin', *origin, '--normal', '1', '0.5', '0.25', *array, '--stats', out)
    sheet = json.loads(out.read_text())['sheets'][0]
    area, mean = wanted()
    assert abs(sheet['area'] - area) < NEAR, (name, 'area', sheet['area'], area)
    if point:
        assert abs(sheet['mean'] - mean) < NEAR, (name, 'mean', sheet['mean'] - BASE, mean - BASE)
    about = json.loads(vprobe('info', path, *options, '--json'))
    bounds = [FAR[0], FAR[0] + 3 * STEP, FAR[1], FAR[1] + 2 * STEP, FAR[2], FAR[2] + 2 * STEP]
    for ours, right in zip(about['bounds'], bounds):
        assert abs(ours - right) < NEAR, (name, about['bounds'], bounds)
    if cell:
        ranges = [a['range'] for a in about['arrays'] if (a['association'], a['name']) == ('cell', cell)]
        assert ranges and abs(ranges[0][0] - BASE) < NEAR and abs(ranges[0][1] - BASE - 1.1) < NEAR, (name, ranges)


figures = []


def wanted():
    """The box cut by hand: the plane meets its edges in the corners of one polygon, and u is linear."""
    if figures:
        return figures
    numpy = need('numpy')
    normal, through = numpy.array([1.0, 0.5, 0.25]), numpy.array(THROUGH)
    size = numpy.array(SIDES) * STEP
    corners = []
    for axis in range(3):
        for a in (0, 1):
            for b in (0, 1):
                start = numpy.zeros(3)
                start[(axis + 1) % 3], start[(axis + 2) % 3] = a, b
                start *= size
                t = normal @ (through - start) / normal[axis]
                if 0 <= t <= size[axis]:
                    start[axis] = t
                    corners.append(start)
    middle = numpy.mean(corners, axis=0)
    unit = normal / numpy.linalg.norm(normal)
    right = numpy.cross(unit, [0, 0, 1])
    right /= numpy.linalg.norm(right)
    up = numpy.cross(unit, right)
    corners.sort(key=lambda p: numpy.arctan2((p - middle) @ up, (p - middle) @ right))
    area, moment = 0.0, numpy.zeros(3)
    for p, q in zip(corners, corners[1:] + corners[:1]):
        part = 0.5 * numpy.linalg.norm(numpy.cross(p - middle, q - middle))
        area += part
        moment += part * (middle + p + q) / 3
    figures.extend((area, BASE + moment @ [1.0, 0.25, 0.5] / area))
    return figures


def text(values):
    return ' '.join(repr(float(v)) for v in values.ravel())


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


def write_exodus(box, path, form, odd_coordinates):
    netcdf4, numpy = need('netCDF4'), box.numpy
    # A point that no cell has, in front and behind; two blocks, of which the second names the greater nodes first.
    points = numpy.vstack([[0, 0, 0], box.points, [1, 1, 1]])
    u = numpy.concatenate([[-1], box.u, [-1]])
    with netcdf4.Dataset(path, 'w', format=form) as file:
        file.setncatts({'api_version': numpy.float32(5.1), 'version': numpy.float32(5.1), 'title': 'box',
                        'floating_point_word_size': numpy.int32(8), 'file_size': numpy.int32(1)})
        for name, size in (('len_name', 33), ('num_dim', 3), ('num_nodes', len(points)), ('time_step', None),
                           ('num_elem', len(box.cells)), ('num_el_blk', 2), ('num_nod_var', 4), ('num_elem_var', 1),
                           ('num_el_in_blk1', 5), ('num_el_in_blk2', len(box.cells) - 5), ('num_nod_per_el1', 8),
                           ('num_nod_per_el2', 8)):
            file.createDimension(name, size)
        file.createVariable('time_whole', 'f8', ('time_step',))[:] = [0.0]
        if odd_coordinates:
            file.createVariable('coord', 'f8', ('num_dim', 'num_nodes'))[:] = points.T
        else:
            for axis in range(3):
                file.createVariable('coord' + 'xyz'[axis], 'f8', ('num_nodes',))[:] = points[:, axis]
        file.createVariable('eb_status', 'i4', ('num_el_blk',))[:] = 1
        numbers = file.createVariable('eb_prop1', 'i4', ('num_el_blk',))
        numbers.setncattr('name', 'ID')
        numbers[:] = [7, 3]
        file.createVariable('node_num_map', 'i4', ('num_nodes',))[:] = 1000 - numpy.arange(len(points))
        names = file.createVariable('name_nod_var', 'S1', ('num_nod_var', 'len_name'))
        shift = numpy.where(u > 0, 0.25, 0.0)
        for n, (name, values) in enumerate((('u', u), ('disp_x', shift), ('disp_y', 2 * shift), ('disp_z', -shift))):
            names[n] = numpy.array(list(name.ljust(33, '\0')), dtype='S1')
            file.createVariable(f'vals_nod_var{n + 1}', 'f8', ('time_step', 'num_nodes'))[0] = values
        names = file.createVariable('name_elem_var', 'S1', ('num_elem_var', 'len_name'))
        names[0] = numpy.array(list('c'.ljust(33, '\0')), dtype='S1')
        for block, some in ((1, slice(0, 5)), (2, slice(5, None))):
            cells, c = box.cells[some], box.c[some]
            order = slice(None, None, 1 if block == 1 else -1)
            sides = (f'num_el_in_blk{block}', f'num_nod_per_el{block}')
            connect = file.createVariable(f'connect{block}', 'i4', sides)
            connect.elem_type = 'HEX8'
            connect[:] = cells[order] + 2
            file.createVariable(f'vals_elem_var1eb{block}', 'f8', ('time_step', sides[0]))[0] = c[order]


def exodus(folder, box):
    for form in ('NETCDF3_CLASSIC', 'NETCDF3_64BIT_OFFSET', 'NETCDF3_64BIT_DATA', 'NETCDF4'):
        write_exodus(box, folder / f'{form}.e', form, form == 'NETCDF3_64BIT_OFFSET')
        yield f'{form}.e', 'u', 'c'


def exodus_displaced(folder, box):
    write_exodus(box, folder / 'moved.e', 'NETCDF4', False)
    about = json.loads(vprobe('info', folder / 'moved.e', '--displace', '4', '--json'))
    for ours, right in zip(about['bounds'][::2], (FAR[0] + 1, FAR[1] + 2, FAR[2] - 1)):
        assert abs(ours - right) < NEAR, about['bounds']
    return ()


def faces_of(box):
    """Of OpenFOAM: those between cells first, by owner and neighbor; seen from outside of the first cell."""
    sides = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
    faces = {}
    for number, cell in enumerate(box.cells):
        for side in sides:
            corners = [int(cell[i]) for i in side]
            faces.setdefault(tuple(sorted(corners)), [corners]).append(number)
    inside = sorted((f for f in faces.values() if len(f) == 3), key=lambda f: f[1:])
    return inside, [f for f in faces.values() if len(f) == 2]


def write_foam(box, folder, form, label=32, packed=False, moving=False):
    """Three patches: a wall with values of its own for each face, an inlet with one for all, and one without."""
    inside, outside = faces_of(box)
    low = [f for f in outside if all(box.near[p][0] < 0.1 for p in f[0])]
    high = [f for f in outside if all(box.near[p][2] > 1.9 * STEP for p in f[0])]
    outside = low + high + [f for f in outside if f not in low and f not in high]
    faces, numpy = inside + outside, box.numpy
    binary = form == 'binary'

    def put(name, kind, body):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        head = ('/* a case */\nFoamFile\n{\n version 2.0;\n' + f' format {form};\n class {kind};\n'
                f' arch "LSB;label={label};scalar=64";\n object {path.name};\n}}\n// * * //\n')
        data = head.encode() + body
        if packed:
            path.with_name(path.name + '.gz').write_bytes(gzip.compress(data))
        else:
            path.write_bytes(data)

    def numbers(values, kind='f8'):
        kind = f'i{label // 8}' if kind == 'i' else kind
        values = numpy.asarray(values)
        if binary:
            return f'{len(values)}\n('.encode() + values.astype(kind).tobytes() + b')\n'
        rows = values.tolist()
        lines = ['(' + ' '.join(map(repr, row)) + ')' if isinstance(row, list) else repr(row) for row in rows]
        return f'{len(values)}\n(\n'.encode() + '\n'.join(lines).encode() + b'\n)\n'

    mesh = 'constant/polyMesh/'
    put(mesh + 'points', 'vectorField', numbers(box.points - (100.0 if moving else 0.0)))
    if moving:
        put('1/polyMesh/points', 'vectorField', numbers(box.points))
    if binary:
        starts = numpy.cumsum([0] + [len(f[0]) for f in faces])
        put(mesh + 'faces', 'faceCompactList', numbers(starts, 'i') + numbers(numpy.concatenate([f[0] for f in faces]),
                                                                              'i'))
    else:
        put(mesh + 'faces', 'faceList', f'{len(faces)}\n(\n'.encode() + '\n'.join(
            f'{len(f[0])}({" ".join(map(str, f[0]))})' for f in faces).encode() + b'\n)\n')
    put(mesh + 'owner', 'labelList', numbers([f[1] for f in faces], 'i'))
    put(mesh + 'neighbour', 'labelList', numbers([f[2] for f in inside], 'i'))
    first, patches = len(inside), ''
    for name, kind, some in (('floor', 'wall', low), ('top', 'patch', high),
                             ('rest', 'patch', outside[len(low) + len(high):])):
        patches += f' {name}\n {{\n  type {kind};\n  nFaces {len(some)};\n  startFace {first};\n }}\n'
        first += len(some)
    put(mesh + 'boundary', 'polyBoundaryMesh', f'3\n(\n{patches})\n'.encode())

    def field(values, kind, unit):
        of_faces = numpy.array([values[f[1]] - unit for f in low])
        one = 'uniform ' + ('(' + text(unit * BASE) + ')' if values.ndim > 1 else repr(float(unit * BASE)))
        return (b'dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<' + kind + b'>\n' + numbers(values)
                + b';\nboundaryField\n{\n floor { type fixedValue; value nonuniform List<' + kind + b'> '
                + numbers(of_faces) + f'; }}\n top {{ type fixedValue; value {one}; }}\n'.encode()
                + b' rest { type zeroGradient; }\n}\n')
    put('1/c', 'volScalarField', field(box.c, b'scalar', numpy.float64(1.0)))
    put('1/grad(c)', 'volSymmTensorField', field(box.c[:, None] + numpy.arange(6), b'symmTensor', numpy.ones(6)))
    put('1/u', 'pointScalarField', b'dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<scalar>\n'
        + numbers(box.u) + b';\nboundaryField\n{\n floor { type calculated; }\n top { type calculated; }\n'
        + b' rest { type calculated; }\n}\n')
    put('system/controlDict', 'dictionary', b'startTime 0;\nendTime 1;\ndeltaT 1;\nwriteInterval 1;\n')
    (folder / 'box.foam').write_text('')
    return low, high, outside[len(low) + len(high):]


def foam(folder, box):
    for name, how in (('text', ('ascii',)), ('binary', ('binary',)), ('labels', ('binary', 64)),
                      ('packed', ('ascii', 32, True)), ('moving', ('binary', 64, True, True))):
        (folder / name).mkdir()
        write_foam(box, folder / name, *how)
        yield f'{name}/box.foam', 'u', 'c'


def foam_averages(folder, box):
    """The values of points that are made from those of cells and of the boundary's faces."""
    numpy = box.numpy
    low, high, rest = write_foam(box, folder, 'ascii')
    out = folder / 'out.vtu'
    vprobe('convert', folder / 'box.foam', '-o', out)
    vtk = need('vtkmodules.all')
    from vtkmodules.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(out))
    reader.Update()
    got = reader.GetOutput()
    assert numpy.array_equal(vtk_to_numpy(got.GetPoints().GetData()), box.points)
    for name, values in (('c', box.c[:, None]), ('grad(c)', box.c[:, None] + [0, 3, 5, 1, 4, 2])):
        ones = numpy.ones_like(values[0])
        around = {}
        for cell, corners in enumerate(box.cells):
            for p in corners:
                around.setdefault(int(p), []).append(values[cell])
        edge = {}
        for face in low + high + rest:
            value = values[face[1]] - ones if face in low else ones * BASE if face in high else values[face[1]]
            for p in face[0]:
                edge.setdefault(p, []).append(value)
        right = numpy.array([numpy.mean(edge.get(p, around[p]), axis=0) for p in range(len(box.points))])
        ours = vtk_to_numpy(got.GetPointData().GetArray(name)).reshape(right.shape)
        assert abs(ours - right).max() < NEAR, (name, abs(ours - right).max())
        ours = vtk_to_numpy(got.GetCellData().GetArray(name)).reshape(values.shape)
        assert numpy.array_equal(ours, values), name
    return ()


def foam_patches(folder, box):
    """A patch as a sheet: its places are the file's too."""
    write_foam(box, folder, 'binary', 64, True)
    stats = json.loads(vprobe('slice', folder / 'box.foam', '--surface', 'patch=top', '--stats', '-'))['sheets'][0]
    area = SIDES[0] * SIDES[1] * STEP ** 2
    assert abs(stats['area'] - area) < NEAR, (stats['area'], area)
    return ()


def by_meshio(folder, box):
    meshio = need('meshio')
    mesh = meshio.Mesh(box.points, [('hexahedron', box.cells)], point_data={'u': box.u}, cell_data={'c': [box.c]})
    written = [('box.msh', {'file_format': 'gmsh22', 'binary': False}),
               ('binary.msh', {'file_format': 'gmsh22', 'binary': True}), ('box.dat', {}), ('box.avs', {}),
               ('box.med', {}), ('xml.xdmf', {'data_format': 'XML'}), ('hdf.xdmf', {'data_format': 'HDF'}),
               ('binary.xdmf', {'data_format': 'Binary'}), ('box.e', {}), ('box.cgns', {})]
    for name, how in written:
        try:
            mesh.write(folder / name, **how)
        except Exception as error:  # pylint: disable=broad-except
            print(f'far: {name} is left out, {error}')
            continue
        yield name, 'u' if name != 'box.cgns' else None, None if name in ('box.e', 'box.cgns') else 'c'


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
    for kind in (vtk_files, vtk_text, exodus, exodus_displaced, foam, foam_averages, foam_patches, by_meshio, lattices):
        place = folder / kind.__name__
        place.mkdir()
        try:
            for name, point, cell in kind(place, box):
                check(name, place / name, point, cell)
        except Missing as missing:
            print(f'far: {kind.__name__} is left out, {missing} is not installed')


CASES = [far_from_the_origin]
