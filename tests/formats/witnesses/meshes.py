#!/usr/bin/env python3
"""Random meshes by meshio in the formats that it and vprobe know: read by both, values and places compared.

usage: meshes.py VPROBE [FIRST-SEED COUNT]

Gmsh 2.2 and 4.1, XDMF, MED, Exodus, AVS UCD, VTK legacy and XML, and Tecplot, in text and binary; tetrahedra, pyramids,
wedges and hexahedra, of second order too where the format has them; values of points and cells. Where meshio cannot
read what it writes, the mesh that was written stands for it. What meshio calls CGNS has no labels, so no other program reads
it. Seeds make the files. VPROBE_LONG asks for 500. Exit code 77 where meshio or VTK's module is missing.
"""
import contextlib
import io
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import warnings

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
LINEAR, CURVED = ('tetra', 'pyramid', 'wedge', 'hexahedron'), ('tetra10', 'hexahedron20')
# Ending, options of meshio, types of cells, and whether vectors are kept.
FORMATS = [('msh', {'file_format': 'gmsh22', 'binary': False}, LINEAR + CURVED, True),
           ('msh', {'file_format': 'gmsh22', 'binary': True}, LINEAR + CURVED, True),
           ('msh', {'file_format': 'gmsh', 'binary': False}, LINEAR + CURVED, True),
           ('msh', {'file_format': 'gmsh', 'binary': True}, LINEAR + CURVED, True),
           ('xdmf', {'data_format': 'XML'}, LINEAR + CURVED, True),
           ('xdmf', {'data_format': 'Binary'}, LINEAR + CURVED, True),
           ('xdmf', {'data_format': 'HDF'}, LINEAR + CURVED, True), ('med', {}, LINEAR + CURVED, True),
           ('exo', {}, LINEAR + CURVED, False), ('avs', {}, LINEAR, True), ('dat', {}, LINEAR, False),
           ('vtk', {'binary': False}, LINEAR + CURVED, True), ('vtk', {'binary': True}, LINEAR + CURVED, True),
           ('vtu', {'binary': False}, LINEAR + CURVED, True),
           ('vtu', {'binary': True, 'compression': 'zlib'}, LINEAR + CURVED, True),
           ('vtu', {'binary': True, 'compression': 'lzma'}, LINEAR + CURVED, True),
           ('vtu', {'binary': True, 'compression': None}, LINEAR + CURVED, True)]
EDGES = {'tetra10': [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)],
         'hexahedron20': [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4),
                          (0, 4), (1, 5), (2, 6), (3, 7)]}
CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
PARTS = {'hexahedron': [range(8)], 'wedge': [(0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)],
         'tetra': [(0, 1, 2, 5), (0, 2, 3, 7), (0, 5, 7, 4), (2, 7, 5, 6), (0, 2, 7, 5)],
         'pyramid': [(0, 1, 2, 3, 4), (1, 5, 6, 2, 4), (2, 6, 7, 3, 4)]}


def make_mesh(rand, numbers, types, one_type):
    """Cubes in a row, each of one type of cells."""
    kinds = [rand.choice(types)] if one_type else rand.sample(types, rand.randint(1, len(types)))
    points, blocks = [], []
    for at, kind in enumerate(kinds):
        linear = {'tetra10': 'tetra', 'hexahedron20': 'hexahedron'}.get(kind, kind)
        n, known, cells = rand.randint(1, 3), {}, []

        def number(place):
            key = tuple(numpy.round(place * 48).astype(int))
            if key not in known:
                known[key] = len(points)
                points.append(place + [2 * at, 0, 0])
            return known[key]

        for i in range(n):
            cube = numpy.array(CUBE, dtype=float) + (0, 0, i)
            for part in PARTS[linear]:
                places = [cube[c] for c in part]
                places += [(places[a] + places[b]) / 2 for a, b in EDGES.get(kind, [])]
                cells.append([number(place) for place in places])
        blocks.append((kind, numpy.array(cells)))
    points = numpy.array(points) + numbers.integers(-9, 9, (len(points), 3)) / 128 + rand.choice([0, 100])
    return points, blocks


def fields(rand, numbers, points, blocks, vectors):
    point_data = {'f': numbers.integers(-99, 99, len(points)) / 8}
    if vectors and rand.random() < 0.5:
        point_data['v'] = numbers.integers(-99, 99, (len(points), 3)) / 8
    cell_data = {'g': [numbers.integers(-99, 99, len(cells)) / 8 for _, cells in blocks]} if rand.random() < 0.7 else {}
    return point_data, cell_data


