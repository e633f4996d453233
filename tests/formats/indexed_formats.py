"""Indices of files of other formats: values that lie there as plain numbers stay there, and others are in the index."""
import json

from against import info, mixed_mesh, need, tetrahedra, tried, vprobe
from indices import both, figures, said, told
from packed_times import TIMES, mesh_at
from packs import CUTS, OWN, polygons, same

ALL = {'PointData/f', 'PointData/v', 'CellData/g'}


def vtkhdf(path, meshes, parts=1, **how):
    """A file as VTKHDF 2.0 says, with a mesh for each of TIMES, or with one. how: of h5py's data sets."""
    h5py, numpy = need('h5py'), need('numpy')
    types = {'hexahedron': 12, 'tetra': 10}
    mesh = meshes[0]
    sizes = numpy.concatenate([numpy.full(len(block.data), block.data.shape[1]) for block in mesh.cells])
    ids = [row for block in mesh.cells for row in block.data]
    bounds = numpy.linspace(0, len(sizes), parts + 1).astype('i8')
    with h5py.File(path, 'w') as file:
        root = file.create_group('VTKHDF')
        root.attrs['Version'] = numpy.array([2, 0] if len(meshes) > 1 else [1, 0], 'i8')
        root.attrs['Type'] = numpy.bytes_('UnstructuredGrid')
        count = len(mesh.points)  # each part has all points
        root['NumberOfPoints'] = [count] * parts
        root['NumberOfCells'] = numpy.diff(bounds)
        root['NumberOfConnectivityIds'] = [int(sizes[a:b].sum()) for a, b in zip(bounds, bounds[1:])]
        root['Points'] = numpy.concatenate([mesh.points] * parts)
        root['Types'] = numpy.concatenate([numpy.full(len(b.data), types[b.type], 'u1') for b in mesh.cells])
        root['Connectivity'] = numpy.concatenate(ids).astype('i8')
        root['Offsets'] = numpy.concatenate([[0, *numpy.cumsum(sizes[a:b])] for a, b in zip(bounds, bounds[1:])])
        points, cells = root.create_group('PointData'), root.create_group('CellData')
        for name in mesh.point_data:
            points.create_dataset(name, data=numpy.concatenate([m.point_data[name] for m in meshes
                                                                for _ in range(parts)]), **how)
        for name in mesh.cell_data:
            cells.create_dataset(name, data=numpy.concatenate([v for m in meshes for v in m.cell_data[name]]), **how)
        if len(meshes) == 1:
            return path
        steps = root.create_group('Steps')
        steps.attrs['NSteps'], steps['Values'] = len(meshes), TIMES
        steps['NumberOfParts'] = [parts] * len(meshes)
        for name in ('PartOffsets', 'PointOffsets', 'CellOffsets', 'ConnectivityIdOffsets'):
            steps[name] = numpy.zeros(len(meshes), 'i8')
        for group, names, rows in (('PointDataOffsets', mesh.point_data, count * parts),
                                   ('CellDataOffsets', mesh.cell_data, len(sizes))):
            for name in names:
                steps[f'{group}/{name}'] = numpy.arange(len(meshes)) * rows
    return path


def in_place(path):
    """Arrays whose values stay in the file, and the others."""
    with need('h5py').File(f'{path}.vpx') as file:
        names = {f'{group}/{name}': 'Places' in file['vprobe'][group][name]
                 for group in ('PointData', 'CellData') for name in file['vprobe'].get(group, ())}
        copied = {name for name, is_there in names.items() if not is_there}
        assert copied == {name for name in names if name in file['VTKHDF']}, names
        return set(names) - copied, copied


def written(folder, mesh, path):
    """By VTK's writer of its legacy format, or by meshio."""
    meshio = need('meshio')
    if path.suffix != '.vtk':
        meshio.write(path, mesh)
        return
    import vtk
    meshio.write(folder / 'of.vtu', mesh)
    reader, writer = vtk.vtkXMLUnstructuredGridReader(), vtk.vtkUnstructuredGridWriter()
    reader.SetFileName(str(folder / 'of.vtu'))
    reader.Update()
    writer.SetFileName(str(path))
    writer.SetFileVersion(51 if path.stem.endswith('51') else 42)
    writer.SetFileTypeToASCII() if path.stem.startswith('text') else writer.SetFileTypeToBinary()
    writer.SetInputData(reader.GetOutput())
    assert writer.Write()


