"""What the witnesses share: converting a file by vprobe, comparing arrays, and going through seeds."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

VPROBE = sys.argv[1]


def need(*modules):
    """Ends the test with exit code 77 where a module is missing."""
    for module in modules:
        try:
            __import__(module)
        except ImportError as error:
            print(f'left out: {error}')
            sys.exit(77)


def run(*arguments):
    return subprocess.run([VPROBE, *map(str, arguments)], capture_output=True, encoding='utf-8')


def info(path, *options):
    done = run('info', path, '--json', *options)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def converted(path, folder, *options):
    """The points of the only block, its point arrays by name, and what was said."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader
    import numpy
    done = run('convert', path, '-o', folder / 'out.vtm', *options)
    assert done.returncode == 0, done.stderr
    pieces = list((folder / 'out').iterdir())
    assert len(pieces) == 1, pieces
    reader = vtkXMLGenericDataObjectReader()
    reader.SetFileName(str(pieces[0]))
    reader.Update()
    data = reader.GetOutput()
    points = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    fields = data.GetPointData()
    arrays = {fields.GetArrayName(i): vtk_to_numpy(fields.GetArray(i)).copy()
              for i in range(fields.GetNumberOfArrays())}
    shutil.rmtree(folder / 'out')
    return points, arrays, done.stderr


def units_of(found, key, otherwise):
    """Units that `info` tells; `otherwise` where this version of it tells none of their kind."""
    return found[key] or '' if key in found else otherwise


def refused(path, *options):
    """The line of a file that is refused; never a crash."""
    done = run('info', path, *options)
    assert done.returncode == 2, (done.returncode, done.stdout, done.stderr)
    assert done.stderr.count('\n') == 1, done.stderr
    return done.stderr


def same(ours, wanted, what, tolerance=0.0):
    import numpy
    ours, wanted = numpy.asarray(ours), numpy.asarray(wanted)
    assert ours.shape == wanted.shape, (what, ours.shape, wanted.shape)
    if tolerance == 0.0:
        equal = (ours == wanted) | ((ours != ours) & (wanted != wanted))
    else:
        largest = numpy.nanmax(numpy.abs(wanted), initial=1e-9)
        equal = numpy.isclose(ours, wanted, rtol=tolerance, atol=tolerance * largest, equal_nan=True)
    assert equal.all(), (what, ours[~equal][:4], wanted[~equal][:4])


def lattice(counts, origin=(0, 0, 0), steps=None):
    """Points with x running fastest; counts and steps along the three axes, steps as vectors."""
    import numpy
    steps = numpy.eye(3) if steps is None else numpy.asarray(steps, float)
    k, j, i = numpy.meshgrid(*(numpy.arange(n) for n in counts[::-1]), indexing='ij')
    index = numpy.stack([i.ravel(), j.ravel(), k.ravel()], axis=1)
    return index @ steps + numpy.asarray(origin, float)


def how_many(normal=20, many=500):
    if 'VPROBE_LONG' in os.environ:
        return many
    every = int(os.environ.get('VPROBE_TRY_EVERY', 1))
    return (normal + every - 1) // every


def go_through(name, compare, normal=20, many=500):
    """Calls compare(seed, folder) for all seeds; VPROBE_LONG asks for many, VPROBE_TRY_EVERY for every so many."""
    first, count = (int(word) for word in sys.argv[2:4]) if len(sys.argv) > 3 else (1, how_many(normal, many))
    done = failed = 0
    for seed in range(first, first + count):
        with tempfile.TemporaryDirectory(prefix='vprobe-witness-') as folder:
            try:
                compare(seed, pathlib.Path(folder))
                done += 1
            except AssertionError as error:
                failed += 1
                print(f'{name}, seed {seed}: FAILED: {error}')
    print(f'{name}: {done} of {done + failed} files as their writers meant them')
    sys.exit(1 if failed else 0)
