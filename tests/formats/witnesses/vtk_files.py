#!/usr/bin/env python3
"""VTK's own files, written by VTK's writers in every way they know, and read by vprobe.

usage: vtk_files.py VPROBE [FIRST-SEED COUNT]

XML (text, base64, appended; raw or packed; both orders of bytes) and legacy files (text and binary, old and new lists
of cells) of images, rectilinear, structured and unstructured grids, with arrays of all types, nan and inf among them.
The values and places that vprobe converts, and those that it samples, are compared with the data set that was written,
and with what VTK's own readers make of the file, where they read it right. VPROBE_LONG asks for 500 files. Exit code 77
where VTK's modules are missing.
"""
import csv
import io
import pathlib
import random
import subprocess
import sys
import tempfile

try:
    import numpy
    from vtkmodules import vtkCommonCore as core
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_TETRA, VTK_VOXEL, VTK_WEDGE, vtkDataSetAttributes,
                                               vtkImageData, vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid)
    from vtkmodules.vtkIOLegacy import vtkDataSetReader, vtkDataSetWriter
    from vtkmodules.vtkIOXML import vtkXMLDataSetWriter, vtkXMLGenericDataObjectReader
except ImportError as error:
    print(f'left out: {error}')
    sys.exit(77)

from common import how_many

VPROBE = sys.argv[1]
ENDINGS = {'image': '.vti', 'rectilinear': '.vtr', 'structured': '.vts', 'unstructured': '.vtu'}
TYPES = ['SignedChar', 'UnsignedChar', 'Short', 'UnsignedShort', 'Int', 'UnsignedInt', 'Long', 'UnsignedLong',
         'LongLong', 'IdType', 'Float', 'Double', 'Float', 'Double']
# Of a unit cell in eight points numbered along x, y and z.
SPLITS = [[(VTK_VOXEL, range(8))], [(VTK_HEXAHEDRON, (0, 1, 3, 2, 4, 5, 7, 6))],
          [(VTK_WEDGE, (0, 1, 2, 4, 5, 6)), (VTK_WEDGE, (1, 3, 2, 5, 7, 6))],
          [(VTK_TETRA, t) for t in ((0, 1, 3, 5), (0, 3, 2, 6), (0, 5, 6, 4), (3, 6, 5, 7), (0, 3, 6, 5))]]


