"""netCDF of the CF conventions: what other libraries do not judge. witnesses/cf.py compares the rest with them."""
import subprocess

from against import VPROBE, cut, info, lattice, near, need
from odd import refused

FLAT = ['--normal', 'z', '--origin']


def new(path, sides=(('z', 3), ('y', 4), ('x', 5)), **options):
    file = need('netCDF4').Dataset(path, 'w', **options)
    for side, count in sides:
        file.createDimension(side, count)
    return file


def axis(file, name, values, kind='f8', sides=None, **attributes):
    made = file.createVariable(name, kind, sides or (name,), fill_value=attributes.pop('_FillValue', None))
    made.set_auto_maskandscale(False)
    made.setncatts(attributes)
    made[:] = values
    return made


def noted(path, *options):
    return subprocess.run([VPROBE, 'info', path, *options], capture_output=True, encoding='utf-8').stderr


def conventions_bytes(folder):
    """All 256 values of a byte are values, unless the file says otherwise."""
    numpy = need('numpy')
    with new(folder / 'f.nc') as file:
        for kind in ('i1', 'u1'):
            values = numpy.full((3, 4, 5), 10, kind)
            values[0, 0, 0] = -127 if kind == 'i1' else 255
            file.createVariable(kind, kind, ('z', 'y', 'x'))[:] = values
    found = {a['name']: (a['type'], a['range']) for a in info(folder / 'f.nc')['arrays']}
    assert found == {'i1': ('int8', [-127, 10]), 'u1': ('uint8', [10, 255])}, found


def conventions_ranges(folder):
    """Valid values are of packed units, unless no packed value can be one; a text may hold a number."""
    numpy = need('numpy')
    with new(folder / 'f.nc') as file:
        def packed(name, **attributes):
            made = file.createVariable(name, 'i2', ('z', 'y', 'x'))
            made.set_auto_maskandscale(False)
            made.setncatts(attributes)
            made[:] = numpy.arange(60).reshape(3, 4, 5) * 10
        packed('stored', scale_factor=0.1, valid_range=numpy.array([100, 200], 'i2'))
        packed('meant', scale_factor=0.1, valid_min=10.5, valid_max=20.5)
        packed('text', scale_factor='0.1', missing_value='-5, 590')
        wide = file.createVariable('wide', 'i8', ('z', 'y', 'x'), fill_value=2**62 + 1)
        wide.set_auto_maskandscale(False)
        wide[:] = 2**62
    found = {a['name']: a['range'] for a in info(folder / 'f.nc')['arrays']}
    for name, low, high in (('stored', 10, 20), ('meant', 11, 20), ('text', 0, 58), ('wide', 2.0**62, 2.0**62)):
        assert near(found[name][0], low) and near(found[name][1], high), (name, found)
    with new(folder / 'bad.nc') as file:
        file.createVariable('f', 'i2', ('z', 'y', 'x')).scale_factor = 'two'
    refused(folder / 'bad.nc', 'scale_factor of f is no number')


