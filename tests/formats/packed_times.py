"""A pack holds all times of a grid that stands still, and all its blocks."""
import json
import shutil
import subprocess

from against import VPROBE, info, mixed_mesh, need, tried, vprobe
from packs import CUTS, OWN, polygons, same, same_figures

TIMES = (0.0, 0.5, 1.0, 1.5)


def mesh_at(time):
    """The mixed mesh, with values that change and materials that come and go."""
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mixed_mesh(meshio, numpy)
    mesh.point_data['f'] = mesh.point_data['f'] * (1 - time) + 30 * time
    mesh.cell_data['g'] = [values + time for values in mesh.cell_data['g']]
    mesh.cell_data['material'] = [numpy.arange(len(block.data), dtype='i4') // 20 % int(1 + 2 * time)
                                  for block in mesh.cells]
    return mesh


def series(folder, change=None):
    """A file for each time, and an index of them, which is not in their order. change(mesh, time) alters a mesh."""
    meshio = need('meshio')
    for step, time in enumerate(TIMES):
        mesh = mesh_at(time)
        if change:
            change(mesh, time)
        meshio.write(folder / f'mesh{step}.vtu', mesh)
    lines = [f'<DataSet timestep="{time}" file="mesh{step}.vtu"/>' for step, time in enumerate(TIMES)]
    (folder / 'mesh.pvd').write_text('<VTKFile type="Collection" version="0.1"><Collection>' + ''.join(lines[::-1]) +
                                     '</Collection></VTKFile>')
    return folder / 'mesh.pvd'


def packed(folder):
    path, pack = series(folder), folder / 'mesh.vtkhdf'
    vprobe('pack', path, '-o', pack, '--part', '64')
    return path, pack


def all_times_are_those_of_the_input(folder):
    path, pack = packed(folder)
    for time in ([], *(['--time', time] for time in ('#0', '#1', '0.9', 'last'))):
        one, other = (info(each, *time) for each in (path, pack))
        assert other['times'] == list(TIMES) and one['times'] == other['times'], other['times']
        assert [(a['name'], a['range']) for a in one['arrays']] == [(a['name'], a['range']) for a in other['arrays']]
        for cut in tried(CUTS[:4]):
            for array in (['--array', 'f'], ['--array', 'material'], ['--threshold', '20', '60']):
                same_figures(path, pack, [*cut, *array, *time], folder)
        same_figures(path, pack, ['--array', 'f', '--iso', '31', *time], folder)
        assert polygons(pack, CUTS[0] + time, folder / 'a.vtp') == polygons(path, CUTS[0] + time, folder / 'b.vtp')
    # The copy of a time has no others.
    vprobe('pack', path, '-o', folder / 'one.vtkhdf', '--time', '0.5')
    same_figures(folder / 'mesh1.vtu', folder / 'one.vtkhdf', [], folder)
    assert info(folder / 'one.vtkhdf')['times'] == []
    vprobe('pack', pack, '-o', folder / 'again.vtkhdf')
    for time in ('#0', '#3'):
        same_figures(path, folder / 'again.vtkhdf', ['--time', time], folder)


def all_times_of_xdmf_are_packed(folder):
    """Written by meshio, points and cells once."""
    meshio = need('meshio')
    path, pack = folder / 'mesh.xdmf', folder / 'mesh.vtkhdf'
    with meshio.xdmf.TimeSeriesWriter(path, data_format='XML') as writer:
        mesh = mesh_at(0.0)
        writer.write_points_cells(mesh.points, mesh.cells)
        for time in TIMES:
            mesh = mesh_at(time)
            writer.write_data(time, point_data={'f': mesh.point_data['f']}, cell_data={'g': mesh.cell_data['g']})
    vprobe('pack', path, '-o', pack, '--part', '64')
    for time in TIMES:
        same_figures(path, pack, [*CUTS[0], '--time', str(time)], folder)


