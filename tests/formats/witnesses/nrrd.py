#!/usr/bin/env python3
"""NRRD in many spellings, read by vprobe.

usage: nrrd.py VPROBE [FIRST-SEED COUNT]

Debian has no Python library of the format. The files are written by hand, after its definition
(https://teem.sourceforge.net/nrrd/format.html): types by all their names, encodings, detached data by name, list and
pattern, skips, axes in any order with kinds, directions, spacings, minima, centers and units; damaged ones among them.
What VTK's reader can read (attached, three axes, no directions) is compared with it too. VPROBE_LONG asks for 500.
"""
import bz2
import gzip
import random

from common import converted, go_through, info, lattice, need, refused, same, units_of

need('numpy', 'vtkmodules')
import numpy  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkIOImage import vtkNrrdReader  # noqa: E402

TYPES = {'i1': ['signed char', 'int8', 'int8_t'], 'u1': ['uchar', 'unsigned char', 'uint8', 'uint8_t'],
         'i2': ['short', 'short int', 'signed short', 'int16', 'int16_t'],
         'u2': ['ushort', 'unsigned short', 'unsigned short int', 'uint16'], 'i4': ['int', 'signed int', 'int32'],
         'u4': ['uint', 'unsigned int', 'uint32_t'], 'i8': ['longlong', 'long long', 'long long int', 'int64'],
         'u8': ['ulonglong', 'unsigned long long', 'uint64', 'uint64_t'], 'f4': ['float'], 'f8': ['double']}
METERS = {'nm': 1e-9, 'um': 1e-6, 'mm': 1e-3, 'cm': 1e-2}


