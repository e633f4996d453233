"""NRRD and NIfTI whose values stay in their files: cuts give what the whole file gives, and read the rows they meet."""
import struct

from against import need
from damage import refused
from parts import PLANES, SIDES, field, same, table

ROWS = 17 * 23 * 4  # bytes of a layer, which is one part


def header(kind='float', about='', sides='17 23 19', endian='little', encoding='raw', dimension=3):
    return (f'NRRD0005\ntype: {kind}\ndimension: {dimension}\nsizes: {sides}\nendian: {endian}\nencoding: {encoding}\n'
            f'{about}\n').encode()


TURNED = 'space: left-posterior-superior\nspace directions: (0,1,0) (-0.5,0,0) (0,0,2)\nspace origin: (1,2,3)\n'
STRAIGHT = 'space: left-posterior-superior\nspace directions: (-0.5,0,0) (0,1,0) (0,0,2)\nspace origin: (1,2,3)\n'


# The headers by hand. The plane between the layers 4 and 5 has the means of both.
def stored_nrrd(folder):
    numpy = need('numpy')
    values = field(numpy)
    raw = values.tobytes()

    def made(name, head, data):
        (folder / name).write_bytes(head + data)
        return folder / name

    path = made('plain.nrrd', header(about='spacings: 0.5 1 2\n'), raw)
    same(path, planes=PLANES)
    _, stats = table(path, ['--normal', '0', '0', '1', '--origin', '4', '11', '9', '--memory', '2K'])
    between = (values[4].astype('f8') + values[5]) / 2
    assert abs(stats['sheets'][0]['max'] - between.max()) < 1e-6 * abs(between.max()), stats['sheets'][0]
    parts = stats['parts']
    assert (parts['all'], parts['met'], parts['bytes_met']) == (19, 2, 2 * ROWS), parts
    assert parts['bytes_read'] == parts['read'] * ROWS, parts
    same(made('skip.nrrd', header(about='byte skip: 3\nline skip: 2\n'), b'a line\nand one\nxyz' + raw))
    same(made('end.nrrd', header(about='byte skip: -1\n'), b'whatever' + raw))
    same(made('straight.nrrd', header(about=STRAIGHT), raw))
    for kind, name, endian in (('>i2', 'short', 'big'), ('u1', 'uchar', 'little'), ('>f8', 'double', 'big')):
        same(made(f'{name}.nrrd', header(name, endian=endian), field(numpy, kind=kind).tobytes()))
    (folder / 'beside.raw').write_bytes(b'head' + raw)
    same(made('detached.nhdr', header(about='byte skip: 4\ndata file: beside.raw\n'), b''), planes=PLANES[:1])
    (folder / 'below').mkdir()
    (folder / 'below' / 'beside.raw').write_bytes(raw)
    same(made('below.nhdr', header(about='data file: below/beside.raw\n'), b''))
    vectors = numpy.stack([values, -values, 2 * values], axis=-1)
    same(made('vectors.nrrd', header(sides='3 17 23 19', dimension=4, about='kinds: 3-vector space space space\n'),
              vectors.tobytes()), ['--component', 'magnitude'])
    times = numpy.stack([values, 3 * values])
    path = made('times.nrrd', header(sides='17 23 19 2', dimension=4, about='kinds: space space space time\n'),
                times.tobytes())
    for time in ('first', 'last'):
        same(path, ['--time', time])
    top = table(path, ['--time', 'last', '--normal', '0', '0', '1', '--origin', '8', '11', '4.5', '--memory', '2K'])
    assert abs(top[1]['sheets'][0]['max'] - 3 * between.max()) < 1e-5 * abs(between.max()), top[1]['sheets'][0]
    # These are read as a whole.
    same(made('turned.nrrd', header(about=TURNED), raw), stays=False)
    same(made('text.nrrd', header(encoding='text'), b' '.join(b'%r' % float(v) for v in values.ravel())), stays=False)
    same(made('planes.nrrd', header(sides='17 23 19 3', dimension=4, about='kinds: space space space 3-vector\n'),
              numpy.moveaxis(vectors, -1, 0).tobytes()), ['--component', 'magnitude'], stays=False)
    (folder / 'half.raw').write_bytes(raw[:len(raw) // 2])
    for part in range(19):
        (folder / f'part{part}.raw').write_bytes(values[part].tobytes())
    same(made('list.nhdr', header(about='data file: LIST 2\n' + '\n'.join(f'part{n}.raw' for n in range(19))), b''),
         stays=False)
    same(made('pattern.nhdr', header(about='data file: part%d.raw 0 18 1 2\n'), b''), stays=False)
    for name, about, data in (('short.nrrd', '', raw[:-1]), ('half.nhdr', 'data file: half.raw\n', b''),
                              ('gone.nhdr', 'data file: gone.raw\n', b''), ('far.nrrd', 'byte skip: 99999\n', raw)):
        refused(made(name, header(about=about), data), options=['--memory', '2K'])
    refused(made('wide.nrrd', header(sides=f'{2**40} {2**40} 19'), raw), options=['--memory', '2K'])


# By nibabel. What it writes with a determinant below zero, VTK reads with its layers in reverse.
def stored_nifti(folder):
    numpy, nibabel = need('numpy'), need('nibabel')
    values = field(numpy).transpose(2, 1, 0)
    steps = {'ras': (0.5, 1, 2), 'las': (-0.5, 1, 2), 'lps': (-0.5, -1, 2), 'down': (0.5, 1, -2)}
    places = {name: numpy.diag([*step, 1.0]) for name, step in steps.items()}
    for name, place in places.items():
        place[:3, 3] = 3, 2, 1
        path = folder / f'{name}.nii'
        nibabel.save(nibabel.Nifti1Image(values, place), path)
        same(path)
        # The plane between the layers 4 and 5, as nibabel has them.
        at = place @ [8, 11, 4.5, 1]
        _, stats = table(path, ['--normal', '0', '0', '1', '--origin', *map(str, at[:3]), '--memory', '2K'])
        between = (values[:, :, 4].astype('f8') + values[:, :, 5]) / 2
        assert abs(stats['sheets'][0]['max'] - between.max()) < 1e-6 * abs(between.max()), (name, stats['sheets'][0])
        parts = stats['parts']
        assert (parts['all'], parts['met'], parts['bytes_met']) == (19, 2, 2 * ROWS), (name, parts)
    las = places['las']
    for kind in ('>i2', 'u1', '>f8', '<u4', 'c8'):
        image = nibabel.Nifti1Image(values.astype(kind), las)
        image.header.set_slope_inter(1, 0)
        if kind[0] == '>':
            image = nibabel.Nifti1Image(values.astype(kind), las, header=nibabel.Nifti1Header(endianness='>'))
            image.header.set_data_dtype(kind)
        nibabel.save(image, folder / 'kind.nii')
        same(folder / 'kind.nii', ['--component', 'magnitude'] if kind == 'c8' else ())
    for kind, image in (('pair.img', nibabel.Nifti1Pair(values, las)), ('two.nii', nibabel.Nifti2Image(values, las))):
        nibabel.save(image, folder / kind)
        same((folder / kind).with_suffix('.hdr') if kind.endswith('img') else folder / kind)
    # More header behind the header.
    image = nibabel.Nifti1Image(values, las)
    image.header.extensions.append(nibabel.nifti1.Nifti1Extension('comment', b'x' * 100))
    nibabel.save(image, folder / 'extended.nii')
    same(folder / 'extended.nii')
    colors = numpy.zeros(values.shape, [('R', 'u1'), ('G', 'u1'), ('B', 'u1')])
    for number, name in enumerate('RGB'):
        colors[name] = (values / (8 + number)).astype('i4') & 255
    nibabel.save(nibabel.Nifti1Image(colors, las), folder / 'colors.nii')
    same(folder / 'colors.nii')
    for sides in ('four', 'five'):
        times = numpy.stack([values, 3 * values], axis=-1)
        nibabel.save(nibabel.Nifti1Image(times[..., None] if sides == 'five' else times, las), folder / f'{sides}.nii')
        for time in ('first', 'last'):
            same(folder / f'{sides}.nii', ['--time', time])
    # These are read as a whole.
    scaled = nibabel.Nifti1Image(values.astype('i2'), las)
    scaled.header.set_slope_inter(0.5, 3)
    nibabel.save(scaled, folder / 'scaled.nii')
    same(folder / 'scaled.nii', stays=False)
    nibabel.save(nibabel.Nifti1Image(values, las), folder / 'packed.nii.gz')
    same(folder / 'packed.nii.gz', stays=False)
    vectors = numpy.stack([values, -values, 2 * values], axis=-1)[:, :, :, None]
    nibabel.save(nibabel.Nifti1Image(vectors, las), folder / 'vectors.nii')
    same(folder / 'vectors.nii', ['--component', 'magnitude'], stays=False)
    turned = numpy.array([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
    nibabel.save(nibabel.Nifti1Image(values, turned), folder / 'turned.nii')
    same(folder / 'turned.nii', stays=False)
    # Sizes and offsets that lead outside.
    sound = (folder / 'las.nii').read_bytes()
    for name, wrong in (('short', sound[:-1]), ('sides', sound[:46] + struct.pack('<h', 32000) + sound[48:]),
                        ('offset', sound[:108] + struct.pack('<f', 1e9) + sound[112:]),
                        ('before', sound[:108] + struct.pack('<f', -1e9) + sound[112:])):
        (folder / f'{name}.nii').write_bytes(wrong)
        refused(folder / f'{name}.nii', options=['--memory', '2K'])
    assert SIDES == values.shape[::-1]


CASES = [stored_nrrd, stored_nifti]
