"""What `vprobe index` writes beside a file: cuts read little of the file, and have its figures and polygons."""
import json
import os
import shutil
import subprocess

from against import VPROBE, mixed_mesh, need, tried, vprobe
from packs import CUTS, OWN, polygons, same


def plain(mesh, path, shuffles=False):
    """Writes a mesh as ParaView does without compression: raw numbers behind the XML."""
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk
    meshio, numpy = need('meshio'), need('numpy')
    if shuffles:
        chance = numpy.random.default_rng(3)
        order = chance.permutation(len(mesh.points))
        there = numpy.argsort(order)
        mesh = meshio.Mesh(mesh.points[order], [(block.type, there[block.data]) for block in mesh.cells],
                           {name: values[order] for name, values in mesh.point_data.items()}, mesh.cell_data)
        for c, block in enumerate(mesh.cells):
            cells = chance.permutation(len(block.data))
            block.data = block.data[cells]
            for values in mesh.cell_data.values():
                values[c] = numpy.asarray(values[c])[cells]
    meshio.write(path, mesh)
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    fields = grid.GetCellData(), grid.GetPointData()
    for name, data, count in ('w/o', fields[0], grid.GetNumberOfCells()), ('long', fields[1], grid.GetNumberOfPoints()):
        values = numpy_to_vtk(numpy.arange(count, dtype='i8') * 1000003 % 97, 1)
        values.SetName(name)
        values.GetInformation().Set(vtk.vtkDataArray.UNITS_LABEL(), 'Pa')
        data.AddArray(values)
    time = vtk.vtkDoubleArray()
    time.SetName('TimeValue')
    time.InsertNextValue(2.5)
    grid.GetFieldData().AddArray(time)
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.SetCompressorTypeToNone()
    writer.EncodeAppendedDataOff()
    assert writer.Write()


def indexed(folder, shuffles=False):
    path = folder / 'mesh.vtu'
    plain(mixed_mesh(need('meshio'), need('numpy')), path, shuffles)
    vprobe('index', path, '--part', '64')
    return path


def told(path, options, stats):
    vprobe('slice', path, *options, '--stats', stats)
    return json.loads(stats.read_text())


def figures(stats):
    return [{k: v for k, v in sheet.items() if k not in OWN} for sheet in stats['sheets']]


def both(path, options, folder):
    """Figures with the index and without, which are the same. Returns what is told of parts."""
    stats = folder / 'stats.json'
    with_index, without = told(path, options, stats), told(path, [*options, '--no-index'], stats)
    for a, b in zip(figures(without), figures(with_index), strict=True):
        other = {key: (a[key], b[key]) for key in a if not same(a[key], b[key])}
        assert not other, (options, other)
    assert with_index['grid'] == without['grid'] and without['parts'] is None, options
    return with_index['parts']


def indexed_files_are_cut_as_without(folder):
    arrays = ['f'], ['v'], ['g'], ['w/o'], ['long']
    for shuffles in tried((False, True)):
        path = indexed(folder, shuffles)
        cuts = [*CUTS, *([*CUTS[0], '--array', *array] for array in arrays), ['--array', 'f', '--iso', '31.5'],
                ['--array', 'long', '--iso', '40']]
        for options in tried(cuts):
            assert both(path, options, folder) is not None, options
            wanted = polygons(path, [*options, '--no-index'], folder / 'b.vtp')
            assert polygons(path, options, folder / 'a.vtp') == wanted, options


def indexed_files_are_whole_where_that_is_asked(folder):
    path = indexed(folder)
    for options in tried((['--threshold', '20', '60'], ['--normal', '1', '0', '0', '--crinkle'],
                          ['--normal', '1', '0', '0', '--cell-to-point', '--array', 'g'])):
        both(path, options, folder)
    about = [json.loads(vprobe('info', path, '--json', *more)) for more in ([], ['--no-index'])]
    for key in ('bounds', 'times', 'points', 'cells'):
        assert about[0].get(key) == about[1].get(key), (key, about)
    assert about[0]['times'] == [2.5], about[0]
    line = ['--line', '0', '0', '0', '2.5', '0.7', '8', '20']
    assert vprobe('sample', path, *line) == vprobe('sample', path, *line, '--no-index') != ''


