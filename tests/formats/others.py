#!/usr/bin/env python3
"""Files that other programs write: read, and compared with the same data in a file of VTK or NRRD.

usage: others.py VPROBE [PART-OF-A-NAME]; convert_reference_sets, which takes long, runs by its whole name only

A case whose program or module is missing is left out; exit code 77 where that is all of them.
"""
import importlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import traceback

VPROBE = sys.argv[1]
CUT = ['--classify', 'cpu', '--normal', '0.3', '0.5', '0.81']


SCRATCH = None  # a folder of the case that runs


class Missing(Exception):
    """What a case needs is not installed."""


def need(module):
    try:
        return importlib.import_module(module)
    except ImportError:
        raise Missing(module) from None


def vprobe(*arguments):
    done = subprocess.run([VPROBE, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(f'vprobe {" ".join(map(str, arguments))}: {done.stderr.strip()}')
    return done.stdout


def info(path, *options):
    return json.loads(vprobe('info', path, *options, '--json'))


def cut(path, array, *options):
    out = SCRATCH / 'cut.vtp'
    stats = SCRATCH / 'stats.json'
    named = ['--array', array] if array else []
    vprobe('slice', path, *options, *CUT, *named, '-o', out, '--stats', stats)
    return json.loads(stats.read_text())['sheets'][0]


def near(a, b, tolerance=1e-5):
    return a == b or abs(a - b) <= tolerance * max(abs(a), abs(b), 1e-12)


def compare(path, reference, arrays, options=(), tolerance=1e-5):
    """`arrays`: pairs of a name here and in the reference."""
    ours, wanted = info(path, *options), info(reference)
    for key in ('cells', 'points'):
        assert ours['grid'][key] == wanted['grid'][key], (key, ours['grid'], wanted['grid'])
    for a, b in zip(ours['bounds'], wanted['bounds']):
        assert abs(a - b) < tolerance * 100, (ours['bounds'], wanted['bounds'])
    names = {f'{a["association"]}:{a["name"]}': a for a in ours['arrays']}
    other = {f'{a["association"]}:{a["name"]}': a for a in wanted['arrays']}
    for name, named in arrays:
        assert name in names, (name, sorted(names))
        for a, b in zip(names[name]['range'], other[named]['range']):
            assert near(a, b, tolerance), (name, names[name]['range'], other[named]['range'])
        a, b = cut(path, name, *options), cut(reference, named)
        for key in ('area', 'mean', 'min', 'max'):
            assert near(a[key], b[key], 10 * tolerance), (name, key, a[key], b[key])


# A box of hexahedra beside one of tetrahedra, with values that differ along each axis.
def mixed_mesh(meshio, numpy):
    points, cells, index = [], {'hexahedron': [], 'tetra': []}, {}
    for k in range(5):
        for j in range(4):
            for i in range(6):
                index[i, j, k] = len(points)
                points.append([0.5 * i, 0.25 * j, 2.0 * k + 0.1 * i])
    for k in range(4):
        for j in range(3):
            for i in range(5):
                c = [index[i + a, j + b, k + d] for a, b, d in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                                                                (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
                if i < 3:
                    cells['hexahedron'].append(c)
                else:
                    for t in ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)):
                        cells['tetra'].append([c[n] for n in t])
    points = numpy.array(points)
    f = points @ [1.0, 10.0, 100.0]
    blocks = [(name, numpy.array(lists)) for name, lists in cells.items()]
    g = [f[lists].mean(axis=1) for _, lists in blocks]
    v = numpy.stack([f, -f, 0.5 * f], axis=1)
    return meshio.Mesh(points, blocks, point_data={'f': f, 'v': v}, cell_data={'g': g})


def by_meshio(folder, name, arrays=('point:f', 'point:v', 'cell:g'), mesh=None, **options):
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mesh or mixed_mesh(meshio, numpy)
    reference, path = folder / 'reference.vtu', folder / name
    meshio.write(reference, mesh)
    meshio.write(path, mesh, **options)
    compare(path, reference, [(a, a) for a in arrays])


def gmsh_22_text(folder):
    by_meshio(folder, 'mesh.msh', file_format='gmsh22', binary=False)


def gmsh_22_binary(folder):
    by_meshio(folder, 'mesh.msh', file_format='gmsh22', binary=True)


def by_meshio_41(folder, binary):
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mixed_mesh(meshio, numpy)
    mesh.cells, mesh.cell_data['g'] = mesh.cells[1:], mesh.cell_data['g'][1:]  # meshio writes one type to an entity
    meshio.write(folder / 'reference.vtu', mesh)
    mesh.point_data['gmsh:dim_tags'] = numpy.array([[3, 1]] * len(mesh.points))
    for tag in ('gmsh:physical', 'gmsh:geometrical'):
        mesh.cell_data[tag] = [numpy.ones(len(block.data), dtype='i4') for block in mesh.cells]
    meshio.write(folder / 'mesh.msh', mesh, file_format='gmsh', binary=binary)
    compare(folder / 'mesh.msh', folder / 'reference.vtu', [(a, a) for a in ('point:f', 'point:v', 'cell:g')])


def gmsh_41_text(folder):
    by_meshio_41(folder, False)


def gmsh_41_binary(folder):
    by_meshio_41(folder, True)


GEOMETRY = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 2, 3};
Sphere(2) = {2, 1, 1, 0.8};
Mesh.CharacteristicLengthMax = 0.6;
Mesh.SaveAll = 1;
"""


def by_gmsh(folder, version, binary, order):
    """The same mesh by Gmsh's own writers: .msh, and VTK's legacy format. Their surfaces are left out."""
    if not shutil.which('gmsh'):
        raise Missing('gmsh')
    geometry = folder / 'box.geo'
    geometry.write_text(GEOMETRY)
    command = ['gmsh', '-3', '-order', str(order), str(geometry), '-v', '0']
    extra = ['-bin'] if binary else []
    subprocess.run([*command, '-format', f'msh{version}', *extra, '-o', folder / 'mesh.msh'], check=True)
    subprocess.run([*command, '-format', 'vtk', '-o', folder / 'reference.vtk'], check=True)
    ours, wanted = info(folder / 'mesh.msh'), info(folder / 'reference.vtk')
    assert ours['grid'] == wanted['grid'], (ours['grid'], wanted['grid'])
    a, b = cut(folder / 'mesh.msh', 'cell:gmsh:geometrical'), cut(folder / 'reference.vtk', None)
    assert near(a['area'], b['area'], 1e-6), (a['area'], b['area'])
    assert (a['min'], a['max']) == (1, 2), (a['min'], a['max'])


def gmsh_own(folder):
    for version in (22, 40, 41):
        for binary in (False, True):
            for order in (1, 2):
                if version == 40 and binary:
                    continue  # which gmsh 4.8 itself refuses
                place = folder / f'{version}-{binary}-{order}'
                place.mkdir()
                by_gmsh(place, version, binary, order)


def tecplot(folder):
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mixed_mesh(meshio, numpy)
    mesh.point_data.pop('v')  # meshio leaves vectors out of Tecplot files
    by_meshio(folder, 'mesh.dat', arrays=('point:f', 'cell:g'), mesh=mesh)


def xdmf(folder):
    for form in ('XML', 'HDF', 'Binary'):
        if form == 'HDF':
            need('h5py')
        place = folder / form
        place.mkdir()
        by_meshio(place, 'mesh.xdmf', data_format=form)


def xdmf_series(folder):
    meshio, numpy = need('meshio'), need('numpy')
    need('h5py')
    mesh = mixed_mesh(meshio, numpy)
    here = os.getcwd()
    os.chdir(folder)  # where meshio puts the HDF5 file
    try:
        with meshio.xdmf.TimeSeriesWriter('series.xdmf') as writer:
            writer.write_points_cells(mesh.points, mesh.cells)
            for time in (0.0, 0.5, 2.0):
                writer.write_data(time, point_data={'f': mesh.point_data['f'] * (1 + time)})
    finally:
        os.chdir(here)
    reference = folder / 'reference.vtu'
    meshio.write(reference, mesh)
    assert info(folder / 'series.xdmf')['times'] == [0.0, 0.5, 2.0]
    compare(folder / 'series.xdmf', reference, [('point:f', 'point:f')], ['--time', 'first'])
    top = info(folder / 'series.xdmf')['arrays'][0]['range'][1]
    assert near(top, 3 * mesh.point_data['f'].max()), top


def xdmf_lattice(folder):
    h5py, numpy = need('h5py'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 10 20 30\n')
    with h5py.File(folder / 'data.h5', 'w') as file:
        file['group/f'] = values
    (folder / 'image.xmf').write_text("""<?xml version="1.0" ?>
<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" []>
<Xdmf Version="2.0"><Domain><Grid Name="box" GridType="Uniform">
<Topology TopologyType="3DCoRectMesh" Dimensions="6 4 5"/>
<Geometry GeometryType="ORIGIN_DXDYDZ">
<DataItem Dimensions="3" Format="XML">30 20 10</DataItem><DataItem Dimensions="3" Format="XML">2 1 0.5</DataItem>
</Geometry>
<Attribute Name="f" AttributeType="Scalar" Center="Node">
<DataItem Dimensions="6 4 5" NumberType="Float" Precision="8" Format="HDF">data.h5:/group/f</DataItem>
</Attribute></Grid></Domain></Xdmf>
""")
    compare(folder / 'image.xmf', reference, [('point:f', 'point:f')])


def avs_ucd(folder):
    meshio, numpy = need('meshio'), need('numpy')
    by_meshio(folder, 'mesh.avs', mesh=mixed_mesh(meshio, numpy))


def med(folder):
    need('h5py')
    by_meshio(folder, 'mesh.med')


# The tetrahedra of the mixed mesh alone, with the points that they use.
def tetrahedra(meshio, numpy):
    mesh = mixed_mesh(meshio, numpy)
    used, lists = numpy.unique(mesh.cells[1].data, return_inverse=True)
    return meshio.Mesh(mesh.points[used], [('tetra', lists.reshape(-1, 4))],
                       point_data={'f': mesh.point_data['f'][used]}, cell_data={'g': [mesh.cell_data['g'][1]]})


def gambit(folder):
    """After the GAMBIT User's Guide, appendix C."""
    meshio, numpy = need('meshio'), need('numpy')
    mesh = tetrahedra(meshio, numpy)
    meshio.write(folder / 'reference.vtu', mesh)
    cells = mesh.cells[0].data
    lines = ['        CONTROL INFO 2.4.6', '** GAMBIT NEUTRAL FILE', 'tetrahedra',
             'PROGRAM:                Gambit     VERSION:  2.4.6', ' 1 Jan 2020    12:00:00',
             '     NUMNP     NELEM     NGRPS    NBSETS     NDFCD     NDFVL',
             f'{len(mesh.points):10}{len(cells):10}         2         0         3         3', 'ENDOFSECTION',
             '   NODAL COORDINATES 2.4.6']
    lines += [f'{i + 1:10}{x:20.11e}{y:20.11e}{z:20.11e}' for i, (x, y, z) in enumerate(mesh.points)]
    lines += ['ENDOFSECTION', '      ELEMENTS/CELLS 2.4.6']
    lines += [f'{i + 1:8}  6  4 ' + ''.join(f'{n + 1:8}' for n in cell) for i, cell in enumerate(cells)]
    lines.append('ENDOFSECTION')
    half = len(cells) // 2
    for group, elements in ((1, range(half)), (2, range(half, len(cells)))):
        lines += ['       ELEMENT GROUP 2.4.6',
                  f'GROUP:{group:11} ELEMENTS:{len(elements):11} MATERIAL:{group + 3:11} NFLAGS:          1',
                  f'group {group}', '       0', *(f'{e + 1:8}' for e in elements), 'ENDOFSECTION']
    path = folder / 'mesh.neu'
    path.write_text('\n'.join(lines) + '\n')
    compare(path, folder / 'reference.vtu', [])
    a, b = cut(path, 'cell:Material Type'), cut(folder / 'reference.vtu', 'cell:g')
    assert near(a['area'], b['area'], 1e-6) and (a['min'], a['max']) == (4, 5), (a, b)


def fluent(folder):
    """After the Fluent User's Guide, appendix B: each face once, its corners turning right about the way into c0."""
    meshio, numpy = need('meshio'), need('numpy')
    mesh = tetrahedra(meshio, numpy)
    meshio.write(folder / 'reference.vtu', mesh)
    faces = {}
    for c, cell in enumerate(mesh.cells[0].data):
        a, b, e, tip = mesh.points[cell]
        if numpy.dot(numpy.cross(b - a, e - a), tip - a) < 0:
            cell = cell[[0, 2, 1, 3]]
        for inward in ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)):
            corners = [int(cell[i]) for i in inward]
            faces.setdefault(tuple(sorted(corners)), [corners]).append(c)
    inside = [f for f in faces.values() if len(f) == 3]
    outside = [f for f in faces.values() if len(f) == 2]
    cells = len(mesh.cells[0].data)

    def listed(some):
        return '\n'.join(' '.join(f'{n + 1:x}' for n in f[0]) + f' {f[1] + 1:x} {f[2] + 1 if len(f) == 3 else 0:x}'
                         for f in some)
    nodes = '\n'.join(' '.join(repr(float(x)) for x in point) for point in mesh.points)
    count = len(mesh.points)
    (folder / 'run.cas').write_text(
        f'(0 "tetrahedra")\n(2 3)\n(10 (0 1 {count:x} 0 3))\n(10 (1 1 {count:x} 1 3)(\n{nodes}))\n'
        f'(12 (0 1 {cells:x} 0))\n(12 (2 1 {cells:x} 1 2))\n(13 (0 1 {len(faces):x} 0))\n'
        f'(13 (3 1 {len(inside):x} 2 3)(\n{listed(inside)}))\n'
        f'(13 (4 {len(inside) + 1:x} {len(faces):x} 3 3)(\n{listed(outside)}))\n')
    values = '\n'.join(repr(float(x)) for x in mesh.cell_data['g'][0])
    (folder / 'run.dat').write_text(f'(0 "values")\n(33 ({cells} {len(faces)} {count}))\n'
                                    f'(300 (3 2 1 0 0 1 {cells})(\n{values}))\n')
    compare(folder / 'run.cas', folder / 'reference.vtu', [('cell:TEMPERATURE', 'cell:g')])
    vtk = need('vtkmodules.vtkIOGeometry')  # VTK's reader agrees where it can
    reader = vtk.vtkFLUENTReader()
    reader.SetFileName(str(folder / 'run.cas'))
    reader.Update()
    block = reader.GetOutput().GetBlock(0)
    assert block.GetNumberOfCells() == cells, block
    ours = [a for a in info(folder / 'run.cas')['arrays'] if a['name'] == 'TEMPERATURE'][0]['range']
    theirs = block.GetCellData().GetArray('TEMPERATURE').GetRange()
    assert near(ours[0], theirs[0]) and near(ours[1], theirs[1]), (ours, theirs)


