"""Stacks of slices with answers worked out by hand; the witnesses try many more of each kind."""
import subprocess
import zlib

from against import VPROBE, cut, info, lattice, near, need

OME = ('<?xml version="1.0"?><OME xmlns="http://www.openmicroscopy.org/Schemas/OME/2016-06"><Image ID="Image:0"><Pixels '
       'ID="Pixels:0" DimensionOrder="XYZCT" Type="uint16" SizeX="5" SizeY="4" SizeZ="3" SizeC="1" SizeT="1" {}>'
       '<Channel ID="Channel:0:0" SamplesPerPixel="1"/>{}</Pixels></Image></OME>')


def refused(path, *words):
    done = subprocess.run([VPROBE, 'info', path], capture_output=True, encoding='utf-8')
    assert done.returncode == 2 and done.stderr.count('\n') == 1, done
    for word in words:
        assert word in done.stderr, (word, done.stderr)


def slices(numpy):
    """The slice k has the values 100 k."""
    return numpy.repeat(numpy.arange(3, dtype='u2') * 100, 20).reshape(3, 4, 5)


def ome(folder, name, about, data, pages, **options):
    import tifffile
    path = folder / name
    tifffile.imwrite(path, pages, description=OME.format(about, data).encode(), metadata=None,
                     photometric='minisblack', **options)
    return path


def tiff_order_and_units(folder):
    need('tifffile')
    numpy = need('numpy')
    pages = slices(numpy)
    at_first = ['--normal', '0', '0', '1', '--origin', '1', '1', '0.25', '--interpolate', 'linear']
    turned = ''.join(f'<TiffData IFD="{2 - k}" FirstZ="{k}"/>' for k in range(3))
    assert near(cut(ome(folder, 'turned.ome.tif', '', turned, pages), None, *at_first)['mean'], 175)
    # 3 x 2 nm and two steps of 2 um: 6 nm by 4000 nm along x.
    sizes = 'PhysicalSizeX="1" PhysicalSizeY="1" PhysicalSizeZ="2" PhysicalSizeXUnit="nm" PhysicalSizeYUnit="nm"'
    mixed = ome(folder, 'mixed.ome.tif', sizes + ' PhysicalSizeZUnit="um"', '<TiffData/>', pages)
    assert near(cut(mixed, None, '--normal', '1', '0', '0')['area'], 3 * 4000)
    assert info(mixed)['length_units'] == 'nm'
    # The default of the schema is the micron.
    assert info(ome(folder, 'plain.ome.tif', sizes.split(' PhysicalSizeXUnit')[0], '<TiffData/>',
                    pages))['length_units'] == 'µm'
    other = '<TiffData IFD="0" PlaneCount="3"><UUID FileName="gone.ome.tif">urn:uuid:1</UUID></TiffData>'
    here = '<TiffData IFD="0" FirstZ="0"/>'
    refused(ome(folder, 'parts.ome.tif', '', here + other.replace('PlaneCount="3"', 'FirstZ="1" PlaneCount="2"'), pages),
            'gone.ome.tif', 'keep the files together')
    refused(ome(folder, 'short.ome.tif', '', here, pages), 'no page of slice 1')
    refused(ome(folder, 'order.ome.tif', '', '<TiffData IFD="7"/>', pages), 'damaged')


def tiff_damaged(folder):
    """Packed pages that cannot be unpacked are an error, and so are pages cut short."""
    tifffile, numpy = need('tifffile'), need('numpy')
    path = folder / 'a.tif'
    tifffile.imwrite(path, lattice(numpy).astype('u2'), compression='zlib', photometric='minisblack')
    with tifffile.TiffFile(path) as file:
        place, size = file.pages[3].dataoffsets[0], file.pages[3].databytecounts[0]
    whole = path.read_bytes()
    for begin, bad in ((place, b'\0' * size), (place + 2, b'\xff\xff\xff')):
        path.write_bytes(whole[:begin] + bad + whole[begin + len(bad):])
        refused(path, 'truncated or damaged')


