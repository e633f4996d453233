"""Arrays that stay in their files: cuts that read only the parts that they meet give what the whole file gives."""
import itertools
import json
import os
import struct
import subprocess

import against
import damage
from against import need, tried, vprobe

PLANES = [('0', '0', '1'), ('0', '1', '0'), ('1', '0', '0'), ('0.3', '0.5', '0.81')]
SIDES = (19, 23, 17)  # along z, y, x
PACKED = '14K'  # room for the parts of a cut, so that each is unpacked once


# Values that differ along each axis and from point to point.
def field(numpy, sides=SIDES, kind='f4'):
    z, y, x = numpy.meshgrid(*(numpy.arange(n) for n in sides), indexing='ij')
    return (1000 * numpy.sin(0.3 * x + 0.2 * y) * numpy.cos(0.25 * z) + 3 * x - 2 * y + z).astype(kind)


def table(path, options):
    out, stats = against.scratch / 'cut.csv', against.scratch / 'stats.json'
    vprobe('slice', path, *options, '--classify', 'cpu', '-o', out, '--stats', stats)
    return out.read_bytes(), json.loads(stats.read_text())


planes_in_turns = itertools.cycle(PLANES)


# `memory`: so little that every array stays in the file. `planes`: if they are not given, calls take turns among all.
def same(path, options=(), stays=True, memory='2K', planes=None):
    if planes is None:
        planes = PLANES if 'VPROBE_LONG' in os.environ else [next(planes_in_turns)]
    for normal in planes:
        plane = [*options, '--normal', *normal]
        whole, there = table(path, plane)
        some, here = table(path, [*plane, '--memory', memory])
        assert whole == some, (path.name, normal, 'the tables differ')
        assert there['parts'] is None, there['parts']
        for sheet, other in zip(here['sheets'], there['sheets']):
            assert sheet == other, (path.name, normal, sheet, other)
        parts = here['parts']
        assert (parts is not None) == stays, (path.name, parts)
        if stays:
            assert 0 < parts['met'] <= parts['all'], parts
            assert parts['met'] <= parts['read'] and parts['bytes_met'] <= parts['bytes_read'], parts


def vtkhdf(path, arrays, extent=None, attributes=None, cells=None, libver=None, userblock=0, **options):
    h5py, numpy = need('h5py'), need('numpy')
    with h5py.File(path, 'w', libver=libver, userblock_size=userblock) as file:
        root = file.create_group('VTKHDF')
        root.attrs['Version'] = numpy.array([1, 0], 'i8')
        root.attrs['Type'] = numpy.bytes_('ImageData')
        sides = next(iter(arrays.values())).shape
        root.attrs['WholeExtent'] = numpy.array(extent or [0, sides[2] - 1, 0, sides[1] - 1, 0, sides[0] - 1], 'i8')
        root.attrs['Origin'], root.attrs['Spacing'] = [1.0, 2.0, 3.0], [0.5, 0.25, 2.0]
        for name, value in (attributes or {}).items():
            root.attrs[name] = value
        for group, each in (('PointData', arrays), ('CellData', cells or {})):
            to = root.create_group(group)
            for name, values in each.items():
                set_ = to.create_dataset(name, data=values, **options)
                for i in range(40):  # so many that the header of the object is continued elsewhere
                    set_.attrs[f'note {i}'] = 'x' * 60
    return path


# The filters' names and numbers, and what packs bytes as they do: by the codecs' own library.
def packers(numcodecs):
    def lz4(data):
        block = numcodecs.lz4.compress(data)[4:]  # without the size that numcodecs puts before it
        return struct.pack('>QIi', len(data), len(data), len(block)) + bytes(block)

    yield 'blosc', 32001, lambda data: numcodecs.blosc.compress(data, b'lz4', 5, 1)
    yield 'lz4', 32004, lz4
    yield 'zstd', 32015, lambda data: numcodecs.zstd.compress(data, 3)


