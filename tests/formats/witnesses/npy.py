#!/usr/bin/env python3
"""NumPy's arrays and archives in many spellings, written by NumPy and read by vprobe.

usage: npy.py VPROBE [FIRST-SEED COUNT]

Types, byte orders, C and Fortran order, versions of the header, vectors, archives plain and packed with arrays of
other shapes among them. VPROBE_LONG asks for 500 files.
"""
import random

import common

common.need('numpy', 'vtkmodules.vtkIOXML')
import numpy

TYPES = ['i1', 'u1', 'i2', 'u2', 'i4', 'u4', 'i8', 'u8', 'f4', 'f8', '?']


def array_of(rng, numbers, shape):
    kind = rng.choice(TYPES)
    values = numbers.integers(0, 2 if kind == '?' else 100, shape).astype(kind)
    if kind[0] == 'f':
        values = values / numpy.array(8, kind)
    if kind not in ('i1', 'u1', '?'):
        values = values.astype(values.dtype.newbyteorder(rng.choice('<>')))
    return numpy.asfortranarray(values) if len(shape) == 3 and rng.random() < 0.5 else values


def meant(values, shape):
    """Points with x, the last axis, running fastest; in Fortran's order the first."""
    fortran = values.flags.f_contiguous and not values.flags.c_contiguous
    turned = values.T if fortran else values
    return turned.reshape((-1, turned.shape[-1])) if values.ndim == 4 else turned.ravel()


def compare(seed, folder):
    rng, numbers = random.Random(seed), numpy.random.default_rng(seed)
    shape = tuple(rng.randint(2, 6) for _ in range(3))
    if rng.random() < 0.5:
        path = folder / 'v.npy'
        values = array_of(rng, numbers, shape + ((rng.randint(1, 4),) if rng.random() < 0.3 else ()))
        with open(path, 'wb') as file:
            numpy.lib.format.write_array(file, values, version=rng.choice([None, (1, 0), (2, 0), (3, 0)]))
        arrays = {'v': values}
    else:
        path = folder / 'v.npz'
        arrays = {f'v{i}': array_of(rng, numbers, shape).copy(order='C') for i in range(rng.randint(1, 4))}
        others = {'scalar': numpy.array(3.5), 'line': numpy.arange(4)} if rng.random() < 0.5 else {}
        rng.choice([numpy.savez, numpy.savez_compressed])(path, **arrays, **others)
    points, ours, _ = common.converted(path, folder)
    for name, values in arrays.items():
        wanted = meant(values, shape)
        if values.ndim == 4 and wanted.shape[1] == 1:
            wanted = wanted.ravel()
        common.same(ours[name].astype(float), wanted.astype(float), (name, values.dtype, values.shape))
    common.same(points.max(axis=0).astype(int)[0], (values.T if values.flags.f_contiguous and not
                values.flags.c_contiguous else values).shape[2] - 1, 'places')


common.go_through('npy', compare)
