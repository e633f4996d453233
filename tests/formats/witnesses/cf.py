#!/usr/bin/env python3
"""Files of the CF conventions in many spellings, written and read by other libraries, and read by vprobe.

usage: cf.py VPROBE [FIRST-SEED COUNT]

Written by netCDF4 (classic, 64-bit offsets, netCDF-4), h5py and zarr; read by netCDF4, which masks and unpacks, and by
xarray. The values and places that vprobe converts are compared with theirs. Seeds make the files, so a failure repeats.
VPROBE_LONG asks for 100 files of each kind. Exit code 77 where netCDF4 or VTK's module is missing.

Where vprobe follows the conventions and not netCDF4: bytes have no default fill value.
"""
import pathlib
import random
import subprocess
import sys
import tempfile
import warnings

try:
    import netCDF4
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader
except ImportError as error:
    print(f'left out: {error}')
    sys.exit(77)

from common import how_many

VPROBE = sys.argv[1]
FORMS = ['NETCDF3_CLASSIC', 'NETCDF3_64BIT_OFFSET', 'NETCDF4', 'h5py', 'zarr']
CLASSIC = ['i1', 'i2', 'i4', 'f4', 'f8']

# Attributes that say what runs along an axis, each enough by itself.
SAYS = {
    'x': [{'axis': 'X'}, {'units': 'degrees_east'}, {'units': 'degreeE'}, {'standard_name': 'projection_x_coordinate'},
          {'standard_name': 'longitude', 'units': 'degrees'}],
    'y': [{'axis': 'Y'}, {'units': 'degrees_north'}, {'units': 'degree_N'}, {'standard_name': 'latitude'},
          {'standard_name': 'projection_y_coordinate', 'units': 'm'}],
    'z': [{'axis': 'Z'}, {'units': 'hPa'}, {'positive': 'up', 'units': 'm'}, {'positive': 'down', 'units': 'm'},
          {'standard_name': 'depth', 'positive': 'down'}, {'standard_name': 'ocean_sigma_coordinate'}],
}


