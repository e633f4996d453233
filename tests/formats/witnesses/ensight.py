#!/usr/bin/env python3
"""EnSight files in the spellings of the manual, read by vprobe.

usage: ensight.py VPROBE [FIRST-SEED COUNT]

No library in Debian writes all of the format: these files are written by this script, after chapter 11 of the EnSight
User Manual, and their values are known. EnSight 6 and Gold; text, C and Fortran binary of either byte order; ids;
elements and blocks of every kind; several time sets and file sets; undefined and partial values. Seeds make the files. VPROBE_LONG asks for 500. Exit code 77 where VTK's module is missing.
"""
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

try:
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader
except ImportError as error:
    print(f'left out: {error}')
    sys.exit(77)

from common import how_many

VPROBE = sys.argv[1]
NAN = float('nan')


class Writer:
    """Lines and numbers of one file, in the form that the case has."""

    def __init__(self, form, gold):
        self.form, self.gold, self.bytes = form, gold, b''
        self.order = '>' if form.endswith('big') else '<'

    def put(self, data):
        if self.form.startswith('fortran'):
            mark = struct.pack(self.order + 'i', len(data))
            data = mark + data + mark
        self.bytes += data

    def line(self, text):
        self.put((text + '\n').encode() if self.form == 'text' else text.encode().ljust(80, b'\0'))

    def ints(self, values, columns=1):
        values = [int(value) for value in values]
        if self.form != 'text':
            return self.put(struct.pack(f'{self.order}{len(values)}i', *values))
        width = 10 if self.gold else 8
        for i in range(0, len(values), columns):
            self.put(''.join(f'{value:{width}d}' for value in values[i:i + columns]).encode() + b'\n')

    def reals(self, values, columns=0):
        columns = columns or (1 if self.gold else 6)
        values = [float(value) for value in values]
        if self.form != 'text':
            return self.put(struct.pack(f'{self.order}{len(values)}f', *values))
        for i in range(0, len(values), columns):
            self.put(''.join(f'{value:12.5e}' for value in values[i:i + columns]).encode() + b'\n')


def corners(n, i, j, k):
    at = i + n[0] * (j + n[1] * k)
    up = n[0] * n[1]
    return [at, at + 1, at + 1 + n[0], at + n[0], at + up, at + 1 + up, at + 1 + n[0] + up, at + n[0] + up]