# Writes the chunks of the array f anew, packed by a filter.
def repacked(path, number, pack, libver=None):
    h5py, numpy = need('h5py'), need('numpy')
    with h5py.File(path, 'a', libver=libver) as file:
        values = file['VTKHDF/PointData/f'][()]
        del file['VTKHDF/PointData/f']
        made = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
        made.set_chunk((4, 5, 6))
        made.set_filter(number, h5py.h5z.FLAG_OPTIONAL, ())
        space = h5py.h5s.create_simple(values.shape)
        set_ = h5py.h5d.create(file['VTKHDF/PointData'].id, b'f', h5py.h5t.IEEE_F32LE, space, made)
        for k in range(0, values.shape[0], 4):
            for j in range(0, values.shape[1], 5):
                for i in range(0, values.shape[2], 6):
                    chunk = numpy.zeros((4, 5, 6), 'f4')
                    some = values[k:k + 4, j:j + 5, i:i + 6]
                    chunk[:some.shape[0], :some.shape[1], :some.shape[2]] = some
                    set_.write_direct_chunk((k, j, i), pack(chunk.tobytes()))


# Hand-made: of a plane between two layers of points, the values are the means of the two layers.
def stored_raw(folder):
    numpy = need('numpy')
    values = field(numpy)
    path = folder / 'v.raw'
    path.write_bytes(b'a header' + values.tobytes())
    raw = ['--raw-size', '17x23x19', '--raw-type', 'float32', '--raw-spacing', '0.5x1x2']
    same(path, raw, planes=PLANES)
    _, stats = table(path, [*raw, '--normal', '0', '0', '1', '--origin', '4', '11', '9', '--memory', '2K'])
    between = (values[4].astype('f8') + values[5]) / 2
    sheet = stats['sheets'][0]
    assert abs(sheet['max'] - between.max()) < 1e-6 * abs(between.max()), (sheet['max'], between.max())
    assert abs(sheet['min'] - between.min()) < 1e-6 * abs(between.min()), (sheet['min'], between.min())
    # A layer is 17 x 23 x 4 bytes, one part of less than 16 KiB; two layers are met.
    assert stats['parts'] == {'all': 19, 'met': 2, 'read': stats['parts']['read'], 'kept': 1, 'level': 0,
                              'bytes_met': 2 * 1564, 'bytes_read': 1564 * stats['parts']['read']}, stats['parts']
    for kind, name, order in (('>i2', 'int16', 'big'), ('u1', 'uint8', 'little'), ('>f8', 'float64', 'big')):
        path.write_bytes(field(numpy, kind=kind).tobytes())
        same(path, ['--raw-size', '17x23x19', '--raw-type', name, '--raw-order', order])


# A large array in rows, most of which an oblique plane meets: a line says what would read less.
def stored_rows_across(folder):
    path = folder / 'large.raw'
    with path.open('wb') as file:
        file.truncate(4 * 256 * 280 * 300)  # zeros, without a byte on the disk
    raw = ['--raw-size', '256x280x300', '--raw-type', 'float32', '--stats', folder / 'stats.json']
    for normal, is_told in (('1 0 0', True), ('0 0 1', False)):
        done = subprocess.run([against.VPROBE, 'slice', path, *raw, '--normal', *normal.split()], capture_output=True,
                              encoding='utf-8')
        assert done.returncode == 0 and ('convert' in done.stderr) == is_told, done
        met = json.loads((folder / 'stats.json').read_text())['parts']['met']
        assert (f'reads {met} of ' in done.stderr) == is_told, (met, done.stderr)


def stored_numpy(folder):
    numpy = need('numpy')
    numpy.save(folder / 'a.npy', field(numpy))
    same(folder / 'a.npy')
    numpy.save(folder / 'turned.npy', numpy.asfortranarray(field(numpy, kind='>f4')))
    same(folder / 'turned.npy')
    numpy.save(folder / 'vector.npy', numpy.stack([field(numpy), -field(numpy), 2 * field(numpy)], axis=-1))
    same(folder / 'vector.npy', ['--component', 'magnitude'])


def stored_mrc(folder):
    mrcfile, numpy = need('mrcfile'), need('numpy')
    for kind in ('f4', 'i2', 'u2', 'i1'):
        with mrcfile.new(folder / f'{kind}.mrc', overwrite=True) as file:
            file.set_data(field(numpy, kind=kind))
            file.voxel_size = 1.5
        same(folder / f'{kind}.mrc')


