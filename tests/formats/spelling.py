#!/usr/bin/env python3
"""Numbers in text as programs write them, counts that do not fit, and arrays that share a name.

usage: spelling.py VPROBE

Two unit cells along x hold the values 1e-100 and 5, -2.5 and 5, inf and 5 ... in each format, written as C, Fortran and
VTK write them.
"""
import math
import pathlib
import subprocess
import sys
import tempfile

VPROBE = sys.argv[1]

# Each pair of words, and the two numbers.
PAIRS = [('1.0-100 5', 1e-100, 5), ('-2.5D+0 5', -2.5, 5), ('1D2 5', 100, 5), ('1q1 5.', 10, 5), ('1.5+2 5', 150, 5),
         ('5 nan', 5, math.nan), ('NaN 5', math.nan, 5), ('5 -NAN', 5, math.nan), ('nan(0x7) 5', math.nan, 5),
         ('inf 5', math.inf, 5), ('5 Infinity', 5, math.inf), ('-INF 5', -math.inf, 5), ('5 +infinity', 5, math.inf),
         ('1.#QNAN 5', math.nan, 5), ('1.#INF 5', math.inf, 5), ('+3 5', 3, 5), ('.5 5', 0.5, 5)]
POINTS = '0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0 0 0 1 1 0 1 2 0 1 0 1 1 1 1 1 2 1 1'
CORNERS = '0 1 4 3 6 7 10 9 1 2 5 4 7 8 11 10'


def xml(kind, inside, attributes=''):
    return (f'<VTKFile type="{kind}" version="0.1" byte_order="LittleEndian"><{kind}{attributes}>{inside}</{kind}>'
            '</VTKFile>')


def array(words, name='c', kind='Float64', components=1):
    about = f'type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii"'
    return f'<DataArray {about}>{words}</DataArray>'


def vtu(arrays, more='', points=POINTS, corners=CORNERS, offsets='8 16'):
    cells = array(corners, 'connectivity', 'Int64') + array(offsets, 'offsets', 'Int64')
    cells += array('12 12', 'types', 'UInt8')
    return xml('UnstructuredGrid', '<Piece NumberOfPoints="12" NumberOfCells="2"><Points>' +
               array(points, 'p', components=3) + f'</Points><Cells>{cells}</Cells><CellData>' +
               ''.join(array(words, name) for name, words in arrays) + f'{more}</CellData></Piece>')


def lattice(kind, arrays, inside='', attributes=''):
    fields = ''.join(array(f'\n{words}\n', name) for name, words in arrays)
    return xml(kind, f'<Piece Extent="0 2 0 1 0 1">{inside}<CellData>{fields}</CellData></Piece>',
               f' WholeExtent="0 2 0 1 0 1"{attributes}')


def vti(arrays):
    return lattice('ImageData', arrays, attributes=' Origin="0D0 0 -0.0" Spacing="1.0+0 1 1E0"')


def vtr(arrays):
    axes = ''.join(array(a, 'xyz'[i]) for i, a in enumerate(('0 1d0 2', '0 1', '0.0+0 1.')))
    return lattice('RectilinearGrid', arrays, f'<Coordinates>{axes}</Coordinates>')


def vts(arrays):
    return lattice('StructuredGrid', arrays, f'<Points>{array(POINTS, "p", "Float32", 3)}</Points>')


def scalars(arrays):
    return 'CELL_DATA 2\n' + ''.join(f'SCALARS {name} double 1\nLOOKUP_TABLE default\n{words}\n'
                                      for name, words in arrays)


def legacy(arrays, more=''):
    return ('# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 12 double\n' + POINTS +
            '\nCELLS 2 18\n8 0 1 4 3 6 7 10 9\n8 1 2 5 4 7 8 11 10\nCELL_TYPES 2\n12 12\n' + scalars(arrays) + more)


def legacy_new(arrays):
    ranges = 'METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 nan inf\n\n'
    return ('# vtk DataFile Version 5.1\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 12 float\n' + POINTS +
            f'\nCELLS 3 16\nOFFSETS vtktypeint64\n0 8 16\nCONNECTIVITY vtktypeint64\n{CORNERS}\nCELL_TYPES 2\n12 12\n'
            f'CELL_DATA 2\nFIELD FieldData {len(arrays)}\n' +
            ''.join(f'{name} 1 2 double\n{words}\n{ranges}' for name, words in arrays))


def legacy_image(arrays):
    return ('# vtk DataFile Version 2.0\ntitle\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nORIGIN 0 0 0\n'
            'SPACING 1D0 1.0+0 1\n' + scalars(arrays))


