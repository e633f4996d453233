"""Several times in one file, pieces without points, polyhedra of VTK 9.4, entities, axes that are turned round."""
import base64
import struct
import subprocess
import zlib

from against import VPROBE, cut, info, near, need
from odd import refused


def damaged(path, *words):
    done = subprocess.run([VPROBE, 'info', path], capture_output=True, encoding='utf-8')
    assert done.returncode == 2 and done.stderr.count('\n') == 1, done
    for word in words:
        assert word in done.stderr, (word, done.stderr)


def means(path, array, *options):
    sheet = cut(path, array, *options, '--normal', '1', '0', '0', '--origin', '1.5', '1.5', '1.5')
    return sheet['area'], sheet['mean']


def vtk_times(folder):
    """What VTK's writers make of three times: in text and inline a piece for each, appended an array for each."""
    xml, core = need('vtkmodules.vtkIOXML'), need('vtkmodules.vtkCommonDataModel')
    kinds, filters = need('vtkmodules.vtkCommonCore'), need('vtkmodules.vtkFiltersCore')

    def axis():
        numbers = kinds.vtkDoubleArray()
        for i in range(4):
            numbers.InsertNextValue(i)
        return numbers

    def values(name, count, number):
        array = kinds.vtkDoubleArray()
        array.SetName(name)
        array.SetNumberOfValues(count)
        array.Fill(number)
        return array

    image = core.vtkImageData()
    image.SetDimensions(4, 4, 4)
    straight = core.vtkRectilinearGrid()
    straight.SetDimensions(4, 4, 4)
    for put in (straight.SetXCoordinates, straight.SetYCoordinates, straight.SetZCoordinates):
        put(axis())
    curved = core.vtkStructuredGrid()
    curved.SetDimensions(4, 4, 4)
    points = kinds.vtkPoints()
    for i in range(64):
        points.InsertNextPoint(image.GetPoint(i))
    curved.SetPoints(points)
    free = filters.vtkAppendFilter()
    free.AddInputData(image)
    free.Update()
    grids = {'vti': ('ImageData', image), 'vtr': ('RectilinearGrid', straight), 'vts': ('StructuredGrid', curved),
             'vtu': ('UnstructuredGrid', free.GetOutput())}
    forms = ('Ascii', 'Binary', 'Appended', 'raw')
    for number, (ending, (kind, grid)) in enumerate(grids.items()):
        for form_number, form in enumerate(forms):
            path = folder / f'{form}.{ending}'
            writer = getattr(xml, f'vtkXML{kind}Writer')()
            writer.SetFileName(str(path))
            writer.SetInputData(grid)
            getattr(writer, 'SetDataModeTo' + (form if form != 'raw' else 'Appended'))()
            if form == 'raw':
                writer.EncodeAppendedDataOff()
            if (number + form_number) % 2:
                writer.SetCompressorTypeToNone()
            writer.SetNumberOfTimeSteps(3)
            writer.Start()
            for step in range(3):
                grid.GetPointData().AddArray(values('T', 64, step + 1))
                grid.GetCellData().AddArray(values('C', 27, 10 * step + 10))
                grid.Modified()
                writer.WriteNextTime(0.5 * step)
            writer.Stop()
            # Each file is asked one question; together they ask all.
            question = [([], 3), (['--time', '0.5'], 2), (['--time', '#0'], 1), (['--time', 'last'], 3)]
            options, step = question[(number + form_number) % 4]
            area, mean = means(path, 'point:T', *options)
            assert near(area, 9) and near(mean, step), (path, options, area, mean)
    assert info(folder / 'raw.vtr')['times'] == [0, 0.5, 1]
    assert near(means(folder / 'Ascii.vtu', 'cell:C', '--time', '0.4')[1], 20)
    done = subprocess.run([VPROBE, 'info', folder / 'raw.vtu', '--time', '#3'], capture_output=True, encoding='utf-8')
    assert done.returncode == 2 and 'from #0 to #2' in done.stderr, done
    # A piece of an index, and what cannot be told apart.
    (folder / 'all.pvtu').write_text(
        '<VTKFile type="PUnstructuredGrid" version="0.1" byte_order="LittleEndian"><PUnstructuredGrid GhostLevel="0">'
        '<PPointData><PDataArray type="Float64" Name="T"/></PPointData>'
        '<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>'
        '<Piece Source="raw.vtu"/></PUnstructuredGrid></VTKFile>')
    assert near(means(folder / 'all.pvtu', 'point:T', '--time', '0.5')[1], 2)
    text = (folder / 'Ascii.vti').read_text()
    last = text.rindex('<Piece')
    (folder / 'less.vti').write_text(text[:last] + text[text.index('</Piece>', last) + 8:])
    refused(folder / 'less.vti', '2 pieces', '3 times')