def stored_hdf5(folder):
    h5py, numpy = need('h5py'), need('numpy')
    values = field(numpy)
    same(vtkhdf(folder / 'contiguous.hdf', {'f': values}), planes=PLANES)
    for chunk in ((4, 4, 4), (1, 23, 17), (5, 7, 3), (32, 32, 32), (19, 1, 1)):
        same(vtkhdf(folder / f'chunks{chunk[0]}.hdf', {'f': values}, chunks=chunk if max(chunk) < 32 else True))
    for kind in ('i1', 'u2', '>i4', '>f8'):
        same(vtkhdf(folder / 'kinds.hdf', {'f': field(numpy, kind=kind)}, chunks=(4, 5, 6)), ['--interpolate', 'linear'])
    same(vtkhdf(folder / 'block.hdf', {'f': values}, chunks=(4, 4, 4), userblock=1024), ['--format', 'vtkhdf'])
    vectors = numpy.stack([values, -values, 2 * values], axis=-1)
    same(vtkhdf(folder / 'vectors.hdf', {'v': vectors}, chunks=(4, 4, 4, 3)), ['--component', 'magnitude'])
    same(vtkhdf(folder / 'cells.hdf', {'f': values}, chunks=(4, 4, 4), cells={'c': values[:-1, :-1, :-1] * 3}),
         ['--array', 'cell:c'])
    same(vtkhdf(folder / 'mirror.hdf', {'f': values}, chunks=(4, 4, 4),
                attributes={'Direction': [-1.0, 0, 0, 0, 1, 0, 0, 0, 1]}))
    # A part of the values was never written: they are the fill value.
    with h5py.File(folder / 'fill.hdf', 'w') as file:
        root = file.create_group('VTKHDF')
        root.attrs['Version'], root.attrs['Type'] = numpy.array([1, 0], 'i8'), numpy.bytes_('ImageData')
        root.attrs['WholeExtent'] = numpy.array([0, 16, 0, 22, 0, 18], 'i8')
        root.attrs['Origin'], root.attrs['Spacing'] = [0.0] * 3, [1.0] * 3
        some = root.create_dataset('PointData/f', SIDES, '>f4', chunks=(4, 4, 4), fillvalue=-7.5)
        some[:8, :, 4:] = values[:8, :, 4:]
    same(folder / 'fill.hdf')
    # Packed chunks.
    for name, packing in {'gzip': {'compression': 'gzip'}, 'shuffle': {'compression': 'gzip', 'shuffle': True},
                          'all': {'compression': 'gzip', 'shuffle': True, 'fletcher32': True},
                          'checked': {'fletcher32': True}}.items():
        same(vtkhdf(folder / f'{name}.hdf', {'f': values}, chunks=(4, 5, 6), **packing), memory=PACKED)
        same(vtkhdf(folder / f'{name}2.hdf', {'f': field(numpy, kind='>i2')}, chunks=(4, 5, 7), **packing),
             memory=PACKED)
    # Filters that HDF5 itself does not bring.
    plain, _ = table(vtkhdf(folder / 'plain.hdf', {'f': values}, chunks=(4, 5, 6)), ['--normal', '0.3', '0.5', '0.81'])
    for name, number, pack in packers(need('numcodecs')):
        path = vtkhdf(folder / f'{name}.hdf', {'f': values}, chunks=(4, 5, 6))
        repacked(path, number, pack)
        packed, stats = table(path, ['--normal', '0.3', '0.5', '0.81', '--memory', PACKED])
        assert packed == plain, name
        assert stats['parts'], name
    # Parts of components do not stay in the file.
    same(vtkhdf(folder / 'split.hdf', {'v': vectors}, chunks=(4, 4, 4, 1)), stays=False)
    same(vtkhdf(folder / 'turned.hdf', {'f': values}, chunks=(4, 4, 4),
                attributes={'Direction': [0.0, 1, 0, -1, 0, 0, 0, 0, 1]}), stays=False)


