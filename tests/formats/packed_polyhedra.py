"""Packs and indices of polyhedra, and of prisms over hexagons, give the figures of what they were made from."""
import math
import shutil
import subprocess

from against import VPROBE, info, need, tried, vprobe
from indices import both
from packed_times import TIMES, swept
from packs import CUTS, change, contours_of, figures, polygons, remove, same, same_figures, shorten

LAYERS = 6


def honeycomb(path, time=0.0, size=8):
    """Layers of cells over hexagons of side 1, each 1 high: polyhedra, prisms and again polyhedra. Written by VTK."""
    import vtk
    points, ids, cells = vtk.vtkPoints(), {}, vtk.vtkUnstructuredGrid()
    f, g = vtk.vtkDoubleArray(), vtk.vtkIntArray()
    f.SetName('f')
    g.SetName('g')

    def point(x, y, z):
        key = round(x, 6), round(y, 6), z
        if key not in ids:
            ids[key] = points.InsertNextPoint(x, y, z)
            f.InsertNextValue(x - 0.5 * y + 0.2 * z + time * z)
        return ids[key]

    cells.SetPoints(points)
    for layer in range(LAYERS):
        for q in range(size):
            for r in range(size):
                low, high = ([point(math.sqrt(3) * (q + r / 2) + math.cos(math.pi * (1 + 2 * k) / 6),
                                    1.5 * r + math.sin(math.pi * (1 + 2 * k) / 6), z) for k in range(6)]
                             for z in (layer, layer + 1))
                g.InsertNextValue(cells.GetNumberOfCells() + int(1000 * time))
                if layer % 2 == 1:
                    cells.InsertNextCell(vtk.VTK_HEXAGONAL_PRISM, 12, low + high)
                    continue
                faces = [low[::-1], high] + [[low[k], low[(k + 1) % 6], high[(k + 1) % 6], high[k]] for k in range(6)]
                stream = vtk.vtkIdList()
                for number in [8] + [n for face in faces for n in [len(face)] + face]:
                    stream.InsertNextId(number)
                cells.InsertNextCell(vtk.VTK_POLYHEDRON, stream)
    cells.GetPointData().AddArray(f)
    cells.GetCellData().AddArray(g)
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(cells)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.SetCompressorTypeToNone()
    assert writer.Write()
    return path


def packed(folder):
    path, pack = honeycomb(folder / 'comb.vtu'), folder / 'comb.vtkhdf'
    done = subprocess.run([VPROBE, 'pack', path, '-o', pack, '--part', '64'], capture_output=True, encoding='utf-8')
    assert done.returncode == 0 and 'VTKHDF 2.5' in done.stderr and done.stderr.count('\n') == 1, done
    return path, pack


def polyhedra_are_cut_as_their_inputs(folder):
    path, pack = packed(folder)
    for options in tried(CUTS):
        same_figures(path, pack, options, folder)
        assert polygons(pack, options, folder / 'a.vtp') == polygons(path, options, folder / 'b.vtp'), options
    parts = same_figures(path, pack, ['--normal', '0', '0', '1', '--origin', '0', '0', '0.25'], folder)
    assert 0 < parts['met'] < 0.6 * parts['all'], parts
    # 64 hexagons of side 1, by hand.
    sheets, _ = figures(pack, ['--normal', '0', '0', '1', '--origin', '0', '0', '0.25'], folder / 's.json')
    assert abs(sheets[0]['area'] - 64 * 1.5 * math.sqrt(3)) < 1e-5 and sheets[0]['cut_cells'] == 64, sheets


def neighbors_of_polyhedra_are_found(folder):
    """Thresholds and contours link the cells near the sheet, others read all."""
    path, pack = packed(folder)
    for options in tried((['--threshold', '0', '5'], ['--contour', '3', '--contour-depth', '0.5'],
                          ['--seeds', 'boundary'], ['--strategy', 'generations'], ['--iso', '2.5'],
                          ['--normal', '0', '1', '0', '--threshold', '0', '5', '--crinkle'])):
        same_figures(path, pack, options, folder)
        wanted, got = (contours_of(each, options, folder / 's.json') for each in (path, pack))
        assert all(same(a[key], b[key]) for a, b in zip(wanted, got, strict=True) for key in a), (options, wanted, got)


def counts(path, folder):
    sheets, _ = figures(path, ['--probe', 'trihedral', '--array', 'f'], folder / 's.json')
    return [[sheet[key] for key in ('cut_cells', 'vertices', 'polygons', 'components')] for sheet in sheets]


def polyhedra_are_converted_and_packed_again(folder):
    path, pack = packed(folder)
    again, back = folder / 'again.vtkhdf', folder / 'back.vtu'
    vprobe('pack', pack, '-o', again, '--part', '100')
    vprobe('convert', pack, '-o', back)
    for options in tried(CUTS[:3]):
        same_figures(path, again, options, folder)
    wanted, got = (counts(each, folder) for each in (path, back))
    assert wanted == got, (wanted, got)
    one, other = info(path), info(pack)
    for key in ('grid', 'bounds'):
        assert one[key] == other[key], (key, one[key], other[key])


def polyhedra_are_indexed(folder):
    path = honeycomb(folder / 'comb.vtu')
    vprobe('index', path)
    for options in tried([*CUTS[:6], ['--threshold', '0', '5']]):
        both(path, options, folder)


