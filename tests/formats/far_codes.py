"""The mesh far from the origin, as codes write it. Writers yield the names of a file, and of its arrays at points
and at cells."""
import gzip
import json

from against import need, vprobe
from far_box import BASE, FAR, NEAR, SIDES, STEP, faces_of, text


def write_exodus(box, path, form, small):
    netcdf4, numpy = need('netCDF4'), box.numpy
    # A point that no cell has, in front and behind; two blocks, of which the second names the greater nodes first.
    points = numpy.vstack([[0, 0, 0], box.points, [1, 1, 1]])
    u = numpy.concatenate([[-1], box.u, [-1]])
    with netcdf4.Dataset(path, 'w', format=form) as file:
        file.setncatts({'api_version': numpy.float32(5.1), 'version': numpy.float32(5.1), 'title': 'box',
                        'floating_point_word_size': numpy.int32(8), 'file_size': numpy.int32(not small)})
        for name, size in (('len_name', 33), ('num_dim', 3), ('num_nodes', len(points)), ('time_step', None),
                           ('num_elem', len(box.cells)), ('num_el_blk', 2), ('num_nod_var', 4), ('num_elem_var', 1),
                           ('num_el_in_blk1', 5), ('num_el_in_blk2', len(box.cells) - 5), ('num_nod_per_el1', 8),
                           ('num_nod_per_el2', 8)):
            file.createDimension(name, size)
        file.createVariable('time_whole', 'f8', ('time_step',))[:] = [0.0]
        if small:  # the older layout, of one array for all
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
            if small:
                if n == 0:
                    file.createVariable('vals_nod_var', 'f8', ('time_step', 'num_nod_var', 'num_nodes'))
                file['vals_nod_var'][0, n] = values
            else:
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


