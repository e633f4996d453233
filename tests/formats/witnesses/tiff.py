#!/usr/bin/env python3
"""TIFF stacks in many spellings, written and read by tifffile, and read by vprobe.

usage: tiff.py VPROBE [FIRST-SEED COUNT]

Plain stacks, ImageJ's hyperstacks, tifffile's own descriptions, and OME-TIFF, whose XML is written here: all orders of
dimensions, TiffData in any order and size, two files, units that differ. VPROBE_LONG asks for 500 files.
"""
import random
import uuid

from common import converted, go_through, info, lattice, need, same, units_of

need('numpy', 'tifffile', 'vtkmodules')
import numpy  # noqa: E402
import tifffile  # noqa: E402

METERS = {'nm': 1e-9, 'µm': 1e-6, 'mm': 1e-3, 'Å': 1e-10, 'cm': 1e-2, 'm': 1.0, 'pm': 1e-12, 'in': 0.0254}
TYPES = ['u1', 'i1', 'u2', 'i2', 'u4', 'i4', 'f4', 'f8', 'u8', 'i8', 'bool']


class Stack:
    """What one file holds: values by time, channel, slice, row, column and sample."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.numbers = numpy.random.default_rng(seed)
        pick, number = self.random.choice, self.random.randint
        self.form = pick(['plain', 'imagej', 'shaped', 'ome', 'ome', 'ome'])
        self.kind = pick(['u1', 'u2', 'f4'] if self.form == 'imagej' else TYPES)
        self.samples = pick([1, 1, 1, 3])
        if self.form == 'imagej' and self.samples == 3:
            self.kind = 'u1'
        if self.kind == 'bool':
            self.samples = 1
        self.times = number(1, 3) if self.form != 'plain' else 1
        self.channels = number(1, 3) if self.form != 'plain' else 1
        self.slices, self.rows, self.columns = number(2, 4), number(2, 6), number(5, 7)
        shape = (self.times, self.channels, self.slices, self.rows, self.columns, self.samples)
        self.values = self.numbers.integers(0, 2 if self.kind == 'bool' else 127, shape).astype(self.kind)
        self.spacing, self.units, self.steps, self.time_units = [1.0] * 3, '', 1.0, ''
        self.origin = [0.0] * 3
        self.time_values = list(range(self.times))

    def storage(self):
        """How pages are kept: none of it changes what they say."""
        pick = self.random.choice
        options = {'compression': pick([None, None, 'zlib', 'lzma']), 'byteorder': pick('<>'),
                   'bigtiff': pick([False, False, True])}
        if self.kind == 'bool':
            options['compression'] = None
        elif pick([False, True]):
            options['tile'] = (16, 16)
        else:
            options['rowsperstrip'] = pick([1, 2, 100])
        if self.samples == 3:
            options['photometric'] = 'rgb'
            options['planarconfig'] = pick(['contig', 'separate'])
        else:
            options['photometric'] = 'minisblack'
        return options

    def pages(self, planes, options):
        """As tifffile wants them."""
        if self.samples == 1:
            return planes[..., 0]
        return numpy.moveaxis(planes, -1, -3) if options['planarconfig'] == 'separate' else planes


def write_plain(stack, path):
    options = stack.storage()
    tifffile.imwrite(path, stack.pages(stack.values[0, 0], options), metadata=None, **options)


def write_imagej(stack, path):
    about = {'axes': 'TZCYXS', 'spacing': stack.random.choice([0.5, 2.0, -2.0]), 'finterval': 2.5}
    if stack.samples == 1:
        about['axes'] = 'TZCYX'
    unit, stack.units = stack.random.choice([('um', 'µm'), ('micron', 'µm'), ('nm', 'nm'), ('pixel', ''), ('mm', 'mm'),
                                             ('\\u00B5m', 'µm'), ('inch', 'in')])
    about['unit'] = unit
    stack.spacing = [0.25, 0.5, abs(about['spacing'])]
    stack.time_values, stack.time_units = [2.5 * t for t in range(stack.times)], 's'
    values = stack.values.transpose(0, 2, 1, 3, 4, 5)
    if stack.samples == 1:
        values = values[..., 0]
    tifffile.imwrite(path, values, imagej=True, resolution=(4, 2), metadata=about,
                     byteorder=stack.random.choice('<>'))


def write_shaped(stack, path):
    options = stack.storage()
    order = stack.random.sample('TCZ', 3)
    values = stack.values.transpose(*('TCZ'.index(axis) for axis in order), 3, 4, 5)
    axes = ''.join(order) + {0: 'YX', 1: 'YXS', 2: 'SYX'}[
        0 if stack.samples == 1 else 2 if options['planarconfig'] == 'separate' else 1]
    tifffile.imwrite(path, stack.pages(values, options), metadata={'axes': axes}, **options)


def ome_xml(stack, order, runs, own, planes=''):
    """runs: of pages, each (plane, file or None, page, count or None)."""
    sizes = {'T': stack.times, 'C': stack.channels, 'Z': stack.slices}
    data = ''
    for plane, other, page, count in runs:
        first = {}
        for axis in order:
            first[axis], plane = plane % sizes[axis], plane // sizes[axis]
        attributes = ''.join(f' First{axis}="{first[axis]}"' for axis in order
                             if first[axis] or stack.random.random() < 0.5)
        attributes += '' if page is None else f' IFD="{page}"'
        attributes += '' if count is None else f' PlaneCount="{count}"'
        inner = f'<UUID FileName="{other[0]}">{other[1]}</UUID>' if other else ''
        data += f'<TiffData{attributes}>{inner}</TiffData>'
    about = ''
    for axis, size, unit in zip('XYZ', stack.given, stack.given_units):
        about += f' PhysicalSize{axis}="{size}"'
        about += '' if unit == 'µm' and stack.random.random() < 0.5 else f' PhysicalSize{axis}Unit="{unit}"'
    if not planes and stack.times > 1:
        about += f' TimeIncrement="{stack.steps}" TimeIncrementUnit="{stack.time_units}"'
    types = {'u': 'uint', 'i': 'int', 'f': 'float', 'b': 'bit'}
    kind = stack.values.dtype
    name = {'f4': 'float', 'f8': 'double'}.get(kind.str[1:], 'bit' if kind == bool else
                                               f'{types[kind.kind]}{8 * kind.itemsize}')
    channels = ''.join(f'<Channel ID="Channel:0:{c}" SamplesPerPixel="{stack.samples}"/>'
                       for c in range(stack.channels))
    return (f'<?xml version="1.0" encoding="UTF-8"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06" '
            f'UUID="{own}"><Image ID="Image:0"><Pixels ID="Pixels:0" DimensionOrder="XY{order}" Type="{name}" '
            f'SizeX="{stack.columns}" SizeY="{stack.rows}" SizeZ="{stack.slices}" '
            f'SizeC="{stack.channels * stack.samples}" SizeT="{stack.times}"{about}>{channels}{data}{planes}'
            f'</Pixels></Image></OME>')


def write_ome(stack, path):
    pick = stack.random.choice
    options = stack.storage()
    order = ''.join(stack.random.sample('ZCT', 3))
    stack.given_units = [pick(['µm', 'nm', 'µm', 'mm', 'Å'])] * 3
    if pick([False, True]):
        stack.given_units[2] = pick(['µm', 'nm', 'pm'])
    stack.given = [pick([0.5, 1, 2.5]) for _ in range(3)]
    stack.units = stack.given_units[0]
    stack.spacing = [size * METERS[unit] / METERS[stack.units] for size, unit in zip(stack.given, stack.given_units)]
    stack.steps, stack.time_units = pick([1.0, 0.5, 30.0]), pick(['s', 'ms', 'min'])
    stack.time_values = [stack.steps * t for t in range(stack.times)]
    count = stack.times * stack.channels * stack.slices
    # The planes in the file's own order of dimensions.
    planes = stack.values.transpose(*('TCZ'.index(axis) for axis in order[::-1]), 3, 4, 5)
    planes = planes.reshape(count, *stack.values.shape[3:])
    own = f'urn:uuid:{uuid.UUID(int=stack.random.getrandbits(128))}'
    moments = ''
    if stack.times > 1 and pick([False, True]):
        stack.time_values = [pick([0.5, 2.0]) * t + stack.random.random() for t in range(stack.times)]
        moments = ''.join(f'<Plane TheZ="0" TheC="0" TheT="{t}" DeltaT="{stack.time_values[t]}" '
                          f'DeltaTUnit="{stack.time_units}"/>' for t in range(stack.times))
    if pick([False, False, False, True]):
        return write_two_files(stack, path, order, planes, own, options, moments)
    way = pick(['all', 'alone', 'runs'])
    if way == 'all':
        runs, pages = [(0, None, pick([None, 0]), None)], planes
        if runs[0][2] == 0:
            runs = [(0, None, 0, count)]
    elif way == 'alone':
        places = stack.random.sample(range(count), count)  # of each page
        runs = [(plane, None, page, pick([None, 1])) for page, plane in enumerate(places)]
        stack.random.shuffle(runs)
        pages = planes[places]
    else:
        cut = stack.random.randint(1, count - 1)
        runs = [(0, None, count - cut, cut), (cut, None, 0, count - cut)]
        pages = numpy.concatenate([planes[cut:], planes[:cut]])
    xml = ome_xml(stack, order, runs, own, moments)
    tifffile.imwrite(path, stack.pages(pages, options), description=xml.encode(), metadata=None, **options)


def write_two_files(stack, path, order, planes, own, options, moments):
    other = f'urn:uuid:{uuid.UUID(int=stack.random.getrandbits(128))}'
    cut = stack.random.randint(1, len(planes) - 1)
    runs = [(0, (path.name, own), 0, cut), (cut, ('second.ome.tif', other), 0, len(planes) - cut)]
    for name, uid, part in ((path.name, own, planes[:cut]), ('second.ome.tif', other, planes[cut:])):
        state = stack.random.getstate()
        xml = ome_xml(stack, order, runs, uid, moments)
        stack.random.setstate(state)
        tifffile.imwrite(path.parent / name, stack.pages(part, options), description=xml.encode(), metadata=None,
                         **options)


def by_tifffile(stack, path):
    """The values as tifffile reads them, by time, channel, slice, row, column and sample."""
    with tifffile.TiffFile(path) as file:
        series = file.series[0]
        values, axes = series.asarray(), series.axes
    axes = axes.replace('I', 'Z').replace('Q', 'Z')
    for axis in 'TCZYXS':
        if axis not in axes:
            values, axes = values[..., None], axes + axis
    values = values.transpose([axes.index(axis) for axis in 'TCZYXS'])
    return values.reshape(stack.values.shape)


def compare(seed, folder):
    stack = Stack(seed)
    path = folder / ('a.ome.tif' if stack.form == 'ome' else 'a.tif')
    {'plain': write_plain, 'imagej': write_imagej, 'shaped': write_shaped, 'ome': write_ome}[stack.form](stack, path)
    what = (stack.form, stack.kind, stack.values.shape)
    witness = by_tifffile(stack, path)
    same(witness, stack.values, (what, 'the witness itself'))
    found = info(path)
    same(found['times'], sorted(stack.time_values) if stack.times > 1 else [], (what, 'times'), 1e-12)
    assert units_of(found, 'length_units', stack.units) == stack.units, (what, found.get('length_units'))
    if stack.times > 1:
        assert units_of(found, 'time_units', stack.time_units) == stack.time_units, (what, found.get('time_units'))
    index = stack.random.randrange(stack.times)
    step = int(numpy.argsort(stack.time_values, kind='stable')[index])
    points, arrays, _ = converted(path, folder, '--time', f'#{index}')
    counts = (stack.columns, stack.rows, stack.slices)
    same(points, lattice(counts, stack.origin, numpy.diag(stack.spacing)), (what, 'places'), 1e-9)
    assert len(arrays) == stack.channels, (what, list(arrays))
    for channel in range(stack.channels):
        name = 'values' if stack.channels == 1 else f'channel {channel}'
        wanted = witness[step, channel].reshape(-1, stack.samples)
        same(arrays[name].reshape(-1, stack.samples), wanted, (what, name))


go_through('tiff', compare)
