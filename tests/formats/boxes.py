"""Codes that refine by boxes: written here after what VTK's readers take, and compared with the same data in a file of
VTK, and with what those readers say of them."""
from against import cut, info, lattice, near, need


def cells_of_image(folder, values, spacing, origin, name='g'):
    """A file of VTK with cells; `values` by z, y, x."""
    path = folder / 'reference.vtk'
    sides = ' '.join(str(count + 1) for count in values.shape[::-1])
    path.write_text(f'# vtk DataFile Version 3.0\ncells\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS {sides}\n'
                    f'ORIGIN {" ".join(map(str, origin))}\nSPACING {" ".join(map(str, spacing))}\n'
                    f'CELL_DATA {values.size}\nSCALARS {name} double 1\nLOOKUP_TABLE default\n'
                    + '\n'.join(repr(float(x)) for x in values.ravel()) + '\n')
    return path


def same_cut(path, name, reference, named, *options):
    a, b = cut(path, name, *options), cut(reference, named)
    for key in ('area', 'mean', 'min', 'max'):
        assert near(a[key], b[key], 1e-5), (key, a[key], b[key])


def refined(numpy):
    """Values of 4 x 4 x 4 cells, of 4 x 8 x 8 halves of those in the lower half along x, and all in halves."""
    coarse = lattice(numpy)[:4, :4, :4]
    fine = numpy.arange(4 * 8 * 8, dtype=float).reshape(8, 8, 4) + 1000
    whole = coarse.repeat(2, 0).repeat(2, 1).repeat(2, 2)
    whole[:, :, :4] = fine
    return coarse, fine, whole


def vtk_ranges(reader, name):
    """The least and the greatest value that a reader of VTK gives, of all of its blocks."""
    reader.UpdateInformation()
    selection = reader.GetCellDataArraySelection() if hasattr(reader, 'GetCellDataArraySelection') else None
    if selection:
        selection.EnableAllArrays()
    reader.Update()
    iterator = reader.GetOutputDataObject(0).NewIterator()
    lows, highs = [], []
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        array = iterator.GetCurrentDataObject().GetCellData().GetArray(name)
        if array:
            lows.append(array.GetRange()[0])
            highs.append(array.GetRange()[1])
        iterator.GoToNextItem()
    return min(lows), max(highs)


def enzo(folder):
    h5py, numpy, vtk = need('h5py'), need('numpy'), need('vtkmodules.vtkIOAMR')
    coarse, fine, whole = refined(numpy)
    text = ''
    grids = (((4, 4, 4), (0, 0, 0), (2, 2, 2)), ((4, 8, 8), (0, 0, 0), (1, 2, 2)))
    for number, (cells, left, right) in enumerate(grids, 1):
        last = ' '.join(str(2 + count) for count in cells)
        text += (f'\nGrid = {number}\nTask = 0\nGridRank = 3\nGridDimension = {" ".join(str(6 + c) for c in cells)}\n'
                 f'GridStartIndex = 3 3 3\nGridEndIndex = {last}\nGridLeftEdge = {" ".join(map(str, left))}\n'
                 f'GridRightEdge = {" ".join(map(str, right))}\nTime = 0.5\nNumberOfBaryonFields = 1\nFieldType = 0\n'
                 f'BaryonFileName = ./DD0002.grid000{number}\nNumberOfParticles = 0\n'
                 f'Pointer: Grid[{number}]->NextGridThisLevel = 0\n'
                 f'Pointer: Grid[{number}]->NextGridNextLevel = {2 if number == 1 else 0}\n')
        with h5py.File(folder / f'DD0002.grid000{number}', 'w') as file:
            file['Density'] = coarse if number == 1 else fine
            file['particle_mass'] = numpy.ones(7)
    path = folder / 'DD0002.hierarchy'
    path.write_text(text)
    (folder / 'DD0002').write_text('InitialTime = 0.5\nTopGridRank = 3\n')
    (folder / 'DD0002.boundary').write_text('BoundaryRank = 3\n')
    found = info(path)
    assert found['times'] == [0.5] and [a['name'] for a in found['arrays']] == ['Density'], found
    assert found['grid']['cells'] == 32 + 256, found['grid']
    same_cut(path, 'cell:Density', cells_of_image(folder, whole, (0.25,) * 3, (0, 0, 0)), 'cell:g')
    reader = vtk.vtkAMREnzoReader()
    reader.SetFileName(str(path))
    reader.SetMaxLevel(5)
    theirs = vtk_ranges(reader, 'Density')  # with the hidden cells
    assert near(theirs[1], found['arrays'][0]['range'][1]), (theirs, found['arrays'])