def ucd(arrays, more=''):
    places = POINTS.split()
    nodes = ''.join(f'{i + 1} {places[3 * i]}d0 {places[3 * i + 1]} {places[3 * i + 2]}\n' for i in range(12))
    first, second = (' '.join(words.split()[i] for _, words in arrays) for i in (0, 1))
    return (f'12 2 0 {len(arrays)} 0\n{nodes}1 0 hex 7 8 11 10 1 2 5 4\n2 0 hex 8 9 12 11 2 3 6 5\n'
            f'{len(arrays)} {" ".join("1" * len(arrays))}\n' + ''.join(f'{name}, K\n' for name, _ in arrays) +
            f'1 {first}\n2 {second}\n{more}')


WRITERS = [('.vtu', vtu), ('.vti', vti), ('.vtr', vtr), ('.vts', vts), ('.vtk', legacy), ('.vtk', legacy_new),
           ('.vtk', legacy_image), ('.inp', ucd)]


def one(words):
    return [('c', words)]


class Failed(Exception):
    pass


def run(*arguments):
    return subprocess.run([VPROBE, *map(str, arguments)], capture_output=True, encoding='utf-8')


def values(path, folder, name=None):
    """The values of an array in both cells, or of all, by name; and the words on standard error."""
    places = folder / 'places.txt'
    places.write_text('0.5 0.5 0.5\n1.5 0.5 0.5\n')
    done = run('sample', path, '--points', places, *(['--array', name] if name else []))
    if done.returncode:
        raise Failed(f'{path.name}: {done.stderr}')
    rows = [line.split(',') for line in done.stdout.split('\n') if line]
    columns = {title: [float(row[i]) for row in rows[1:]] for i, title in enumerate(rows[0]) if i > 4}
    return (next(iter(columns.values())) if name else columns), done.stderr


def same(a, b):
    return a == b or (a != a and b != b) or abs(a - b) <= 1e-6 * abs(b)


def every_spelling(folder):
    arrays = [(f'c{i}', words) for i, (words, _, _) in enumerate(PAIRS)]
    for ending, write in WRITERS:
        path = folder / f'f{ending}'
        path.write_text(write(arrays))
        found, _ = values(path, folder)
        for i, (words, *wanted) in enumerate(PAIRS):
            if not all(same(a, b) for a, b in zip(found[f'c{i}'], wanted)) or len(found[f'c{i}']) != 2:
                raise Failed(f'{write.__name__}: "{words}" gives {found[f"c{i}"]}')


def pieces(folder):
    """An index of pieces, and an index of blocks."""
    (folder / 'a.vtu').write_text(vtu(one('1.0-1 Infinity')))
    points = '<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>'
    fields = '<PCellData><PDataArray type="Float64" Name="c"/></PCellData>'
    (folder / 'p.pvtu').write_text(xml('PUnstructuredGrid', f'{points}{fields}<Piece Source="a.vtu"/>'))
    (folder / 'm.vtm').write_text(xml('vtkMultiBlockDataSet', '<DataSet index="0" file="a.vtu"/>'))
    for name in ('p.pvtu', 'm.vtm'):
        found, _ = values(folder / name, folder, 'c')
        if found != [0.1, math.inf]:
            raise Failed(f'{name} gives {found}')


def plot3d(folder):
    """Places and a solution as Fortran writes lists. The density is 1 where x is 0, nan at 1, and 5 at 2."""
    grid, solution = folder / 'g.xyz', folder / 'g.q'
    x, y, z = '0 1D0 2., ' * 4, '3*0.0 3*1.0+0 ' * 2, '6*0, 6*1.0'
    grid.write_text(f'1\n3 2 2\n{x}\n{y}\n{z}\n')
    density = '1.0 nan 5.0-0 ' * 4
    solution.write_text(f'1\n3 2 2\n0.5 0 1D6 0\n{density}\n36*1\n12*2.5D0\n')
    places = folder / 'places.txt'
    places.write_text('0 0.5 0.5\n2 0.5 0.5\n')
    done = run('sample', grid, '--points', places, '--array', 'StagnationEnergy')
    if done.returncode or [row.split(',')[5] for row in done.stdout.split()[1:]] != ['2.5', '2.5']:
        raise Failed(f'{done.stdout}{done.stderr}')
    done = run('slice', grid, '--normal', 'z', '--array', 'Density')
    words = done.stdout.split('\n')[1].split()
    if done.returncode or words[5] != '2' or words[7:9] != ['1', '5']:
        raise Failed(f'{done.stdout}{done.stderr}')
    for text, wanted in ((f'1\n3 2 2\n{x}\n{y}\n{z} 7\n', 'layout'), (f'1\n3 2 2\n{x}\n{y}\n6*0, 6*x\n', 'x')):
        grid.write_text(text)
        done = run('slice', grid, '--normal', 'z')
        if done.returncode != 2 or wanted not in done.stderr:
            raise Failed(f'{wanted}: {done.returncode} {done.stderr}')