def write_pieces(folder, name, grids):
    xml = need('vtkmodules.vtkIOXML')
    for number, grid in enumerate(grids):
        writer = xml.vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(folder / f'{name}{number}.vtu'))
        writer.SetDataModeToAscii()
        writer.SetInputData(grid)
        writer.Write()
    pieces = ''.join(f'<Piece Source="{name}{number}.vtu"/>' for number in range(len(grids)))
    (folder / f'{name}.pvtu').write_text(
        '<VTKFile type="PUnstructuredGrid" version="0.1" byte_order="LittleEndian"><PUnstructuredGrid GhostLevel="0">'
        '<PPointData><PDataArray type="Float64" Name="x"/></PPointData>'
        '<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>'
        f'{pieces}</PUnstructuredGrid></VTKFile>')


def empty_pieces(folder):
    """A rank without cells writes a piece without points, and without the arrays that the others have."""
    core, kinds = need('vtkmodules.vtkCommonDataModel'), need('vtkmodules.vtkCommonCore')
    filters, xml = need('vtkmodules.vtkFiltersCore'), need('vtkmodules.vtkIOXML')
    image = core.vtkImageData()
    image.SetDimensions(2, 2, 2)
    append = filters.vtkAppendFilter()
    append.AddInputData(image)
    append.Update()
    full, empty = append.GetOutput(), core.vtkUnstructuredGrid()
    x = kinds.vtkDoubleArray()
    x.SetName('x')
    for i in range(8):
        x.InsertNextValue(full.GetPoint(i)[0])
    full.GetPointData().AddArray(x)
    plane = ('--normal', '0', '1', '0', '--origin', '0', '0.4', '0')
    for name, grids in (('first', [empty, full]), ('last', [full, empty])):
        write_pieces(folder, name, grids)
        sheet = cut(folder / f'{name}.pvtu', 'x', *plane)
        assert near(sheet['area'], 1) and near(sheet['mean'], 0.5), sheet
    write_pieces(folder, 'none', [empty, empty])
    refused(folder / 'none.pvtu', 'nothing to slice')
    refused(folder / 'none0.vtu', 'nothing to slice')
    done = subprocess.run([VPROBE, 'slice', folder / 'none0.vtu', folder / 'last0.vtu', *plane, '--stats', '-'],
                          capture_output=True, encoding='utf-8')
    assert done.returncode == 0 and '"area": 1.0' in done.stdout and 'is left out' in done.stderr, done
    # The same in one file, and as a block of several.
    text = (folder / 'last0.vtu').read_text()
    nothing = (folder / 'none0.vtu').read_text()
    piece = nothing[nothing.index('<Piece'):nothing.index('</Piece>') + 8]
    at = text.index('<Piece')
    (folder / 'both.vtu').write_text(text[:at] + piece + text[at:])
    assert near(cut(folder / 'both.vtu', 'x', *plane)['area'], 1)
    (folder / 'blocks.vtm').write_text(
        '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet><DataSet index="0" file="none0.vtu"/>'
        '<DataSet index="1" file="last0.vtu"/><DataSet index="2"/></vtkMultiBlockDataSet></VTKFile>')
    assert near(cut(folder / 'blocks.vtm', 'x', *plane)['area'], 1)
    # Lattices: VTK writes an extent without points.
    for kind, ending in (('StructuredGrid', 'vts'), ('ImageData', 'vti')):
        writer = getattr(xml, f'vtkXML{kind}Writer')()
        writer.SetFileName(str(folder / f'none.{ending}'))
        writer.SetInputData(getattr(core, f'vtk{kind}')())
        writer.Write()
        refused(folder / f'none.{ending}', 'nothing to slice')
    lattice = core.vtkStructuredGrid()
    lattice.SetDimensions(2, 2, 2)
    points = kinds.vtkPoints()
    for i in range(8):
        points.InsertNextPoint(image.GetPoint(i))
    lattice.SetPoints(points)
    writer = xml.vtkXMLStructuredGridWriter()
    writer.SetFileName(str(folder / 'full.vts'))
    writer.SetInputData(lattice)
    writer.Write()
    (folder / 'all.pvts').write_text(
        '<VTKFile type="PStructuredGrid" version="0.1" byte_order="LittleEndian">'
        '<PStructuredGrid WholeExtent="0 1 0 1 0 1" GhostLevel="0">'
        '<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>'
        '<Piece Extent="0 -1 0 -1 0 -1" Source="none.vts"/><Piece Extent="0 1 0 1 0 1" Source="full.vts"/>'
        '</PStructuredGrid></VTKFile>')
    assert near(cut(folder / 'all.pvts', None, *plane)['area'], 1)


CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def ends(lists):
    sums = [0]
    for each in lists:
        sums.append(sums[-1] + len(each))
    return sums


def three_cubes():
    """A polyhedron, a hexahedron and a polyhedron, side by side: points, types and lists as VTK 9.4 has them."""
    points = [(x + c, y, z) for c in range(3) for x, y, z in CORNERS]
    cells = [[8 * c + i for i in range(8)] for c in range(3)]
    faces = [[8 * c + i for i in face] for c in (0, 2) for face in FACES]
    return points, [42, 12, 42], cells, faces, [list(range(6)), [], list(range(6, 12))]


def polyhedra_of_vtk94(folder):
    """Faces once, and lists of them for each cell (.vtu 2.3), written by hand in each form."""
    points, types, cells, faces, uses = three_cubes()

    def flat(lists):
        return [number for each in lists for number in each]

    arrays = {'Points': ('Float64', 3, flat(points)), 'connectivity': ('Int64', 1, flat(cells)),
              'offsets': ('Int64', 1, ends(cells)[1:]), 'types': ('UInt8', 1, types),
              'face_connectivity': ('Int64', 1, flat(faces)), 'face_offsets': ('Int64', 1, ends(faces)[1:]),
              'polyhedron_to_faces': ('Int64', 1, flat(uses)), 'polyhedron_offsets': ('Int64', 1, ends(uses)[1:]),
              'c': ('Float64', 1, [0, 5, 10])}
    letters = {'Float64': 'd', 'Int64': 'q', 'UInt8': 'B'}

    def write(form):
        appended = b''

        def element(name):
            nonlocal appended
            kind, components, numbers = arrays[name]
            head = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" '
            if form == 'ascii':
                return head + 'format="ascii">' + ' '.join(map(str, numbers)) + '</DataArray>'
            data = struct.pack(f'<{len(numbers)}{letters[kind]}', *numbers)
            size = struct.pack('<Q', len(data))
            if form == 'zlib':
                data = zlib.compress(data)
                size = struct.pack('<4Q', 1, 1 << 15, len(numbers) * struct.calcsize(letters[kind]), len(data))
            if form != 'raw':
                text = base64.b64encode(size).decode() + base64.b64encode(data).decode()
                if form == 'base64':
                    text = base64.b64encode(size + data).decode()
                return head + f'format="binary">{text}</DataArray>'
            offset, appended = len(appended), appended + size + data
            return head + f'format="appended" offset="{offset}"/>'

        packed = ' compressor="vtkZLibDataCompressor"' if form == 'zlib' else ''
        text = (f'<VTKFile type="UnstructuredGrid" version="2.3" byte_order="LittleEndian" header_type="UInt64"{packed}>'
                f'<UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">'
                f'<CellData>{element("c")}</CellData><Points>{element("Points")}</Points><Cells>'
                + ''.join(element(name) for name in arrays if name not in ('Points', 'c'))
                + '</Cells></Piece></UnstructuredGrid>')
        tail = b'<AppendedData encoding="raw">_' + appended + b'</AppendedData>' if form == 'raw' else b''
        path = folder / f'{form}.vtu'
        path.write_bytes(text.encode() + tail + b'</VTKFile>')
        return path

    plane = ('--normal', '0', '1', '0', '--origin', '0', '0.4', '0')
    for form in ('ascii', 'base64', 'raw', 'zlib'):
        sheet = cut(write(form), 'cell:c', *plane)
        assert near(sheet['area'], 3) and near(sheet['mean'], 5), (form, sheet)
    # In an index, behind another piece: the points of the faces move along.
    (folder / 'all.pvtu').write_text(
        '<VTKFile type="PUnstructuredGrid" version="2.3" byte_order="LittleEndian"><PUnstructuredGrid GhostLevel="0">'
        '<PCellData><PDataArray type="Float64" Name="c"/></PCellData>'
        '<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>'
        '<Piece Source="raw.vtu"/><Piece Source="ascii.vtu"/></PUnstructuredGrid></VTKFile>')
    assert near(cut(folder / 'all.pvtu', 'cell:c', *plane)['area'], 6)
    text = (folder / 'ascii.vtu').read_text()
    for old, new in (('0 1 2 3 4 5 6 7 8 9 10 11</DataArray>', '0 1 2 3 4 5 6 7 8 9 10 99</DataArray>'),
                     ('>0 3 2 1 ', '>0 3 2 -1 '), ('>0 3 2 1 ', '>0 3 2 24 '), ('>6 6 12<', '>6 2 12<'),
                     ('>6 6 12<', '>6 6 1000000000000<')):
        assert old in text
        (folder / 'bad.vtu').write_text(text.replace(old, new))
        damaged(folder / 'bad.vtu', 'damaged')


