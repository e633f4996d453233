"""Odd files that are valid: each gives the right figures, or one line that says why not."""
import subprocess

from against import VPROBE, compare, cut, info, lattice, mixed_mesh, near, need, nrrd


def refused(path, *words):
    done = subprocess.run([VPROBE, 'info', path], capture_output=True, encoding='utf-8')
    assert done.returncode == 2 and done.stderr.count('\n') == 1, done
    for word in words:
        assert word in done.stderr, (word, done.stderr)
    assert 'damaged' not in done.stderr, done.stderr


def exodus_by_meshio(folder):
    """Without the mark of large files, but with variables as these have them; a vector as one of them."""
    meshio, numpy = need('meshio'), need('numpy')
    need('netCDF4')
    mesh = mixed_mesh(meshio, numpy)
    mesh.cell_data.clear()
    meshio.write(folder / 'reference.vtu', mesh)
    meshio.write(folder / 'mesh.e', mesh)
    compare(folder / 'mesh.e', folder / 'reference.vtu', [(a, a) for a in ('point:f', 'point:v')], counts=('cells',))


def exodus_without_values(folder):
    """The table of variables says that one is there."""
    netcdf4, numpy, meshio = need('netCDF4'), need('numpy'), need('meshio')
    mesh = mixed_mesh(meshio, numpy)
    mesh.cell_data.clear()
    mesh.point_data.clear()
    path = folder / 'mesh.e'
    meshio.write(path, mesh)
    with netcdf4.Dataset(path, 'a') as file:
        file.createDimension('num_elem_var', 1)
        file.createVariable('name_elem_var', 'S1', ('num_elem_var', 'len_string'))[0, 0] = b'p'
        file.createVariable('elem_var_tab', 'i4', ('num_el_blk', 'num_elem_var'))[:] = 1
    done = subprocess.run([VPROBE, 'info', path], capture_output=True, encoding='utf-8')
    assert done.returncode == 2 and 'it has no vals_elem_var1eb1' in done.stderr, done


def numpy_types(folder):
    numpy = need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values)
    numpy.savez(folder / 'mixed.npz', empty=numpy.zeros((0, 4, 5)), f=values.astype('>f4'), c=values.astype('c8'),
                objects=numpy.array([None]), mask=values > 100)
    compare(folder / 'mixed.npz', reference, [('point:f', 'point:f')])
    assert {a['name'] for a in info(folder / 'mixed.npz')['arrays']} == {'f', 'mask'}
    numpy.save(folder / 'half.npy', values.astype('f2'))
    refused(folder / 'half.npy', "astype('float32')")
    numpy.save(folder / 'empty.npy', numpy.zeros((0, 4, 5)))
    refused(folder / 'empty.npy', 'nothing to slice')
    numpy.save(folder / 'nan.npy', numpy.full((3, 3, 3), numpy.nan))
    assert info(folder / 'nan.npy')['arrays'][0]['range'] == [None, None]


def nrrd_directions(folder):
    """"none" says which axis is not of space; kinds may be left out, and so may all directions but these."""
    numpy = need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 1 1 1\naxis mins: 0 0 0\n')
    for name, order, sizes, directions in (('first', '<f4', '2 5 4 6', 'none (1,0,0) (0,1,0) (0,0,1)'),
                                           ('last', '<f4', '5 4 6 2', '(1,0,0) (0,1,0) (0,0,1) none')):
        both = numpy.stack([values, -values], axis=3 if name == 'first' else 0)
        (folder / f'{name}.nrrd').write_bytes(
            (f'NRRD0005\ntype: float\ndimension: 4\nsizes: {sizes}\ncontent: f\nendian: little\nencoding: raw\n'
             f'space: left-posterior-superior\nspace directions: {directions}\nspace origin: (0,0,0)\n\n').encode() +
            both.astype(order).tobytes())
        found = info(folder / f'{name}.nrrd')
        assert found['arrays'][0]['components'] == 2 and found['bounds'] == [0, 4, 0, 3, 0, 5], found
        ours, wanted = cut(folder / f'{name}.nrrd', 'f', '--component', '0'), cut(reference, 'f')
        assert near(ours['area'], wanted['area']) and near(ours['mean'], wanted['mean']), (name, ours, wanted)