class Spelling:
    """What one file holds, and how it is written."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.numbers = numpy.random.default_rng(seed)
        self.kind = self.random.choice(list(ENDINGS))
        self.counts = [self.random.randint(2, 5) for _ in range(3)]
        self.is_legacy = self.random.random() < 0.4
        self.strange = False  # whether VTK's readers do not know a number in the text
        self.data = getattr(self, self.kind)()
        self.add_fields()

    def axes(self):
        return [numpy.cumsum(self.numbers.uniform(0.5, 2.0, n)) - 3 for n in self.counts]

    def image(self):
        image = vtkImageData()
        low = [self.random.randint(-3, 3) for _ in range(3)] if not self.is_legacy else [0, 0, 0]
        image.SetExtent([x for a in range(3) for x in (low[a], low[a] + self.counts[a] - 1)])
        image.SetOrigin(*self.numbers.uniform(-5, 5, 3))
        image.SetSpacing(*self.numbers.uniform(0.1, 2, 3))
        return image

    def rectilinear(self):
        grid = vtkRectilinearGrid()
        grid.SetDimensions(self.counts)
        for axis, values in zip('XYZ', self.axes()):
            kind = self.random.choice([numpy.float32, numpy.float64])
            getattr(grid, f'Set{axis}Coordinates')(numpy_to_vtk(values.astype(kind), deep=True))
        return grid

    def points(self):
        z, y, x = numpy.meshgrid(*reversed(self.axes()), indexing='ij')
        places = numpy.stack([x.ravel(), y.ravel() + 0.1 * x.ravel(), z.ravel()], axis=1)
        points = core.vtkPoints()
        points.SetData(numpy_to_vtk(places.astype(self.random.choice([numpy.float32, numpy.float64])), deep=True))
        return points

    def structured(self):
        grid = vtkStructuredGrid()
        grid.SetDimensions(self.counts)
        grid.SetPoints(self.points())
        return grid

    def unstructured(self):
        grid = vtkUnstructuredGrid()
        grid.SetPoints(self.points())
        nx, ny, nz = self.counts
        fixed = self.random.choice(SPLITS) if self.random.random() < 0.5 else None
        grid.Allocate(1)
        for k in range(nz - 1):
            for j in range(ny - 1):
                for i in range(nx - 1):
                    corners = [i + a + nx * (j + b + ny * (k + c)) for c in (0, 1) for b in (0, 1) for a in (0, 1)]
                    for shape, places in fixed or self.random.choice(SPLITS):
                        ids = [corners[p] for p in places]
                        grid.InsertNextCell(shape, len(ids), ids)
        return grid

    def array(self, name, tuples):
        kind = self.random.choice(TYPES)
        array = getattr(core, f'vtk{kind}Array')()
        array.SetName(name)
        array.SetNumberOfComponents(self.random.choice([1, 1, 2, 3, 9]))
        array.SetNumberOfTuples(tuples)
        low, high = array.GetDataTypeValueMin(), array.GetDataTypeValueMax()
        for i in range(array.GetNumberOfValues()):
            if kind in ('Float', 'Double'):
                odd = self.random.random() < 0.1
                value = self.random.choice([float('nan'), float('inf'), -float('inf'), 1e-30, 0.0]) if odd else \
                    self.random.choice([1, -1]) * 10 ** self.random.uniform(-8, 8)
                self.strange |= value != value or abs(value) == float('inf')
            else:
                # vtkIdType has 32 bits in legacy files.
                low, high = (max(low, -2 ** 31), min(high, 2 ** 31 - 1)) if self.is_legacy else (low, high)
                value = self.random.choice([int(low), int(high)]) if self.random.random() < 0.1 else \
                    self.random.randint(int(max(low, -100)), 100)
            array.SetValue(i, value)
        if self.random.random() < 0.2:
            array.GetInformation().Set(core.vtkDataArray.UNITS_LABEL(), 'kPa')
        if self.random.random() < 0.2:
            array.GetRange(0)  # ranges are written, and those of nan and inf are no numbers
            array.GetFiniteRange(-1)
        return array

    def add_fields(self):
        for fields, count in ((self.data.GetPointData(), self.data.GetNumberOfPoints()),
                              (self.data.GetCellData(), self.data.GetNumberOfCells())):
            for a in range(self.random.randint(0, 3)):
                name = self.random.choice(['a', 'pressure field', 'v/w', 'τ', 'x_y']) + str(a)
                fields.AddArray(self.array(name, count))
            if fields.GetNumberOfArrays() and self.random.random() < 0.5:
                array = fields.GetArray(0)
                role = {1: 'Scalars', 3: 'Vectors', 9: 'Tensors'}.get(array.GetNumberOfComponents())
                if role:
                    fields.SetActiveAttribute(0, getattr(vtkDataSetAttributes, role.upper()))
        linear = core.vtkDoubleArray()  # so that samples of point arrays are known
        linear.SetName('linear')
        for i in range(self.data.GetNumberOfPoints()):
            x, y, z = self.data.GetPoint(i)
            linear.InsertNextValue(2 * x - y + 3 * z)
        self.data.GetPointData().AddArray(linear)
        if self.random.random() < 0.3:
            bits = core.vtkBitArray()
            bits.SetName('bits')
            for i in range(self.data.GetNumberOfCells()):
                bits.InsertNextValue(i % 3 == 1)
            self.data.GetCellData().AddArray(bits)
        number = core.vtkIntArray()
        number.SetName('number')
        for i in range(self.data.GetNumberOfCells()):
            number.InsertNextValue(7 * i)
        self.data.GetCellData().AddArray(number)
        if self.random.random() < 0.3:
            times = core.vtkDoubleArray()
            times.SetName('TimeValue')
            times.InsertNextValue(2.5)
            self.data.GetFieldData().AddArray(times)
        if self.random.random() < 0.2:
            words = core.vtkStringArray()
            words.SetName('words')
            words.InsertNextValue('two words, 100 %')
            self.data.GetFieldData().AddArray(words)

    def is_vtk_wrong(self):
        """VTK's readers know no nan and inf in text, nor the names of colors that its writer encodes."""
        return self.strange and (self.is_text or self.is_legacy) or self.is_legacy and \
            any(self.data.GetAttributes(kind).GetScalars() for kind in (0, 1))

    def write(self, folder):
        pick = self.random.choice
        if self.is_legacy:
            path = folder / 'f.vtk'
            writer = vtkDataSetWriter()
            self.is_text = pick([True, False])
            writer.SetFileType(1 if self.is_text else 2)
            writer.SetFileVersion(pick([42, 51]))
            self.how = f'legacy, text: {self.is_text}'
        else:
            path = folder / f'f{ENDINGS[self.kind]}'
            writer = vtkXMLDataSetWriter()
            mode = pick(['Ascii', 'Binary', 'Appended'])
            self.is_text = mode == 'Ascii'
            getattr(writer, f'SetDataModeTo{mode}')()
            writer.SetEncodeAppendedData(pick([True, False]))
            writer.SetCompressorType(pick([0, 1, 2, 3]))
            writer.SetHeaderType(pick([32, 64]))
            writer.SetByteOrder(pick([0, 1]))
            writer.SetBlockSize(pick([64, 1024, 1 << 15]))
            self.how = f'{mode}, compressor {writer.GetCompressor() and writer.GetCompressor().GetClassName()}'
        writer.SetFileName(str(path))
        writer.SetInputData(self.data)
        assert writer.Write()
        return path