def polyhedra_have_times(folder):
    lines = [f'<DataSet timestep="{time}" file="{honeycomb(folder / f"comb{step}.vtu", time).name}"/>'
             for step, time in enumerate(TIMES)]
    path, pack = folder / 'comb.pvd', folder / 'comb.vtkhdf'
    path.write_text('<VTKFile type="Collection"><Collection>' + ''.join(lines) + '</Collection></VTKFile>')
    vprobe('pack', path, '-o', pack, '--part', '64')
    for time in TIMES:
        same_figures(path, pack, [*CUTS[0], '--time', str(time)], folder)
    (wanted, _), (got, parts) = (swept(each, folder, '--normal', '1', '0', '0.2') for each in (path, pack))
    assert len(wanted) == len(got) == len(TIMES)
    for one, other in zip(wanted, got, strict=True):
        assert one[0] == other[0] and all(same(a[key], b[key]) for a, b in zip(one[1:], other[1:]) for key in a)
    assert 0 < parts[-1]['bytes_read'] < 0.3 * parts[0]['bytes_read'], parts


def faces_follow_the_specification(folder):
    """Cell by cell, as VTKHDF 2.5 says where their faces are."""
    import vtk
    h5py = need('h5py')
    path, pack = packed(folder)
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    with h5py.File(pack) as file:
        root, own = file['VTKHDF'], file['vprobe']
        assert list(root.attrs['Version']) == [2, 5] and root.attrs['Type'] == b'UnstructuredGrid'
        counts = {name: int(root[name][0]) for name in ('NumberOfFaces', 'NumberOfFaceConnectivityIds',
                                                        'NumberOfPolyhedronToFaceIds', 'NumberOfCells')}
        assert len(root['NumberOfFaces']) == 1 and (root['Types'][...] == 42).all()
        ends, cell_ends = root['FaceOffsets'][...], root['PolyhedronOffsets'][...]
        assert len(ends) == counts['NumberOfFaces'] + 1 and ends[-1] == counts['NumberOfFaceConnectivityIds']
        assert len(cell_ends) == counts['NumberOfCells'] + 1 and cell_ends[-1] == counts['NumberOfPolyhedronToFaceIds']
        places, corners, faces = root['Points'][...], root['FaceConnectivity'][...], root['PolyhedronToFaces'][...]
        offsets, ids = root['Offsets'][...], root['Connectivity'][...]

        def at(points):
            return frozenset(tuple(round(float(x), 4) for x in place) for place in points)

        for cell, number in enumerate(own['CellNumbers'][...]):
            of_input = grid.GetCell(int(number))
            wanted = {at(of_input.GetFace(k).GetPoints().GetPoint(i)
                         for i in range(of_input.GetFace(k).GetNumberOfPoints()))
                      for k in range(of_input.GetNumberOfFaces())}
            got = {at(places[corners[ends[face]:ends[face + 1]]])
                   for face in faces[cell_ends[cell]:cell_ends[cell + 1]]}
            assert len(got) == 8 and got == wanted, (cell, got, wanted)
            assert at(places[ids[offsets[cell]:offsets[cell + 1]]]) == frozenset().union(*wanted)


def damaged_polyhedra_are_refused(folder):
    h5py = need('h5py')
    _, pack = packed(folder)
    root, own = 'VTKHDF/', 'vprobe/'
    damages = {
        'an id beyond': change(root + 'FaceConnectivity', 0, 999999),
        'an id below 0': change(root + 'FaceConnectivity', 5, -1),
        'a face of two points': change(root + 'FaceOffsets', 1, 2), 'ends that fall': change(root + 'FaceOffsets', 3, 0),
        'a cell of three faces': change(root + 'PolyhedronOffsets', 1, 3),
        'a cell with more faces than there are': change(root + 'PolyhedronOffsets', 4, 10 ** 6),
        'faces of another run': change(own + 'NumberOfFaces', 0, 7),
        'more faces than there can be': change(own + 'NumberOfFaces', 1, 4 * 10 ** 9),
        'ids of another run': change(own + 'NumberOfFaceConnectivityIds', 0, 1),
        'no faces of all': shorten(own + 'NumberOfFaces'), 'no ids of all': shorten(own + 'NumberOfFaceConnectivityIds'),
        'no lists of faces': remove(own + 'NumberOfFaces'), 'faces without ids': remove(root + 'FaceConnectivity'),
        'ids missing': shorten(root + 'FaceConnectivity'), 'ends missing': shorten(root + 'FaceOffsets'),
        'cells missing': shorten(root + 'PolyhedronOffsets')}
    for name, damage in tried(list(damages.items())):
        broken = folder / 'broken.vtkhdf'
        shutil.copy(pack, broken)
        with h5py.File(broken, 'r+') as file:
            damage(file)
        for command in (['slice', broken, '--probe', 'stack', '--sheets', '20', '--stats', '-'],
                        ['convert', broken, '-o', folder / 'broken.vtu']):
            done = subprocess.run([VPROBE, *map(str, command)], capture_output=True, encoding='utf-8')
            assert done.returncode == 2 and len(done.stderr.strip().splitlines()) == 1, (name, command[0], done)


CASES = [polyhedra_are_cut_as_their_inputs, neighbors_of_polyhedra_are_found, polyhedra_are_converted_and_packed_again,
         polyhedra_are_indexed, polyhedra_have_times, faces_follow_the_specification, damaged_polyhedra_are_refused]
