#!/usr/bin/env python3
"""Cases of OpenFOAM in many spellings, read by vprobe, and the plain ones by VTK's reader too.

usage: foam.py VPROBE [FIRST-SEED COUNT]

No library of Debian writes cases, so this program does, after OpenFOAM's user guide and sources: text and bytes, packed
or not, labels and numbers of both sizes, macros, included files, patterns, groups of patches. Values of cells and
points are compared with those that were meant, places and cells too. VTK's vtkOpenFOAMReader is the witness of the
cells, and of the values that points have from cells, wherever it knows the spelling; it has 7 digits.
"""
import gzip
import random

from common import go_through, info, need, same

need('numpy', 'vtkmodules')

import numpy  # noqa: E402
from grids import arrays_of, cells_of, grid_of, points_of  # noqa: E402

CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
HEXAHEDRON = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
WEDGES = (((0, 2, 1), (4, 5, 6), (0, 1, 5, 4), (1, 2, 6, 5), (0, 4, 6, 2)),
          ((0, 3, 2), (4, 6, 7), (2, 3, 7, 6), (3, 0, 4, 7), (0, 2, 6, 4)))
KINDS = {'scalar': ('Scalar', 1), 'vector': ('Vector', 3), 'sphericalTensor': ('SphericalTensor', 1),
         'symmTensor': ('SymmTensor', 6), 'tensor': ('Tensor', 9)}
SYMMETRIC = [0, 3, 5, 1, 4, 2]  # XX YY ZZ XY YZ XZ


class Mesh:
    """Boxes, some of them cut into wedges and some of them joined in pairs; patches of the boundary."""

    def __init__(self, pick, numbers):
        sides = [pick.randint(1, 3) for _ in range(3)]
        nx, ny, nz = (n + 1 for n in sides)
        self.points = numpy.array([(i, j, k) for k in range(nz) for j in range(ny) for i in range(nx)], float)
        self.points += numbers.uniform(-0.1, 0.1, self.points.shape) + pick.choice([0.0, 6.7e6])
        shapes = {}
        for i in range(sides[0]):
            for j in range(sides[1]):
                cut = pick.random() < 0.3
                for k in range(sides[2]):
                    corners = [i + a + nx * (j + b + ny * (k + c)) for a, b, c in CORNERS]
                    shapes[i, j, k] = [[[corners[c] for c in face] for face in shape]
                                       for shape in (WEDGES if cut else (HEXAHEDRON,))]
        cells = [shape for place in shapes for shape in shapes[place]]
        pick.shuffle(cells)
        self.sort_faces(cells, pick)

    def sort_faces(self, cells, pick):
        """Faces between cells first, by their owners and neighbors; then those of the patches."""
        sides = {}
        for number, cell in enumerate(cells):
            for face in cell:
                sides.setdefault(frozenset(face), []).append((number, face))
        joined = {}
        for pair in sides.values():
            ends = {number for number, _ in pair}
            if len(pair) == 2 and len(cells) > 4 and pick.random() < 0.1 and not ends & joined.keys():
                joined |= {max(ends): min(ends), min(ends): min(ends)}
        numbers = {}
        for number in range(len(cells)):
            numbers[number] = numbers.get(joined.get(number, number), len(set(numbers.values())))
        inside, outside = [], []
        for pair in sides.values():
            own = sorted((numbers[number], face) for number, face in pair)
            if len(own) == 1:
                outside.append((own[0][1], own[0][0]))
            elif own[0][0] != own[1][0]:
                inside.append((own[0][1], own[0][0], own[1][0]))
        inside.sort(key=lambda face: face[1:])
        pick.shuffle(outside)
        self.count = len(set(numbers.values()))
        self.patches, first = [], len(inside)
        parts = numpy.array_split(numpy.arange(len(outside)), 4)
        for name, part, kinds in zip(('inlet', 'outlet', 'hotWalls', 'sides'), parts,
                                     (('patch',), ('patch', 'mappedWall'), ('wall',),
                                      ('patch', 'symmetryPlane', 'empty'))):
            groups = {'inlet': ['open'], 'outlet': ['open', 'far'], 'hotWalls': ['wall', 'hot'], 'sides': []}[name]
            self.patches.append((name, pick.choice(kinds), groups, first, len(part)))
            first += len(part)
        self.inside = inside
        self.faces = [face[0] for face in inside] + [face[0] for face in outside]
        self.owners = [face[1] for face in inside] + [face[1] for face in outside]
        self.neighbours = [face[2] for face in inside]
        self.corners = [set() for _ in range(self.count)]
        for face, owner in zip(self.faces, self.owners):
            self.corners[owner].update(face)
        for face, other in zip(self.faces, self.neighbours):
            self.corners[other].update(face)


