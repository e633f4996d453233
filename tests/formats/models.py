"""Files of models that have ways of their own: WRF, ocean models with s-coordinates, CAM, UGRID; and units."""
from against import cut, info, near, need
from conventions import FLAT, axis, new, noted
from far_codes import begin_cgns
from odd import refused


def write_wrf(path, names_places, numpy):
    """Columns whose layers are 10 m thick at the ground and 20 m above, on a ground that rises by 5 m a column."""
    sides = (('Time', 2), ('DateStrLen', 19), ('bottom_top', 3), ('bottom_top_stag', 4), ('south_north', 4),
             ('south_north_stag', 5), ('west_east', 5), ('west_east_stag', 6))
    with new(path, sides) as file:
        times = file.createVariable('Times', 'S1', ('Time', 'DateStrLen'))
        times[:] = numpy.array([list('2005-08-28_12:00:00'), list('2005-08-29_00:30:00')], 'S1')
        j, i = numpy.mgrid[0:4, 0:5]
        for name, values, units in (('XLAT', 40.0 + j, 'degree_north'), ('XLONG', 10.0 + i, 'degree_east')):
            made = file.createVariable(name, 'f4', ('Time', 'south_north', 'west_east'))
            made.units = units
            made[:] = numpy.stack([values, values])
        borders = numpy.array([0.0, 10.0, 30.0, 50.0])[:, None, None] + 5.0 * i
        for name, share in (('PH', 0.25), ('PHB', 0.75)):
            file.createVariable(name, 'f4', ('Time', 'bottom_top_stag', 'south_north', 'west_east'))[:] = \
                9.81 * share * numpy.stack([borders, borders])
        # West winds on the sides of cells come first in WRF's files, too.
        u = file.createVariable('U', 'f4', ('Time', 'bottom_top', 'south_north', 'west_east_stag'))
        u[:] = numpy.arange(6.0) * numpy.ones((2, 3, 4, 1))
        t = file.createVariable('T', 'f4', ('Time', 'bottom_top', 'south_north', 'west_east'))
        t[:] = numpy.array([1.0, 2.0])[:, None, None, None] * numpy.ones((2, 3, 4, 5))
        if names_places:
            u.coordinates, t.coordinates = 'XLONG_U XLAT_U', 'XLONG XLAT'


def wrf(folder):
    numpy = need('numpy')
    for names_places in (True, False):
        path = folder / f'wrfout_{names_places}.nc'
        write_wrf(path, names_places, numpy)
        found = info(path)
        assert numpy.allclose(found['bounds'], [10, 14, 40, 43, 5, 60], atol=1e-4), found['bounds']
        assert found['times'] == [0, 750], found['times']
        ranges = {a['name']: a['range'] for a in found['arrays']}
        assert ranges['T'] == [2, 2] and ranges['U'] == [0.5, 4.5], ranges
        first = {a['name']: a['range'] for a in info(path, '--time', '#0')['arrays']}
        assert first['T'] == [1, 1], first
        assert 'the means at their middles' in noted(path)