def stored_vtk(folder):
    numpy = need('numpy')
    xml, data, numbers = need('vtkmodules.vtkIOXML'), need('vtkmodules.vtkCommonDataModel'), \
        need('vtkmodules.util.numpy_support')
    values = field(numpy)
    vectors = numpy.stack([values, -values, 2 * values], axis=-1)

    def filled(grid):
        for name, array in (('f', values), ('v', vectors)):
            made = numbers.numpy_to_vtk(array.reshape(-1, *array.shape[3:]), deep=True)
            made.SetName(name)
            grid.GetPointData().AddArray(made)
        made = numbers.numpy_to_vtk(values[:-1, :-1, :-1].astype('i4').ravel(), deep=True)
        made.SetName('c')
        grid.GetCellData().AddArray(made)
        return grid

    image = data.vtkImageData()
    image.SetExtent(2, 18, 0, 22, -3, 15)
    image.SetOrigin(1, 2, 3)
    image.SetSpacing(0.5, -0.25, 2)
    axes = data.vtkRectilinearGrid()
    axes.SetDimensions(17, 23, 19)
    for set_, count in ((axes.SetXCoordinates, 17), (axes.SetYCoordinates, 23), (axes.SetZCoordinates, 19)):
        set_(numbers.numpy_to_vtk(numpy.arange(count) ** 1.5, deep=True))
    for grid, writer, ending in ((image, xml.vtkXMLImageDataWriter(), 'vti'),
                                 (axes, xml.vtkXMLRectilinearGridWriter(), 'vtr')):
        writer.SetInputData(filled(grid))
        for compressed, encoded in ((False, False), (True, False), (False, True)):
            path = folder / f'{ending}{compressed}{encoded}.{ending}'
            writer.SetFileName(str(path))
            (writer.SetCompressorTypeToZLib if compressed else writer.SetCompressorTypeToNone)()
            writer.SetEncodeAppendedData(encoded)
            assert writer.Write()
            for array in ('f', 'v', 'cell:c'):
                same(path, ['--array', array], stays=not compressed and not encoded)


# The data beside the header, or behind it.
def stored_meta(folder):
    numpy, io, data, numbers = need('numpy'), need('vtkmodules.vtkIOImage'), need('vtkmodules.vtkCommonDataModel'), \
        need('vtkmodules.util.numpy_support')
    for kind in ('f4', 'i2', 'u1'):
        image = data.vtkImageData()
        image.SetDimensions(17, 23, 19)
        image.SetSpacing(0.5, 1, 2)
        image.GetPointData().SetScalars(numbers.numpy_to_vtk(field(numpy, kind=kind).ravel(), deep=True))
        for ending in ('mhd', 'mha'):
            writer = io.vtkMetaImageWriter()
            writer.SetInputData(image)
            writer.SetFileName(str(folder / f'{kind}.{ending}'))
            if ending == 'mhd':
                writer.SetRAWFileName(str(folder / f'{kind}.raw'))
            writer.SetCompression(False)
            writer.Write()
            same(folder / f'{kind}.{ending}')


# Zarr 2 by its own library: chunks in files, packed or not, some of them missing, at an index of two more sides.
def stored_zarr(folder):
    numpy, zarr, numcodecs = need('numpy'), need('zarr'), need('numcodecs')
    values = field(numpy)
    ways = {'plain': {'compressor': None}, 'default': {}, 'zstd': {'compressor': numcodecs.Zstd()},
            'delta': {'filters': [numcodecs.Delta(dtype='i4')], 'dtype': 'i4'}, 'fortran': {'order': 'F'},
            'big': {'dtype': '>f8'}, 'half': {'dtype': 'f2'}, 'short': {'dtype': 'u2'},
            'folders': {'dimension_separator': '/'}}
    for name, way in tried(ways.items(), 2):
        array = zarr.open(str(folder / f'{name}.zarr'), mode='w', shape=SIDES, chunks=(5, 7, 6),
                          **{'dtype': 'f4', 'fill_value': 0, **way})
        array[:, :, :] = (values / 8).astype(array.dtype)
        if name in ('plain', 'zstd'):
            (folder / f'{name}.zarr' / '1.2.0').unlink()  # zeros then
        same(folder / f'{name}.zarr', ['--interpolate', 'linear'], memory=PACKED)
    several = zarr.open(str(folder / 'times.zarr'), mode='w', shape=(2, 1, *SIDES), chunks=(1, 1, 5, 7, 6), dtype='f4')
    several[0, 0], several[1, 0] = values, 2 * values
    several.attrs['_ARRAY_DIMENSIONS'] = ['time', 'channel', 'z', 'y', 'x']
    for time in ('first', 'last'):
        same(folder / 'times.zarr', ['--time', time], memory=PACKED)
    # Where whole numbers stand for missing ones, it needs a look at all to know the type.
    for kind, stays in (('f4', True), ('i4', False)):
        marked = zarr.open(str(folder / f'{kind}.zarr'), mode='w', shape=SIDES, chunks=(5, 7, 6), dtype=kind, fill_value=-9)
        marked[:, :, :] = numpy.where(values < -20, -9, values)
        same(folder / f'{kind}.zarr', stays=stays, memory=PACKED)