def arrays_of(fields):
    arrays = {}
    for i in range(fields.GetNumberOfArrays()):
        array = fields.GetArray(i)
        if isinstance(array, core.vtkBitArray):
            values = numpy.array([array.GetValue(k) for k in range(array.GetNumberOfValues())], numpy.uint8)
        else:
            values = vtk_to_numpy(array)
        arrays[array.GetName()] = values
    return arrays


def points_of(data):
    return numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])


def read_by_vtk(path):
    reader = vtkDataSetReader() if path.suffix == '.vtk' else vtkXMLGenericDataObjectReader()
    if path.suffix == '.vtk':
        for what in ('Scalars', 'Vectors', 'Normals', 'Tensors', 'ColorScalars', 'TCoords', 'Fields'):
            getattr(reader, f'ReadAll{what}On')()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def run(*arguments, text=None):
    done = subprocess.run([VPROBE, *map(str, arguments)], capture_output=True, encoding='utf-8', input=text)
    assert done.returncode == 0, done.stderr
    return done.stdout


def same(ours, wanted, what, digits=0.0):
    assert ours.shape == wanted.shape, (what, ours.shape, wanted.shape)
    near = (ours == wanted) | ((ours != ours) & (wanted != wanted))
    if digits and wanted.dtype.kind == 'f':
        near |= numpy.isclose(ours, wanted, rtol=digits, atol=0, equal_nan=True)
    assert near.all(), (what, ours[~near][:4], wanted[~near][:4])