def conventions_date_line(folder):
    """Longitudes from 176 to -176 are 8 degrees wide, in one and in two dimensions, packed or not."""
    numpy = need('numpy')
    lon = numpy.array([176, 178, 180, -178, -176.0])
    with new(folder / 'one.nc') as file:
        axis(file, 'x', lon, units='degrees_east')
        axis(file, 'y', [30, 20, 10, 0], units='degrees_north')
        file.createVariable('f', 'f4', ('z', 'y', 'x'))[:] = 1
    with new(folder / 'two.nc') as file:
        axis(file, 'lon', numpy.tile(lon * 10, (4, 1)), 'i2', ('y', 'x'), units='degrees_east', scale_factor=0.1)
        axis(file, 'lat', numpy.tile(numpy.arange(4.0)[:, None] * 10, (1, 5)), sides=('y', 'x'), units='degrees_north')
        file.createVariable('f', 'f4', ('z', 'y', 'x')).coordinates = 'lon lat'
        file['f'][:] = 1
    for name in ('one', 'two'):
        found = info(folder / f'{name}.nc')['bounds']
        assert near(found[0], 176) and near(found[1], 184), found
        assert near(cut(folder / f'{name}.nc', 'f', *FLAT, 180, 15, 0.5)['area'], 8 * 30), name
    # Rows that go around a pole: the cells that close the turn are left out, and the others stay narrow.
    with new(folder / 'pole.nc', (('z', 2), ('y', 8), ('x', 8))) as file:
        j, i = numpy.mgrid[0:8, 0:8] - 3.5
        axis(file, 'lon', numpy.degrees(numpy.arctan2(j, i)), sides=('y', 'x'), units='degrees_east')
        axis(file, 'lat', 90 - numpy.hypot(i, j), sides=('y', 'x'), units='degrees_north')
        file.createVariable('f', 'f4', ('z', 'y', 'x')).coordinates = 'lon lat'
        file['f'][:] = 1
    assert 'are left out' in noted(folder / 'pole.nc'), noted(folder / 'pole.nc')
    assert cut(folder / 'pole.nc', 'f', *FLAT, 0, 88, 0.5)['area'] < 360 * 5


def conventions_missing_places(folder):
    """A cell without one of its corners is left out and counted, however the file says that it is missing."""
    numpy = need('numpy')
    j, i = numpy.mgrid[0:4, 0:5].astype(float)
    for name, mark, kind in (('nan', numpy.nan, 'f4'), ('fill', -9999.0, 'f8'), ('short', -32767, 'i2')):
        with new(folder / f'{name}.nc') as file:
            for side, places in (('lon', 10 + i), ('lat', 50 + j)):
                stored = places * (10 if kind == 'i2' else 1)
                stored[0, 0] = mark
                units = 'degrees_east' if side == 'lon' else 'degrees_north'
                packing = {'scale_factor': 0.1} if kind == 'i2' else {}
                axis(file, side, stored, kind, ('y', 'x'), units=units, _FillValue=mark, **packing)
            file.createVariable('f', 'f4', ('z', 'y', 'x')).coordinates = 'lon lat'
            file['f'][:] = 1
        assert near(cut(folder / f'{name}.nc', 'f', *FLAT, 12, 51, 0.5)['area'], 11), name
        assert '2 cells' in noted(folder / f'{name}.nc'), noted(folder / f'{name}.nc')
    with new(folder / 'line.nc') as file:
        axis(file, 'x', [0, 1, -1, 3, 4], _FillValue=-1)
        file.createVariable('f', 'f4', ('z', 'y', 'x'))[:] = 1
    assert near(cut(folder / 'line.nc', 'f', *FLAT, 0.5, 1.5, 0.5)['area'], 2 * 3)


def conventions_corners(folder):
    """Cells whose corners the file gives, in either sense and order of axes; layers that descend."""
    numpy = need('numpy')
    j, i = numpy.mgrid[0:4, 0:5].astype(float)
    for name, dx, dy in (('right', (-.5, .5, .5, -.5), (-.5, -.5, .5, .5)), ('left', (-.5, -.5, .5, .5), (-.5, .5, .5, -.5))):
        with new(folder / f'{name}.nc', (('z', 3), ('y', 4), ('x', 5), ('two', 2), ('four', 4))) as file:
            axis(file, 'z', [20, 10, 0], axis='Z', bounds='z_b')
            axis(file, 'z_b', [[15, 25], [5, 15], [-1, 5]], sides=('z', 'two'))
            for side, places, off, units in (('lon', 10 + i, dx, 'degrees_east'), ('lat', 50 + j, dy, 'degrees_north')):
                axis(file, side, places, sides=('y', 'x'), units=units, bounds=f'{side}_b')
                axis(file, f'{side}_b', places[..., None] + numpy.array(off), sides=('y', 'x', 'four'))
            file.createVariable('f', 'f4', ('z', 'y', 'x')).coordinates = 'lon lat'
            file['f'][:] = numpy.arange(3)[:, None, None] * numpy.ones((4, 5))
        found = info(folder / f'{name}.nc')
        assert [(a['association'], a['name']) for a in found['arrays']] == [('cell', 'f')], found['arrays']
        assert numpy.allclose(found['bounds'], [9.5, 14.5, 49.5, 53.5, -1, 25]), found['bounds']
        lowest = cut(folder / f'{name}.nc', 'f', *FLAT, 12, 52, 2)
        assert near(lowest['area'], 20) and near(lowest['mean'], 2), lowest