# netCDF by its own library: what is stored is not what is meant, and axes lie in any order.
def stored_netcdf(folder):
    numpy, netcdf4 = need('numpy'), need('netCDF4')
    sides = {'z': 41, 'y': 53, 'x': 47, 'time': 2}
    values = field(numpy, (41, 53, 47)) / 8
    missing = numpy.abs(values - 40) < 8
    ways = {'plain': ('NETCDF4', 'f4', 'zyx', {}, {}), 'classic': ('NETCDF3_CLASSIC', 'f8', 'zyx', {}, {}),
            'missing': ('NETCDF4', 'f4', 'zyx', {'zlib': True, 'chunksizes': (20, 27, 24)}, {'_FillValue': -9999.0}),
            'packed': ('NETCDF4', 'i2', ('time', *'zyx'), {'zlib': True, 'shuffle': True, 'chunksizes': (1, 41, 10, 47)},
                       {'_FillValue': -32768, 'scale_factor': 0.05, 'add_offset': 3.5}),
            'old': ('NETCDF3_64BIT_OFFSET', 'i2', ('time', *'zyx'), {}, {'missing_value': -32000, 'scale_factor': 0.05}),
            'turned': ('NETCDF4', 'f4', 'xzy', {'chunksizes': (9, 41, 53)}, {'valid_min': -20.0}),
            'together': ('NETCDF4', 'f8', ('time', *'zxy'), {'chunksizes': (2, 5, 6, 7)}, {'_FillValue': 1e30}),
            'whole': ('NETCDF4', 'i4', 'zyx', {}, {}), 'bytes': ('NETCDF4', 'u1', 'yzx', {}, {})}
    for name, (form, kind, order, options, attributes) in tried(ways.items()):
        path = folder / f'{name}.nc'
        with netcdf4.Dataset(path, 'w', format=form) as file:
            for side in order:
                file.createDimension(side, sides[side])
            for axis in 'xyz':
                places = file.createVariable(axis, 'f8', (axis,))
                places.axis = axis.upper()
                places[:] = numpy.arange(sides[axis]) * {'x': 0.5, 'y': -1.0 if name == 'missing' else 1.0, 'z': 2.0}[axis]
            fill = attributes.pop('_FillValue', None)
            made = file.createVariable('v', kind, tuple(order), fill_value=fill, **options)
            made.setncatts(attributes)
            made.set_auto_maskandscale(False)
            mark = fill if fill is not None else attributes.get('missing_value', values[0, 0, 0])
            stored = (values - attributes.get('add_offset', 0.0)) / attributes.get('scale_factor', 1.0)
            stored = numpy.where(missing, mark, abs(stored) if kind == 'u1' else stored).astype(kind)
            turned = numpy.transpose(stored, ['zyx'.index(side) for side in order if side != 'time'])
            made[:] = numpy.stack([turned[::-1], turned]) if 'time' in order else turned
        for time in ([], ['--time', 'first'])[:2 if 'time' in order else 1]:
            same(path, [*time, '--interpolate', 'linear'], stays=name != 'whole', memory='50K' if kind == 'u1' else '200K')


