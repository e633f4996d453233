"""Meshes that other programs write."""
import os
import shutil
import subprocess

from against import Missing, by_meshio, compare, cut, info, lattice, mixed_mesh, near, need, nrrd, tetrahedra


def gmsh_22_text(folder):
    by_meshio(folder, 'mesh.msh', file_format='gmsh22', binary=False)


def gmsh_22_binary(folder):
    by_meshio(folder, 'mesh.msh', file_format='gmsh22', binary=True)


def by_meshio_41(folder, binary):
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mixed_mesh(meshio, numpy)
    mesh.cells, mesh.cell_data['g'] = mesh.cells[1:], mesh.cell_data['g'][1:]  # meshio writes one type to an entity
    meshio.write(folder / 'reference.vtu', mesh)
    mesh.point_data['gmsh:dim_tags'] = numpy.array([[3, 1]] * len(mesh.points))
    for tag in ('gmsh:physical', 'gmsh:geometrical'):
        mesh.cell_data[tag] = [numpy.ones(len(block.data), dtype='i4') for block in mesh.cells]
    meshio.write(folder / 'mesh.msh', mesh, file_format='gmsh', binary=binary)
    compare(folder / 'mesh.msh', folder / 'reference.vtu', [(a, a) for a in ('point:f', 'point:v', 'cell:g')])


def gmsh_41_text(folder):
    by_meshio_41(folder, False)


def gmsh_41_binary(folder):
    by_meshio_41(folder, True)


GEOMETRY = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 2, 3};
Sphere(2) = {2, 1, 1, 0.8};
Mesh.CharacteristicLengthMax = 0.6;
Mesh.SaveAll = 1;
"""


def by_gmsh(folder, version, binary, order):
    """The same mesh by Gmsh's own writers: .msh, and VTK's legacy format. Their surfaces are left out."""
    if not shutil.which('gmsh'):
        raise Missing('gmsh')
    geometry = folder / 'box.geo'
    geometry.write_text(GEOMETRY)
    command = ['gmsh', '-3', '-order', str(order), str(geometry), '-v', '0']
    extra = ['-bin'] if binary else []
    subprocess.run([*command, '-format', f'msh{version}', *extra, '-o', folder / 'mesh.msh'], check=True)
    subprocess.run([*command, '-format', 'vtk', '-o', folder / 'reference.vtk'], check=True)
    ours, wanted = info(folder / 'mesh.msh'), info(folder / 'reference.vtk')
    assert ours['grid'] == wanted['grid'], (ours['grid'], wanted['grid'])
    a, b = cut(folder / 'mesh.msh', 'cell:gmsh:geometrical'), cut(folder / 'reference.vtk', None)
    assert near(a['area'], b['area'], 1e-6), (a['area'], b['area'])
    assert (a['min'], a['max']) == (1, 2), (a['min'], a['max'])


def gmsh_own(folder):
    for version in (22, 40, 41):
        for binary in (False, True):
            for order in (1, 2):
                if version == 40 and binary:
                    continue  # which gmsh 4.8 itself refuses
                place = folder / f'{version}-{binary}-{order}'
                place.mkdir()
                by_gmsh(place, version, binary, order)


def tecplot(folder):
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mixed_mesh(meshio, numpy)
    mesh.point_data.pop('v')  # meshio leaves vectors out of Tecplot files
    by_meshio(folder, 'mesh.dat', arrays=('point:f', 'cell:g'), mesh=mesh)


def xdmf(folder):
    for form in ('XML', 'HDF', 'Binary'):
        if form == 'HDF':
            need('h5py')
        place = folder / form
        place.mkdir()
        by_meshio(place, 'mesh.xdmf', data_format=form)


def xdmf_series(folder):
    meshio, numpy = need('meshio'), need('numpy')
    need('h5py')
    mesh = mixed_mesh(meshio, numpy)
    here = os.getcwd()
    os.chdir(folder)  # where meshio puts the HDF5 file
    try:
        with meshio.xdmf.TimeSeriesWriter('series.xdmf') as writer:
            writer.write_points_cells(mesh.points, mesh.cells)
            for time in (0.0, 0.5, 2.0):
                writer.write_data(time, point_data={'f': mesh.point_data['f'] * (1 + time)})
    finally:
        os.chdir(here)
    reference = folder / 'reference.vtu'
    meshio.write(reference, mesh)
    assert info(folder / 'series.xdmf')['times'] == [0.0, 0.5, 2.0]
    compare(folder / 'series.xdmf', reference, [('point:f', 'point:f')], ['--time', 'first'])
    top = info(folder / 'series.xdmf')['arrays'][0]['range'][1]
    assert near(top, 3 * mesh.point_data['f'].max()), top


def xdmf_lattice(folder):
    h5py, numpy = need('h5py'), need('numpy')
    values = lattice(numpy)
    reference = nrrd(folder, values, 'spacings: 0.5 1 2\naxis mins: 10 20 30\n')
    with h5py.File(folder / 'data.h5', 'w') as file:
        file['group/f'] = values
    (folder / 'image.xmf').write_text("""<?xml version="1.0" ?>
