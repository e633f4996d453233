"""Cuts by every kind of probe and surface, with lines, contours and vectors. The first run, on one rank, writes what each
part of the output holds, and draws it; a run on several ranks compares with it.
usage: pvbatch options.py"""
import json
import os

import numpy as np
import paraview.servermanager as servermanager
import paraview.simple as simple
from shared import FOLDER, check, close, finish, load, parts_of
from vtkmodules.util.numpy_support import vtk_to_numpy

load(globals())
ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
kept = os.path.join(FOLDER, 'options.json')
probe_file = os.path.join(FOLDER, 'probe.json')
with open(probe_file, 'w', encoding='utf-8') as file:
    json.dump({'sheets': [{'to_sheet': {'normal': [1, 0, 0]}}, {'to_sheet': {'normal': [0, 1, 0]}, 'window': [0.5, 0.4]},
                          {'surface': 'sphere:0.3'}, {'hidden': True}]}, file)

# What is set, and how many parts the output has.
CASES = {
    'single': ({}, 1),
    'trihedral': ({'ProbeType': 'Trihedral'}, 3),
    'paddlewheel': ({'ProbeType': 'Paddlewheel', 'Vanes': 5}, 5),
    'stack': ({'ProbeType': 'Stack', 'Sheets': 4}, 4),
    'offsets': ({'ProbeType': 'Stack', 'Offsets': [-0.2, 0.0, 0.3]}, 3),
    'file': ({'ProbeType': 'From a File', 'ProbeFile': probe_file}, 3),
    'window': ({'UseWindow': 1, 'Window': [0.4, 0.7]}, 1),
    'sphere': ({'SurfaceType': 'Sphere', 'Radius': 0.4}, 1),
    'cylinder': ({'SurfaceType': 'Cylinder', 'Radius': 0.3}, 1),
    'cone': ({'SurfaceType': 'Cone', 'Angle': 25.0}, 1),
    'expression': ({'SurfaceType': 'Expression', 'Expression': 'z = 0.1*sin(9*x)'}, 1),
    'coordinates': ({'SurfaceType': 'Expression', 'Expression': 'x + y - 1', 'ExpressionMovesWithPlane': 0}, 1),
    'iso': ({'SurfaceType': 'Value of the Array', 'IsoValue': 0.9}, 1),
    'threshold': ({'UseThreshold': 1, 'Threshold': [0.7, 1.1]}, 1),
    'crinkle': ({'Crinkle': 1}, 1),
    'lines': ({'UseContourLines': 1, 'ContourLines': [0.6, 0.9, 1.2]}, 2),
    'contours': ({'UseContours': 1, 'Contours': [0.9], 'ContourDepth': 0.3}, 2),
    'tufts': ({'Vectors': 'Tufts'}, 2),
    'paths': ({'Vectors': 'Lines', 'VectorLattice': 8, 'VectorSteps': 20}, 2),
}
# Faces between two cut cells of two ranks are on the outside of both; a path ends where its rank's piece does; a contour
# grows on each rank from its part of the sheet.
LOCAL = ('crinkle', 'contours', 'tufts', 'paths')


def size_of(part):
    """The area of polygons, in triangles, or the length of lines."""
    if part.GetNumberOfCells() == 0:
        return 0.0
    points = vtk_to_numpy(part.GetPoints().GetData()).astype(float)
    cells = part.GetPolys() if part.GetNumberOfPolys() else part.GetLines()
    starts = vtk_to_numpy(cells.GetOffsetsArray())
    ids = vtk_to_numpy(cells.GetConnectivityArray())
    size = 0.0
    for begin, end in zip(starts[:-1], starts[1:]):
        corners = points[ids[begin:end]]
        if part.GetNumberOfPolys():
            around = corners - corners.mean(axis=0)
            size += np.linalg.norm(np.cross(around, np.roll(around, -1, axis=0)), axis=1).sum() / 2
        else:
            size += np.linalg.norm(np.diff(corners, axis=0), axis=1).sum()
    return size


data = simple.OpenDataFile(os.path.join(FOLDER, 'tetrahedra.pvtu'))
view = simple.CreateRenderView(ViewSize=[320, 240])
figures = {}
for case, (settings, count) in CASES.items():
    probe = VolumeProbe(Input=data)  # noqa: F821, from the plugin
    probe.Origin, probe.Normal, probe.Up = (0.5, 0.55, 0.6), (0.3, 0.5, 0.8), (0, 1, 0)
    probe.Array, probe.VectorArray = ['POINTS', 'pressure'], ['POINTS', 'velocity']
    for name, value in settings.items():
        setattr(probe, name, value)
    probe.UpdatePipeline()  # one sheet is polydata, several are a multiblock: Fetch asks which it was last
    parts = parts_of(servermanager.Fetch(probe))
    # A multiblock comes with the parts of the first rank, then those of the next.
    sizes = [sum(size_of(part) for part in parts[first::count]) for first in range(count)]
    if 'Vectors' in settings:
        figures[case + ' launched'] = [sum(part.GetNumberOfLines() for part in parts)]
    figures[case] = sizes
    check(len(parts) in (count, count * ranks) and all(size > 0 for size in sizes), f'{case}, {ranks} ranks: {count} parts, {sizes}')
    has_arrays = all(part.GetPointData().HasArray('pressure') for part in parts if part.GetNumberOfCells())
    check(has_arrays, f'{case}, {ranks} ranks: every part has the arrays')
    shown = simple.Show(probe, view)
    simple.ColorBy(shown, ('POINTS', 'pressure'))
    simple.ResetCamera(view)
    simple.SaveScreenshot(os.path.join(FOLDER, f'{case}-{ranks}.png'), view)
    simple.Delete(probe)
if ranks == 1:
    with open(kept, 'w', encoding='utf-8') as file:
        json.dump(figures, file)
with open(kept, encoding='utf-8') as file:
    single = json.load(file)
for case, sizes in figures.items():
    if case not in LOCAL or ranks == 1:
        same = all(close(a, b, 1e-7) for a, b in zip(sizes, single[case]))
        check(same and len(sizes) == len(single[case]), f'{case}, {ranks} ranks: as on one rank')
finish()
