#!/usr/bin/env python3
"""NIfTI in many spellings, written and read by nibabel, and read by vprobe.

usage: nifti.py VPROBE [FIRST-SEED COUNT]

Versions 1 and 2, packed, pairs of files, both orders of bytes, all types, times, vectors, qform and sform, slopes and
intercepts of any value, units. VPROBE_LONG asks for 500 files.
"""
import random

from common import converted, go_through, info, lattice, need, same, units_of

need('numpy', 'nibabel', 'vtkmodules')
import nibabel  # noqa: E402
import numpy  # noqa: E402

TYPES = ['u1', 'i1', 'u2', 'i2', 'u4', 'i4', 'i8', 'u8', 'f4', 'f8']


def write(seed, folder):
    """Returns the path, and what the file says of itself apart from nibabel."""
    chance = random.Random(seed)
    pick = chance.choice
    counts = [chance.randint(2, 5) for _ in range(3)]
    times, vector = pick([1, 1, 2, 3]), pick([1, 1, 1, 3])
    kind = pick(TYPES)
    shape = counts + ([times, vector] if vector > 1 else [times] if times > 1 or pick([False, True]) else [])
    low, high = (0, 120) if kind[0] == 'u' else (-120, 120)
    values = numpy.random.default_rng(seed).integers(low, high, shape).astype(pick('<>') + kind)
    if kind[0] == 'f' and pick([False, True]):
        values.flat[:3] = numpy.nan, numpy.inf, -numpy.inf
    affine = numpy.eye(4)
    affine[:3, :3] = pick([numpy.diag([2, 3, 4]), numpy.diag([-1, 1.5, 1]),
                           numpy.array([[0, 2, 0], [-1, 0, 0], [0, 0, 1.5]]),
                           numpy.array([[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 2]])])
    affine[:3, 3] = pick([(0, 0, 0), (10.5, -20, 30)])
    version = pick([nibabel.Nifti1Image, nibabel.Nifti2Image])
    ending = pick(['.nii', '.nii.gz', '.hdr'])
    if ending == '.hdr':
        version = {nibabel.Nifti1Image: nibabel.Nifti1Pair, nibabel.Nifti2Image: nibabel.Nifti2Pair}[version]
    image = version(values, affine, dtype=values.dtype)
    way = pick(['both', 'sform', 'qform'])
    image.set_sform(affine, 1 if way != 'qform' else 0)
    image.set_qform(affine, 1 if way != 'sform' else 0)
    length, time = pick(['mm', 'meter', 'micron', 'unknown']), pick(['sec', 'msec', 'usec', 'unknown'])
    image.header.set_xyzt_units(length, time)
    step = pick([1.0, 2.5])
    if len(shape) > 3:
        image.header['pixdim'][4] = step
    path = folder / f'a{ending}'
    nibabel.save(image, path)
    scale = pick([None, None, (2.0, -5.0), (0.5, 0.0), (0.0, 7.0), (numpy.nan, 0.0), (-1.0, 0.0)])
    if scale and ending != '.nii.gz':
        rescale(path, image.header, scale)
    units = {'mm': 'mm', 'meter': 'm', 'micron': 'µm', 'unknown': ''}[length]
    seconds = {'sec': 's', 'msec': 'ms', 'usec': 'µs', 'unknown': ''}[time]
    return path, counts, times, vector, step, units, seconds, (kind, shape, ending, version.__name__, scale)


def rescale(path, header, scale):
    """Sets slope and intercept in the file, where nibabel would choose its own."""
    bare = bytearray(path.read_bytes())
    at, width = (112, 'f4') if header.sizeof_hdr == 348 else (176, 'f8')
    order = header.endianness
    bare[at:at + 2 * int(width[1])] = numpy.array(scale, order + width).tobytes()
    path.write_bytes(bytes(bare))


def compare(seed, folder):
    path, counts, times, vector, step, units, seconds, what = write(seed, folder)
    image = nibabel.load(path)
    values = numpy.asarray(image.dataobj)  # rescaled, where slope and intercept say so
    values = values.reshape(*counts, times, vector)
    found = info(path)
    same(found['times'], [step * t for t in range(times)] if times > 1 else [], (what, 'times'), 1e-6)
    assert units_of(found, 'length_units', units) == units, (what, found.get('length_units'))
    if times > 1:
        assert units_of(found, 'time_units', seconds) == seconds, (what, found.get('time_units'))
    chosen = random.Random(-seed).randrange(times)
    points, arrays, _ = converted(path, folder, '--time', f'#{chosen}')
    affine = image.affine
    # Slices may stand in the other order, each with its place.
    near = numpy.rint((points - affine[:3, 3]) @ numpy.linalg.inv(affine[:3, :3]).T).astype(int)
    same(near @ affine[:3, :3].T + affine[:3, 3], points, (what, 'places'), 1e-5)
    same(numpy.unique(near, axis=0), numpy.unique(lattice(counts), axis=0), (what, 'places'))
    wanted = values[near[:, 0], near[:, 1], near[:, 2], chosen]
    same(arrays['NIFTI'].reshape(-1, vector), wanted, what, 1e-12)


go_through('nifti', compare)
