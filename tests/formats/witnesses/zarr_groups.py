#!/usr/bin/env python3
"""Zarr 2 in many spellings, written and read by zarr, and read by vprobe.

usage: zarr_groups.py VPROBE [FIRST-SEED COUNT]

Types, byte orders, orders of values, compressors, filters, chunks that are missing, fill values, flat and nested keys,
consolidated metadata, groups and lone arrays. VPROBE_LONG asks for 500 files.
"""
import random

import common

common.need('numpy', 'zarr', 'numcodecs', 'vtkmodules.vtkIOXML')
import numcodecs
import numpy
import zarr

TYPES = ['i1', 'u1', 'i2', 'u2', 'i4', 'u4', 'i8', 'u8', 'f2', 'f4', 'f8', '?']


def compressor(pick):
    blosc = [numcodecs.Blosc(name, pick([1, 5, 9]), shuffle) for name in ('lz4', 'lz4hc', 'blosclz', 'zstd', 'zlib')
             for shuffle in (0, 1, 2)]
    return pick([None, pick(blosc), pick(blosc), numcodecs.Zlib(1), numcodecs.GZip(5), numcodecs.Zstd(3),
                 numcodecs.LZ4(), numcodecs.LZMA()])


def filters(pick, kind):
    if kind in ('?', 'f2'):
        return None
    whole = numpy.dtype(kind).kind in 'iu'
    size = numpy.dtype(kind).itemsize
    chosen = [pick([numcodecs.Shuffle(size), numcodecs.CRC32()])]
    if whole:
        chosen.insert(0, numcodecs.Delta(dtype=kind))
    else:
        chosen.insert(0, pick([numcodecs.Delta(dtype=kind), numcodecs.Quantize(2, dtype=kind),
                               numcodecs.FixedScaleOffset(offset=0.5, scale=4, dtype=kind, astype='<i4')]))
    return pick([None, None, chosen[:1], chosen[1:], chosen])


def values_of(numbers, kind, shape):
    if kind == '?':
        return numbers.integers(0, 2, shape).astype(bool)
    values = numbers.integers(0 if kind[0] == 'u' else -50, 100, shape).astype(kind)
    return values + numpy.array(0.25, kind) if kind[0] == 'f' else values


def spelled(seed):
    """Names of arrays, how they are made, and what is written into them."""
    rng, numbers = random.Random(seed), numpy.random.default_rng(seed)
    pick, chance = rng.choice, rng.random
    shape = tuple(rng.randint(2, 7) for _ in range(3))
    arrays = {}
    for i in range(rng.randint(1, 4)):
        kind = pick(TYPES)
        order = kind if kind in ('i1', 'u1', '?') else pick('<>') + kind
        about = {'shape': shape, 'dtype': order, 'chunks': tuple(rng.randint(1, n + 1) for n in shape),
                 'compressor': compressor(pick), 'order': pick('CF'), 'filters': filters(pick, kind)}
        fill = 0 if kind == '?' else pick([0, 7, 99] + ([numpy.nan] if kind[0] == 'f' else []))
        about['fill_value'] = fill
        values = values_of(numbers, kind, shape)
        begin = tuple(rng.randint(0, n - 1) for n in shape) if chance() < 0.4 else (0, 0, 0)
        if begin == (0, 0, 0) and chance() < 0.3:
            about['fill_value'] = None
        arrays[f'v{i}'] = (about, values, begin)
    return rng, shape, arrays


def write(seed, folder):
    rng, shape, arrays = spelled(seed)
    separator = rng.choice('./')
    path = folder / 'f.zarr'
    store = zarr.DirectoryStore(str(path), dimension_separator=separator) if rng.random() < 0.7 else \
        zarr.NestedDirectoryStore(str(path))
    lone = rng.random() < 0.2
    if lone:
        arrays = dict(list(arrays.items())[:1])
    else:
        group = zarr.group(store)
    named = rng.random() < 0.6
    for name, (about, values, begin) in arrays.items():
        made = zarr.create(store=store, **about) if lone else group.create(name=name, **about)
        if named:
            made.attrs['_ARRAY_DIMENSIONS'] = ['z', 'y', 'x']
        part = tuple(slice(b, None) for b in begin)
        made[part] = values[part]
        made.attrs['odd'] = {'a': [1, None]}
        made.attrs['nothing'] = float('nan')
    if not lone and named and rng.random() < 0.5:
        places = numpy.linspace(10, 20, shape[2])
        group.array('x', places, chunks=2, compressor=numcodecs.Zlib()).attrs['_ARRAY_DIMENSIONS'] = ['x']
    if not lone and rng.random() < 0.3:
        zarr.consolidate_metadata(store)
    return path, lone, arrays


def compare(seed, folder):
    path, lone, arrays = write(seed, folder)
    points, ours, _ = common.converted(path, folder)
    opened = zarr.open(str(path), mode='r')
    for name in arrays:
        made = opened if lone else opened[name]
        wanted = made[...].ravel()
        if made.fill_value is not None and made.fill_value != 0:
            wanted = numpy.where(wanted == made.fill_value, numpy.nan, wanted.astype(float))
        found = ours['f.zarr' if lone else name]
        common.same(found.astype(float), wanted.astype(float), (name, made.dtype, made.compressor, made.filters))
    xs = opened['x'][...] if not lone and 'x' in opened else numpy.arange(made.shape[2])
    common.same(points[:made.shape[2], 0], xs, 'places', 1e-12)


common.go_through('zarr', compare)
