#!/usr/bin/env python3
"""Times the first picture of a file: all of `vprobe render FILE -o picture.png`, beside VTK's reader and its fastest
cutter, which make no picture, in turns.

usage: first_picture.py VPROBE FOLDER [--turns N] [--only NAME[,NAME]] [--cold] [FILE ARRAY]...

Makes its files in FOLDER, where they are not there yet: 8 GB in all. More files may be given, each with an array of points:
.vtk, .vti, .vts, .vtu, .ex2, .cgns, .foam. --cold: the page cache holds nothing of the file when a turn begins.
Peak memory is that of the program and its reader, pages that both have counted once. Ratios are medians of turns.
Needs python3-vtk9 and python3-numpy.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import time

NORMAL = ('.3', '.5', '.81')
READERS = {'.vtk': 'vtkGenericDataObjectReader', '.vti': 'vtkXMLImageDataReader', '.vts': 'vtkXMLStructuredGridReader',
           '.vtu': 'vtkXMLUnstructuredGridReader', '.ex2': 'vtkExodusIIReader', '.cgns': 'vtkCGNSReader',
           '.foam': 'vtkOpenFOAMReader'}
# kind, cells along each axis, compressed
FILES = {'tets-10M.vtu': ('tets', 128, False), 'tets-10M-zlib.vtu': ('tets', 128, True),
         'tets-31M.vtu': ('tets', 184, False), 'hexes-7M.vtu': ('hexes', 192, False),
         'hexes-17M.vtu': ('hexes', 256, False), 'shell-17M.vts': ('shell', 256, False),
         'shell-17M-zlib.vts': ('shell', 256, True), 'image-134M.vti': ('image', 511, False),
         'image-134M-zlib.vti': ('image', 511, True), 'tets-10M.vtk': ('tets', 128, False),
         'hexes-2M.ex2': ('hexes', 128, False)}


def lattice_corners(n):
    import numpy as np
    m = n + 1
    k, j, i = np.meshgrid(*(np.arange(n),) * 3, indexing='ij')
    b = ((k * m + j) * m + i).ravel()
    return np.stack([b, b + 1, b + 1 + m, b + m, b + m * m, b + 1 + m * m, b + 1 + m + m * m, b + m + m * m], 1), i + j + k


def unstructured(kind, n):
    import numpy as np
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    corners, parity = lattice_corners(n)
    cells, cell_type = corners, vtk.VTK_HEXAHEDRON
    if kind == 'tets':
        split = np.array([[[0, 1, 3, 4], [1, 2, 3, 6], [1, 4, 5, 6], [3, 4, 6, 7], [1, 3, 4, 6]],
                          [[0, 1, 2, 5], [0, 2, 3, 7], [0, 4, 5, 7], [2, 5, 6, 7], [0, 2, 5, 7]]])
        odd = (parity & 1).ravel()
        cells = np.empty((n ** 3, 5, 4), np.int64)
        for p in (0, 1):
            cells[odd == p] = corners[odd == p][:, split[p]]
        cells, cell_type = cells.reshape(-1, 4), vtk.VTK_TETRA
    offsets = np.arange(0, cells.size + 1, cells.shape[1])
    array = vtk.vtkCellArray()
    array.SetData(numpy_to_vtkIdTypeArray(offsets, deep=1), numpy_to_vtkIdTypeArray(cells.ravel(), deep=1))
    grid = vtk.vtkUnstructuredGrid()
    grid.SetCells(numpy_to_vtk(np.full(len(cells), cell_type, np.uint8), deep=1), array)
    return grid


def make(path, kind, n, compressed):
    import numpy as np
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk
    t = np.linspace(0, 1, n + 1, dtype='f4')
    k, j, i = np.meshgrid(t, t, t, indexing='ij')
    if kind == 'image':
        grid, writer = vtk.vtkImageData(), vtk.vtkXMLImageDataWriter()
        grid.SetDimensions(n + 1, n + 1, n + 1)
        p = np.stack([i.ravel(), j.ravel(), k.ravel()], 1)
    else:
        p = np.stack([((1 + i) * np.cos(5.65 * j)).ravel(), ((1 + i) * np.sin(5.65 * j)).ravel(), (2 * k).ravel()], 1)
        points = vtk.vtkPoints()
        points.SetData(numpy_to_vtk(p.astype('f4'), deep=1))
        if kind == 'shell':
            grid, writer = vtk.vtkStructuredGrid(), vtk.vtkXMLStructuredGridWriter()
            grid.SetDimensions(n + 1, n + 1, n + 1)
        else:
            grid, writer = unstructured(kind, n), vtk.vtkXMLUnstructuredGridWriter()
        grid.SetPoints(points)
    for name, value in (('s', np.sin(3 * p[:, 0]) * np.cos(2 * p[:, 1]) + .5 * p[:, 2]), ('q', p[:, 0] * p[:, 1])):
        array = numpy_to_vtk(value.astype('f4'), deep=1)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    if path.endswith('.ex2'):
        writer = vtk.vtkExodusIIWriter()
    elif path.endswith('.vtk'):
        writer = vtk.vtkUnstructuredGridWriter()
        writer.SetFileTypeToBinary()
    else:
        writer.SetDataModeToAppended()
        writer.EncodeAppendedDataOff()
        writer.SetHeaderTypeToUInt64()
        writer.SetCompressorTypeToZLib() if compressed else writer.SetCompressorTypeToNone()
    writer.SetFileName(path + '.part' + os.path.splitext(path)[1])
    writer.SetInputData(grid)
    writer.Write()
    os.rename(path + '.part' + os.path.splitext(path)[1], path)


def leaves(data):
    import vtk
    if not isinstance(data, vtk.vtkCompositeDataSet):
        return [data]
    found = []
    at = data.NewIterator()
    at.InitTraversal()
    while not at.IsDoneWithTraversal():
        found.append(at.GetCurrentDataObject())
        at.GoToNextItem()
    return found


def vtk_cut(path, shown, way):
    """Seconds of VTK's reader and one of its cutters, as JSON on standard output."""
    import vtk
    start = time.time()
    ending = os.path.splitext(path)[1]
    reader = getattr(vtk, READERS[ending])()
    reader.SetFileName(path)
    if ending != '.vtk':
        reader.UpdateInformation()
    if ending == '.ex2':
        reader.SetPointResultArrayStatus(shown, 1)
    elif hasattr(reader, 'GetNumberOfPointArrays'):
        for i in range(reader.GetNumberOfPointArrays()):
            reader.SetPointArrayStatus(reader.GetPointArrayName(i), reader.GetPointArrayName(i) == shown)
    reader.Update()
    was_read = time.time()
    parts = [p for p in leaves(reader.GetOutputDataObject(0)) if p.GetNumberOfCells() > 0]
    boxes = [p.GetBounds() for p in parts]
    plane = vtk.vtkPlane()
    plane.SetOrigin(*[(min(b[2 * a] for b in boxes) + max(b[2 * a + 1] for b in boxes)) / 2 for a in range(3)])
    plane.SetNormal(*map(float, NORMAL))
    for part in parts:
        cutter = {'linear': vtk.vtk3DLinearGridPlaneCutter, 'edges': vtk.vtkFlyingEdgesPlaneCutter}.get(way, vtk.vtkPlaneCutter)()
        if way == 'plain':
            cutter.SetBuildTree(False)
        if way == 'edges':
            part.GetPointData().SetActiveScalars(shown)
        cutter.SetPlane(plane)
        cutter.SetInputData(part)
        cutter.Update()
    json.dump({'read': was_read - start, 'cut': time.time() - was_read}, sys.stdout)