def counts_that_lie(folder):
    """Lists and counts in a head that ask for more than there can be."""
    def refused_as_damaged(name, text, *words):
        (folder / name).write_text(text)
        done = subprocess.run([VPROBE, 'info', folder / name], capture_output=True, encoding='utf-8', timeout=120)
        assert done.returncode == 2 and done.stderr.count('\n') == 1, done
        for word in words:
            assert word in done.stderr, (word, done.stderr)

    often = ','.join(['1-4'] * 50000)
    refused_as_damaged('often.dat', f'VARIABLES = "X" "Y" "Z" "P"\nZONE I=2, J=2, K=2, DATAPACKING=BLOCK, '
                       f'VARLOCATION=([{often}]=NODAL)\n' + '0 1 0 1 0 1 0 1\n' * 4, 'more than once')
    refused_as_damaged('many.xmf', '<?xml version="1.0"?>\n<Xdmf Version="3.0"><Domain><Grid Name="box">\n'
                       '<Topology TopologyType="3DCoRectMesh" Dimensions="1000 1000 1000"/>\n'
                       '<Geometry GeometryType="ORIGIN_DXDYDZ"><DataItem Dimensions="3" Format="XML">0 0 0</DataItem>\n'
                       '<DataItem Dimensions="3" Format="XML">1 1 1</DataItem></Geometry>\n'
                       '<Attribute Name="f" Center="Node"><DataItem Dimensions="1000 1000 1000" Format="XML">'
                       '1 2 3</DataItem></Attribute></Grid></Domain></Xdmf>\n', 'fewer values')


def deep_trees(folder):
    """A hyper tree of 66 levels, of which each has one cell that is divided further."""
    vtk = need('vtk')
    trees, cursor = vtk.vtkHyperTreeGrid(), vtk.vtkHyperTreeGridNonOrientedCursor()
    trees.SetDimensions(2, 2, 2)
    trees.SetBranchFactor(2)
    for axis in 'XYZ':
        ends = vtk.vtkDoubleArray()
        for end in (0.0, 1.0):
            ends.InsertNextValue(end)
        getattr(trees, f'Set{axis}Coordinates')(ends)
    trees.InitializeNonOrientedCursor(cursor, 0, True)
    cursor.SetGlobalIndexStart(0)
    for _ in range(66):
        cursor.SubdivideLeaf()
        cursor.ToChild(0)
    values = vtk.vtkDoubleArray()
    values.SetName('f')
    values.SetNumberOfTuples(1 + 8 * 66)
    values.Fill(1.0)
    trees.GetCellData().AddArray(values)
    writer = vtk.vtkXMLHyperTreeGridWriter()
    writer.SetInputData(trees)
    writer.SetFileName(str(folder / 'deep.htg'))
    writer.Write()
    refused(folder / 'deep.htg', '67 levels', 'up to 64')


