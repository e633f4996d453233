"""What `vprobe pack` writes, cut part by part, gives the figures and polygons of what it was made from."""
import json
import shutil
import subprocess

import against
from against import VPROBE, info, mixed_mesh, need, tried, vprobe

# Counts of the search, and what tells one file from the other.
OWN = {'cells_scanned', 'cells_touched', 'cells_walked', 'tree_tests', 'boundary_tests', 'seeds', 'hops',  # of the search
       'generations', 'front_max'}

CUTS = (['--normal', '0.3', '0.5', '0.81'], ['--normal', '1', '0', '0', '--origin', '1.5', '0.4', '4'],
        ['--normal', '0', '0', '1', '--origin', '0', '0', '4'],
        ['--surface', 'sphere:1.5', '--origin', '1', '0.5', '4'],
        ['--surface', 'sin(3*x) + y - 0.4*z + 1'], ['--probe', 'trihedral'], ['--probe', 'paddlewheel'],
        ['--probe', 'stack', '--sheets', '3'], ['--window', '0.7', '0.5'], ['--normal', '1', '0', '2', '--crinkle'],
        ['--normal', '1', '0', '0', '--origin', '90', '0', '0'])  # meets nothing


def figures(path, options, stats):
    vprobe('slice', path, *options, '--stats', stats)
    told = json.loads(stats.read_text())
    return [{k: v for k, v in sheet.items() if k not in OWN} for sheet in told['sheets']], told


def same(a, b):
    """Sums may differ in their last digits, since the cells come in another order."""
    if isinstance(a, float) and isinstance(b, float):
        return a == b or abs(a - b) <= 1e-13 * max(abs(a), abs(b))
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(same, a, b))
    return a == b


def same_figures(path, pack, options, folder):
    (wanted, whole), (got, parts) = (figures(each, options, folder / 'stats.json') for each in (path, pack))
    for a, b in zip(wanted, got, strict=True):
        other = {key: (a[key], b[key]) for key in a if not same(a[key], b[key])}
        assert not other, (options, other)
    assert parts['grid'] == whole['grid'], (options, parts['grid'], whole['grid'])
    return parts['parts']


def polygons(path, options, out):
    """Each polygon as its cell, its array of the cell, and its corners in order of their places."""
    import vtk
    vprobe('slice', path, *options, '-o', out)
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(out))
    reader.Update()
    data = reader.GetOutput()
    cells, g = data.GetCellData().GetArray('vprobe:cell'), data.GetCellData().GetArray('g')
    f = data.GetPointData().GetArray('f')
    found = []
    for c in range(data.GetNumberOfCells()):
        points = data.GetCell(c).GetPointIds()
        corners = sorted((*data.GetPoint(points.GetId(i)), f.GetValue(points.GetId(i)))
                         for i in range(points.GetNumberOfIds()))
        found.append((cells.GetValue(c), g.GetValue(c), corners))
    return sorted(found)


