"""Pictures of two dimensions that are given one by one make a volume. Every answer is worked out by hand."""
import json
import subprocess

from against import VPROBE, cut, info, near, need
from everyday import png


def picture_files(folder, numpy):
    """Three pictures of 4 x 3 values in each format; slice k has 100 k + x."""
    tifffile, nibabel, mrcfile = need('tifffile'), need('nibabel'), need('mrcfile')
    image = need('vtkmodules.vtkCommonDataModel').vtkImageData
    writer = need('vtkmodules.vtkIOXML').vtkXMLImageDataWriter()
    from vtkmodules.util.numpy_support import numpy_to_vtk
    files = {}
    for k in (2, 10, 1):
        values = numpy.tile(numpy.arange(4, dtype='<i2'), (3, 1)) + numpy.int16(100 * k)

        def name(ending):
            files.setdefault(ending, []).append(folder / f's{k}.{ending}')
            return files[ending][-1]
        tifffile.imwrite(name('tif'), values.astype('u2'), photometric='minisblack', metadata=None)
        name('png').write_bytes(png((values // 10).tolist()))
        numpy.save(name('npy'), values)
        with mrcfile.new(name('mrc')) as file:
            file.set_data(values)
        place = numpy.diag([1.0, 1.0, 1.0, 1.0])
        place[2, 3] = 10 + 0.5 * k
        nibabel.save(nibabel.Nifti1Image(values.T, place), name('nii'))
        name('mha').write_bytes(b'ObjectType = Image\nNDims = 2\nDimSize = 4 3\nElementSpacing = 2 1\n'
                                b'ElementType = MET_SHORT\nElementDataFile = LOCAL\n' + values.tobytes())
        name('nrrd').write_bytes(b'NRRD0004\ntype: short\ndimension: 2\nsizes: 4 3\nendian: little\n'
                                 b'encoding: raw\n\n' + values.tobytes())
        flat = image()
        flat.SetExtent(0, 3, 0, 2, k, k)
        flat.SetSpacing(1, 1, 0.25)
        array = numpy_to_vtk(values.ravel(), deep=True)
        array.SetName('v')
        flat.GetPointData().SetScalars(array)
        writer.SetFileName(str(name('vti')))
        writer.SetInputData(flat)
        writer.Write()
    return files


def stacks(folder):
    """Pictures given one by one are slices of a volume, in the order of their numbers or at their own places."""
    numpy = need('numpy')
    files = picture_files(folder, numpy)
    for ending in ('tif', 'png', 'npy', 'mrc', 'mha', 'nrrd'):
        given = files[ending] if ending != 'npy' else files[ending] + ['--inputs', 'stack']
        about = info(*given)
        assert about['grid']['points'] == 4 * 3 * 3 and about['bounds'][4:] == [0, 2], (ending, about)
        sheet = cut(given[0], None, *given[1:], '--normal', 'z', '--origin', 1, 1, 2, '--interpolate', 'linear')
        # The last of three is s10: a mean of 1000 + 1.5; the PNG has a tenth, rounded down.
        assert near(sheet['mean'], 1001.5 if ending != 'png' else 100), (ending, sheet['mean'])
        assert near(sheet['area'], 12 if ending == 'mha' else 6), (ending, sheet['area'])
    # s1, s2 and s10 lie where their files say: half a unit, then four, so the distances are not even.
    for ending, low, step in (('nii', 10, 0.5), ('vti', 0, 0.25)):
        assert info(*files[ending])['bounds'][4:] == [low + step, low + 10 * step], ending
        at = ['--normal', 'z', '--origin', 1, 1, low + 4 * step]
        sheet = cut(files[ending][0], None, *files[ending][1:], *at, '--interpolate', 'linear')
        assert near(sheet['mean'], 401.5), (ending, sheet['mean'])  # a quarter of the way from 200 to 1000


def stacks_refused(folder):
    numpy = need('numpy')
    tifffile = need('tifffile')
    for name, shape in (('a1', (3, 4)), ('a2', (3, 5)), ('b1', (3, 4)), ('b2', (2, 3, 4)), ('c1', (2, 3, 4)),
                        ('c2', (2, 3, 4))):
        tifffile.imwrite(folder / f'{name}.tif', numpy.zeros(shape, 'u1'), photometric='minisblack', metadata=None)

    def told(*arguments):
        done = subprocess.run([VPROBE, 'info', *arguments], capture_output=True, encoding='utf-8', cwd=folder)
        assert done.returncode in (1, 2) and done.stderr.count('\n') == 1, done
        return done.stderr
    assert 'a2.tif has another size or type than a1.tif' in told('a1.tif', 'a2.tif')
    assert 'b1.tif: nothing to slice' in told('b1.tif', 'b2.tif')
    assert 'b2.tif has 2 pages' in told('b1.tif', 'b2.tif', '--inputs', 'stack')
    assert 'c1.tif has 2 pages' in told('c1.tif', 'c2.tif', '--inputs', 'stack')
    assert 'no file' in told('c1.tif', 'demo:blob', '--inputs', 'stack')
    # Volumes are what they were: times of a series, by a pattern too.
    for given in (('c1.tif', 'c2.tif'), ('c*.tif', '--inputs', 'times')):
        done = subprocess.run([VPROBE, 'info', '--json', *given], capture_output=True, encoding='utf-8', cwd=folder)
        assert json.loads(done.stdout)['times'] == [1, 2], (given, done)
    numpy.save(folder / 'd1.npy', numpy.zeros((3, 4)))
    numpy.save(folder / 'd2.npy', numpy.zeros((4, 4)))
    assert 'd2.npy has another size or direction than d1.npy' in told('d1.npy', 'd2.npy', '--inputs', 'stack')
    assert 'no such file' in told('a1.tif', 'a9.tif')


CASES = [stacks, stacks_refused]