def lattice(numpy):
    z, y, x = numpy.mgrid[0:6, 0:4, 0:5].astype(float)
    return x + 10.0 * y + 100.0 * z


def nrrd(folder, values, about=''):
    path = folder / 'reference.nrrd'
    head = ('NRRD0005\ntype: double\ndimension: 3\nsizes: 5 4 6\ncontent: f\nendian: little\nencoding: raw\n' +
            (about or 'spacings: 1 1 1\naxis mins: 0 0 0\n') + '\n')
    path.write_bytes(head.encode() + values.astype('<f8').tobytes())
    return path


def numpy_arrays(folder):
    numpy = need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values)
    for name, array in {'c': values, 'fortran': numpy.asfortranarray(values.transpose(2, 1, 0)),
                        'single': values.astype('>f4'), 'short': values.astype('i2')}.items():
        numpy.save(folder / f'{name}.npy', array)
        compare(folder / f'{name}.npy', reference, [(f'point:{name}', 'point:f')])
    numpy.savez(folder / 'stored.npz', f=values, half=values / 2, table=numpy.eye(3))
    numpy.savez_compressed(folder / 'packed.npz', f=values, vector=numpy.stack([values] * 3, axis=-1))
    for name in ('stored', 'packed'):
        compare(folder / f'{name}.npz', reference, [('point:f', 'point:f')])
    arrays = {a['name']: a['components'] for a in info(folder / 'packed.npz')['arrays']}
    assert arrays == {'f': 1, 'vector': 3}, arrays


