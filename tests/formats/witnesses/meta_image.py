#!/usr/bin/env python3
"""MetaImage in many spellings, read by vprobe.

usage: meta_image.py VPROBE [FIRST-SEED COUNT]

Debian has no Python library of the format. Every third file is written by vtkMetaImageWriter and read by
vtkMetaImageReader. The others are written by hand, after the description of MetaIO (https://itk.org/Wiki/MetaIO): all
types, both orders of bytes, text, zlib, four dimensions, channels, matrices, lists and patterns of files, headers to
skip; damaged ones among them. VPROBE_LONG asks for 500 files.
"""
import random
import zlib

from common import converted, go_through, info, lattice, need, refused, same, units_of

need('numpy', 'vtkmodules')
import numpy  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData  # noqa: E402
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkMetaImageWriter  # noqa: E402

# MetaIO's own sizes: a long has 4 bytes, on every machine.
TYPES = {'MET_CHAR': 'i1', 'MET_UCHAR': 'u1', 'MET_SHORT': 'i2', 'MET_USHORT': 'u2', 'MET_INT': 'i4', 'MET_UINT': 'u4',
         'MET_LONG': 'i4', 'MET_ULONG': 'u4', 'MET_LONG_LONG': 'i8', 'MET_ULONG_LONG': 'u8', 'MET_FLOAT': 'f4',
         'MET_DOUBLE': 'f8'}


def by_vtk(seed, folder):
    chance = random.Random(seed)
    counts = [chance.randint(2, 6) for _ in range(3)]
    kind = chance.choice(['i1', 'u1', 'i2', 'u2', 'i4', 'u4', 'f4', 'f8'])
    values = numpy.random.default_rng(seed).integers(0, 100, counts[0] * counts[1] * counts[2]).astype(kind)
    image = vtkImageData()
    image.SetDimensions(counts)
    image.SetOrigin(chance.choice([(0, 0, 0), (1.5, -20, 300)]))
    image.SetSpacing(chance.choice([(1, 1, 1), (0.5, 2, 1.25)]))
    array = numpy_to_vtk(values, deep=True)
    array.SetName('f')
    image.GetPointData().SetScalars(array)
    path = folder / chance.choice(['a.mha', 'a.mhd'])
    writer = vtkMetaImageWriter()
    writer.SetFileName(str(path))
    if path.suffix == '.mhd':
        writer.SetRAWFileName(str(folder / 'a.raw'))
    writer.SetCompression(chance.choice([False, True]))
    writer.SetInputData(image)
    writer.Write()
    reader = vtkMetaImageReader()
    reader.SetFileName(str(path))
    reader.Update()
    read = reader.GetOutput()
    places = [read.GetPoint(i) for i in range(read.GetNumberOfPoints())]
    return path, ('VTK', kind), vtk_to_numpy(read.GetPointData().GetScalars())[None, :, None], places, [0.0], ''


def number_text(value):
    if isinstance(value, (numpy.floating, float)):
        return {'nan': 'nan', 'inf': 'inf', '-inf': '-inf'}.get(str(value), repr(float(value)))
    return str(int(value))


def by_hand(seed, folder):
    chance = random.Random(seed)
    pick = chance.choice
    name, kind = pick(list(TYPES.items()))
    times, channels = pick([1, 1, 2, 3]), pick([1, 1, 1, 3])
    counts = [chance.randint(2, 5) for _ in range(3)]
    info_of = numpy.iinfo(kind) if kind[0] in 'iu' else None
    low, high = (info_of.min, info_of.max) if info_of else (-1000, 1000)
    values = numpy.random.default_rng(seed).integers(low, high, (times, counts[0] * counts[1] * counts[2], channels),
                                                     dtype='u8' if kind == 'u8' else 'i8', endpoint=True).astype(kind)
    if info_of is None:
        values = values / 3
        values = values.astype(kind)
        values.flat[:3] = numpy.nan, numpy.inf, -numpy.inf
    axes = 4 if times > 1 or pick([False, False, True]) else 3
    spacing = [pick([1, 0.5, 2.25, -1.5]) for _ in range(3)] + [pick([0.5, 2])]
    offset = [pick([0, 10.5, -3]) for _ in range(3)] + [pick([0, 4.5])]
    matrix = numpy.array(pick([[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [-1, 0, 0], [0, 0, 1]],
                               [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, -1]]]), float)
    rows = numpy.eye(axes)
    rows[:3, :3] = matrix
    order = pick('<>')
    text, packed = pick([(False, False), (False, False), (False, True), (True, False)])
    units = pick(['', '', 'mm', 'um', 'cm'])
    lines = ['ObjectType = Image', f'NDims = {axes}', f'BinaryData = {not text}',
             f'{pick(["BinaryDataByteOrderMSB", "ElementByteOrderMSB"])} = {order == ">"}',
             f'{pick(["TransformMatrix", "Rotation", "Orientation"])} = ' + ' '.join(map(str, rows.ravel())),
             f'{pick(["Offset", "Position", "Origin"])} = ' + ' '.join(map(str, offset[:axes])),
             f'{pick(["ElementSpacing", "ElementSize"])} = ' + ' '.join(map(str, spacing[:axes])),
             'DimSize = ' + ' '.join(map(str, (counts + [times])[:axes]))]
    lines += [f'DistanceUnits = {units}'] if units else []
    lines += [f'ElementNumberOfChannels = {channels}'] if channels > 1 else []
    lines += [f'ElementType = {name}{pick(["", "_ARRAY"]) if channels > 1 else ""}']
    chance.shuffle(lines)
    data = values.astype(order + kind).tobytes()
    if text:
        data = ' '.join(number_text(value) for value in values.ravel()).encode()
    path = write(chance, folder, lines, data, counts + [times] if axes == 4 else counts, text, packed)
    steps = [matrix[i] * spacing[i] for i in range(3)]
    moments = [offset[3] + spacing[3] * t for t in range(times)]
    return path, (name, times, channels, text, packed), values, lattice(counts, offset[:3], steps), moments, \
        {'um': 'µm'}.get(units, units)