<!DOCTYPE Xdmf SYSTEM "Xdmf.dtd" []>
<Xdmf Version="2.0"><Domain><Grid Name="box" GridType="Uniform">
<Topology TopologyType="3DCoRectMesh" Dimensions="6 4 5"/>
<Geometry GeometryType="ORIGIN_DXDYDZ">
<DataItem Dimensions="3" Format="XML">30 20 10</DataItem><DataItem Dimensions="3" Format="XML">2 1 0.5</DataItem>
</Geometry>
<Attribute Name="f" AttributeType="Scalar" Center="Node">
<DataItem Dimensions="6 4 5" NumberType="Float" Precision="8" Format="HDF">data.h5:/group/f</DataItem>
</Attribute></Grid></Domain></Xdmf>
""")
    compare(folder / 'image.xmf', reference, [('point:f', 'point:f')])


def avs_ucd(folder):
    meshio, numpy = need('meshio'), need('numpy')
    by_meshio(folder, 'mesh.avs', mesh=mixed_mesh(meshio, numpy))


def med(folder):
    need('h5py')
    by_meshio(folder, 'mesh.med')


def med_tensors(folder):
    """Components of tensors have their places by their names, as code_aster writes them."""
    meshio, numpy, h5py = need('meshio'), need('numpy'), need('h5py')
    path = folder / 'tensor.med'
    corners = [(i & 1, i >> 1 & 1, i >> 2) for i in (0, 1, 3, 2, 4, 5, 7, 6)]
    mesh = meshio.Mesh(numpy.array(corners, float), [('hexahedron', [range(8)])],
                       point_data={'s': numpy.tile(numpy.arange(1.0, 7.0), (8, 1))})
    mesh.write(path)
    for names, wanted in ((('SIXX', 'SIYY', 'SIZZ', 'SIXY', 'SIXZ', 'SIYZ'), dict(xx=1, yy=2, zz=3, xy=4, xz=5, yz=6)),
                          (('XZ', 'YZ', 'XY', 'ZZ', 'YY', 'XX'), dict(xz=1, yz=2, xy=3, zz=4, yy=5, xx=6)),
                          (('a', 'b', 'c', 'd', 'e', 'f'), dict(xx=1, yy=2, zz=3, xy=4, yz=5, xz=6))):
        with h5py.File(path, 'r+') as file:
            file['CHA/s'].attrs['NOM'] = numpy.bytes_(''.join(name.ljust(16) for name in names))
        for component, value in wanted.items():
            found = cut(path, 's', '--component', component)['mean']
            assert near(found, value), (names, component, found)


def gambit(folder):
    """After the GAMBIT User's Guide, appendix C."""
    meshio, numpy = need('meshio'), need('numpy')
    mesh = tetrahedra(meshio, numpy)
    meshio.write(folder / 'reference.vtu', mesh)
    cells = mesh.cells[0].data
    lines = ['        CONTROL INFO 2.4.6', '** GAMBIT NEUTRAL FILE', 'tetrahedra',
             'PROGRAM:                Gambit     VERSION:  2.4.6', ' 1 Jan 2020    12:00:00',
             '     NUMNP     NELEM     NGRPS    NBSETS     NDFCD     NDFVL',
             f'{len(mesh.points):10}{len(cells):10}         2         0         3         3', 'ENDOFSECTION',
             '   NODAL COORDINATES 2.4.6']
    lines += [f'{i + 1:10}{x:20.11e}{y:20.11e}{z:20.11e}' for i, (x, y, z) in enumerate(mesh.points)]
    lines += ['ENDOFSECTION', '      ELEMENTS/CELLS 2.4.6']
    lines += [f'{i + 1:8}  6  4 ' + ''.join(f'{n + 1:8}' for n in cell) for i, cell in enumerate(cells)]
    lines.append('ENDOFSECTION')
    half = len(cells) // 2
    for group, elements in ((1, range(half)), (2, range(half, len(cells)))):
        lines += ['       ELEMENT GROUP 2.4.6',
                  f'GROUP:{group:11} ELEMENTS:{len(elements):11} MATERIAL:{group + 3:11} NFLAGS:          1',
                  f'group {group}', '       0', *(f'{e + 1:8}' for e in elements), 'ENDOFSECTION']
    path = folder / 'mesh.neu'
    path.write_text('\n'.join(lines) + '\n')
    compare(path, folder / 'reference.vtu', [])
    a, b = cut(path, 'cell:Material Type'), cut(folder / 'reference.vtu', 'cell:g')
    assert near(a['area'], b['area'], 1e-6) and (a['min'], a['max']) == (4, 5), (a, b)


