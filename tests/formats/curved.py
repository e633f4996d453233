"""Straight unit cubes of curved cells, written by the libraries of their fields: a cut has exactly the area 1."""
import itertools
import json
import os
import random
import subprocess

from against import VPROBE, Missing, cut, need, tried, vprobe
from exodus import corners_of
from far_codes import begin_cgns
from odd import refused

# Corners, Gmsh's type, and meshio's name of the quadratic cells.
GMSH_TYPES = [(4, 4), (8, 5), (6, 6), (5, 7), (4, 11), (8, 12), (6, 13), (5, 14), (8, 17), (6, 18), (5, 19)]
MESHIO_NAMES = {'QuadraticTetra': 'tetra10', 'QuadraticHexahedron': 'hexahedron20', 'QuadraticWedge': 'wedge15',
                'TriQuadraticHexahedron': 'hexahedron27', 'BiQuadraticQuadraticWedge': 'wedge18',
                'BiQuadraticQuadraticHexahedron': 'hexahedron24', 'QuadraticPyramid': 'pyramid13'}
LINEAR = {4: 'Tetra', 5: 'Pyramid', 6: 'Wedge', 8: 'Hexahedron'}


def check_cubes(path, count, *options):
    """So many cubes in a row along x."""
    stats = path.parent / 'stats.json'
    vprobe('slice', path, '--probe', 'trihedral', '--origin', .4, .4, .4, '--classify', 'cpu', '--stats', stats,
           *options)
    for axis, sheet in enumerate(json.loads(stats.read_text())['sheets']):
        wanted = count if axis else 1
        assert abs(sheet['area'] - wanted) < 1e-12 * count, (path.name, options, axis, sheet['area'])


def check_both(path, count=1):
    check_cubes(path, count)
    check_cubes(path, count, '--refine', 0.01)


def reference_places(numpy, gmsh, kind):
    """Places of the nodes by the weights of the linear cell's corners, which Gmsh's own reference elements give."""
    name, _, _, count, places, corners = gmsh.model.mesh.getElementProperties(kind)
    places = numpy.array(places).reshape(count, 3)
    u, v, w = places.T
    if name.startswith('Hexa'):
        weights = [(1 + a * u) * (1 + b * v) * (1 + c * w) / 8 for a, b, c in places[:8]]
    elif name.startswith('Prism'):
        weights = [f * (1 + c * w) / 2 for c in (-1, 1) for f in (1 - u - v, u, v)]
    elif name.startswith('Tetra'):
        weights = [1 - u - v - w, u, v, w]
    else:  # a straight pyramid is its own reference: corners of the base at (+-1, +-1, 0), the tip at (0, 0, 1)
        scale = numpy.where(w < 1, 1 - w, 1)
        weights = [numpy.where(w < 1, (scale + a * u) * (scale + b * v) / (4 * scale), 0)
                   for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))] + [w]
    weights = numpy.stack(weights, axis=1)
    assert numpy.allclose(weights[:corners], numpy.eye(corners)) and numpy.allclose(weights.sum(axis=1), 1), name
    return name, weights


def gathered(numpy, cells):
    """Points, each once, and the cells' numbers of them."""
    points, index = numpy.unique(numpy.concatenate(cells).round(12), axis=0, return_inverse=True)
    return points, index.reshape(len(cells), -1)


def gmsh_cubes(folder):
    gmsh, numpy = need('gmsh'), need('numpy')
    gmsh.initialize(['gmsh', '-nopopup', '-v', '0'])
    try:
        for corners, kind in tried(GMSH_TYPES):
            gmsh.model.add(f'cube {kind}')
            name, weights = reference_places(numpy, gmsh, kind)
            points, cells = gathered(numpy, [weights @ numpy.array(cell) for cell in corners_of(numpy, corners)])
            gmsh.model.addDiscreteEntity(3, 1)
            gmsh.model.mesh.addNodes(3, 1, range(1, len(points) + 1), points.ravel())
            gmsh.model.mesh.addElementsByType(1, kind, range(1, len(cells) + 1), (cells + 1).ravel())
            for version, binary in ((1, 0), (2.2, 0), (2.2, 1), (4.0, 0), (4.1, 0), (4.1, 1)):
                gmsh.option.setNumber('Mesh.MshFileVersion', version)
                gmsh.option.setNumber('Mesh.Binary', binary)
                gmsh.option.setNumber('Mesh.SaveAll', 1)
                path = folder / f'{name.replace(" ", "_")}_{version}_{binary}.msh'
                gmsh.write(str(path))
                check_cubes(path, 1)
                if version == 2.2:
                    check_cubes(path, 1, '--refine', 0.01)
    finally:
        gmsh.finalize()