def write_foam(box, folder, form, label=32, packed=False, moving=False, region=''):
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

    mesh = f'constant/{region}polyMesh/'
    put(mesh + 'points', 'vectorField', numbers(box.points - (100.0 if moving else 0.0)))
    if moving:
        put(f'1/{region}polyMesh/points', 'vectorField', numbers(box.points))
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
    for name, kind, some in (('floor', 'mappedWall', low), ('top', 'patch', high),
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
    put(f'1/{region}c', 'volScalarField', field(box.c, b'scalar', numpy.float64(1.0)))
    put(f'1/{region}grad(c)', 'volSymmTensorField', field(box.c[:, None] + numpy.arange(6), b'symmTensor', numpy.ones(6)))
    put(f'1/{region}u', 'pointScalarField', b'dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<scalar>\n'
        + numbers(box.u) + b';\nboundaryField\n{\n floor { type calculated; }\n top { type calculated; }\n'
        + b' rest { type calculated; }\n}\n')
    put('system/controlDict', 'dictionary', b'startTime 0;\nendTime 1;\ndeltaT 1;\nwriteInterval 1;\n')
    (folder / 'box.foam').write_text('')
    return low, high, outside[len(low) + len(high):]


def foam(folder, box):
    for name, how in (('text', ('ascii',)), ('binary', ('binary',)), ('labels', ('binary', 64)),
                      ('packed', ('ascii', 32, True)), ('moving', ('binary', 64, True, True)),
                      ('region', ('ascii', 32, False, True, 'air/'))):
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


def codes(folder, box):
    numpy = box.numpy
    count, cells = len(box.points), len(box.cells)
    lines = ['        CONTROL INFO 2.4.6', '** GAMBIT NEUTRAL FILE', 'box', 'PROGRAM: Gambit  VERSION:  2.4.6',
             ' 1 Jan 2020    12:00:00', '     NUMNP     NELEM     NGRPS    NBSETS     NDFCD     NDFVL',
             f'{count:10}{cells:10}         0         0         3         3', 'ENDOFSECTION',
             '   NODAL COORDINATES 2.4.6']
    lines += [f'{i + 1:10} {text(point)}' for i, point in enumerate(box.points)]
    lines += ['ENDOFSECTION', '      ELEMENTS/CELLS 2.4.6']
    lines += [f'{i + 1:8}  4  8 ' + ''.join(f'{n + 1:8}' for n in cell[[0, 1, 3, 2, 4, 5, 7, 6]])
              for i, cell in enumerate(box.cells)]
    (folder / 'box.neu').write_text('\n'.join(lines + ['ENDOFSECTION']) + '\n')
    yield 'box.neu', None, None

    inside, outside = faces_of(box)

    def listed(some):
        return '\n'.join('4 ' + ' '.join(f'{n + 1:x}' for n in f[0][::-1])
                         + f' {f[1] + 1:x} {f[2] + 1 if len(f) == 3 else 0:x}' for f in some)
    for name, nodes, values in (('text', f'(10 (1 1 {count:x} 1 3)(\n{text(box.points)}))\n'.encode(),
                                 f'(300 (3 2 1 0 0 1 {cells})(\n{text(box.c)}))\n'.encode()),
                                ('binary', f'(3010 (1 1 {count:x} 1 3)('.encode() + box.points.tobytes()
                                 + b')\nEnd of Binary Section 3010)\n',
                                 f'(3300 (3 2 1 0 0 1 {cells})('.encode() + box.c.tobytes()
                                 + b')\nEnd of Binary Section 3300)\n')):
        (folder / f'{name}.cas').write_bytes(
            f'(0 "box")\n(4 (60 0 0 1 2 4 4 4 8 8 4))\n(2 3)\n(10 (0 1 {count:x} 0 3))\n'.encode() + nodes
            + f'(12 (0 1 {cells:x} 0))\n(12 (2 1 {cells:x} 1 4))\n(13 (0 1 {len(inside + outside):x} 0))\n'
            f'(13 (3 1 {len(inside):x} 2 0)(\n{listed(inside)}))\n(13 (4 {len(inside) + 1:x} '
            f'{len(inside + outside):x} 3 0)(\n{listed(outside)}))\n'.encode())
        (folder / f'{name}.dat').write_bytes(b'(0 "box")\n(4 (60 0 0 1 2 4 4 4 8 8 4))\n'
                                             + f'(33 ({cells} {len(inside + outside)} {count}))\n'.encode() + values)
        yield f'{name}.cas', None, 'TEMPERATURE'

    control = numpy.zeros(64, dtype='<i8')
    for word, number in ((11, 1), (15, 4), (16, count), (17, 6), (18, 6), (19, 1), (20, 1), (23, cells), (24, 1),
                         (27, 7)):
        control[word] = number
    control[14:15].view('<f8')[:] = 971.0
    solids = numpy.hstack([box.cells + 1, numpy.ones((cells, 1))]).astype('<i8')
    stresses = numpy.hstack([numpy.zeros((cells, 6)), box.c[:, None]])
    state = [numpy.array([0.5]), numpy.ones(6), box.points.ravel(), box.u, stresses.ravel(), numpy.array([-999999.0])]
    (folder / 'd3plot').write_bytes(control.tobytes() + (box.points - 1000).tobytes() + solids.tobytes()
                                    + numpy.concatenate(state).tobytes())
    yield 'd3plot', 'temperature', 'plastic strain'


def begin_cgns(numpy, file):
    """The root of a CGNS file in HDF5; returns what writes its nodes."""
    for key, word, size in (('name', 'HDF5 MotherNode', 33), ('label', 'Root Node of HDF5 File', 33), ('type', 'MT', 3)):
        file.attrs.create(key, numpy.bytes_(word), dtype=f'S{size}')
    file[' format'] = numpy.frombuffer(b'IEEE_LITTLE_32\0', dtype='i1')
    file[' hdf5version'] = numpy.frombuffer(b'HDF5 Version 1.10.0'.ljust(33, b'\0'), dtype='i1')

    def node(parent, name, label, kind='MT', values=None):
        group = parent.create_group(name, track_order=True)
        group.attrs['flags'] = numpy.array([1], dtype='i4')
        for key, word, size in (('name', name, 33), ('label', label, 33), ('type', kind, 3)):
            group.attrs.create(key, numpy.bytes_(word), dtype=f'S{size}')
        if values is not None:
            if isinstance(values, str):
                values = numpy.frombuffer(values.encode(), dtype='i1')
            group[' data'] = values
        return group

    node(file, 'CGNSLibraryVersion', 'CGNSLibraryVersion_t', 'R4', numpy.array([3.4], dtype='f4'))
    return node


def in_hdf5(folder, box):
    h5py, numpy = need('h5py'), box.numpy
    count, cells = len(box.points), len(box.cells)
    with h5py.File(folder / 'box.vtkhdf', 'w') as file:
        root = file.create_group('VTKHDF')
        root.attrs['Version'] = [1, 0]
        root.attrs['Type'] = numpy.bytes_('UnstructuredGrid')
        for name, values in (('NumberOfPoints', [count]), ('NumberOfCells', [cells]),
                             ('NumberOfConnectivityIds', [8 * cells]), ('Connectivity', box.cells.ravel()),
                             ('Offsets', 8 * numpy.arange(cells + 1))):
            root[name] = numpy.array(values, dtype='i8')
        root['Types'], root['Points'] = numpy.full(cells, 12, dtype='u1'), box.points
        root['PointData/u'], root['CellData/c'] = box.u, box.c
    yield 'box.vtkhdf', 'u', 'c'

    with h5py.File(folder / 'box.cgns', 'w', track_order=True) as file:
        node = begin_cgns(numpy, file)
        base = node(file, 'Base', 'CGNSBase_t', 'I4', numpy.array([3, 3], dtype='i4'))
        zone = node(base, 'Zone', 'Zone_t', 'I4', numpy.array([[count], [cells], [0]], dtype='i4'))
        node(zone, 'ZoneType', 'ZoneType_t', 'C1', 'Unstructured')
        places = node(zone, 'GridCoordinates', 'GridCoordinates_t')
        for axis in range(3):
            node(places, 'Coordinate' + 'XYZ'[axis], 'DataArray_t', 'R8', box.points[:, axis])
        parts = node(zone, 'Hexahedra', 'Elements_t', 'I4', numpy.array([17, 0], dtype='i4'))
        node(parts, 'ElementRange', 'IndexRange_t', 'I4', numpy.array([1, cells], dtype='i4'))
        node(parts, 'ElementConnectivity', 'DataArray_t', 'I4', (box.cells + 1).ravel().astype('i4'))
        for name, place, values in (('u', 'Vertex', box.u), ('c', 'CellCenter', box.c)):
            solution = node(zone, 'Of ' + name, 'FlowSolution_t')
            node(solution, 'GridLocation', 'GridLocation_t', 'C1', place)
            node(solution, name, 'DataArray_t', 'R8', values)
    yield 'box.cgns', 'u', 'c'

    values = box.c.reshape(SIDES[::-1])
    (folder / 'E.hierarchy').write_text(
        'Grid = 1\nTask = 0\nGridRank = 3\n' + f'GridDimension = {" ".join(str(n + 6) for n in SIDES)}\n'
        f'GridStartIndex = 3 3 3\nGridEndIndex = {" ".join(str(n + 2) for n in SIDES)}\n'
        f'GridLeftEdge = {text(numpy.array(FAR))}\nGridRightEdge = {text(numpy.array(SIDES) * STEP + FAR)}\n'
        'Time = 0.5\nNumberOfBaryonFields = 1\nFieldType = 0\nBaryonFileName = ./E.grid0001\n'
        'NumberOfParticles = 0\nPointer: Grid[1]->NextGridThisLevel = 0\nPointer: Grid[1]->NextGridNextLevel = 0\n')
    with h5py.File(folder / 'E.grid0001', 'w') as file:
        file['c'] = values
    yield 'E.hierarchy', None, 'c'
    with h5py.File(folder / 'box.xamr', 'w') as file:
        root = file.create_group('AMR')
        root.attrs['BlockDims'] = numpy.array(SIDES, dtype='i4')
        root.attrs['RootDX'] = [STEP] * 3
        root.attrs['SimTime'] = 3.0
        root['Leaves/Level'] = numpy.array([1], dtype='i4')
        root['Leaves/X0'] = numpy.array([FAR])
        root['Leaves/c'] = values[None, ..., None]
    yield 'box.xamr', None, 'c'


WRITERS = (exodus, exodus_displaced, foam, foam_averages, foam_patches, codes, in_hdf5)