def vtkhdf_grids(folder):
    """Unstructured grids of VTKHDF 2 with times, after its specification."""
    h5py, numpy = need('h5py'), need('numpy')
    plane = ('--normal', '1', '0', '0', '--origin', '0.4', '0.4', '0.4')

    def new(name, kind='UnstructuredGrid', steps=0):
        root = h5py.File(folder / name, 'w').create_group('VTKHDF')
        root.attrs['Version'] = (2, 0)
        root.attrs.create('Type', numpy.bytes_(kind))
        if steps:
            root.create_group('Steps').attrs['NSteps'] = steps
        return root

    def put(root, **lists):
        for name, numbers in lists.items():
            root[name] = numpy.array(numbers)

    # Two parts above each other, that all times share; values that differ by time, and some that do not.
    corners = numpy.array(CORNERS, dtype=float)
    root = new('still.vtkhdf', steps=3)
    put(root, NumberOfPoints=[8, 8], NumberOfCells=[1, 1], NumberOfConnectivityIds=[8, 8], Types=[12, 12],
        Connectivity=list(range(8)) * 2, Offsets=[0, 8, 0, 8])
    root['Types'][...] = 12
    del root['Types']
    root['Types'] = numpy.array([12, 12], dtype='u1')
    places = numpy.concatenate([corners, corners + [0, 0, 1]])
    root['Points'] = places
    put(root['Steps'], Values=[0.0, 1.0, 2.0], PartOffsets=[0, 0, 0], NumberOfParts=[2, 2, 2], PointOffsets=[0, 0, 0],
        CellOffsets=[[0], [0], [0]], ConnectivityIdOffsets=[[0], [0], [0]])
    root['PointData/x'] = numpy.concatenate([places[:, 0] + 10 * step for step in range(3)])
    root['PointData/z'] = places[:, 2]
    root['CellData/c'] = numpy.array([1.0, 2.0, 3.0, 4.0])
    root['Steps/PointDataOffsets/x'] = numpy.array([0, 16, 32])
    root['Steps/CellDataOffsets/c'] = numpy.array([0, 2, 0])
    root.file.close()
    for options, x, c in (([], 20.4, 1.5), (['--time', '1'], 10.4, 3.5), (['--time', '#0'], 0.4, 1.5)):
        sheet = cut(folder / 'still.vtkhdf', 'x', *plane, *options)
        assert near(sheet['area'], 2) and near(sheet['mean'], x), (options, sheet)
        assert near(cut(folder / 'still.vtkhdf', 'cell:c', *plane, *options)['mean'], c), options
    assert near(cut(folder / 'still.vtkhdf', 'z', *plane)['mean'], 1)
    assert info(folder / 'still.vtkhdf')['times'] == [0, 1, 2]

    # A grid that changes: a hexahedron, then that and a tetrahedron, in one part each. No list names the parts.
    root = new('moving.vtkhdf', steps=2)
    put(root, NumberOfPoints=[8, 12], NumberOfCells=[1, 2], NumberOfConnectivityIds=[8, 12],
        Connectivity=list(range(8)) + list(range(12)), Offsets=[0, 8, 0, 8, 12])
    root['Types'] = numpy.array([12, 12, 10], dtype='u1')
    root['Points'] = numpy.concatenate([corners, 2 * corners, [[0, 0, 5], [1, 0, 5], [0, 1, 5], [0, 0, 6]]])
    put(root['Steps'], Values=[5.0, 6.0], PartOffsets=[0, 1], PointOffsets=[0, 8], CellOffsets=[0, 1],
        ConnectivityIdOffsets=[0, 8])
    root['PointData/v'] = numpy.stack([root['Points'][:, 0], root['Points'][:, 1], root['Points'][:, 2]], axis=1)
    root.file.close()
    assert near(cut(folder / 'moving.vtkhdf', 'v', *plane, '--time', 'first')['area'], 1)
    assert near(cut(folder / 'moving.vtkhdf', 'v', *plane)['area'], 4 + 0.6 * 0.6 / 2)
    assert info(folder / 'moving.vtkhdf')['grid']['cells'] == 2

    # Polyhedra that move.
    points, types, cells, faces, uses = three_cubes()
    root = new('polyhedra.vtkhdf', steps=2)
    put(root, NumberOfPoints=[24, 24], NumberOfCells=[3, 3], NumberOfConnectivityIds=[24, 24],
        Connectivity=numpy.concatenate(cells * 2), Offsets=ends(cells) * 2, NumberOfFaces=[12, 12],
        NumberOfPolyhedronToFaceIds=[12, 12], NumberOfFaceConnectivityIds=[48, 48],
        FaceConnectivity=numpy.concatenate(faces * 2), FaceOffsets=ends(faces) * 2,
        PolyhedronToFaces=list(range(12)) * 2, PolyhedronOffsets=ends(uses) * 2,
        Points=numpy.concatenate([points, numpy.array(points) * [2, 1, 1]]))
    root['Types'] = numpy.array(types * 2, dtype='u1')
    put(root['Steps'], Values=[0.0, 1.0], PartOffsets=[0, 1], PointOffsets=[0, 24], CellOffsets=[0, 3],
        ConnectivityIdOffsets=[0, 24], FaceConnectivityOffsets=[0, 48], FaceOffsetsOffsets=[0, 12],
        PolyhedronToFaceIdOffsets=[0, 12])
    root.file.close()
    across = ('--normal', '0', '1', '0', '--origin', '0', '0.4', '0')
    assert near(cut(folder / 'polyhedra.vtkhdf', None, *across, '--time', '0')['area'], 3)
    assert near(cut(folder / 'polyhedra.vtkhdf', None, *across)['area'], 6)

    # Nothing that the file says is taken on trust.
    whole = (folder / 'still.vtkhdf').read_bytes()
    for name, place, number in (('Offsets', 1, 7), ('Connectivity', 3, 8), ('Connectivity', 3, -1),
                                ('NumberOfPoints', 0, 1 << 50), ('NumberOfCells', 1, -1), ('NumberOfCells', 1, 9),
                                ('Steps/PartOffsets', 2, 5), ('Steps/PointOffsets', 2, 17),
                                ('Steps/PointDataOffsets/x', 2, 33), ('Steps/NumberOfParts', 2, 3),
                                ('Steps/CellDataOffsets/c', 2, -1)):
        (folder / 'bad.vtkhdf').write_bytes(whole)
        with h5py.File(folder / 'bad.vtkhdf', 'a') as file:
            file['VTKHDF/' + name][place] = number
        damaged(folder / 'bad.vtkhdf', 'damaged')
    for kind, words in (('OverlappingAMR', 'OverlappingAMR'), ('PolyData', 'poly'),
                        ('PartitionedDataSetCollection', 'without image data and unstructured grids')):
        new('other.vtkhdf', kind).file.close()
        done = subprocess.run([VPROBE, 'info', folder / 'other.vtkhdf'], capture_output=True, encoding='utf-8')
        assert done.returncode == 2 and words in done.stderr, done


