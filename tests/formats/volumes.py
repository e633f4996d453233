"""Volumes and lattices that other programs write."""
import subprocess

from against import VPROBE, Missing, compare, info, lattice, near, need, nrrd


def numpy_arrays(folder):
    numpy = need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values)
    for name, array in {'c': values, 'fortran': numpy.asfortranarray(values.transpose(2, 1, 0)),
                        'single': values.astype('>f4'), 'short': values.astype('i2')}.items():
        numpy.save(folder / f'{name}.npy', array)
        compare(folder / f'{name}.npy', reference, [(f'point:{name}', 'point:f')])
    numpy.savez(folder / 'stored.npz', f=values, half=values / 2, table=numpy.eye(3))
    numpy.savez_compressed(folder / 'packed.npz', f=values, vector=numpy.stack([values] * 3, axis=-1))
    for name in ('stored', 'packed'):
        compare(folder / f'{name}.npz', reference, [('point:f', 'point:f')])
    arrays = {a['name']: a['components'] for a in info(folder / 'packed.npz')['arrays']}
    assert arrays == {'f': 1, 'vector': 3}, arrays


def raw(folder):
    numpy = need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 0 0 0\n')
    (folder / 'big.raw').write_bytes(b'a header' + values.astype('>u2').tobytes())
    compare(folder / 'big.raw', reference, [('point:values', 'point:f')],
            ['--raw-size', '5x4x6', '--raw-type', 'uint16', '--raw-spacing', '0.5x1x2', '--raw-order', 'big'])