def conventions_times(folder):
    """Times in any order: each is reached by its value, equal ones by their index, and told apart."""
    numpy = need('numpy')

    def write(name, times, **attributes):
        with new(folder / name, (('time', len(times)), ('z', 3), ('y', 4), ('x', 5))) as file:
            axis(file, 'time', times, units='days since 2000-01-01', **attributes)
            file.createVariable('f', 'f4', ('time', 'z', 'y', 'x'))[:] = \
                numpy.arange(len(times))[:, None, None, None] * numpy.ones((3, 4, 5))
        return folder / name

    def step(path, time):
        return cut(path, 'f', '--time', time)['mean']

    path = write('mixed.nc', [30.0, 60.0, 0.0])
    assert info(path)['times'] == [0.0, 30.0, 60.0]
    assert [step(path, time) for time in ('0', '30', '60', 'first', 'last', '#1')] == [2, 0, 1, 2, 1, 0]
    path = write('equal.nc', [5.0, 5.0, 1.0])
    assert info(path)['times'] == [1.0, 5.0, 5.0]
    assert [step(path, time) for time in ('#0', '#1', '#2', '5', 'last')] == [2, 0, 1, 0, 1]
    path = write('near.nc', [730120.0, 730120.25, 730120.5])
    shown = subprocess.run([VPROBE, 'info', path], capture_output=True, encoding='utf-8').stdout
    assert '730120 730120.25 730120.5' in shown, shown
    path = write('missing.nc', [0.0, -1.0, 10.0], _FillValue=-1.0)
    assert info(path)['times'] == [0.0, 1.0, 2.0] and step(path, '1') == 1 and '1 of its 3 times' in noted(path)


def conventions_folded(folder):
    with new(folder / 'f.nc') as file:
        axis(file, 'x', [0, 2, 1, 3, 4])
        file.createVariable('f', 'f4', ('z', 'y', 'x'))[:] = 1
    refused(folder / 'f.nc', 'axis x neither rise nor fall', 'sortby')


def conventions_zarr(folder):
    """Groups below are named, and so is what the folder is where it is none."""
    numpy, zarr = need('numpy'), need('zarr')
    values = lattice(numpy)
    group = zarr.open_group(str(folder / 'f.zarr'), mode='w')
    group.create_group('below').array('f', values)
    refused(folder / 'f.zarr', 'groups alone', 'f.zarr/below')
    assert info(folder / 'f.zarr' / 'below')['arrays'][0]['range'] == [values.min(), values.max()]
    group.array('x', values, chunks=(2, 2, 2)).attrs['_ARRAY_DIMENSIONS'] = ['z', 'y', 'x']
    group.array('y', values[:3]).attrs['_ARRAY_DIMENSIONS'] = ['z', 'y', 'x']
    refused(folder / 'f.zarr', 'dimension z has 3 places in y and 6 in others')
    (folder / 'f.zarr' / 'y' / '.zarray').unlink()
    assert info(folder / 'f.zarr')['arrays'][0]['range'] == [values.min(), values.max()]
    (folder / 'f.zarr' / 'x' / '.zarray').write_text('{"shape": [1')
    assert 'no JSON' in noted(folder / 'f.zarr')


CASES = [conventions_bytes, conventions_ranges, conventions_date_line, conventions_missing_places, conventions_corners,
         conventions_times, conventions_folded, conventions_zarr]