class Writer:
    """How the files of one case are written."""

    def __init__(self, pick, folder):
        self.pick, self.folder = pick, folder
        self.binary = pick.random() < 0.5
        self.label, self.scalar = pick.choice([32, 64]), pick.choice([64, 64, 32]) if self.binary else 64
        self.order = pick.choice('<<<>')
        self.packed = pick.random() < 0.3
        self.plain = pick.random() < 0.5
        if not self.binary or self.plain:
            self.order = '<'

    def put(self, name, kind, body, binary=None):
        binary = self.binary if binary is None else binary
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        arch = f'{"LSB" if self.order == "<" else "MSB"};label={self.label};scalar={self.scalar}'
        head = (f'/*--- {name} ---*/\nFoamFile\n{{\n    version 2.0;\n    format {"binary" if binary else "ascii"};\n'
                f'    arch "{arch}"; // as it is\n    class {kind};\n    object {path.name};\n}}\n// * * * //\n\n')
        data = head.encode() + (body if isinstance(body, bytes) else body.encode()) + b'\n// ***** //\n'
        if self.packed:
            path.with_name(path.name + '.gz').write_bytes(gzip.compress(data))
        else:
            path.write_bytes(data)

    def number(self, value):
        value = float(value)
        if value != value:
            return self.pick.choice(['nan', '-nan', 'NaN', '1.#QNAN', '-1.#IND'])
        if value in (float('inf'), -float('inf')):
            return ('-' if value < 0 else '') + self.pick.choice(['inf', 'Infinity', '1.#INF'])
        return repr(value)

    def element(self, row, kind):
        words = ' '.join(map(self.number, row))
        return words if kind == 'scalar' else f'({words})'

    def comment(self):
        return '' if self.plain else self.pick.choice(['', '', ' // two words (1 2)\n', ' /* { ; */ '])

    def reals(self, values, kind, is_typed=True):
        """A list with its count."""
        values = numpy.asarray(values, float)
        name = f'List<{kind}> ' if is_typed else ''
        if self.binary:
            kind = f'{self.order}f{self.scalar // 8}'
            return f'{name}\n{len(values)}\n('.encode() + values.astype(kind).tobytes() + b')'
        if not self.plain and self.pick.random() < 0.2:
            name = ''
        if len(values) and (values == values[0]).all() and not self.plain and self.pick.random() < 0.7:
            return f'{name}{len(values)}{{{self.element(values[0], kind)}}}'.encode()
        glue = self.pick.choice(['\n', ' '])
        rows = glue.join(self.element(row, kind) for row in values) or ''
        return f'{name}{self.comment()}{len(values)}\n({self.comment()}\n{rows}\n)'.encode()

    def labels(self, values):
        if self.binary:
            kind = f'{self.order}i{self.label // 8}'
            return f'{len(values)}\n('.encode() + numpy.asarray(values, kind).tobytes() + b')'
        if len(set(values)) == 1 and not self.plain:
            return f'{len(values)}{{{values[0]}}}'.encode()
        return f'{len(values)}\n({self.comment()}\n'.encode() + '\n'.join(map(str, values)).encode() + b'\n)'

    def mesh(self, mesh, where, points_where):
        self.put(f'{points_where}polyMesh/points', 'vectorField', self.reals(mesh.points, 'vector', False))
        if self.binary:
            starts = numpy.cumsum([0] + [len(face) for face in mesh.faces])
            self.put(f'{where}polyMesh/faces', 'faceCompactList',
                     self.labels(list(starts)) + b'\n' + self.labels([c for face in mesh.faces for c in face]))
        else:
            faces = '\n'.join(f'{len(face)}({" ".join(map(str, face))})' for face in mesh.faces)
            self.put(f'{where}polyMesh/faces', 'faceList', f'{len(mesh.faces)}\n(\n{faces}\n)')
        self.put(f'{where}polyMesh/owner', 'labelList', self.labels(mesh.owners))
        self.put(f'{where}polyMesh/neighbour', 'labelList', self.labels(mesh.neighbours))
        patches = ''
        for name, kind, groups, first, count in mesh.patches:
            form = self.pick.choice(['{}({})', 'List<word> {}({})'])
            words = f'    inGroups {form.format(len(groups), " ".join(groups))};\n' if groups else ''
            patches += (f'  {name}\n  {{\n    type {kind};{self.comment()}\n{words}    nFaces {count};\n'
                        f'    startFace {first};\n  }}\n')
        self.put(f'{where}polyMesh/boundary', 'polyBoundaryMesh', f'{len(mesh.patches)}\n(\n{patches})\n', False)


