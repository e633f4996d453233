"""Which way is up: flat pictures of a volume with one bright corner."""
import numpy

from against import need, vprobe

SIDE = 8


def volume():
    """Indices (i, j, k), bright where all three are high."""
    values = numpy.zeros((SIDE, SIDE, SIDE), numpy.uint8)
    values[-3:, -3:, -3:] = 200
    return values


def corner_of(folder, path, *options):
    """Where the bright part of the plot lies: (right or left, top or bottom)."""
    need('vtkmodules.vtkIOImage')
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
    picture = folder / 'picture.png'
    vprobe('slice', path, '--classify', 'cpu', '--size', '400x400', '--no-legend', '--title', '', '--colormap', 'turbo',
           '--background', 'white', '-o', picture, *options)
    reader = vtkPNGReader()
    reader.SetFileName(str(picture))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    rows = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[::-1].astype(int)
    red, green, blue = rows[..., 0], rows[..., 1], rows[..., 2]
    inside = (blue > red + 10) & (red < 90) & (green < 60)  # turbo's low end
    bright = (red > 90) & (green < 60) & (blue < 60)  # its high end
    assert bright.sum() > 200, bright.sum()
    y, x = numpy.nonzero(inside | bright)
    center = (x.min() + x.max()) / 2, (y.min() + y.max()) / 2
    y, x = numpy.nonzero(bright)
    return 'right' if x.mean() > center[0] else 'left', 'bottom' if y.mean() > center[1] else 'top'


def through(axis, sign=''):
    """A plane through the bright part."""
    return ['--origin', 6, 6, 6, '--normal', sign + axis]


def expect(folder, path, views, places=through):
    for axis, wanted in views.items():
        found = corner_of(folder, path, *places(axis[-1], axis[:-1]))
        assert found == wanted, (path.name, axis, found, wanted)


def pictures_of_engineers(folder):
    path = folder / 'plain.nrrd'
    header = f'NRRD0004\ntype: uint8\ndimension: 3\nsizes: {SIDE} {SIDE} {SIDE}\nencoding: raw\n\n'
    path.write_bytes(header.encode() + volume().tobytes(order='F'))
    expect(folder, path, {'x': ('right', 'top'), 'y': ('right', 'top'), 'z': ('right', 'top'),
                          '-x': ('left', 'top'), '-y': ('left', 'top'), '-z': ('left', 'top')})
    # A given up axis wins: y down means that the bright corner is at the bottom.
    found = corner_of(folder, path, *through('z'), '--up', 0, -1, 0)
    assert found == ('left', 'bottom'), found


def pictures_of_rows(folder):
    tifffile = need('tifffile')
    stack = volume().transpose(2, 1, 0)  # pages, rows, columns
    numpy.save(folder / 'rows.npy', stack)
    tifffile.imwrite(folder / 'rows.tif', stack)
    for path in (folder / 'rows.npy', folder / 'rows.tif'):
        expect(folder, path, {'z': ('right', 'bottom'), 'y': ('right', 'bottom'), 'x': ('right', 'bottom')})


def pictures_of_patients(folder):
    """The bright corner is on the patient's left, at the back, at the head."""
    def headed(name, header, flips):
        path = folder / name
        values = volume()[tuple(slice(None, None, -1) if flip else slice(None) for flip in flips)]
        path.write_bytes(header.encode() + values.tobytes(order='F'))
        return path

    nrrd = (f'NRRD0004\ntype: uint8\ndimension: 3\nspace: {{}}\nsizes: {SIDE} {SIDE} {SIDE}\nencoding: raw\n'
            'space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n\n')
    meta = (f'ObjectType = Image\nNDims = 3\nDimSize = {SIDE} {SIDE} {SIDE}\nElementType = MET_UCHAR\n'
            'AnatomicalOrientation = RAI\nElementDataFile = LOCAL\n')
    files = [(headed('lps.nrrd', nrrd.format('left-posterior-superior'), (0, 0, 0)), (6, 6, 6)),
             (headed('ras.nrrd', nrrd.format('RAS'), (1, 1, 0)), (1, 1, 6)),
             (headed('lps.mha', meta, (0, 0, 0)), (6, 6, 6))]
    nibabel = need('nibabel')
    nifti = folder / 'ras.nii'
    nibabel.save(nibabel.Nifti1Image(volume()[::-1, ::-1], numpy.eye(4)), nifti)
    files.append((nifti, (1, 1, 6)))
    for path, origin in files:
        def places(axis, sign, origin=origin):
            return ['--origin', *origin, '--normal', sign + axis]
        # Axial from the feet: left at the right, back at the bottom. Coronal from the front: left at the right, head at
        # the top. Sagittal from the left: back at the right, head at the top.
        expect(folder, path, {'z': ('right', 'bottom'), 'y': ('right', 'top'), 'x': ('right', 'top'),
                              '-z': ('left', 'bottom')}, places)


def pictures_of_frames(folder):
    """DICOM, as pydicom writes it."""
    pydicom = need('pydicom')
    from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
    from pydicom.uid import CTImageStorage, ExplicitVRLittleEndian, generate_uid
    series = folder / 'series'
    series.mkdir()
    study = generate_uid()
    for k in range(SIDE):
        meta = FileMetaDataset()
        meta.MediaStorageSOPClassUID = CTImageStorage
        meta.MediaStorageSOPInstanceUID = generate_uid()
        meta.TransferSyntaxUID = ExplicitVRLittleEndian
        item = FileDataset(str(series / f'{k}.dcm'), Dataset(), file_meta=meta, preamble=b'\0' * 128)
        item.is_little_endian, item.is_implicit_VR = True, False
        item.SOPClassUID, item.SOPInstanceUID = meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID
        item.Modality, item.StudyInstanceUID, item.SeriesInstanceUID = 'CT', study, study
        item.ImagePositionPatient, item.ImageOrientationPatient = [0, 0, k], [1, 0, 0, 0, 1, 0]
        item.PixelSpacing, item.Rows, item.Columns = [1, 1], SIDE, SIDE
        item.SamplesPerPixel, item.PhotometricInterpretation = 1, 'MONOCHROME2'
        item.BitsAllocated = item.BitsStored = 8
        item.HighBit, item.PixelRepresentation, item.InstanceNumber = 7, 0, k
        item.PixelData = volume()[:, :, k].T.tobytes()
        item.save_as(series / f'{k}.dcm', write_like_original=False)
    assert pydicom.dcmread(series / '0.dcm').Rows == SIDE
    expect(folder, series / '0.dcm', {'z': ('right', 'bottom'), 'y': ('right', 'top'), 'x': ('right', 'top')})


CASES = [pictures_of_engineers, pictures_of_rows, pictures_of_patients, pictures_of_frames]
