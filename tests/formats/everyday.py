"""What users have every day: MED of Salome-Meca, folders of slices, meshes with repeated nodes, displacements.

Every answer is worked out by hand.
"""
import json
import struct
import subprocess
import zlib

from against import VPROBE, cut, info, near, need, tried, vprobe
from far_codes import begin_cgns
from stacks import refused

CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
BETWEEN = {'H20': (8, '01 12 23 03 45 56 67 47 04 15 26 37'),
           'H27': (8, '01 12 23 03 45 56 67 47 04 15 26 37 0123 0154 1265 2376 3047 4567 01234567'),
           'T10': (4, '01 12 02 03 13 23'), 'P13': (5, '01 12 23 03 04 14 24 34'),
           'P15': (6, '01 12 02 34 45 35 03 14 25'), 'P18': (6, '01 12 02 34 45 35 03 14 25 0143 1254 2035')}
SHAPES = {8: CORNERS, 4: [CORNERS[i] for i in (0, 1, 3, 4)], 5: [CORNERS[i] for i in (0, 1, 2, 3, 4)],
          6: [CORNERS[i] for i in (0, 1, 3, 4, 5, 7)]}
# As MED describes them: a face seen from inside where VTK sees it from outside, so every cell is mirrored.
TURNED = {8: (0, 3, 2, 1, 4, 7, 6, 5), 4: (0, 2, 1, 3), 5: (0, 3, 2, 1, 4), 6: (0, 2, 1, 3, 5, 4)}
BULGE = 0.2


def med_file(h5py, numpy, path, kind, nodes, values):
    """One cell in the frame of a file by meshio, beside a triangle, a quad and a line of second order."""
    meshio = need('meshio')
    count = len(nodes)
    meshio.write(path, meshio.Mesh(nodes, [('hexahedron', numpy.arange(8).reshape(1, 8) % count)],
                                   point_data={'RESU____DEPL': values}))
    with h5py.File(path, 'r+') as file:
        cells = next(iter(next(iter(file['ENS_MAA'].values())).values()))['MAI']
        cells.move('HE8', kind)

        def put(name, ids):
            if name not in cells:
                file.copy(cells[kind], cells, name)
            about = dict(cells[name]['NOD'].attrs)
            del cells[name]['NOD']
            cells[name]['NOD'] = numpy.asarray(ids, dtype='i4')
            cells[name]['NOD'].attrs.update(about)
        put(kind, numpy.arange(1, count + 1))
        for name, nodes_of in (('TR6', 6), ('QU8', 8), ('QU9', 9), ('SE3', 3)):
            put(name, numpy.arange(nodes_of) % count + 1)
        step = next(iter(file['CHA/RESU____DEPL'].values()))
        file.copy(step['NOE'], step, f'NOE.{kind}')  # as code_aster writes ELNO


def curved_places(numpy, kind):
    """Nodes in MED's order. Sides in x bulge by x = ... + 4 BULGE y (1 - y), which second order has exactly."""
    corners, between = BETWEEN[kind]
    order = TURNED[corners]
    shape = [numpy.array(SHAPES[corners][i], float) for i in order]
    places = shape + [numpy.mean([shape[int(c)] for c in group], axis=0) for group in between.split()]
    return numpy.array(places)


