#!/usr/bin/env python3
"""Cases of OpenFOAM that are decomposed among processors, held against the same case whole.

usage: foam_parts.py VPROBE [FIRST-SEED COUNT]

This program decomposes, after decomposePar: cells go to processors by chance, so that parts fall to pieces, touch at
edges only, or are empty. Where OpenFOAM is installed, its own decomposePar does the same to some of the cases.
"""
import os
import pathlib
import random
import shutil
import subprocess

from common import go_through, info, need, same

need('numpy', 'vtkmodules')

import numpy  # noqa: E402
from foam import KINDS, Field, Mesh, Writer  # noqa: E402
from grids import arrays_of, cells_of, grid_of, points_of  # noqa: E402

OPENFOAM = '/usr/share/openfoam'
WRONG = 1e30  # the values of patches between processors, which nobody may show


class Part:
    """What one processor has of a mesh. Its patches are [name, type, first face, faces, words of its entry]."""

    def __init__(self, mesh, part_of, number, cyclic):
        self.cells = numpy.flatnonzero(part_of == number)
        local = {cell: i for i, cell in enumerate(self.cells)}
        behind = dict(enumerate(mesh.neighbours))
        chosen, self.neighbours, self.patches = [], [], []
        for face, other in behind.items():
            if mesh.owners[face] in local and other in local:
                chosen.append((face, False))
                self.neighbours.append(local[other])
        between, through = {}, {}
        for name, kind, groups, first, count in mesh.patches:
            own = [(face, False) for face in range(first, first + count) if mesh.owners[face] in local]
            if name == cyclic:  # some of its faces are at a patch that leads through it
                through = {'' if len(own) < 2 else f'procBoundary{number}to99through{name}': own[len(own) // 2:]}
                through.pop('', None)
                own = own[:len(own) // 2] if through else own
            words = f'    inGroups {len(groups)}({" ".join(groups)});\n' if groups else ''
            self.add(chosen, name, kind, own, words)
        for face, other in behind.items():
            ends = mesh.owners[face], other
            for here, there in (ends, ends[::-1]):
                if here in local and there not in local:
                    between.setdefault(part_of[there], []).append((face, here != ends[0]))
        for other in sorted(between):
            self.add(chosen, f'procBoundary{number}to{other}', 'processor', between[other],
                     f'    myProcNo {number};\n    neighbProcNo {other};\n')
        for name, own in through.items():
            self.add(chosen, name, 'processorCyclic', own,
                     f'    myProcNo {number};\n    neighbProcNo 99;\n    referPatch {cyclic};\n')
        self.from_faces = [face for face, _ in chosen]
        self.numbers = sorted({point for face, _ in chosen for point in mesh.faces[face]})
        names = {point: i for i, point in enumerate(self.numbers)}
        self.points = mesh.points[self.numbers].reshape(-1, 3)
        self.faces, self.owners = [], []
        for face, is_turned in chosen:
            corners = [names[point] for point in mesh.faces[face]]
            self.faces.append(corners[:1] + corners[:0:-1] if is_turned else corners)
            self.owners.append(local[mesh.neighbours[face] if is_turned else mesh.owners[face]])

    def add(self, chosen, name, kind, faces, words):
        self.patches.append([name, kind, len(chosen), len(faces), words])
        chosen += faces


def write_part(writer, mesh, part, fields, region, time):
    """Into the writer's folder."""
    where = f'constant/{region}polyMesh/'
    writer.put(where + 'points', 'vectorField', writer.reals(part.points, 'vector', False))
    if writer.binary:
        starts = numpy.cumsum([0] + [len(face) for face in part.faces])
        writer.put(where + 'faces', 'faceCompactList',
                   writer.labels(list(starts)) + b'\n' + writer.labels([c for face in part.faces for c in face]))
    else:
        faces = '\n'.join(f'{len(face)}({" ".join(map(str, face))})' for face in part.faces)
        writer.put(where + 'faces', 'faceList', f'{len(part.faces)}\n(\n{faces}\n)')
    writer.put(where + 'owner', 'labelList', writer.labels(part.owners))
    writer.put(where + 'neighbour', 'labelList', writer.labels(part.neighbours))
    patches = ''.join(f'  {name}\n  {{\n    type {kind};\n{words}    nFaces {count};\n    startFace {first};\n  }}\n'
                      for name, kind, first, count, words in part.patches)
    writer.put(where + 'boundary', 'polyBoundaryMesh', f'{len(part.patches)}\n(\n{patches})\n', False)
    for field in fields.values():
        kind = f'{"vol" if field.of_cells else "point"}{field.type}Field'
        inside = field.inside[part.cells if field.of_cells else part.numbers]
        entries = b''
        for name, _, first, count, _ in part.patches:
            values = field.at.get(name)
            if name.startswith('procBoundary'):
                values = numpy.full((count, field.width), WRONG)
            elif values is not None:
                begin = next(patch[3] for patch in mesh.patches if patch[0] == name)
                values = values[[face - begin for face in part.from_faces[first:first + count]]]
            body = b'type zeroGradient;'
            if values is not None and field.of_cells:
                body = b'type fixedValue; value nonuniform ' + writer.reals(values, field.kind) + b';'
            entries += f'    {name} {{ '.encode() + body + b' }\n'
        writer.put(f'{time}/{region}{field.name}', kind,
                   b'dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform ' + writer.reals(inside, field.kind)
                   + b';\nboundaryField\n{\n' + entries + b'}\n')


def collate(folder, first, parts, name):
    """Puts the files of some processors into shared ones: the head of what is in them stands in the first block."""
    shared = folder / name
    files = sorted(path.relative_to(parts[0]) for path in parts[0].rglob('*') if path.is_file())
    for file in files:
        data = ('FoamFile\n{\n    version 2.0;\n    format binary;\n    class decomposedBlockData;\n'
                f'    object {file.name};\n}}\n\n').encode()
        for number, part in enumerate(parts):
            block = (part / file).read_bytes()
            if number:
                block = block[block.index(b'// * * * //') + 11:]
            data += f'\n// Processor{first + number}\n\n{len(block)}\n('.encode() + block + b')\n'
        (shared / file).parent.mkdir(parents=True, exist_ok=True)
        (shared / file).write_bytes(data)
    for part in parts:
        shutil.rmtree(part)


def compare(seed, folder):
    pick = random.Random(seed)
    numbers = numpy.random.default_rng(seed)
    mesh = Mesh(pick, numbers)
    cyclic = pick.choice([None, 'sides'])
    mesh.patches = [(name, 'cyclic' if name == cyclic else kind, *rest) for name, kind, *rest in mesh.patches]
    writer = Writer(pick, folder)
    writer.plain, writer.order = True, '<'
    if writer.scalar == 32:
        mesh.points = mesh.points.astype('f4').astype(float)
    fields = {}
    for i in range(pick.randint(1, 3)):
        name = f'{pick.choice(["T", "grad(T)", "k.air"])}{i}'
        field = Field(writer, mesh, numbers, name, pick.choice(list(KINDS)), pick.random() < 0.75)
        if cyclic:
            field.at[cyclic] = None
        fields[name] = field
    region, time = pick.choice(['', 'air/']), '2.5'
    count = pick.randint(1, 5)
    part_of = numbers.integers(0, count, mesh.count)
    parts = [Part(mesh, part_of, p, cyclic) for p in range(count)]
    has_numbers = pick.random() < 0.6
    is_shared = pick.random() < 0.4
    writer.packed &= not is_shared
    folders = [folder / f'processor{p}' for p in range(count)]
    for part, place in zip(parts, folders):
        writer.folder = place
        write_part(writer, mesh, part, fields, region, time)
        for name, values in (('point', part.numbers), ('cell', part.cells)) if has_numbers else ():
            writer.put(f'constant/{region}polyMesh/{name}ProcAddressing', 'labelList', writer.labels(list(values)))
    if is_shared:
        middle = pick.choice([None, count // 2]) if count > 1 else None
        for first, last in ((0, count),) if middle is None else ((0, middle), (middle, count)):
            name = f'processors{count}' + ('' if middle is None else f'_{first}-{last - 1}')
            collate(folder, first, folders[first:last], name)
    elif pick.random() < 0.3 and count > 1:
        (folders[-1] / '7').mkdir()  # a time that is not written to its end
    path = folder / 'case.foam'
    path.write_text('')

    assert info(path)['times'] == [2.5]
    grid, said = grid_of(path, folder)
    assert ('numbered one processor after the other' in said) == (not has_numbers), said
    assert ('only some of its processors' in said) == (folders[-1] / '7').exists(), said
    # Where its cells and points are in the whole.
    cells, points = numpy.arange(mesh.count), numpy.arange(len(mesh.points))
    if not has_numbers:
        cells = numpy.concatenate([part.cells for part in parts])
        at = {tuple(point): i for i, point in enumerate(mesh.points)}
        points = numpy.array([at[tuple(point)] for point in points_of(grid)])
    joins_all = has_numbers or set(points) == set(range(len(mesh.points))) and len(points) == len(mesh.points)
    same(points_of(grid), mesh.points[points], 'points')
    assert [frozenset(points[list(c)]) for c in cells_of(grid)] == [frozenset(mesh.corners[c]) for c in cells], 'cells'
    of_cells, of_points = arrays_of(grid.GetCellData()), arrays_of(grid.GetPointData())
    for name, field in fields.items():
        digits = 1e-6 if writer.scalar == 32 else 1e-13
        if field.of_cells:
            same(of_cells[name], field.right(field.inside)[cells], ('cells', name))
            if joins_all:
                same(of_points[name], field.right_at_points(mesh)[points], ('points', name), digits)
        else:
            same(of_points[name], field.right(field.inside)[points], ('points', name))


    if is_shared:
        return
    # The mesh of the case itself, which has no times, gives way to parts unless one of them is missing.
    writer.folder = folder
    writer.mesh(mesh, f'constant/{region}', f'constant/{region}')
    assert grid_of(path, folder)[1] == said
    shutil.rmtree(folders[0])
    grid, said = grid_of(path, folder)
    assert cells_of(grid) == [frozenset(corners) for corners in mesh.corners], 'cells of the whole'
    assert ('part of processor 0 is missing' in said) == (count > 1), said


def compare_with_decompose_par(seed, folder):
    """A case, and the same case once OpenFOAM's program has decomposed it."""
    pick = random.Random(seed)
    numbers = numpy.random.default_rng(seed)
    mesh = Mesh(pick, numbers)
    mesh.patches = [(name, 'patch', groups, first, count) for name, _, groups, first, count in mesh.patches]
    writer = Writer(pick, folder)
    writer.plain, writer.order, writer.label, writer.scalar, writer.packed = True, '<', 32, 64, False
    writer.mesh(mesh, 'constant/', 'constant/')
    fields = [Field(writer, mesh, numbers, f'f{i}', pick.choice(list(KINDS)), True) for i in range(2)]
    for field in fields:
        field.put('1/')
    count = pick.randint(2, 4)
    writer.put('system/controlDict', 'dictionary', 'startFrom startTime; startTime 1; endTime 2; deltaT 1;\n'
               'writeInterval 1; writeFormat ascii; writePrecision 17;\n', False)
    writer.put('system/fvSchemes', 'dictionary', 'ddtSchemes {} gradSchemes {} divSchemes {} laplacianSchemes {}\n'
               'interpolationSchemes {} snGradSchemes {}\n', False)
    writer.put('system/fvSolution', 'dictionary', 'solvers {}\n', False)
    writer.put('system/decomposeParDict', 'dictionary', f'numberOfSubdomains {count};\n'
               + pick.choice(['method random;\n', f'method simple; simpleCoeffs {{ n ({count} 1 1); delta 0.001; }}\n']),
               False)
    path = folder / 'case.foam'
    path.write_text('')
    whole, _ = grid_of(path, folder)
    how = pick.choice(['uncollated', 'collated'])
    done = subprocess.run(['decomposePar', '-time', '1', '-fileHandler', how], cwd=folder, capture_output=True,
                          encoding='utf-8', env={**os.environ, 'WM_PROJECT_DIR': OPENFOAM})
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr
    shutil.rmtree(folder / 'constant')
    shutil.rmtree(folder / '1')
    grid, said = grid_of(path, folder)
    assert said == '', said
    same(points_of(grid), points_of(whole), 'points', 1e-15)
    assert cells_of(grid) == cells_of(whole), 'cells'
    for ours, right in ((grid.GetCellData(), whole.GetCellData()), (grid.GetPointData(), whole.GetPointData())):
        ours, right = arrays_of(ours), arrays_of(right)
        assert ours.keys() == right.keys(), (ours.keys(), right.keys())
        for name in ours:
            same(ours[name], right[name], name, 1e-13)


def compare_both(seed, folder):
    (folder / 'ours').mkdir()
    compare(seed, folder / 'ours')
    if seed % 4 == 0 and shutil.which('decomposePar') and pathlib.Path(OPENFOAM).is_dir():
        (folder / 'theirs').mkdir()
        compare_with_decompose_par(seed, folder / 'theirs')


if __name__ == '__main__':
    go_through('decomposed OpenFOAM', compare_both)