def meshed_cube(folder):
    """A cube by Gmsh's mesh generators, above second order too."""
    gmsh = need('gmsh')
    gmsh.initialize(['gmsh', '-nopopup', '-v', '0'])
    try:
        for order, recombined in itertools.product((1, 2, 3), (False, True)):
            gmsh.model.add(f'{order} {recombined}')
            gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
            gmsh.model.occ.synchronize()
            if recombined:
                gmsh.model.mesh.setTransfiniteAutomatic()
            gmsh.option.setNumber('Mesh.MeshSizeMax', 0.5)
            gmsh.option.setNumber('Mesh.SaveAll', 0)
            gmsh.model.mesh.generate(3)
            gmsh.model.mesh.setOrder(order)
            path = folder / f'{order}{recombined}.msh'
            gmsh.write(str(path))
            if order < 3:
                check_both(path)
            else:
                refused(path, 'hexahedra of order 3' if recombined else 'tetrahedra of order 3')
    finally:
        gmsh.finalize()


def vtk_cell(numpy, data, name):
    """The cell of a VTK class: its type, and the weights of its linear cell's corners at its nodes."""
    cell = getattr(data, 'vtk' + name)()
    count = cell.GetNumberOfPoints()
    places = numpy.array(cell.GetParametricCoords()[:3 * count]).reshape(count, 3)
    corners = next(number for number, word in LINEAR.items() if name.endswith(word))
    linear = getattr(data, 'vtk' + LINEAR[corners])()
    weights = []
    for place in places:
        own = [0.0] * corners
        linear.InterpolateFunctions(place, own)
        weights.append(own)
    return cell.GetCellType(), corners, numpy.array(weights)


def write_grid(data, xml, numpy, path, kind, cells, degree=None):
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.util.numpy_support import numpy_to_vtk
    points, lists = gathered(numpy, cells)
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    grid = data.vtkUnstructuredGrid()
    grid.SetPoints(places)
    for corners in lists:
        grid.InsertNextCell(kind, len(corners), [int(corner) for corner in corners])
    if degree:
        degrees = numpy_to_vtk(numpy.full((len(lists), 3), float(degree)), deep=True)
        degrees.SetName('HigherOrderDegrees')
        grid.GetCellData().SetHigherOrderDegrees(degrees)
    writer = xml.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.SetDataModeToAscii()
    writer.Write()
    return points, lists


def vtk_modules():
    try:
        from vtkmodules import vtkCommonDataModel, vtkIOXML
    except ImportError as error:
        raise Missing('vtkmodules') from error
    return vtkCommonDataModel, vtkIOXML, need('numpy')


def quadratic_cubes(folder):
    """VTK's own cells in .vtu, and the same in XDMF, by meshio too."""
    data, xml, numpy = vtk_modules()
    for name in [*MESHIO_NAMES, 'QuadraticLinearWedge']:
        kind, corners, weights = vtk_cell(numpy, data, name)
        cells = [weights @ numpy.array(cell) for cell in corners_of(numpy, corners)]
        points, lists = write_grid(data, xml, numpy, folder / f'{name}.vtu', kind, cells)
        check_both(folder / f'{name}.vtu')
        if name not in MESHIO_NAMES:
            continue
        write_xdmf(folder / f'{name}.xmf', name, points, lists)
        check_both(folder / f'{name}.xmf')
        try:
            mesh = need('meshio').Mesh(points, [(MESHIO_NAMES[name], lists)])
        except KeyError:
            continue  # some versions do not know all cells
        mesh.write(folder / f'{name}.xdmf', data_format='XML')
        check_both(folder / f'{name}.xdmf')


