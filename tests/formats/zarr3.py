"""Zarr 3 and OME-Zarr. Debian's zarr writes version 2, so this writes version 3 by its specification; zarrita, a reader
of others, says whether it is right (npm install --prefix FOLDER zarrita, VPROBE_ZARRITA=FOLDER)."""
import base64
import itertools
import json
import os
import pathlib
import random
import struct
import subprocess

from against import Missing, compare, info, lattice, need, nrrd, tried
from damage import refused, told
from labels import expect_labels, tissue
from parts import PACKED, PLANES, field, same

TYPES = {'i1': 'int8', 'u1': 'uint8', 'i2': 'int16', 'u2': 'uint16', 'i4': 'int32', 'u4': 'uint32', 'i8': 'int64',
         'u8': 'uint64', 'f2': 'float16', 'f4': 'float32', 'f8': 'float64'}


def crc32c(data):
    total = 0xFFFFFFFF
    for byte in data:
        total ^= byte
        for _ in range(8):
            total = total >> 1 ^ (0x82F63B78 if total & 1 else 0)
    return struct.pack('<I', total ^ 0xFFFFFFFF)


def packed(chunk, codecs):
    """The bytes of a chunk after codecs in the words of zarr.json."""
    numcodecs = need('numcodecs')
    endian = '<'
    for codec in codecs:
        name, how = codec['name'], codec.get('configuration', {})
        if name == 'transpose':
            chunk = chunk.transpose(how['order'])
        elif name == 'bytes':
            endian = '>' if how.get('endian') == 'big' else '<'
            chunk = chunk.astype(chunk.dtype.newbyteorder(endian)).tobytes()
        elif name == 'crc32c':
            chunk = chunk + crc32c(chunk)
        elif name == 'blosc':
            shuffles = {'noshuffle': 0, 'shuffle': 1, 'bitshuffle': 2}
            chunk = numcodecs.Blosc(how['cname'], how['clevel'], shuffles[how['shuffle']]).encode(chunk)
        else:
            known = {'gzip': numcodecs.GZip, 'zstd': numcodecs.Zstd, 'numcodecs.zlib': numcodecs.Zlib,
                     'numcodecs.lz4': numcodecs.LZ4}
            chunk = known[name]().encode(chunk)
    return bytes(chunk)


