#!/usr/bin/env python3
"""SEG-Y in many spellings, written and read by segyio, and read by vprobe.

usage: segy.py VPROBE [FIRST-SEED COUNT]

Formats of samples (1, 2, 3, 5, 8 by segyio; 6, 10, 11, 16, which it does not know, put into its files by hand after
"SEG-Y r2.0"), both orders of bytes where segyio has them right, traces in any order, scales of coordinates, delays, coordinates
of middles and of sources, and none at all. VPROBE_LONG asks for 500 files.
"""
import random

from common import converted, go_through, need, same

need('numpy', 'segyio', 'vtkmodules')
import numpy  # noqa: E402
import segyio  # noqa: E402

FORMATS = {1: 'f4', 2: 'i4', 3: 'i2', 5: 'f4', 6: 'f8', 8: 'i1', 10: 'u4', 11: 'u2', 16: 'u1'}
FIELD = segyio.TraceField


def write(seed, path):
    chance = random.Random(seed)
    pick = chance.choice
    form = pick(list(FORMATS))
    inlines = sorted(chance.sample(range(1, 60), chance.randint(2, 4)))
    crosslines = sorted(chance.sample(range(100, 160), chance.randint(2, 4)))
    samples, interval, delay = chance.randint(2, 6), pick([1000, 2000, 4000]), pick([0, 0, 100])
    if form in (3, 8):  # segyio 1.8.3 writes whole words alone
        samples = pick([4, 8])
    scale = pick([1, 0, -100, 10])
    place = pick(['middle', 'source', 'none'])
    order = [(i, c) for i in inlines for c in crosslines]
    if pick([False, True]):
        chance.shuffle(order)
    elif pick([False, True]):
        order.sort(key=lambda pair: pair[::-1])
    spec = segyio.spec()
    by_hand = form in (6, 10, 11, 16)
    spec.format, spec.samples, spec.tracecount = 5 if by_hand else form, numpy.arange(samples) * interval / 1000, len(order)
    spec.endian = pick(['big', 'little']) if form in (1, 2, 5) else 'big'
    low, high = {'i1': (-100, 100), 'u1': (0, 250)}.get(FORMATS[form], (0 if FORMATS[form][0] == 'u' else -1000, 1000))
    values = numpy.random.default_rng(seed).integers(low, high, (len(order), samples))
    if form in (1, 5, 6):
        values = values / 8
    values = values.astype(FORMATS[form])
    places = {}
    with segyio.create(path, spec) as file:
        file.bin[segyio.BinField.Interval] = interval
        file.bin[segyio.BinField.SEGYRevision] = pick([0, 256])
        for n, (i, c) in enumerate(order):
            file.trace[n] = values[n].astype(file.dtype)
            x, y = 1000 + 25 * i - 5 * c, 2000 + 5 * i + 25 * c
            header = {FIELD.INLINE_3D: i, FIELD.CROSSLINE_3D: c, FIELD.SourceGroupScalar: scale,
                      FIELD.DelayRecordingTime: delay, FIELD.TRACE_SAMPLE_COUNT: samples,
                      FIELD.TRACE_SAMPLE_INTERVAL: interval}
            if place == 'middle':
                header |= {FIELD.CDP_X: x, FIELD.CDP_Y: y}
            if place == 'source' or (place == 'middle' and pick([False, True])):
                header |= {FIELD.SourceX: x, FIELD.SourceY: y}
            file.header[n] = header
            factor = -1 / scale if scale < 0 else scale or 1
            places[i, c] = (i, c) if place == 'none' else (x * factor, y * factor)
    if by_hand:
        put_samples(path, form, values)
    return (form, spec.endian, place, scale), spec.endian, inlines, crosslines, places, interval / 1000, delay, order, values


def put_samples(path, form, values):
    bare = path.read_bytes()
    head = bytearray(bare[:3600])
    head[3224:3226] = form.to_bytes(2, 'big')
    step = 240 + 4 * values.shape[1]
    path.write_bytes(bytes(head) + b''.join(
        bare[3600 + n * step:3840 + n * step] + trace.astype(trace.dtype.newbyteorder('>')).tobytes()
        for n, trace in enumerate(values)))


def by_segyio(path, endian):
    with segyio.open(path, ignore_geometry=True, endian=endian) as file:
        return {(file.header[n][FIELD.INLINE_3D], file.header[n][FIELD.CROSSLINE_3D]): file.trace[n].copy()
                for n in range(file.tracecount)}


def compare(seed, folder):
    path = folder / 'a.sgy'
    what, endian, inlines, crosslines, places, interval, delay, order, values = write(seed, path)
    by_hand = what[0] in (6, 10, 11, 16)
    witness = dict(zip(order, values)) if by_hand else by_segyio(path, endian)
    samples = len(next(iter(witness.values())))
    points, arrays, said = converted(path, folder)
    assert ('no coordinates' in said) == (what[2] == 'none'), (what, said)
    # Upside down: the last sample lies lowest.
    wanted = [(*places[i, c], -(delay + interval * k)) for k in reversed(range(samples))
              for i in inlines for c in crosslines]
    same(points, wanted, (what, 'places'), 1e-9)
    values = [witness[i, c][k] for k in reversed(range(samples)) for i in inlines for c in crosslines]
    same(arrays['trace'], values, what)


go_through('segy', compare)
