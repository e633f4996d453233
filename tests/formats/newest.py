"""HDF5 files with the newest kinds of chunk indices: their chunks stay in the file, and HDF5 looks each of them up."""
import ctypes
import itertools
import random
import subprocess

import against
from against import need, tried
from damage import refused
from parts import PACKED, PLANES, SIDES, XDMF, field, packers, repacked, same, table, vtkhdf

CHUNK = (4, 5, 6)
ALL = 5 * 5 * 3  # chunks of SIDES
PACKINGS = {'plain': {}, 'gzip': {'compression': 'gzip'}, 'shuffle': {'compression': 'gzip', 'shuffle': True},
            'checked': {'compression': 'gzip', 'shuffle': True, 'fletcher32': True}}
# What HDF5 makes of these: a fixed array, an extensible one, a version-2 B-tree, and one chunk.
INDICES = {'fixed': {'chunks': CHUNK}, 'extensible': {'chunks': CHUNK, 'maxshape': (None, *SIDES[1:])},
           'tree': {'chunks': CHUNK, 'maxshape': (None,) * 3}, 'single': {'chunks': SIDES}}


def library(h5py):
    """HDF5 as h5py has it, for what h5py leaves out."""
    with open('/proc/self/maps', encoding='utf-8') as maps:
        names = {line.split()[-1] for line in maps if 'libhdf5' in line and '_hl' not in line}
    assert h5py and len(names) == 1, names
    return ctypes.CDLL(names.pop())


def image(file, sides=SIDES):
    numpy = need('numpy')
    root = file.create_group('VTKHDF')
    root.attrs['Version'], root.attrs['Type'] = numpy.array([1, 0], 'i8'), numpy.bytes_('ImageData')
    root.attrs['WholeExtent'] = numpy.array([0, sides[2] - 1, 0, sides[1] - 1, 0, sides[0] - 1], 'i8')
    root.attrs['Origin'], root.attrs['Spacing'] = [0.0] * 3, [1.0] * 3
    return root.create_group('PointData')


def made(h5py, group, name, kind, values, chunk=CHUNK, change=None):
    """A set of the low-level interface. change: of the properties of its creation, before it is made."""
    properties = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
    properties.set_chunk(chunk)
    if change:
        change(properties)
    space = h5py.h5s.create_simple(values.shape)
    return h5py.h5d.create(group.id, name, kind, space, properties)


# Every index with every packing, and what is read of them, counted by hand.
def newest_indices(folder):
    numpy = need('numpy')
    values = field(numpy)
    paths = [vtkhdf(folder / f'{index}-{packing}.hdf', {'f': values}, libver='latest', **how, **more)
             for index, how in INDICES.items() for packing, more in PACKINGS.items()]
    for path in tried(paths, 3):
        same(path, memory=PACKED, planes=PLANES[3:])
    for index in ('fixed', 'tree'):
        path = folder / f'{index}-gzip.hdf'
        # Points are at 1 + i / 2, 2 + j / 4, 3 + 2 k. So these planes are between the layers 3 and 4, and 4 and 5; between
        # the rows 4 and 5; and between the columns 5 and 6. A chunk has 4 layers, 5 rows and 6 columns.
        for normal, origin, met in (('0 0 1', '3 4 10', 2 * 5 * 3), ('0 0 1', '3 4 12', 5 * 3),
                                    ('0 1 0', '3 3.1 9', 2 * 5 * 3), ('1 0 0', '3.75 4 9', 2 * 5 * 5)):
            plane = ['--normal', *normal.split(), '--origin', *origin.split()]
            _, stats = table(path, [*plane, '--memory', PACKED])
            parts = stats['parts']
            assert (parts['all'], parts['met'], parts['bytes_met']) == (ALL, met, met * 4 * 120), (normal, parts)
            assert parts['bytes_read'] == parts['read'] * 4 * 120, parts
        sheet = table(path, ['--normal', '0', '0', '1', '--origin', '3', '4', '12', '--memory', PACKED])[1]['sheets'][0]
        between = (values[4].astype('f8') + values[5]) / 2
        assert abs(sheet['max'] - between.max()) < 1e-6 * abs(between.max()), (sheet['max'], between.max())


