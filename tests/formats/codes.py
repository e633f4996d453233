"""Results of codes whose files nothing in Debian writes: written here after what VTK's readers take, and compared with
the same data in a file of VTK, and with what those readers say of them."""
import gzip

from against import compare, cut, info, lattice, mixed_mesh, near, need, tetrahedra
from boxes import cells_of_image, same_cut, vtk_ranges
from meshes import fluent

FACES = {'hexahedron': ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)),
         'tetra': ((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1))}


def faces_of(mesh):
    """Corners, counterclockwise as seen from outside of the first cell, and the cells on both sides, or -1."""
    faces, number = {}, 0
    for block in mesh.cells:
        for cell in block.data:
            for face in FACES[block.type]:
                corners = [int(cell[i]) for i in face]
                faces.setdefault(tuple(sorted(corners)), [corners]).append(number)
            number += 1
    return sorted(((f[0], f[1], f[2] if len(f) == 3 else -1) for f in faces.values()), key=lambda f: f[2] < 0)


def converge(folder):
    h5py, numpy, meshio = need('h5py'), need('numpy'), need('meshio')
    vtk = need('vtkmodules.vtkIOCONVERGECFD')
    mesh = mixed_mesh(meshio, numpy)
    meshio.write(folder / 'reference.vtu', mesh)
    g = numpy.concatenate(mesh.cell_data['g'])
    faces = faces_of(mesh)
    for path, inward in ((folder / 'post000001_+1.0.h5', False), (folder / 'turned.h5', True)):
        with h5py.File(path, 'w') as file:
            file.attrs['OUTPUT_TIME'] = 1.0
            file['BOUNDARIES/BOUNDARY_NAMES'] = numpy.array([b'wall'])
            file['BOUNDARIES/BOUNDARY_IDS'] = numpy.array([5], dtype='i4')
            file['BOUNDARIES/NUM_ELEMENTS'] = numpy.array([sum(f[2] < 0 for f in faces)], dtype='i4')
            stream = file.create_group('STREAM_00')
            for axis in range(3):
                stream['VERTEX_COORDINATES/' + 'XYZ'[axis]] = mesh.points[:, axis].astype('f4')
            stream['CONNECTIVITY/POLYGON_OFFSET'] = numpy.cumsum([0] + [len(f[0]) for f in faces]).astype('i4')
            order = -1 if inward else 1
            stream['CONNECTIVITY/POLYGON_TO_VERTEX'] = numpy.concatenate([f[0][::order] for f in faces]).astype('i4')
            stream['CONNECTIVITY/CONNECTED_CELLS'] = numpy.array(
                [(f[1], f[2]) if f[2] >= 0 else (-6, f[1]) for f in faces], dtype='i4').ravel()
            if inward:  # the boundary's cell first, as their number has no meaning
                sides = stream['CONNECTIVITY/CONNECTED_CELLS'][:].reshape(-1, 2)
                stream['CONNECTIVITY/CONNECTED_CELLS'][:] = numpy.where(sides[:, :1] < 0, sides[:, ::-1], sides).ravel()
            stream['CELL_CENTER_DATA/TEMPERATURE'] = g.astype('f4')
            for axis in range(3):
                stream['CELL_CENTER_DATA/VELOCITY_' + 'XYZ'[axis]] = (axis * g).astype('f4')
            names = ['TEMPERATURE', 'VELOCITY_X', 'VELOCITY_Y', 'VELOCITY_Z']
            stream['VARIABLE_NAMES/CELL_VARIABLES'] = numpy.array([name.encode() for name in names])
    path = folder / 'turned.h5'
    compare(path, folder / 'reference.vtu', [('cell:TEMPERATURE', 'cell:g')])
    assert {a['name']: a['components'] for a in info(path)['arrays']} == {'TEMPERATURE': 1, 'VELOCITY': 3}
    assert info(path)['times'] == [1.0]
    reader = vtk.vtkCONVERGECFDReader()
    reader.SetFileName(str(path))
    theirs = vtk_ranges(reader, 'TEMPERATURE')
    ours = [a for a in info(path)['arrays'] if a['name'] == 'TEMPERATURE'][0]['range']
    assert near(ours[0], theirs[0]) and near(ours[1], theirs[1]), (ours, theirs)


