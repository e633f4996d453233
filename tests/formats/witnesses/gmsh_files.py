#!/usr/bin/env python3
"""Random meshes by Gmsh itself, read by Gmsh and by vprobe: places, cells, physical groups, partitions, and views.

usage: gmsh_files.py VPROBE [FIRST-SEED COUNT]

Written in versions 1, 2.2, 4.0 and 4.1, text and binary, of first and second order, with and without partitions, with
entities in several groups, and with views of nodes and elements at several times. VPROBE_LONG asks for 500 files. Exit
code 77 where Gmsh's module or VTK's is missing.
"""
import pathlib
import random
import subprocess
import sys
import tempfile

try:
    import gmsh
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError as error:
    print(f'left out: {error}')
    sys.exit(77)

from common import how_many

VPROBE = sys.argv[1]
# Gmsh's types of solid elements, and how many of their nodes VTK's cells have.
SOLIDS = {4: 4, 5: 8, 6: 6, 7: 5, 11: 10, 12: 27, 13: 18, 14: 13, 17: 20, 18: 15, 19: 13}


def make_model(rand):
    """Boxes in a row, of tetrahedra, or of hexahedra or prisms that are swept."""
    gmsh.model.add('m')
    count, way = rand.randint(1, 3), rand.choice(['tetrahedra', 'hexahedra', 'prisms'])
    if way == 'tetrahedra':
        boxes = [(3, gmsh.model.occ.addBox(i, 0, 0, 1, rand.choice([0.5, 1]), 1)) for i in range(count)]
        if count > 1:
            gmsh.model.occ.fragment(boxes[:1], boxes[1:])
    else:
        top = (2, gmsh.model.occ.addRectangle(0, 0, 0, 1, 1))
        for _ in range(count):
            top = gmsh.model.occ.extrude([top], 0, 0, 1, [rand.randint(1, 2)], recombine=True)[0]
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber('Mesh.MeshSizeMax', rand.choice([0.5, 0.8]))
    gmsh.option.setNumber('Mesh.RecombineAll', int(way == 'hexahedra'))
    volumes = [tag for _, tag in gmsh.model.getEntities(3)]
    for number in range(1, rand.randint(1, 4)):
        group = gmsh.model.addPhysicalGroup(3, rand.sample(volumes, rand.randint(1, len(volumes))), 10 * number)
        if rand.random() < 0.7:
            gmsh.model.setPhysicalName(3, group, f'part {number}')
    faces = [tag for _, tag in gmsh.model.getEntities(2)]
    if rand.random() < 0.5:
        gmsh.model.addPhysicalGroup(2, rand.sample(faces, 2), 10)
    gmsh.model.mesh.generate(3)
    gmsh.model.mesh.setOrder(rand.choice([1, 1, 2]))


def meant():
    """Of each solid element its tag, the places of its nodes, and its groups' numbers."""
    tags, places, _ = gmsh.model.mesh.getNodes()
    place_of = dict(zip(tags.tolist(), numpy.array(places).reshape(-1, 3)))
    elements = {}
    for _, entity in gmsh.model.getEntities(3):
        groups = set(gmsh.model.getPhysicalGroupsForEntity(3, entity).tolist())
        for kind, tags, nodes in zip(*gmsh.model.mesh.getElements(3, entity)):
            for tag, own in zip(tags, numpy.array(nodes).reshape(len(tags), -1)[:, :SOLIDS[kind]]):
                key = frozenset(tuple(place_of[node].round(7) + 0.0) for node in own.tolist())
                elements[int(tag)] = key, groups
    return place_of, elements


def write_views(rand, numbers, path, place_of, elements):
    """Views behind the mesh; returns of each its name, whether it is of nodes, and its steps by time."""
    views = []
    for v in range(rand.randint(0, 3)):
        of_nodes, width = rand.random() < 0.5, rand.choice([1, 3, 9])
        tags = sorted(place_of if of_nodes else elements)
        steps, view = {}, gmsh.view.add(f'view {v}')
        for step in range(rand.randint(1, 3)):
            own = rand.sample(tags, rand.randint(1, len(tags)))
            values = numbers.integers(-99, 99, (len(own), width)) / 4
            time = float(step * rand.choice([0.5, 1]) + v)
            gmsh.view.addModelData(view, step, 'm', 'NodeData' if of_nodes else 'ElementData', own, values.tolist(),
                                   time, width)
            steps[time] = dict(zip(own, values))
        gmsh.option.setNumber('PostProcessing.SaveMesh', 0)
        gmsh.view.write(view, str(path), True)
        views.append((f'view {v}', of_nodes, width, steps))
    return views


def read_by_vprobe(path, folder, *options):
    done = subprocess.run([VPROBE, 'convert', path, '-o', folder / 'out.vtu', *options], capture_output=True, encoding='utf-8')
    assert done.returncode == 0, done.stderr
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(folder / 'out.vtu'))
    reader.Update()
    return reader.GetOutput()