def netcdf_sides(folder):
    netcdf4, numpy = need('netCDF4'), need('numpy')
    values = lattice(numpy)

    def new(name, form='NETCDF4', **sides):
        file = netcdf4.Dataset(folder / name, 'w', format=form)
        for side, count in ({'z': 6, 'y': 4, 'x': 5} | sides).items():
            file.createDimension(side, count)
        return file

    with new('no_times.nc', time=None) as file:
        file.createVariable('f', 'f4', ('time', 'z', 'y', 'x'))
    refused(folder / 'no_times.nc', 'dimension time is 0')
    with new('static.nc', time=None) as file:
        file.createVariable('surface', 'f4', ('time', 'y', 'x'))
        file.createVariable('f', 'f4', ('z', 'y', 'x'))[:] = values
    compare(folder / 'static.nc', nrrd(folder, values), [('point:f', 'point:f')])
    with new('records.nc', form='NETCDF3_CLASSIC', z=None) as file:
        file.createVariable('f', 'f4', ('z', 'y', 'x'))[:] = values
    compare(folder / 'records.nc', nrrd(folder, values), [('point:f', 'point:f')])
    with new('types.nc') as file:
        kinds = ('i1', 'u1', 'i2', 'u2', 'i4', 'u4', 'i8', 'u8', 'f4', 'f8')
        for kind in kinds:
            file.createVariable(kind, kind, ('z', 'y', 'x'), zlib=True, shuffle=True, endian='big')[:] = values % 100
        file.createVariable('words', str, ('z', 'y', 'x'))[0, 0, 0] = 'a word'
    found = {a['name']: a['range'] for a in info(folder / 'types.nc')['arrays']}
    assert found == {kind: [0.0, 34.0] for kind in kinds}, found
    for kind in kinds:
        assert near(cut(folder / 'types.nc', kind)['mean'], cut(folder / 'types.nc', 'f8')['mean']), kind
    # Bytes are signed, unless the file says otherwise; whole numbers may be packed, and have times.
    with new('bytes.nc', time=2) as file:
        file.createVariable('z', 'f4', ('z',))[:] = numpy.arange(6)[::-1]
        axis = file.createVariable('time', 'f8', ('time',))
        axis.units, axis[:] = 'hours since 2001-01-01', [6, 12]
        file.createVariable('signed', 'i1', ('time', 'z', 'y', 'x'))[:] = [values / 10 - 50, values / 5 - 100]
        packed = file.createVariable('packed', 'u2', ('time', 'z', 'y', 'x'), fill_value=534)
        packed.set_auto_maskandscale(False)
        packed.scale_factor, packed.add_offset = 0.5, -3.0
        packed[:] = [values, values]
        packed.units = 'K'
        odd = file.createVariable('odd', 'i1', ('time', 'z', 'y', 'x'))
        odd.set_auto_maskandscale(False)
        odd._Unsigned = 'true'
        odd[:] = numpy.stack([values / 2.5] * 2).astype('u1').view('i1')
        file.createVariable('f', 'f4', ('time', 'z', 'y', 'x'))[:] = [values, 2 * values]
    found = {a['name']: a['range'] for a in info(folder / 'bytes.nc')['arrays']}
    assert found == {'signed': [-100.0, 6.0], 'packed': [-3.0, 263.5], 'odd': [0.0, 213.0], 'f': [0.0, 1068.0]}, found
    a, b = cut(folder / 'bytes.nc', 'signed', '--time', 'first'), cut(folder / 'bytes.nc', 'f', '--time', 'first')
    assert abs(a['mean'] - (b['mean'] / 10 - 50)) < 1.0, (a, b)
    with new('late.nc', t=3) as file:
        axis = file.createVariable('t', 'i4', ('t',))
        axis.units, axis[:] = 'days since 2001-01-01', [5, 10, 20]
        file.createVariable('f', 'f4', ('z', 't', 'y', 'x'))[:] = values[:, None] * numpy.arange(3)[:, None, None]
    compare(folder / 'late.nc', nrrd(folder, values), [('point:f', 'point:f')], ['--time', '10'])
    with new('members.nc', member=3) as file:
        file.createVariable('f', 'f4', ('member', 'z', 'y', 'x'))[:] = 0
    refused(folder / 'members.nc', 'f(member, z, y, x) has 4 dimensions', 'ncks -d')
    with netcdf4.Dataset(folder / 'groups.nc', 'w') as file:
        group = file.createGroup('run')
        for side, count in (('z', 6), ('y', 4), ('x', 5)):
            group.createDimension(side, count)
        group.createVariable('f', 'f4', ('z', 'y', 'x'))[:] = values
    refused(folder / 'groups.nc', 'groups of netCDF-4')


def xdmf_types(folder):
    h5py, numpy = need('h5py'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values)
    with h5py.File(folder / 'data.h5', 'w') as file:
        file.create_dataset('big', data=values.astype('>f4'), chunks=(3, 2, 5), compression='gzip', shuffle=True)
        file['half'] = values.astype('f2')
        file['short'] = values.astype('>i2')
        file.create_dataset('never', shape=values.shape, dtype='f4')
    for name in ('big', 'half', 'short', 'never'):
        (folder / f'{name}.xmf').write_text(
            '<Xdmf Version="3.0"><Domain><Grid><Topology TopologyType="3DCoRectMesh" Dimensions="6 4 5"/>'
            '<Geometry GeometryType="ORIGIN_DXDYDZ"><DataItem Dimensions="3">0 0 0</DataItem>'
            '<DataItem Dimensions="3">1 1 1</DataItem></Geometry><Attribute Name="f" Center="Node">'
            f'<DataItem Dimensions="6 4 5" Format="HDF">data.h5:/{name}</DataItem></Attribute></Grid></Domain></Xdmf>')
        if name != 'never':
            compare(folder / f'{name}.xmf', reference, [('point:f', 'point:f')])
    done = subprocess.run([VPROBE, 'info', folder / 'never.xmf'], capture_output=True, encoding='utf-8')
    assert done.returncode == 2 and 'was never written' in done.stderr, done


