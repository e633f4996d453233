"""Writes the data of the tests. On one rank: a curvilinear shell, and tetrahedra. On several: these with ghost cells, one
piece for each rank."""
import os

import numpy as np
import paraview.servermanager as servermanager
import paraview.simple as simple
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkIOXML import vtkXMLStructuredGridWriter

FOLDER = os.environ['VPROBE_SCRATCH']


def lattice(n, place):
    """A structured grid of n points, the places of which are a function of three numbers between 0 and 1."""
    w, v, u = np.meshgrid(*(np.linspace(0, 1, m) for m in reversed(n)), indexing='ij')
    grid = vtkStructuredGrid()
    grid.SetDimensions(n)
    points = vtkPoints()
    xyz = np.stack([a.ravel() for a in place(u, v, w)], axis=1)
    points.SetData(numpy_to_vtk(xyz, deep=True))
    grid.SetPoints(points)
    x, y, z = xyz.T
    data = dataset_adapter.WrapDataObject(grid)
    data.PointData.append(np.sin(3 * x) + y * z, 'pressure')
    data.PointData.append(np.stack([-y, x, 0.3 + 0 * z], axis=1), 'velocity')
    cells = grid.GetNumberOfCells()
    data.CellData.append(np.arange(cells), 'id')
    data.CellData.append(np.cos(0.01 * np.arange(cells)), 'quality')
    return grid


def write(grid, name):
    writer = vtkXMLStructuredGridWriter()
    writer.SetFileName(os.path.join(FOLDER, name))
    writer.SetInputData(grid)
    writer.Write()


def shell(u, v, w):
    r, turn = 1 + u, 2.5 * v + 0.4 * u
    return r * np.cos(turn), r * np.sin(turn), 1.5 * w + 0.1 * np.sin(4 * v)


def warped(u, v, w):
    return u + 0.07 * np.sin(5 * v), v + 0.05 * np.sin(4 * w), w + 0.06 * np.cos(3 * u)


whole = os.path.join(FOLDER, 'whole.vtu')
if servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions() == 1:
    write(lattice((33, 41, 29), shell), 'shell.vts')
    write(lattice((17, 16, 17), warped), 'warped.vts')
    box = simple.XMLStructuredGridReader(FileName=[os.path.join(FOLDER, 'warped.vts')])
    numbered = simple.GenerateGlobalIds(Input=simple.Tetrahedralize(Input=box))
    numbered = simple.Calculator(Input=numbered, AttributeType='Cell Data', Function='GlobalCellIds',
                                 ResultArrayName='id')
    simple.SaveData(whole, proxy=numbered)
else:
    tetrahedra = simple.XMLUnstructuredGridReader(FileName=[whole])
    pieces = simple.GhostCellsGenerator(Input=simple.RedistributeDataSet(Input=tetrahedra))
    simple.SaveData(os.path.join(FOLDER, 'tetrahedra.pvtu'), proxy=pieces)
    owned, stored = (source.GetDataInformation().DataInformation.GetNumberOfCells() for source in (tetrahedra, pieces))
    print(f'{owned} cells, {stored} with ghost cells')
    assert stored > 1.05 * owned