def arrays_of(fields):
    return {fields.GetArrayName(i): vtk_to_numpy(fields.GetArray(i)) for i in range(fields.GetNumberOfArrays())}


def check_groups(cells, arrays, by_place, saves_all, has_names):
    names = {}
    for dimension, number in gmsh.model.getPhysicalGroups(3):
        names[number] = has_names and gmsh.model.getPhysicalName(dimension, number) or str(number)
    several = any(len(groups) > 1 for _, groups in by_place.values())
    for i, key in cells.items():
        groups = by_place[key][1]
        first = arrays['gmsh:physical'][i]
        assert (first in groups) if groups else first == 0 and saves_all, (first, groups)
        if several:
            found = {number for number, name in names.items() if arrays.get(f'gmsh:physical:{name}', [0] * (i + 1))[i]}
            assert found == groups, (found, groups)


def compare(seed, folder):
    rand = random.Random(f'gmsh:{seed}')
    numbers = numpy.random.default_rng(seed)
    make_model(rand)
    place_of, elements = meant()
    groups = gmsh.model.getPhysicalGroups(3)
    saves_all = not groups or rand.random() < 0.2
    version, binary = rand.choice([(1, 0), (2.2, 0), (2.2, 1), (4.0, 0), (4.1, 0), (4.1, 1)])
    if saves_all and groups and version < 4:
        saves_all = False  # these versions have no groups then
    path = folder / 'm.msh'
    gmsh.option.setNumber('Mesh.SaveAll', int(saves_all))
    gmsh.option.setNumber('Mesh.MshFileVersion', version)
    gmsh.option.setNumber('Mesh.Binary', binary)
    parts = rand.choice([0, 0, 2, 3]) if version > 1 else 0
    views_at = [] if parts or version != 4.1 and version != 2.2 else None
    if parts:
        gmsh.option.setNumber('Mesh.PartitionCreateGhostCells', rand.randint(0, 1))
        gmsh.option.setNumber('Mesh.PartitionCreateTopology', 1)
        gmsh.model.mesh.partition(parts)
    gmsh.write(str(path))
    if not saves_all:  # Gmsh numbers what it saves anew, and values of other elements would have the same numbers
        elements = {tag: about for tag, about in elements.items() if about[1]}
    views = write_views(rand, numbers, path, place_of, elements) if views_at is None else views_at
    times = sorted({time for _, _, _, steps in views for time in steps})
    time = rand.choice(times) if times else None
    data = read_by_vprobe(path, folder, *(['--time', repr(time)] if times else []))

    by_place = {key: (tag, own) for tag, (key, own) in elements.items()}
    points = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    cells = {}
    for i in range(data.GetNumberOfCells()):
        if data.GetCell(i).GetCellDimension() == 3:
            ids = data.GetCell(i).GetPointIds()
            cells[i] = frozenset(tuple(points[ids.GetId(n)].round(7) + 0.0) for n in range(ids.GetNumberOfIds()))
    assert sorted(map(sorted, cells.values())) == sorted(map(sorted, by_place)), (len(cells), len(by_place))
    cell_data, point_data = arrays_of(data.GetCellData()), arrays_of(data.GetPointData())
    check_groups(cells, cell_data, by_place, saves_all, version > 1)
    if parts:
        found = set(cell_data['gmsh:partition'][list(cells)].tolist())
        assert found <= set(range(1, parts + 1)) and len(found) > 0, found
    for name, of_nodes, width, steps in views:
        at = max([t for t in steps if t <= time], default=min(steps))
        values = steps[at]
        ours = (point_data if of_nodes else cell_data)[name].reshape(-1, width)
        if of_nodes:
            tag_at = {tuple(place.round(7) + 0.0): tag for tag, place in place_of.items()}
            tags = {i: tag_at[tuple(point.round(7) + 0.0)] for i, point in enumerate(points)}
        else:
            tags = {i: by_place[key][0] for i, key in cells.items()}
        for i, tag in tags.items():
            wanted = values.get(tag, numpy.full(width, numpy.nan))
            assert numpy.allclose(ours[i], wanted, equal_nan=True, atol=1e-9), (name, at, time, ours[i], wanted)


def main():
    first, count = (int(word) for word in sys.argv[2:4]) if len(sys.argv) > 3 else \
        (1, how_many())
    failed = 0
    for seed in range(first, first + count):
        gmsh.initialize(['gmsh', '-nopopup', '-v', '0'])
        with tempfile.TemporaryDirectory(prefix='vprobe-gmsh-') as folder:
            try:
                compare(seed, pathlib.Path(folder))
            except (AssertionError, KeyError) as error:
                failed += 1
                print(f'seed {seed}: FAILED: {error!r}'[:600])
        gmsh.finalize()
    print(f'{count - failed} of {count} Gmsh files as Gmsh means them')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