def vtkhdf_collections(folder):
    """A unit cube of one hexahedron, and beside it an image, at two times."""
    h5py, numpy = need('h5py'), need('numpy')
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1.0]])
    path = folder / 'both.vtkhdf'

    def steps_of(root, name, offsets, times=(2.0, 4.0), **lists):
        steps = root.create_group('Steps')
        steps.attrs['NSteps'] = 2
        steps['Values'] = times
        steps[f'PointDataOffsets/{name}'] = offsets
        for key, values in lists.items():
            steps[key] = values

    def write(kind, times=(2.0, 4.0)):
        with h5py.File(path, 'w') as file:
            top = file.create_group('VTKHDF')
            top.attrs['Version'], top.attrs['Type'] = (2, 1), kind
            cube, image = top.create_group('a cube'), top.create_group('Image')
            for number, (root, type_of) in enumerate(((cube, 'UnstructuredGrid'), (image, 'ImageData'))):
                root.attrs['Version'], root.attrs['Type'], root.attrs['Index'] = (2, 1), type_of, 1 - number
            for name, numbers in {'NumberOfPoints': [8], 'NumberOfCells': [1], 'NumberOfConnectivityIds': [8],
                                  'Connectivity': list(range(8)), 'Offsets': [0, 8]}.items():
                cube[name] = numpy.array(numbers)
            cube['Types'], cube['Points'] = numpy.array([12], dtype='u1'), corners
            cube['PointData/f'] = numpy.concatenate([corners[:, 2], 5 + corners[:, 2]])
            steps_of(cube, 'f', [0, 8], PartOffsets=[0, 0], NumberOfParts=[1, 1], PointOffsets=[0, 0],
                     CellOffsets=[0, 0], ConnectivityIdOffsets=[0, 0])
            image.attrs['WholeExtent'] = (0, 2, 0, 1, 0, 1)
            image.attrs['Origin'], image.attrs['Spacing'] = (1.0, 0.0, 0.0), (1.0, 1.0, 1.0)
            image.attrs['Direction'] = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
            z = numpy.mgrid[0:2, 0:2, 0:3][0].astype(float)
            image['PointData/f'] = numpy.stack([z, 5 + z])
            steps_of(image, 'f', [0, 1], times)
            tree = top.create_group('Assembly')
            tree['all/a cube'] = h5py.SoftLink('/VTKHDF/a cube')
            tree['all/Image'] = h5py.SoftLink('/VTKHDF/Image')

    for kind in ('PartitionedDataSetCollection', 'MultiBlockDataSet'):
        write(kind)
        told = info(path)
        assert [block['name'] for block in told['blocks']] == ['both: Image', 'both: a cube'], told
        assert told['times'] == [2, 4], told
        plane = ('--normal', '0', '0', '1', '--origin', '0', '0', '0.25')
        for time, mean in (('2', 0.25), ('last', 5.25)):
            sheet = cut(path, 'f', *plane, '--time', time)
            assert near(sheet['area'], 3) and near(sheet['mean'], mean) and sheet['components'] == 1, sheet
    write('MultiBlockDataSet', times=(2.0, 3.0))
    refused(path, 'different times')
    with h5py.File(path, 'r+') as file:
        del file['VTKHDF/Image']  # and a link leads nowhere
        for name, type_of in (('tree', 'HyperTreeGrid'), ('flat', 'PolyData')):
            file.create_group(f'VTKHDF/{name}').attrs['Type'] = type_of
    done = subprocess.run([VPROBE, 'slice', path, *plane, '--stats', folder / 's.json'], capture_output=True,
                          encoding='utf-8')
    assert done.returncode == 0 and 'the data set tree of type HyperTreeGrid is left out' in done.stderr, done
    assert 'flat' not in done.stderr and near(cut(path, 'f', *plane)['area'], 1)