class Spelling:
    """What one file holds, apart from how its library writes it."""

    def __init__(self, seed, form):
        self.random = random.Random(f'{seed}:{form}')
        self.numbers = numpy.random.default_rng(self.random.randrange(1 << 30))
        self.form = form
        pick = self.random.choice
        self.types = CLASSIC + ([] if form.startswith('NETCDF3') else ['u1', 'u2', 'u4', 'i8', 'u8'])
        self.lengths = {axis: self.random.randint(2, 6) for axis in 'xyz'}
        self.names = dict(zip('xyz', pick([('x', 'y', 'z'), ('a', 'b', 'c'), ('z1', 'x1', 'y1'), ('lon', 'lat', 'lev')])))
        self.says = {axis: dict(pick(SAYS[axis])) for axis in 'xyz'}
        self.order = self.random.sample('xyz', 3)
        self.places = {axis: self.make_places(axis) for axis in 'xyz'}
        self.times = self.make_times()
        self.variables = {f'v{i}': self.make_variable() for i in range(self.random.randint(3, 6))}

    def make_places(self, axis):
        """Stored values, their attributes, and the places that are meant."""
        count, says = self.lengths[axis], self.says[axis]
        steps = self.numbers.integers(1, 9, count) if self.random.random() < 0.5 else numpy.full(count, 2)
        values = numpy.cumsum(steps) * self.random.choice([1, -1]) + self.random.randint(-20, 20)
        turns = axis == 'x' and (says.get('units', '').startswith('degree') or says.get('standard_name') == 'longitude')
        if turns and self.random.random() < 0.5:
            values = (values + 180 + 180) % 360 - 180  # across the date line
        kind = self.random.choice(['f4', 'f8', 'i4', 'i2', 'packed'])
        attributes = dict(says)
        if kind == 'packed':
            kind, values = 'i2', values * 10
            attributes |= {'scale_factor': 0.1, '_FillValue': numpy.int16(-32767)}
        return values.astype(kind), attributes

    def make_times(self):
        if self.random.random() < 0.4:
            return None
        count = self.random.randint(1, 4)
        values = self.numbers.permutation(numpy.arange(count) * 30.0)
        if self.random.random() < 0.3:
            values[:] = values[0]
        return values

    def make_variable(self):
        pick, chance = self.random.choice, self.random.random
        kind = pick(self.types)
        attributes, special = {}, []
        whole = kind[0] in 'iu'
        top = 100 if kind == 'i1' else 200
        by_zarr = self.form == 'zarr'

        turned = kind in ('i1', 'i2', 'i4') and chance() < 0.3
        if turned:  # xarray takes the one spelling, and does not turn missing values
            attributes['_Unsigned'] = 'true' if by_zarr else pick(['true', 'True'])

        def mark():
            low = 3 if kind[0] == 'u' or (turned and by_zarr) else -1
            value = numpy.array(pick([0, 7, top - 1, low, 55]) if whole or chance() < 0.7
                                else pick([1e20, -999.5, numpy.nan]), kind)[()]
            special.append(value)
            return value

        if chance() < 0.5:
            attributes['_FillValue'] = mark()
        if chance() < 0.3:
            attributes['missing_value'] = mark()
        elif chance() < 0.2 and not by_zarr:
            attributes['missing_value'] = numpy.array([mark(), mark()], kind)
        if chance() < 0.3 and not by_zarr:
            low, high = numpy.array([5, top // 2], kind)
            attributes |= pick([{'valid_range': numpy.array([low, high], kind)}, {'valid_min': low},
                                {'valid_max': high}, {'valid_min': low, 'valid_max': high}])
        if chance() < 0.4:
            attributes['scale_factor'] = pick([numpy.float64(0.5), numpy.float32(0.01), numpy.float64(-3)])
        if chance() < 0.3:
            attributes['add_offset'] = pick([numpy.float64(273.15), numpy.float32(10)])
        sides = list(self.order)
        if self.random.random() < 0.3:
            self.random.shuffle(sides)
        if self.times is not None and chance() < 0.8:
            sides.insert(self.random.randint(0, 3), 't')
        shape = [len(self.times) if side == 't' else self.lengths[side] for side in sides]
        values = self.numbers.integers(0 if kind[0] == 'u' else -top // 2, top, shape).astype(kind)
        if kind not in ('i1', 'u1') and not by_zarr and not turned:
            special.append(numpy.array(netCDF4.default_fillvals[kind], kind)[()])
        for value in special:
            values[self.numbers.random(shape) < 0.1] = value
        return sides, values, attributes

    def name_of(self, side):
        return 'time' if side == 't' else self.names[side]

    def axes(self):
        """Name, stored values and attributes of every coordinate variable."""
        for axis in 'xyz':
            yield self.names[axis], *self.places[axis]
        if self.times is not None:
            yield 'time', self.times, {'units': 'days since 2000-01-01'}


def write_netcdf(spelling, path):
    with netCDF4.Dataset(path, 'w', format=spelling.form) as file:
        file.set_auto_maskandscale(False)
        everything = [(name, [name], values, about) for name, values, about in spelling.axes()]
        for name, values, _ in spelling.axes():
            file.createDimension(name, len(values))
        everything += [(name, [spelling.name_of(side) for side in sides], values, about)
                       for name, (sides, values, about) in spelling.variables.items()]
        for name, sides, values, about in everything:
            packing = spelling.random.choice([{}, {'zlib': True, 'shuffle': True}, {'endian': 'big'},
                                              {'fletcher32': True}]) if spelling.form == 'NETCDF4' else {}
            about = dict(about)
            made = file.createVariable(name, values.dtype, sides, fill_value=about.pop('_FillValue', None), **packing)
            made.set_auto_maskandscale(False)
            made.setncatts(about)
            made[:] = values


def write_h5py(spelling, path):
    import h5py
    with h5py.File(path, 'w') as file:
        file.attrs['Conventions'] = 'CF-1.8'
        for name, values, about in spelling.axes():
            file[name] = values
            file[name].make_scale(name)
            file[name].attrs.update(about)
        for name, (sides, values, about) in spelling.variables.items():
            options = spelling.random.choice([{}, {'compression': 'gzip'}, {'chunks': True, 'shuffle': True}])
            made = file.create_dataset(name, data=values.astype(values.dtype.newbyteorder(spelling.random.choice('<>'))),
                                       **options)
            made.attrs.update(about)
            for i, side in enumerate(sides):
                made.dims[i].attach_scale(file[spelling.name_of(side)])


def write_zarr(spelling, path):
    import zarr
    group = zarr.open_group(str(path), mode='w')
    everything = [(name, [name], values, about) for name, values, about in spelling.axes()]
    everything += [(name, [spelling.name_of(side) for side in sides], values, about)
                   for name, (sides, values, about) in spelling.variables.items()]
    for name, sides, values, about in everything:
        chunks = [spelling.random.randint(1, length) for length in values.shape]
        fill = about.get('_FillValue') or None
        about = {key: value.item() if hasattr(value, 'item') else value for key, value in about.items()
                 if key != '_FillValue' or fill is None}
        made = group.create_dataset(name, data=values, chunks=chunks, compressor=None, fill_value=fill)
        made.attrs.update({key: value for key, value in about.items() if value == value})
        made.attrs['_ARRAY_DIMENSIONS'] = sides


def read_by_witness(spelling, path):
    """Of each variable its dimensions and values; NaN where they are missing."""
    if spelling.form == 'zarr':
        import xarray
        with xarray.open_zarr(path, decode_times=False, consolidated=False) as file:
            return {str(name): (file[name].dims, file[name].values.astype(float)) for name in file.variables}
    with netCDF4.Dataset(path) as file:
        return {name: (made.dimensions, numpy.ma.filled(made[...].astype(float), numpy.nan))
                for name, made in file.variables.items()}


def read_by_vprobe(path, folder, time):
    out = folder / 'out.vtm'
    done = subprocess.run([VPROBE, 'convert', path, '-o', out, '--time', time], capture_output=True, encoding='utf-8')
    assert done.returncode == 0, done.stderr
    reader = vtkXMLGenericDataObjectReader()
    reader.SetFileName(str(next((folder / 'out').iterdir())))
    reader.Update()
    data = reader.GetOutput()
    points = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    fields = data.GetPointData()
    arrays = {fields.GetArrayName(i): vtk_to_numpy(fields.GetArray(i)).astype(float)
              for i in range(fields.GetNumberOfArrays())}
    for piece in (folder / 'out').iterdir():
        piece.unlink()
    (folder / 'out').rmdir()
    return points, arrays


def same(ours, wanted, what):
    assert ours.shape == wanted.shape, (what, ours.shape, wanted.shape)
    near = numpy.isclose(ours, wanted, rtol=1e-6, atol=1e-6 * numpy.nanmax(numpy.abs(wanted), initial=1e-9),
                         equal_nan=True)
    assert near.all(), (what, ours[~near][:4], wanted[~near][:4])


def compare(seed, form, folder):
    spelling = Spelling(seed, form)
    path = folder / ('f.zarr' if form == 'zarr' else 'f.nc')
    {'h5py': write_h5py, 'zarr': write_zarr}.get(form, write_netcdf)(spelling, path)
    witness = read_by_witness(spelling, path)

    index, step = 0, 0
    if spelling.times is not None:
        index = spelling.random.randrange(len(spelling.times))
        step = int(numpy.argsort(spelling.times, kind='stable')[index])
        if not any('t' in sides for sides, _, _ in spelling.variables.values()):
            index = 0  # nothing changes with time
    points, arrays = read_by_vprobe(path, folder, f'#{index}')

    x, y, z = (witness[spelling.names[axis]][1] for axis in 'xyz')
    says = spelling.says
    if 'units' in says['x'] and says['x']['units'].startswith('degree'):
        x = numpy.unwrap(x, period=360)
    if says['z'].get('positive') == 'down':
        z = -z
    zs, ys, xs = numpy.meshgrid(z, y, x, indexing='ij')
    same(points, numpy.stack([xs.ravel(), ys.ravel(), zs.ravel()], axis=1), 'places')
    timed = any('t' in sides for sides, _, _ in spelling.variables.values())
    assert timed or spelling.times is None or index == 0
    for name, (sides, _, about) in spelling.variables.items():
        values = witness[name][1]
        left = list(sides)
        if 't' in left:
            values = numpy.take(values, step, axis=left.index('t'))
            left.remove('t')
        same(arrays[name], values.transpose([left.index(axis) for axis in 'zyx']).ravel(), (name, sides, about))


def main():
    warnings.simplefilter('ignore')
    first, count = (int(word) for word in sys.argv[2:4]) if len(sys.argv) > 3 else \
        (1, how_many(4, 100))
    failed = 0
    for form in FORMS:
        done = 0
        for seed in range(first, first + count):
            with tempfile.TemporaryDirectory(prefix='vprobe-cf-') as folder:
                try:
                    compare(seed, form, pathlib.Path(folder))
                    done += 1
                except ImportError as error:
                    print(f'{form}: left out, {error.name} is not installed')
                    break
                except AssertionError as error:
                    failed += 1
                    print(f'{form}, seed {seed}: FAILED: {error}')
        print(f'{form}: {done} files as their writers meant them')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
