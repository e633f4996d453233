"""One small mesh, far from the origin, and its figures."""
import json

import against
from against import need, vprobe

# The usual offsets of maps: an axis each.
FAR = (500000.0, 6700000.0, 10000000.0)
BASE = 6700000.0  # what the values are far from
SIDES = (3, 2, 2)
STEP = 0.37
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
THROUGH = (1.5 * STEP + 0.031, STEP - 0.017, STEP + 0.023)
NEAR = 1e-7 * STEP


class Box:
    """Cubes in three rows, with values at points and at cells that differ little from a large number."""

    def __init__(self, numpy):
        self.numpy = numpy
        nx, ny, nz = (n + 1 for n in SIDES)
        k, j, i = numpy.mgrid[0:nz, 0:ny, 0:nx]
        self.near = numpy.stack([i, j, k], axis=-1).reshape(-1, 3) * STEP
        self.points = self.near + FAR
        ids = numpy.arange(nx * ny * nz).reshape(nz, ny, nx)
        cells = numpy.stack([ids[c:c + nz - 1, b:b + ny - 1, a:a + nx - 1] for a, b, c in CORNERS], axis=-1)
        self.cells = cells.reshape(-1, 8)
        self.u = BASE + self.near @ [1.0, 0.25, 0.5]
        self.c = BASE + 0.1 * numpy.arange(len(self.cells))


def check(box, name, path, point=None, cell=None):
    """point, cell: the names of the arrays with u and c."""
    vtk, numpy = need('vtkmodules.all'), box.numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    out, stats = against.scratch / 'cut.vtp', against.scratch / 'stats.json'
    array = ['--array', f'point:{point}'] if point else []
    origin = [repr(f + t) for f, t in zip(FAR, THROUGH)]
    vprobe('slice', path, '--origin', *origin, '--normal', '1', '0.5', '0.25', *array, '-o', out, '--stats', stats)
    sheet = json.loads(stats.read_text())['sheets'][0]
    area, mean = wanted()
    assert abs(sheet['area'] - area) < NEAR, (name, 'area', sheet['area'], area)
    if point:
        assert abs(sheet['mean'] - mean) < NEAR, (name, 'mean', sheet['mean'] - BASE, mean - BASE)
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(out))
    reader.Update()
    got = reader.GetOutput()
    places = vtk_to_numpy(got.GetPoints().GetData()) - FAR
    for vertex in range(got.GetNumberOfPoints() if point else 0):
        u = got.GetPointData().GetArray(point).GetTuple1(vertex) - BASE
        assert abs(u - places[vertex] @ [1.0, 0.25, 0.5]) < NEAR, (name, vertex, u, places[vertex])
    for polygon in range(got.GetNumberOfCells()):
        ids = got.GetCell(polygon).GetPointIds()
        middle = numpy.mean([places[ids.GetId(i)] for i in range(ids.GetNumberOfIds())], axis=0)
        i, j, k = (int(x) for x in middle / STEP)
        assert i < SIDES[0] and j < SIDES[1] and k < SIDES[2], (name, middle)
        if cell:
            c = got.GetCellData().GetArray(cell).GetTuple1(polygon)
            assert abs(c - box.c[i + SIDES[0] * (j + SIDES[1] * k)]) < NEAR, (name, polygon, c - BASE, middle)


figures = []


def wanted():
    """The box cut by hand: the plane meets its edges in the corners of one polygon, and u is linear."""
    if figures:
        return figures
    numpy = need('numpy')
    normal, through = numpy.array([1.0, 0.5, 0.25]), numpy.array(THROUGH)
    size = numpy.array(SIDES) * STEP
    corners = []
    for axis in range(3):
        for a in (0, 1):
            for b in (0, 1):
                start = numpy.zeros(3)
                start[(axis + 1) % 3], start[(axis + 2) % 3] = a, b
                start *= size
                t = normal @ (through - start) / normal[axis]
                if 0 <= t <= size[axis]:
                    start[axis] = t
                    corners.append(start)
    middle = numpy.mean(corners, axis=0)
    unit = normal / numpy.linalg.norm(normal)
    right = numpy.cross(unit, [0, 0, 1])
    right /= numpy.linalg.norm(right)
    up = numpy.cross(unit, right)
    corners.sort(key=lambda p: numpy.arctan2((p - middle) @ up, (p - middle) @ right))
    area, moment = 0.0, numpy.zeros(3)
    for p, q in zip(corners, corners[1:] + corners[:1]):
        part = 0.5 * numpy.linalg.norm(numpy.cross(p - middle, q - middle))
        area += part
        moment += part * (middle + p + q) / 3
    figures.extend((area, BASE + moment @ [1.0, 0.25, 0.5] / area))
    return figures


def text(values):
    return ' '.join(repr(float(v)) for v in values.ravel())


def faces_of(box):
    """Of OpenFOAM: those between cells first, by owner and neighbor; seen from outside of the first cell."""
    sides = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
    faces = {}
    for number, cell in enumerate(box.cells):
        for side in sides:
            corners = [int(cell[i]) for i in side]
            faces.setdefault(tuple(sorted(corners)), [corners]).append(number)
    inside = sorted((f for f in faces.values() if len(f) == 3), key=lambda f: f[1:])
    return inside, [f for f in faces.values() if len(f) == 2]