def med_salome(folder):
    """Quadratic cells as Salome-Meca writes them: the area of a plane, straight and bulging, in MED's own order."""
    h5py, numpy = need('h5py'), need('numpy')
    # The section at z = 1/4: a unit square, a triangle of half a square that shrinks or not.
    areas = {'H20': 1, 'H27': 1, 'T10': 0.5 * 0.75 ** 2, 'P13': 0.75 ** 2, 'P15': 0.5, 'P18': 0.5}
    for kind, area in areas.items():
        nodes = curved_places(numpy, kind)
        moves = numpy.zeros_like(nodes)
        moves[:, 2] = nodes[:, 2]
        path = folder / f'{kind}.med'
        med_file(h5py, numpy, path, kind, nodes, moves)
        at = ['--normal', '0', '0', '1', '--origin', '0.2', '0.2', '0.25']
        assert near(cut(path, 'RESU____DEPL', *at, '--component', 'z')['mean'], 0.25), kind
        assert near(cut(path, None, *at)['area'], area), (kind, cut(path, None, *at)['area'])
        assert info(path)['grid']['cells'] == 1
        about = subprocess.run([VPROBE, 'info', path], capture_output=True, encoding='utf-8').stderr
        assert 'values at the nodes of each cell' in about, about
        # Twice as high, so the plane at 1/2 has the area of that at 1/4.
        moved = ['--displace', '1', '--normal', '0', '0', '1', '--origin', '0.2', '0.2', '0.5']
        assert near(cut(path, None, *moved)['area'], area), kind
        assert info(path, '--displace', '1')['bounds'][5] == 2
    # Bulging sides: x = 1 + 4 h y (1 - y) at the far side adds 2/3 h to the area of the square.
    for kind in ('H20', 'H27'):
        nodes = curved_places(numpy, kind)
        nodes[:, 0] += 4 * BULGE * nodes[:, 1] * (1 - nodes[:, 1]) * nodes[:, 0]
        med_file(h5py, numpy, folder / 'bulge.med', kind, nodes, numpy.zeros_like(nodes))
        found = cut(folder / 'bulge.med', None, '--refine', '0.002', '--normal', '0', '0', '1')['area']
        assert near(found, 1 + 2 * BULGE / 3, 2e-3), (kind, found)


def png(values):
    """A gray PNG of 8 bits."""
    def chunk(name, data):
        return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))
    rows = b''.join(b'\0' + bytes(row) for row in values)
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', len(values[0]), len(values), 8, 0, 0, 0, 0))
            + chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))


def slices(folder):
    """Slice k has the values 10 k + y of its row: s2 comes before s10, and the first row has y = 0."""
    tifffile, numpy = need('tifffile'), need('numpy')
    rows = numpy.repeat(numpy.arange(3), 4).reshape(3, 4)
    at_tenth = ['--normal', '0', '0', '1', '--origin', '1.5', '1', '9']
    low = ['--normal', '0', '1', '0', '--origin', '1.5', '0.5', '5']
    for ending in ('tif', 'png'):
        place = folder / ending
        place.mkdir()
        for k in range(1, 12):
            values = (10 * k + rows).astype('u1')
            if ending == 'tif':
                tifffile.imwrite(place / f's{k}.tif', values, photometric='minisblack', metadata=None)
            else:
                (place / f's{k}.png').write_bytes(png(values.tolist()))
        for path in (place, place / f'*.{ending}'):
            about = info(path)
            assert (about['grid']['kind'], about['grid']['points']) == ('image', 4 * 3 * 11), about['grid']
            assert near(cut(path, None, *at_tenth)['mean'], 101), (path, cut(path, None, *at_tenth))
            assert near(cut(path, None, *low)['mean'], 60.5)  # in the middle of 1 to 11, at y = 1/2
        assert info(place / f's?.{ending}')['grid']['points'] == 4 * 3 * 9
        (place / 'notes.txt').write_text('not a slice')
        assert info(place)['grid']['points'] == 4 * 3 * 11
        (place / f's6.{ending}').unlink()
        told = subprocess.run([VPROBE, 'info', place], capture_output=True, encoding='utf-8').stderr
        assert f'between s5.{ending} and s7.{ending}' in told, told
        refused(place / f'x*.{ending}', 'no file has such a name')
        refused(place / f's3*.{ending}', 'two slices or more')
    both = folder / 'both'
    both.mkdir()
    (both / 'a1.png').write_bytes(png([[1, 2], [3, 4]]))
    tifffile.imwrite(both / 'a2.tif', numpy.zeros((2, 2), 'u1'), metadata=None)
    refused(both, 'holds TIFF and PNG files')
    (both / 'a2.png').write_bytes(png([[1, 2, 3], [3, 4, 5]]))
    refused(both / '*.png', 'a2.png has another size or type than a1.png')
    tifffile.imwrite(both / 'a3.tif', numpy.zeros((3, 2, 2), 'u1'), metadata=None, photometric='minisblack')
    refused(both / '*.tif', 'a3.tif has 3 pages')
    (both / 'a2.png').write_bytes(b'\x89PNG\r\n\x1a\n')
    refused(both / '*.png', 'a2.png')


