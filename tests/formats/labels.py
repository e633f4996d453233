"""Files that say that they are segmentations: their values are not mixed, and areas are those of voxels."""
import numpy

from against import cut, need, near

SIDE = 10


def tissue():
    """More than 32 values, so that only the file can tell that they are labels; 50 in a block of 3 x 4 x 5 voxels."""
    i, j, k = numpy.indices((SIDE, SIDE, SIDE))
    values = ((31 * i + 17 * j + 5 * k) % 40).astype(numpy.int16)
    values[3:6, 2:6, 2:7] = 50
    return values


def expect_labels(path):
    """A plane a little above the layer 4 shows 3 x 4 voxels of 50; between layers nothing is mixed."""
    sheet = cut(path, None, '--normal', 'z', '--origin', 5, 5, 4.2)
    assert near(sheet['labels']['50'], 12.0), sheet['labels']
    assert near(sum(sheet['labels'].values()), (SIDE - 1) ** 2), sheet['labels']
    assert 'labels' not in cut(path, None, '--interpolate', 'linear')


def labels_of_nifti(folder):
    nibabel = need('nibabel')
    image = nibabel.Nifti1Image(tissue(), numpy.eye(4))
    nibabel.save(image, folder / 'scan.nii')
    assert 'labels' not in cut(folder / 'scan.nii', None)
    image.header.set_intent('label')
    nibabel.save(image, folder / 'labels.nii')
    expect_labels(folder / 'labels.nii')


def labels_of_slicer(folder):
    header = (f'NRRD0004\ntype: int16\ndimension: 3\nsizes: {SIDE} {SIDE} {SIDE}\nencoding: raw\nendian: little\n'
              'space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n')
    for name, keys in (('a.seg.nrrd', ''), ('b.nrrd', 'Segment0_ID:=Segment_1\n')):
        (folder / name).write_bytes((header + keys + '\n').encode() + tissue().tobytes(order='F'))
        expect_labels(folder / name)
    (folder / 'c.nrrd').write_bytes((header + '\n').encode() + tissue().tobytes(order='F'))
    assert 'labels' not in cut(folder / 'c.nrrd', None)


def labels_of_zarr(folder):
    zarr = need('zarr')
    group = zarr.open_group(str(folder / 'labels.zarr'), mode='w')
    group.create_dataset('0', data=tissue().transpose(2, 1, 0))
    assert 'labels' not in cut(folder / 'labels.zarr', None)
    group.attrs['image-label'] = {'version': '0.4'}
    expect_labels(folder / 'labels.zarr')


def labels_by_their_values(folder):
    """Without a word of the file, at most 32 integers are labels, and a ramp of gray is none."""
    few = tissue() % 7
    numpy.save(folder / 'few.npy', few)
    areas = cut(folder / 'few.npy', None, '--normal', 'z', '--origin', 5, 5, 4.2)['labels']
    assert set(areas) == {str(value) for value in range(7)}, areas
    ramp = numpy.broadcast_to(numpy.arange(20, dtype=numpy.uint8) * 12, (20, 20, 20))
    numpy.save(folder / 'ramp.npy', ramp)
    assert 'labels' not in cut(folder / 'ramp.npy', None)


def mean_of_labels(folder):
    """12 of 81 voxels have 50, the others 10: a mean of (12 * 50 + 69 * 10) / 81. Values between two are none."""
    values = numpy.full((SIDE, SIDE, SIDE), 10, numpy.int16)
    values[2:7, 2:6, 3:6] = 50  # z, y, x
    numpy.save(folder / 'few.npy', values)
    at = ['--normal', 'z', '--origin', 5, 5, 4.2]
    sheet = cut(folder / 'few.npy', None, *at)
    assert near(sheet['labels']['50'], 12) and near(sheet['labels']['10'], 69), sheet['labels']
    assert near(sheet['mean'], 1290 / 81) and (sheet['min'], sheet['max']) == (10, 50), sheet
    # A plane between two voxels of different layers, at a third of the way: still no value between.
    sheet = cut(folder / 'few.npy', None, '--normal', 'z', '--origin', 5, 5, 6.4)
    assert near(sheet['mean'], 1290 / 81) and (sheet['min'], sheet['max']) == (10, 50), sheet
    linear = cut(folder / 'few.npy', None, *at, '--interpolate', 'linear')
    assert near(linear['mean'], 1290 / 81), linear  # the voxels' corners are midway between points


def names_of_segments(folder):
    """As 3D Slicer writes them; two segments of two layers with one value have no name."""
    header = (f'NRRD0004\ntype: int16\ndimension: 3\nsizes: {SIDE} {SIDE} {SIDE}\nencoding: raw\nendian: little\n'
              'space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n')
    keys = ''
    for number, value, name in ((0, 50, 'left lung'), (1, 7, 'liver'), (2, 7, 'heart'), (3, 9, 'aorta'), (4, 99, 'gone')):
        keys += f'Segment{number}_ID:=Segment_{number}\nSegment{number}_Name:={name}\nSegment{number}_LabelValue:={value}\n'
    (folder / 'a.seg.nrrd').write_bytes((header + keys + '\n').encode() + tissue().tobytes(order='F'))
    sheet = cut(folder / 'a.seg.nrrd', None, '--normal', 'z', '--origin', 5, 5, 4.2)
    assert sheet['label_names'] == {'50': 'left lung', '9': 'aorta'}, sheet['label_names']
    (folder / 'b.seg.nrrd').write_bytes((header + '\n').encode() + tissue().tobytes(order='F'))
    assert 'label_names' not in cut(folder / 'b.seg.nrrd', None)


CASES = [labels_of_nifti, labels_of_slicer, labels_of_zarr, labels_by_their_values, mean_of_labels,
         names_of_segments]