def ocean(folder):
    """By hand, after formula g2 of the conventions' appendix D: h = 100, hc = 50, zeta = 1, C = s."""
    numpy = need('numpy')
    with new(folder / 'roms.nc', (('ocean_time', 1), ('s_rho', 3), ('eta_rho', 4), ('xi_rho', 5))) as file:
        axis(file, 'ocean_time', [0.0], units='seconds since 2000-01-01')
        axis(file, 's_rho', [-1.0, -0.5, 0.0], positive='up', standard_name='ocean_s_coordinate_g2',
             formula_terms='s: s_rho C: Cs_r eta: zeta depth: h depth_c: hc')
        axis(file, 'Cs_r', [-1.0, -0.5, 0.0], sides=('s_rho',))
        j, i = numpy.mgrid[0:4, 0:5]
        for name, values, units in (('lon_rho', 10.0 + i, 'degree_east'), ('lat_rho', 50.0 + j, 'degree_north'),
                                    ('h', 100.0 + 0 * i, 'meter')):
            axis(file, name, values, sides=('eta_rho', 'xi_rho'), units=units)
        axis(file, 'zeta', numpy.ones((1, 4, 5)), sides=('ocean_time', 'eta_rho', 'xi_rho'))
        file.createVariable('hc', 'f8', ())[...] = 50.0
        temp = file.createVariable('temp', 'f4', ('ocean_time', 's_rho', 'eta_rho', 'xi_rho'))
        temp.coordinates = 'lon_rho lat_rho s_rho ocean_time'
        temp[:] = numpy.arange(3.0)[None, :, None, None] * numpy.ones((1, 3, 4, 5))
    found = info(folder / 'roms.nc')
    assert near(found['bounds'][4], -100) and near(found['bounds'][5], 1), found['bounds']
    # s = -0.5: S = (50 * -0.5 + 100 * -0.5) / 150 = -0.5, z = 1 + 101 * -0.5 = -49.5
    middle = cut(folder / 'roms.nc', 'temp', *FLAT, 12, 52, -49.5)
    assert near(middle['area'], 12) and near(middle['mean'], 1), middle
    with new(folder / 'lacks.nc') as file:
        axis(file, 'z', [0.0, 0.5, 1.0], positive='up', standard_name='ocean_sigma_coordinate',
             formula_terms='sigma: z eta: zeta depth: h')
        file.createVariable('f', 'f4', ('z', 'y', 'x'))[:] = 1
    refused(folder / 'lacks.nc', 'need', 'ncks -A')


def ugrid(folder):
    with new(folder / 'u.nc', (('time', 3), ('layer', 4), ('face', 5))) as file:
        mesh = file.createVariable('Mesh2', 'i4', ())
        mesh.cf_role, mesh.topology_dimension = 'mesh_topology', 2
        made = file.createVariable('s', 'f4', ('time', 'layer', 'face'))
        made.mesh, made.location = 'Mesh2', 'face'
        made[:] = 1
    refused(folder / 'u.nc', 'UGRID', 'Mesh2')


def units(folder):
    """Kilometers beside meters: lengths are of one unit, that of x."""
    numpy = need('numpy')
    with new(folder / 'f.nc') as file:
        axis(file, 'x', numpy.arange(5) * 2.0, units='km', axis='X')
        axis(file, 'y', numpy.arange(4) * 1000.0, units='m', axis='Y')
        axis(file, 'z', numpy.arange(3) * 500.0, units='meters', axis='Z')
        file.createVariable('f', 'f4', ('z', 'y', 'x'))[:] = 1
    assert numpy.allclose(info(folder / 'f.nc')['bounds'], [0, 8, 0, 3, 0, 1])
    with new(folder / 'g.nc') as file:
        axis(file, 'x', numpy.arange(5), units='degrees_east')
        axis(file, 'y', numpy.arange(4), units='degrees_north')
        axis(file, 'z', [0, 10, 30], units='m', positive='up')
        file.createVariable('f', 'f4', ('z', 'y', 'x'))[:] = 1
    assert 'units of its axes (degrees_east, degrees_north, m)' in noted(folder / 'g.nc')


def cam(folder):
    """Two quads across the longitude 0, of packed values with a missing one, at times that descend."""
    numpy = need('numpy')
    with new(folder / 'quads.nc', (('ncorners', 4), ('ncells', 2))) as file:
        corners = numpy.array([[1, 2, 5, 4], [2, 3, 6, 5]])
        file.createVariable('element_corners', 'i4', ('ncorners', 'ncells'))[:] = corners.T
    with new(folder / 'f.nc', (('time', 2), ('lev', 3), ('ncol', 6))) as file:
        axis(file, 'time', [10.0, 5.0], units='days since 2000-01-01')
        axis(file, 'lev', [100.0, 500.0, 1000.0])
        axis(file, 'lon', [358.0, 0.0, 2.0] * 2, sides=('ncol',))
        axis(file, 'lat', [0.0] * 3 + [3.0] * 3, sides=('ncol',))
        values = numpy.full((2, 3, 6), 50, 'i2')
        values[1] = 70
        values[:, 2, 0] = -32767
        axis(file, 'T', values, 'i2', ('time', 'lev', 'ncol'), scale_factor=0.1, _FillValue=-32767)
    assert info(folder / 'f.nc')['time_units'] == 'days since 2000-01-01'
    for time, mean in (('5', 7), ('10', 5), ('#0', 7), ('last', 5)):
        sheet = cut(folder / 'f.nc', 'T', *FLAT, 0, 1, 1.5, '--time', time)
        assert near(sheet['area'], 12) and near(sheet['mean'], mean), (time, sheet)
    with new(folder / 'quads.nc', (('ncorners', 4), ('ncells', 2))) as file:
        file.createVariable('element_corners', 'i4', ('ncorners', 'ncells'))[:] = 7
    refused(folder / 'f.nc', 'column 7 of 6', '--solution')