def vtkhdf_images(folder):
    """Times are the slowest side of an array."""
    h5py, numpy = need('h5py'), need('numpy')
    z, y, x = numpy.mgrid[0:4, 0:5, 0:6].astype(float)
    with h5py.File(folder / 'image.vtkhdf', 'w') as file:
        root = file.create_group('VTKHDF')
        root.attrs['Version'] = (2, 0)
        root.attrs['Type'] = 'ImageData'  # of any length
        root.attrs['WholeExtent'] = (2, 7, 0, 4, 0, 3)
        root.attrs['Origin'], root.attrs['Spacing'] = (0.0, 0.0, 0.0), (0.5, 1.0, 1.0)
        root.attrs['Direction'] = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0)
        steps = root.create_group('Steps')
        steps.attrs['NSteps'] = 3
        steps['Values'] = [0.0, 2.0, 4.0]
        root.create_dataset('PointData/f', data=numpy.stack([x + 100 * t for t in range(3)]).astype('>f4'),
                            chunks=(1, 4, 5, 6), compression='gzip')
        root['PointData/v'] = numpy.stack([numpy.stack([x, y, z + 7 * t], axis=3) for t in range(3)])
        root['PointData/again'] = numpy.stack([y, 2 * y])
        steps['PointDataOffsets/again'] = [0, 1, 0]
        root['CellData/c'] = numpy.stack([numpy.full((3, 4, 5), t, dtype='i2') for t in (3, 4, 5)])
    plane = ('--normal', '1', '0', '0', '--origin', '1.75', '0', '0')  # between the points 1 and 2
    for options, step in (([], 2), (['--time', '2'], 1), (['--time', 'first'], 0)):
        sheet = cut(folder / 'image.vtkhdf', 'f', *plane, *options)
        assert near(sheet['area'], 12) and near(sheet['mean'], 1.5 + 100 * step), (options, sheet)
        assert near(cut(folder / 'image.vtkhdf', 'cell:c', *plane, *options)['mean'], 3 + step)
        assert near(cut(folder / 'image.vtkhdf', 'again', *plane, *options)['mean'], 2 * (1 + step % 2))
    found = info(folder / 'image.vtkhdf')
    assert found['bounds'] == [1, 3.5, 0, 4, -3, 0] or found['bounds'][:2] == [1, 3.5], found['bounds']
    with h5py.File(folder / 'image.vtkhdf', 'a') as file:
        file['VTKHDF/Steps/PointDataOffsets/again'][2] = 2
    damaged(folder / 'image.vtkhdf', 'damaged')


