#!/usr/bin/env python3
"""Tecplot text files in many spellings, read by vprobe, and by meshio where it can.

usage: tecplot.py VPROBE [FIRST-SEED COUNT]

Half of the files are meshio's, read back by meshio. VTK has no writer of Tecplot files, so this program writes the
other half, after the Tecplot 360 Data Format Guide: zones ordered and of elements, by points and by variables, old
keywords and new ones, shared and passive variables, places of variables, times and strands, texts and drawings between
them. Their right values are those that were to be written.
"""
import random
import shutil

from common import go_through, info, need, refused, run, same

need('numpy', 'vtkmodules')

import numpy  # noqa: E402
from grids import arrays_of, cells_of, grid_of, points_of  # noqa: E402

HEXAHEDRON = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
TETRAHEDRA = ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6))
# Bricks with corners that are the same: wedges, pyramids, tetrahedra.
COLLAPSED = {(0, 1, 2, 2, 4, 5, 6, 6): 6, (0, 1, 2, 3, 4, 4, 4, 4): 5, (0, 1, 2, 2, 4, 4, 4, 4): 4}
BETWEEN = ['', '# a comment with ZONE and 1 2 3\n',
           'TEXT X=10, Y=90, CS=FRAME, H=2.5\nC=RED T="Re = 1e5,\\nZONE"\n',
           'GEOMETRY X=0, Y=0, T=LINE, C=RED, CS=GRID\n1\n3\n0 0\n1.5 0\n1 1\n',
           "CUSTOMLABELS 'MON','TUE', \"WED\"\n", 'DATASETAUXDATA Common.Incompressible="TRUE"\n',
           'VARAUXDATA 1 unit="m"\n', 'TEXT\nX=1 Y=2 T=\'it\' ZN=1\nGEOMETRY T=CIRCLE X=1 Y=2\n0.5\n']