class Part:
    def __init__(self, rand, numbers, gold, shift):
        kinds = ['unstructured', 'unstructured', 'curvilinear'] + (['rectilinear', 'uniform'] if gold else [])
        self.kind = rand.choice(kinds)
        self.n = n = [rand.randint(2, 4) for _ in range(3)]
        self.axes = [numpy.cumsum(numbers.integers(4, 9, count)) / 8 for count in n]
        if self.kind == 'uniform':
            self.axes = [numpy.arange(count) * 0.5 for count in n]
        self.axes[0] = self.axes[0] + shift
        z, y, x = numpy.meshgrid(*self.axes[::-1], indexing='ij')
        self.points = numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
        if self.kind in ('unstructured', 'curvilinear'):
            self.points = self.points + numbers.integers(-1, 2, self.points.shape) / 8
        self.blanks, self.elements = None, []
        if self.kind == 'curvilinear' and rand.random() < 0.4:
            blanks = (numbers.random(len(self.points)) > 0.05).astype(int)
            if self.centers(blanks[:, None].astype(float)).max() == 1:  # a cell is left
                self.blanks = blanks
        hexahedra = [corners(n, i, j, k) for k in range(n[2] - 1) for j in range(n[1] - 1) for i in range(n[0] - 1)]
        self.count = len(hexahedra)
        if self.kind == 'unstructured':
            self.elements = self.make_elements(rand, hexahedra, gold)
            self.count = sum(len(cells) for _, cells in self.elements)

    @staticmethod
    def make_elements(rand, hexahedra, gold):
        kinds = {name: [] for name in ['hexa8', 'penta6', 'tetra4', 'pyramid5', 'nfaced', 'quad4', 'nsided', 'point']}
        for h in hexahedra:
            way = rand.choice(['hexa8', 'hexa8', 'penta6', 'tetra4', 'pyramid5'] + (['nfaced'] if gold else []))
            if way == 'hexa8':
                kinds[way].append(h)
            elif way == 'penta6':
                kinds[way] += [[h[0], h[1], h[2], h[4], h[5], h[6]], [h[0], h[2], h[3], h[4], h[6], h[7]]]
            elif way == 'tetra4':
                kinds[way] += [[h[0], h[1], h[2], h[5]], [h[0], h[2], h[3], h[7]], [h[0], h[5], h[7], h[4]],
                               [h[2], h[7], h[5], h[6]], [h[0], h[2], h[7], h[5]]]
            elif way == 'pyramid5':
                kinds[way] += [[h[0], h[1], h[2], h[3], h[4]], [h[1], h[5], h[6], h[2], h[4]],
                               [h[2], h[6], h[7], h[3], h[4]]]
            else:
                sides = [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
                kinds[way].append([[h[i] for i in side] for side in sides])
        kinds['quad4'] = [h[:4] for h in hexahedra[:rand.randint(0, 2)]]
        kinds['point'] = [h[:1] for h in hexahedra[:rand.randint(0, 1)]]
        if gold:
            kinds['nsided'] = [h[:rand.randint(3, 4)] for h in hexahedra[:rand.randint(0, 2)]]
        order = list(kinds.items())
        rand.shuffle(order)
        order = [(name, cells) for name, cells in order if cells]
        if not any(name in ('hexa8', 'penta6', 'tetra4', 'pyramid5', 'nfaced') for name, _ in order):
            order.append(('hexa8', [hexahedra[0]]))
        return order

    def centers(self, points):
        """The mean of each cell's corners."""
        if self.kind != 'unstructured':
            n = self.n
            return numpy.array([points[corners(n, i, j, k)].mean(axis=0) for k in range(n[2] - 1)
                                for j in range(n[1] - 1) for i in range(n[0] - 1)])
        nodes = [sorted({p for face in cell for p in face}) if name == 'nfaced' else cell
                 for name, cells in self.elements for cell in cells]
        return numpy.array([points[own].mean(axis=0) for own in nodes])


class Case:
    def __init__(self, seed):
        self.rand = rand = random.Random(f'ensight:{seed}')
        self.numbers = numpy.random.default_rng(rand.randrange(1 << 30))
        self.gold = rand.random() < 0.7
        self.form = rand.choice(['text', 'text', 'c', 'c big', 'fortran', 'fortran big'])
        self.ids = [rand.choice(['off', 'given', 'assign', 'ignore']) for _ in range(2)]
        self.parts = {rand.choice([i, 7 * i + 1]): Part(rand, self.numbers, self.gold, 40 * i)
                      for i in range(1, rand.randint(2, 4))}
        self.sets = {}
        for number in range(1, rand.randint(1, 4)):
            count = rand.randint(1, 4)
            times = numpy.cumsum(self.numbers.integers(1, 5, count)) / 4 - rand.choice([0, 1])
            files = list(range(count))
            way = rand.choice(['start', 'numbers'])
            if way == 'start':
                start, step = rand.randint(0, 12), rand.randint(1, 3)
                files = [start + step * i for i in range(count)]
                said = f'filename start number: {start}\nfilename increment: {step}\n'
            else:
                files = sorted(rand.sample(range(200), count))
                said = 'filename numbers: ' + rand.choice([' ', '\n']).join(map(str, files)) + '\n'
            self.sets[number] = (times, files, said)
        self.single = set()  # of files with all steps

    def spread(self, name, number):
        """How a name stands in the case, how many steps it has, and where step i is written."""
        if number is None:
            return name, 1, [(name, 0)]
        times, files, _ = self.sets[number]
        if self.rand.random() < 0.4:
            self.single.add(number)
            return f'{number} {number} {{}}{name}', len(times), [(name, i) for i in range(len(times))]
        stars = self.rand.choice([1, 4])
        return f'{number} {{}}{name}.{"*" * stars}', len(times), [(f'{name}.{file:0{stars}d}', 0) for file in files]

    def choose_set(self):
        return self.rand.choice([None] + list(self.sets))

    def step_at(self, number, time):
        if number is None:
            return 0
        times = self.sets[number][0]
        return max([i for i in range(len(times)) if times[i] <= time], default=0)

    def save(self, folder, name, places, write, is_geometry):
        whole = {}
        for i, (file, _) in enumerate(places):
            writer = whole.setdefault(file, Writer(self.form, self.gold))
            if not writer.bytes and is_geometry and self.form != 'text':
                writer.line('C Binary' if self.form.startswith('c') else 'Fortran Binary')
            steps = len(places) > 1 and places[0][0] == places[-1][0]
            if steps:
                writer.line('BEGIN TIME STEP')
            write(writer, i)
            if steps:
                writer.line('END TIME STEP')
        for file, writer in whole.items():
            (folder / file).write_bytes(writer.bytes)

    def write(self, folder):
        rand = self.rand
        said = ['FORMAT', f'type:   ensight{" gold" if self.gold else ""}', '# a comment', 'GEOMETRY']
        self.model_set = self.choose_set()
        entry, steps, places = self.spread('g.geo', self.model_set)
        self.moves = [self.numbers.integers(0, 8) / 8 for _ in range(steps)]
        only = rand.random() < 0.3
        self.save(folder, 'g.geo', places,
                  lambda writer, i: self.write_geometry(writer, self.moves[i], not (only and i > 0)), True)
        said += ['model: ' + entry.format('') + (' change_coords_only' if only else ''), '', 'VARIABLE']
        self.variables = {}
        for v in range(rand.randint(1, 4)):
            self.add_variable(folder, f'v{v}', said)
        if rand.random() < 0.2:
            said.append('constant per case: Density 1.25')
        if self.sets:
            said.append('TIME')
        for number, (times, _, numbering) in self.sets.items():
            between = rand.choice([' ', '\n', '  \n '])
            said += [f'time set: {number}', f'number of steps: {len(times)}', numbering + 'time values: ' +
                     between.join(map(repr, times.tolist()))]
        if self.single:
            said.append('FILE')
        for number in sorted(self.single):
            said += [f'file set: {number}', f'number of steps: {len(self.sets[number][0])}']
        (folder / 'a.case').write_text('\n'.join(said) + '\n')

    def add_variable(self, folder, name, said):
        rand = self.rand
        per_node, components = rand.random() < 0.5, rand.choice([1, 1, 3, 6, 9])
        kind = {1: 'scalar', 3: 'vector', 6: 'tensor symm', 9: 'tensor asym'}[components]
        number = self.choose_set()
        entry, steps, places = self.spread(name + '.val', number)
        values = []
        for _ in range(steps):
            counts = {p: len(part.points) if per_node else part.count for p, part in self.parts.items()}
            values.append({p: self.numbers.integers(-800, 800, (count, components)) / 8 for p, count in counts.items()})
        self.variables[name] = (per_node, components, number, values)
        self.save(folder, name, places, lambda writer, i: self.write_values(writer, per_node, components, values[i]),
                  False)
        said.append(f'{kind} per {"node" if per_node else "element"}: ' +
                    (entry.format(name + ' ') if '{}' in entry else f'{name} {entry}'))

    def write_geometry(self, writer, move, with_cells):
        for text in ('a geometry', 'of two lines', f'node id {self.ids[0]}', f'element id {self.ids[1]}'):
            writer.line(text)
        node_ids, element_ids = (way in ('given', 'ignore') for way in self.ids)
        firsts = {}
        if not self.gold:
            loose = [part for part in self.parts.values() if part.kind == 'unstructured']
            points = numpy.concatenate([part.points + move for part in loose]) if loose else numpy.zeros((0, 3))
            first = 0
            for part in loose:
                firsts[part] = first
                first += len(part.points)
            self.given = 3 * numpy.arange(len(points)) + 5 if node_ids else numpy.arange(len(points)) + 1
            writer.line('coordinates')
            writer.ints([len(points)])
            if self.form == 'text':
                for i, point in enumerate(points):
                    text = f'{self.given[i]:8d}' if node_ids else ''
                    writer.put((text + ''.join(f'{value:12.5e}' for value in point) + '\n').encode())
            else:
                if node_ids:
                    writer.ints(self.given)
                writer.reals(points.ravel())
        for p, part in self.parts.items():
            writer.line('part' if self.gold else f'part {p}')
            if self.gold:
                writer.ints([p])
            writer.line(f'piece {p}')
            if part.kind == 'unstructured':
                self.write_unstructured(writer, part, move, firsts.get(part), node_ids, element_ids, with_cells)
            else:
                self.write_block(writer, part, move)

    def write_unstructured(self, writer, part, move, first, node_ids, element_ids, with_cells):
        if self.gold:
            writer.line('coordinates')
            writer.ints([len(part.points)])
            if node_ids:
                writer.ints(range(len(part.points), 0, -1))
            for axis in range(3):
                writer.reals(part.points[:, axis] + move)
        number = (lambda node: node + 1) if self.gold else (lambda node: self.given[first + node])
        for name, cells in part.elements if with_cells else []:
            writer.line(name)
            writer.ints([len(cells)])
            if element_ids and not (self.form == 'text' and not self.gold):
                writer.ints(range(1, len(cells) + 1))
            if name == 'nfaced':
                writer.ints([len(cell) for cell in cells])
                writer.ints([len(face) for cell in cells for face in cell])
                cells = [face for cell in cells for face in cell]
            elif name == 'nsided':
                writer.ints([len(cell) for cell in cells])
            lines = [[number(node) for node in cell] for cell in cells]
            if self.form != 'text':
                writer.ints([node for line in lines for node in line])
                continue
            for i, line in enumerate(lines):
                if element_ids and not self.gold:
                    line = [i + 1] + line
                writer.ints(line, len(line))

    def write_block(self, writer, part, move):
        kind = '' if part.kind == 'curvilinear' else ' ' + part.kind
        writer.line('block' + kind + (' iblanked' if part.blanks is not None else ''))
        writer.ints(part.n, 3)
        if part.kind == 'uniform':
            writer.reals([axis[0] + move for axis in part.axes] + [0.5] * 3)
        elif part.kind == 'rectilinear':
            for axis in part.axes:
                writer.reals(axis + move)
        else:
            for axis in range(3):
                writer.reals(part.points[:, axis] + move)
        if part.blanks is not None:
            writer.ints(part.blanks, 1 if self.gold else 10)

    def write_values(self, writer, per_node, components, values):
        writer.line('values')
        if not self.gold and per_node:
            loose = [values[p] for p, part in self.parts.items() if part.kind == 'unstructured']
            if loose:
                writer.reals(numpy.concatenate(loose).ravel())
        for p, part in self.parts.items():
            if not self.gold and per_node and part.kind == 'unstructured':
                continue
            writer.line('part' if self.gold else f'part {p}')
            if self.gold:
                writer.ints([p])
            if part.kind != 'unstructured':
                self.write_section(writer, 'block', values[p], True)
            elif per_node:
                self.write_section(writer, 'coordinates', values[p], True)
            else:
                first = 0
                for name, cells in part.elements:
                    self.write_section(writer, name, values[p][first:first + len(cells)], self.gold)
                    first += len(cells)

    def write_section(self, writer, name, values, by_component):
        """Some values are undefined in what is meant, too: those in `values` become NaN."""
        way = self.rand.choice(['', '', 'undef', 'partial']) if self.gold else ''
        missing = self.numbers.random(len(values)) < 0.2
        writer.line(f'{name} {way}'.strip())
        written = values.copy()
        if way == 'undef':
            writer.reals([-1e6])
            written[missing] = -1e6
            values[missing] = NAN
        elif way == 'partial':
            given = numpy.flatnonzero(~missing)
            writer.ints([len(given)])
            writer.ints(given + 1)
            values[missing] = NAN
            written = written[given]
        if not by_component:
            writer.reals(written.ravel())
        elif len(written):
            for component in range(values.shape[1]):
                writer.reals(written[:, component])


def pieces_of(path):
    """Of each piece of a .vtm its name, places, centers of cells and arrays."""
    found = {}
    for file in sorted(path.with_suffix('').iterdir()):
        reader = vtkXMLGenericDataObjectReader()
        reader.SetFileName(str(file))
        reader.Update()
        data = reader.GetOutput()
        points = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
        centers = []
        for c in range(data.GetNumberOfCells()):
            ids = data.GetCell(c).GetPointIds()
            corners_of = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
            centers.append(points[corners_of].mean(axis=0) if corners_of else [NAN] * 3)  # a blanked cell has none
        arrays = [{fields.GetArrayName(i): vtk_to_numpy(fields.GetArray(i)) for i in range(fields.GetNumberOfArrays())}
                  for fields in (data.GetPointData(), data.GetCellData())]
        found[len(found)] = (points, numpy.array(centers), *arrays)
    return found


def same(ours, wanted, what):
    assert ours.shape == wanted.shape, (what, ours.shape, wanted.shape)
    assert numpy.allclose(ours, wanted, rtol=0, atol=1e-6, equal_nan=True), (what, ours[:3], wanted[:3])


def compare(seed, folder):
    case = Case(seed)
    case.write(folder)
    times = sorted({time for times, _, _ in case.sets.values() for time in times.tolist()})
    time = case.rand.choice(times) if times else 0.0
    done = subprocess.run([VPROBE, 'convert', folder / 'a.case', '-o', folder / 'out.vtm', '--time', repr(time)],
                          capture_output=True, encoding='utf-8')
    assert done.returncode == 0, done.stderr
    used = {case.model_set} | {number for _, _, number, _ in case.variables.values()}
    used.discard(None)
    if used:
        times = sorted({t for number in used for t in case.sets[number][0].tolist()})
        time = min(times, key=lambda t: (abs(t - time), t))
    pieces = pieces_of(folder / 'out.vtm')
    wanted = sorted(case.parts)
    assert len(pieces) == len(wanted), (len(pieces), len(wanted))
    move = case.moves[case.step_at(case.model_set, time)]
    for place, p in enumerate(wanted):
        part = case.parts[p]
        points, centers, point_data, cell_data = pieces[place]
        where = part.points + move
        used = numpy.arange(len(where))
        if not case.gold and part.kind == 'unstructured':
            order = [node for _, cells in part.elements for cell in cells for node in cell]
            used = numpy.array(list(dict.fromkeys(order)))
        same(points, where[used], (p, part.kind, 'places'))
        wanted_centers = part.centers(where)
        if part.blanks is not None:
            wanted_centers[part.centers(part.blanks[:, None].astype(float))[:, 0] < 1] = NAN
        same(centers, wanted_centers, (p, part.kind, 'cells'))
        for name, (per_node, components, number, values) in case.variables.items():
            meant = values[case.step_at(number, time)][p]
            if components == 6:
                meant = meant[:, [0, 1, 2, 3, 5, 4]]
            meant = meant[used] if per_node else meant
            got = (point_data if per_node else cell_data)[name]
            same(got.reshape(len(got), -1).astype(float), meant, (p, part.kind, name))
        if part.blanks is not None and not part.blanks.all():
            marks = point_data['vtkGhostType']
            same((marks & 2 == 0).astype(float), part.blanks.astype(float), 'blanks')


def main():
    first, count = (int(word) for word in sys.argv[2:4]) if len(sys.argv) > 3 else \
        (1, how_many())
    failed = 0
    for seed in range(first, first + count):
        with tempfile.TemporaryDirectory(prefix='vprobe-ensight-') as folder:
            try:
                compare(seed, pathlib.Path(folder))
            except (AssertionError, KeyError) as error:
                failed += 1
                print(f'seed {seed}: FAILED: {error!r}'[:600])
    print(f'{count - failed} of {count} EnSight files as their writers meant them')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