def xdmf_entities(folder):
    """Entities of the file itself are expanded; none of another file is opened, and none blows up."""
    numbers = ' '.join(map(str, range(60)))
    geometry = ('<Geometry GeometryType="ORIGIN_DXDYDZ"><DataItem Dimensions="3">0 0 0</DataItem>'
                '<DataItem Dimensions="3">1 1 1</DataItem></Geometry>')

    def write(name, declared, values='&v;', place=geometry):
        path = folder / f'{name}.xmf'
        path.write_text(f'<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" [{declared}]><Xdmf Version="2.0"><Domain><Grid>'
                        f'<Topology TopologyType="3DCoRectMesh" Dimensions="3 4 5"/>{place}'
                        f'<Attribute Name="x" Center="Node"><DataItem Dimensions="3 4 5">{values}</DataItem>'
                        '</Attribute></Grid></Domain></Xdmf>')
        return path

    (folder / 'values.txt').write_text(numbers)
    good = {'values': write('values', f'<!ENTITY v "{numbers}">'),
            'nested': write('nested', f'<!ENTITY a "0 1 2"><!ENTITY v "&a; {numbers[6:]}">'),
            'elements': write('elements', f"<!ENTITY g '{geometry}'>", numbers, '&g;'),
            'odd': write('odd', '<!ENTITY a "x>y ]> z">', numbers)}
    for path in good.values():
        assert info(path)['arrays'][0]['range'] == [0, 59], path
    refused(write('external', '<!ENTITY v SYSTEM "values.txt">'), 'never opened')
    refused(write('undeclared', ''), 'never opened')
    laughs = '<!ENTITY l0 "0 ">' + ''.join(f'<!ENTITY l{i} "{f"&l{i - 1};" * 10}">' for i in range(1, 12))
    damaged(write('laughs', laughs, '&l11;'), 'XML cannot be parsed')
    damaged(write('circle', '<!ENTITY a "&b;"><!ENTITY b "&a;">', '&a;'), 'XML cannot be parsed')
    # The same in VTK's files, which VTK's parser reads.
    for name, declared, file in (('good', '<!ENTITY f "values.xmf">', '&f;'), ('laughs', laughs, '&l11;'),
                                 ('external', '<!ENTITY f SYSTEM "values.txt">', '&f;')):
        path = folder / f'{name}.pvd'
        path.write_text(f'<?xml version="1.0"?><!DOCTYPE VTKFile [{declared}]><VTKFile type="Collection"><Collection>'
                        f'<DataSet timestep="0" file="{file}"/></Collection></VTKFile>')
        if name == 'good':
            assert info(path)['arrays'][0]['range'] == [0, 59]
        else:
            damaged(path, 'damaged')