def forget(path):
    fd = os.open(path, os.O_RDONLY)
    os.fsync(fd)
    os.posix_fadvise(fd, 0, 0, os.POSIX_FADV_DONTNEED)
    os.close(fd)


def peak_memory(command):
    """Bytes of the program and its children, shared pages counted once, at most; sampled."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    peak = 0

    def children(pid):
        try:
            for task in os.listdir('/proc/%d/task' % pid):
                yield from map(int, open('/proc/%d/task/%s/children' % (pid, task)).read().split())
        except OSError:
            return

    def pss(pid):
        try:
            return next(int(line.split()[1]) * 1024 for line in open('/proc/%d/smaps_rollup' % pid) if line.startswith('Pss:'))
        except (OSError, StopIteration):
            return 0
    while process.poll() is None:
        peak = max(peak, pss(process.pid) + sum(map(pss, children(process.pid))))
        time.sleep(.005)
    return peak


def measure(vprobe, path, array, turns, cold):
    ways = {'.vti': ['edges'], '.vts': ['plain'], '.cgns': ['plain'], '.foam': ['plain']}.get(
        os.path.splitext(path)[1], ['plain', 'linear'])
    picture = os.path.join(os.path.dirname(path), 'picture.png')
    ours = [vprobe, 'render', path, '--array', array, '--normal', *NORMAL, '-o', picture]
    seconds, theirs, processes = [], {way: [] for way in ways}, []
    for turn in range(turns + (not cold)):  # warm: a first turn that does not count
        for way in ways:
            if cold:
                forget(path)
            start = time.time()
            out = subprocess.run([sys.executable, __file__, '--vtk', path, array, way], capture_output=True, check=True)
            processes.append(time.time() - start)
            figures = json.loads(out.stdout)
            if cold or turn > 0:
                theirs[way].append(figures['read'] + figures['cut'])
        if cold:
            forget(path)
        start = time.time()
        subprocess.run(ours, check=True, stdout=subprocess.DEVNULL)
        if cold or turn > 0:
            seconds.append(time.time() - start)
    best = min(statistics.median(of_way) for of_way in theirs.values())
    mine = statistics.median(seconds)
    print('| %s%s | %.2f | %.2f | %.2f | %.2f | %.0f MB |' % (
        os.path.basename(path), ', cold' if cold else '', best, statistics.median(processes), mine, mine / best,
        peak_memory(ours) / 1e6), flush=True)


def main():
    if sys.argv[1:2] == ['--vtk']:
        return vtk_cut(*sys.argv[2:5])
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('vprobe')
    parser.add_argument('folder')
    parser.add_argument('--turns', type=int, default=5)
    parser.add_argument('--only', default='')
    parser.add_argument('--cold', action='store_true')
    parser.add_argument('files', nargs='*')
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    print('| file | VTK reads and cuts, s | its process | the picture | ratio | peak |\n| --- | --- | --- | --- | --- | --- |')
    for name, (kind, n, compressed) in FILES.items():
        if options.only and name not in options.only.split(','):
            continue
        path = os.path.join(options.folder, name)
        if not os.path.exists(path):
            making = [sys.executable, '-c', 'import first_picture; first_picture.make(%r, %r, %d, %r)' % (path, kind, n, compressed)]
            subprocess.run(making, check=True, cwd=os.path.dirname(os.path.abspath(__file__)))  # and its memory is free again
        measure(options.vprobe, path, 's', options.turns, options.cold)
    for path, array in zip(options.files[::2], options.files[1::2]):
        measure(options.vprobe, path, array, options.turns, options.cold)


if __name__ == '__main__':
    main()