class Zone:
    def __init__(self, pick, numbers, names, zones):
        self.pick, self.names = pick, names
        self.kind = pick.choice(['ordered', 'ordered', 'BRICK', 'BRICK', 'TETRAHEDRON', 'POLYHEDRON'])
        self.sides = [pick.randint(2, 4) for _ in range(3)]
        nx, ny, nz = self.sides
        self.points = numpy.array([(i, j, k) for k in range(nz) for j in range(ny) for i in range(nx)], float)
        self.points = self.points * [1.5, -2.25, 0.125] + numbers.integers(-9, 9, 3)
        boxes = [[i + a + nx * (j + b + ny * (k + c)) for a, b, c in CORNERS]
                 for k in range(nz - 1) for j in range(ny - 1) for i in range(nx - 1)]
        self.elements = boxes
        if self.kind == 'TETRAHEDRON':
            self.elements = [[box[c] for c in corners] for box in boxes for corners in TETRAHEDRA]
        elif self.kind == 'BRICK' and pick.random() < 0.4:
            self.elements = [box if pick.random() < 0.5 else [box[c] for c in pick.choice(list(COLLAPSED))]
                             for box in boxes]
        self.corners = [frozenset(element) for element in self.elements]
        self.blocks = self.kind == 'POLYHEDRON' or pick.random() < 0.5
        self.packs_old = self.kind != 'POLYHEDRON' and pick.random() < 0.4
        self.at_cells = {v for v in range(3, len(names)) if self.blocks and pick.random() < 0.4}
        self.passive = {v for v in range(3, len(names)) if not self.packs_old and pick.random() < 0.15}
        self.values = [self.make_values(numbers, v) for v in range(len(names))]
        self.shared, self.shares_corners, self.other = set(), False, None
        others = [z for z in zones if z.kind == self.kind and z.sides == self.sides]
        if others and pick.random() < 0.8:
            self.share_with(others[-1], zones)
        self.time, self.strand = None, None
        self.title = pick.choice(['a zone', 'fluid, hot', "it's", 'two\nlines']) + f' {len(zones)}'

    def make_values(self, numbers, v):
        if v < 3:
            return self.points[:, v]
        count = len(self.elements) if v in self.at_cells else len(self.points)
        values = numbers.integers(-9999, 9999, count) * 10.0 ** self.pick.choice([0, -3, 5, -104, 120])
        if self.pick.random() < 0.2:
            values[numbers.random(count) < 0.2] = self.pick.choice([numpy.nan, numpy.inf, -numpy.inf])
        if self.pick.random() < 0.2:
            values[count // 2:] = values[0]
        return values

    def share_with(self, other, zones):
        self.other = zones.index(other) + 1
        self.points = other.points
        self.shared = {0, 1, 2}
        for v in range(3):
            self.values[v] = other.values[v]
        for v in set(range(3, len(self.names))) - self.passive - other.passive:
            if (v in self.at_cells) == (v in other.at_cells) and len(self.elements) == len(other.elements) and \
                    self.pick.random() < 0.4:
                self.shared.add(v)
                self.values[v] = other.values[v]
        if self.kind != 'ordered' and self.pick.random() < 0.5:
            self.shares_corners = True
            self.elements, self.corners = other.elements, other.corners
            for v in self.at_cells - self.shared:
                self.values[v] = numpy.resize(self.values[v], len(self.elements))
        for v in [v for v in self.shared & self.at_cells if len(self.values[v]) != len(self.elements)]:
            self.shared.discard(v)
            self.values[v] = numpy.arange(len(self.elements), dtype=float)

    def number(self, value):
        pick = self.pick
        if value != value:
            return pick.choice(['nan', 'NaN', '-nan', '1.#QNAN', 'NAN'])
        if value in (numpy.inf, -numpy.inf):
            return ('-' if value < 0 else '') + pick.choice(['inf', 'Infinity', 'INF'])
        words = pick.choice(['{!r}', '{!r}', '{:.17E}', '{:+.17e}', 'D', 'none']).format(float(value))
        if words in 'Dnone':
            mantissa, exponent = f'{value:.17E}'.split('E')
            if words == 'D':
                return f'{mantissa}D{int(exponent):+03d}'
            return f'{mantissa}{int(exponent):+04d}' if abs(int(exponent)) >= 100 else f'{mantissa}d{int(exponent)}'
        return words

    def list_of(self, variables):
        """ "[1,3-5]", as sets of variables are written."""
        numbers, parts = sorted(v + 1 for v in variables), []
        while numbers:
            last = 0
            while last + 1 < len(numbers) and numbers[last + 1] == numbers[last] + 1 and self.pick.random() < 0.8:
                last += 1
            parts.append(f'{numbers[0]}-{numbers[last]}' if last else str(numbers[0]))
            numbers = numbers[last + 1:]
        return f'[{",".join(parts)}]'

    def head(self):
        pick, keys = self.pick, []
        if self.kind == 'ordered':
            keys += [f'{axis}={side}' for axis, side in zip('IJK', self.sides)]
            if not self.packs_old and pick.random() < 0.5:
                keys.append('ZONETYPE=ORDERED')
        elif self.packs_old:
            keys += [f'N={len(self.points)}', f'E={len(self.elements)}', f'ET={self.kind}']
        else:
            keys += [pick.choice(['NODES={}', 'Nodes = {}', 'N={}']).format(len(self.points)),
                     pick.choice(['ELEMENTS={}', 'E={}']).format(len(self.elements)), f'ZONETYPE=FE{self.kind}']
        if self.kind == 'POLYHEDRON':
            self.make_faces()
            keys += [f'FACES={len(self.faces)}', f'TOTALNUMFACENODES={sum(len(f[0]) for f in self.faces)}',
                     'NUMCONNECTEDBOUNDARYFACES=0', 'TOTALNUMBOUNDARYCONNECTIONS=0']
        fe = '' if self.kind == 'ordered' else 'FE'
        packing = 'BLOCK' if self.blocks else 'POINT'
        if self.packs_old:
            keys.append(f'F={fe}{packing}')
        elif self.blocks or pick.random() < 0.9:
            keys.append(f'DATAPACKING={packing}')
        if self.at_cells:
            if pick.random() < 0.5:
                keys.append('VARLOCATION=(' + pick.choice([',', ' ', ', ']).join(
                    'CELLCENTERED' if v in self.at_cells else 'NODAL' for v in range(len(self.names))) + ')')
            else:
                keys.append(f'VARLOCATION=({self.list_of(self.at_cells)}=CELLCENTERED)')
        if self.passive:
            keys.append('PASSIVEVARLIST=' + pick.choice(['{}', '({})']).format(self.list_of(self.passive)))
        if self.shared:
            keys.append(f'VARSHARELIST=({self.list_of(self.shared)}={self.other})')
        if self.shares_corners:
            keys.append(f'CONNECTIVITYSHAREZONE={self.other}')
        if self.time is not None:
            keys.append(f'SOLUTIONTIME={self.time!r}')
        if self.strand is not None:
            keys.append(f'STRANDID={self.strand}')
        keys += [key for key in ('C=RED', f'DT=({"DOUBLE " * len(self.names)})', 'PARENTZONE=0',
                                 'AUXDATA Mach.Number="0.3, or 1"') if pick.random() < 0.2]
        pick.shuffle(keys)
        keys.insert(pick.randint(0, len(keys)), f'T="{self.title}"')
        glue = [pick.choice([', ', ' ', '\n', ',\n ', '  # a comment\n']) for _ in keys]
        return 'ZONE ' + ''.join(key + mark for key, mark in zip(keys, glue)) + '\n'

    def make_faces(self):
        """Each face with its left and its right element; a face's normal points to the right one."""
        sides = {}
        for number, box in enumerate(self.elements):
            for side in HEXAHEDRON:
                face = [box[c] for c in side]
                sides.setdefault(frozenset(face), []).append((face, number + 1))
        self.faces = []
        for pair in sides.values():
            (face, left), right = pair[0], pair[1][1] if len(pair) == 2 else 0
            if self.pick.random() < 0.5:
                face, left, right = face[::-1], right, left
            self.faces.append((face, left, right))

    def body(self):
        pick = self.pick
        own = [v for v in range(len(self.names)) if v not in self.passive | self.shared]
        if self.blocks:
            words = [word for v in own for word in self.repeated(self.values[v])]
        else:
            words = [self.number(self.values[v][i]) for i in range(len(self.points)) for v in own]
        per = pick.choice([1, 5, 10, 1000])
        text = ''.join(' '.join(words[i:i + per]) + '\n' for i in range(0, len(words), per))
        if self.kind == 'POLYHEDRON' and not self.shares_corners:
            for numbers in ([len(f[0]) for f in self.faces], [c + 1 for f in self.faces for c in f[0]],
                            [f[1] for f in self.faces], [f[2] for f in self.faces]):
                text += ' '.join(map(str, numbers)) + '\n'
        elif self.kind != 'ordered' and not self.shares_corners:
            text += ''.join(' '.join(str(c + 1) for c in element) + '\n' for element in self.elements)
        return text

    def repeated(self, values):
        """8*0.5 for eight values that follow each other."""
        at = 0
        while at < len(values):
            end = at + 1
            while end < len(values) and values[end] == values[at]:
                end += 1
            if end - at > 2 and self.pick.random() < 0.7:
                yield f'{end - at}*{self.number(values[at])}'
                at = end
            else:
                yield self.number(values[at])
                at += 1

    def check(self, grid, said):
        wanted = {name: v for v, name in enumerate(self.names) if v >= 3 and v not in self.passive}
        same(points_of(grid), self.points, 'points')
        if self.kind != 'ordered':
            assert cells_of(grid) == self.corners, (self.kind, cells_of(grid)[:3], self.corners[:3])
        at_points, at_cells = arrays_of(grid.GetPointData()), arrays_of(grid.GetCellData())
        assert set(at_points) | set(at_cells) == set(wanted), (set(at_points), set(at_cells), wanted)
        for name, v in wanted.items():
            found = at_cells if v in self.at_cells else at_points
            assert name in found, ('place', name)
            same(found[name][:, 0], self.values[v], name)
        for v in self.passive:
            assert self.names[v] in said, said


def blocks_of(path, folder, *options):
    """The grids of a file of several zones, by their names."""
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
    from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader
    done = run('convert', path, '-o', folder / 'out.vtm', *options)
    assert done.returncode == 0, done.stderr
    reader = vtkXMLMultiBlockDataReader()
    reader.SetFileName(str(folder / 'out.vtm'))
    reader.Update()
    root, blocks = reader.GetOutput(), {}
    for i in range(root.GetNumberOfBlocks()):
        name = root.GetMetaData(i).Get(vtkCompositeDataSet.NAME())
        assert name not in blocks, name
        blocks[name] = root.GetBlock(i)
    shutil.rmtree(folder / 'out')
    return blocks, done.stderr


def make_names(pick):
    forms = pick.choice([('X', 'Y', 'Z'), ('x', 'y', 'z'), ('X [m]', 'Y [m]', 'Z [m]'), ('CoordinateX', 'CoordinateY',
                        'CoordinateZ'), ('lon', 'lat', 'depth')])
    names = list(forms) + pick.sample(['V', 'pressure, static', 'rho (kg/m3)', 'T', 'two\nlines', 'k#1', 'a "b"'],
                                      pick.randint(1, 4))
    bare = not any(set(name) & set(' ,\n"()[]#') for name in names) and pick.random() < 0.3
    glue = pick.choice([', ', ' ', '\n', ',\n'])
    words = glue.join(name if bare else '"' + name.replace('"', '\\"') + '"' for name in names)
    return [name.replace('\n', ' ') for name in names], f'VARIABLES = {words}\n'


def by_hand(seed, folder):
    pick, numbers = random.Random(seed), numpy.random.default_rng(seed)
    names, variables = make_names(pick)
    zones = []
    for _ in range(pick.randint(1, 4)):
        zones.append(Zone(pick, numbers, names, zones))
    shown, options = zones, []
    if pick.random() < 0.5:
        times = pick.sample([0.0, 0.5, 1e-3, 2.0, 1.0000000001, 1.0], pick.randint(1, 3))
        for zone in zones:
            zone.strand = pick.choice([None, 1, 2, 0])
            zone.time = pick.choice(times)
        found = sorted({zone.time for zone in zones if zone.strand != 0})
        if found:
            index = pick.randrange(len(found))
            options = ['--time', pick.choice([f'#{index}', repr(found[index])])]
            shown = [zone for zone in zones if zone.strand == 0 or zone.time == found[index]]
    text = pick.choice(['', 'TITLE = "a, title"\n', 'FILETYPE=FULL\n']) + variables
    for zone in zones:
        text += pick.choice(BETWEEN) + zone.head() + zone.body()
    text += pick.choice(BETWEEN)
    path = folder / 'file.dat'
    path.write_text(text)
    if options:
        assert info(path)['times'] == found, (info(path)['times'], found)
    blocks, said = blocks_of(path, folder, *options)
    titles = [zone.title.replace('\n', ' ') for zone in shown]
    assert list(blocks) == titles, (list(blocks), titles)
    for zone, title in zip(shown, titles):
        zone.check(blocks[title], said)
    if seed % 10 == 1:
        refuse_damaged(zones[0], variables, folder / 'damaged.dat')


def refuse_damaged(zone, variables, path):
    """One value too many, or the last one missing: refused in a line."""
    text = variables + zone.head() + zone.body()
    path.write_text(text + ' 1\n')
    assert 'more values' in refused(path), refused(path)
    path.write_text(text.rstrip().rsplit(None, 1)[0] + '\n')
    refused(path)


def by_meshio(seed, folder):
    import meshio
    pick, numbers = random.Random(seed), numpy.random.default_rng(seed)
    nx, ny, nz = (pick.randint(2, 4) for _ in range(3))
    points = numpy.array([(i, j, k) for k in range(nz) for j in range(ny) for i in range(nx)], float)
    points += numbers.uniform(-0.2, 0.2, points.shape)
    boxes = [[i + a + nx * (j + b + ny * (k + c)) for a, b, c in CORNERS]
             for k in range(nz - 1) for j in range(ny - 1) for i in range(nx - 1)]
    kind = pick.choice(['tetra', 'hexahedron', 'mixed'])
    cells = [('hexahedron', numpy.array(boxes))]
    if kind == 'tetra':
        cells = [('tetra', numpy.array([[box[c] for c in t] for box in boxes for t in TETRAHEDRA]))]
    elif kind == 'mixed':
        wedges = [[boxes[0][c] for c in w] for w in ((0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7))]
        cells = [('wedge', numpy.array(wedges))] + ([('hexahedron', numpy.array(boxes[1:]))] if boxes[1:] else [])
    count = sum(len(block) for _, block in cells)
    starts = numpy.cumsum([len(block) for _, block in cells])[:-1]
    mesh = meshio.Mesh(points, cells, point_data={'f': numbers.normal(size=len(points)) * 1e5},
                       cell_data={'g': numpy.split(numbers.normal(size=count), starts)})
    path = folder / 'mesh.dat'
    meshio.write(path, mesh, file_format='tecplot')
    witness = meshio.read(path, file_format='tecplot')
    grid, _ = grid_of(path, folder)
    same(points_of(grid), witness.points, 'points')
    wanted = [frozenset(map(int, cell)) for block in witness.cells for cell in block.data]
    assert cells_of(grid) == wanted, (cells_of(grid)[:2], wanted[:2])
    same(arrays_of(grid.GetPointData())['f'][:, 0], witness.point_data['f'], 'f')
    same(arrays_of(grid.GetCellData())['g'][:, 0], numpy.concatenate(witness.cell_data['g']), 'g')
    same(arrays_of(grid.GetPointData())['f'][:, 0], mesh.point_data['f'], 'f', 1e-15)


def compare(seed, folder):
    if seed % 2:
        by_hand(seed, folder)
    else:
        need('meshio')
        by_meshio(seed, folder)


if __name__ == '__main__':
    go_through('Tecplot', compare)