def several_blocks_are_packed_as_one_file(folder):
    """Two blocks of cells with a common border, at each time. Their names and numbers are kept."""
    meshio, h5py, numpy = need('meshio'), need('h5py'), need('numpy')
    lines = []
    for step, time in enumerate(TIMES):
        mesh = mesh_at(time)
        for name, block in zip('ab', range(2)):
            used, lists = numpy.unique(mesh.cells[block].data, return_inverse=True)
            cells = [(mesh.cells[block].type, lists.reshape(mesh.cells[block].data.shape))]
            of_points = {key: values[used] for key, values in mesh.point_data.items()}
            of_cells = {key: [values[block]] for key, values in mesh.cell_data.items()}
            meshio.write(folder / f'{name}{step}.vtu', meshio.Mesh(mesh.points[used], cells, of_points, of_cells))
        (folder / f'both{step}.vtm').write_text(
            '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>' +
            ''.join(f'<DataSet index="{i}" name="{name}" file="{file}{step}.vtu"/>'
                    for i, (file, name) in enumerate((('a', 'outer/part'), ('b', 'outer.part')))) +
            '</vtkMultiBlockDataSet></VTKFile>')
        lines.append(f'<DataSet timestep="{time}" file="both{step}.vtm"/>')
    path, pack = folder / 'both.pvd', folder / 'both.vtkhdf'
    path.write_text('<VTKFile type="Collection"><Collection>' + ''.join(lines) + '</Collection></VTKFile>')
    vprobe('pack', path, '-o', pack, '--part', '64')
    for time in TIMES:
        for cut in tried(CUTS[:5]):
            same_figures(path, pack, [*cut, '--time', str(time)], folder)
    for options in tried((['--crinkle'], ['--threshold', '20', '60'])):
        same_figures(path, pack, options, folder)
    assert polygons(pack, CUTS[0], folder / 'a.vtp') == polygons(path, CUTS[0], folder / 'b.vtp')
    (wanted, _), (got, parts) = (swept(each, folder, '--normal', '1', '0', '0.2') for each in (path, pack))
    for one, other in zip(wanted, got, strict=True):
        assert all(map(same, (v for sheet in one[1:] for v in sheet.values()),
                       (v for sheet in other[1:] for v in sheet.values()))), (one, other)
    assert 0 < parts[-1]['bytes_read'] < 0.3 * parts[0]['bytes_read'], parts
    one, other = info(path), info(pack)
    for key in ('grid', 'bounds', 'times'):
        assert one[key] == other[key], (key, one[key], other[key])
    assert [block['name'] for block in other['blocks']] == ['both: outer_part', 'both: outer_part_2'], other['blocks']
    # As VTKHDF 2.1 has collections.
    with h5py.File(pack, 'r') as file:
        root = file['VTKHDF']
        assert root.attrs['Type'] == b'PartitionedDataSetCollection' and list(root.attrs['Version']) == [2, 1]
        for number, name in enumerate(('outer_part', 'outer_part_2')):
            assert root[name].attrs['Index'] == number and root[name].attrs['Type'] == b'UnstructuredGrid'
            assert root['Assembly'][name] == root[name]
    # One time of them, and again.
    vprobe('pack', path, '-o', folder / 'one.vtkhdf', '--time', '0.5')
    same_figures(folder / 'both1.vtm', folder / 'one.vtkhdf', CUTS[0], folder)
    vprobe('pack', pack, '-o', folder / 'again.vtkhdf')
    same_figures(path, folder / 'again.vtkhdf', [*CUTS[0], '--time', '#1'], folder)


def blocks_of_exodus_are_packed(folder):
    """Two blocks of elements."""
    meshio = need('meshio')
    need('netCDF4')
    meshio.write(folder / 'mesh.e', mesh_at(0.5))
    vprobe('pack', folder / 'mesh.e', '-o', folder / 'mesh.vtkhdf', '--part', '64')
    assert len(info(folder / 'mesh.vtkhdf')['blocks']) == 2
    for cut in tried(CUTS):
        same_figures(folder / 'mesh.e', folder / 'mesh.vtkhdf', cut, folder)