def packed(folder, *options):
    """A mesh of hexahedra and tetrahedra with names of materials, and its pack."""
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mixed_mesh(meshio, numpy)
    mesh.cell_data['material'] = [numpy.arange(len(block.data), dtype='i4') // 20 for block in mesh.cells]
    path, pack = folder / 'mesh.vtu', folder / 'mesh.vtkhdf'
    meshio.write(path, mesh)
    vprobe('pack', path, '-o', pack, *options)
    return path, pack


def packs_are_cut_as_their_inputs(folder):
    path, pack = packed(folder, '--part', '64')
    for options in tried(CUTS):
        parts = same_figures(path, pack, options, folder)
        misses = '90' in options
        assert parts['met'] == 0 if misses else 0 < parts['met'] <= parts['all'], parts
        assert polygons(pack, options, folder / 'a.vtp') == polygons(path, options, folder / 'b.vtp'), options


def packs_read_what_is_cut(folder):
    """A thin layer of a box meets few of its parts."""
    pack = folder / 'box.vtkhdf'
    vprobe('pack', 'demo:tets:16', '-o', pack, '--part', '256')
    for options, share in (([], 0.7), (['--crinkle'], 0.7), (['--window', '0.5', '0.4'], 0.3)):
        told = same_figures('demo:tets:16', pack, ['--normal', '1', '2', '3', *options], folder)
        assert told['met'] < share * told['all'] and told['bytes_read'] < 0.9 * pack.stat().st_size, told


def contours_of(path, options, stats):
    own = {'seeds', 'generations', 'cells_touched'}  # of the search
    return [{k: v for k, v in each.items() if k not in own} for each in figures(path, options, stats)[1]['contours']]


def packs_find_neighbors_near_sheets(folder):
    """A threshold, seeds and contours need the neighbors of the cells near the sheet, and no others."""
    pack = folder / 'box.vtkhdf'
    vprobe('pack', 'demo:tets:16', '-o', pack, '--part', '64')
    searched = (['--threshold', '-0.2', '0.4'], ['--threshold', '-0.2', '0.4', '--crinkle'], ['--seeds', 'boundary'],
                ['--outside', 'report'], ['--contour', '0.2', '0.3', '--contour-depth', '0.1'],
                ['--contour-at', '0.5', '0.5'])
    sheets = (['--normal', '1', '2', '3'], ['--normal', '0', '0', '1', '--origin', '0', '0', '0.5'],
              ['--normal', '1', '2', '3', '--window', '0.5', '0.4'])
    for sheet in tried(sheets):
        for options in searched:
            cut = [*sheet, *options]
            wide = '--contour-at' in cut and '--window' not in cut  # its box reaches far
            told = same_figures('demo:tets:16', pack, cut, folder)
            assert wide or told['read'] < 0.8 * told['all'], (cut, told)
            wanted, got = (contours_of(each, cut, folder / 's.json') for each in ('demo:tets:16', pack))
            assert all(same(a[key], b[key]) for a, b in zip(wanted, got, strict=True) for key in a), (cut, wanted, got)


def swept(path, folder, *options):
    """The sheets and the parts of each frame."""
    vprobe('sweep', path, '--normal', '0.3', '0.5', '0.81', '--frames', '16', '--array', 's', *options,
           '--stats', folder / 'stats.json')
    frames = json.loads((folder / 'stats.json').read_text())['frames']
    own = OWN | {'hot_spot_inside'}  # a scan does not look for it
    return [[{k: v for k, v in sheet.items() if k not in own} for sheet in frame['sheets']] for frame in frames], \
           [frame['parts'] for frame in frames]


def packs_are_swept_as_their_inputs(folder, cases=(['--memory', '300K'], [], ['--probe', 'trihedral'])):
    """A run is read once, when a sheet comes to it. With little memory it goes again, and the figures stay."""
    pack = folder / 'box.vtkhdf'
    vprobe('pack', 'demo:tets:16', '-o', pack, '--part', '256')
    for options in tried(cases):
        (wanted, _), (got, parts) = (swept(each, folder, *options) for each in ('demo:tets:16', pack))
        for frame, (a, b) in enumerate(zip(wanted, got, strict=True)):
            for one, other in zip(a, b, strict=True):
                unlike = {key: (one[key], other[key]) for key in one if not same(one[key], other[key])}
                assert not unlike, (options, frame, unlike)
        read, last = sum(each['read'] for each in parts), parts[-1]
        if '--memory' in options:
            assert max(each['kept'] for each in parts) < last['all'] < read, (read, parts)
        else:
            assert parts[0]['kept'] < read == last['kept'] <= last['all'], (read, parts)


def packs_show_one_value(folder):
    """Parts are read whose values lie on both sides; all, if the pack does not say which."""
    h5py, meshio, numpy = need('h5py'), need('meshio'), need('numpy')
    path, pack = packed(folder, '--part', '64')
    mesh = meshio.read(path)
    mesh.point_data['n'] = numpy.where(mesh.points[:, 0] < 1.2, numpy.nan, mesh.points[:, 2] - 3)
    mesh.point_data['i'] = numpy.arange(len(mesh.points), dtype='i2') % 50
    meshio.write(path, mesh)
    vprobe('pack', path, '-o', pack, '--part', '64')
    cases = [['--array', 'f', '--iso', value] for value in ('200', '31.5', '-1e9')]
    cases += [['--array', 'n', '--iso', '0'], ['--array', 'i', '--iso', '25'], ['--array', 'v', '--iso', '2'],
              ['--array', 'v', '--component', 'y', '--iso', '0.25'], ['--array', 'f', '--iso', '60', '--normal', '1', '0', '0']]
    for options in tried(cases):
        parts = same_figures(path, pack, options, folder)
        assert parts['read'] == parts['met'] < parts['all'] or 'i' in options or 'v' in options, (options, parts)
        assert polygons(pack, options, folder / 'a.vtp') == polygons(path, options, folder / 'b.vtp'), options
    box, options = folder / 'box.vtkhdf', ['--array', 's', '--iso', '1.2']
    vprobe('pack', 'demo:tets:16', '-o', box, '--part', '256')
    parts = same_figures('demo:tets:16', box, options, folder)
    assert 0 < parts['read'] < 0.7 * parts['all'], parts
    with h5py.File(box, 'r+') as file:
        values = file['VTKHDF/PointData/s']
        kept = values[...]
        values[...] = kept + 0.05  # and the ranges are as they were
    done = subprocess.run([VPROBE, 'slice', box, *options, '--stats', '-'], capture_output=True, encoding='utf-8')
    assert done.returncode == 2 and 'lies outside the range of its cells' in done.stderr, done
    with h5py.File(box, 'r+') as file:
        file['VTKHDF/PointData/s'][...] = kept
        del file['vprobe/PointData/s/RunRanges']
    parts = same_figures('demo:tets:16', box, options, folder)
    assert parts['read'] == parts['all'], parts


def packs_are_whole_where_that_is_asked(folder):
    """What looks beyond the cut cells reads all parts, as all other commands do."""
    path, pack = packed(folder, '--part', '64')
    for options in (['--strategy', 'cells'], ['--cell-to-point', '--array', 'g'],
                    ['--surface', 'sphere:1.5', '--threshold', '30', '400']):
        done = [subprocess.run([VPROBE, 'slice', each, *options, '--stats', folder / 's.json'], capture_output=True,
                               encoding='utf-8') for each in (path, pack)]
        assert [each.returncode for each in done] == [0, 0], done
        told = same_figures(path, pack, options, folder)
        assert told['read'] == told['all'], (options, told)
    one, other = info(path), info(pack)
    assert one['blocks'][0]['parts'] is None and other['blocks'][0]['parts'] == 4, other['blocks']
    for key in ('grid', 'bounds'):
        assert one[key] == other[key], (key, one[key], other[key])
    assert [(a['name'], a['range']) for a in one['arrays']] == [(a['name'], a['range']) for a in other['arrays']]


def packs_look_like_their_inputs(folder):
    """The colors go by all values, and materials are categories, also where few parts are read."""
    path, pack = packed(folder, '--part', '64')
    for array in ('f', 'v', 'material'):
        pictures = []
        for number, each in enumerate((path, pack)):
            out = folder / f'{number}.svg'
            vprobe('slice', each, '--normal', '0', '0', '1', '--array', array, '-o', out)
            # Without the letters of the title, which has the file's name.
            pictures.append(sorted(line for line in out.read_text().splitlines() if 'fill:rgb' in line))
        assert pictures[0] == pictures[1], array


def older(pack, folder):
    """Returns a pack like this one that does not tell the least values above 0."""
    old = folder / 'old.vtkhdf'
    shutil.copy(pack, old)
    with need('h5py').File(old, 'r+') as file:
        for array in (*file['vprobe/PointData'].values(), *file['vprobe/CellData'].values()):
            del array['LeastPositive']
    return old


def packs_take_logarithms(folder):
    """A logarithmic scale begins at the least value above 0, wherever that lies. Old packs do not tell it."""
    path, pack = packed(folder, '--part', '64')
    old = older(pack, folder)
    for array in ('f', 'v', 'material'):
        scales, reads = [], []
        for each in (path, pack, old):
            out, stats = folder / 'log.svg', folder / 'log.json'
            cut = ['slice', each, '--normal', '0', '0', '1', '--origin', '0', '0', '1', '--array', array, '--log']
            done = subprocess.run([VPROBE, *cut, '-o', out, '--stats', stats], capture_output=True, encoding='utf-8')
            assert done.returncode == 0, done
            lines = done.stderr.replace(str(each), '')
            scales.append((lines, sorted(line for line in out.read_text().splitlines() if 'fill:rgb' in line)))
            reads.append(json.loads(stats.read_text())['parts'])
        assert scales[0] == scales[1] == scales[2], array
        assert reads[1]['read'] < reads[1]['all'] == reads[2]['read'], (array, reads)


def packs_tell_cells_that_are_left_out(folder):
    """Flat and hidden cells, and those with a point without a place, wherever they lie."""
    import vtk
    numpy = need('numpy')
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    path, pack = packed(folder)
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    vtk_to_numpy(grid.GetPoints().GetData())[117] = [1e60, numpy.nan, 0.0]  # far from the cut
    beyond = grid.GetPoints().InsertNextPoint(50.0, 0.0, 0.0)
    for name in ('f', 'v'):
        array = grid.GetPointData().GetArray(name)
        array.InsertNextTuple(array.GetTuple(0))
    for corners in ((0, 1, 7), (1, 2, beyond)):
        grid.InsertNextCell(vtk.VTK_TRIANGLE, 3, corners)
    cells = grid.GetNumberOfCells()
    for name in ('g', 'material'):
        grid.GetCellData().RemoveArray(name)
    marks = numpy.zeros(cells, 'u1')
    marks[[3, 4, 5]] = 32  # hidden
    ghosts = numpy_to_vtk(marks, deep=True)
    ghosts.SetName('vtkGhostType')
    grid.GetCellData().AddArray(ghosts)
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.Write()
    vprobe('pack', path, '-o', pack, '--part', '64')
    options = ['--normal', '0', '0', '1', '--origin', '1', '0.3', '1']
    told = same_figures(path, pack, options, folder)
    assert told['read'] < told['all'], told
    said = [subprocess.run([VPROBE, 'slice', each, *options, '--stats', folder / 's.json'], capture_output=True,
                           encoding='utf-8').stderr.replace(str(each), 'FILE') for each in (path, pack)]
    assert said[0] == said[1] and '3 ghost or hidden cells' in said[0], said
    assert info(path)['bounds'] == info(pack)['bounds']
    one, other = info(path)['grid'], info(pack)['grid']
    assert one == other and one['cells_left_out'] == 2 and one['cells_without_place'] > 0, (one, other)


ODD = """# vtk DataFile Version 3.0
a tetrahedron that lists five points, and ids
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 7 float
0 0 0  1 0 0  0 1 0  0 0 1  1 1 1  2 2 2  -1 -1 -1
CELLS 3 15
5 0 1 2 3 5  4 1 2 3 4  3 0 1 2
CELL_TYPES 3
10 10 5
POINT_DATA 7
SCALARS id vtkIdType 1
LOOKUP_TABLE default
10 20 30 40 50 60 70
CELL_DATA 3
SCALARS long long 1
LOOKUP_TABLE default
7 8 9
"""


def packs_keep_what_is_odd(folder):
    """Ids of VTK's own type are numbers, of too many points the first ones are used, and some have no cell."""
    path, pack = folder / 'odd.vtk', folder / 'odd.vtkhdf'
    path.write_text(ODD)
    vprobe('pack', path, '-o', pack)
    for array in ('id', 'long'):
        same_figures(path, pack, ['--normal', '1', '2', '3', '--array', array], folder)
    same_figures(path, pack, ['--normal', '1', '2', '3', '--crinkle'], folder)


def packs_are_converted_and_packed_again(folder):
    path, pack = packed(folder, '--part', '64')
    again, back = folder / 'again.vtkhdf', folder / 'back.vtu'
    vprobe('pack', pack, '-o', again, '--part', '100')
    vprobe('convert', pack, '-o', back)
    for each in (again, back):
        options = ['--probe', 'trihedral', '--array', 'f', '--stats', folder / 's.json']
        sheets = []
        for file in (path, each):
            vprobe('slice', file, *options)
            sheets.append(json.loads((folder / 's.json').read_text())['sheets'])
        for a, b in zip(*sheets, strict=True):
            assert not {key for key in a if key not in OWN and not same(a[key], b[key])}, each


def arrays_that_become_alike_are_kept(folder):
    """HDF5 has no names with slashes and dots."""
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mixed_mesh(meshio, numpy)
    f = mesh.point_data['f']
    mesh.point_data = {'a.b': f, 'a/b': 2 * f, 'a_b': 3 * f}
    path = folder / 'mesh.vtu'
    meshio.write(path, mesh)
    for command in ('pack', 'convert'):
        out = folder / f'{command}.vtkhdf'
        vprobe(command, path, '-o', out)
        told = {a['name']: a['range'][1] for a in info(out)['arrays'] if a['association'] == 'point'}
        names = ('a.b', 'a/b', 'a_b') if command == 'pack' else ('a_b', 'a_b_2', 'a_b_3')  # a pack says what they were
        assert told == {name: (n + 1) * f.max() for n, name in enumerate(names)}, told


def vtk_reads_packs(folder):
    import vtk
    if not hasattr(vtk, 'vtkHDFReader'):
        raise against.Missing('vtkHDFReader')
    path, pack = packed(folder, '--part', '64')
    sums = []
    for reader, file in ((vtk.vtkXMLUnstructuredGridReader(), path), (vtk.vtkHDFReader(), pack)):
        reader.SetFileName(str(file))
        sizes = vtk.vtkCellSizeFilter()
        sizes.SetInputConnection(reader.GetOutputPort())
        sizes.Update()
        data = sizes.GetOutput()
        volume, g = data.GetCellData().GetArray('Volume'), data.GetCellData().GetArray('g')
        cells = range(data.GetNumberOfCells())
        sums.append((len(cells), sum(volume.GetValue(c) for c in cells),
                     sum(g.GetValue(c) * volume.GetValue(c) for c in cells)))
    assert sums[0][0] == sums[1][0], sums
    assert all(abs(a - b) < 1e-9 * abs(a) for a, b in zip(*sums)), sums


def parts_of_several_partitions(folder):
    """A pack that is too large for the numbers of one partition has several. Here it is divided by hand."""
    h5py, numpy = need('h5py'), need('numpy')
    path, pack = packed(folder, '--part', '64')
    with h5py.File(pack, 'r+') as file:
        root, own = file['VTKHDF'], file['vprobe']
        parts, in_runs = len(own['PartPoints']), own['NumberOfConnectivityIds'][...]
        assert parts == len(in_runs) > 3  # a run each
        points, cells, ids = (int(list_of[:2].sum()) for list_of in (own['PartPoints'], own['PartCells'], in_runs))
        connectivity, ends = root['Connectivity'][...], root['Offsets'][...]
        connectivity[ids:] -= points
        ends = numpy.concatenate([ends[:cells + 1], ends[cells:] - ends[cells]])
        for name, first in (('NumberOfPoints', points), ('NumberOfCells', cells), ('NumberOfConnectivityIds', ids)):
            both = [first, root[name][0] - first]
            del root[name]
            root[name] = numpy.array(both, dtype='i8')
        for name, values in (('Connectivity', connectivity), ('Offsets', ends)):
            del root[name]
            root[name] = values
    for options in tried((*CUTS, ['--crinkle'])):
        same_figures(path, pack, options, folder)


def packs_in_chunks(folder):
    """Lists that another program has packed are read through HDF5."""
    h5py = need('h5py')
    path, pack = packed(folder, '--part', '64')
    with h5py.File(pack, 'r+') as file:
        for name in ('VTKHDF/Points', 'VTKHDF/Connectivity', 'VTKHDF/PointData/f', 'vprobe/PointNumbers'):
            values = file[name][...]
            del file[name]
            file.create_dataset(name, data=values, chunks=True, compression='gzip')
    same_figures(path, pack, ['--normal', '0.3', '0.5', '0.81', '--array', 'f'], folder)


def change(name, at, value):
    def damage(file):
        values = file[name][...]
        values[at] = value
        file[name][...] = values
    return damage


def remove(name):
    return lambda file: file.__delitem__(name)


def shorten(name):
    def damage(file):
        values = file[name][:-1]
        del file[name]
        file[name] = values
    return damage


def damaged_packs_are_refused(folder):
    h5py, numpy = need('h5py'), need('numpy')
    path, pack = packed(folder, '--part', '64')

    def attribute(name, value):
        def damage(file):
            file['vprobe'].attrs[name] = numpy.array([value])
        return damage

    def points_in_the_next_part(file):  # and all ids in the first run
        points, ids = file['vprobe/PartPoints'][...], file['vprobe/NumberOfConnectivityIds'][...]
        points[:3] = 0, 0, points[:3].sum()
        file['vprobe/PartPoints'][...] = points
        file['vprobe/NumberOfConnectivityIds'][...] = [ids.sum()] + [0] * (len(ids) - 1)

    damages = {
        'parts without points': points_in_the_next_part, 'a newer version': attribute('Version', 5), 'no count of hidden cells': lambda file: file['vprobe'].attrs.__delitem__('HiddenCells'),
        'a point moved': change('VTKHDF/Points', (0, 0), -3.0), 'a smaller box': change('vprobe/Boxes', (0, 3), 0.1),
        'an id beyond': change('VTKHDF/Connectivity', 0, 999999), 'an id below 0': change('VTKHDF/Connectivity', 0, -1),
        'points out of order': change('vprobe/PointNumbers', 1, 0),
        'a number beyond': change('vprobe/PointNumbers', 3, 4000000000),
        'a point more': attribute('NumberOfPoints', 10 ** 9), 'a cell less': attribute('NumberOfCells', 1),
        'no cells in a run': attribute('CellsOfRun', 0), 'shorter runs': attribute('CellsOfRun', 20),
        'another run': change('vprobe/NumberOfConnectivityIds', 0, 7), 'no boxes of all': shorten('vprobe/Boxes'),
        'no numbers of all': shorten('vprobe/CellNumbers'), 'points missing': shorten('VTKHDF/Points'),
        'no part of all': shorten('vprobe/PartCells'), 'another part': change('vprobe/PartPoints', 0, 3),
        'no numbers': remove('vprobe/PointNumbers'), 'no ranges': remove('vprobe/PointData/f/Spans'),
        'a least value below 0': change('vprobe/PointData/f/LeastPositive', 0, -1.0),
        'no least value of all': shorten('vprobe/PointData/f/LeastPositive'),
        'no ranges of all': shorten('vprobe/PointData/f/RunRanges'),
        'offsets that fall': change('VTKHDF/Offsets', 2, 100000), 'a wrong count': change('VTKHDF/NumberOfCells', 0, 1),
        'ranges turned': change('vprobe/PointData/f/Spans', (0, 0), 1e30)}
    for name, damage in tried(list(damages.items())):
        broken = folder / 'broken.vtkhdf'
        shutil.copy(pack, broken)
        with h5py.File(broken, 'r+') as file:
            damage(file)
        done = subprocess.run([VPROBE, 'slice', broken, '--probe', 'stack', '--sheets', '20', '--stats', '-'],
                              capture_output=True, encoding='utf-8')
        if name == 'ranges turned':  # no value is finite, says the file, so there is no range
            assert done.returncode == 0, done.stderr
            continue
        assert done.returncode == 2 and len(done.stderr.strip().splitlines()) == 1, (name, done.returncode, done.stderr)


def packing_refuses(folder):
    path, _ = packed(folder)
    for arguments, words in ((['pack', path], '--output'),
                             (['pack', path, '-o', folder / 'a.vtu'], 'written as .vtkhdf'),
                             (['pack', path, path, '-o', folder / 'a.vtkhdf'], 'takes one file'),
                             (['pack', 'demo:shell:4', '-o', folder / 'a.vtkhdf'], 'convert it to .vtu first'),
                             (['pack', path, '-o', folder / 'a.vtkhdf', '--array', 'h'],
                              '--array h: no such array; there are: cell:g, cell:material, point:f, point:v'),
                             (['pack', path, '-o', folder / 'a.vtkhdf', '--part', '3'], '--part')):
        done = subprocess.run([VPROBE, *map(str, arguments)], capture_output=True, encoding='utf-8')
        assert done.returncode in (1, 2) and words in done.stderr, (arguments, done)
        assert not (folder / 'a.vtkhdf').exists()


CASES = [packs_are_cut_as_their_inputs, packs_read_what_is_cut, packs_find_neighbors_near_sheets, packs_are_swept_as_their_inputs, packs_show_one_value,
         packs_are_whole_where_that_is_asked, packs_look_like_their_inputs, packs_take_logarithms,
         packs_tell_cells_that_are_left_out,
         packs_keep_what_is_odd, packs_are_converted_and_packed_again, arrays_that_become_alike_are_kept,
         vtk_reads_packs, parts_of_several_partitions, packs_in_chunks, damaged_packs_are_refused, packing_refuses]