def vtk_images(folder):
    """Big-endian, packed in many blocks, cells counted from any index, a time among the field data."""
    numpy, vtk, core = need('numpy'), need('vtkmodules.vtkIOXML'), need('vtkmodules.vtkCommonDataModel')
    support, kinds = need('vtkmodules.util.numpy_support'), need('vtkmodules.vtkCommonCore')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 0 5 23\n')
    image = core.vtkImageData()
    image.SetExtent(-2, 2, 3, 6, 10, 15)
    image.SetSpacing(0.5, 1, 2)
    image.SetOrigin(1, 2, 3)
    array = support.numpy_to_vtk(values.ravel(), deep=True)
    array.SetName('f')
    image.GetPointData().AddArray(array)
    time = kinds.vtkDoubleArray()
    time.SetName('TimeValue')
    time.InsertNextValue(7.5)
    image.GetFieldData().AddArray(time)
    for packing in ('ZLib', 'LZ4', 'LZMA'):
        for mode in ('Appended', 'Binary'):
            path = folder / f'{packing}{mode}.vti'
            writer = vtk.vtkXMLImageDataWriter()
            writer.SetFileName(str(path))
            writer.SetInputData(image)
            getattr(writer, f'SetCompressorTypeTo{packing}')()
            getattr(writer, f'SetDataModeTo{mode}')()
            writer.SetByteOrderToBigEndian()
            writer.SetHeaderTypeToUInt64()
            writer.SetBlockSize(128)
            writer.EncodeAppendedDataOff()
            writer.Write()
            compare(path, reference, [('point:f', 'point:f')])
            assert info(path)['times'] == [7.5]


def vtk_without_cells(folder):
    vtk, core = need('vtkmodules.vtkIOXML'), need('vtkmodules.vtkCommonDataModel')
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(folder / 'empty.vtu'))
    writer.SetInputData(core.vtkUnstructuredGrid())
    writer.Write()
    refused(folder / 'empty.vtu', 'nothing to slice')


def gmsh_comments(folder):
    """Comments before all sections, and sizes of 32 bits."""
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mixed_mesh(meshio, numpy)
    meshio.write(folder / 'reference.vtu', mesh)
    meshio.write(folder / 'plain.msh', mesh, file_format='gmsh22', binary=False)
    text = (folder / 'plain.msh').read_text()
    (folder / 'mesh.msh').write_text('$Comments\nby a program\n$EndComments\n' + text)
    compare(folder / 'mesh.msh', folder / 'reference.vtu', [('point:f', 'point:f')])
    (folder / 'narrow.msh').write_text(
        '$MeshFormat\n4.1 0 4\n$EndMeshFormat\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 6\n'
        '$EndNodes\n$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n')
    assert near(cut(folder / 'narrow.msh', None, '--normal', '0', '0', '1', '--origin', '0', '0', '3')['area'], 0.125)


def wedges(folder):
    """Their first three corners are seen from inside in Gmsh and GAMBIT, from outside in VTK: none is inside out."""
    nodes = ['0 0 0', '1 0 0', '0 1 0', '0 0 1', '1 0 1', '0 1 1']
    listed = '\n'.join(f'{i} {node}' for i, node in enumerate(nodes, 1))
    (folder / 'wedge.msh').write_text(f'$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n{listed}\n$EndNodes\n'
                                      '$Elements\n1\n1 6 2 1 1 1 2 3 4 5 6\n$EndElements\n')
    (folder / 'wedge.neu').write_text(
        '        CONTROL INFO 1.2.1\n** GAMBIT NEUTRAL FILE\nwedge\nPROGRAM: Gambit VERSION: 1.2.1\n4 Jan 2000\n'
        '     NUMNP     NELEM     NGRPS    NBSETS     NDFCD     NDFVL\n 6 1 0 0 3 3\nENDOFSECTION\n'
        f'   NODAL COORDINATES 1.2.1\n{listed}\nENDOFSECTION\n      ELEMENTS/CELLS 1.2.1\n 1 5 6 1 2 3 4 5 6\n'
        'ENDOFSECTION\n')
    for name in ('wedge.msh', 'wedge.neu'):
        done = subprocess.run([VPROBE, 'check', folder / name], capture_output=True, encoding='utf-8')
        assert done.returncode == 0 and 'no fault' in done.stdout, done


def tiff_orders(folder):
    tifffile, numpy = need('tifffile'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values)
    for name, options in (('big', {'byteorder': '>'}), ('bigtiff', {'bigtiff': True}),
                          ('both', {'byteorder': '>', 'bigtiff': True})):
        tifffile.imwrite(folder / f'{name}.tif', values.astype('u2'), **options)
        compare(folder / f'{name}.tif', reference, [('point:values', 'point:f')])


def other_codes(folder):
    meshio, numpy = need('meshio'), need('numpy')
    meshio.write(folder / 'mesh.inp', mixed_mesh(meshio, numpy), file_format='abaqus')
    refused(folder / 'mesh.inp', 'Abaqus')