# Rows of plain pages, and the strips and tiles of others, which libtiff unpacks.
def stored_tiff(folder):
    numpy, tifffile = need('numpy'), need('tifffile')
    values = field(numpy)
    ways = {'plain': {}, 'big': {'byteorder': '>', 'bigtiff': True}, 'imagej': {'imagej': True, 'metadata': {'axes': 'ZYX'}}, 'rows': {'rowsperstrip': 5},
            'zlib': {'compression': 'zlib', 'rowsperstrip': 5}, 'whole': {'compression': 'zlib'},
            'tiles': {'tile': (16, 16)}, 'packed': {'tile': (16, 32), 'compression': 'zlib', 'byteorder': '>'},
            'predictor': {'compression': 'zlib', 'predictor': True, 'dtype': 'u2', 'rowsperstrip': 7}}
    for name, way in ways.items():
        kind = way.pop('dtype', 'f4')
        array = numpy.abs(values).astype(kind)
        tifffile.imwrite(folder / f'{name}.tif', array, photometric='minisblack', **way)
        small = PACKED if {'compression', 'tile'} & set(way) else '2K'
        same(folder / f'{name}.tif', ['--interpolate', 'linear'], memory=small)
    for planar in ('contig', 'separate'):
        colors = numpy.stack([values, 2 * values, 3 * values], axis=1 if planar == 'separate' else -1).astype('u1')
        for name, more in (('plain', {}), ('tiles', {'tile': (16, 16)}), ('packed', {'compression': 'zlib'})):
            path = folder / f'{planar}-{name}.tif'
            tifffile.imwrite(path, colors, photometric='rgb', planarconfig=planar, **more)
            same(path, memory='1K')
    both = numpy.stack([numpy.stack([values * (t + 1), values + t], axis=1) for t in range(2)])  # t, z, c, y, x
    for name, more in (('ome', {}), ('ome-packed', {'compression': 'zlib'})):
        path = folder / f'{name}.ome.tif'
        tifffile.imwrite(path, both, ome=True, photometric='minisblack', metadata={'axes': 'TZCYX'}, **more)
        for time in ('#0', '#1'):
            same(path, ['--array', 'channel 1', '--time', time], memory='4K')


def stored_hdf5_steps(folder):
    h5py, numpy = need('h5py'), need('numpy')
    path = folder / 'steps.hdf'
    with h5py.File(path, 'w') as file:
        root = file.create_group('VTKHDF')
        root.attrs['Version'], root.attrs['Type'] = numpy.array([2, 0], 'i8'), numpy.bytes_('ImageData')
        root.attrs['WholeExtent'] = numpy.array([0, 16, 0, 22, 0, 18], 'i8')
        root.attrs['Origin'], root.attrs['Spacing'] = [0.0] * 3, [1.0] * 3
        for name, chunk in (('f', (1, 4, 4, 4)), ('g', None)):
            data = numpy.stack([field(numpy) * (step + 1) for step in range(3)])
            root.create_dataset(f'PointData/{name}', data=data, chunks=chunk)
        steps = root.create_group('Steps')
        steps.attrs['NSteps'] = 3
        steps['Values'] = [0.0, 0.5, 1.0]
    for name in ('f', 'g'):
        for step in ('#0', '#1', 'last'):
            same(path, ['--array', name, '--time', step])
        # A sweep over times keeps its cut, and reads of each time what it meets.
        figures = []
        for more in ([], ['--memory', '2K']):
            vprobe('sweep', path, '--path', 'times', '--array', name, '--normal', '0', '0', '1', '--classify', 'cpu',
                   '--stats', folder / 'sweep.json', *more)
            figures.append(json.loads((folder / 'sweep.json').read_text())['frames'])
        for whole, some in zip(*figures):
            assert whole['sheets'] == some['sheets'] and whole['time'] == some['time'], (whole, some)
            assert whole['parts'] is None and 0 < some['parts']['met'] < some['parts']['all'], some['parts']


XDMF = """<?xml version="1.0"?><Xdmf Version="3.0"><Domain><Grid Name="box">
<Topology TopologyType="{}" Dimensions="19 23 17"/>{}
<Attribute Name="f" Center="Node">{}</Attribute>
<Attribute Name="v" AttributeType="Vector" Center="Node">{}</Attribute>
<Attribute Name="c" Center="Cell">{}</Attribute></Grid></Domain></Xdmf>"""


