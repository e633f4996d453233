"""Cuts what VTK has in memory, by a call and in a pipeline."""
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

import vprobe
import vprobe.vtk

source = vtkRTAnalyticSource()
append = vtkAppendFilter()  # makes an unstructured grid of the image
append.SetInputConnection(source.GetOutputPort())
append.Update()

data = vprobe.wrap(append.GetOutput())  # its arrays are shared
print(data)
mesh = data.slice(normal=(.3, .5, .8)).to_vtk()
print(mesh.GetClassName(), mesh.GetNumberOfPolys() > 500, mesh.GetPointData().GetArrayName(0))

probe = vprobe.vtk.VolumeProbe(vprobe.Probe.trihedral(opacity=.6))
probe.SetInputConnection(append.GetOutputPort())
probe.Update()
print(probe.GetOutput().GetNumberOfBlocks(), 'sheets')