def patterns(folder):
    """Other files are put together, or are times, as if the shell had listed them."""
    numpy = need('numpy')
    for k in (2, 10):
        numpy.save(folder / f'v{k}.npy', numpy.full((3, 3, 3), float(k)))
    assert info(folder / 'v*.npy')['times'] == [2, 10]
    assert info(folder / 'v*.npy', '--time', '2')['arrays'][0]['range'] == [2, 2]


MSH2 = '''$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
{count}
{nodes}
$EndNodes
$Elements
1
1 4 2 1 1 1 2 3 4
$EndElements
'''
MSH4 = '''$MeshFormat
4.1 0 8
$EndMeshFormat
$Nodes
2 {count} 1 4
2 1 0 4
1
2
3
4
0 0 0
1 0 0
0 1 0
0 0 1
3 1 0 {more}
{tags}
{places}
$EndNodes
$Elements
1 1 1 1
3 1 4 1
1 1 2 3 4
$EndElements
'''


def gmsh_repeated_nodes(folder):
    """A node that is listed twice at one place is one; at two places it is refused by its tag."""
    nodes = ['1 0 0 0', '2 1 0 0', '3 0 1 0', '4 0 0 1']
    for name, again, count in (('one', ['2 1 0 0', '4 0 0 1.0'], 4), ('two', ['2 1 0 0.5'], 0)):
        path = folder / f'{name}2.msh'
        path.write_text(MSH2.format(count=4 + len(again), nodes='\n'.join(nodes + again)))
        four = folder / f'{name}4.msh'
        four.write_text(MSH4.format(count=4 + len(again), more=len(again), tags='\n'.join(n.split()[0] for n in again),
                                    places='\n'.join(n.split(' ', 1)[1] for n in again)))
        for each in (path, four):
            if count == 0:
                refused(each, 'node 2 occurs twice, at different places')
                continue
            assert info(each)['grid']['points'] == count, each
            assert near(cut(each, None, '--normal', '0', '0', '1', '--origin', '0.1', '0.1', '0.5')['area'], 0.125)


def displaced_formats(folder):
    """The unit cube, stretched to 3 along x and sheared: areas and bounds by hand, in each format."""
    meshio, numpy = need('meshio'), need('numpy')
    points = numpy.array(CORNERS, float)
    moves = numpy.stack([2 * points[:, 0], points[:, 2], 0 * points[:, 0]], axis=1)
    other = numpy.stack([0 * points[:, 0], 0 * points[:, 0], points[:, 2]], axis=1)
    stress = numpy.ones(8)
    files = (('a.vtu', 'Displacement'), ('b.vtu', 'disp'), ('c.med', 'RESU____DEPL'), ('d.xdmf', 'DISP'),
             ('e.vtk', 'nodal_displacement'), ('f.vtu', 'U'), ('g.avs', 'displ'), ('h.msh', 'DEPL'), ('i.e', 'disp'))
    for name, array in tried(files):
        path = folder / name
        mesh = meshio.Mesh(points, [('hexahedron', [list(range(8))])],
                           point_data={'other': other, array: moves, 'stress': stress})
        meshio.write(path, mesh, file_format='gmsh' if name.endswith('msh') else None)
        at = ['--normal', '1', '0', '0']
        assert near(cut(path, None, *at)['area'], 1), name
        moved = info(path, '--displace', '1')
        assert [round(b, 5) for b in moved['bounds']] == [0, 3, 0, 2, 0, 1], (name, moved['bounds'])
        z = ['--normal', '0', '0', '1', '--displace', '0.5']
        assert near(cut(path, None, *z)['area'], 2), (name, cut(path, None, *z)['area'])
        assert info(path, '--displace', '0')['bounds'] == info(path)['bounds'] == [0, 1, 0, 1, 0, 1]
        chosen = info(path, '--displace-by', 'other')['bounds']
        assert [round(b, 5) for b in chosen] == [0, 1, 0, 1, 0, 2], (name, chosen)
        vprobe('convert', path, '-o', folder / 'moved.vtu', '--displace', '1')
        assert info(folder / 'moved.vtu')['bounds'][1] == 3
        one = json.loads(vprobe('slice', path, *z, '--array', 'stress', '--classify', 'cpu', '--stats', '-'))['sheets'][0]
        assert near(one['area'], 2) and one['mean'] == 1, one  # only the arrays that are shown are read