def netcdf(folder):
    netcdf4, numpy = need('netCDF4'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 10 20 30\n')
    for form in ('NETCDF3_CLASSIC', 'NETCDF3_64BIT_OFFSET', 'NETCDF4', 'NETCDF4_CLASSIC'):
        path = folder / f'{form}.nc'
        with netcdf4.Dataset(path, 'w', format=form) as file:
            file.Conventions = 'CF-1.8'
            for name, places in (('time', [0.0, 6.0, 12.0]), ('z', 30 + 2.0 * numpy.arange(6)),
                                 ('y', 20 + 1.0 * numpy.arange(4)), ('x', 10 + 0.5 * numpy.arange(5))):
                file.createDimension(name, len(places))
                axis = file.createVariable(name, 'f8', (name,))
                axis[:] = places
                axis.units = 'hours since 2000-01-01' if name == 'time' else 'm'
                axis.axis = name[0].upper()
            packed = file.createVariable('f', 'i2', ('time', 'z', 'y', 'x'), fill_value=-999)
            packed.scale_factor, packed.add_offset, packed.units = 0.5, 10.0, 'K'
            for step in range(3):
                packed[step] = values * (step + 1)
            file.createVariable('surface', 'f4', ('y', 'x'))[:] = 1.0
        found = info(path)
        assert found['times'] == [0.0, 6.0, 12.0], found['times']
        compare(path, reference, [('point:f', 'point:f')], ['--time', 'first'])
        last = info(path)['arrays'][0]['range']
        assert near(last[1], 3 * values.max()), last


def netcdf_fill(folder):
    netcdf4, numpy = need('netCDF4'), need('numpy')
    path = folder / 'holes.nc'
    with netcdf4.Dataset(path, 'w') as file:
        for name, count in (('z', 6), ('y', 4), ('x', 5)):
            file.createDimension(name, count)
        values = file.createVariable('f', 'f4', ('z', 'y', 'x'), fill_value=1e20)
        values[:] = numpy.ma.masked_greater(lattice(numpy), 400)
    found = info(path)['arrays'][0]['range']
    assert found == [0.0, 400.0], found


def zarr(folder):
    netcdf4, numpy = need('netCDF4'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 10 20 30\n')
    for mode, packed in (('zarr', False), ('nczarr', True)):
        path = folder / f'{mode}.zarr'
        try:
            file = netcdf4.Dataset(f'file://{path}#mode={mode},file', 'w')
        except OSError:
            raise Missing('netCDF with Zarr') from None
        for name, places in (('z', 30 + 2.0 * numpy.arange(6)), ('y', 20 + 1.0 * numpy.arange(4)),
                             ('x', 10 + 0.5 * numpy.arange(5))):
            file.createDimension(name, len(places))
            file.createVariable(name, 'f8', (name,))[:] = places
        f = file.createVariable('f', 'f8', ('z', 'y', 'x'), zlib=packed, chunksizes=(3, 4, 5))
        f[:] = values
        f.units = 'K'
        file.close()
        compare(path, reference, [('point:f', 'point:f')])


def netcdf_pop(folder):
    """As the ocean model POP writes: places by longitude and latitude of two dimensions, depths of one."""
    netcdf4, numpy = need('netCDF4'), need('numpy')
    path = folder / 'ocean.pop.nc'
    with netcdf4.Dataset(path, 'w') as file:
        file.Conventions = 'CF-1.0'
        for name, count in (('z_t', 6), ('nlat', 4), ('nlon', 5)):
            file.createDimension(name, count)
        depth = file.createVariable('z_t', 'f4', ('z_t',))
        depth[:], depth.units, depth.positive, depth.axis = 500.0 * numpy.arange(6), 'centimeters', 'down', 'Z'
        j, i = numpy.mgrid[0:4, 0:5].astype(float)
        for name, places, units in (('TLONG', 10 + i + 0.1 * j, 'degrees_east'),
                                    ('TLAT', 50 + j + 0.2 * i, 'degrees_north')):
            axis = file.createVariable(name, 'f8', ('nlat', 'nlon'))
            axis[:], axis.units = places, units
        values = file.createVariable('TEMP', 'f4', ('z_t', 'nlat', 'nlon'), fill_value=9.96921e36)
        values[:] = numpy.ma.masked_greater(lattice(numpy), 500)
        values.coordinates, values.units = 'TLONG TLAT', 'degC'
    found = info(path)
    assert found['grid']['kind'] in ('curvilinear', 'unstructured'), found['grid']
    assert near(found['bounds'][0], 10.0) and near(found['bounds'][1], 14.3), found['bounds']
    temp = [a for a in found['arrays'] if a['name'] == 'TEMP'][0]
    assert temp['range'] == [0.0, 500.0], temp


def tiff(folder):
    tifffile, numpy = need('tifffile'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.25 0.5 2\naxis mins: 0 0 0\n')
    tifffile.imwrite(folder / 'imagej.tif', values.astype('f4'), imagej=True, resolution=(4, 2),
                     metadata={'spacing': 2.0, 'unit': 'um', 'axes': 'ZYX'})
    compare(folder / 'imagej.tif', reference, [('point:values', 'point:f')])
    tifffile.imwrite(folder / 'two.ome.tif', numpy.stack([values, 2 * values])[:, :, None].astype('u2'),
                     metadata={'axes': 'TZCYX', 'PhysicalSizeX': 0.25, 'PhysicalSizeY': 0.5, 'PhysicalSizeZ': 2.0})
    compare(folder / 'two.ome.tif', reference, [('point:values', 'point:f')], ['--time', 'first'])
    assert near(info(folder / 'two.ome.tif')['arrays'][0]['range'][1], 2 * values.max())
    tifffile.imwrite(folder / 'channels.ome.tif', numpy.stack([values, 3 * values], axis=1).astype('f4'),
                     compression='zlib', tile=(16, 16),
                     metadata={'axes': 'ZCYX', 'PhysicalSizeX': 0.25, 'PhysicalSizeY': 0.5, 'PhysicalSizeZ': 2.0})
    compare(folder / 'channels.ome.tif', reference, [('point:channel 0', 'point:f')])
    plain = nrrd(folder, values)
    tifffile.imwrite(folder / 'plain.tif', values.astype('i2'))
    compare(folder / 'plain.tif', plain, [('point:values', 'point:f')])


def mrc(folder):
    mrcfile, numpy = need('mrcfile'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 10 20 30\n')
    for kind in ('f4', 'i2', 'u2'):
        path = folder / f'{kind}.mrc'
        with mrcfile.new(path) as file:
            file.set_data(values.astype(kind))
            file.voxel_size = (0.5, 1.0, 2.0)
            file.header.origin = (10.0, 20.0, 30.0)
        compare(path, reference, [('point:density', 'point:f')])


def dicom(folder):
    pydicom, numpy = need('pydicom'), need('numpy')
    values = lattice(numpy)
    # Rows along x, columns tilted in y and z, as a gantry does.
    row, column = numpy.array([1.0, 0.0, 0.0]), numpy.array([0.0, 0.8, 0.6])
    step = numpy.array([0.0, -0.6, 0.8]) * 2.0
    origin = numpy.array([10.0, 20.0, 30.0])
    directions = ' '.join(f'({a[0]},{a[1]},{a[2]})' for a in (0.5 * row, 1.0 * column, step))
    reference = nrrd(folder, values,
                     f'space: left-posterior-superior\nspace directions: {directions}\nspace origin: (10,20,30)\n')
    series = folder / 'series'
    series.mkdir()
    uid = pydicom.uid.generate_uid()
    for index in (3, 0, 5, 1, 4, 2):
        data = pydicom.dataset.Dataset()
        data.SOPClassUID, data.SOPInstanceUID = pydicom.uid.CTImageStorage, pydicom.uid.generate_uid()
        data.SeriesInstanceUID, data.StudyInstanceUID = uid, pydicom.uid.generate_uid()
        data.Modality, data.InstanceNumber = 'CT', index + 1
        data.Rows, data.Columns, data.SamplesPerPixel = 4, 5, 1
        data.PhotometricInterpretation = 'MONOCHROME2'
        data.BitsAllocated = data.BitsStored = 16
        data.HighBit, data.PixelRepresentation = 15, 0
        data.PixelSpacing, data.SliceThickness = [1.0, 0.5], 5.0
        data.ImageOrientationPatient = [*row, *column]
        data.ImagePositionPatient = [round(float(x), 6) for x in origin + index * step]
        data.RescaleSlope, data.RescaleIntercept = '0.5', '-100'
        data.PixelData = ((values[index] + 100) * 2).astype('<u2').tobytes()
        data.file_meta = pydicom.dataset.FileMetaDataset()
        data.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
        data.file_meta.MediaStorageSOPClassUID = data.SOPClassUID
        data.file_meta.MediaStorageSOPInstanceUID = data.SOPInstanceUID
        data.is_little_endian, data.is_implicit_VR = True, False
        data.save_as(series / f'{index}.dcm', write_like_original=False)
    (series / 'notes.txt').write_text('not an image\n')
    for path in (series, series / '4.dcm'):
        compare(path, reference, [('point:DICOM', 'point:f')])
    # As the shell lists them, all or a part.
    files = [series / f'{index}.dcm' for index in (5, 1, 0, 4, 2, 3)]
    compare(files[0], reference, [('point:DICOM', 'point:f')], files[1:])
    assert info(*files[3:])['grid']['points'] == 5 * 4 * 3
    (series / '2.dcm').unlink()
    done = subprocess.run([VPROBE, 'info', series], capture_output=True, encoding='utf-8')
    assert done.returncode == 2 and 'a slice is missing' in done.stderr, done


CASES = [numpy_arrays, raw, netcdf, netcdf_fill, netcdf_pop, zarr, tiff, mrc, dicom]