def pages_are_read(folder):
    """Points and cells of long rows: a plane across them reads some of the pages, whichever array it shows."""
    vtk, numpy = need('vtk'), need('numpy')
    from vtk.util.numpy_support import numpy_to_vtk
    vprobe('convert', 'demo:tets:24', '-o', folder / 'packed.vtu')
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(folder / 'packed.vtu'))
    reader.Update()
    grid = reader.GetOutput()
    row = numpy.arange(grid.GetNumberOfCells(), dtype='f8')
    values = numpy_to_vtk(row, 1)
    values.SetName('row')
    grid.GetCellData().AddArray(values)
    writer = vtk.vtkXMLUnstructuredGridWriter()
    path = folder / 'rows.vtu'
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.SetCompressorTypeToNone()
    writer.EncodeAppendedDataOff()
    assert writer.Write()
    vprobe('index', path)
    flat = ['--normal', '0', '0', '1', '--origin', '0', '0', '0.1']  # some layers of the lattice, whole
    parts = both(path, flat, folder)
    assert parts['met'] < parts['all'] / 2 and parts['bytes_read'] < path.stat().st_size / 3, parts
    sweep = ['sweep', path, '--normal', '0.3', '0.5', '0.81', '--frames', '9', '--array', 'row', '--stats',
             folder / 'stats.json']
    frames = []
    for more in [], ['--no-index'], ['--memory', '600K']:
        vprobe(*sweep, *more)
        each = json.loads((folder / 'stats.json').read_text())['frames']
        frames.append([[{k: v for k, v in sheet.items() if k not in OWN | {'hot_spot_inside'}}
                        for sheet in frame['sheets']] for frame in each])
        read = sum(frame['parts']['bytes_read'] for frame in each if frame['parts'])
        assert '--no-index' in more or 0 < read, more
    assert same(frames[0], frames[1]) and same(frames[2], frames[1])


def said(arguments, **environment):
    done = subprocess.run([VPROBE, *map(str, arguments)], capture_output=True, encoding='utf-8',
                          env={**os.environ, **environment})
    return done.returncode, done.stderr


def an_index_that_does_not_fit_is_told(folder):
    path = indexed(folder)
    index = path.with_name('mesh.vtu.vpx')
    kept = folder / 'kept'
    cut = ['slice', path, *CUTS[0], '--stats', folder / 'stats.json']
    vprobe(*cut)
    wanted = figures(json.loads((folder / 'stats.json').read_text()))
    shutil.copy2(index, kept)

    def later():
        os.utime(path, ns=(1, path.stat().st_mtime_ns + 1))

    def another():
        shutil.copy2(path, folder / 'copy.vtu')
        os.replace(folder / 'copy.vtu', path)

    def longer():
        with open(path, 'ab') as file:
            file.write(b'\n')

    def shorter():
        index.write_bytes(kept.read_bytes()[:5000])

    def empty():
        index.write_bytes(b'')

    def no_index():
        vprobe('pack', path, '-o', folder / 'mesh.vtkhdf')
        shutil.copy(folder / 'mesh.vtkhdf', index)

    for damage, words in tried(((later, 'before its file was changed'), (another, 'before its file was changed'),
                                (longer, 'before its file was changed'), (shorter, 'HDF5 cannot open it'),
                                (empty, 'the file is empty'), (no_index, 'it is no index'))):
        shutil.copy2(kept, index)
        damage()
        code, lines = said(cut)
        assert code == 0 and words in lines and lines.count('\n') == 1, (damage, code, lines)
        assert f'run vprobe index {path} again' in lines, lines
        got = json.loads((folder / 'stats.json').read_text())
        assert got['parts'] is None and same(figures(got), wanted), damage
        vprobe('index', path, '--part', '64')  # of the file as it is now
        shutil.copy2(index, kept)
        assert said(cut) == (0, '') and json.loads((folder / 'stats.json').read_text())['parts'], damage
    warning = 'VPROBE_INDEX must be on or off, not no; indices are used'
    for word, warned, has_parts in (('on', '', True), ('off', '', False), ('no', warning, True)):
        code, lines = said(cut, VPROBE_INDEX=word)
        assert code == 0 and warned in lines and lines.count('\n') == bool(warned), (word, lines)
        assert bool(json.loads((folder / 'stats.json').read_text())['parts']) == has_parts, word
    code, lines = said(['slice', index, *CUTS[0], '--stats', '-'])
    assert code == 2 and 'the index of a file; open that file' in lines and lines.count('\n') == 1, lines