def fluent_hdf5(folder):
    h5py, numpy, meshio = need('h5py'), need('numpy'), need('meshio')
    mesh = mixed_mesh(meshio, numpy)
    meshio.write(folder / 'reference.vtu', mesh)
    g = numpy.concatenate(mesh.cell_data['g'])
    faces = faces_of(mesh)
    inside = sum(f[2] >= 0 for f in faces)

    def part(group, name, first, values):
        group[name] = values
        group[name].attrs['minId'], group[name].attrs['maxId'] = first, first + len(values) - 1

    with h5py.File(folder / 'run.cas.h5', 'w') as file:
        file.create_group('settings')
        root = file.create_group('meshes/1')
        root.attrs.update({'dimension': 3, 'nodeCount': len(mesh.points), 'cellCount': len(g),
                           'faceCount': len(faces)})
        part(root, 'nodes/coords/1', 1, mesh.points)
        hexahedra = len(mesh.cells[0].data)
        for name, values in (('id', (3, 4)), ('minId', (1, hexahedra + 1)), ('maxId', (hexahedra, len(g)))):
            root['cells/zoneTopology/' + name] = numpy.array(values, dtype='i4')
        root['cells/zoneTopology/name'] = 'air;steel'  # of variable length
        for number, some in ((1, faces[:inside]), (2, faces[inside:])):  # seen from inside of c0
            group = root.create_group(f'faces/nodes/{number}')
            first = 1 if number == 1 else inside + 1
            group.attrs['minId'], group.attrs['maxId'] = first, first + len(some) - 1
            group['nnodes'] = numpy.array([len(f[0]) for f in some], dtype='i2')
            group['nodes'] = numpy.concatenate([f[0][::-1] for f in some]).astype('u4') + 1
        part(root, 'faces/c0/1', 1, numpy.array([f[1] + 1 for f in faces], dtype='u4'))
        part(root, 'faces/c1/1', 1, numpy.array([f[2] + 1 for f in faces[:inside]], dtype='u4'))
    with h5py.File(folder / 'run.dat.h5', 'w') as file:
        cells = file.create_group('results/1/phase-1/cells')
        cells['fields'] = numpy.array([b'SV_T;SV_V'])
        half = len(g) // 2
        part(cells, 'SV_T/1', 1, g[:half].astype('f4'))
        part(cells, 'SV_T/2', half + 1, g[half:].astype('f4'))
        part(cells, 'SV_V/1', 1, numpy.stack([g, 2 * g, 3 * g], axis=1))
    # Each of the zones has the points between them.
    compare(folder / 'run.cas.h5', folder / 'reference.vtu', [('cell:SV_T', 'cell:g')], counts=('cells',))
    found = info(folder / 'run.cas.h5')
    assert {a['name']: a['components'] for a in found['arrays']} == {'SV_T': 1, 'SV_V': 3}, found['arrays']
    assert [b['name'].split(': ')[-1] for b in found['blocks']] == ['air', 'steel'], found['blocks']


def fluent_gzip(folder):
    fluent(folder)
    for ending in ('cas', 'dat'):
        with gzip.open(folder / f'packed.{ending}.gz', 'wb') as file:
            file.write((folder / f'run.{ending}').read_bytes())
    compare(folder / 'packed.cas.gz', folder / 'run.cas', [('cell:TEMPERATURE', 'cell:TEMPERATURE')])