def write_xdmf(path, name, points, lists):
    """After the XDMF model and format, by the number of a cell's nodes."""
    kind = next(word for word in LINEAR.values() if name.endswith(word)).replace('Tetra', 'Tetrahedron')
    path.write_text(f"""<?xml version="1.0" ?>
<Xdmf Version="3.0"><Domain><Grid Name="cube">
<Topology TopologyType="{kind}_{len(lists[0])}" NumberOfElements="{len(lists)}">
<DataItem Dimensions="{lists.shape[0]} {lists.shape[1]}" NumberType="Int" Format="XML">
{' '.join(map(str, lists.ravel()))}</DataItem></Topology>
<Geometry GeometryType="XYZ"><DataItem Dimensions="{len(points)} 3" NumberType="Float" Precision="8" Format="XML">
{' '.join(map(repr, points.ravel().tolist()))}</DataItem></Geometry></Grid></Domain></Xdmf>
""")


def med_cubes(folder):
    """MED's curved kinds in the frame of a file by meshio: in the order of MED, in that of VTK, and mirrored."""
    data, xml, numpy = vtk_modules()
    meshio, h5py = need('meshio'), need('h5py')
    of_med = [*range(20), 24, 22, 21, 23, 20, 25, 26]
    kinds = (('T10', 'QuadraticTetra', None), ('P13', 'QuadraticPyramid', None), ('P15', 'QuadraticWedge', None),
             ('P18', 'BiQuadraticQuadraticWedge', None), ('H20', 'QuadraticHexahedron', None),
             ('H27', 'TriQuadraticHexahedron', None), ('H27', 'TriQuadraticHexahedron', of_med))
    for kind, name, order in tried(kinds):
        cell, corners, weights = vtk_cell(numpy, data, name)
        for mirrored in (False, True):
            cells = [weights @ numpy.array(cell) for cell in corners_of(numpy, corners)]
            if mirrored:
                cells = [[1, 0, 0] + [-1, 1, 1] * places for places in cells]
            points, lists = write_grid(data, xml, numpy, folder / 'h.vtu', cell, cells)
            path = folder / f'{kind}{mirrored}{order is None}.med'
            meshio.write(path, meshio.Mesh(points, [('hexahedron', lists[:, :1].repeat(8, axis=1))]))
            with h5py.File(path, 'r+') as file:
                cells_of = next(iter(next(iter(file['ENS_MAA'].values())).values()))['MAI']
                cells_of.move('HE8', kind)
                about = dict(cells_of[kind]['NOD'].attrs)
                del cells_of[kind]['NOD']
                cells_of[kind]['NOD'] = ((lists if order is None else lists[:, order]).T + 1).ravel()
                cells_of[kind]['NOD'].attrs.update(about)
            check_both(path)


# After "CGNS Standard Interface Data Structures", 3.3: the number of a type, its corners, and between which ones its
# other nodes lie, from 1.
CGNS_WEDGE = '12 23 31 14 25 36 45 56 64'
CGNS_HEXAHEDRON = '12 23 34 41 15 26 37 48 56 67 78 85'
CGNS_TYPES = {'TETRA_4': (10, 4, ''), 'TETRA_10': (11, 4, '12 23 31 14 24 34'), 'PYRA_5': (12, 5, ''),
              'PYRA_13': (21, 5, '12 23 34 41 15 25 35 45'), 'PYRA_14': (13, 5, '12 23 34 41 15 25 35 45 1234'),
              'PENTA_6': (14, 6, ''), 'PENTA_15': (15, 6, CGNS_WEDGE),
              'PENTA_18': (16, 6, CGNS_WEDGE + ' 1254 2365 3146'),
              'HEXA_8': (17, 8, ''), 'HEXA_20': (18, 8, CGNS_HEXAHEDRON),
              'HEXA_27': (19, 8, CGNS_HEXAHEDRON + ' 1234 1265 2376 3487 1485 5678 12345678')}


