"""Cuts every kind of data set, and composites of them: areas are those of ParaView's Slice.
usage: pvbatch kinds.py"""
import os

import paraview.servermanager as servermanager
import paraview.simple as simple
from shared import FOLDER, area_of, check, close, finish, load, parts_of
from vtkmodules.util.numpy_support import vtk_to_numpy

load(globals())
NORMAL = (0.3, 0.5, 0.8)


def image(**more):
    return simple.Wavelet(WholeExtent=[0, 12] * 3, **more)


def turned(source):
    """An image with a direction matrix."""
    turn = simple.ProgrammableFilter(Input=source)
    turn.Script = 'output.ShallowCopy(inputs[0].VTKObject); output.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)'
    return turn


def hidden(source, where, mark, of='Cell'):
    """Cells or points hidden, as readers do it, and the number of each cell."""
    hide = simple.ProgrammableFilter(Input=source)
    hide.Script = f'''
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
output.ShallowCopy(inputs[0].VTKObject)
def add(values, name, attributes):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    attributes.AddArray(array)
add(np.arange(output.GetNumberOfCells()), 'id', output.GetCellData())
number = np.arange(output.GetNumberOf{of}s())
add(np.where({where}, {mark}, 0).astype(np.uint8), 'vtkGhostType', output.Get{of}Data())
'''
    return hide


def voxels(source):
    """An unstructured grid of all cells."""
    return simple.Threshold(Input=source, Scalars=['POINTS', 'RTData'], LowerThreshold=-1e9, UpperThreshold=1e9)


def rectilinear():
    source = simple.ProgrammableSource(OutputDataSetType='vtkRectilinearGrid')
    source.Script = '''
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
axis = numpy_to_vtk(np.array([0, 1, 1.5, 3, 5, 5.5, 7, 12.0], np.float32), deep=True)
output.SetDimensions(8, 8, 8)
output.SetXCoordinates(axis)
output.SetYCoordinates(axis)
output.SetZCoordinates(axis)
'''
    return source


def polyhedra(source):
    """Every voxel as a polyhedron."""
    convert = simple.ProgrammableFilter(Input=source)
    convert.Script = '''
from vtkmodules.vtkCommonCore import vtkIdList
taken = inputs[0].VTKObject
output.Initialize()
output.SetPoints(taken.GetPoints())
output.Allocate(taken.GetNumberOfCells())
for cell in range(taken.GetNumberOfCells()):
    ids = taken.GetCell(cell).GetPointIds()
    p = [ids.GetId(i) for i in range(8)]
    stream = vtkIdList()
    stream.InsertNextId(6)
    for face in ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)):
        stream.InsertNextId(4)
        for corner in face:
            stream.InsertNextId(p[corner])
    output.InsertNextCell(42, stream)
'''
    return convert


def prisms():
    """Prisms over a pentagon and a hexagon, side by side, and a point of no cell that has no place."""
    source = simple.ProgrammableSource(OutputDataSetType='vtkUnstructuredGrid')
    source.Script = '''
import math
from vtkmodules.vtkCommonCore import vtkPoints
points = vtkPoints()
output.Allocate(2)
for cell, sides in enumerate((5, 6)):
    first = points.GetNumberOfPoints()
    for layer in (0, 1):
        for i in range(sides):
            angle = 2 * math.pi * i / sides
            points.InsertNextPoint(math.cos(angle) + 3 * cell, math.sin(angle), layer)
    output.InsertNextCell(10 + sides, 2 * sides, list(range(first, first + 2 * sides)))
points.InsertNextPoint(math.nan, 0, 0)
output.SetPoints(points)
'''
    return source


shell = simple.OpenDataFile(os.path.join(FOLDER, 'shell.vts'))
refined = simple.AMRGaussianPulseSource()
KINDS = {
    'an image': image(),
    'a turned image': turned(image()),
    'an image with hidden cells': hidden(image(), 'number % 3 == 0', 32),
    'an image with hidden points': hidden(image(), 'number == 6 * 169 + 6 * 13 + 6', 2, 'Point'),
    'an image with a layer of ghost cells': hidden(image(), 'number % 12 == 0', 1),
    'a structured grid with a layer of ghost cells': hidden(shell, 'number >= 27 * 32 * 40', 1),
    'a rectilinear grid': rectilinear(),
    'voxels': voxels(image()),
    'polyhedra': polyhedra(voxels(image())),
    'prisms': prisms(),
    'a structured grid': shell,
    'a group with a surface': simple.GroupDatasets(Input=[image(), shell, simple.Sphere()]),
    'groups in a group': simple.GroupDatasets(Input=[simple.GroupDatasets(Input=[rectilinear(), shell]), image()]),
    'a grid that is refined in places': refined,
}
# Slice cuts ghost cells, and coarse cells beneath finer ones, too.
REFERENCES = {
    'an image with a layer of ghost cells': simple.ExtractSubset(Input=image(), VOI=[1, 12, 0, 12, 0, 12]),
    'a structured grid with a layer of ghost cells': simple.ExtractSubset(Input=shell, VOI=[0, 32, 0, 40, 0, 27]),
    'a grid that is refined in places': simple.ResampleToImage(Input=refined, SamplingDimensions=[9, 9, 9]),
}
for kind, data in KINDS.items():
    data.UpdatePipeline()
    bounds = data.GetDataInformation().DataInformation.GetBounds()
    origin = [low + share * (high - low) for low, high, share in zip(bounds[::2], bounds[1::2], (0.37, 0.61, 0.43))]
    probe = VolumeProbe(Input=data)  # noqa: F821, from the plugin
    cutter = simple.Slice(Input=REFERENCES.get(kind, data), Triangulatetheslice=0)
    probe.Origin, probe.Normal = origin, NORMAL
    cutter.SliceType.Origin, cutter.SliceType.Normal = origin, NORMAL
    probe.UpdatePipeline()
    cutter.UpdatePipeline()
    area, other = area_of(probe), area_of(cutter)
    check(area > 0 and close(area, other, 2e-5), f'{kind}: {area:.6f}, Slice {other:.6f}')
    if 'id' in data.CellData.keys() and 'group' not in kind:
        parts = [part for part in parts_of(servermanager.Fetch(probe)) if part.GetNumberOfCells()]
        numbers, ids = (vtk_to_numpy(parts[0].GetCellData().GetArray(name)) for name in ('vprobe:cell', 'id'))
        check((numbers == ids).all(), f'{kind}: cells have the numbers of the input')
finish()