def slac(folder):
    netcdf4, numpy, meshio = need('netCDF4'), need('numpy'), need('meshio')
    vtk = need('vtkmodules.vtkIONetCDF')
    mesh = tetrahedra(meshio, numpy)
    mesh.cell_data.clear()
    mesh.point_data['efield'] = numpy.stack([mesh.point_data['f'], -mesh.point_data['f'], mesh.points[:, 2]], axis=1)
    meshio.write(folder / 'reference.vtu', mesh)
    cells = mesh.cells[0].data[:, [1, 0, 2, 3]]  # turned, as the codes have them
    volumes = numpy.arange(len(cells)) % 2 + 1
    exterior = numpy.arange(len(cells)) % 3 == 0
    with netcdf4.Dataset(folder / 'mesh.ncdf', 'w', format='NETCDF3_64BIT_OFFSET') as file:
        file.createDimension('ncoord', len(mesh.points))
        file.createDimension('three', 3)
        file.createVariable('coords', 'f8', ('ncoord', 'three'))[:] = mesh.points
        for name, width, some in (('interior', 5, ~exterior), ('exterior', 9, exterior)):
            file.createDimension(name, some.sum())
            file.createDimension(name + 'size', width)
            rows = numpy.full((some.sum(), width), -1)
            rows[:, 0], rows[:, 1:5] = volumes[some], cells[some]
            file.createVariable('tetrahedron_' + name, 'i4', (name, name + 'size'))[:] = rows
    with netcdf4.Dataset(folder / 'mode.nc', 'w', format='NETCDF3_CLASSIC') as file:
        file.createDimension('ncoord', len(mesh.points))
        file.createDimension('three', 3)
        file.createVariable('coords', 'f8', ('ncoord', 'three'))[:] = mesh.points
        file.createVariable('frequency', 'f8', ())[...] = 1.3e9
        file.createVariable('efield', 'f8', ('ncoord', 'three'))[:] = mesh.point_data['efield']
    found = info(folder / 'mesh.ncdf', '--solution', folder / 'mode.nc')
    assert found['grid']['cells'] == len(cells) and len(found['blocks']) == 2, found
    same_cut(folder / 'mesh.ncdf', 'point:efield', folder / 'reference.vtu', 'point:efield', '--solution',
             folder / 'mode.nc')
    assert info(folder / 'mesh.ncdf')['arrays'] == []
    reader = vtk.vtkSLACReader()
    reader.SetMeshFileName(str(folder / 'mesh.ncdf'))
    reader.ReadInternalVolumeOn()
    reader.ReadExternalSurfaceOff()
    reader.ReadMidpointsOff()
    reader.Update()
    blocks = reader.GetOutputDataObject(1)
    theirs = sum(blocks.GetBlock(b).GetNumberOfCells() for b in range(blocks.GetNumberOfBlocks()) if blocks.GetBlock(b))
    assert theirs == len(cells), theirs


def write_mfix(numpy, path, shape, widths, coordinates, flags, files, version='01.6', start=0.0):
    """A restart file with two phases of solids, the gas with three species, and files of values: {ending: [(time,
    [values by z, y, x]), ...]}. Records of 512 bytes, in the order of MFIX's write_res0.f."""
    def filled(data):
        return data + bytes(-len(data) % 512)

    def reals(values):
        return filled(numpy.asarray(values, dtype='>f8').tobytes())

    def wholes(values):
        return filled(numpy.asarray(values, dtype='>i4').tobytes())

    nz, ny, nx = shape
    number = float(version)
    phases, kinds, constants, species = 2, 70, 3, [3, 1, 2]
    real, whole = len(reals([0] * kinds)), len(wholes([0] * kinds))
    out = [f'RES = {version}'.encode().ljust(512), bytes(1024)]
    sizes = [2, 2, 2, nx - 2, ny - 2, nz - 2, nx - 1, ny - 1, nz - 1, nx, ny, nz, nx * ny, nx * ny * nz, phases,
             kinds, kinds, constants, kinds]
    out.append(filled(numpy.array(sizes, dtype='>i4').tobytes() + numpy.array([0.01, start] + [0] * 7,
                                                                              dtype='>f8').tobytes()))
    out += [reals([0] * constants), bytes(512 * constants), wholes(species)]
    out += [reals(w) for w in widths]
    out.append(filled(b'bed'.ljust(120) + b'CGS'.ljust(16) + b'NEW'.ljust(16) + coordinates.encode().ljust(16)))
    out += [reals([1] * species[0]), bytes(512 * phases), bytes(512)]
    of_species = sum(species[1:])
    solids = 1 if number >= 1.15 else 0
    out.append(bytes(6 * real + 6 * whole + (3 + 2 * (1 - solids) + species[0] + 3) * real
                     + (phases * (4 + solids) + of_species) * real))
    out.append(bytes(6 * real + 6 * whole + (3 + 2 * (1 - solids) + species[0] + 7) * real
                     + (phases * (6 + solids) + of_species) * real + 512 * kinds))
    out.append(wholes(flags.ravel()))
    out.append(bytes(6 * real + 6 * whole + (2 + phases) * real + 512 * kinds))
    out.append(bytes(1024))
    spx = 11 if number >= 1.5 else 9
    if number >= 1.5:
        out.append(wholes([spx]))
    out.append(bytes(512 * (spx + phases + 1 + 7 + 5) + 2 * real + 512 * kinds + 6 * real))
    out.append(bytes(512 * 4 + (4 + 4 * phases) * real + 512 * 2))
    if number >= 1.15:
        out.append(bytes(512 + (2 + 2 * phases) * real))
    if number >= 1.2:
        out.append(bytes(512))
    if number >= 1.3:
        out += [filled(numpy.array([1], dtype='>i4').tobytes() + bytes(8) + numpy.array([1], dtype='>i4').tobytes()),
                wholes([1])]
    if number >= 1.5:
        out.append(wholes([0]))
    if number >= 1.6:
        out.append(wholes([0]))
    path.write_bytes(b''.join(out))
    for ending, steps in files.items():
        records = len(steps[0][1]) * len(filled(bytes(4 * nx * ny * nz))) // 512 + 1
        out = [bytes(1024), wholes([4 + records * len(steps), records])]
        for time, variables in steps:
            out.append(filled(numpy.array([time], dtype='>f4').tobytes()))
            out += [filled(v.astype('>f4').tobytes()) for v in variables]
        path.with_suffix(ending).write_bytes(b''.join(out))