def other_formats_are_cut_by_their_indices(folder):
    meshio, numpy = need('meshio'), need('numpy')
    mesh, alike = mixed_mesh(meshio, numpy), tetrahedra(meshio, numpy)
    files = []
    for name, kept in (('packed.vtu', set()), ('bytes51.vtk', ALL), ('bytes42.vtk', ALL - {'PointData/v'}), ('text.vtk', set()),
                       ('mesh.avs', set()), ('mesh.msh', set()),
                       ('alike.e', set())):
        written(folder, alike if name in ('bytes42.vtk', 'alike.e') else mesh, folder / name)
        files.append((folder / name, kept))
    files.append((vtkhdf(folder / 'plain.vtkhdf', [mesh]), ALL))
    files.append((vtkhdf(folder / 'parts.vtkhdf', [mesh], parts=3), ALL))
    files.append((vtkhdf(folder / 'chunks.vtkhdf', [mesh], chunks=True, compression='gzip'), set()))
    for path, kept in tried(files, 2):
        code, lines = said(['index', path, '--part', '64'])
        assert code == 0 and lines.count('\n') == (0 if kept and kept >= {'CellData/g'} else 1), (path, lines)
        found, copied = in_place(path)
        assert kept is None or found == kept, (path, found)
        assert all(name.split('/')[1] in lines for name in copied), (copied, lines)
        for options in [*CUTS[:5], ['--array', 'f', '--iso', '31.5'],
                        *([['--array', 'g']] if path.suffix != '.e' else []),  # meshio writes none of cells
                        ['--normal', '1', '2', '3', '--threshold', '20', '60']]:
            parts = both(path, options, folder)
            assert parts and ('90' in options or parts['met'] > 0), (path, options, parts)
        if path.suffix != '.e':
            wanted = polygons(path, [*CUTS[0], '--no-index'], folder / 'b.vtp')
            assert polygons(path, CUTS[0], folder / 'a.vtp') == wanted, path
        with_index, without = (json.loads(vprobe('info', path, '--json', *more)) for more in ([], ['--no-index']))
        for key in ('bounds', 'times', 'points', 'cells'):
            assert with_index.get(key) == without.get(key), (path, key)
        ranges = [[(each['name'], each['range']) for each in about['arrays']] for about in (with_index, without)]
        assert ranges[0] == ranges[1], (path, ranges)


def times_stay_in_their_file(folder):
    """Values of all times, in the file or in its index; times in the file need not be in order."""
    for name, how in tried((('plain', {}), ('chunks', {'chunks': True}))):
        path = vtkhdf(folder / f'{name}.vtkhdf', [mesh_at(time) for time in TIMES], **how)
        code, lines = said(['index', path, '--part', '64'])
        assert code == 0 and lines.count('\n') == len(how), lines
        assert bool(in_place(path)[0]) == (name == 'plain')
        for time in TIMES:
            for array in ('f', 'g', 'material'):
                assert both(path, [*CUTS[0], '--time', str(time), '--array', array], folder)
        sweep = ['sweep', path, '--path', 'times', *CUTS[0], '--array', 'f', '--stats', folder / 's.json']
        frames = []
        for more in [], ['--no-index']:
            vprobe(*sweep, *more)
            told_frames = json.loads((folder / 's.json').read_text())['frames']
            frames.append([[{k: v for k, v in sheet.items() if k not in OWN} for sheet in frame['sheets']]
                           for frame in told_frames])
        assert len(frames[0]) == len(TIMES) and same(*frames), frames
    path, turned = (vtkhdf(folder / name, [mesh_at(time) for time in TIMES]) for name in ('a.vtkhdf', 'b.vtkhdf'))
    with need('h5py').File(turned, 'r+') as file:
        file['VTKHDF/Steps/Values'][...] = TIMES[::-1]
    vprobe('index', turned, '--part', '64')
    assert info(turned)['times'] == list(TIMES) and len(in_place(turned)[0]) == 4
    wanted = told(path, [*CUTS[0], '--time', '0', '--array', 'f'], folder / 's.json')
    got = told(turned, [*CUTS[0], '--time', '1.5', '--array', 'f'], folder / 's.json')
    assert got['parts'] and not wanted['parts'] and same(figures(wanted), figures(got)), (wanted, got)


def what_the_reader_said_is_said_again(folder):
    """A file with two arrays of one name."""
    meshio, numpy = need('meshio'), need('numpy')
    path = folder / 'twice.vtk'
    written(folder, mixed_mesh(meshio, numpy), path)
    assert path.read_bytes().count(b'\nv 3 ') == 1
    path.write_bytes(path.read_bytes().replace(b'\nv 3 ', b'\nf 3 '))
    lines = said(['slice', path, *CUTS[0], '--stats', folder / 's.json'])[1]
    assert 'two point arrays are called f' in lines, lines
    assert said(['index', path, '--part', '64'])[0] == 0
    assert said(['slice', path, *CUTS[0], '--stats', folder / 's.json']) == (0, lines)
    assert both(path, [*CUTS[0], '--array', 'f'], folder) and both(path, [*CUTS[0], '--array', 'f 2'], folder)


def files_that_name_others_get_no_index(folder):
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mixed_mesh(meshio, numpy)
    for piece in ('a', 'b'):
        meshio.write(folder / f'{piece}.vtu', mesh)
    (folder / 'all.vtm').write_text('<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
                                    '<DataSet index="0" file="a.vtu"/></vtkMultiBlockDataSet></VTKFile>')
    vprobe('pack', folder / 'a.vtu', '-o', folder / 'pack.vtkhdf')
    meshio.write(folder / 'blocks.e', mesh)
    for name, words in (('all.vtm', 'names a.vtu, and an index is of one file that names no others'),
                        ('pack.vtkhdf', 'is a pack, and needs no index: use it as it is'),
                        ('blocks.e', 'has several blocks')):
        code, lines = said(['index', folder / name])
        assert code == 2 and words in lines and lines.count('\n') == 1, (name, code, lines)
        assert not (folder / f'{name}.vpx').exists()


CASES = [other_formats_are_cut_by_their_indices, times_stay_in_their_file, what_the_reader_said_is_said_again,
         files_that_name_others_get_no_index]
