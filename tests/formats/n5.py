"""N5, by zarr's own store where that writes it, and by hand after the specification of N5 elsewhere; and OME-Zarr whose
axes are stored in another order than z, y, x."""
import gzip
import itertools
import json
import struct
import subprocess

from against import VPROBE, compare, info, lattice, need, nrrd, tried
from damage import refused, told
from parts import PACKED, PLANES, field, same, table
from zarr3 import BIG, GZIP, TURNED, ZSTD, group3, ome_attributes, write3


def java_lz4(data):
    """As LZ4BlockOutputStream of lz4-java: blocks, the second of which is not packed, and an empty one at the end."""
    lz4 = need('numcodecs').lz4
    half = len(data) // 2
    first = bytes(lz4.compress(data[:half])[4:])
    made = b'LZ4Block' + bytes([0x26]) + struct.pack('<III', len(first), half, 0) + first
    rest = data[half:]
    made += b'LZ4Block' + bytes([0x16]) + struct.pack('<III', len(rest), len(rest), 0) + rest
    return made + b'LZ4Block' + bytes([0x16]) + struct.pack('<III', 0, 0, 0)


def packers():
    numcodecs = need('numcodecs')
    return {'raw': bytes, 'gzip': gzip.compress, 'zstd': lambda data: bytes(numcodecs.zstd.compress(data, 3)),
            'lz4': java_lz4, 'blosc': lambda data: bytes(numcodecs.blosc.compress(data, b'lz4', 5, 1))}


