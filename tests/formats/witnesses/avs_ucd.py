#!/usr/bin/env python3
"""AVS UCD files in text, written by meshio and read by vprobe.

usage: avs_ucd.py VPROBE [FIRST-SEED COUNT]

Meshes of hexahedra, wedges, pyramids and tetrahedra with arrays of points, nan and inf among their values, and the
materials of the cells, the only array of cells that meshio writes. What vprobe converts is compared with what was
written: meshio 5.3 cannot read its own files. VPROBE_LONG asks for 500 files. Exit code 77 where meshio or VTK's
modules are missing.
"""
import pathlib
import random
import subprocess
import sys
import tempfile

try:
    import meshio
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError as error:
    print(f'left out: {error}')
    sys.exit(77)

from common import how_many

VPROBE = sys.argv[1]
CORNERS = {'hexahedron': (0, 1, 3, 2, 4, 5, 7, 6), 'wedge': (0, 1, 2, 4, 5, 6), 'tetra': (0, 1, 2, 4),
           'pyramid': (0, 1, 3, 2, 4)}


def mesh_of(seed):
    """Cells of several kinds, each in a unit cube of its own, some of which share corners."""
    pick, numbers = random.Random(seed), numpy.random.default_rng(seed)
    sides = [pick.randint(1, 3) + 1 for _ in range(3)]
    nx, ny, nz = sides
    places = numpy.array([(i, j, k) for k in range(nz) for j in range(ny) for i in range(nx)], float)
    places = places * numbers.uniform(0.1, 10, 3) + numbers.uniform(-1e3, 1e3, 3)
    blocks = {}
    for k in range(nz - 1):
        for j in range(ny - 1):
            for i in range(nx - 1):
                corners = [i + a + nx * (j + b + ny * (k + c)) for c in (0, 1) for b in (0, 1) for a in (0, 1)]
                kind = pick.choice(list(CORNERS))
                blocks.setdefault(kind, []).append([corners[p] for p in CORNERS[kind]])

    def values(count):
        array = numbers.uniform(-1, 1, (count, pick.choice([1, 1, 2, 3]))) * 10.0 ** pick.randint(-100, 100)
        array[numbers.random(array.shape) < 0.1] = pick.choice([numpy.nan, numpy.inf, -numpy.inf, 0.0])
        return array[:, 0] if array.shape[1] == 1 else array

    cells = [(kind, numpy.array(ids)) for kind, ids in blocks.items()]
    point_data = {f'p{i}': values(len(places)) for i in range(pick.randint(0, 3))}
    materials = [numbers.integers(0, 9, len(ids)) for _, ids in cells]
    return meshio.Mesh(places, cells, point_data=point_data, cell_data={'avsucd:material': materials})


def same(ours, wanted, what):
    wanted = numpy.asarray(wanted, float)
    assert ours.shape == wanted.shape, (what, ours.shape, wanted.shape)
    near = (ours == wanted) | ((ours != ours) & (wanted != wanted))
    near |= numpy.isclose(ours, wanted, rtol=1e-14, atol=0)
    assert near.all(), (what, ours[~near][:4], wanted[~near][:4])


def compare(seed, folder):
    path, out = folder / 'f.inp', folder / 'f.vtu'
    witness = mesh_of(seed)
    meshio.write(path, witness, file_format='avsucd')
    done = subprocess.run([VPROBE, 'convert', path, '-o', out], capture_output=True, encoding='utf-8')
    assert done.returncode == 0, done.stderr
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(out))
    reader.Update()
    grid = reader.GetOutput()
    same(vtk_to_numpy(grid.GetPoints().GetData()), witness.points, 'places')
    ours = [[ids.GetId(k) for k in range(ids.GetNumberOfIds())]
            for ids in (grid.GetCell(c).GetPointIds() for c in range(grid.GetNumberOfCells()))]
    theirs = [list(map(int, corners)) for block in witness.cells for corners in block.data]
    for a, b in zip(ours, theirs, strict=True):
        # meshio mirrors tetrahedra, which VTK's reader leaves as they are.
        assert a == b or (len(a) == 4 and sorted(a) == sorted(b)), ('cells', a, b)
    for name, values in witness.point_data.items():
        same(vtk_to_numpy(grid.GetPointData().GetArray(name)), values, name)
    materials = numpy.concatenate(witness.cell_data['avsucd:material'])
    same(vtk_to_numpy(grid.GetCellData().GetArray('material')), materials, 'material')


def main():
    first, count = (int(word) for word in sys.argv[2:4]) if len(sys.argv) > 3 else \
        (1, how_many(10))
    failed = 0
    for seed in range(first, first + count):
        with tempfile.TemporaryDirectory(prefix='vprobe-ucd-') as folder:
            try:
                compare(seed, pathlib.Path(folder))
            except AssertionError as error:
                failed += 1
                print(f'seed {seed}: FAILED: {error}')
    print(f'{count - failed} of {count} files as meshio wrote them')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
