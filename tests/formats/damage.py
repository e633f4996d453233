"""Packed data that are damaged, within a sound structure: each file is refused in one line, and gives no values."""
import json
import subprocess

import boxes
import codes
import conventions
import meshes
import steps
from against import VPROBE, Missing, lattice, need


def told(path, *options):
    """The figures of a file, or its line where it is refused."""
    done = subprocess.run([VPROBE, 'info', path, *options, '--json'], capture_output=True, encoding='utf-8')
    if done.returncode == 0:
        return json.loads(done.stdout)
    assert done.returncode == 2 and done.stdout == '' and done.stderr.count('\n') == 1, (path, done)
    return done.stderr


def refused(path, *words, options=()):
    line = told(path, *options)
    assert isinstance(line, str), (path, line)
    for word in words:
        assert word in line, (path, word, line)


def sets_of(h5py, file):
    found = []
    file.visititems(lambda name, item: found.append(name) if isinstance(item, h5py.Dataset) else None)
    return found


def repack(h5py, path):
    """Makes each set of numbers one chunk, packed by gzip and with a checksum."""
    contents = path.read_bytes()
    path.unlink()  # others may have it open
    path.write_bytes(contents)
    with h5py.File(path, 'r+') as file:
        for name in sets_of(h5py, file):
            old = file[name]
            if old.dtype.kind not in 'iuf' or old.ndim == 0 or old.size == 0 or old.chunks:
                continue
            values, attributes = old[...], dict(old.attrs.items())
            del file[name]
            made = file.create_dataset(name, data=values, chunks=values.shape, compression='gzip', fletcher32=True)
            made.attrs.update(attributes)


