#!/usr/bin/env python3
"""MRC and CCP4 maps in many spellings, written and read by mrcfile, and read by vprobe.

usage: mrc.py VPROBE [FIRST-SEED COUNT]

All modes that mrcfile knows, both orders of bytes, all orders of axes, origins and first indices, extended headers,
stacks of images and of volumes. By hand, after MRC2014 and IMOD's mrc_format.txt, since mrcfile does not know them:
IMOD's stamp, values of 4 bits, and the angles of the cell. VPROBE_LONG asks for 500 files.
"""
import itertools
import math
import random
import warnings

from common import converted, go_through, info, lattice, need, refused, same, units_of

need('numpy', 'mrcfile', 'vtkmodules')
import mrcfile  # noqa: E402
import numpy  # noqa: E402

IMOD = 1146047817


def write(seed, path):
    """Returns what the file is, the values of its volumes, and where they lie."""
    chance = random.Random(seed)
    pick, number = chance.choice, chance.randint
    kind = pick(['i1', 'i2', 'u2', 'f4', 'f2', 'imod', 'four bits'])
    counts = [number(3, 6), number(2, 5), number(2, 4)]  # of columns, rows and sections
    way = pick(['volume', 'volume', 'images', 'volumes'])
    volumes = number(2, 3) if way == 'volumes' else 1
    shape = (volumes, *counts[::-1])
    low, high = {'i1': (-128, 127), 'u2': (0, 65535), 'imod': (0, 255), 'four bits': (0, 15)}.get(kind, (-2000, 2000))
    values = numpy.random.default_rng(seed).integers(low, high + 1, shape)
    stored = values.astype({'imod': 'u1', 'four bits': 'u1', 'f2': 'f2'}.get(kind, kind))
    if kind == 'f2' and pick([False, True]):
        stored.flat[:3] = numpy.nan, numpy.inf, -numpy.inf
    flags = 0
    if kind == 'imod':
        flags = pick([0, 1, 4, 5])
        stored = stored.view('i1')
    written = stored
    if kind == 'four bits':
        padded = numpy.pad(stored, [(0, 0)] * 3 + [(0, counts[0] % 2)])
        written = (padded[..., 0::2] | padded[..., 1::2] << 4).view('i1')
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        with mrcfile.new(path, overwrite=True) as file:
            file.set_data(written if way == 'volumes' else written[0])
            if way == 'images':
                file.set_image_stack()
            voxel = [pick([0.5, 1.0, 2.25]) for _ in range(3)]
            file.voxel_size = tuple(voxel)
            header = file.header
            order = (1, 2, 3) if way != 'volume' else pick(list(itertools.permutations((1, 2, 3))))
            header.mapc, header.mapr, header.maps = order
            sizes = dict(zip(order, counts))
            if way == 'volume':
                header.mx, header.my, header.mz = (sizes[axis] for axis in (1, 2, 3))
            header.cella = tuple(step * int(n) for step, n in zip(voxel, (header.mx, header.my, header.mz)))
            start = [number(-5, 5) for _ in range(3)]
            header.nxstart, header.nystart, header.nzstart = start
            origin = pick([(0, 0, 0), (0, 0, 0), (10.5, 0, -3.25), (1, 2, 3)])
            header.origin = origin
            angles = pick([(90, 90, 90), (90, 90, 90), (90, 90, 120), (80, 75, 100)]) if way != 'images' else (90,) * 3
            header.cellb = angles
            if pick([False, True]):
                file.set_extended_header(numpy.frombuffer(b'x' * 80 * number(1, 3), 'V80'))
            if kind == 'four bits':
                header.mode, header.nx = 101, counts[0]
                if way != 'volume':
                    header.mx = counts[0]
                    header.cella.x = voxel[0] * counts[0]
            whole = header.copy()
    bare = bytearray(path.read_bytes())
    sign = 1
    if kind == 'imod':
        bare[152:160] = numpy.array([IMOD, flags], '<i4').tobytes()
        if pick([False, True]):  # before MRC2014
            bare[108:112] = bytes(4)
            sign = 1 if flags & 4 else -1
        values = values if not flags & 1 else values.astype('u1').view('i1')
    if kind != 'four bits' and pick([False, True]):
        swap_bytes(bare, stored.dtype.itemsize, int(whole.nsymbt))
    path.write_bytes(bytes(bare))
    if kind == 'f2':
        values = stored.astype('f4')

    alpha, beta, gamma = (math.cos(math.radians(angle)) if angle != 90 else 0.0 for angle in angles)
    sine = math.sqrt(1 - gamma * gamma)
    y = (alpha - beta * gamma) / sine
    cell = numpy.array([[1, 0, 0], [gamma, sine, 0], [beta, y, math.sqrt(1 - beta * beta - y * y)]])
    steps = [cell[axis - 1] * voxel[axis - 1] for axis in order]
    first = numpy.array(origin) * sign if any(origin) else sum(n * step for n, step in zip(start, steps))
    return (kind, way, order, flags), values, lattice(counts, first, steps)


def swap_bytes(bare, width, extended):
    """Turns the file into one of a big-endian machine."""
    words = numpy.frombuffer(bytes(bare[:1024]), '<u4').byteswap().tobytes()
    for begin, end in ((0, 104), (108, 208), (216, 224)):
        bare[begin:end] = words[begin:end]
    bare[212:216] = b'\x11\x11\0\0'
    begin = 1024 + extended
    bare[begin:] = numpy.frombuffer(bytes(bare[begin:]), f'<u{width}').byteswap().tobytes()


def compare(seed, folder):
    path = folder / 'a.mrc'
    if seed % 25 == 0:
        return compare_refused(seed, path)
    what, values, places = write(seed, path)
    if what[0] not in ('imod', 'four bits'):
        with warnings.catch_warnings():
            warnings.simplefilter('ignore')
            with mrcfile.open(path, permissive=True) as file:
                same(file.data.reshape(values.shape), values, (what, 'the witness itself'))
    found = info(path)
    volumes = len(values)
    assert found['times'] == (list(range(volumes)) if volumes > 1 else []), (what, found['times'])
    assert units_of(found, 'length_units', 'Å') == 'Å', found
    chosen = random.Random(-seed).randrange(volumes)
    points, arrays, _ = converted(path, folder, '--time', f'#{chosen}')
    same(points, places, (what, 'places'), 1e-6)
    same(arrays['density'], values[chosen].ravel(), what)


def compare_refused(seed, path):
    """Transforms, and files that end early, are no volume."""
    with mrcfile.new(path, overwrite=True) as file:
        file.set_data(numpy.ones((3, 4, 5), 'c8' if seed % 2 else 'f4'))
    if seed % 2:
        assert 'complex' in refused(path)
    else:
        path.write_bytes(path.read_bytes()[:-4])
        assert 'bytes of values' in refused(path)


go_through('mrc', compare)