def tiff_imagej(folder):
    """One page and the values of all behind it, as ImageJ writes large stacks; signed values and units of its own."""
    tifffile, numpy = need('tifffile'), need('numpy')
    values = lattice(numpy)
    tifffile.imwrite(folder / 'large.tif', values.astype('u2'), imagej=True, truncate=True, metadata={'axes': 'ZYX'})
    with tifffile.TiffFile(folder / 'large.tif') as file:
        assert len(file.pages) == 1
    found = info(folder / 'large.tif')
    assert found['grid']['points'] == 120 and found['arrays'][0]['range'] == [0, 534], found
    text = 'ImageJ=1.53\nimages=6\nslices=6\nunit=\\u00B5m\nspacing=2\ncf=0\nc0=-32768\nc1=1\nvunit=HU\n'
    tifffile.imwrite(folder / 'signed.tif', (values - 100 + 32768).astype('u2'), description=text, metadata=None,
                     photometric='minisblack')
    found = info(folder / 'signed.tif')
    assert found['arrays'][0]['range'] == [-100, 434] and found['length_units'] == 'µm', found
    assert found['bounds'][5] == 10, found


def tiff_bits(folder):
    tifffile, numpy = need('tifffile'), need('numpy')
    mask = lattice(numpy) >= 300
    tifffile.imwrite(folder / 'mask.tif', mask, photometric='minisblack')
    sheet = cut(folder / 'mask.tif', None, '--normal', '0', '0', '1', '--origin', '1', '1', '2.5', '--interpolate',
                'linear')
    assert near(sheet['mean'], 0.5) and sheet['min'] == sheet['max'] == 0.5, sheet


def mrc_volumes(folder):
    """A stack of volumes is a series of times; IMOD's bytes have no sign unless its flag says so."""
    mrcfile, numpy = need('mrcfile'), need('numpy')
    values = lattice(numpy).astype('f4')
    with mrcfile.new(folder / 'stack.mrc') as file:
        file.set_data(numpy.stack([values, values + 1000]))
    assert info(folder / 'stack.mrc')['times'] == [0, 1]
    assert info(folder / 'stack.mrc', '--time', 'first')['arrays'][0]['range'] == [0, 534]
    assert info(folder / 'stack.mrc')['arrays'][0]['range'] == [1000, 1534]
    with mrcfile.new(folder / 'complex.mrc') as file:
        file.set_data(values.astype('c8'))
    refused(folder / 'complex.mrc', 'complex values', 'mode 2')


def meta_image_packed(folder):
    """Packed data are unpacked in full or not at all; a fourth dimension is time."""
    numpy = need('numpy')
    values = numpy.arange(120, dtype='<i2')
    head = 'ObjectType = Image\nNDims = 4\nDimSize = 5 4 3 2\nElementSpacing = 1 1 1 0.5\nElementType = MET_SHORT\n'
    packed = head + 'CompressedData = True\nElementDataFile = LOCAL\n'
    path = folder / 'a.mha'
    path.write_bytes(packed.encode() + zlib.compress(values.tobytes()))
    found = info(path, '--time', '0')
    assert found['times'] == [0, 0.5] and found['arrays'][0]['range'] == [0, 59], found
    path.write_bytes(packed.encode() + zlib.compress(values.tobytes()[:-2]))
    refused(path, 'cannot be unpacked')


def nrrd_text(folder):
    """Numbers as Fortran writes them are whole numbers; one more than there should be is one too many."""
    head = 'NRRD0004\ntype: double\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n'
    path = folder / 'a.nrrd'
    path.write_text(head + '1D2 1.0-100 nan Infinity -1.5 2 3 4\n')
    assert info(path)['arrays'][0]['range'] == [-1.5, 100], info(path)
    path.write_text(head + '1 2 3 4 5 6 7 8 9\n')
    refused(path, '9 values where 8 are wanted')


CASES = [tiff_order_and_units, tiff_damaged, tiff_imagej, tiff_bits, mrc_volumes, meta_image_packed, nrrd_text]
