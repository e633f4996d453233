"""Straight cubes of every type of Exodus elements, by netCDF4, in each order that writers use."""
import itertools
import math

from against import cut, info, need
from damage import refused as damaged
from odd import refused

# Nodes between corners, in the order of the Exodus manual and of libMesh.
TETRAHEDRON = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
TRIANGLES = [(0, 1, 2), (1, 2, 3), (0, 2, 3), (0, 1, 3)]
WEDGE = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 4), (2, 5), (3, 4), (4, 5), (5, 3)]
ENDS, SIDES = [(0, 1, 2), (3, 4, 5)], [(0, 1, 3, 4), (1, 2, 4, 5), (0, 2, 3, 5)]
PYRAMID = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)]
SLOPES = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (0, 3, 4)]
HEXAHEDRON = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 5), (2, 6), (3, 7), (4, 5), (5, 6), (6, 7), (7, 4)]
QUADRILATERALS = [(0, 1, 2, 3), (4, 5, 6, 7), (0, 3, 4, 7), (1, 2, 5, 6), (0, 1, 4, 5), (2, 3, 6, 7)]
INSIDE = {4: (0, 1, 2, 3), 5: (0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 4), 6: tuple(range(6)), 8: tuple(range(8))}
FOUR, FIVE, SIX, EIGHT = ([INSIDE[n]] for n in (4, 5, 6, 8))
LATER = [SIDES[1], SIDES[2], SIDES[0]]

TYPES = [('TETRA4', 4, []), ('TETRA5', 4, FOUR), ('tet8', 4, TRIANGLES), ('TETRA10', 4, TETRAHEDRON),
         ('TETRA11', 4, TETRAHEDRON + FOUR), ('TETRA14', 4, TETRAHEDRON + TRIANGLES),
         ('TETRA15', 4, TETRAHEDRON + TRIANGLES + FOUR), ('WEDGE', 6, []),
         ('WEDGE12', 6, WEDGE[:3] + WEDGE[6:]), ('WEDGE15', 6, WEDGE), ('WEDGE16', 6, WEDGE + SIX),
         ('WEDGE18', 6, WEDGE + SIDES), ('WEDGE20', 6, WEDGE + ENDS + LATER),
         ('WEDGE21', 6, WEDGE + SIX + ENDS + LATER),
         ('PYRAMID5', 5, []), ('PYRAMID13', 5, PYRAMID), ('PYRAMID14', 5, PYRAMID + QUADRILATERALS[:1]),
         ('PYRAMID18', 5, PYRAMID + QUADRILATERALS[:1] + SLOPES),
         ('PYRAMID19', 5, PYRAMID + QUADRILATERALS[:1] + SLOPES + FIVE), ('HEX8', 8, []), ('HEX9', 8, EIGHT),
         ('HEX16', 8, HEXAHEDRON[:4] + HEXAHEDRON[8:]), ('HEX20', 8, HEXAHEDRON), ('HEX21', 8, HEXAHEDRON + EIGHT),
         ('HEX27', 8, HEXAHEDRON + EIGHT + QUADRILATERALS)]
OTHER_ORDERS = [('TETRA14', 4, TETRAHEDRON + TRIANGLES[:1] + TRIANGLES[3:] + TRIANGLES[1:3]),
                ('TETRA15', 4, TETRAHEDRON + FOUR + TRIANGLES), ('WEDGE20', 6, WEDGE + SIDES + ENDS),
                ('WEDGE21', 6, WEDGE + SIDES + ENDS + SIX), ('PYRAMID18', 5, PYRAMID + SLOPES + QUADRILATERALS[:1])]