def displaced_in_ensight_and_cgns(folder):
    """The same in formats that meshio does not write: along x to 3, and y grows by z."""
    h5py, numpy = need('h5py'), need('numpy')
    points = numpy.array(CORNERS, float)
    moves = numpy.stack([2 * points[:, 0], points[:, 2], 0 * points[:, 0]], axis=1)

    def column(values):
        return ''.join(f'{value:12.5e}\n' for value in values)
    (folder / 'a.case').write_text('FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\nVARIABLE\n'
                                   'vector per node: velocity a.vel\nvector per node: Displ a.dis\n')
    (folder / 'a.geo').write_text('a\nb\nnode id off\nelement id off\npart\n         1\nc\ncoordinates\n         8\n'
                                  + ''.join(column(points[:, a]) for a in range(3)) + 'hexa8\n         1\n'
                                  + ''.join(f'{n:10d}' for n in range(1, 9)) + '\n')
    for name, values in (('a.vel', points), ('a.dis', moves)):
        (folder / name).write_text('a\npart\n         1\ncoordinates\n' + ''.join(column(values[:, a]) for a in range(3)))
    with h5py.File(folder / 'b.cgns', 'w', track_order=True) as file:
        node = begin_cgns(numpy, file)
        base = node(file, 'Base', 'CGNSBase_t', 'I4', numpy.array([3, 3], dtype='i4'))
        zone = node(base, 'Zone', 'Zone_t', 'I4', numpy.array([[8], [1], [0]], dtype='i4'))
        node(zone, 'ZoneType', 'ZoneType_t', 'C1', 'Unstructured')
        places = node(zone, 'GridCoordinates', 'GridCoordinates_t')
        solution = node(zone, 'Solution', 'FlowSolution_t')
        node(solution, 'GridLocation', 'GridLocation_t', 'C1', 'Vertex')
        for i in range(3):
            node(places, 'Coordinate' + 'XYZ'[i], 'DataArray_t', 'R8', points[:, i].copy())
            node(solution, 'Displacement' + 'XYZ'[i], 'DataArray_t', 'R8', moves[:, i].copy())
        part = node(zone, 'Cells', 'Elements_t', 'I4', numpy.array([17, 0], dtype='i4'))
        node(part, 'ElementRange', 'IndexRange_t', 'I4', numpy.array([1, 1], dtype='i4'))
        node(part, 'ElementConnectivity', 'DataArray_t', 'I4', numpy.arange(1, 9, dtype='i4'))
    for name in ('a.case', 'b.cgns'):
        moved = info(folder / name, '--displace', '1')['bounds']
        assert [round(b, 5) for b in moved] == [0, 3, 0, 2, 0, 1], (name, moved)
        z = ['--normal', '0', '0', '1', '--displace', '0.5']
        assert near(cut(folder / name, None, *z)['area'], 2), name


def displaced_lattices(folder):
    """An image becomes curvilinear: z grows by x z / 2, so the plane x = 1/2 is a quarter higher."""
    vtk = need('vtkmodules.vtkCommonDataModel')
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
    numpy = need('numpy')
    image = vtk.vtkImageData()
    image.SetDimensions(3, 3, 3)
    image.SetSpacing(0.5, 0.5, 0.5)
    places = numpy.array([image.GetPoint(p) for p in range(27)])
    moves = numpy.zeros((27, 3))
    moves[:, 2] = places[:, 0] * places[:, 2] / 2
    for values, name in ((moves, 'displacement'), (places, 'velocity')):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        image.GetPointData().AddArray(array)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(folder / 'image.vti'))
    writer.Write()
    about = info(folder / 'image.vti', '--displace', '1')
    assert about['grid']['kind'] == 'curvilinear' and about['bounds'][5] == 1.5, about
    assert near(cut(folder / 'image.vti', None, '--displace', '1', '--normal', '1', '0', '0', '--origin', '.5', '.5', '.5')
                ['area'], 1.25)