def write(rand, numbers, folder):
    ending, options, types, vectors = rand.choice(FORMATS)
    # meshio writes one type to an entity of Gmsh 4.1, and one to a zone of Tecplot.
    one_type = options.get('file_format') == 'gmsh' or ending == 'dat'
    points, blocks = make_mesh(rand, numbers, types, one_type)
    point_data, cell_data = fields(rand, numbers, points, blocks, vectors)
    mesh = meshio.Mesh(points, blocks, point_data=dict(point_data), cell_data=dict(cell_data))
    if options.get('file_format') == 'gmsh':
        mesh.point_data['gmsh:dim_tags'] = numpy.array([[3, 1]] * len(points))
        for tag in ('gmsh:physical', 'gmsh:geometrical'):
            mesh.cell_data[tag] = [numpy.ones(len(cells), dtype='i4') for _, cells in blocks]
    path = folder / f'mesh.{ending}'
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        mesh.write(path, **options)
        try:
            again = meshio.read(path, **({'file_format': 'exodus'} if ending == 'exo' else {}))
        except (ValueError, KeyError, IndexError, TypeError):
            again = mesh  # meshio cannot read all that it writes
    return path, again


def read_by_vprobe(path, folder):
    done = subprocess.run([VPROBE, 'convert', path, '-o', folder / 'out.vtm'], capture_output=True, encoding='utf-8')
    assert done.returncode == 0, (path.name, done.stderr)
    points, centers, point_data, cell_data = [], [], {}, {}
    for file in sorted((folder / 'out').iterdir()):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(file))
        reader.Update()
        data = reader.GetOutput()
        own = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
        points.append(own)
        for c in range(data.GetNumberOfCells()):
            ids = data.GetCell(c).GetPointIds()
            corners = {ids.GetId(i) for i in range(ids.GetNumberOfIds())}  # those of collapsed bricks once
            centers.append(own[sorted(corners)].mean(axis=0))
        for fields_of, found in ((data.GetPointData(), point_data), (data.GetCellData(), cell_data)):
            for i in range(fields_of.GetNumberOfArrays()):
                found.setdefault(fields_of.GetArrayName(i), []).append(vtk_to_numpy(fields_of.GetArray(i)))
    joined = [{name: numpy.concatenate(values) for name, values in found.items()} for found in (point_data, cell_data)]
    return numpy.concatenate(points), numpy.array(centers), *joined


def by_place(places, values):
    return {tuple(place.round(4) + 0.0): numpy.ravel(value) for place, value in zip(places, values)}


def same(ours, wanted, what):
    assert ours.keys() == wanted.keys(), (what, len(ours), len(wanted))
    for place, value in wanted.items():
        assert numpy.allclose(ours[place], value, rtol=1e-6, atol=1e-6), (what, place, ours[place], value)


def compare(seed, folder):
    rand = random.Random(f'meshes:{seed}')
    path, mesh = write(rand, numpy.random.default_rng(rand.randrange(1 << 30)), folder)
    points, centers, point_data, cell_data = read_by_vprobe(path, folder)
    middles = numpy.array([mesh.points[numpy.unique(cell)].mean(axis=0) for block in mesh.cells for cell in block.data])
    same(by_place(points, points), by_place(mesh.points, mesh.points), (path.name, 'places'))
    same(by_place(centers, centers), by_place(middles, middles), (path.name, 'cells'))
    for name, values in mesh.point_data.items():
        if not name.startswith('gmsh:'):
            same(by_place(points, point_data[name]), by_place(mesh.points, values), (path.name, name))
    for name, values in mesh.cell_data.items():
        if name == 'g':
            same(by_place(centers, cell_data[name]), by_place(middles, numpy.concatenate(values)), (path.name, name))


def main():
    warnings.simplefilter('ignore')
    first, count = (int(word) for word in sys.argv[2:4]) if len(sys.argv) > 3 else \
        (1, how_many())
    failed = left = 0
    for seed in range(first, first + count):
        with tempfile.TemporaryDirectory(prefix='vprobe-meshes-') as folder:
            here = os.getcwd()
            try:
                compare(seed, pathlib.Path(folder))
            except (ImportError, meshio.WriteError, meshio.ReadError) as error:
                left += 1  # a format whose library is missing, or that meshio cannot write
                if left < 4:
                    print(f'seed {seed}: left out: {error!r}'[:200])
            except (AssertionError, KeyError) as error:
                failed += 1
                print(f'seed {seed}: FAILED: {error!r}'[:600])
            finally:
                os.chdir(here)
    print(f'{count - failed - left} of {count} meshes as meshio reads them, {left} left out')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