def corners_of(numpy, corners):
    """The unit cube in cells of so many corners."""
    cube = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    lists = {6: ((0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)), 8: (range(8),),
             4: ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)),
             5: ((0, 1, 2, 3, 8), (4, 7, 6, 5, 8), (0, 4, 5, 1, 8), (1, 5, 6, 2, 8), (2, 6, 7, 3, 8), (3, 7, 4, 0, 8))}
    return [[numpy.array((cube + [(.5, .5, .5)])[i], dtype=float) for i in cell] for cell in lists[corners]]


def write_cubes(path, types, field, unused=2):
    """A row of unit cubes along x, each a block of 2 x 2 x 2 cubes of one type. No node is shared between blocks.

    Without a field it is a mesh alone, as preprocessors write it: no times and no variables."""
    netcdf4, numpy = need('netCDF4'), need('numpy')
    points, blocks = [(99.0, 99.0, 99.0)] * unused, []
    for at, (_, corners, others) in enumerate(types):
        known, cells = {}, []

        def number(place):
            key = tuple(numpy.round(place * 4800).astype(int))
            if key not in known:
                known[key] = len(points) + 1
                points.append(tuple(place + (at, 0, 0)))
            return known[key]

        for corner in itertools.product(range(2), repeat=3):
            for cell in corners_of(numpy, corners):
                places = [(p + corner) / 2 for p in cell]
                places += [numpy.mean([places[i] for i in between], axis=0) for between in others]
                cells.append([number(p) for p in places])
        blocks.append(cells)
    with netcdf4.Dataset(path, 'w', format='NETCDF3_64BIT_OFFSET') as file:
        sizes = {'len_string': 33, 'len_name': 33, 'time_step': None, 'num_dim': 3, 'num_nodes': len(points),
                 'num_elem': sum(map(len, blocks)), 'num_el_blk': len(blocks)}
        if field:
            sizes['num_nod_var'] = 1
        for name, size in sizes.items():
            file.createDimension(name, size)
        file.api_version = file.version = numpy.float32(8.03)
        file.floating_point_word_size, file.file_size, file.title = numpy.int32(8), numpy.int32(1), 'cubes'
        times = file.createVariable('time_whole', 'f8', ('time_step',))
        file.createVariable('eb_status', 'i4', ('num_el_blk',))[:] = 1
        ids = file.createVariable('eb_prop1', 'i4', ('num_el_blk',))
        ids.setncattr('name', 'ID')
        ids[:] = range(10 * len(blocks), 0, -10)  # readers sort the blocks
        for axis in range(3):
            file.createVariable('coord' + 'xyz'[axis], 'f8', ('num_nodes',))[:] = [p[axis] for p in points]
        for b, ((name, _, _), cells) in enumerate(zip(types, blocks), 1):
            file.createDimension(f'num_el_in_blk{b}', len(cells))
            file.createDimension(f'num_nod_per_el{b}', len(cells[0]))
            listed = file.createVariable(f'connect{b}', 'i4', (f'num_el_in_blk{b}', f'num_nod_per_el{b}'))
            listed.elem_type = name
            listed[:] = cells
        if not field:
            return
        times[0] = 0.0
        names = file.createVariable('name_nod_var', 'S1', ('num_nod_var', 'len_name'))
        names[0, :] = numpy.array(list('u'.ljust(33, '\0')), 'S1')
        file.createVariable('vals_nod_var1', 'f8', ('time_step', 'num_nodes'))[0, :] = [field(*p) for p in points]


def linear(x, y, z):
    return 1 + x + 2 * y - 3 * z


def check_sections(path, cubes, *options):
    middle = cubes / 2
    planes = [((middle, .5, .4), (0, 0, 1), 1.0), ((middle, .5, .5), (0, .2, 1), math.hypot(1, .2)),
              ((middle, .5, .5), (0, 1, -1), math.sqrt(2))]
    for origin, normal, width in planes:
        sheet = cut(path, 'point:u', '--origin', *origin, '--normal', *normal, *options)
        assert abs(sheet['area'] - cubes * width) < 1e-12 * cubes, (origin, normal, sheet['area'])
        # VTK's reader makes floats of the coordinates.
        assert abs(sheet['mean'] - linear(*origin)) < 1e-6, (origin, normal, sheet['mean'])