def damaged_indices_are_refused(folder):
    """What lies in it leads out of no memory, and out of no file."""
    h5py = need('h5py')
    path = indexed(folder)
    index = path.with_name('mesh.vtu.vpx')
    kept = index.read_bytes()

    def change(name, at, value):
        def damage(file):
            file[name][at] = value
        return damage

    def attribute(name, key, value):
        def damage(file):
            file[name].attrs[key] = value
        return damage

    far = 2 ** 62
    for name, damage in tried((('cell', change('vprobe/CellNumbers', 5, 2 ** 31)),
                               ('point', change('vprobe/PointNumbers', 3, 2 ** 31)),
                               ('place', change('vprobe/CellData/g/Places', 0, far)),
                               ('place of points', change('vprobe/PointData/f/Places', 0, path.stat().st_size - 9)),
                               ('components', attribute('vprobe/PointData/f', 'NumberOfComponents', 60000)),
                               ('type', attribute('vprobe/PointData/f', 'Type', 'float8')))):
        index.write_bytes(kept)
        with h5py.File(index, 'r+') as file:
            damage(file)
        code, lines = said(['slice', path, '--probe', 'stack', '--sheets', '20', '--stats', folder / 'stats.json'])
        # Before anything was cut the file is read as it is; later it is an error.
        assert lines.count('\n') == 1 and 'mesh.vtu.vpx' in lines, (name, lines)
        assert code == (2 if name in ('cell', 'point') else 0), (name, code, lines)
        assert code == 2 or json.loads((folder / 'stats.json').read_text())['parts'] is None, name


def indexing_refuses(folder):
    meshio, numpy = need('meshio'), need('numpy')
    path = folder / 'packed.vtu'
    meshio.write(path, mixed_mesh(meshio, numpy))
    vprobe('convert', 'demo:blob:6', '-o', folder / 'image.vti')
    plain(mixed_mesh(meshio, numpy), folder / 'plain.vtu')
    for arguments, words in (([folder / 'image.vti'], 'is no unstructured grid'),
                             (['demo:tets'], 'a built-in data set has no file to index'),
                             ([folder / 'plain.vtu', path], 'an index is of one file'),
                             ([folder / 'plain.vtu', '--displace', '2'], 'an index is of the file as it is'),
                             ([folder / 'plain.vtu', '--time', 'first'], 'an index is of the file as it is'),
                             ([folder / 'plain.vtu', '--part', '3'], '--part'), ([folder / 'none.vtu'], 'no such file')):
        code, lines = said(['index', *arguments])
        assert code in (1, 2) and words in lines and lines.count('\n') == 1, (arguments, code, lines)
        assert not list(folder.glob('*.vpx'))


def an_index_may_lie_in_the_cache(folder):
    """Known by the path of its file, and behind one beside it."""
    path, other = folder / 'mesh.vtu', folder / 'other' / 'mesh.vtu'
    other.parent.mkdir()
    plain(mixed_mesh(need('meshio'), need('numpy')), path)
    shutil.copy(path, other)
    cache, stats = {'XDG_CACHE_HOME': str(folder / 'cache')}, folder / 'stats.json'

    def parts(file, **environment):
        assert said(['slice', file, *CUTS[0], '--stats', stats], **environment) == (0, '')
        return json.loads(stats.read_text())['parts']

    assert said(['index', path, '--in-cache', '--part', '64'], **cache) == (0, '')
    made = list((folder / 'cache' / 'volume-probes').iterdir())
    assert len(made) == 1 and made[0].name.startswith('mesh.vtu-') and not (folder / 'mesh.vtu.vpx').exists(), made
    assert parts(path, **cache) is not None and parts(path) is None and parts(other, **cache) is None
    (folder / 'link').symlink_to(folder)
    assert parts(folder / 'link' / 'mesh.vtu', **cache) == parts(path, **cache)
    vprobe('index', path, '--part', '4096')
    assert parts(path, **cache)['all'] == parts(path)['all'] and (folder / 'mesh.vtu.vpx').exists()
    if os.geteuid() == 0:  # who may write everywhere
        return
    os.chmod(other.parent, 0o555)
    assert said(['index', other], **cache) == (0, '')
    os.chmod(other.parent, 0o755)
    assert parts(other, **cache) is not None and not (other.parent / 'mesh.vtu.vpx').exists()


def a_bad_order_is_told(folder):
    """A plane through rows of cells needs some pages of a file, and all if the cells are in no order."""
    meshio, numpy = need('meshio'), need('numpy')
    vprobe('convert', 'demo:tets:44', '-o', folder / 'packed.vtu')
    mesh = meshio.read(folder / 'packed.vtu')
    path = folder / 'plain.vtu'
    plain(mesh, path)
    assert said(['index', path]) == (0, '')
    plain(mesh, path, shuffles=True)
    code, lines = said(['index', path])
    assert code == 0 and 'that a plane needs 100 % of their pages; vprobe pack brings' in lines, lines
    parts = both(path, ['--normal', '0.3', '0.5', '0.81'], folder)
    assert parts['met'] < parts['all'] / 3, parts


CASES = [indexed_files_are_cut_as_without, indexed_files_are_whole_where_that_is_asked, pages_are_read,
         an_index_that_does_not_fit_is_told, damaged_indices_are_refused, indexing_refuses, an_index_may_lie_in_the_cache,
         a_bad_order_is_told]