def pieces(values, sides, fill):
    """The indices and values of all pieces, the last ones filled up."""
    numpy = need('numpy')
    for at in itertools.product(*(range(-(-n // side)) for n, side in zip(values.shape, sides))):
        piece = numpy.full(sides, fill, values.dtype)
        part = values[tuple(slice(i * side, (i + 1) * side) for i, side in zip(at, sides))]
        piece[tuple(slice(n) for n in part.shape)] = part
        yield at, piece


def shard_of(values, chunk, fill, codecs, where, checksum, rng):
    """A shard. Its chunks lie in any order, with gaps, and those of the fill value alone are left out."""
    numpy = need('numpy')
    index, body = [], []
    begin = len(list(pieces(values, chunk, fill))) * 16 + (4 if checksum else 0) if where == 'start' else 0
    every = list(enumerate(piece for _, piece in pieces(values, chunk, fill)))
    rng.shuffle(every)
    places = {}
    for number, piece in every:
        if numpy.array_equal(piece, numpy.full(chunk, fill, values.dtype), equal_nan=values.dtype.kind == 'f'):
            places[number] = (2**64 - 1, 2**64 - 1)
            continue
        data = packed(piece, codecs)
        body.append(b'gap' if rng.random() < 0.2 else b'')
        places[number] = (begin + sum(map(len, body)), len(data))
        body.append(data)
    index = b''.join(struct.pack('<QQ', *places[number]) for number in range(len(every)))
    index += crc32c(index) if checksum else b''
    return index + b''.join(body) if where == 'start' else b''.join(body) + index


def write3(path, values, chunk, shard=None, codecs=(), fill=0, keys=None, names=None, attributes=None, holes=(),
           index='end', checksum=True, seed=1):
    """An array of version 3. `codecs`: those after the bytes; a transpose and the bytes may be among them."""
    path.mkdir(parents=True)
    codecs = list(codecs)
    if not any(codec['name'] == 'bytes' for codec in codecs):
        codecs.insert(0, {'name': 'bytes', 'configuration': {'endian': 'little'}})
    keys = keys or {'name': 'default'}
    separator = keys.get('configuration', {}).get('separator', '/' if keys['name'] == 'default' else '.')
    outer = codecs if shard is None else [{'name': 'sharding_indexed', 'configuration': {
        'chunk_shape': list(chunk), 'codecs': codecs, 'index_location': index, 'index_codecs':
        [{'name': 'bytes', 'configuration': {'endian': 'little'}}] + ([{'name': 'crc32c'}] if checksum else [])}}]
    about = {'zarr_format': 3, 'node_type': 'array', 'shape': list(values.shape),
             'data_type': 'bool' if values.dtype.kind == 'b' else TYPES[values.dtype.str[1:]],
             'chunk_grid': {'name': 'regular', 'configuration': {'chunk_shape': list(shard or chunk)}},
             'chunk_key_encoding': keys, 'fill_value': 'NaN' if fill != fill else fill, 'codecs': outer,
             'attributes': attributes or {}}
    if names:
        about['dimension_names'] = names
    (path / 'zarr.json').write_text(json.dumps(about))
    rng = random.Random(seed)
    for at, piece in pieces(values, shard or chunk, fill):
        if at in holes:
            continue
        name = separator.join(map(str, (['c'] if keys['name'] == 'default' else []) + list(at)))
        (path / name).parent.mkdir(parents=True, exist_ok=True)
        (path / name).write_bytes(shard_of(piece, chunk, fill, codecs, index, checksum, rng) if shard
                                  else packed(piece, codecs))


def group3(path, attributes=None):
    path.mkdir(parents=True, exist_ok=True)
    (path / 'zarr.json').write_text(json.dumps({'zarr_format': 3, 'node_type': 'group', 'attributes': attributes or {}}))


BYTES = {'name': 'bytes', 'configuration': {'endian': 'little'}}
BIG = {'name': 'bytes', 'configuration': {'endian': 'big'}}
GZIP = {'name': 'gzip', 'configuration': {'level': 1}}
ZSTD = {'name': 'zstd', 'configuration': {'level': 0, 'checksum': False}}
BLOSC = {'name': 'blosc', 'configuration': {'cname': 'lz4', 'clevel': 5, 'shuffle': 'shuffle', 'typesize': 4,
                                            'blocksize': 0}}
TURNED = {'name': 'transpose', 'configuration': {'order': [1, 2, 0]}}
FLAT = {'name': 'v2', 'configuration': {'separator': '.'}}
DOTS = {'name': 'default', 'configuration': {'separator': '.'}}
WAYS = {'plain': {}, 'gzip': {'codecs': [GZIP]}, 'zstd': {'codecs': [ZSTD, {'name': 'crc32c'}]},
        'blosc': {'codecs': [BLOSC], 'keys': FLAT}, 'big': {'codecs': [BIG], 'keys': DOTS},
        'turned': {'codecs': [TURNED, BYTES, ZSTD]},
        'lz4': {'codecs': [{'name': 'numcodecs.lz4', 'configuration': {'acceleration': 1}}]},
        'shards': {'shard': (10, 14, 12)}, 'packed shards': {'shard': (20, 7, 18), 'codecs': [ZSTD], 'keys': FLAT},
        'first': {'shard': (10, 28, 6), 'codecs': [BLOSC], 'index': 'start'},
        'unchecked': {'shard': (5, 7, 6), 'checksum': False}}


# What stays in its file is what the whole array gives.
def stored_zarr3(folder):
    numpy = need('numpy')
    values = field(numpy) / 8
    for name, way in tried(WAYS.items()):
        write3(folder / name, values.astype('f4'), (5, 7, 6), **way)
        same(folder / name, ['--interpolate', 'linear'], memory=PACKED, planes=PLANES[3:])
    several = numpy.stack([values, 2 * values])[:, None].astype('f8')
    write3(folder / 'times', several, (1, 1, 5, 7, 6), (1, 1, 10, 14, 12), names=['time', 'channel', 'z', 'y', 'x'])
    for time in ('first', 'last'):
        same(folder / 'times', ['--time', time], memory=PACKED)


# The values are those that were written, of every type, with chunks and shards that are missing.
def zarr3_values(folder):
    numpy = need('numpy')
    values = lattice(numpy)
    for number, (name, way) in tried(enumerate(WAYS.items()), 2):
        sides = (3, 2, 5)
        if 'shard' in way:
            way = {**way, 'shard': tuple(n * side for n, side in zip((1 + number % 2, 2, 1), sides))}
        fill, holes = (7, [(1, 0, 0)]) if number % 2 and 'shard' not in way else (0, [])
        group3(folder / name)
        kinds = list(TYPES)[number % 3::3]
        for kind in kinds:
            write3(folder / name / kind, (values / 4).astype(kind), sides, fill=fill, holes=holes, names=['z', 'y', 'x'],
                   **way)
            expected = (values / 4).astype(kind).astype(float)
            for at in holes:
                expected[tuple(slice(i * n, (i + 1) * n) for i, n in zip(at, sides))] = fill
            found = info(folder / name)
            array = next(array for array in found['arrays'] if array['name'] == kind)
            assert array['range'] == [expected.min(), expected.max()], (name, array)
        compare(folder / name, nrrd(folder, expected), [(f'point:{kinds[-1]}', 'point:f')])
    assert info(folder / 'plain' / 'i1')['grid'] == info(folder / 'plain')['grid']  # an array by itself


# Groups, axes and marks of missing values, as xarray writes them.
def zarr3_conventions(folder):
    numpy = need('numpy')
    values = lattice(numpy).astype('f8')
    marked = values.copy()
    marked[values > 400] = -9
    nine = base64.standard_b64encode(struct.pack('<d', -9)).decode()
    path = folder / 'f.zarr'
    group3(path, {'title': 'all'})
    write3(path / 'f', marked, (3, 2, 5), names=['z', 'y', 'x'], attributes={'units': 'K', '_FillValue': nine})
    for name, places in (('z', 30 + 2.0 * numpy.arange(6)), ('y', 20 + 1.0 * numpy.arange(4)),
                         ('x', 10 + 0.5 * numpy.arange(5))):
        write3(path / name, places, places.shape, names=[name], attributes={'units': 'm', 'axis': name.upper()})
    found = info(path)
    array = found['arrays'][0]
    assert array['range'] == [values.min(), 400], array
    assert found['bounds'] == [10, 12, 20, 23, 30, 40], found['bounds']
    # What a group says of its arrays in one place.
    about = json.loads((path / 'zarr.json').read_text())
    arrays = {name: json.loads((path / name / 'zarr.json').read_text()) for name in 'fzyx'}
    about['consolidated_metadata'] = {'kind': 'inline', 'must_understand': False, 'metadata': arrays}
    (path / 'zarr.json').write_text(json.dumps(about))
    (path / 'f' / 'zarr.json').unlink()
    assert info(path)['arrays'][0]['range'] == [values.min(), 400]
    group3(folder / 'outer.zarr')
    path.rename(folder / 'outer.zarr' / 'inner')
    refused(folder / 'outer.zarr', 'groups alone', 'outer.zarr/inner')


def ome_attributes(axes, levels, version='0.5', channels=(), labels=False):
    about = {'multiscales': [{'axes': axes, 'datasets': [
        {'path': path, 'coordinateTransformations':
         [{'type': 'scale', 'scale': scale}] + ([{'type': 'translation', 'translation': at}] if at else [])}
        for path, scale, at in levels]}]}
    if channels:
        about['omero'] = {'channels': [{'label': label, 'window': {'min': 0, 'max': 9, 'start': 1, 'end': 8}}
                                       for label in channels]}
    if labels:
        about['image-label'] = {}
    return {'ome': {'version': version, **about}} if version == '0.5' else about


# The finest level, its place, units, channels and times. Version 0.4 is written by zarr.
def ome_zarr(folder):
    numpy, zarr = need('numpy'), need('zarr')
    values = lattice(numpy).astype('u2')
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 10 20 30\n')
    both = numpy.stack([numpy.stack([values * (t + 1), values + t]) for t in range(3)])  # t, c, z, y, x
    space = [{'name': name, 'type': 'space', 'unit': 'micrometer'} for name in 'zyx']
    axes = [{'name': 't', 'type': 'time', 'unit': 'second'}, {'name': 'c', 'type': 'channel'}] + space
    scale, at = [5, 1, 2, 1, 0.5], [0, 0, 30, 20, 10]
    levels = [('0', scale, at), ('1', [5, 1, 4, 2, 1], at)]
    for version in ('0.5', '0.4'):
        path = folder / f'{version}.zarr'
        attributes = ome_attributes(axes, levels, version, ('Nuclei', 'Membrane'))
        if version == '0.5':
            group3(path, attributes)
            write3(path / '0', both, (1, 1, 3, 2, 5), (1, 1, 6, 4, 5), codecs=[ZSTD])
            write3(path / '1', both[..., ::2, ::2, ::2], (1, 1, 3, 2, 5))
        else:
            group = zarr.open_group(str(path), mode='w')
            group.array('0', both, chunks=(1, 1, 3, 2, 5), dimension_separator='/')
            group.array('1', both[..., ::2, ::2, ::2], chunks=(1, 1, 3, 2, 5), dimension_separator='/')
            group.attrs.update(attributes)
        found = info(path)
        assert (found['times'], found['length_units'], found['time_units']) == ([0, 5, 10], 'µm', 'second'), found
        assert [array['name'] for array in found['arrays']] == ['Nuclei', 'Membrane'], found['arrays']
        compare(path, reference, [('point:Nuclei', 'point:f'), ('point:Membrane', 'point:f')], ['--time', 'first'])
        last = {array['name']: array['range'][1] for array in info(path, '--time', '#2')['arrays']}
        assert last == {'Nuclei': 3 * values.max(), 'Membrane': values.max() + 2}, last
        assert (found['levels'], found['level'], found['grid']['points']) == (2, 0, 120), found
        same(path, ['--array', 'Membrane', '--time', '#1'], memory='100')
        coarse = info(path, '--level', '1', '--time', 'first')
        assert (coarse['level'], coarse['grid']['points'], coarse['bounds']) == (1, 18, [10, 12, 20, 22, 30, 38]), coarse
        assert coarse['arrays'][0]['range'] == [values[::2, ::2, ::2].min(), values[::2, ::2, ::2].max()]
        refused(path, 'it has levels 0 to 1', options=['--level', '2'])
    refused(reference, 'it has one level', options=['--level', '1'])


def ome_zarr_kinds(folder):
    numpy, zarr = need('numpy'), need('zarr')
    values = lattice(numpy).astype('u1')
    # Version 0.2 gives no axes; a plane has two; labels are told; a window of one channel.
    old = zarr.open_group(str(folder / 'old.zarr'), mode='w')
    old.array('0', values[None, None])
    old.attrs['multiscales'] = [{'version': '0.2', 'datasets': [{'path': '0'}]}]
    assert info(folder / 'old.zarr')['grid']['points'] == values.size
    flat = ome_attributes([{'name': name, 'type': 'space'} for name in 'yx'], [('s0', [2, 3], None)], '0.4')
    group = zarr.open_group(str(folder / 'flat.zarr'), mode='w')
    group.array('s0', values[0])
    group.attrs.update(flat)
    refused(folder / 'flat.zarr', 'no three-dimensional cells')
    axes = [{'name': name, 'type': 'space'} for name in 'zyx']
    group3(folder / 'labels.zarr', ome_attributes(axes, [('0', [1, 1, 1], None)], labels=True))
    write3(folder / 'labels.zarr' / '0', tissue().transpose(2, 1, 0), (8, 8, 8))
    expect_labels(folder / 'labels.zarr')
    group3(folder / 'wide.zarr', {'ome': {'version': '0.5', 'multiscales': [{'axes': axes, 'datasets': [
        {'path': '0', 'coordinateTransformations': [{'type': 'scale', 'scale': [1, 1, 1]}]}],
        'coordinateTransformations': [{'type': 'scale', 'scale': [2, 2, 2]},
                                      {'type': 'translation', 'translation': [1, 1, 1]}]}]}})
    write3(folder / 'wide.zarr' / '0', values, (3, 2, 5))
    # Means of eight, whose place is not told: their edges are those of all, from -0.5 to 3.5, so they lie at 0.5 and 2.5.
    axes_of_means = [('0', [1, 1, 1], None), ('1', [2, 2, 2], None)]
    group3(folder / 'means.zarr', ome_attributes(axes, axes_of_means))
    for level, side in enumerate((4, 2)):
        write3(folder / 'means.zarr' / str(level), numpy.zeros((side,) * 3, 'u1'), (2, 2, 2))
    assert info(folder / 'means.zarr', '--level', '1')['bounds'] == [0.5, 2.5] * 3
    assert info(folder / 'wide.zarr')['bounds'] == [1, 9, 1, 7, 1, 11]  # by hand: 1 + 2 n


def damaged_zarr3(folder):
    numpy = need('numpy')
    values = lattice(numpy)

    def made(name, **way):
        write3(folder / name, values, (3, 2, 5), **way)
        assert isinstance(told(folder / name), dict)
        return folder / name

    def changed(path, change):
        about = json.loads((path / 'zarr.json').read_text())
        change(about)
        (path / 'zarr.json').write_text(json.dumps(about))

    path = made('short', shard=(6, 4, 5))
    shard = path / 'c' / '0' / '0' / '0'
    sound = shard.read_bytes()
    for cut in (b'', sound[:40], sound[-30:]):
        shard.write_bytes(cut)
        refused(path, 'shard c/0/0/0 of short', 'shorter than its index')
    wrong = bytearray(sound)
    wrong[-20] ^= 1
    shard.write_bytes(wrong)
    refused(path, 'checksum')
    path = made('outside', shard=(6, 4, 5), checksum=False)
    shard = path / 'c' / '0' / '0' / '0'
    sound = shard.read_bytes()
    for place in ((2**64 - 8, 240), (0, 2**63), (2**40, 1)):
        shard.write_bytes(sound[:-16] + struct.pack('<QQ', *place))
        refused(path, 'lies outside of it')
    path = made('sum', codecs=[{'name': 'crc32c'}])
    chunk = path / 'c' / '1' / '0' / '0'
    chunk.write_bytes(bytes([chunk.read_bytes()[0] ^ 1]) + chunk.read_bytes()[1:])
    refused(path, 'chunk c/1/0/0 of sum', 'crc32c')
    for name, change, word in (
            ('grid', lambda about: about['chunk_grid'].update(name='rectangular'), 'differ in size'),
            ('codec', lambda about: about['codecs'].append({'name': 'pcodec'}), 'packed by pcodec'),
            ('keys', lambda about: about.update(chunk_key_encoding={'name': 'odd'}), 'cannot be followed'),
            ('more', lambda about: about.update(rotation={'by': 3}), 'asks for an extension'),
            ('later', lambda about: about.update(zarr_format=4), 'version 2 or 3'),
            ('sides', lambda about: about.update(shape=[6, 4]), 'cannot be followed'),
            ('none', lambda about: about['chunk_grid']['configuration'].update(chunk_shape=[0, 2, 5]), 'cannot be')):
        path = made(name)
        changed(path, change)
        refused(path, word)
    path = made('optional')
    changed(path, lambda about: about.update(note={'must_understand': False}, storage_transformers=[]))
    assert isinstance(told(path), dict)
    axes = [{'name': name, 'type': 'space'} for name in 'zyx']
    for name, levels, word in (('out', [('../grid', [1, 1, 1], None)], 'outside of it'),
                               ('gone', [('9', [1, 1, 1], None)], 'is not there'),
                               ('flat', [('0', [1, 0, 1], None)], 'a scale that is not above 0'),
                               ('few', [('0', [1, 1], None)], 'a number for each axis')):
        group3(folder / f'ome-{name}', ome_attributes(axes, levels))
        refused(folder / f'ome-{name}', word)
    for name, shape, word in (('channels', (2**30, 1, 6, 4, 5), 'channels'), ('times', (1, 2**30, 6, 4, 5), 'times')):
        write3(folder / name / '0', numpy.zeros((1, 1, 6, 4, 5), 'f4'), (1, 1, 3, 2, 5))
        changed(folder / name / '0', lambda about: about.update(shape=shape))
        five = [{'name': 'c', 'type': 'channel'}, {'name': 't', 'type': 'time'}] + axes
        group3(folder / name, ome_attributes(five, [('0', [1, 1, 1, 1, 1], None)]))
        refused(folder / name, f'has {2**30} {word}')
    group3(folder / 'plate', {'ome': {'plate': {}}})
    refused(folder / 'plate', 'a plate', 'A/1/0')


ZARRITA = '''
import * as zarr from "zarrita";
import fs from "node:fs";
import { dirname } from "node:path";
const [, , verb, path, ...rest] = process.argv;
// zarrita's own store of files gives some versions of Node numbers that these do not take.
class Files {
  get(key) {
    return fs.existsSync(path + key) ? new Uint8Array(fs.readFileSync(path + key)) : undefined;
  }
  getRange(key, range) {
    const all = this.get(key);
    if (range.suffixLength !== undefined) return all?.slice(all.length - Number(range.suffixLength));
    return all?.slice(Number(range.offset), Number(range.offset) + Number(range.length));
  }
  set(key, value) {
    fs.mkdirSync(dirname(path + key), { recursive: true });
    fs.writeFileSync(path + key, value);
  }
}
const root = zarr.root(new Files());
if (verb === "read") {
  const { data, shape: [nz, ny, nx], stride } = await zarr.get(await zarr.open.v3(root, { kind: "array" }));
  const sorted = new data.constructor(data.length); // it may come with its sides turned
  for (let z = 0, at = 0; z < nz; ++z)
    for (let y = 0; y < ny; ++y)
      for (let x = 0; x < nx; ++x) sorted[at++] = data[z * stride[0] + y * stride[1] + x * stride[2]];
  process.stdout.write(Buffer.from(sorted.buffer));
} else {
  const about = JSON.parse(rest[0]);
  const array = await zarr.create(root, about);
  const type = { float32: Float32Array, int16: Int16Array, float64: Float64Array }[about.dtype];
  const count = about.shape.reduce((a, b) => a * b);
  const data = type.from({ length: count }, (_, i) => i - 50);
  const stride = about.shape.map((_, i) => about.shape.slice(i + 1).reduce((a, b) => a * b, 1));
  await zarr.set(array, null, { data, shape: about.shape, stride });
}
'''


# What zarrita reads is what was written here, and what it writes is read.
def zarr3_of_zarrita(folder):
    numpy = need('numpy')
    where = pathlib.Path(os.environ.get('VPROBE_ZARRITA', '/nonexistent'))
    if not (where / 'node_modules' / 'zarrita').is_dir():
        raise Missing('zarrita (VPROBE_ZARRITA)')
    script = where / 'vprobe.mjs'
    script.write_text(ZARRITA)

    def zarrita(*arguments):
        done = subprocess.run(['node', script, *map(str, arguments)], capture_output=True, check=False)
        assert done.returncode == 0, done.stderr.decode()
        return done.stdout

    values = field(numpy).astype('f4')
    for name, way in WAYS.items():
        if 'index' in way or any(codec['name'].startswith('numcodecs') for codec in way.get('codecs', ())):
            continue  # zarrita does not know an index that comes first, and no codecs of Python's library
        write3(folder / name, values, (5, 7, 6), **way)
        assert zarrita('read', folder / name) == values.tobytes(), name
    for number, codecs in enumerate(([BYTES], [BYTES, BLOSC], [TURNED, BIG, ZSTD])):
        for kind in ('float32', 'int16', 'float64'):
            path = folder / f'theirs{number}{kind}'
            path.mkdir()
            zarrita('write', path, json.dumps({'shape': [6, 4, 5], 'chunkShape': [3, 2, 5], 'dtype': kind,
                                               'codecs': codecs, 'fillValue': 0}))
            reference = nrrd(folder, numpy.arange(-50.0, 70.0).reshape(6, 4, 5))
            compare(path, reference, [(f'point:{path.name}', 'point:f')])


CASES = [stored_zarr3, zarr3_values, zarr3_conventions, ome_zarr, ome_zarr_kinds, damaged_zarr3, zarr3_of_zarrita]