def compare_sets(ours, wanted, what, digits):
    # Numbers in the text of legacy files have few digits, and the sizes of images are always text.
    near = 2e-5 if 'legacy' in what and (digits or what.startswith('image')) else 1e-12
    assert numpy.allclose(points_of(ours), points_of(wanted), rtol=near, atol=near), f'{what}: places'
    for fields in ('GetPointData', 'GetCellData'):
        mine, theirs = arrays_of(getattr(ours, fields)()), arrays_of(getattr(wanted, fields)())
        assert set(mine) == set(theirs), (what, fields, sorted(mine), sorted(theirs))
        for name, values in theirs.items():
            assert mine[name].dtype.kind == values.dtype.kind, (what, name, mine[name].dtype, values.dtype)
            same(mine[name], values, f'{what}: {fields} {name}', digits)
    for i in range(wanted.GetNumberOfCells()):
        assert ours.GetCellType(i) == wanted.GetCellType(i), (what, i)
        a, b = ours.GetCell(i).GetPointIds(), wanted.GetCell(i).GetPointIds()
        assert [a.GetId(k) for k in range(a.GetNumberOfIds())] == [b.GetId(k) for k in range(b.GetNumberOfIds())]


def compare_samples(path, data):
    """Arrays of cells, and the linear one of the points, at the middles of cells: by the way without VTK, if there is
    one."""
    middles, cells = [], list(range(0, data.GetNumberOfCells(), max(1, data.GetNumberOfCells() // 7)))
    for c in cells:
        ids = data.GetCell(c).GetPointIds()
        corners = [data.GetPoint(ids.GetId(k)) for k in range(ids.GetNumberOfIds())]
        middles.append(numpy.mean(corners, axis=0))
    text = ''.join(f'{x!r} {y!r} {z!r}\n' for x, y, z in (map(float, place) for place in middles))
    rows = list(csv.reader(io.StringIO(run('sample', path, '--points', '-', text=text))))
    column = {name: i for i, name in enumerate(rows[0])}
    assert len(rows) == len(middles) + 1
    for c, place, row in zip(cells, middles, rows[1:]):
        assert row[column['cell']] == str(c), (c, row)
        linear = 2 * place[0] - place[1] + 3 * place[2]
        assert abs(float(row[column['linear']]) - linear) < 1e-4, (c, row, linear)
        names = {name: values for name, values in arrays_of(data.GetCellData()).items() if values.ndim == 1}
        for name, values in names.items():
            if name in arrays_of(data.GetPointData()) or values.dtype.kind != 'f':
                continue
            ours, wanted = float(row[column[name]]), float(values[c])
            assert ours == wanted or (ours != ours and wanted != wanted) or abs(ours - wanted) <= 2e-5 * abs(wanted), \
                (name, c, ours, wanted)
        assert row[column['number']] == str(7 * c)
        assert 'bits' not in names or row[column['bits']] == str(int(c % 3 == 1)), row


def compare(seed, folder):
    spelling = Spelling(seed)
    path = spelling.write(folder)
    out = folder / 'out.vtm'
    run('convert', path, '-o', out)
    ours = read_by_vtk(next((folder / 'out').iterdir()))
    digits = 2e-5 if spelling.is_legacy and spelling.is_text else 0.0
    what = f'{spelling.kind}, {spelling.how}'
    try:
        compare_sets(ours, spelling.data, f'{what}, as written', digits)
        if not spelling.is_vtk_wrong():
            compare_sets(ours, read_by_vtk(path), f'{what}, as read by VTK', digits)
        compare_samples(path, spelling.data)
    except AssertionError as error:
        raise AssertionError(what, *error.args) from error


def main():
    core.vtkObject.GlobalWarningDisplayOff()
    first, count = (int(word) for word in sys.argv[2:4]) if len(sys.argv) > 3 else \
        (1, how_many())
    failed = 0
    for seed in range(first, first + count):
        with tempfile.TemporaryDirectory(prefix='vprobe-vtk-') as folder:
            try:
                compare(seed, pathlib.Path(folder))
            except AssertionError as error:
                failed += 1
                print(f'seed {seed}: FAILED: {error}')
    print(f'{count - failed} of {count} files as VTK wrote them')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