def mfix(folder):
    numpy, vtk = need('numpy'), need('vtkmodules.vtkIOGeometry')
    shape = (8, 6, 7)  # with the ghosts
    values = lattice(numpy)[:, :1, :1] + numpy.arange(7)[None, None, :] + 10.0 * numpy.arange(6)[None, :, None]
    values = numpy.concatenate([values, values[-2:] + 7], axis=0)[:8]
    flags = numpy.full(shape, 100)
    flags[1:-1, 1:-1, 1:-1] = 1
    flags[3, 2, 4] = 100
    widths = [numpy.full(7, 0.5), numpy.full(6, 1.0), numpy.full(8, 2.0)]
    reference = cells_of_image(folder, values[1:-1, 1:-1, 1:-1], (0.5, 1, 2), (0, 0, 0))
    for version in ('01.6', '01.4', '01.15', '01.14'):
        place = folder / version
        place.mkdir()
        path = place / 'BED.RES'
        steps = [(0.0, [0 * values]), (0.5, [values / 2]), (1.0, [values])]
        pressures = [(0.25, [values, -values]), (0.75, [3 * values, -values])]
        write_mfix(numpy, path, shape, widths, 'CARTESIAN', flags, {'.SP1': steps, '.SP2': pressures}, version)
        found = info(path)
        assert found['times'] == [0.0, 0.25, 0.5, 0.75, 1.0], found['times']
        assert found['grid']['cells'] == 6 * 4 * 5 - 1, found['grid']
        ours = {a['name']: a['range'] for a in found['arrays']}
        assert set(ours) == {'EP_g', 'P_g', 'P_star'}, ours
        a, b = cut(path, 'cell:EP_g'), cut(reference, 'cell:g')
        assert a['max'] <= b['max'] and 0 < b['area'] - a['area'] < 4, (a, b)
        assert near(info(path, '--time', '0.5')['arrays'][0]['range'][1], ours['EP_g'][1] / 2)
        reader = vtk.vtkMFIXReader()
        reader.SetFileName(str(path))
        reader.UpdateInformation()
        for index in range(reader.GetNumberOfCellArrays()):
            reader.SetCellArrayStatus(reader.GetCellArrayName(index), 1)
        reader.SetTimeStep(2)
        reader.Update()
        theirs = reader.GetOutput()
        assert theirs.GetNumberOfCells() == found['grid']['cells'], (version, theirs.GetNumberOfCells())
        assert found['bounds'] == [0.0, 2.5, 0.0, 4.0, 0.0, 12.0], found['bounds']