def turned_axes(folder):
    """A negative spacing turns the axis round; the first sample stays where it is."""
    numpy = need('numpy')
    values = numpy.arange(7 * 8 * 9, dtype='<f4')
    x, y, z = values.astype(int) % 9, values.astype(int) // 9 % 8, values.astype(int) // 72

    def mha(name, *lines):
        path = folder / name
        head = ('ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n' +
                '\n'.join(lines) + '\nDimSize = 9 8 7\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n')
        path.write_bytes(head.encode() + values.tobytes())
        return path

    def bounds(path):
        return [round(b, 9) + 0.0 for b in info(path)['bounds']]

    # The last sample of each axis lies where ITK's TransformIndexToPhysicalPoint() puts it.
    path = mha('z.mha', 'Offset = 10 -20 30', 'ElementSpacing = 0.5 0.75 -1.25')
    assert bounds(path) == [10, 14, -20, -14.75, 22.5, 30], bounds(path)
    sheet = cut(path, None, '--normal', '0', '0', '1', '--origin', '12', '-18', '26.25')
    assert near(sheet['area'], 21) and near(sheet['mean'], values[z == 3].mean()), sheet
    path = mha('x.mha', 'TransformMatrix = 0 1 0 1 0 0 0 0 1', 'Offset = 1 2 3', 'ElementSpacing = -0.5 2 1')
    assert bounds(path) == [1, 15, -2, 2, 3, 9], bounds(path)
    sheet = cut(path, None, '--normal', '0', '1', '0', '--origin', '0', '0.5', '0')
    assert near(sheet['area'], 84) and near(sheet['mean'], values[x == 3].mean()), sheet
    path = mha('size.mha', 'ElementSize = 1 -1 1')
    assert bounds(path) == [0, 8, -7, 0, 0, 6], bounds(path)
    assert near(cut(path, None, '--normal', '0', '1', '0', '--origin', '0', '-2', '0')['mean'], values[y == 2].mean())
    damaged(mha('zero.mha', 'ElementSpacing = 1 0 1'), 'ElementSpacing')
    # The same of NRRD and of VTK's images, whose spacings are steps.
    path = folder / 'turned.nrrd'
    path.write_bytes(b'NRRD0005\ntype: float\ndimension: 3\nsizes: 9 8 7\nendian: little\nencoding: raw\n'
                     b'spacings: 1 1 -2\naxis mins: 0 0 5\n\n' + values.tobytes())
    assert bounds(path)[4:] == [-7, 5], bounds(path)
    assert near(cut(path, None, '--normal', '0', '0', '1', '--origin', '0', '0', '1')['mean'], values[z == 2].mean())
    (folder / 'turned.vti').write_text(
        '<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="0 8 0 7 0 6" '
        'Origin="0 0 5" Spacing="1 1 -2"><Piece Extent="0 8 0 7 0 6"><PointData><DataArray type="Float32" Name="f" '
        f'format="ascii">{" ".join(str(int(v)) for v in values)}</DataArray></PointData></Piece></ImageData></VTKFile>')
    path = folder / 'turned.vti'
    assert bounds(path)[4:] == [-7, 5], bounds(path)
    assert near(cut(path, None, '--normal', '0', '0', '1', '--origin', '0', '0', '1')['mean'], values[z == 2].mean())


CASES = [vtk_times, empty_pieces, polyhedra_of_vtk94, vtkhdf_grids, vtkhdf_collections, vtkhdf_images,
         xdmf_entities, turned_axes]