def displacements_that_are_not_there(folder):
    """The line names the vectors there are."""
    meshio, numpy = need('meshio'), need('numpy')
    mesh = meshio.Mesh(numpy.array(CORNERS, float), [('hexahedron', [list(range(8))])],
                       point_data={'U': numpy.ones((8, 3)), 'p': numpy.ones(8), 'grad': numpy.ones((8, 3))})
    meshio.write(folder / 'fluid.vtu', mesh)

    def told(*options):
        done = subprocess.run([VPROBE, 'info', folder / 'fluid.vtu', *options], capture_output=True, encoding='utf-8')
        assert done.returncode == 2 and done.stderr.count('\n') == 1, done
        return done.stderr
    assert '--displace-by: U, grad' in told('--displace', '2'), told('--displace', '2')
    assert '--displace-by none: there is no such vector' in told('--displace-by', 'none')
    assert 'U, grad' in told('--displace-by', 'p', '--displace', '1')
    assert info(folder / 'fluid.vtu', '--displace-by', 'U')['bounds'] == [1, 2, 1, 2, 1, 2]
    done = subprocess.run([VPROBE, 'info', 'demo:shell:4', '--displace', '1'], capture_output=True, encoding='utf-8')
    assert done.returncode == 1 and 'is built in' in done.stderr, done
    mesh.point_data = {'p': numpy.ones(8)}
    meshio.write(folder / 'fluid.vtu', mesh)
    assert 'three components' in told('--displace', '1')


def converted_demos(folder):
    """Each built-in data set is written, also without -o, and is what it was."""
    for name in ('shell', 'hexes', 'tets', 'blob', 'graded', 'mixed', 'layer'):
        demo, out = f'demo:{name}:4', folder / f'{name}.vtu'
        vprobe('convert', demo, out)
        theirs, ours = info(demo), info(out)
        for key in ('cells', 'points'):
            assert theirs['grid'][key] == ours['grid'][key], (name, key)
        assert [a['name'] for a in ours['arrays']] == ['s', 'v']
        for a, b in zip(theirs['bounds'], ours['bounds']):
            assert abs(a - b) < 1e-6
        for figure in ('area', 'mean', 'min', 'max'):
            a, b = cut(demo, 's')[figure], cut(out, 's')[figure]
            assert near(a, b, 1e-6) or abs(a - b) < 1e-12, (name, figure, a, b)
    vprobe('convert', 'demo:shell:4', '-o', folder / 'shell.vts')
    vprobe('convert', 'demo:blob:4', '-o', folder / 'blob.vti')
    for arguments, words in ((('demo:none', folder / 'n.vtu'), 'there are shell, hexes'),
                             (('demo:shell:4', folder / 'shell.vtu'), 'is there already'),
                             (('demo:shell:4',), '-o: name the file'),
                             (('demo:blob:4', folder / 'blob.vts'), 'is written as .vti, .vtu or .vtm'),
                             (('demo:shell:4', folder / 'n.vtu', '--displace', '1'), 'no vector at its points'),
                             (('demo:shell:0', folder / 'n.vtu'), 'N must be 1')):
        done = subprocess.run([VPROBE, 'convert', *arguments], capture_output=True, encoding='utf-8')
        assert done.returncode in (1, 2) and words in done.stderr and done.stderr.count('\n') == 1, done
    assert not (folder / 'n.vtu').exists()


CASES = [med_salome, slices, patterns, gmsh_repeated_nodes, displaced_formats, displaced_in_ensight_and_cgns,
         displaced_lattices, displacements_that_are_not_there, converted_demos]