def raw(folder):
    numpy = need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 0 0 0\n')
    (folder / 'big.raw').write_bytes(b'a header' + values.astype('>u2').tobytes())
    compare(folder / 'big.raw', reference, [('point:values', 'point:f')],
            ['--raw-size', '5x4x6', '--raw-type', 'uint16', '--raw-spacing', '0.5x1x2', '--raw-order', 'big'])


def netcdf(folder):
    netcdf4, numpy = need('netCDF4'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 10 20 30\n')
    for form in ('NETCDF3_CLASSIC', 'NETCDF3_64BIT_OFFSET', 'NETCDF4', 'NETCDF4_CLASSIC'):
        path = folder / f'{form}.nc'
        with netcdf4.Dataset(path, 'w', format=form) as file:
            file.Conventions = 'CF-1.8'
            for name, places in (('time', [0.0, 6.0, 12.0]), ('z', 30 + 2.0 * numpy.arange(6)),
                                 ('y', 20 + 1.0 * numpy.arange(4)), ('x', 10 + 0.5 * numpy.arange(5))):
                file.createDimension(name, len(places))
                axis = file.createVariable(name, 'f8', (name,))
                axis[:] = places
                axis.units = 'hours since 2000-01-01' if name == 'time' else 'm'
                axis.axis = name[0].upper()
            packed = file.createVariable('f', 'i2', ('time', 'z', 'y', 'x'), fill_value=-999)
            packed.scale_factor, packed.add_offset, packed.units = 0.5, 10.0, 'K'
            for step in range(3):
                packed[step] = values * (step + 1)
            file.createVariable('surface', 'f4', ('y', 'x'))[:] = 1.0
        found = info(path)
        assert found['times'] == [0.0, 6.0, 12.0], found['times']
        compare(path, reference, [('point:f', 'point:f')], ['--time', 'first'])
        last = info(path)['arrays'][0]['range']
        assert near(last[1], 3 * values.max()), last


def netcdf_fill(folder):
    netcdf4, numpy = need('netCDF4'), need('numpy')
    path = folder / 'holes.nc'
    with netcdf4.Dataset(path, 'w') as file:
        for name, count in (('z', 6), ('y', 4), ('x', 5)):
            file.createDimension(name, count)
        values = file.createVariable('f', 'f4', ('z', 'y', 'x'), fill_value=1e20)
        values[:] = numpy.ma.masked_greater(lattice(numpy), 400)
    found = info(path)['arrays'][0]['range']
    assert found == [0.0, 400.0], found


def zarr(folder):
    netcdf4, numpy = need('netCDF4'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 10 20 30\n')
    for mode, packed in (('zarr', False), ('nczarr', True)):
        path = folder / f'{mode}.zarr'
        try:
            file = netcdf4.Dataset(f'file://{path}#mode={mode},file', 'w')
        except OSError:
            raise Missing('netCDF with Zarr') from None
        for name, places in (('z', 30 + 2.0 * numpy.arange(6)), ('y', 20 + 1.0 * numpy.arange(4)),
                             ('x', 10 + 0.5 * numpy.arange(5))):
            file.createDimension(name, len(places))
            file.createVariable(name, 'f8', (name,))[:] = places
        f = file.createVariable('f', 'f8', ('z', 'y', 'x'), zlib=packed, chunksizes=(3, 4, 5))
        f[:] = values
        f.units = 'K'
        file.close()
        compare(path, reference, [('point:f', 'point:f')])


def netcdf_pop(folder):
    """As the ocean model POP writes: places by longitude and latitude of two dimensions, depths of one."""
    netcdf4, numpy = need('netCDF4'), need('numpy')
    path = folder / 'ocean.pop.nc'
    with netcdf4.Dataset(path, 'w') as file:
        file.Conventions = 'CF-1.0'
        for name, count in (('z_t', 6), ('nlat', 4), ('nlon', 5)):
            file.createDimension(name, count)
        depth = file.createVariable('z_t', 'f4', ('z_t',))
        depth[:], depth.units, depth.positive, depth.axis = 500.0 * numpy.arange(6), 'centimeters', 'down', 'Z'
        j, i = numpy.mgrid[0:4, 0:5].astype(float)
        for name, places, units in (('TLONG', 10 + i + 0.1 * j, 'degrees_east'),
                                    ('TLAT', 50 + j + 0.2 * i, 'degrees_north')):
            axis = file.createVariable(name, 'f8', ('nlat', 'nlon'))
            axis[:], axis.units = places, units
        values = file.createVariable('TEMP', 'f4', ('z_t', 'nlat', 'nlon'), fill_value=9.96921e36)
        values[:] = numpy.ma.masked_greater(lattice(numpy), 500)
        values.coordinates, values.units = 'TLONG TLAT', 'degC'
    found = info(path)
    assert found['grid']['kind'] in ('curvilinear', 'unstructured'), found['grid']
    assert near(found['bounds'][0], 10.0) and near(found['bounds'][1], 14.3), found['bounds']
    temp = [a for a in found['arrays'] if a['name'] == 'TEMP'][0]
    assert temp['range'] == [0.0, 500.0], temp


def tiff(folder):
    tifffile, numpy = need('tifffile'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.25 0.5 2\naxis mins: 0 0 0\n')
    tifffile.imwrite(folder / 'imagej.tif', values.astype('f4'), imagej=True, resolution=(4, 2),
                     metadata={'spacing': 2.0, 'unit': 'um', 'axes': 'ZYX'})
    compare(folder / 'imagej.tif', reference, [('point:values', 'point:f')])
    tifffile.imwrite(folder / 'two.ome.tif', numpy.stack([values, 2 * values])[:, :, None].astype('u2'),
                     metadata={'axes': 'TZCYX', 'PhysicalSizeX': 0.25, 'PhysicalSizeY': 0.5, 'PhysicalSizeZ': 2.0})
    compare(folder / 'two.ome.tif', reference, [('point:values', 'point:f')], ['--time', 'first'])
    assert near(info(folder / 'two.ome.tif')['arrays'][0]['range'][1], 2 * values.max())
    tifffile.imwrite(folder / 'channels.ome.tif', numpy.stack([values, 3 * values], axis=1).astype('f4'),
                     compression='zlib', tile=(16, 16),
                     metadata={'axes': 'ZCYX', 'PhysicalSizeX': 0.25, 'PhysicalSizeY': 0.5, 'PhysicalSizeZ': 2.0})
    compare(folder / 'channels.ome.tif', reference, [('point:channel 0', 'point:f')])
    plain = nrrd(folder, values)
    tifffile.imwrite(folder / 'plain.tif', values.astype('i2'))
    compare(folder / 'plain.tif', plain, [('point:values', 'point:f')])


def mrc(folder):
    mrcfile, numpy = need('mrcfile'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 10 20 30\n')
    for kind in ('f4', 'i2', 'u2'):
        path = folder / f'{kind}.mrc'
        with mrcfile.new(path) as file:
            file.set_data(values.astype(kind))
            file.voxel_size = (0.5, 1.0, 2.0)
            file.header.origin = (10.0, 20.0, 30.0)
        compare(path, reference, [('point:density', 'point:f')])


def dicom(folder):
    pydicom, numpy = need('pydicom'), need('numpy')
    values = lattice(numpy)
    # Rows along x, columns tilted in y and z, as a gantry does.
    row, column = numpy.array([1.0, 0.0, 0.0]), numpy.array([0.0, 0.8, 0.6])
    step = numpy.array([0.0, -0.6, 0.8]) * 2.0
    origin = numpy.array([10.0, 20.0, 30.0])
    directions = ' '.join(f'({a[0]},{a[1]},{a[2]})' for a in (0.5 * row, 1.0 * column, step))
    reference = nrrd(folder, values,
                     f'space: left-posterior-superior\nspace directions: {directions}\nspace origin: (10,20,30)\n')
    series = folder / 'series'
    series.mkdir()
    uid = pydicom.uid.generate_uid()
    for index in (3, 0, 5, 1, 4, 2):
        data = pydicom.dataset.Dataset()
        data.SOPClassUID, data.SOPInstanceUID = pydicom.uid.CTImageStorage, pydicom.uid.generate_uid()
        data.SeriesInstanceUID, data.StudyInstanceUID = uid, pydicom.uid.generate_uid()
        data.Modality, data.InstanceNumber = 'CT', index + 1
        data.Rows, data.Columns, data.SamplesPerPixel = 4, 5, 1
        data.PhotometricInterpretation = 'MONOCHROME2'
        data.BitsAllocated = data.BitsStored = 16
        data.HighBit, data.PixelRepresentation = 15, 0
        data.PixelSpacing, data.SliceThickness = [1.0, 0.5], 5.0
        data.ImageOrientationPatient = [*row, *column]
        data.ImagePositionPatient = [round(float(x), 6) for x in origin + index * step]
        data.RescaleSlope, data.RescaleIntercept = '0.5', '-100'
        data.PixelData = ((values[index] + 100) * 2).astype('<u2').tobytes()
        data.file_meta = pydicom.dataset.FileMetaDataset()
        data.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
        data.file_meta.MediaStorageSOPClassUID = data.SOPClassUID
        data.file_meta.MediaStorageSOPInstanceUID = data.SOPInstanceUID
        data.is_little_endian, data.is_implicit_VR = True, False
        data.save_as(series / f'{index}.dcm', write_like_original=False)
    (series / 'notes.txt').write_text('not an image\n')
    for path in (series, series / '4.dcm'):
        compare(path, reference, [('point:DICOM', 'point:f')])
    (series / '2.dcm').unlink()
    done = subprocess.run([VPROBE, 'info', series], capture_output=True, text=True)
    assert done.returncode == 2 and 'a slice is missing' in done.stderr, done


def reread(path, out, *options):
    """What was converted gives the same figures as what it was made from."""
    vprobe('convert', path, '-o', out, *options)
    arrays = [f'{a["association"]}:{a["name"]}' for a in info(path)['arrays'][:1]]
    compare(out, path, [(a, a) for a in arrays], tolerance=1e-6)


def convert(folder):
    meshio, numpy = need('meshio'), need('numpy')
    mesh = folder / 'mesh.msh'
    meshio.write(mesh, mixed_mesh(meshio, numpy), file_format='gmsh22')
    for ending in ('vtu', 'vtm', 'vtkhdf'):
        reread(mesh, folder / f'mesh.{ending}')
    image = nrrd(folder, lattice(numpy))
    for ending in ('vti', 'vtm', 'vtkhdf'):
        reread(image, folder / f'image.{ending}')
    vprobe('convert', mesh, '-o', folder / 'one.vtu', '--array', 'f')
    assert [a['name'] for a in info(folder / 'one.vtu')['arrays']] == ['f']
    for out, why in (('mesh.vti', 'is written as .vtu'), ('mesh.stl', 'is written as one of'),
                     ('mesh.vtm', 'is there already')):
        done = subprocess.run([VPROBE, 'convert', mesh, '-o', folder / out], capture_output=True, text=True)
        assert done.returncode in (1, 2, 4) and why in done.stderr, done
        assert out == 'mesh.vtm' or not (folder / out).exists()


REFERENCE_SETS = """voxel/ironProt/ironProt.vtk voxel/HeadMRVolume/HeadMRVolume.mhd uniform/carotid/carotid.vtk
rectilinear/RectGrid2/RectGrid2.vtk structured/bluntfin/bluntfinxyz.bin structured/SampleStructGrid/SampleStructGrid.vtk
structured/office/office.binary.vtk multiblock/multi_bin/multi-bin-C.xyz unstructured/hexa/hexa.vtk
unstructured/uGridEx/uGridEx.vtk unstructured/disk_out_ref/disk_out_ref.ex2 unstructured/post_tets/post.vtk
unstructured/box_hybrid/box_hybrid_mesh.vtu polyhedral/pebi3d/pebi3d_with_properties.vtu time/mug/mug.e
voxel/headsq/headsq/quarter.nhdr multiblock/5blocks_struc/5blocks-struc.cgns multiblock/sqnz/sqnz_s.adf.cgns
polyhedral/ensight_nfaced/TEST_bin.case polyhedral/flange/flange.foam
amr/HierarchicalBox/HierarchicalBoxDataset.v1.1.vthb amr/chombo3d/chombo3d.vtm time/can_hdf/can_1.hdf
formats/cavity_foam/case.foam formats/office_ensight/office_bin.case higher-order/notch_disp/notch_disp.vtu""".split()


def convert_reference_sets(folder):
    if 'VPROBE_DATA' not in os.environ:
        raise Missing('VPROBE_DATA')
    for number, name in enumerate(REFERENCE_SETS):
        path = pathlib.Path(os.environ['VPROBE_DATA']) / name
        place = folder / str(number)
        place.mkdir()
        # Beside the link to the set, so that nothing is written there.
        (place / 'set').symlink_to(path.parent)
        link, out = place / 'set' / path.name, place / 'out.vtm'
        try:
            reread(link, out)
        except AssertionError as error:
            raise AssertionError(f'{name}: {error}') from None


CASES = [gmsh_22_text, gmsh_22_binary, gmsh_41_text, gmsh_41_binary, gmsh_own, tecplot, avs_ucd, med,
         gambit, fluent, xdmf, xdmf_series, xdmf_lattice, numpy_arrays, raw, netcdf, netcdf_fill, netcdf_pop, zarr, tiff, mrc, dicom, convert, convert_reference_sets]


def main():
    failed = done = 0
    for case in CASES:
        wanted = sys.argv[2] if len(sys.argv) > 2 else ''
        if wanted not in case.__name__ or case is convert_reference_sets and wanted != case.__name__:
            continue
        with tempfile.TemporaryDirectory(prefix='vprobe-formats-') as folder:
            global SCRATCH
            SCRATCH = pathlib.Path(folder)
            try:
                case(SCRATCH)
                done += 1
                print(f'{case.__name__}: as it should be')
            except Missing as missing:
                print(f'{case.__name__}: left out, {missing} is not installed')
            except Exception as error:  # pylint: disable=broad-except
                if not isinstance(error, AssertionError):
                    traceback.print_exc()
                failed += 1
                print(f'{case.__name__}: FAILED: {error}')
    return 1 if failed else 0 if done else 77


if __name__ == '__main__':
    sys.exit(main())