def fluent(folder):
    """After the Fluent User's Guide, appendix B: each face once, its corners turning right about the way into c0."""
    meshio, numpy = need('meshio'), need('numpy')
    mesh = tetrahedra(meshio, numpy)
    meshio.write(folder / 'reference.vtu', mesh)
    faces = {}
    for c, cell in enumerate(mesh.cells[0].data):
        a, b, e, tip = mesh.points[cell]
        if numpy.dot(numpy.cross(b - a, e - a), tip - a) < 0:
            cell = cell[[0, 2, 1, 3]]
        for inward in ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)):
            corners = [int(cell[i]) for i in inward]
            faces.setdefault(tuple(sorted(corners)), [corners]).append(c)
    inside = [f for f in faces.values() if len(f) == 3]
    outside = [f for f in faces.values() if len(f) == 2]
    cells = len(mesh.cells[0].data)

    def listed(some):
        return '\n'.join(' '.join(f'{n + 1:x}' for n in f[0]) + f' {f[1] + 1:x} {f[2] + 1 if len(f) == 3 else 0:x}'
                         for f in some)
    nodes = '\n'.join(' '.join(repr(float(x)) for x in point) for point in mesh.points)
    count = len(mesh.points)
    (folder / 'run.cas').write_text(
        f'(0 "tetrahedra")\n(2 3)\n(10 (0 1 {count:x} 0 3))\n(10 (1 1 {count:x} 1 3)(\n{nodes}))\n'
        f'(12 (0 1 {cells:x} 0))\n(12 (2 1 {cells:x} 1 2))\n(13 (0 1 {len(faces):x} 0))\n'
        f'(13 (3 1 {len(inside):x} 2 3)(\n{listed(inside)}))\n'
        f'(13 (4 {len(inside) + 1:x} {len(faces):x} 3 3)(\n{listed(outside)}))\n')
    values = '\n'.join(repr(float(x)) for x in mesh.cell_data['g'][0])
    (folder / 'run.dat').write_text(f'(0 "values")\n(33 ({cells} {len(faces)} {count}))\n'
                                    f'(300 (3 2 1 0 0 1 {cells})(\n{values}))\n')
    compare(folder / 'run.cas', folder / 'reference.vtu', [('cell:TEMPERATURE', 'cell:g')])
    vtk = need('vtkmodules.vtkIOGeometry')  # VTK's reader agrees where it can
    reader = vtk.vtkFLUENTReader()
    reader.SetFileName(str(folder / 'run.cas'))
    reader.Update()
    block = reader.GetOutput().GetBlock(0)
    assert block.GetNumberOfCells() == cells, block
    ours = [a for a in info(folder / 'run.cas')['arrays'] if a['name'] == 'TEMPERATURE'][0]['range']
    theirs = block.GetCellData().GetArray('TEMPERATURE').GetRange()
    assert near(ours[0], theirs[0]) and near(ours[1], theirs[1]), (ours, theirs)


CASES = [gmsh_22_text, gmsh_22_binary, gmsh_41_text, gmsh_41_binary, gmsh_own, tecplot, avs_ucd, med, med_tensors, gambit, fluent,
         xdmf, xdmf_series, xdmf_lattice]