def flip(h5py, path, name):
    """Changes a byte in the middle of the first chunk. False where there is none."""
    with h5py.File(path, 'r') as file:
        chunked = file[name].id
        if file[name].chunks is None or chunked.get_num_chunks() == 0:
            return False
        about = chunked.get_chunk_info(0)
    with open(path, 'r+b') as file:
        file.seek(about.byte_offset + about.size // 2)
        byte = file.read(1)
        file.seek(-1, 1)
        file.write(bytes([byte[0] ^ 0x55]))
    return True


def try_all(main, packed, *options, is_packed=False):
    """Damages each set of a file in turn. What is read makes a refusal, what is not changes no figure."""
    h5py = need('h5py')
    if not is_packed:
        repack(h5py, packed)
    sound = told(main, *options)
    assert isinstance(sound, dict), sound
    original, counted = packed.read_bytes(), 0
    with h5py.File(packed, 'r') as file:
        names = sets_of(h5py, file)
    for name in names[::max(1, len(names) // 6)]:  # each takes a run of the program
        if flip(h5py, packed, name):
            now = told(main, *options)
            assert isinstance(now, str) or now == sound, (packed, name)
            counted += isinstance(now, str)
            packed.write_bytes(original)
    assert counted >= 1, (packed, names)


def damaged_codes(folder):
    for write, main, packed in ((codes.converge, 'turned.h5', 'turned.h5'),
                                (codes.fluent_hdf5, 'run.cas.h5', 'run.cas.h5'),
                                (codes.fluent_hdf5, 'run.cas.h5', 'run.dat.h5'),
                                (boxes.enzo, 'DD0002.hierarchy', 'DD0002.grid0001'),
                                (boxes.flash, 'run_hdf5_plt_cnt_0000', 'run_hdf5_plt_cnt_0000'),
                                (boxes.velodyne, 'run.xamr', 'run.xamr'),
                                (meshes.med, 'mesh.med', 'mesh.med'),
                                (meshes.xdmf_lattice, 'image.xmf', 'data.h5'),
                                (steps.vtkhdf_grids, 'still.vtkhdf', 'still.vtkhdf')):
        place = folder / f'{write.__name__}-{packed}'
        place.mkdir()
        try:
            write(place)
        except Missing as missing:
            print(f'{write.__name__}: left out, {missing} is not installed')
            continue
        try_all(place / main, place / packed)


def damaged_netcdf(folder):
    """Of the netCDF library, and of VTK's reader of Exodus, which reads through it."""
    h5py, netcdf4, numpy = need('h5py'), need('netCDF4'), need('numpy')
    path = folder / 'f.nc'
    packing = {'zlib': True, 'fletcher32': True}
    with netcdf4.Dataset(path, 'w') as file:
        for name, length in zip('zyx', (6, 4, 5)):
            file.createDimension(name, length)
            file.createVariable(name, 'f8', (name,), **packing)[:] = numpy.arange(length)
        for name in ('f', 'g'):
            file.createVariable(name, 'f4', ('z', 'y', 'x'), **packing)[:] = lattice(numpy)
    try_all(path, path, is_packed=True)

    corners = [[1, 2, 4, 3, 5, 6, 8, 7]]
    path = folder / 'f.exo'
    with netcdf4.Dataset(path, 'w') as file:
        file.setncatts({'api_version': numpy.float32(5.1), 'version': numpy.float32(5.1), 'title': 'a',
                        'floating_point_word_size': numpy.int32(8), 'file_size': numpy.int32(1)})
        for name, length in (('len_string', 33), ('len_name', 33), ('time_step', None), ('num_dim', 3),
                             ('num_nodes', 8), ('num_elem', 1), ('num_el_blk', 1), ('num_el_in_blk1', 1),
                             ('num_nod_per_el1', 8), ('num_nod_var', 1), ('num_elem_var', 1)):
            file.createDimension(name, length)
        for axis, name in enumerate('xyz'):
            file.createVariable(f'coord{name}', 'f8', ('num_nodes',), **packing)[:] = numpy.arange(8) >> axis & 1
        file.createVariable('eb_status', 'i4', ('num_el_blk',), **packing)[:] = 1
        file.createVariable('eb_prop1', 'i4', ('num_el_blk',), **packing)[:] = 1
        file['eb_prop1'].setncattr('name', 'ID')
        file.createVariable('connect1', 'i4', ('num_el_in_blk1', 'num_nod_per_el1'), **packing)[:] = corners
        file['connect1'].elem_type = 'HEX8'
        for kind, name in (('nod', 'u'), ('elem', 'p')):
            names = file.createVariable(f'name_{kind}_var', 'S1', (f'num_{kind}_var', 'len_name'))
            names[0, :] = numpy.array(list(name.ljust(33, '\0')), 'S1')
        file.createVariable('time_whole', 'f8', ('time_step',), **packing)[:] = [0.0, 1.0]
        file.createVariable('vals_nod_var1', 'f8', ('time_step', 'num_nodes'), **packing)[:] = \
            numpy.arange(16).reshape(2, 8)
        file.createVariable('vals_elem_var1eb1', 'f8', ('time_step', 'num_el_in_blk1'), **packing)[:] = [[3], [4]]
    try_all(path, path, is_packed=True)


def damaged_cgns(folder):
    """CGNS in HDF5 as meshio writes it."""
    meshio, numpy = need('meshio'), need('numpy')
    need('h5py')
    mesh = meshes.tetrahedra(meshio, numpy)
    meshio.write(folder / 'mesh.cgns', meshio.Mesh(mesh.points, mesh.cells))
    if isinstance(told(folder / 'mesh.cgns'), dict):
        try_all(folder / 'mesh.cgns', folder / 'mesh.cgns')


def damaged_zarr(folder):
    numpy, zarr, numcodecs = need('numpy'), need('zarr'), need('numcodecs')
    for packing in (numcodecs.Blosc(), numcodecs.Zlib(), numcodecs.GZip(), numcodecs.Zstd(), numcodecs.LZ4(),
                    numcodecs.LZMA()):
        group = zarr.open_group(str(folder / 'f.zarr'), mode='w')
        group.array('f', lattice(numpy), chunks=(3, 4, 5), compressor=packing)
        assert isinstance(told(folder / 'f.zarr'), dict)
        chunk = folder / 'f.zarr' / 'f' / '1.0.0'
        sound = chunk.read_bytes()
        for short in (sound[:len(sound) // 2], b''):
            chunk.write_bytes(short)
            refused(folder / 'f.zarr', 'chunk 1.0.0 of f', packing.codec_id)
    group.array('g', numpy.ones((6, 4, 5)), filters=[numcodecs.Shuffle(8), numcodecs.CRC32()], compressor=None)
    sound = bytearray((folder / 'f.zarr' / 'g' / '0.0.0').read_bytes())
    sound[100] ^= 1
    (folder / 'f.zarr' / 'g' / '0.0.0').write_bytes(sound)
    refused(folder / 'f.zarr', 'chunk')
    group = zarr.open_group(str(folder / 'odd.zarr'), mode='w')
    group.array('f', lattice(numpy), compressor=numcodecs.BZ2())
    refused(folder / 'odd.zarr', 'packed by bz2', 'compressor')
    group = zarr.open_group(str(folder / 'none.zarr'), mode='w')
    made = group.create('f', shape=(6, 4, 5), chunks=(3, 4, 5), dtype='i4', fill_value=None)
    made[:3] = 1
    refused(folder / 'none.zarr', 'chunks of f are missing')


def missing_parts(folder):
    """Values in other files, which HDF5 takes for zeros where they are missing."""
    h5py, numpy = need('h5py'), need('numpy')
    values = lattice(numpy)

    def write_xdmf(name):
        (folder / f'{name}.xmf').write_text(f'''<Xdmf Version="2.0"><Domain><Grid Name="box">
<Topology TopologyType="3DCoRectMesh" Dimensions="6 4 5"/><Geometry GeometryType="ORIGIN_DXDYDZ">
<DataItem Dimensions="3" Format="XML">0 0 0</DataItem><DataItem Dimensions="3" Format="XML">1 1 1</DataItem></Geometry>
<Attribute Name="f" Center="Node"><DataItem Dimensions="6 4 5" NumberType="Float" Precision="8"
Format="HDF">{name}.h5:/f</DataItem></Attribute></Grid></Domain></Xdmf>''')
        return folder / f'{name}.xmf'

    raw = folder / 'values.raw'
    raw.write_bytes(values.astype('<f8').tobytes())
    with h5py.File(folder / 'external.h5', 'w') as file:
        file.create_dataset('f', shape=values.shape, dtype='<f8', external=[('values.raw', 0, values.nbytes)])
    external = write_xdmf('external')
    assert told(external)['arrays'][0]['range'] == [values.min(), values.max()]
    raw.write_bytes(raw.read_bytes()[:-8])
    refused(external, 'values.raw', 'ends before')
    raw.unlink()
    refused(external, 'values.raw', 'keep the files together')

    with h5py.File(folder / 'source.h5', 'w') as file:
        file['g'] = values
    with h5py.File(folder / 'virtual.h5', 'w') as file:
        layout = h5py.VirtualLayout(values.shape, 'f8')
        layout[...] = h5py.VirtualSource('source.h5', 'g', values.shape)
        file.create_virtual_dataset('f', layout)
    virtual = write_xdmf('virtual')
    assert told(virtual)['arrays'][0]['range'] == [values.min(), values.max()]
    (folder / 'source.h5').unlink()
    refused(virtual, 'source.h5', 'keep the files together')

    with h5py.File(folder / 'filter.h5', 'w') as file:
        file.create_dataset('f', data=values, compression='lzf')
    refused(write_xdmf('filter'), 'lzf', 'h5repack')


def same_names(folder):
    """Both of two arrays of one name are shown."""
    numpy = need('numpy')
    numbers = ' '.join(map(str, range(8)))
    attribute = f'<Attribute Name="f" Center="Node"><DataItem Dimensions="2 2 2">{numbers}</DataItem></Attribute>'
    path = folder / 'two.xmf'
    path.write_text(f'''<Xdmf Version="2.0"><Domain><Grid Name="box">
<Topology TopologyType="3DCoRectMesh" Dimensions="2 2 2"/><Geometry GeometryType="ORIGIN_DXDYDZ">
<DataItem Dimensions="3">0 0 0</DataItem><DataItem Dimensions="3">1 1 1</DataItem></Geometry>
{attribute}{attribute.replace(numbers, numbers[::-1])}</Grid></Domain></Xdmf>''')
    found = told(path)
    assert sorted(a['name'] for a in found['arrays']) == ['f', 'f 2'], found['arrays']
    assert 'two arrays are called f' in conventions.noted(path)
    assert numpy.all([a['range'] == [0, 7] for a in found['arrays']])


def fluent_pieces(folder):
    """What a case or its data file lacks, or has twice, never goes without a word."""
    need('meshio')
    meshes.fluent(folder)
    case, data = (folder / 'run.cas').read_text(), (folder / 'run.dat').read_text()
    sound = told(folder / 'run.cas')
    cells, nodes = sound['grid']['cells'], sound['grid']['points']

    def try_case(case, data=data):
        (folder / 'run.cas').write_text(case)
        (folder / 'run.dat').write_text(data)
        return folder / 'run.cas'

    rows = case.split('\n')
    first = next(i for i, row in enumerate(rows) if row.startswith('(10 (1 1')) + 1
    half = nodes // 2
    parts = [f'(10 (9 {a + 1:x} {b:x} 1 3)(\n' + '\n'.join(rows[first + a:first + b]).rstrip(')') + '))'
             for a, b in ((half, nodes), (0, half))]
    turned = '\n'.join(rows[:first - 1] + parts + rows[first + nodes:])
    assert told(try_case(turned)) == sound  # zones of nodes in the other order
    refused(try_case('\n'.join(rows[:first - 1] + parts[:1] + rows[first + nodes:])), 'zones of nodes')
    refused(try_case(case[:case.index('(13 (4 ')]), 'faces')
    refused(try_case(case.replace(f'(12 (2 1 {cells:x} ', f'(12 (2 1 {cells - 1:x} ')), 'zones have')
    refused(try_case(case.replace('))\n(12', '\n1.5))\n(12')), 'longer than it announces')
    refused(try_case(case, data.replace('))', '\n7))')), 'longer than it announces')
    refused(try_case(case, data.replace(f' 0 0 1 {cells})', f' 0 0 2 {cells + 1})')), 'not in their zone')

    few = f'(0 "values")\n(300 (3 2 1 0 0 1 2)(\n7 8))\n(300 (3 2 1 0 0 2 3)(\n5 6))\n'
    path = try_case(case, few)
    ranges = {a['name']: a['range'] for a in told(path)['arrays']}
    assert ranges == {'TEMPERATURE': [7, 8], 'TEMPERATURE 2': [5, 6]}, ranges
    line = conventions.noted(path)
    assert 'several arrays of one name' in line and 'values of some cells alone' in line, line
    assert 'holds no values at cells' in conventions.noted(try_case(case, '(0 "nothing")\n'))


def gambit_groups(folder):
    meshes.gambit(folder)
    path = folder / 'mesh.neu'
    text = path.read_text()
    path.write_text(text.replace('         2         0         3         3', '         1         0         3         3'))
    refused(path, 'more groups than it announces')
    head, groups = text[:text.index('       ELEMENT GROUP')], text.split('       ELEMENT GROUP')[1:]
    last = groups[0].split('\n')[-3]  # the last element of the first group
    rows = groups[1].split('\n')
    rows[4] = last
    path.write_text('       ELEMENT GROUP'.join([head, groups[0], '\n'.join(rows)]))
    assert '1 of its elements are in several groups' in conventions.noted(path), conventions.noted(path)


def mfix_times(folder):
    """Of a run that was started again a time is there twice, and the later one counts; others are told."""
    numpy = need('numpy')
    ones = numpy.ones((5, 5, 5))
    flags = numpy.full(ones.shape, 100)
    flags[1:-1, 1:-1, 1:-1] = 1
    path = folder / 'BED.RES'
    steps = [(0.0, [ones]), (1.0, [2 * ones]), (0.5, [3 * ones]), (1.0, [4 * ones]), (2.0, [5 * ones])]
    codes.write_mfix(numpy, path, ones.shape, [numpy.full(5, 1.0)] * 3, 'CARTESIAN', flags,
                     {'.SP1': steps, '.SP6': [(1.5, [6 * ones, ones, ones])]})
    found = told(path)
    assert found['times'] == [0, 0.5, 1, 1.5, 2] and found.get('time_units', 's') == 's', found
    for time, gas in (('0', 1), ('0.5', 3), ('1', 4), ('#4', 5)):
        ranges = {a['name']: a['range'][0] for a in told(path, '--time', time)['arrays']}
        assert ranges['EP_g'] == gas and ranges['T_g'] == 6, (time, ranges)
    assert 'T_g of 1.5' in conventions.noted(path)
    (folder / 'BED.SP6').write_bytes(b'\0' * 1024 + numpy.array([4, 4], '>i4').tobytes().ljust(512, b'\0'))
    assert 'no time was written to its .SP6' in conventions.noted(path), conventions.noted(path)


def converge_places(folder):
    """A list of coordinates that is shorter than the others, whichever it is."""
    h5py = need('h5py')
    codes.converge(folder)
    path = folder / 'turned.h5'
    for axis in 'XYZ':
        with h5py.File(path, 'r+') as file:
            name = f'STREAM_00/VERTEX_COORDINATES/{axis}'
            whole = file[name][:]
            del file[name]
            file[name] = whole[:-1]
        refused(path, 'not as many coordinates')
        with h5py.File(path, 'r+') as file:
            del file[name]
            file[name] = whole
    assert isinstance(told(path), dict)


def slac_meshes(folder):
    """VTK's reader takes ids as they come, and zeros for what a short file lacks."""
    netcdf4 = need('netCDF4')
    codes.slac(folder)
    mesh, modes = folder / 'mesh.ncdf', folder / 'mode.nc'
    for path in (mesh, modes):
        whole = path.read_bytes()
        path.write_bytes(whole[:len(whole) * 9 // 10])
        refused(mesh, 'bytes where its header asks for', options=('--solution', modes))
        path.write_bytes(whole)
    for name in ('tetrahedron_interior', 'tetrahedron_exterior'):
        for point in (60, -7):
            with netcdf4.Dataset(mesh, 'r+') as file:
                before = int(file[name][3, 2])
                file[name][3, 2] = point
            refused(mesh, f'point {point} of 60', options=('--solution', modes))
            with netcdf4.Dataset(mesh, 'r+') as file:
                file[name][3, 2] = before
    assert isinstance(told(mesh, '--solution', modes), dict)


CASES = [slac_meshes, converge_places, fluent_pieces, gambit_groups, mfix_times, damaged_codes, damaged_netcdf,
         damaged_cgns, damaged_zarr, missing_parts, same_names]