def swept(path, folder, *options):
    vprobe('sweep', path, '--path', 'times', '--array', 'f', *options, '--stats', folder / 'stats.json')
    frames = json.loads((folder / 'stats.json').read_text())['frames']
    own = OWN | {'hot_spot_inside'}
    return [[frame['time'], *({k: v for k, v in sheet.items() if k not in own} for sheet in frame['sheets'])]
            for frame in frames], [frame['parts'] for frame in frames]


def a_time_reads_the_values_of_what_is_cut(folder):
    path, pack = packed(folder)
    for options in tried((['--normal', '0.3', '0.5', '0.81'], ['--probe', 'trihedral'], ['--threshold', '20', '60'],
                          ['--normal', '1', '0', '0', '--memory', '20K'])):
        (wanted, _), (got, parts) = (swept(each, folder, *options) for each in (path, pack))
        assert len(wanted) == len(got) == len(TIMES)
        for one, other in zip(wanted, got, strict=True):
            assert one[0] == other[0], (one[0], other[0])
            for a, b in zip(one[1:], other[1:], strict=True):
                unlike = {key: (a[key], b[key]) for key in a if not same(a[key], b[key])}
                assert not unlike, (options, one[0], unlike)
        if '--threshold' in options or '--memory' in options:
            continue
        first, *later = parts
        for each in later:  # f has 8 bytes a point, of 36 with its place and number, and a hexahedron 32 for ids
            assert each['kept'] == first['kept'] and 0 < each['bytes_read'] < 0.3 * first['bytes_read'], parts


def steps_follow_the_specification(folder):
    """Lists of each time as VTKHDF 2.0 has them, read by h5py."""
    h5py, numpy = need('h5py'), need('numpy')
    _, pack = packed(folder)
    with h5py.File(pack, 'r') as file:
        root, own = file['VTKHDF'], file['vprobe']
        assert list(root.attrs['Version']) == [2, 0] == list(own.attrs['Version'])
        steps = root['Steps']
        assert steps.attrs['NSteps'] == len(TIMES) and list(steps['Values']) == list(TIMES)
        points, cells = root['NumberOfPoints'][...], root['NumberOfCells'][...]
        for name, value in (('PartOffsets', 0), ('PointOffsets', 0), ('CellOffsets', 0), ('ConnectivityIdOffsets', 0),
                            ('NumberOfParts', len(points))):
            assert list(steps[name]) == [value] * len(TIMES), name
        for step, time in enumerate(TIMES):
            mesh = mesh_at(time)
            for group, name, count, numbers, values in (
                    ('Point', 'f', points.sum(), own['PointNumbers'][...], mesh.point_data['f']),
                    ('Point', 'v', points.sum(), own['PointNumbers'][...], mesh.point_data['v']),
                    ('Cell', 'g', cells.sum(), own['CellNumbers'][...], numpy.concatenate(mesh.cell_data['g']))):
                first = steps[f'{group}DataOffsets/{name}'][step]
                assert (root[f'{group}Data/{name}'][first:first + count] == values[numbers]).all(), (name, time)


