"""The filter for pipelines of VTK."""
import numpy as np
import pytest

import vprobe

pytest.importorskip('vtkmodules.vtkFiltersCore', reason='no VTK for Python')
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData  # noqa: E402

from vprobe.vtk import VolumeProbe  # noqa: E402

from test_vtk_grids import KINDS, area_and_mean, image, named, structured, tetrahedra, vtk_cut  # noqa: E402

NORMAL = .3, .5, .8


def names(attributes):
    return {attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())}


@pytest.mark.parametrize('make', KINDS)
def test_output_is_that_of_vtkcutter_with_cells(make):
    mesh = make()
    mesh.GetPointData().SetActiveScalars('p')
    mesh.GetFieldData().AddArray(named(np.array([7.0]), 'about'))
    probe = VolumeProbe(normal=NORMAL, classify='cpu')
    probe.SetInputData(mesh)
    probe.Update()
    output = probe.GetOutputDataObject(0)
    assert isinstance(output, vtkPolyData) and probe.GetError() is None
    cutters = vtk_cut(mesh, probe.GetCut()[0].origin)
    assert names(output.GetPointData()) == names(cutters.GetPointData())
    assert names(output.GetCellData()) == names(cutters.GetCellData()) | {'vprobe:cell', 'vprobe:block'}
    assert output.GetPointData().GetScalars().GetName() == 'p'
    assert output.GetFieldData().GetArray('about').GetValue(0) == 7.0
    assert probe.GetCut()[0].area == pytest.approx(area_and_mean(cutters, 'p')[0], rel=2e-5)
    assert np.array_equal(*(vtk_to_numpy(output.GetCellData().GetArray(name)) for name in ('vprobe:cell', 'number')))


class Source(VTKPythonAlgorithmBase):
    """Gives a copy of a mesh, as a reader does: the points and cells are the same objects."""

    def __init__(self, mesh):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType=mesh.GetClassName())
        self.mesh = mesh

    def RequestData(self, request, inputs, outputs):
        type(self.mesh).GetData(outputs).ShallowCopy(self.mesh)
        return 1


def test_adjacency_is_kept_until_points_or_cells_change():
    source = Source(tetrahedra())
    probe = VolumeProbe(normal=NORMAL, array='p', classify='cpu')
    probe.SetInputConnection(source.GetOutputPort())
    probe.Update()
    data = probe._kept._data
    probe.SetOrigin(.5, .4, .5)
    probe.Update()
    assert probe._kept._data is data and data.memory().copied
    before = probe.GetCut()[0]
    mean = before.mean
    # Other arrays: what was built stays, and the slice before keeps its arrays.
    p = source.mesh.GetPointData().GetArray('p')
    source.mesh.GetPointData().AddArray(named(3 * vtk_to_numpy(p), 'p'))
    source.mesh.GetPointData().AddArray(named(vtk_to_numpy(p) + 1, 'new'))
    source.Modified()
    probe.Update()
    assert probe._kept._data is data
    now = probe.GetCut()[0]
    assert now.mean == pytest.approx(3 * mean) and set(now.point_data) == {'p', 'v', 'new'}
    assert now.area == before.area and set(before.point_data) == {'p', 'v'}
    assert before['p'].max() < now['p'].max() / 2
    # Values in place.
    vtk_to_numpy(source.mesh.GetPointData().GetArray('p'))[:] *= 2
    source.mesh.GetPointData().GetArray('p').Modified()
    source.Modified()
    probe.Update()
    assert probe._kept._data is data and probe.GetCut()[0].mean == pytest.approx(6 * mean)
    # Points.
    points = vtk_to_numpy(source.mesh.GetPoints().GetData())
    points[:] *= 2
    source.mesh.GetPoints().GetData().Modified()
    source.Modified()
    probe.SetOrigin(1, .8, 1)
    probe.Update()
    assert probe._kept._data is not data
    assert probe.GetCut()[0].area == pytest.approx(4 * before.area, rel=1e-5)


def test_several_sheets_and_blocks():
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, image())
    blocks.SetBlock(1, structured())
    probe = VolumeProbe(vprobe.Probe.trihedral(origin=(.5, .5, .2)), classify='cpu')
    probe.SetInputData(blocks)
    probe.Update()
    output = probe.GetOutputDataObject(0)
    assert isinstance(output, vtkMultiBlockDataSet) and output.GetNumberOfBlocks() == 3
    assert 'vprobe:block' in names(output.GetBlock(0).GetCellData())
    probe.SetProbe(None)
    probe.SetNormal((0, 1, 0))
    probe.Update()
    assert isinstance(probe.GetOutputDataObject(0), vtkPolyData) and probe.GetCut()[0].normal == (0, 1, 0)


def test_what_cannot_be_cut_is_an_error(capfd):
    probe = VolumeProbe(array='none', classify='cpu')
    probe.SetInputData(image())
    probe.Update()
    assert isinstance(probe.GetError(), vprobe.InputError) and 'there are' in str(probe.GetError())
    probe.Set(array='p')
    probe.Update()
    assert probe.GetError() is None and probe.GetOutputDataObject(0).GetNumberOfPolys() > 0
    capfd.readouterr()
