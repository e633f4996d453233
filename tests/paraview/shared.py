"""What the scripts of this folder share: the plugin, figures of a cut, checks."""
import os
import sys

import numpy as np
import paraview.servermanager as servermanager
import paraview.simple as simple
from vtkmodules.util.numpy_support import vtk_to_numpy

PLUGIN = os.environ['VPROBE_PLUGIN']
FOLDER = os.environ['VPROBE_SCRATCH']  # of the test: data, results, pictures
COUNTS = ('GridsTaken', 'NeighborsBuilt', 'CutsMade')

failures = []


def load(scope, remote=False):
    """Loads the plugin, and puts VolumeProbe among the names of `scope`."""
    if remote:
        simple.LoadPlugin(PLUGIN, remote=True, ns=scope)
    simple.LoadPlugin(PLUGIN, remote=False, ns=scope)


def parts_of(data):
    """The data sets of a data object."""
    if not data.IsA('vtkCompositeDataSet'):
        return [data]
    iterator = data.NewIterator()
    iterator.InitTraversal()
    parts = []
    while not iterator.IsDoneWithTraversal():
        parts.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return parts


def area_of(source):
    """The area of flat polygons, over all ranks. Integrate Variables gives none where the first rank has no cells."""
    area = 0.0
    for part in parts_of(servermanager.Fetch(source)):
        if part.GetNumberOfCells() == 0:
            continue
        points = vtk_to_numpy(part.GetPoints().GetData()).astype(float)
        starts = vtk_to_numpy(part.GetPolys().GetOffsetsArray())
        ids = vtk_to_numpy(part.GetPolys().GetConnectivityArray())
        following = np.arange(1, len(ids) + 1)
        following[starts[1:] - 1] = starts[:-1]
        origin = points[ids[np.repeat(starts[:-1], np.diff(starts))]]
        sides = np.cross(points[ids] - origin, points[ids[following]] - origin)
        area += np.linalg.norm(np.add.reduceat(sides, starts[:-1]), axis=1).sum() / 2
    return area


def cells_of(source, name='id'):
    """The cells of the input that a filter has cut, over all ranks, by the input's array of ids."""
    ids = [vtk_to_numpy(part.GetCellData().GetArray(name)) for part in parts_of(servermanager.Fetch(source))
           if part.GetNumberOfCells()]
    return np.unique(np.concatenate(ids)) if ids else np.empty(0)


def counts_of(probe):
    """How many grids were taken, how often neighbors were built, how many cuts were made."""
    probe.UpdatePropertyInformation()
    return [int(probe.GetPropertyValue(name)) for name in COUNTS]


def check(holds, what):
    """Prints the verdict of one check."""
    print(('ok: ' if holds else 'FAILED: ') + what, flush=True)
    if not holds:
        failures.append(what)


def close(a, b, tolerance):
    """Whether two figures differ by no more than a part."""
    return abs(a - b) <= tolerance * max(abs(a), abs(b), 1e-30)


def finish():
    """Ends the script, with 1 where a check failed."""
    sys.stdout.flush()
    if failures:
        sys.exit(1)