def metaimage_longs(folder):
    """MetaIO's longs have 4 bytes. VTK's reader takes them for 8."""
    numpy = need('numpy')
    head = ('ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = 5 4 6\n'
            'ElementSpacing = 1 1 1\nElementType = {}\nElementDataFile = LOCAL\n')
    for name, kind in (('MET_LONG', '<i4'), ('MET_ULONG', '<u4')):
        values = (2 ** 24 + 1 + numpy.arange(120)).astype(kind)
        (folder / 'long.mha').write_bytes(head.format(name).encode() + values.tobytes())
        found = info(folder / 'long.mha')['arrays'][0]
        assert found['range'] == [2 ** 24 + 1, 2 ** 24 + 120], found
    (folder / 'long.mha').write_bytes(head.format('MET_LONG_LONG').encode() +
                                      (2 ** 40 + numpy.arange(120)).astype('<i8').tobytes())
    found = info(folder / 'long.mha')['arrays'][0]
    assert found['type'] == 'int64' and found['range'] == [2 ** 40, 2 ** 40 + 119], found


def half_floats(folder):
    tifffile, numpy = need('tifffile'), need('numpy')
    tifffile.imwrite(folder / 'half.tif', lattice(numpy).astype('f2'))
    refused(folder / 'half.tif', 'floats of 16 bits', 'save it with floats of 32 bits')


def kinds_of_vtkhdf(folder):
    h5py, numpy = need('h5py'), need('numpy')
    for kind, remedy in (('OverlappingAMR', '.vthb'), ('MultiBlockDataSet', '.vtm'), ('HyperTreeGrid', '.htg'),
                         ('PolyData', 'nothing to slice')):
        for text in (numpy.bytes_(kind), kind):  # a text of one length, and one of any length
            with h5py.File(folder / 'kind.vtkhdf', 'w') as file:
                group = file.create_group('VTKHDF')
                group.attrs['Version'] = [2, 0]
                group.attrs['Type'] = text
            refused(folder / 'kind.vtkhdf', kind, remedy)


def cgns_of_faces(folder):
    """A cube whose cell is told by the two sides of its faces alone."""
    h5py, numpy = need('h5py'), need('numpy')
    codes = {'i4': b'I4', 'f4': b'R4', 'f8': b'R8', 'i1': b'C1'}

    def node(parent, name, label, data=None):
        group = parent.create_group(name, track_order=True) if name else parent
        for key, value, length in (('name', name or 'HDF5 MotherNode', 33), ('label', label, 33)):
            group.attrs.create(key, numpy.bytes_(value.encode().ljust(length, b'\0')), dtype=f'S{length}')
        kind = b'MT'
        if data is not None:
            array = numpy.asarray(data)
            group.create_dataset(' data', data=array)
            kind = codes[array.dtype.str[1:]]
        group.attrs.create('type', numpy.bytes_(kind + b'\0'), dtype='S3')
        return group

    def text(words):
        return numpy.frombuffer(words.encode(), 'i1')

    with h5py.File(folder / 'faces.cgns', 'w', track_order=True) as file:
        root = node(file, '', 'Root Node of HDF5 File')
        root.create_dataset(' format', data=text('IEEE_LITTLE_32\0'))
        root.create_dataset(' hdf5version', data=text('HDF5 Version 1.10.8'.ljust(33, '\0')))
        node(root, 'CGNSLibraryVersion', 'CGNSLibraryVersion_t', numpy.array([3.3], 'f4'))
        base = node(root, 'Base', 'CGNSBase_t', numpy.array([3, 3], 'i4'))
        zone = node(base, 'Zone', 'Zone_t', numpy.array([[8], [1], [0]], 'i4'))
        node(zone, 'ZoneType', 'ZoneType_t', text('Unstructured'))
        places = node(zone, 'GridCoordinates', 'GridCoordinates_t')
        for axis, name in enumerate('XYZ'):
            node(places, f'Coordinate{name}', 'DataArray_t',
                 numpy.array([float(point >> axis & 1) for point in range(8)], 'f8'))
        faces = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
        section = node(zone, 'Faces', 'Elements_t', numpy.array([22, 0], 'i4'))
        node(section, 'ElementRange', 'IndexRange_t', numpy.array([1, 6], 'i4'))
        node(section, 'ElementConnectivity', 'DataArray_t',
             numpy.array([number for face in faces for number in (4, *face)], 'i4'))
        node(section, 'ParentElements', 'DataArray_t', numpy.array([[1] * 6, [0] * 6], 'i4'))
    refused(folder / 'faces.cgns', 'ParentElements', 'NFACE_n')


CASES = [metaimage_longs, counts_that_lie, deep_trees, exodus_by_meshio, exodus_without_values, numpy_types,
         netcdf_sides, nrrd_directions, xdmf_types, vtk_images, vtk_without_cells, gmsh_comments, wedges, tiff_orders,
         other_codes, half_floats, kinds_of_vtkhdf, cgns_of_faces]