def write_cgns_cubes(numpy, file, types, mixed):
    """A zone for the cube of each type, one beside the other; as a section of one type, or as a mixed one."""
    node = begin_cgns(numpy, file)
    base = node(file, 'Base', 'CGNSBase_t', 'I4', numpy.array([3, 3], dtype='i4'))
    for number, name in enumerate(types):
        kind, corners, between = CGNS_TYPES[name]
        cells = []
        for cell in corners_of(numpy, corners):
            cells.append(numpy.array(list(cell) + [numpy.mean([cell[int(i) - 1] for i in word], axis=0)
                                                   for word in between.split()]) + [number, 0, 0])
        points, lists = gathered(numpy, cells)
        zone = node(base, name, 'Zone_t', 'I4', numpy.array([[len(points)], [len(lists)], [0]], dtype='i4'))
        node(zone, 'ZoneType', 'ZoneType_t', 'C1', 'Unstructured')
        places = node(zone, 'GridCoordinates', 'GridCoordinates_t')
        for axis in range(3):
            node(places, 'Coordinate' + 'XYZ'[axis], 'DataArray_t', 'R8', points[:, axis].copy())
        part = node(zone, 'Cells', 'Elements_t', 'I4', numpy.array([20 if mixed else kind, 0], dtype='i4'))
        node(part, 'ElementRange', 'IndexRange_t', 'I4', numpy.array([1, len(lists)], dtype='i4'))
        listed = lists + 1
        if mixed:
            listed = numpy.insert(listed, 0, kind, axis=1)
            node(part, 'ElementStartOffset', 'DataArray_t', 'I4',
                 (numpy.arange(len(lists) + 1) * listed.shape[1]).astype('i4'))
        node(part, 'ElementConnectivity', 'DataArray_t', 'I4', listed.ravel().astype('i4'))


def cgns_cubes(folder):
    """By the tables of the SIDS."""
    h5py, numpy = need('h5py'), need('numpy')
    fine = [name for name in CGNS_TYPES if name != 'PYRA_13']
    for mixed in (False, True):
        for name, types in (('fine', fine), ('odd', ['PYRA_13'])):
            path = folder / f'{name}{mixed}.cgns'
            with h5py.File(path, 'w', track_order=True) as file:
                write_cgns_cubes(numpy, file, types, mixed)
            if types is fine:
                check_both(path, len(fine))
            else:
                refused(path, 'PYRA_13')