def write(chance, folder, lines, data, counts, text, packed):
    pick = chance.choice
    way = pick(['local', 'file', 'behind', 'end', 'list', 'pattern']) if not text else pick(['local', 'file'])
    lines += [f'CompressedData = {packed}'] if packed or pick([False, True]) else []
    pack = zlib.compress if packed else bytes
    path = folder / ('a.mha' if way == 'local' else 'a.mhd')
    if way in ('list', 'pattern'):
        size = len(data) // counts[-1]
        names = [f's{3 + 2 * i:03}.raw' for i in range(counts[-1])]
        for i, name in enumerate(names):
            (folder / name).write_bytes(pack(data[i * size:(i + 1) * size]))
        last = 'LIST\n' + '\n'.join(names) if way == 'list' else f's%03d.raw 3 {1 + 2 * counts[-1]} 2'
        path.write_text('\n'.join(lines) + f'\nElementDataFile = {last}\n')
        return path
    stored = pack(data)
    if packed and pick([False, True]):
        lines += [f'CompressedDataSize = {len(stored)}']
    if way == 'local':
        path.write_bytes('\n'.join(lines).encode() + b'\nElementDataFile = LOCAL\n' + stored)
        return path
    before = b''
    if way == 'behind':
        before = b'a header of another program'
        lines += [f'HeaderSize = {len(before)}']
    elif way == 'end' and not packed:
        before = b'something'
        lines += ['HeaderSize = -1']
    (folder / 'a.raw').write_bytes(before + stored)
    path.write_text('\n'.join(lines) + '\nElementDataFile = a.raw\n')
    return path


def compare_damaged(seed, folder):
    """Packed data with a wrong byte, text with a number too many, and data cut short are no values."""
    lines = 'ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementType = MET_SHORT\n'
    data = numpy.arange(64, dtype='<i2').tobytes()
    packed = bytearray(zlib.compress(data))
    path = folder / 'a.mha'
    way = seed % 4
    if way == 0:
        packed[random.Random(seed).randrange(2, len(packed))] ^= 0x55
        lines, data = lines + 'CompressedData = True\n', bytes(packed)
    elif way == 1:
        lines, data = lines + 'CompressedData = True\n', bytes(packed[:-6])
    elif way == 2:
        lines, data = lines + 'BinaryData = False\n', b'1 ' * 65
    else:
        data = data[:-1]
    path.write_bytes(lines.encode() + b'ElementDataFile = LOCAL\n' + data)
    assert 'truncated or damaged' in refused(path), way


def compare(seed, folder):
    if seed % 10 == 0:
        return compare_damaged(seed // 10, folder)
    path, what, values, places, moments, units = (by_vtk if seed % 3 == 0 else by_hand)(seed, folder)
    found = info(path)
    same(found['times'], moments if len(moments) > 1 else [], (what, 'times'))
    assert units_of(found, 'length_units', units) == units, (what, found)
    step = random.Random(-seed).randrange(len(moments))
    points, arrays, _ = converted(path, folder, '--time', f'#{step}')
    same(points, places, (what, 'places'), 1e-9)
    ours = arrays['MetaImage']
    assert what[0] == 'VTK' or ours.dtype == values.dtype, (what, ours.dtype)
    same(ours.reshape(values.shape[1:]), values[step], what)


go_through('meta_image', compare)