def flash(folder):
    h5py, numpy = need('h5py'), need('numpy')
    coarse, _, whole = refined(numpy)
    # One parent, and its eight children of 4 x 4 x 4 cells, in single precision.
    boxes = [(0, 2, 0, 2, 0, 2)] + [(i, i + 1, j, j + 1, k, k + 1) for k in (0, 1) for j in (0, 1) for i in (0, 1)]
    values = [coarse] + [whole[4 * k:4 * k + 4, 4 * j:4 * j + 4, 4 * i:4 * i + 4]
                         for k in (0, 1) for j in (0, 1) for i in (0, 1)]
    tree = -numpy.ones((9, 15), dtype='i4')
    tree[0, 7:] = range(2, 10)
    tree[1:, 6] = 1
    path = folder / 'run_hdf5_plt_cnt_0000'
    with h5py.File(path, 'w') as file:
        file['gid'] = tree
        file['node type'] = numpy.array([2] + [1] * 8, dtype='i4')
        file['refine level'] = numpy.array([1] + [2] * 8, dtype='i4')
        file['bounding box'] = numpy.array(boxes, dtype='f4').reshape(9, 3, 2)
        file['coordinates'] = numpy.array([[(b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2] for b in boxes])
        file['block size'] = numpy.array([[b[1] - b[0], b[3] - b[2], b[5] - b[4]] for b in boxes], dtype='f8')
        file['unknown names'] = numpy.array([[b'dens'], [b'temp']], dtype='S4')
        file['dens'] = numpy.array(values, dtype='f4')
        file['temp'] = 2 * numpy.array(values, dtype='>f8')
        table = [('name', 'S80'), ('value', 'f8')]
        file['real scalars'] = numpy.array([(b'time'.ljust(80), 0.25), (b'dt'.ljust(80), 0.5)], dtype=table)
        file['integer scalars'] = numpy.array([(name.ljust(80), n) for name, n in (
            (b'nxb', 4), (b'nyb', 4), (b'nzb', 4), (b'globalnumblocks', 9), (b'nstep', 3))],
            dtype=[('name', 'S80'), ('value', 'i4')])
        file['string scalars'] = numpy.array([(b'geometry', b'cartesian')], dtype=[('name', 'S80'), ('value', 'S80')])
        file['sim info'] = numpy.array([(9,)], dtype=[('file format version', 'i4')])
    found = info(path)
    assert found['times'] == [0.25] and [a['name'] for a in found['arrays']] == ['dens', 'temp'], found
    assert found['grid']['cells'] == 512, found['grid']
    assert not found.get('warnings'), found['warnings']
    reference = cells_of_image(folder, whole, (0.25,) * 3, (0, 0, 0))
    same_cut(path, 'cell:dens', reference, 'cell:g')
    assert near(cut(path, 'cell:temp')['mean'], 2 * cut(reference, 'cell:g')['mean'])


def velodyne(folder):
    h5py, numpy = need('h5py'), need('numpy')
    coarse, fine, whole = refined(numpy)
    path = folder / 'run.xamr'
    with h5py.File(path, 'w') as file:
        root = file.create_group('AMR')
        root.attrs['BlockDims'] = numpy.array([2, 4, 4], dtype='i4')
        root.attrs['RootDX'] = [0.5, 0.5, 0.5]
        root.attrs['SimTime'] = 3.0
        # A leaf of level 1 at the greater x, and one of level 2, whose cells are twice as many, at the lesser.
        root['Leaves/Level'] = numpy.array([1], dtype='i4')
        root['Leaves/X0'] = numpy.array([[1.0, 0.0, 0.0]])
        root['Leaves/p'] = coarse[None, :, :, 2:, None]
        root['FullLeaves/Level'] = numpy.array([2], dtype='i4')
        root['FullLeaves/X0'] = numpy.array([[0.0, 0.0, 0.0]])
        root['FullLeaves/p'] = fine[None, ..., None]
        root['FullLeaves/v'] = numpy.stack([fine, -fine, fine], axis=-1)[None]
        root['Leaves/v'] = numpy.zeros((1, 4, 4, 2, 3))
    found = info(path)
    assert found['times'] == [3.0] and found['grid']['cells'] == 32 + 256, found
    assert {a['name']: a['components'] for a in found['arrays']} == {'p': 1, 'v': 3}, found['arrays']
    same_cut(path, 'cell:p', cells_of_image(folder, whole, (0.25,) * 3, (0, 0, 0)), 'cell:g')


def amrex(folder):
    """A fine box over the half of a coarse one, with two components and a layer of ghost cells."""
    numpy = need('numpy')
    coarse, fine, whole = refined(numpy)
    plot = folder / 'plt00010'
    boxes = [(coarse, '((0,0,0) (3,3,3) (0,0,0))', 4), (fine, '((0,0,0) (3,7,7) (0,0,0))', 8)]
    for level, (values, box, _) in enumerate(boxes):
        (plot / f'Level_{level}').mkdir(parents=True)
        grown = numpy.pad(values, 1, constant_values=-5)
        grown_box = box.replace('(0,0,0) (', '(-1,-1,-1) (', 1).replace('3,3,3', '4,4,4').replace('3,7,7', '4,8,8')
        data = (f'FAB ((8, (64 11 52 0 1 12 0 1023)),(8, (8 7 6 5 4 3 2 1))){grown_box} 2\n'.encode()
                + grown.astype('<f8').tobytes() + (2 * grown).astype('<f8').tobytes())
        (plot / f'Level_{level}' / 'Cell_D_00000').write_bytes(data)
        (plot / f'Level_{level}' / 'Cell_H').write_text(
            f'1\n1\n2\n1\n(1 0\n{box}\n)\n1\nFabOnDisk: Cell_D_00000 0\n\n1,2\n0.0,0.0,\n')
    (plot / 'Header').write_text(
        'HyperCLaw-V1.1\n2\ndensity\nTemp\n3\n0.125\n1\n0 0 0\n2 2 2\n2\n((0,0,0) (3,3,3) (0,0,0)) '
        '((0,0,0) (7,7,7) (0,0,0))\n10 20\n0.5 0.5 0.5\n0.25 0.25 0.25\n0\n0\n'
        '0 1 0.125\n10\n0 2\n0 2\n0 2\nLevel_0/Cell\n1 1 0.125\n20\n0 1\n0 2\n0 2\nLevel_1/Cell\n')
    found = info(plot)
    assert found['times'] == [0.125] and found['grid']['cells'] == 32 + 256, found
    assert [a['name'] for a in found['arrays']] == ['density', 'Temp'], found['arrays']
    reference = cells_of_image(folder, whole, (0.25,) * 3, (0, 0, 0))
    same_cut(plot, 'cell:density', reference, 'cell:g')
    assert near(cut(plot, 'cell:Temp')['mean'], 2 * cut(reference, 'cell:g')['mean'])


CASES = [enzo, flash, velodyne, amrex]