class Field:
    """The values of one field, and how they are spelled."""

    def __init__(self, writer, mesh, numbers, name, kind, of_cells):
        pick = writer.pick
        self.writer, self.name, self.kind, self.of_cells = writer, name, kind, of_cells
        self.type, self.width = KINDS[kind]
        count = mesh.count if of_cells else len(mesh.points)
        self.is_uniform = pick.random() < 0.2
        if self.is_uniform:
            self.inside = numpy.repeat(numbers.normal(size=(1, self.width)), count, axis=0)
        else:
            self.inside = numbers.normal(size=(count, self.width)) * 10.0 ** pick.randint(-5, 5)
        if not writer.plain and pick.random() < 0.3:
            self.inside[numbers.random(self.inside.shape) < 0.2] = pick.choice([numpy.nan, numpy.inf])
        if writer.scalar == 32:
            self.inside = self.inside.astype('f4').astype(float)
        self.before, self.entries, self.at = '', [], {}
        for patch in mesh.patches if of_cells else ():
            self.spell_patch(patch, numbers)
        self.level = None
        if not writer.plain and pick.random() < 0.15:
            self.level = numbers.integers(1, 9, self.width).astype(float)

    def spell_patch(self, patch, numbers):
        """An entry of the boundary, and the values that are meant; none: those of the cells beside it."""
        writer, (name, kind, _, _, count) = self.writer, patch
        pick, one = writer.pick, numbers.integers(-99, 99, self.width).astype(float)
        rows = numbers.integers(-99, 99, (count, self.width)).astype(float)
        key, body, values = name, b'type zeroGradient;', None
        if kind in ('empty', 'symmetryPlane'):
            body = f'type {kind};'.encode()
            if not writer.plain and pick.random() < 0.5:
                return  # it follows from the geometry
        else:
            form = pick.choice(['rows', 'uniform', 'none'] if writer.plain else
                               ['rows', 'uniform', 'none', 'macro', 'deep', 'parts', 'entry', 'slip', 'constant',
                                'file'])
            words = writer.element(one, self.kind)
            if form == 'rows':
                body, values = b'type fixedValue; value nonuniform ' + writer.reals(rows, self.kind) + b';', rows
            elif form in ('uniform', 'macro', 'deep', 'entry', 'file'):
                values = numpy.repeat(one[None], count, axis=0)
                value = f'uniform {words}'
                if form == 'macro':
                    self.before += f'v{name} {words};{writer.comment()}\n'
                    value = f'uniform {pick.choice(["$v", "${v"])}{name}'
                    value += '}' if '{' in value else ''
                elif form == 'deep':
                    self.before += f'd{name}\n{{\n  side {value};\n  in {{ side uniform {words}; up $..side; }}\n}}\n'
                    value = pick.choice(['$:d{}.in.up', '$d{}.in.side', '$..d{}.side', '$!d{}/in/side',
                                         '${{:d{}.side}}', '$../../d{}/side']).format(name)
                    value = value.replace('$..d', '$...d')
                elif form == 'entry':
                    self.before += f'e{name} {{ type calculated; value {value}; }}\n'
                elif form == 'file':
                    (writer.folder / 'constant' / 'given').mkdir(parents=True, exist_ok=True)
                    (writer.folder / 'constant' / 'given' / f'{self.name}-{name}').write_text(f'{value}')
                    places = ['$FOAM_CASE/constant/given', '<constant>/given', '../constant/given']
                    places = places[:2 if writer.region else 3]
                    value = f'#include "{pick.choice(places)}/{self.name}-{name}"'
                body = f'type fixedValue; value {value};'.encode()
                if form == 'entry':
                    body = pick.choice([f'$e{name};', f'$:e{name}; type fixedValue;']).encode()
            elif form == 'parts':
                self.before += ''.join(f'p{name}{i} {writer.number(x)};\n' for i, x in enumerate(one))
                parts = ' '.join(f'$p{name}{i}' for i in range(self.width))
                values = numpy.repeat(one[None], count, axis=0)
                body = f'value uniform {parts if self.kind == "scalar" else f"({parts})"}; type calculated;'.encode()
            elif form == 'slip':
                body, values = b'type noSlip;', numpy.zeros((count, self.width))
            elif form == 'constant':
                body = f'type uniformFixedValue; uniformValue constant {words};'.encode()
                values = numpy.repeat(one[None], count, axis=0)
            if not writer.plain and (form != 'rows' or name != 'sides'):
                key = pick.choice([name, name, f'"{name}"', f'"{name[:3]}.*"', f'"({name}|none)"'] +
                                  ({'inlet': [], 'outlet': ['far'], 'hotWalls': ['wall', 'hot']}.get(name, [])))
        self.entries.append((key, body))
        self.at[name] = values

    def put(self, where):
        writer, pick = self.writer, self.writer.pick
        level, inside = b'', self.inside
        if self.level is not None:
            level = f'referenceLevel {writer.element(self.level, self.kind)};\n'.encode()
        if self.is_uniform and (inside == inside[0]).all():
            value = f'uniform {writer.element(inside[0], self.kind)}'.encode()
            if not writer.plain and pick.random() < 0.3:
                self.before += f'inner {value.decode()};\n'
                value = b'$inner'
        else:
            value = b'nonuniform ' + writer.reals(inside, self.kind)
        entries = list(self.entries)
        # A macro by itself would mean this pattern, too.
        if not writer.plain and pick.random() < 0.3 and not any(body.startswith(b'$e') for _, body in entries):
            entries.insert(0, ('".*"', b'type fixedValue; value uniform $nothing;'))
        boundary = b''.join(f'    {key}{writer.comment()}\n    {{\n        '.encode() + body + b'\n    }\n'
                            for key, body in entries)
        before = self.before
        if not writer.plain and pick.random() < 0.3:
            before = '#includeEtc "caseDicts/setConstraintTypes"\n#includeIfPresent "none"\n' + before
        if before and not writer.plain and pick.random() < 0.3:
            (writer.folder / 'constant' / f'before-{self.name}').write_text(before)
            before = f'#include "<constant>/before-{self.name}"\n'
        body = (b'dimensions      [0 0 0 0 0 0 0];\n\n' + before.encode() + level + b'internalField   ' + value +
                b';\n\nboundaryField\n{\n' + boundary + b'}\n')
        if not self.of_cells:
            body = (b'dimensions [0 0 0 0 0 0 0];\n' + before.encode() + level + b'internalField ' + value +
                    b';\nboundaryField\n{\n    ".*" { type calculated; }\n}\n')
        self.writer.put(where + self.name, f'{"vol" if self.of_cells else "point"}{self.type}Field', body)

    def right(self, values):
        values = values + (0 if self.level is None else self.level)
        return values[:, SYMMETRIC] if self.width == 6 else values

    def right_at_points(self, mesh):
        """Means of the faces of walls and patches around a point, else of its cells."""
        around = [[] for _ in mesh.points]
        edge = [[] for _ in mesh.points]
        for cell, corners in enumerate(mesh.corners):
            for point in corners:
                around[point].append(self.inside[cell])
        for name, kind, _, first, count in mesh.patches:
            values = self.at.get(name)
            for i in range(count if kind in ('patch', 'wall', 'mappedWall') else 0):
                for point in mesh.faces[first + i]:
                    edge[point].append(self.inside[mesh.owners[first + i]] if values is None else values[i])
        return self.right(numpy.array([numpy.mean(e or a, axis=0) for e, a in zip(edge, around)]))