def newest_kinds(folder):
    h5py, numpy = need('h5py'), need('numpy')
    values = field(numpy)
    for kind, packing in tried(itertools.product(('i1', 'u2', '>i4', '>f8'), ('plain', 'shuffle')), 3):
        path = vtkhdf(folder / 'kinds.hdf', {'f': field(numpy, kind=kind)}, chunks=CHUNK, libver='latest',
                      **PACKINGS[packing])
        same(path, ['--interpolate', 'linear'], memory='4K', planes=PLANES[3:])
    same(vtkhdf(folder / 'block.hdf', {'f': values}, chunks=CHUNK, userblock=1024, libver='latest'),
         ['--format', 'vtkhdf'], memory=PACKED)
    vectors = numpy.stack([values, -values, 2 * values], axis=-1)
    same(vtkhdf(folder / 'vectors.hdf', {'v w': vectors}, chunks=(*CHUNK, 3), libver='latest'),
         ['--component', 'magnitude'], memory='40K')
    same(vtkhdf(folder / 'split.hdf', {'v': vectors}, chunks=(*CHUNK, 1), libver='latest'), stays=False)
    same(vtkhdf(folder / 'cells.hdf', {'f': values}, chunks=CHUNK, cells={'c': values[:-1, :-1, :-1] * 3},
                libver='latest'), ['--array', 'cell:c'], memory=PACKED)
    # Steps, of which a part's number tells nothing.
    with h5py.File(folder / 'steps.hdf', 'w', libver='latest') as file:
        set_ = image(file).create_dataset('f', data=numpy.stack([values * (step + 1) for step in range(3)]),
                                          chunks=(1, *CHUNK), maxshape=(None, *SIDES), compression='gzip')
        assert set_.chunks[0] == 1
        steps = file['VTKHDF'].create_group('Steps')
        file['VTKHDF'].attrs['Version'] = numpy.array([2, 0], 'i8')
        steps.attrs['NSteps'] = 3
        steps['Values'] = [0.0, 0.5, 1.0]
    for step in ('#0', '#1', 'last'):
        same(folder / 'steps.hdf', ['--time', step], memory=PACKED)
    plain, _ = table(vtkhdf(folder / 'plain.hdf', {'f': values}, chunks=CHUNK), ['--normal', '0.3', '0.5', '0.81'])
    for name, number, pack in packers(need('numcodecs')):
        path = vtkhdf(folder / f'{name}.hdf', {'f': values}, chunks=CHUNK, libver='latest')
        repacked(path, number, pack, 'latest')
        packed, stats = table(path, ['--normal', '0.3', '0.5', '0.81', '--memory', PACKED])
        assert packed == plain and stats['parts'], name


# Chunks that nobody wrote, that some filters did not pack, and edges that none does.
def newest_chunks(folder):
    h5py, numpy = need('h5py'), need('numpy')
    values = field(numpy)
    for name, more in (('fill', {}), ('packed', {'compression': 'gzip'}), ('tree', {'maxshape': (None,) * 3})):
        with h5py.File(folder / f'{name}.hdf', 'w', libver='latest') as file:
            some = image(file).create_dataset('f', SIDES, '>f4', chunks=CHUNK, fillvalue=-7.5, **more)
            some[:8, :, 4:] = values[:8, :, 4:]
        same(folder / f'{name}.hdf', memory=PACKED)
    with h5py.File(folder / 'none.hdf', 'w', libver='latest') as file:
        image(file).create_dataset('f', SIDES, 'f4', chunks=CHUNK)
    refused(folder / 'none.hdf', 'never written')
    libhdf5 = library(h5py)

    def early(properties):
        properties.set_alloc_time(h5py.h5d.ALLOC_TIME_EARLY)  # the implicit index

    def plain_edges(properties):
        properties.set_shuffle()
        properties.set_deflate(6)
        assert libhdf5.H5Pset_chunk_opts(ctypes.c_int64(properties.id), ctypes.c_uint(2)) >= 0

    for name, change in (('implicit', early), ('edges', plain_edges)):
        with h5py.File(folder / f'{name}.hdf', 'w', libver='latest') as file:
            set_ = made(h5py, image(file), b'f', h5py.h5t.IEEE_F32BE, values, change=change)
            set_.write(h5py.h5s.ALL, h5py.h5s.ALL, values)
            sizes = {set_.get_chunk_info(i).size for i in range(set_.get_num_chunks())}
            assert (480 in sizes) and (len(sizes) > 1) == (name == 'edges'), (name, sizes)
        same(folder / f'{name}.hdf', memory=PACKED)
    with h5py.File(folder / 'masks.hdf', 'w', libver='latest') as file:
        set_ = image(file).create_dataset('f', data=values, chunks=CHUNK, compression='gzip', shuffle=True)
        for at in ((0, 0, 0), (4, 5, 6), (8, 10, 12)):  # neither shuffled nor packed
            chunk = numpy.zeros(CHUNK, 'f4')
            some = values[tuple(slice(a, a + n) for a, n in zip(at, CHUNK))]
            chunk[tuple(slice(n) for n in some.shape)] = some
            set_.id.write_direct_chunk(at, chunk.tobytes(), filter_mask=3)
    same(folder / 'masks.hdf', memory=PACKED)