def series_of_equal_times(folder):
    """Files of a list with one time are reached by their index."""
    numpy = need('numpy')
    for name, value in (('a', 1), ('b', 2), ('c', 3)):
        numpy.save(folder / f'{name}.npy', numpy.full((3, 3, 3), float(value)))
    (folder / 'f.series').write_text('{"files": [{"name": "a.npy", "time": 5}, {"name": "b.npy", "time": 5}, '
                                     '{"name": "c.npy", "time": 1}]}')
    assert info(folder / 'f.series')['times'] == [1, 5, 5]
    tops = [info(folder / 'f.series', '--time', time)['arrays'][0]['range'][1] for time in ('#0', '#1', '#2', '5')]
    assert tops == [3, 1, 2, 1], tops


def cgns_times(folder):
    """Times in any order, which VTK's reader would leave out; of equal ones the last is shown."""
    h5py, numpy = need('h5py'), need('numpy')
    corners = numpy.array([[i & 1, i >> 1 & 1, i >> 2] for i in range(8)], float)
    for times in ([2.0, 1.0, 0.5], [0.5, 1.0, 1.0]):
        path = folder / f'{times[0]}.cgns'
        with h5py.File(path, 'w', track_order=True) as file:
            node = begin_cgns(numpy, file)
            base = node(file, 'Base', 'CGNSBase_t', 'I4', numpy.array([3, 3], dtype='i4'))
            steps = node(base, 'Steps', 'BaseIterativeData_t', 'I4', numpy.array([3], dtype='i4'))
            node(steps, 'TimeValues', 'DataArray_t', 'R8', numpy.array(times))
            zone = node(base, 'Zone', 'Zone_t', 'I4', numpy.array([[8], [1], [0]], dtype='i4'))
            node(zone, 'ZoneType', 'ZoneType_t', 'C1', 'Unstructured')
            places = node(zone, 'GridCoordinates', 'GridCoordinates_t')
            for i in range(3):
                node(places, 'Coordinate' + 'XYZ'[i], 'DataArray_t', 'R8', corners[:, i].copy())
            part = node(zone, 'Cells', 'Elements_t', 'I4', numpy.array([17, 0], dtype='i4'))
            node(part, 'ElementRange', 'IndexRange_t', 'I4', numpy.array([1, 1], dtype='i4'))
            node(part, 'ElementConnectivity', 'DataArray_t', 'I4', numpy.array([1, 2, 4, 3, 5, 6, 8, 7], dtype='i4'))
            names = [f'Step{i}' for i in range(3)]
            of_zone = node(zone, 'OfZone', 'ZoneIterativeData_t')
            pointers = numpy.frombuffer(''.join(n.ljust(32) for n in names).encode(), dtype='i1').reshape(3, 32)
            node(of_zone, 'FlowSolutionPointers', 'DataArray_t', 'C1', pointers)
            for i, name in enumerate(names):
                solution = node(zone, name, 'FlowSolution_t')
                node(solution, 'GridLocation', 'GridLocation_t', 'C1', 'Vertex')
                node(solution, 'u', 'DataArray_t', 'R8', numpy.full(8, 10.0 + i))
        if times[0] == 2.0:
            assert info(path)['times'] == [0.5, 1.0, 2.0]
            ranges = [info(path, '--time', time)['arrays'][0]['range'][0] for time in ('#0', '#2', '0.5', '1', '2', 'last')]
            assert ranges == [12, 10, 12, 11, 10, 10], ranges
            continue
        ranges = [info(path, '--time', time)['arrays'][0]['range'][0] for time in ('#0', '#1', '0.5', '1', 'last')]
        assert ranges == [10, 12, 10, 12, 12], ranges
        assert '1 of its 3 steps have the time of another' in noted(path), noted(path)


CASES = [cgns_times, wrf, ocean, ugrid, units, cam, series_of_equal_times]
