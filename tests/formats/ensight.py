"""EnSight cases of one or two cubes, with answers worked out by hand."""
import json
import struct
import subprocess

from against import VPROBE, cut, info, near, vprobe

CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
PLANE = ['--origin', .5, .5, .5, '--normal', 0, 0, 1]


def text_cube(scale=1.0):
    places = ''.join(f'{p[axis] * scale:12.5e}\n' for axis in range(3) for p in CUBE)
    return ('a cube\nof size\nnode id assign\nelement id assign\npart\n1\nbox\ncoordinates\n8\n' + places +
            'hexa8\n1\n1 2 3 4 5 6 7 8\n')


def text_values(value):
    return 'f\npart\n1\ncoordinates\n' + f'{value:12.5e}\n' * 8


def line(text):
    return text.encode().ljust(80, b'\0')


def binary_cube(order):
    return (line('a cube') + line('of size') + line('node id off') + line('element id off') + line('part') +
            struct.pack(order + 'i', 1) + line('box') + line('coordinates') + struct.pack(order + 'i', 8) +
            struct.pack(order + '24f', *(p[axis] for axis in range(3) for p in CUBE)) + line('hexa8') +
            struct.pack(order + '9i', 1, *range(1, 9)))


def binary_values(order, value):
    return line('f') + line('part') + struct.pack(order + 'i', 1) + line('coordinates') + struct.pack(order + '8f',
                                                                                                   *[value] * 8)


def steps(bodies, lined):
    if lined:
        return b''.join(line('BEGIN TIME STEP') + body + line('END TIME STEP') for body in bodies)
    return ''.join(f'BEGIN TIME STEP\n{body}END TIME STEP\n' for body in bodies)


def write(folder, case, **files):
    (folder / 'a.case').write_text('# a comment\nFORMAT\ntype: ensight gold\n' + case)
    for name, contents in files.items():
        path = folder / name.replace('__', '.')
        path.write_bytes(contents if isinstance(contents, bytes) else contents.encode())
    return folder / 'a.case'


def mean(path, *options):
    return cut(path, 'point:f', *PLANE, *options)['mean']


def refused(path, *words):
    done = subprocess.run([VPROBE, 'info', path], capture_output=True, encoding='utf-8')
    assert done.returncode == 2 and done.stderr.count('\n') == 1, done
    for word in words:
        assert word in done.stderr, (word, done.stderr)


def ensight_time_sets(folder):
    """The geometry doubles at time 2; f has the times 1 and 3, in files by their numbers."""
    case = write(folder, 'GEOMETRY\nmodel: 1 g**.geo\nVARIABLE\nscalar per node: 2 f "f **.scl"\nTIME\ntime set: 1\n'
                 'number of steps: 2\nfilename start number: 0\nfilename increment: 5\ntime values: 0.0\n 2.0\n'
                 'time set: 2\nnumber of steps: 2\nfilename numbers: 7\n 40\ntime values: 1 3.\n',
                 g00__geo=text_cube(), g05__geo=text_cube(2))
    (folder / 'f 07.scl').write_text(text_values(10))
    (folder / 'f 40.scl').write_text(text_values(-4))
    assert info(case)['times'] == [0, 1, 2, 3], info(case)['times']
    for time, area, value in ((0, 1, 10), (1, 1, 10), (2, 4, 10), (3, 4, -4)):
        sheet = cut(case, 'point:f', *PLANE, '--time', time)
        assert near(sheet['area'], area) and near(sheet['mean'], value), (time, sheet)
    done = subprocess.run([VPROBE, 'info', case, '--time', 'first'], capture_output=True, encoding='utf-8', check=True)
    assert 'f is shown at time 1, its first' in done.stderr, done.stderr


def ensight_steps_in_a_file(folder):
    sets = ('TIME\ntime set: 1\nnumber of steps: 3\ntime values: 0 0.25 0.5\nFILE\nfile set: 1\nnumber of steps: 3\n')
    body = 'GEOMETRY\nmodel: {}g.geo\nVARIABLE\nscalar per node: 1 1 f f.scl\n' + sets
    forms = {'text': (text_cube(), steps(map(text_values, (1, 2, 4)), False))}
    for order in '<>':
        forms[order] = (line('C Binary') + binary_cube(order),
                        steps([binary_values(order, value) for value in (1, 2, 4)], True))
        forms[order + 'moving'] = (line('C Binary') + steps([binary_cube(order)] * 3, True), forms[order][1])
    for name, (geometry, values) in forms.items():
        case = write(folder, body.format('1 1 ' if 'moving' in name else ''), g__geo=geometry, f__scl=values)
        for time, value in ((0, 1), (0.25, 2), (0.5, 4)):
            assert near(mean(case, '--time', time), value), (name, time)
    # Two files of the set, of two steps and one.
    case = write(folder, 'GEOMETRY\nmodel: g.geo\nVARIABLE\nscalar per node: 1 1 f f*.scl\n' +
                 sets.replace('file set: 1\nnumber of steps: 3', 'file set: 1\nfilename index: 4\nnumber of steps: 2\n'
                              'filename index: 6\nnumber of steps: 1'), g__geo=text_cube(),
                 f4__scl=steps(map(text_values, (1, 2)), False), f6__scl=steps([text_values(4)], False))
    for time, value in ((0, 1), (0.25, 2), (0.5, 4)):
        assert near(mean(case, '--time', time), value), time
    case = write(folder, body.format(''), g__geo=text_cube(), f__scl=steps(map(text_values, (1, 2)), False))
    refused(case, 'f.scl holds 2 steps, fewer than its time set')
    case = write(folder, body.format('').replace('1 1 f', 'f'), g__geo=text_cube(),
                 f__scl=steps(map(text_values, (1, 2)), False))
    refused(case, 'several steps', 'no time set')