# Lattices of XDMF, sets in another file, and conversion.
def newest_elsewhere(folder):
    h5py, numpy = need('h5py'), need('numpy')
    values = field(numpy)
    with h5py.File(folder / 'data.h5', 'w', libver='latest') as file:
        file.create_dataset('a group/of f', data=values, chunks=CHUNK, compression='gzip')
        file.create_dataset('v', data=numpy.stack([values, -values, 2 * values], axis=-1), chunks=(*CHUNK, 3))
        file.create_dataset('c', data=values[:-1, :-1, :-1].astype('>i4'), chunks=CHUNK)

    def item(path, sides, kind):
        return (f'<DataItem Dimensions="{" ".join(map(str, sides))}" NumberType="{kind}" Precision="4" Format="HDF">'
                f'data.h5:{path}</DataItem>')

    box = ('<Geometry GeometryType="ORIGIN_DXDYDZ"><DataItem Dimensions="3">3 2 1</DataItem>'
           '<DataItem Dimensions="3">2 0.5 0.25</DataItem></Geometry>')
    (folder / 'box.xdmf').write_text(XDMF.format(
        '3DCoRectMesh', box, item('/a group/of f', SIDES, 'Float'), item('/v', (*SIDES, 3), 'Float'),
        item('/c', (SIDES[0] - 1, SIDES[1] - 1, SIDES[2] - 1), 'Int')))
    for array in ('f', 'v', 'cell:c'):
        same(folder / 'box.xdmf', ['--array', array], memory='40K')
    # Links to sets in files of each kind.
    for name, libver, more in (('rows', None, {}), ('old', None, {'chunks': CHUNK}),
                               ('new', 'latest', {'chunks': CHUNK, 'compression': 'gzip'})):
        with h5py.File(folder / f'{name}-data.h5', 'w', libver=libver) as file:
            file.create_dataset('inner', data=values, **more)
        with h5py.File(folder / f'{name}.hdf', 'w') as file:
            image(file)['f'] = h5py.ExternalLink(f'{name}-data.h5', '/inner')
        same(folder / f'{name}.hdf', memory=PACKED)
    path = vtkhdf(folder / 'wide.hdf', {'f': values}, chunks=CHUNK, compression='gzip', libver='latest')
    out = folder / 'out.vtkhdf'
    against.vprobe('convert', path, '-o', out, '--memory', '2K')
    with h5py.File(out) as file:
        assert (file['VTKHDF/PointData/f'][()] == values).all()


# Files that are cut short, or have other bytes somewhere, are refused in a line, or give their values all the same.
def damaged_newest(folder):
    numpy = need('numpy')
    values = field(numpy)
    rng = random.Random(3)
    cut = ['--normal', '0.3', '0.5', '0.81', '--memory', PACKED]
    tries = refusals = 0
    for index, how in INDICES.items():
        path = vtkhdf(folder / f'{index}.hdf', {'f': values}, libver='latest', compression='gzip', fletcher32=True,
                      **how)
        sound, _ = table(path, cut)
        contents = path.read_bytes()
        for number in tried(range(12), 5):
            wrong = bytearray(contents)
            at = rng.randrange(len(contents) if number < 6 else 2000)
            if number % 6 == 5:
                wrong = wrong[:at]
            else:
                wrong[at] ^= 1 << rng.randrange(8)
            path.write_bytes(wrong)
            out = against.scratch / 'damaged.csv'
            done = subprocess.run([against.VPROBE, 'slice', path, *cut, '--classify', 'cpu', '-o', out],
                                  capture_output=True, encoding='utf-8', check=False)
            tries += 1
            refusals += done.returncode != 0
            if done.returncode:
                assert done.returncode == 2 and done.stderr.count('\n') == 1, (index, at, done)
            elif out.read_bytes() != sound:  # what no checksum guards, such as attributes in a heap
                some = out.read_bytes()
                assert table(path, cut[:4])[0] == some, (index, at)
        path.write_bytes(contents)
    assert refusals > (3 if tries > 30 else 0), (refusals, tries)


CASES = [newest_indices, newest_kinds, newest_chunks, newest_elsewhere, damaged_newest]