def lattice_of(data, kind, n):
    """Each node's place in a cell of degree n, as weights of the linear cell's corners."""
    nodes = {}
    if kind == 8:
        for i, j, k in itertools.product(range(n + 1), repeat=3):
            u, v, w = i / n, j / n, k / n
            nodes[data.vtkHigherOrderHexahedron.PointIndexFromIJK(i, j, k, [n, n, n])] = [
                a * b * c for c in (1 - w, w) for a, b in ((1 - u, 1 - v), (u, 1 - v), (u, v), (1 - u, v))]
    elif kind == 6:
        for i, j, k in itertools.product(range(n + 1), repeat=3):
            if i + j <= n:
                u, v, w = i / n, j / n, k / n
                nodes[data.vtkHigherOrderWedge.PointIndexFromIJK(i, j, k, [n, n, n, 0])] = [
                    a * c for c in (1 - w, w) for a in (1 - u - v, u, v)]
    else:
        for index in range((n + 1) * (n + 2) * (n + 3) // 6):
            steps = [0, 0, 0, 0]
            data.vtkHigherOrderTetra.BarycentricIndex(index, steps, n)
            nodes[index] = [steps[3] / n, steps[0] / n, steps[1] / n, steps[2] / n]
    return [nodes[index] for index in range(len(nodes))]


def in_old_version(path, old, pieces):
    """The file again as version 1.0, with its only piece so many times, each moved by 1 along x."""
    text = path.read_text()
    head, rest = text.split('<Piece', 1)
    piece, tail = rest.split('</Piece>', 1)
    version = head.split('type="UnstructuredGrid" version="')[1].split('"')[0]
    head = head.replace(f'version="{version}"', 'version="1.0"', 2)
    before, points = piece.split('<Points>')
    start = points.index('>') + 1
    end = points.index('<', start) if '<InformationKey' not in points else points.index('<InformationKey', start)
    numbers = [float(word) for word in points[start:end].split()]
    whole = head
    for shift in range(pieces):
        moved = ' '.join(repr(value + (shift if i % 3 == 0 else 0)) for i, value in enumerate(numbers))
        whole += f'<Piece{before}<Points>{points[:start]}{moved}{points[end:]}</Piece>'
    old.write_text(whole + tail)


def higher_cubes(folder):
    """Lagrange and Bezier cells of several degrees, in the order of nodes before and after version 2.1."""
    data, xml, numpy = vtk_modules()
    for word, corners, n in itertools.product(('LAGRANGE', 'BEZIER'), (4, 6, 8), (1, 2, 3, 4)):
        kind = getattr(data, 'VTK_' + word + '_' + {4: 'TETRAHEDRON', 6: 'WEDGE', 8: 'HEXAHEDRON'}[corners])
        weights = numpy.array(lattice_of(data, corners, n))
        cells = [weights @ numpy.array(cell) for cell in corners_of(numpy, corners)]
        path = folder / f'{word}{corners}{n}.vtu'
        write_grid(data, xml, numpy, path, kind, cells)
        check_cubes(path, 1)
        if n in (2, 3):
            check_cubes(path, 1, '--refine', 0.01)
        if corners == 8 and n > 1:
            mapped = [data.vtkHigherOrderHexahedron.NodeNumberingMappingFromVTK8To9([n, n, n], i)
                      for i in range(len(weights))]
            write_grid(data, xml, numpy, path, kind, [cell[mapped] for cell in cells])
            in_old_version(path, folder / 'old.vtu', 3)
            for options in ((), ('--refine', 0.01)):
                sheet = cut(folder / 'old.vtu', None, '--origin', .5, .5, .4, '--normal', 0, 0, 1, *options)
                assert abs(sheet['area'] - 3) < 1e-12, (path.name, options, sheet['area'])


def collapsed_cubes(folder):
    """Quadratic hexahedra that are wedges, pyramids and tetrahedra, as Ansys lists SOLID186."""
    data, xml, numpy = vtk_modules()
    kind, _, weights = vtk_cell(numpy, data, 'QuadraticHexahedron')
    wedge, pyramid, tetrahedron = (0, 1, 2, 2, 3, 4, 5, 5), (0, 1, 2, 3, 4, 4, 4, 4), (0, 1, 2, 2, 3, 3, 3, 3)
    for name, corners, listed in (('wedge', 6, wedge), ('pyramid', 5, pyramid), ('tetrahedron', 4, tetrahedron)):
        cells = [weights @ numpy.array([cell[i] for i in listed]) for cell in corners_of(numpy, corners)]
        write_grid(data, xml, numpy, folder / f'{name}.vtu', kind, cells)
        check_both(folder / f'{name}.vtu')


def far_nodes(folder):
    """Nodes moved far away: bounded parts, one warning, and little memory."""
    data, xml, numpy = vtk_modules()
    rand = random.Random(3)
    for n, size in ((2, 2), (4, 2), (2, 6 if 'VPROBE_LONG' in os.environ else 3)):
        weights = numpy.array(lattice_of(data, 8, n))
        cells = [weights @ ((numpy.array(cell) + corner) / size) for corner in itertools.product(range(size), repeat=3)
                 for cell in corners_of(numpy, 8)]
        points, lists = gathered(numpy, cells)
        for i in rand.sample(range(len(points)), 5 if size == 2 else len(points) // 4):
            points[i] = [rand.choice([-1, 1]) * 10 ** rand.randint(3, 8) for _ in range(3)]
        path, stats = folder / 'far.vtu', folder / 'stats.json'
        write_grid(data, xml, numpy, path, data.VTK_LAGRANGE_HEXAHEDRON, [points[own] for own in lists])
        with subprocess.Popen([VPROBE, 'slice', path, '--refine', '0.001', '--classify', 'cpu', '--origin', '.5', '.5',
                               '.4', '--normal', '0.1', '0.2', '1', '--stats', stats], stderr=subprocess.PIPE) as run:
            said = run.stderr.read().decode()
            _, status, usage = os.wait4(run.pid, 0)
            run.returncode = os.waitstatus_to_exitcode(status)
        assert run.returncode == 0 and said.count('as far as it was refined') == 1, said
        assert usage.ru_maxrss < 1 << 20, f'{usage.ru_maxrss} KiB'
        refined = json.loads(stats.read_text())['refined']
        assert refined['unfinished'] > 0 and refined['parts'] <= min(10 ** 4 * refined['cells'], 10 ** 6), refined


CASES = [gmsh_cubes, meshed_cube, quadratic_cubes, med_cubes, cgns_cubes, higher_cubes, collapsed_cubes, far_nodes]