def exodus_types(folder):
    write_cubes(folder / 'types.e', TYPES, linear)
    check_sections(folder / 'types.e', len(TYPES))
    check_sections(folder / 'types.e', len(TYPES), '--refine', 1)
    with_tolerance = [t for t in TYPES if t[0] not in ('PYRAMID14', 'PYRAMID18', 'PYRAMID19')]
    write_cubes(folder / 'tolerance.e', with_tolerance, linear)
    check_sections(folder / 'tolerance.e', len(with_tolerance), '--refine', 0.01)


def exodus_orders(folder):
    write_cubes(folder / 'orders.e', OTHER_ORDERS, linear)
    check_sections(folder / 'orders.e', len(OTHER_ORDERS))


def exodus_added_nodes(folder):
    """Nodes that an element lacks have the values of its quadratic functions."""
    quadratic = [t for t in TYPES if t[0] in ('TETRA11', 'TETRA14', 'WEDGE16', 'WEDGE20', 'PYRAMID14', 'PYRAMID18',
                                              'HEX21')]
    count = len(quadratic)
    write_cubes(folder / 'quadratic.e', quadratic, lambda x, y, z: (x - count / 2) ** 2 + y * z - z * z)
    values = {r: cut(folder / 'quadratic.e', 'point:u', '--origin', 0, 0, .25, '--normal', 0, 0, 1, '--refine', r)
              for r in (0, 1, 2)}
    right = count ** 2 / 12 + .25 * .5 - .0625
    errors = [abs(values[r]['mean'] - right) for r in values]
    assert errors[1] < errors[0] / 3.5 and errors[2] < errors[1] / 3.5 and errors[2] < 2e-3, (errors, right)


def exodus_meshes_alone(folder):
    """A mesh without times, of ordinary elements and of odd ones."""
    for name, types in (('plain', [t for t in TYPES if t[0] in ('TETRA4', 'HEX8')]),
                        ('odd', [t for t in TYPES if t[0] in ('TETRA14', 'WEDGE20', 'PYRAMID18')])):
        path = folder / f'{name}.e'
        write_cubes(path, types, None)
        found = info(path)
        assert found['times'] == [] and found['bounds'] == [0, len(types), 0, 1, 0, 1], found
        sheet = cut(path, None, '--origin', 0, 0, .4, '--normal', 0, 0, 1)
        assert abs(sheet['area'] - len(types)) < 1e-12, sheet


def exodus_refused(folder):
    write_cubes(folder / 'hex32.e', [('HEX32', 8, HEXAHEDRON + HEXAHEDRON)], linear)
    refused(folder / 'hex32.e', 'HEX32 with 32 nodes', 'HEX8, HEX20 or HEX27')
    netcdf4 = need('netCDF4')  # what made VTK's reader crash
    for name, words, damage in (
            ('sides', 'what the elements of its block 1 are', lambda f: f.renameDimension('num_nod_per_el1', 'other')),
            ('number', 'what the elements of its block 1 are', lambda f: f.renameDimension('num_el_in_blk1', 'other')),
            ('type', 'what the elements of its block 1 are', lambda f: f['connect1'].delncattr('elem_type')),
            ('names', 'no name_nod_var', lambda f: f.renameVariable('name_nod_var', 'other')),
            ('corners', 'has the node 1000000 of', lambda f: f['connect1'].__setitem__((0, 0), 1000000))):
        path = folder / f'{name}.e'
        write_cubes(path, [t for t in TYPES if t[0] == 'HEX8'], linear)
        with netcdf4.Dataset(path, 'r+') as file:
            damage(file)
        damaged(path, words)


CASES = [exodus_types, exodus_orders, exodus_added_nodes, exodus_meshes_alone, exodus_refused]