def mfix_cylinder(folder):
    """All around an axis: the area of a cut across it is that of regular polygons with 24 sides."""
    numpy = need('numpy')
    shape = (26, 5, 6)
    flags = numpy.full(shape, 100)
    flags[1:-1, 1:-1, 1:-1] = 1
    ones = numpy.ones(shape)
    widths = [numpy.full(6, 0.5), numpy.full(5, 1.0), numpy.full(26, 2 * numpy.pi / 24)]
    for start in (0.0, 1.0):
        path = folder / f'PIPE{start:.0f}.RES'
        write_mfix(numpy, path, shape, widths, 'CYLINDRICAL', flags,
                   {'.SP3': [(1.0, [ones, 0 * ones, 0 * ones])]}, start=start)
        sheet = cut(path, 'cell:Gas Velocity', '--normal', '0', '1', '0')
        polygon = 12 * numpy.sin(2 * numpy.pi / 24)
        wanted = polygon * ((start + 2) ** 2 - start ** 2)
        assert near(sheet['area'], wanted), (sheet['area'], wanted)
        found = info(path)
        assert found['length_units'] == 'cm' if 'length_units' in found else True
        assert found['arrays'][0]['components'] == 3, found['arrays']


def lsdyna(folder):
    """Values at nodes in the order that VTK's reader knows from LS-DYNA's own files: places, temperatures, velocities.
    It crashes unless the states are in files of their own."""
    meshio, numpy, vtk = need('meshio'), need('numpy'), need('vtkmodules.vtkIOLSDyna')
    mesh = mixed_mesh(meshio, numpy)
    cells = mesh.cells[0].data
    used, lists = numpy.unique(cells, return_inverse=True)
    points, f, g = mesh.points[used], mesh.point_data['f'][used], mesh.cell_data['g'][0]
    meshio.write(folder / 'reference.vtu', meshio.Mesh(points, [('hexahedron', lists.reshape(-1, 8))],
                                                       point_data={'f': f}, cell_data={'g': [g]}))
    control = numpy.zeros(64, dtype='<i8')
    for word, number in ((11, 1), (15, 4), (16, len(points)), (17, 6), (18, 6), (19, 1), (20, 1), (21, 1),
                         (23, len(cells)), (24, 1), (27, 7), (51, 1)):
        control[word] = number
    control[14:15].view('<f8')[:] = 971.0
    solids = numpy.hstack([lists.reshape(-1, 8) + 1, numpy.ones((len(cells), 1))]).astype('<i8')
    mark = numpy.array([-999999.0]).tobytes()
    (folder / 'd3plot').write_bytes(control.tobytes() + (points - 7).tobytes() + solids.tobytes() + mark)
    velocity = numpy.stack([f, -f, 0.5 * f], axis=1)
    stresses = numpy.hstack([numpy.zeros((len(cells), 6)), g[:, None]])
    for number in (1, 2):
        state = [numpy.array([0.5 * number]), numpy.ones(6), points.ravel(), number / 2 * f, velocity.ravel(),
                 stresses.ravel()]
        (folder / f'd3plot0{number}').write_bytes(numpy.concatenate(state).tobytes() + mark)
    compare(folder / 'd3plot', folder / 'reference.vtu', [('point:temperature', 'point:f'),
                                                          ('cell:plastic strain', 'cell:g')])
    reader = vtk.vtkLSDynaReader()
    reader.SetFileName(str(folder / 'd3plot'))
    reader.UpdateInformation()
    for index in range(reader.GetNumberOfPointArrays()):
        reader.SetPointArrayStatus(reader.GetPointArrayName(index), 1)
    reader.SetTimeStep(1)
    reader.Update()
    theirs = reader.GetOutput().GetBlock(0)
    ours = info(folder / 'd3plot')
    assert [round(x, 9) for x in theirs.GetBounds()] == [round(x, 9) for x in ours['bounds']], theirs.GetBounds()
    ranges = {a['name']: a['range'] for a in ours['arrays']}
    for name, named in (('temperature', 'Temperature'), ('velocity', 'Velocity'), ('displacement', 'Deflection')):
        array = theirs.GetPointData().GetArray(named)
        least, greatest = array.GetRange(-1)
        assert near(least, ranges[name][0]) and near(greatest, ranges[name][1]), (name, least, greatest, ranges[name])


CASES = [converge, fluent_hdf5, fluent_gzip, slac, mfix, mfix_cylinder, lsdyna]
