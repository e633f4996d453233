"""What the tests of files of other programs share: running vprobe, and comparing two files by its figures."""
import importlib
import json
import os
import subprocess
import sys

VPROBE = sys.argv[1]
NORMAL = ['--normal', '0.3', '0.5', '0.81']

scratch = None  # a folder of the case that runs


class Missing(Exception):
    """What a case needs is not installed."""


def need(module):
    try:
        return importlib.import_module(module)
    except ImportError:
        raise Missing(module) from None


def tried(cases, every=1):
    """Every so many of the cases, and fewer with VPROBE_TRY_EVERY; all of them with VPROBE_LONG."""
    every *= int(os.environ.get('VPROBE_TRY_EVERY', 1))
    return list(cases)[::1 if 'VPROBE_LONG' in os.environ else every]


def vprobe(*arguments):
    done = subprocess.run([VPROBE, *map(str, arguments)], capture_output=True, encoding='utf-8')
    if done.returncode:
        raise AssertionError(f'vprobe {" ".join(map(str, arguments))}: {done.stderr.strip()}')
    return done.stdout


def info(path, *options):
    return json.loads(vprobe('info', path, *options, '--json'))


def cut(path, array, *options):
    out = scratch / 'cut.vtp'
    stats = scratch / 'stats.json'
    named = ['--array', array] if array else []
    normal = [] if '--normal' in options else NORMAL
    vprobe('slice', path, *options, '--classify', 'cpu', *normal, *named, '-o', out, '--stats', stats)
    return json.loads(stats.read_text())['sheets'][0]


def near(a, b, tolerance=1e-5):
    return a == b or abs(a - b) <= tolerance * max(abs(a), abs(b), 1e-12)


def compare(path, reference, arrays, options=(), tolerance=1e-5, counts=('cells', 'points')):
    """`arrays`: pairs of a name here and in the reference."""
    ours, wanted = info(path, *options), info(reference)
    for key in counts:
        assert ours['grid'][key] == wanted['grid'][key], (key, ours['grid'], wanted['grid'])
    for a, b in zip(ours['bounds'], wanted['bounds']):
        assert abs(a - b) < tolerance * 100, (ours['bounds'], wanted['bounds'])
    names = {f'{a["association"]}:{a["name"]}': a for a in ours['arrays']}
    other = {f'{a["association"]}:{a["name"]}': a for a in wanted['arrays']}
    for name, named in arrays:
        assert name in names, (name, sorted(names))
        for a, b in zip(names[name]['range'], other[named]['range']):
            assert near(a, b, tolerance), (name, names[name]['range'], other[named]['range'])
        a, b = cut(path, name, *options), cut(reference, named)
        for key in ('area', 'mean', 'min', 'max'):
            assert near(a[key], b[key], 10 * tolerance), (name, key, a[key], b[key])


# A box of hexahedra beside one of tetrahedra, with values that differ along each axis.
def mixed_mesh(meshio, numpy):
    points, cells, index = [], {'hexahedron': [], 'tetra': []}, {}
    for k in range(5):
        for j in range(4):
            for i in range(6):
                index[i, j, k] = len(points)
                points.append([0.5 * i, 0.25 * j, 2.0 * k + 0.1 * i])
    for k in range(4):
        for j in range(3):
            for i in range(5):
                c = [index[i + a, j + b, k + d] for a, b, d in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                                                                (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
                if i < 3:
                    cells['hexahedron'].append(c)
                else:
                    for t in ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)):
                        cells['tetra'].append([c[n] for n in t])
    points = numpy.array(points)
    f = points @ [1.0, 10.0, 100.0]
    blocks = [(name, numpy.array(lists)) for name, lists in cells.items()]
    g = [f[lists].mean(axis=1) for _, lists in blocks]
    v = numpy.stack([f, -f, 0.5 * f], axis=1)
    return meshio.Mesh(points, blocks, point_data={'f': f, 'v': v}, cell_data={'g': g})


def by_meshio(folder, name, arrays=('point:f', 'point:v', 'cell:g'), mesh=None, **options):
    meshio, numpy = need('meshio'), need('numpy')
    mesh = mesh or mixed_mesh(meshio, numpy)
    reference, path = folder / 'reference.vtu', folder / name
    meshio.write(reference, mesh)
    meshio.write(path, mesh, **options)
    compare(path, reference, [(a, a) for a in arrays])


# The tetrahedra of the mixed mesh alone, with the points that they use.
def tetrahedra(meshio, numpy):
    mesh = mixed_mesh(meshio, numpy)
    used, lists = numpy.unique(mesh.cells[1].data, return_inverse=True)
    return meshio.Mesh(mesh.points[used], [('tetra', lists.reshape(-1, 4))],
                       point_data={'f': mesh.point_data['f'][used]}, cell_data={'g': [mesh.cell_data['g'][1]]})


def lattice(numpy):
    z, y, x = numpy.mgrid[0:6, 0:4, 0:5].astype(float)
    return x + 10.0 * y + 100.0 * z


def nrrd(folder, values, about=''):
    path = folder / 'reference.nrrd'
    head = ('NRRD0005\ntype: double\ndimension: 3\nsizes: 5 4 6\ncontent: f\nendian: little\nencoding: raw\n' +
            (about or 'spacings: 1 1 1\naxis mins: 0 0 0\n') + '\n')
    path.write_bytes(head.encode() + values.astype('<f8').tobytes())
    return path