def grids_that_move_are_refused(folder):
    def moved(mesh, time):
        mesh.points[3, 1] += 0.01 * (time == 0.5)

    def turned(mesh, time):
        if time == 1.0:
            mesh.cells[1].data[5] = mesh.cells[1].data[5][[1, 2, 0, 3]]

    def without_v(mesh, time):
        if time == 0.0:
            del mesh.point_data['v']

    def single(mesh, time):
        if time == 0.5:
            mesh.point_data['f'] = mesh.point_data['f'].astype('f4')

    pack = folder / 'mesh.vtkhdf'
    for change, words in ((moved, 'other points or cells at time 0.5 than at time 1.5'),
                          (turned, 'other points or cells at time 1 '), (without_v, 'no array v at time 0; name'),
                          (single, 'another type of numbers in the array f at time 0.5')):
        path = series(folder, change)
        done = subprocess.run([VPROBE, 'pack', path, '-o', pack], capture_output=True, encoding='utf-8')
        assert done.returncode == 2 and len(done.stderr.strip().splitlines()) == 1, done
        assert words in done.stderr and '--time' in done.stderr, done.stderr
        assert not pack.exists()
        vprobe('pack', path, '-o', pack, '--time', '0.5')
        same_figures(folder / 'mesh1.vtu', pack, [], folder)
        pack.unlink()
    image = ('# vtk DataFile Version 3.0\nimage\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nORIGIN 0 0 0\n'
             'SPACING 1 1 1\nPOINT_DATA 8\nSCALARS f double\nLOOKUP_TABLE default\n')
    for step in (0, 1):
        (folder / f'image{step}.vtk').write_text(image + f'{step}\n' * 8)
    (folder / 'image.pvd').write_text('<VTKFile type="Collection"><Collection><DataSet timestep="0" file="image0.vtk"/>'
                                      '<DataSet timestep="1" file="image1.vtk"/></Collection></VTKFile>')
    for arguments, words in (([folder / 'image.pvd'], 'has 2 times, and an image is packed at one time'),
                             ([series(folder), '--displace-by', 'v'], 'has 4 times, and its points move with them')):
        done = subprocess.run([VPROBE, 'pack', *arguments, '-o', pack], capture_output=True, encoding='utf-8')
        assert done.returncode == 2 and words in done.stderr and '--time' in done.stderr, done
        assert not pack.exists()
        vprobe('pack', *arguments, '-o', pack, '--time', 'last')
        pack.unlink()
    vprobe('pack', series(folder, without_v), '-o', pack, '--array', 'f')
    assert [array['name'] for array in info(pack)['arrays']] == ['f']


def damaged_times_are_refused(folder):
    h5py = need('h5py')
    _, pack = packed(folder)
    damages = {
        'values beyond': ('VTKHDF/Steps/PointDataOffsets/f', 3, 10 ** 6),
        'values before': ('VTKHDF/Steps/CellDataOffsets/g', 0, -1),
        'another part': ('VTKHDF/Steps/PartOffsets', 1, 1), 'other points': ('VTKHDF/Steps/PointOffsets', 2, 8),
        'more parts': ('VTKHDF/Steps/NumberOfParts', 0, 2),
        'more labels': ('vprobe/CellData/material/NumberOfValues', 0, 100),
        'no labels of all': ('vprobe/CellData/material/NumberOfValues', None, None),
        'no ranges of all': ('vprobe/PointData/f/Spans', None, None),
        'no values of all': ('VTKHDF/PointData/f', None, None), 'no times of all': ('VTKHDF/Steps/Values', None, None)}
    for name, (path, at, value) in tried(list(damages.items())):
        broken = folder / 'broken.vtkhdf'
        shutil.copy(pack, broken)
        with h5py.File(broken, 'r+') as file:
            values = file[path][...]
            if at is None:
                del file[path]
                file[path] = values[:-1]
            else:
                values[at] = value
                file[path][...] = values
        for command in (['slice', broken, '--stats', '-'], ['slice', broken, '--iso', '20', '--stats', '-']):
            done = subprocess.run([VPROBE, *command], capture_output=True, encoding='utf-8')
            assert done.returncode == 2 and len(done.stderr.strip().splitlines()) == 1, (name, command, done)


CASES = [all_times_are_those_of_the_input, all_times_of_xdmf_are_packed, several_blocks_are_packed_as_one_file,
         blocks_of_exodus_are_packed, a_time_reads_the_values_of_what_is_cut,
         steps_follow_the_specification, grids_that_move_are_refused, damaged_times_are_refused]