class Volume:
    """Values by time, z, y, x and component, and a header that says so."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        pick = self.random.choice
        self.kind = pick(list(TYPES))
        self.times, self.components = pick([1, 1, 2, 3]), pick([1, 1, 2, 3])
        self.counts = [self.random.randint(2, 5) for _ in range(3)]
        self.encoding = pick(['raw', 'raw', 'gzip', 'gz', 'bzip2', 'bz2', 'ascii', 'text', 'txt', 'hex'])
        shape = (self.times, *self.counts[::-1], self.components)
        whole = self.kind[0] in 'iu'
        low, high = (numpy.iinfo(self.kind).min, numpy.iinfo(self.kind).max) if whole else (-1000, 1000)
        self.values = numpy.random.default_rng(seed).integers(low, high, shape, endpoint=True,
                                                              dtype='u8' if self.kind == 'u8' else 'i8')
        self.values = (self.values if whole else self.values / 8).astype(self.kind)
        if not whole and self.encoding in ('ascii', 'text', 'txt', 'raw'):
            self.values.flat[:3] = numpy.nan, numpy.inf, -numpy.inf
        # The axes in the order of the file, the fastest first: x, y and z keep theirs.
        self.axes = ['x', 'y', 'z']
        for name, length in (('t', self.times), ('c', self.components)):
            if length > 1 or pick([False, False, True]):
                self.axes.insert(self.random.randint(0, len(self.axes)), name)
        if 't' not in self.axes:
            assert self.times == 1
        self.lengths = {'x': self.counts[0], 'y': self.counts[1], 'z': self.counts[2], 't': self.times,
                        'c': self.components}
        self.name = pick(['', 'density'])
        self.lines = [f'type: {pick(TYPES[self.kind])}', f'dimension: {len(self.axes)}',
                      'sizes: ' + ' '.join(str(self.lengths[axis]) for axis in self.axes)]
        self.origin, self.steps, self.units = [0.0] * 3, numpy.eye(3), ''
        self.moments, self.time_units = [float(t) for t in range(self.times)], ''
        self.has_kinds = False
        pick([self.by_directions, self.by_spacings])()
        if self.name:
            self.lines.append(f'content: {self.name}')

    def along(self, key, words, otherwise):
        """A field with a word for each axis."""
        self.lines.append(f'{key}: ' + ' '.join(words.get(axis, otherwise) for axis in self.axes))

    def by_directions(self):
        pick = self.random.choice
        with_time = 't' in self.axes and pick([False, True])
        self.lines.insert(2, pick(['space: LPST', 'space: right-anterior-superior-time']) if with_time else
                          pick(['space: left-posterior-superior', 'space: LPS', 'space dimension: 3', 'space: RAS']))
        self.steps = numpy.array([pick([1, 0.5, 2]) * numpy.array(v, float) for v in pick(
            [[(1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 0), (1, 0, 0), (0, 0, -1)],
             [(0.6, 0.8, 0), (-0.8, 0.6, 0), (0.1, 0, 1)]])])
        vectors = {axis: list(step) for axis, step in zip('xyz', self.steps)}
        self.origin = [pick([0, 10.5, -3]) for _ in range(3)]
        first, gap = pick([0.0, 2.0]), pick([1.0, 0.5])
        if with_time:
            vectors = {axis: step + [0] for axis, step in vectors.items()}
            vectors['t'] = [0, 0, 0, gap]
            self.moments = [first + gap * t for t in range(self.times)]
        written = {axis: '(' + ','.join(map(str, step)) + ')' for axis, step in vectors.items()}
        self.along('space directions', written, 'none')
        origin = self.origin + ([first] if with_time else [])
        if pick([True, True, False]):
            self.lines.append('space origin: (' + ','.join(map(str, origin)) + ')')
        else:
            self.origin = [0.0] * 3
            if with_time:
                self.moments = [gap * t for t in range(self.times)]
        self.kinds(always='t' in self.axes and not with_time)
        if pick([False, True]):
            units = pick([['mm'] * 3, ['um'] * 3, ['mm', 'mm', 'cm'], ['nm', 'nm', 'um']])
            self.set_units(units)
            factors = numpy.array([METERS[unit] / METERS[units[0]] for unit in units])
            self.steps, self.origin = self.steps * factors, list(numpy.array(self.origin) * factors)
            time = pick(['s', 'ms']) if with_time else None
            self.time_units = time or ''
            self.lines.append('space units: ' + ' '.join(f'"{unit}"' for unit in units + ([time] if time else [])))

    def set_units(self, units):
        self.units = {'um': 'µm'}.get(units[0], units[0])

    def by_spacings(self):
        pick = self.random.choice
        self.kinds(always=True)
        spacings = {axis: pick([1.0, 0.5, 2.25]) for axis in 'xyz'}
        minima = {axis: pick([0.0, -4.5, 10.0]) for axis in 'xyz'}
        centers = {axis: pick(['cell', 'node']) for axis in 'xyz'}
        way = pick(['spacings', 'spacings and minima', 'minima and maxima', 'nothing'])
        has_centers = way != 'nothing' and pick([False, True])
        if has_centers:
            self.along(pick(['centers', 'centerings']), centers, '???')
        cell = {axis: has_centers and centers[axis] == 'cell' for axis in 'xyz'}
        if way.startswith('spacings'):
            gap = pick([0.5, 3.0])
            self.along('spacings', {**{axis: str(v) for axis, v in spacings.items()}, 't': str(gap)}, 'nan')
            self.moments = [gap * t for t in range(self.times)]
        if way == 'nothing':
            spacings = dict.fromkeys('xyz', 1.0)
        if way in ('spacings', 'nothing'):
            minima = dict.fromkeys('xyz', None)
        else:
            self.along('axis mins' if pick([False, True]) else 'axismins',
                       {axis: str(v) for axis, v in minima.items()}, 'nan')
        if way == 'minima and maxima':
            gaps = {axis: self.lengths[axis] - (0 if cell[axis] else 1) for axis in 'xyz'}
            self.along('axis maxs' if pick([False, True]) else 'axismaxs',
                       {axis: repr(minima[axis] + gaps[axis] * spacings[axis]) for axis in 'xyz'}, 'nan')
        self.origin = [0.0 if minima[axis] is None else minima[axis] + (0.5 * spacings[axis] if cell[axis] else 0.0)
                       for axis in 'xyz']
        self.steps = numpy.diag([spacings[axis] for axis in 'xyz'])
        if pick([False, True]):
            units = pick([['mm'] * 3, ['um'] * 3, ['mm', 'cm', 'mm']])
            self.set_units(units)
            factors = numpy.array([METERS[unit] / METERS[units[0]] for unit in units])
            self.steps, self.origin = self.steps * factors, list(numpy.array(self.origin) * factors)
            self.time_units = 's' if 't' in self.axes else ''
            self.along('units', {**{axis: f'"{unit}"' for axis, unit in zip('xyz', units)}, 't': '"s"'}, '""')

    def kinds(self, always):
        pick = self.random.choice
        if always or pick([False, True]):
            space = pick(['domain', 'space'])
            other = pick(['list', 'vector', '???'] if self.components > 1 else ['list', '???', 'scalar'])
            if self.components == 1 and other == 'vector':
                other = 'list'
            self.along('kinds', {'x': space, 'y': space, 'z': space, 't': 'time'}, other)

    def write(self, folder):
        pick = self.random.choice
        # From the order of the values (t, z, y, x, c) to that of the file, the slowest first.
        values = self.values.transpose(['tzyxc'.index(axis) for axis in self.axes[::-1] if axis in 'tzyxc'] +
                                       ['tzyxc'.index(axis) for axis in 'tc' if axis not in self.axes])
        order = pick('<>')
        if self.encoding not in ('ascii', 'text', 'txt') and self.kind[1] != '1' or pick([False, True]):
            self.lines.append(f'endian: {"little" if order == "<" else "big"}')
        data = values.astype(order + self.kind).tobytes()
        self.lines.append(f'encoding: {self.encoding}')
        self.lines.append('# a comment')
        pack = {'gzip': gzip.compress, 'gz': gzip.compress, 'bzip2': bz2.compress, 'bz2': bz2.compress,
                'hex': lambda part: part.hex().encode()}.get(self.encoding, bytes)
        if self.encoding in ('ascii', 'text', 'txt'):
            data = pick([' ', '\n', ', ']).join(self.word(value) for value in values.ravel()).encode()
        magic = f'NRRD000{pick([4, 5])}'
        way = pick(['attached', 'attached', 'file', 'list', 'pattern', 'skip', 'end'])
        slabs = self.lengths[self.axes[-1]]
        if way in ('list', 'pattern') and pack is bytes and self.encoding == 'raw' and slabs > 1:
            size = len(data) // slabs
            for i in range(slabs):
                (folder / f's{i}.raw').write_bytes(data[i * size:(i + 1) * size])
            self.lines.append('data file: LIST\n' + '\n'.join(f's{i}.raw' for i in range(slabs)) if way == 'list' else
                              f'data file: s%d.raw 0 {slabs - 1} 1')
            path, rest = folder / 'a.nhdr', b''
        elif way in ('file', 'skip', 'end'):
            before = b''
            if way == 'skip':
                before = b'one line\nand another\n12345'
                self.lines += ['line skip: 2', 'byte skip: 5']
            elif way == 'end' and self.encoding == 'raw':
                before = b'whatever it is'
                self.lines += ['byte skip: -1']
            stored = pack(before + data) if self.encoding in ('raw', 'ascii', 'text', 'txt') else pack(data)
            if self.encoding not in ('raw', 'ascii', 'text', 'txt') and way == 'skip':
                self.lines = self.lines[:-2]
            (folder / 'a.raw').write_bytes(stored)
            self.lines.append(f'{pick(["data file", "datafile"])}: {pick(["", "./"])}a.raw')
            path, rest = folder / 'a.nhdr', b''
        else:
            path, rest = folder / 'a.nrrd', b'\n' + pack(data)
        path.write_bytes((magic + '\n' + '\n'.join(self.lines) + '\n').encode() + rest)
        return path

    def word(self, value):
        if isinstance(value, numpy.floating):
            if value != value:
                return self.random.choice(['nan', 'NaN', 'NAN', '-nan'])
            if numpy.isinf(value):
                return self.random.choice(['inf', 'Infinity', '+inf', 'INF'] if value > 0 else ['-inf', '-Infinity'])
            return repr(float(value))
        return str(int(value))


def compare_damaged(seed, folder):
    """What cannot be unpacked, is cut short, or has a number too many is no volume."""
    data = numpy.arange(64, dtype='<i2').tobytes()
    packed = bytearray(gzip.compress(data))
    head = 'NRRD0004\ntype: short\ndimension: 3\nsizes: 4 4 4\nendian: little\nencoding: '
    way = seed % 6
    if way == 0:
        packed[random.Random(seed).randrange(12, len(packed) - 8)] ^= 0x55
    encoding, stored = [('gzip', bytes(packed)), ('gzip', bytes(packed[:-12])), ('raw', data[:-2]),
                        ('ascii', b'1 ' * 63), ('ascii', b'1 ' * 65), ('bzip2', bz2.compress(data)[:-24])][way]
    path = folder / 'a.nrrd'
    path.write_bytes((head + encoding + '\n\n').encode() + stored)
    assert 'truncated or damaged' in refused(path), way


def by_vtk(path, volume):
    """VTK's reader takes the plain ones."""
    if volume.axes != ['x', 'y', 'z'] or volume.encoding not in ('raw', 'gzip') or path.suffix != '.nrrd':
        return
    reader = vtkNrrdReader()
    reader.SetFileName(str(path))
    reader.Update()
    scalars = reader.GetOutput().GetPointData().GetScalars()
    same(vtk_to_numpy(scalars).ravel(), volume.values.ravel(), 'the witness itself')


def compare(seed, folder):
    if seed % 10 == 0:
        return compare_damaged(seed // 10, folder)
    volume = Volume(seed)
    path = volume.write(folder)
    what = (volume.kind, volume.encoding, ''.join(volume.axes), volume.lines)
    by_vtk(path, volume)
    found = info(path)
    same(found['times'], volume.moments if volume.times > 1 else [], (what, 'times'))
    assert units_of(found, 'length_units', volume.units) == volume.units, (what, found.get('length_units'))
    if volume.times > 1:
        assert units_of(found, 'time_units', volume.time_units) == volume.time_units, (what, found.get('time_units'))
    step = volume.random.randrange(volume.times)
    points, arrays, _ = converted(path, folder, '--time', f'#{step}')
    same(points, lattice(volume.counts, volume.origin, volume.steps), (what, 'places'), 1e-9)
    ours = arrays[volume.name or 'NRRD']
    assert ours.dtype == volume.values.dtype, (what, ours.dtype)
    same(ours.reshape(volume.values.shape[1:]), volume.values[step], what)


go_through('nrrd', compare)
