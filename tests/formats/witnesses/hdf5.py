#!/usr/bin/env python3
"""XDMF and VTKHDF with times in any order, and Exodus, written by h5py and netCDF4 and read by vprobe.

usage: hdf5.py VPROBE [FIRST-SEED COUNT]

Types, byte orders, filters, chunks, external files; times that rise, descend, are mixed up or equal: each is reached
by its index. VPROBE_LONG asks for 500 files.
"""
import random

import common

common.need('numpy', 'h5py', 'netCDF4', 'vtkmodules.vtkIOXML')
import h5py
import netCDF4
import numpy

TYPES = ['i1', 'u1', 'i2', 'u2', 'i4', 'u4', 'i8', 'u8', 'f4', 'f8']


class Case:
    """Values at the points of a lattice for each of several times."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        numbers = numpy.random.default_rng(seed)
        self.shape = tuple(self.random.randint(2, 5) for _ in range(3))  # z, y, x
        count = self.random.randint(1, 5)
        self.times = numbers.permutation(numpy.arange(count) * 0.5)
        if self.random.random() < 0.4:
            self.times = numpy.floor(self.times)
        self.kind = self.random.choice(TYPES)
        self.values = numbers.integers(0, 100, (count, *self.shape)).astype(self.kind)
        self.index = self.random.randrange(count)
        self.step = int(numpy.argsort(self.times, kind='stable')[self.index])

    def write_set(self, group, name, values):
        pick = self.random.choice
        if values.dtype.itemsize > 1:
            values = values.astype(values.dtype.newbyteorder(pick('<>')))
        packing = pick([{}, {'compression': 'gzip'}, {'chunks': True, 'shuffle': True, 'fletcher32': True}])
        return group.create_dataset(name, data=values, **packing)


def write_xdmf(case, folder):
    path = folder / 'f.xdmf'
    sides = ' '.join(map(str, case.shape))
    number = {'i': 'Int', 'u': 'UInt', 'f': 'Float'}[case.kind[0]]
    grids = []
    with h5py.File(folder / 'f.h5', 'w') as file:
        for i, time in enumerate(case.times):
            case.write_set(file, f'v{i}', case.values[i])
            grids.append(f'''<Grid Name="g"><Time Value="{time}"/>
<Topology TopologyType="3DCoRectMesh" Dimensions="{sides}"/><Geometry GeometryType="ORIGIN_DXDYDZ">
<DataItem Dimensions="3" Format="XML">0 0 0</DataItem><DataItem Dimensions="3" Format="XML">1 1 1</DataItem></Geometry>
<Attribute Name="v" Center="Node"><DataItem Dimensions="{sides}" NumberType="{number}" Precision="{case.kind[1]}"
Format="HDF">f.h5:/v{i}</DataItem></Attribute></Grid>''')
    path.write_text(f'<Xdmf Version="2.0"><Domain><Grid GridType="Collection" CollectionType="Temporal">{"".join(grids)}'
                    '</Grid></Domain></Xdmf>')
    return path


def write_vtkhdf(case, folder):
    path = folder / 'f.vtkhdf'
    z, y, x = case.shape
    with h5py.File(path, 'w') as file:
        root = file.create_group('VTKHDF')
        root.attrs.update(Version=[2, 0], WholeExtent=[0, x - 1, 0, y - 1, 0, z - 1], Origin=[0.0, 0, 0],
                          Spacing=[1.0, 1, 1], Direction=[1.0, 0, 0, 0, 1, 0, 0, 0, 1])
        root.attrs.create('Type', b'ImageData', dtype=h5py.string_dtype('ascii', 9))
        case.write_set(root.create_group('PointData'), 'v', case.values)
        steps = root.create_group('Steps')
        steps.attrs['NSteps'] = len(case.times)
        steps['Values'] = case.times
        steps.create_group('PointDataOffsets')['v'] = numpy.arange(len(case.times))
    return path


def write_exodus(case, folder):
    path = folder / 'f.exo'
    z, y, x = case.shape
    form = case.random.choice(['NETCDF3_64BIT_OFFSET', 'NETCDF4'])
    case.values = case.values.astype('f8')
    corners = [i + x * (j + y * k) + 1 + numpy.array([0, 1, x + 1, x, x * y, x * y + 1, x * y + x + 1, x * y + x])
               for k in range(z - 1) for j in range(y - 1) for i in range(x - 1)]
    with netCDF4.Dataset(path, 'w', format=form) as file:
        file.setncatts({'api_version': numpy.float32(5.1), 'version': numpy.float32(5.1), 'title': 'a',
                        'floating_point_word_size': numpy.int32(8), 'file_size': numpy.int32(1)})
        for name, length in (('len_string', 33), ('len_name', 33), ('time_step', None), ('num_dim', 3),
                             ('num_nodes', x * y * z), ('num_elem', len(corners)), ('num_el_blk', 1),
                             ('num_el_in_blk1', len(corners)), ('num_nod_per_el1', 8), ('num_nod_var', 1)):
            file.createDimension(name, length)
        places = numpy.meshgrid(*(numpy.arange(n) for n in case.shape), indexing='ij')
        for name, places in zip('xyz', places[::-1]):
            file.createVariable(f'coord{name}', 'f8', ('num_nodes',))[:] = places.ravel()
        file.createVariable('eb_status', 'i4', ('num_el_blk',))[:] = 1
        file.createVariable('eb_prop1', 'i4', ('num_el_blk',))[:] = 1
        file['eb_prop1'].setncattr('name', 'ID')
        connect = file.createVariable('connect1', 'i4', ('num_el_in_blk1', 'num_nod_per_el1'))
        connect.elem_type = 'HEX8'
        connect[:] = corners
        names = file.createVariable('name_nod_var', 'S1', ('num_nod_var', 'len_name'))
        names[0, :] = numpy.array(list('v'.ljust(33, '\0')), 'S1')
        file.createVariable('time_whole', 'f8', ('time_step',))[:] = case.times
        packing = {'zlib': True, 'fletcher32': True} if form == 'NETCDF4' else {}
        file.createVariable('vals_nod_var1', 'f8', ('time_step', 'num_nodes'), **packing)[:] = \
            case.values.reshape(len(case.times), -1)
    return path


def compare(seed, folder):
    case = Case(seed)
    write = [write_xdmf, write_vtkhdf, write_exodus][seed % 3]
    path = write(case, folder)
    points, arrays, _ = common.converted(path, folder, '--time', f'#{case.index}')
    wanted = case.values[case.step].ravel()
    order = numpy.lexsort(points.T)  # as VTK's reader of Exodus orders the points by their use
    common.same(points[order], common.lattice(case.shape[::-1]), (write.__name__, 'places'), 1e-12)
    common.same(arrays['v'][order].astype(float), wanted.astype(float), (write.__name__, case.times, case.index, case.kind))
    if write is write_xdmf and seed % 2:
        common.same(common.info(path)['times'], sorted(case.times), 'times', 1e-15)


common.go_through('hdf5', compare)