def refused(folder):
    """Words that are no numbers, and too few or too many values, each with a word of the line."""
    other_piece = vtu([('e', '5 6')]).split('<Piece')[1].split('</Piece>')[0]
    two_pieces = vtu(one('1 2')).replace('</Piece>', f'</Piece><Piece{other_piece}</Piece>')
    cases = [('.vtu', two_pieces, 'not in all of its pieces'),
             ('.vtu', vtu(one('1 2 3')), 'cell array c has 3 values where 2'),
             ('.vtu', vtu(one('1')), 'has 1 values'),
             ('.vtu', vtu(one('1 x2')), '"x2"'),
             ('.vtu', vtu(one('1 2'), points=POINTS + ' 1 1 1'), '39 values'),
             ('.vtu', vtu(one('1 2'), corners=CORNERS + ' 3'), '17 values where 16'),
             ('.vtu', vtu(one('1 2'), corners=CORNERS[:-3]), '15 values where 16'),
             ('.vtu', vtu(one('1 2'), offsets='8 16 24'), '24 belong'),
             ('.vtu', vtu(one('1 2'), corners=CORNERS + ' nan'), 'nan'),
             ('.vtu', vtu(one('1 2'), array('300 1', 'u', 'UInt8')), '"300"'),
             ('.vtu', vtu(one('1 2'), array('1e99 1', 'f', 'Float32')), '"1e99"'),
             ('.vti', vti(one('1 2 3')), '3 values'),
             ('.vti', vti(one('1 2')).replace('"0D0', '"nan'), 'Origin'),
             ('.vti', vti(one('1 2')).replace('1.0+0 1', '1.0+0'), 'Spacing'),
             ('.vtr', vtr(one('1 2')).replace('1d0', ''), '2 values'),
             ('.vts', vts(one('1 2')).replace('>0 0 0', '>0 0'), '35 values'),
             ('.vtk', legacy(one('1 2 3')), '"3"'),
             ('.vtk', legacy(one('1')), '1 values where 2'),
             ('.vtk', legacy(one('1 x')), '"x"'),
             ('.vtk', legacy(one('1 2')).replace('POINTS 12', 'POINTS 13'), 'CELLS'),
             ('.vtk', legacy(one('1 2')).replace('POINTS 12', 'POINTS 11'), 'points'),
             ('.vtk', legacy_new(one('1 2')).replace('0 8 16', '0 8 15'), '15'),
             ('.vtk', legacy_new(one('1 2')).replace('CELLS 3 16', 'CELLS 3 15'), '15 corners'),
             ('.inp', ucd(one('1 2'), '3 4\n'), '"3"'),
             ('.inp', ucd(one('1 x')), '"x"')]
    for ending, text, wanted in cases:
        path = folder / f'bad{ending}'
        path.write_text(text)
        done = run('slice', path, '--normal', 'z')
        if done.returncode != 2 or wanted not in done.stderr or done.stderr.strip().count('\n'):
            raise Failed(f'{ending}, where {wanted!r} is wanted: {done.returncode} {done.stderr}')


def one_name(folder):
    """The later array of two gets a name of its own; arrays of points and of cells may share one."""
    numbers = ' '.join(map(str, range(12)))
    point = f'POINT_DATA 12\nSCALARS c float\nLOOKUP_TABLE default\n{numbers}\n'
    twice = {'.vtu': vtu(one('1 2'), array('3 4') + array('7 8', 'c 2')),
             '.vtk': legacy(one('1 2'), 'FIELD f 2\nc 1 2 int\n3 4\nc%202 1 2 int\n7 8\n' + point),
             '.inp': ucd([('c', '1 2'), ('c', '3 4')])}
    for ending, text in twice.items():
        path = folder / f'twice{ending}'
        path.write_text(text)
        first, words = values(path, folder, 'cell:c')
        if first != [1, 2] or 'are called c' not in words:
            raise Failed(f'{path.name}: {first} {words}')
        own = words[words.index('shown as ') + 9:].split('\n')[0]
        second, _ = values(path, folder, own)
        if second != [3, 4]:
            raise Failed(f'{path.name}: {own} is {second}')
    both, _ = values(folder / 'twice.vtk', folder, 'point:c')
    if both != [5, 6]:
        raise Failed(f'the point array c is {both}')


def main():
    with tempfile.TemporaryDirectory(prefix='vprobe-spelling-') as name:
        failed = 0
        for check in (every_spelling, pieces, plot3d, refused, one_name):
            try:
                check(pathlib.Path(name))
                print(f'{check.__name__}: ok')
            except Failed as error:
                failed += 1
                print(f'{check.__name__}: FAILED: {error}')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