def read_by_vtk(path, time):
    from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
    reader = vtkOpenFOAMReader()
    reader.SetFileName(str(path))
    reader.SetCreateCellToPoint(True)
    reader.SetDecomposePolyhedra(False)
    reader.UpdateInformation()
    reader.EnableAllCellArrays()
    reader.EnableAllPointArrays()
    reader.UpdateTimeStep(time)
    root = reader.GetOutputDataObject(0)
    return root.GetBlock(0)


def compare(seed, folder):
    pick = random.Random(seed)
    numbers = numpy.random.default_rng(seed)
    mesh = Mesh(pick, numbers)
    writer = Writer(pick, folder)
    if writer.scalar == 32:
        mesh.points = mesh.points.astype('f4').astype(float)
    region = writer.region = '' if writer.plain else pick.choice(['', '', 'air/'])
    names = pick.sample(['0', '0.25', '1', '1e-05', '10', '2.5', '100'], pick.randint(1, 4))
    names.sort(key=float)
    index = pick.randrange(len(names))
    time = names[index]
    moving = pick.random() < 0.3
    writer.mesh(mesh, f'constant/{region}', f'{time}/{region}' if moving else f'constant/{region}')
    fields = {}
    for i in range(pick.randint(1, 4)):
        kind = pick.choice(list(KINDS))
        name = pick.choice(['T', 'U', 'grad(T)', 'p_rgh', 'k.air']) + str(i)
        fields[name] = Field(writer, mesh, numbers, name, kind, pick.random() < 0.75)
    for each in names:
        (folder / each).mkdir(exist_ok=True)
    for field in fields.values():
        field.put(f'{time}/{region}')
    writer.put(f'{time}/{region}phi', 'surfaceScalarField',
               b'dimensions [0]; internalField nonuniform '
               + writer.reals(numpy.ones((len(mesh.neighbours), 1)), 'scalar') + b';\n'
               b'boundaryField { ".*" { type calculated; value uniform 0; } }')
    writer.put('system/controlDict', 'dictionary', b'startTime 0;\nendTime 1;\ndeltaT 1;\nwriteInterval 1;\n', False)
    path = folder / 'case.foam'
    path.write_text('')

    assert info(path)['times'] == [float(name) for name in names], info(path)['times']
    grid, said = grid_of(path, folder, '--time', f'#{index}')
    assert 'phi' in said and said.count('left out') == 1, said
    same(points_of(grid), mesh.points, 'points')
    assert cells_of(grid) == [frozenset(corners) for corners in mesh.corners], 'cells'
    of_cells, of_points = arrays_of(grid.GetCellData()), arrays_of(grid.GetPointData())
    assert set(of_points) == set(fields) and set(of_cells) == {n for n, f in fields.items() if f.of_cells}, \
        (set(of_points), set(of_cells), set(fields), said)
    for name, field in fields.items():
        digits = 1e-6 if writer.scalar == 32 else 1e-13
        if field.of_cells:
            same(of_cells[name], field.right(field.inside), ('cells', name), digits if field.level is not None else 0)
            same(of_points[name], field.right_at_points(mesh), ('points', name), digits)
        else:
            same(of_points[name], field.right(field.inside), ('points', name), digits if field.level is not None else 0)
    if writer.plain:
        witness = read_by_vtk(path, float(time))
        assert witness.GetNumberOfCells() == mesh.count, 'cells of VTK'
        assert cells_of(witness) == cells_of(grid), 'corners of VTK'
        same(points_of(witness), mesh.points, 'points of VTK', 1e-6)
        # VTK leaves uniform symmetric tensors in OpenFOAM's order.
        for name, values in arrays_of(witness.GetCellData()).items():
            if fields[name].width < 6 or not fields[name].is_uniform:
                same(of_cells[name], values, ('cells of VTK', name), 1e-5)
        for name, values in arrays_of(witness.GetPointData()).items():
            if fields[name].width != 6:
                same(of_points[name], values, ('points of VTK', name), 1e-5)


if __name__ == '__main__':
    go_through('OpenFOAM', compare)