# The XML by hand, the values by h5py and numpy.
def stored_xdmf(folder):
    h5py, numpy = need('h5py'), need('numpy')
    values = field(numpy)
    arrays = {'f': values, 'v': numpy.stack([values, -values, 2 * values], axis=-1),
              'c': values[:-1, :-1, :-1].astype('>i4')}

    def listed(numbers):
        return f'<DataItem Dimensions="{len(numbers)}" Precision="8">{" ".join(map(str, numbers))}</DataItem>'

    def item(values, place, form, more=''):
        kind = 'Int' if values.dtype.kind == 'i' else 'Float'
        return (f'<DataItem Dimensions="{" ".join(map(str, values.shape))}" NumberType="{kind}" Precision="4" '
                f'Format="{form}" {more}>{place}</DataItem>')

    box = '<Geometry GeometryType="ORIGIN_DXDYDZ">' + listed((3, 2, 1)) + listed((2, 0.5, 0.25)) + '</Geometry>'
    mirrored = box.replace('>2 0.5 0.25<', '>2 -0.5 0.25<')
    axes = ''.join(listed(numpy.round(numpy.arange(n) ** 1.5, 6)) for n in SIDES[::-1])
    turned = ''.join(listed(-numpy.arange(n) * 1.5) for n in SIDES[::-1])
    meshes = [('3DCoRectMesh', box), ('3DCoRectMesh', mirrored),
              *(('3DRectMesh', f'<Geometry GeometryType="VXVYVZ">{each}</Geometry>') for each in (axes, turned))]
    for name, packing in (('plain', {}), ('chunks', {'chunks': True}), ('gzip', {'compression': 'gzip'})):
        with h5py.File(folder / f'{name}.h5', 'w') as file:
            for array, its in arrays.items():
                file.create_dataset(f'data/{array}', data=its, **packing)
        for number, mesh in tried(enumerate(meshes if name == 'plain' else meshes[:1])):
            path = folder / f'{name}{number}.xdmf'
            path.write_text(XDMF.format(*mesh, *(item(its, f'{name}.h5:/data/{array}', 'HDF')
                                                 for array, its in arrays.items())))
            for array in tried(('f', 'v', 'cell:c')):
                same(path, ['--array', array], memory=PACKED if packing else '2K')
    for array, its in arrays.items():
        (folder / f'{array}.bin').write_bytes(b'header' + its.astype('>f4' if array != 'c' else '>i4').tobytes())
    path = folder / 'binary.xmf'
    path.write_text(XDMF.format(*meshes[0], *(item(its, f'{array}.bin', 'Binary', 'Endian="Big" Seek="6"')
                                              for array, its in arrays.items())))
    for array in ('f', 'v', 'cell:c'):
        same(path, ['--array', array])
    # Of a set that was written in part, the rest is the fill value. A set that nobody wrote is refused.
    with h5py.File(folder / 'plain.h5', 'a') as file:
        file['flat'] = values.ravel()
        file.create_dataset('some', SIDES, 'f4', chunks=(4, 4, 4), fillvalue=-7)[:8] = values[:8]
        file.create_dataset('none', SIDES, 'f4', chunks=(4, 4, 4))
    for name, stays in (('some', True), ('flat', False), ('none', None)):
        its = item(values, f'plain.h5:/{name}', 'HDF')
        path = folder / f'{name}.xdmf'
        path.write_text(XDMF.replace('Center="Cell"', 'Center="Node"').format(*meshes[0], its, its, its))
        if stays is None:
            damage.refused(path, 'never written')
        else:
            same(path, ['--array', 'f'], stays=stays)