def ensight_undefined(folder):
    """Of eight values one is undefined, or half are given: those that are left count."""
    body = 'GEOMETRY\nmodel: g.geo\nVARIABLE\nscalar per node: f f.scl\nconstant per case: Density 1.5\n'
    case = write(folder, body, g__geo=text_cube(),
                 f__scl='f\npart\n1\ncoordinates undef\n-999\n' + '-999\n' + '5\n' * 7)
    array = info(case)['arrays'][0]
    assert array['range'] == [5, 5], array
    case = write(folder, body, g__geo=text_cube(), f__scl='f\npart\n1\ncoordinates partial\n2\n1\n8\n3.5\n-1.0-100\n')
    assert near(info(case)['arrays'][0]['range'][1], 3.5)
    done = subprocess.run([VPROBE, 'info', case], capture_output=True, encoding='utf-8', check=True)
    assert 'Density = 1.5' in done.stderr, done.stderr
    for values, words in (('5\n' * 7, 'ends early'), ('5\n' * 9, '"5"'), ('5\n' * 7 + 'five\n', '"five"')):
        case = write(folder, body, g__geo=text_cube(), f__scl='f\npart\n1\ncoordinates\n' + values)
        refused(case, words)


def ensight_moving_points(folder):
    """A geometry whose later steps have their coordinates alone."""
    case = write(folder, 'GEOMETRY\nmodel: 1 g*.geo change_coords_only\nTIME\ntime set: 1\nnumber of steps: 2\n'
                 'filename start number: 0\nfilename increment: 1\ntime values: 0 1\n', g0__geo=text_cube(),
                 g1__geo=text_cube(3).split('hexa8')[0])
    for time, area in ((0, 1), (1, 9)):
        assert near(cut(case, None, *PLANE, '--time', time)['area'], area), time


def gmsh_groups(folder):
    """Two cubes; the first one is in two groups, which version 2 writes twice. A view begins at time 1."""
    nodes = [(x, y, z) for z in range(2) for y in range(2) for x in range(3)]
    mesh = ('$MeshFormat\n2.2 0 8\n$EndMeshFormat\n'
            '$PhysicalNames\n3\n2 7 "floor"\n3 1 "all"\n3 2 "left"\n$EndPhysicalNames\n'
            '$Nodes\n12\n' + ''.join(f'{10 * i + 5} {x} {y} {z}\n' for i, (x, y, z) in enumerate(nodes)) +
            '$EndNodes\n')
    left, right = ((0, 1, 4, 3, 6, 7, 10, 9), (1, 2, 5, 4, 7, 8, 11, 10))
    elements = [('5 2 1 1', left), ('5 2 1 1', right), ('5 2 2 1', left), ('3 2 7 9', (0, 1, 4, 3))]
    mesh += '$Elements\n4\n'
    for i, (tags, cell) in enumerate(elements):
        mesh += f'{i + 1} {tags} ' + ' '.join(str(10 * node + 5) for node in cell) + '\n'
    mesh += '$EndElements\n'
    view = ('$ElementData\n1\n"g"\n1\n{time}\n3\n{step}\n1\n2\n2 {a}\n3 {b}\n$EndElementData\n')
    mesh += view.format(time=1.0, step=0, a=5, b=7) + view.format(time=2.0, step=1, a=6, b=8)
    mesh += view.format(time=0.0, step=0, a=1, b=3).replace('"g"', '"h"')
    path = folder / 'm.msh'
    path.write_text(mesh)
    sheet = cut(path, 'cell:gmsh:physical:left', *PLANE)
    assert near(sheet['area'], 2) and near(sheet['mean'], 0.5), sheet
    assert near(cut(path, 'cell:gmsh:physical:all', *PLANE)['min'], 1)
    stats = folder / 'stats.json'
    vprobe('slice', path, '--surface', 'patch=floor', '--stats', stats)
    assert near(json.loads(stats.read_text())['sheets'][0]['area'], 1)
    assert info(path)['times'] == [0, 1, 2]
    for time, g, h in ((0, 6, 2), (1, 6, 2), (2, 7, 2)):
        for name, value in (('cell:g', g), ('cell:h', h)):
            assert near(cut(path, name, *PLANE, '--time', time)['mean'], value), (time, name)
    old = folder / 'old.msh'
    old.write_text('$NOD\n8\n' + ''.join(f'{i + 1} {x} {y} {z}\n' for i, (x, y, z) in enumerate(CUBE)) +
                   '$ENDNOD\n$ELM\n1\n1 5 3 4 8 1 2 3 4 5 6 7 8\n$ENDELM\n')
    sheet = cut(old, 'cell:gmsh:physical', *PLANE)
    assert near(sheet['area'], 1) and sheet['mean'] == 3, sheet


CASES = [ensight_time_sets, ensight_steps_in_a_file, ensight_undefined, ensight_moving_points, gmsh_groups]