def write5(path, values, block, compression='raw', kind=None, mode=0, crops=True, holes=(), attributes=None):
    """A data set of N5. values and block: the fastest side last; N5 has it first."""
    numpy = need('numpy')
    values = values.astype(kind or values.dtype)
    path.mkdir(parents=True, exist_ok=True)
    (path / 'attributes.json').write_text(json.dumps({
        'n5': '2.5.1', 'dimensions': list(values.shape[::-1]), 'blockSize': list(block[::-1]),
        'dataType': str(values.dtype.name),
        'compression': {'type': compression}, **(attributes or {})}))
    for at in itertools.product(*(range(-(-n // side)) for n, side in zip(values.shape, block))):
        if at in holes:
            continue
        part = values[tuple(slice(i * n, (i + 1) * n) for i, n in zip(at, block))]
        if not crops:
            whole = numpy.zeros(block, values.dtype)
            whole[tuple(slice(n) for n in part.shape)] = part
            part = whole
        head = struct.pack('>HH', mode, len(block)) + struct.pack(f'>{len(block)}I', *part.shape[::-1])
        head += struct.pack('>I', part.size) if mode == 1 else b''
        name = path.joinpath(*map(str, at[::-1]))
        name.parent.mkdir(parents=True, exist_ok=True)
        name.write_bytes(head + packers()[compression](part.astype(part.dtype.newbyteorder('>')).tobytes()))


# What stays in its file is what the whole array gives, and no other blocks are read.
def stored_n5(folder):
    numpy = need('numpy')
    values = field(numpy) / 8
    for name in packers():
        write5(folder / f'{name}.n5', values.astype('f4'), (5, 7, 6), name)
        same(folder / f'{name}.n5', ['--interpolate', 'linear'], memory=PACKED, planes=PLANES[3:])
    # 4 x 4 x 3 blocks, and the plane between the layers 4 and 5 meets two layers of them, that in layer 7 only one.
    # Pixels are 1 apart.
    for at, met in (('4.5', 2 * 4 * 3), ('7', 4 * 3)):
        _, stats = table(folder / 'gzip.n5', ['--normal', '0', '0', '1', '--origin', '8', '11', at, '--memory', PACKED])
        parts = stats['parts']
        assert (parts['all'], parts['met'], parts['bytes_met']) == (4 * 4 * 3, met, met * 4 * 210), parts
        assert parts['bytes_read'] == parts['read'] * 4 * 210, parts
    for number, way in enumerate(({'crops': False}, {'mode': 1}, {'holes': [(1, 2, 0)]}, {'kind': 'i2'})):
        write5(folder / f'{number}.n5', values.astype('f4'), (5, 7, 6), 'gzip', **way)
        same(folder / f'{number}.n5', memory=PACKED)
    # A part may not have more than 256 MiB.
    write5(folder / 'wide.n5', values.astype('f4'), (128, 1024, 1024), 'gzip')
    same(folder / 'wide.n5', stays=False)
    # The file may be named in place of its folder.
    same(folder / 'gzip.n5' / 'attributes.json', memory=PACKED)


def n5_values(folder):
    numpy, zarr, numcodecs = need('numpy'), need('zarr'), need('numcodecs')
    values = lattice(numpy)
    compressors = {'none': None, 'gzip': numcodecs.GZip(), 'zlib': numcodecs.Zlib(), 'blosc': numcodecs.Blosc(),
                   'xz': numcodecs.LZMA(filters=None), 'default': 'default'}
    kinds = ('i1', 'u1', 'i2', 'u2', 'i4', 'u4', 'i8', 'u8', 'f4', 'f8')
    for number, (name, compressor) in enumerate(compressors.items()):
        for kind in tried(kinds[number % 2::2], 3):
            path = folder / f'{name}-{kind}.n5'
            array = zarr.open(zarr.N5Store(str(path)), mode='w', shape=values.shape, chunks=(4, 3, 2), dtype=kind,
                              compressor=compressor)
            array[...] = (values / 4).astype(kind)
            compare(path, nrrd(folder, (values / 4).astype(kind).astype(float)), [('point:values', 'point:f')])
    for name in packers():
        path = folder / f'{name}.n5'
        write5(path, values, (4, 3, 2), name, 'i2', holes=[(1, 0, 0)])
        expected = values.copy()
        expected[4:, :3, :2] = 0
        compare(path, nrrd(folder, expected), [('point:values', 'point:f')])
        found = info(path)['arrays'][0]
        assert (found['type'], found['range']) == ('int16', [0, expected.max()]), found
    old = folder / 'old.n5'
    write5(old, values, (4, 3, 2), 'gzip', attributes={'compression': None, 'compressionType': 'gzip'})
    compare(old, nrrd(folder, values), [('point:values', 'point:f')])
    write5(folder / 'packed.n5', values, (4, 3, 2), attributes={'compression': {'type': 'bzip2'}})
    refused(folder / 'packed.n5', 'packed by bzip2')


# Levels and places as BigDataViewer, Paintera and COSEM write them, counted by hand.
def n5_levels(folder):
    numpy = need('numpy')
    values = lattice(numpy)  # 5, 4 and 6 points along x, y and z

    def group(name, attributes, *levels):
        (folder / name).mkdir()
        (folder / name / 'attributes.json').write_text(json.dumps({'n5': '2.5.1', **attributes}))
        for number, more in enumerate(levels):
            write5(folder / name / f's{number}', values[::2**number, ::2**number, ::2**number], (3, 2, 2), 'gzip',
                   attributes=more)
        return folder / name

    fine, coarse = [0, 2, 0, 3, 0, 10], [0.25, 2.25, 0.5, 2.5, 1, 9]
    resolution = {'pixelResolution': {'dimensions': [0.5, 1, 2], 'unit': 'um'}}
    factors = {'downsamplingFactors': [2, 2, 2]}
    ways = {'viewer': ({}, resolution, {**resolution, **factors}), 'group': (resolution, {}, factors),
            'list': ({**resolution, 'downsamplingFactors': [[1, 1, 1], [2, 2, 2]]}, {}, {}),
            'scales': ({**resolution, 'scales': [[1, 1, 1], [2, 2, 2]]}, {}, {}), 'sizes': (resolution, {}, {}),
            'plain': ({'resolution': [0.5, 1, 2], 'units': ['µm'] * 3}, {}, {}),
            'own': ({}, resolution, {'pixelResolution': {'dimensions': [1, 2, 4], 'unit': 'um'}})}
    for name, (attributes, *levels) in tried(ways.items()):
        path = group(name, attributes, *levels)
        found = [info(path, '--level', str(level)) for level in (0, 1)]
        assert [one['bounds'] for one in found] == [fine, coarse], (name, [one['bounds'] for one in found])
        assert [one['grid']['points'] for one in found] == [120, 18], found
        assert found[1]['arrays'][0]['range'] == [0, values[::2, ::2, ::2].max()], found[1]['arrays']
        assert (found[0]['levels'], found[0]['length_units']) == (2, 'µm'), (name, found[0])
    refused(path, 'it has levels 0 to 1', options=['--level', '2'])
    same(path, ['--level', '1'], memory='100')
    # Paintera has an offset, COSEM the names of the axes as NumPy has the sides.
    path = group('offset', {**resolution, 'offset': [10, 20, 30]}, {}, factors)
    assert info(path, '--level', '1')['bounds'] == [10.25, 12.25, 20.5, 22.5, 31, 39]
    transform = {'axes': ['z', 'y', 'x'], 'units': ['nm'] * 3}
    path = group('cosem', {}, {'transform': {**transform, 'scale': [2, 1, 0.5], 'translate': [30, 20, 10]}},
                 {'transform': {**transform, 'scale': [4, 2, 1], 'translate': [31, 20.5, 10.25]}})
    assert info(path)['bounds'] == [10, 12, 20, 23, 30, 40] and info(path)['length_units'] == 'nm', info(path)
    assert info(path, '--level', '1')['bounds'] == [10.25, 12.25, 20.5, 22.5, 31, 39]
    # Channels and times by their names; other sides are told, and the first is shown.
    both = numpy.stack([numpy.stack([values * (t + 1), values + t]) for t in range(3)])  # t, c, z, y, x
    reference = nrrd(folder, values)
    write5(folder / 'five.n5', both, (1, 1, 3, 2, 2), attributes={'axes': ['x', 'y', 'z', 'c', 't']})
    compare(folder / 'five.n5', reference, [('point:channel 0', 'point:f'), ('point:channel 1', 'point:f')],
            ['--time', 'first'])
    last = {array['name']: array['range'][1] for array in info(folder / 'five.n5', '--time', 'last')['arrays']}
    assert last == {'channel 0': 3 * values.max(), 'channel 1': values.max() + 2}, last
    write5(folder / 'stack.n5', both.swapaxes(1, 2), (1, 3, 1, 2, 2), attributes={'axes': ['x', 'y', 'c', 'z', 't']})
    for time in ('first', 'last'):
        same(folder / 'stack.n5', ['--array', 'channel 1', '--time', time], memory='100')
    write5(folder / 'four.n5', both[0], (1, 3, 2, 2))
    done = subprocess.run([VPROBE, 'info', folder / 'four.n5'], capture_output=True, encoding='utf-8', check=True)
    assert 'of its axis 4 the first of 2 places' in done.stderr, done
    compare(folder / 'four.n5', reference, [('point:values', 'point:f')])
    (folder / 'outer').mkdir()
    (folder / 'cosem').rename(folder / 'outer' / 'inner')
    (folder / 'outer' / 'attributes.json').write_text('{"n5": "2.5.1"}')
    refused(folder / 'outer', 'a group of N5', 'inner')


def damaged_n5(folder):
    numpy = need('numpy')
    values = lattice(numpy)

    def made(name, packing='raw', **attributes):
        write5(folder / name, values, (3, 2, 2), packing, attributes=attributes)
        return folder / name

    for number, head in enumerate((b'', struct.pack('>HHIII', 2, 3, 2, 2, 3), struct.pack('>HHIII', 0, 2, 2, 2, 3),
                                   struct.pack('>HHIII', 0, 3, 2, 2, 2**31), struct.pack('>HHIII', 0, 3, 0, 2, 3),
                                   struct.pack('>HHIII', 1, 3, 2, 2, 3))):
        path = made(f'head{number}.n5')
        (path / '0' / '0' / '0').write_bytes(head)
        refused(path, 'chunk 0/0/0')
    for name in packers():
        path = made(f'short-{name}.n5', name)
        block = path / '1' / '1' / '0'
        block.write_bytes(block.read_bytes()[:-30])
        refused(path, 'chunk 1/1/0')
    for name, attributes, word in (('none', {'blockSize': [0, 2, 3]}, 'cannot be'),
                                   ('sides', {'blockSize': [2, 2]}, 'cannot be followed'),
                                   ('below', {'dimensions': [-5, 4, 6]}, 'cannot be followed'),
                                   ('wide', {'blockSize': [2**40, 2**40, 2**40]}, 'cannot be'),
                                   ('large', {'dimensions': [2**39, 2**39, 2]}, 'more'),
                                   ('kind', {'dataType': 'string'}, 'no numbers'),
                                   ('codec', {'compression': {'type': 'jpeg'}}, 'packed by jpeg'),
                                   ('odd', {'compression': {'type': 3}}, 'cannot be followed'),
                                   ('flat', {'resolution': [1, 0, 1]}, 'not above 0')):
        refused(made(f'{name}.n5', **attributes), word)
    (folder / 'bare').mkdir()
    (folder / 'bare' / 'attributes.json').write_text('{}')
    refused(folder / 'bare', 'without data sets')
    (folder / 'bare' / 'attributes.json').write_text('{"dimensions": [[[')
    refused(folder / 'bare', 'no JSON')
    assert isinstance(told(made('sound.n5')), dict)


# Axes in any order, in whole arrays and in parts of them.
def turned_ome_zarr(folder):
    numpy, zarr = need('numpy'), need('zarr')
    values = lattice(numpy)
    scales = {'z': 2, 'y': 1, 'x': 0.5}
    places = {'z': 30, 'y': 20, 'x': 10}
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 10 20 30\n')
    ways = ({}, {'codecs': [TURNED, BIG, ZSTD]}, {'shard': (6, 8, 10), 'codecs': [GZIP]})
    for order, number in tried(itertools.product(('xyz', 'yxz', 'zxy', 'yzx'), range(3)), 5):
        axes = [{'name': name, 'type': 'space'} for name in order]
        level = [('0', [scales[name] for name in order], [places[name] for name in order])]
        path = folder / f'{order}{number}.zarr'
        group3(path, ome_attributes(axes, level))
        write3(path / '0', values.transpose(['zyx'.index(name) for name in order]), (3, 2, 5), **ways[number])
        compare(path, reference, [('point:values', 'point:f')])
        same(path, memory='600')
    # Version 0.4, with channels as the fastest side, and chunks in the order of Fortran.
    both = numpy.stack([values, values + 7], axis=-1).transpose(2, 1, 0, 3)  # x, y, z, c
    axes = [{'name': name, 'type': 'space'} for name in 'xyz'] + [{'name': 'c', 'type': 'channel'}]
    for order in 'CF':
        group = zarr.open_group(str(folder / f'{order}.zarr'), mode='w')
        group.create_dataset('0', data=both, chunks=(2, 3, 5, 1), order=order, dimension_separator='/')
        group.attrs.update(ome_attributes(axes, [('0', [0.5, 1, 2, 1], [10, 20, 30, 0])], '0.4'))
        compare(folder / f'{order}.zarr', reference, [('point:channel 0', 'point:f')])
        second = info(folder / f'{order}.zarr')['arrays'][1]
        assert second['range'] == [7, values.max() + 7], second
        same(folder / f'{order}.zarr', ['--array', 'channel 1'], memory='600')


CASES = [stored_n5, n5_values, n5_levels, damaged_n5, turned_ome_zarr]