# What is written layer by layer is read by VTK and h5py as it was, in bricks.
def stored_converted(folder):
    h5py, numpy, zarr = need('h5py'), need('numpy'), need('zarr')
    hdf, numbers = need('vtkmodules.vtkIOHDF'), need('vtkmodules.util.numpy_support')
    values = field(numpy, (50, 70, 33), 'i4')
    raw = ['--raw-size', '33x70x50', '--raw-type', 'int32', '--raw-order', 'big', '--raw-spacing', '0.5x1x2']
    (folder / 'v.raw').write_bytes(values.astype('>i4').tobytes())
    numpy.save(folder / 'v.npy', numpy.stack([values, -values], axis=-1))
    vtkhdf(folder / 'v.hdf', {'f': values}, chunks=(24, 7, 10), compression='gzip', cells={'c': values[1:, 1:, 1:]})
    vtkhdf(folder / 'plain.hdf', {'f': values}, chunks=(5, 70, 33))
    array = zarr.open(str(folder / 'v.zarr'), mode='w', shape=values.shape, chunks=(16, 17, 18), dtype='i4')
    array[:] = values
    missing = values.copy()
    (folder / 'v.zarr' / '1.2.0').unlink()
    missing[16:32, 34:51, :18] = 0
    for name, options, wanted in (('v.raw', raw, values), ('v.npy', [], numpy.stack([values, -values], axis=-1)),
                                  ('v.hdf', [], values), ('plain.hdf', [], values), ('v.zarr', [], missing)):
        out = folder / f'{name}.vtkhdf'
        vprobe('convert', folder / name, *options, '-o', out, '--memory', '2K')
        with h5py.File(out) as file:
            (set_,) = file['VTKHDF/PointData'].values()
            assert (set_[()] == wanted).all() and set_.dtype == wanted.dtype, name
            assert set_.chunks[:3] == (25, 35, 33), (name, set_.chunks)
            if name == 'v.hdf':
                assert (file['VTKHDF/CellData/c'][()] == values[1:, 1:, 1:]).all()
                continue  # VTK 9.1 takes arrays of cells for ones of points
        reader = hdf.vtkHDFReader()
        reader.SetFileName(str(out))
        reader.Update()
        image = reader.GetOutput()
        read = numbers.vtk_to_numpy(image.GetPointData().GetArray(0)).reshape(wanted.shape)
        assert (read == wanted).all() and image.GetDimensions() == (33, 70, 50), name
        if name == 'v.raw':
            assert image.GetSpacing() == (0.5, 1, 2), image.GetSpacing()
        whole, there = table(folder / name, [*options, '--normal', '0.3', '0.5', '0.81', '--interpolate', 'linear'])
        again, here = table(out, ['--normal', '0.3', '0.5', '0.81', '--interpolate', 'linear'])
        assert whole.split(b'\n', 1)[1] == again.split(b'\n', 1)[1], name  # the first line has the array's name
    # A file that ends early gives no file.
    (folder / 'v.raw').write_bytes(values.astype('>i4').tobytes()[:-5])
    done = subprocess.run([against.VPROBE, 'convert', folder / 'v.raw', *raw, '-o', folder / 'short.vtkhdf',
                                  '--memory', '2K'], capture_output=True, encoding='utf-8')
    assert done.returncode == 2 and done.stderr.count('\n') == 1, done
    assert not (folder / 'short.vtkhdf').exists()


# Every option works, whatever of the values it asks for.
def stored_options(folder):
    numpy = need('numpy')
    numpy.save(folder / 'a.npy', field(numpy))
    labels = (field(numpy) > 0).astype('u1') + (field(numpy) > 400).astype('u1')
    numpy.save(folder / 'labels.npy', labels)
    same(folder / 'labels.npy')
    for options in (['--iso', '200'], ['--threshold', '0', '500'], ['--crinkle'], ['--window', '8', '6'],
                    ['--surface', 'sphere:6'], ['--strategy', 'generations'], ['--contour', '100', '--contour-depth', '4']):
        whole, there = table(folder / 'a.npy', options)
        some, here = table(folder / 'a.npy', [*options, '--memory', '2K'])
        assert whole == some, (options, 'the tables differ')
        assert here['sheets'] == there['sheets'] and here['contours'] == there['contours'], options
        assert here['parts'], options


CASES = [stored_raw, stored_rows_across, stored_numpy, stored_mrc, stored_vtk, stored_meta, stored_hdf5, stored_hdf5_steps,
         stored_zarr, stored_netcdf, stored_tiff, stored_xdmf, stored_converted, stored_options]
