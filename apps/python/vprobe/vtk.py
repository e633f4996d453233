"""Volume Probes in a pipeline of VTK.

>>> from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
>>> import vprobe.vtk
>>> source, probe = vtkRTAnalyticSource(), vprobe.vtk.VolumeProbe(normal=(1, 2, 3))
>>> probe.SetInputConnection(source.GetOutputPort())
>>> probe.Update()
>>> probe.GetOutput().GetPointData().GetArray(0).GetName()
'RTData'
"""
from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkMultiBlockDataSet, vtkPolyData

from ._errors import Error
from ._kept import Kept
from ._probe import Probe
from ._slice import Cut

__all__ = ['VolumeProbe']


class VolumeProbe(VTKPythonAlgorithmBase):  # type: ignore[misc]
    """Cuts its input by a probe, as vtkCutter does by a function.

    The input is any data set that `vprobe.wrap` takes; its arrays are shared. What is built to find cells is kept until
    the points or the cells of the input change by their own MTime; other arrays do not count. The output is a
    vtkPolyData for a single sheet, and else a vtkMultiBlockDataSet with a part for each sheet. It has the point, cell
    and field data of the input, with the names kept, and the cell arrays ``vprobe:cell`` and ``vprobe:block``.

    Parameters
    ----------
    probe : Probe, optional
        By default a single sheet.
    copy, classify, device
        As of `vprobe.wrap`.
    **settings
        As of `Dataset.cut`: ``normal``, ``origin``, ``array``, ``window``, ``surface`` and others.

    Notes
    -----
    VTK prints what a filter raises, and goes on. `GetError` gives it.
    """

    def __init__(self, probe: Optional[Probe] = None, *, copy: bool = False, classify: str = 'auto', device: str = '',
                 **settings: Any) -> None:
        super().__init__(nInputPorts=1, inputType='vtkDataObject', nOutputPorts=1, outputType='vtkDataObject')
        self._kept = Kept(copy, classify, device)
        self._probe = probe
        self._settings = dict(settings)
        self._cut: Optional[Cut] = None
        self._error: Optional[Error] = None

    def SetInputData(self, mesh: Any) -> None:
        """Cuts this mesh, which is no output of a filter."""
        self.SetInputDataObject(0, mesh)

    def GetOutput(self) -> Any:
        """The polygons; call Update() before."""
        return self.GetOutputDataObject(0)

    def SetProbe(self, probe: Optional[Probe]) -> None:
        """Cuts by this probe from now on; None is a single sheet."""
        if probe != self._probe:
            self._probe = probe
            self.Modified()

    def GetProbe(self) -> Optional[Probe]:
        """The probe; None is a single sheet."""
        return self._probe

    def Set(self, **settings: Any) -> None:
        """Sets any settings; None is the default again."""
        if any(self._settings.get(key) != value for key, value in settings.items()):
            self._settings.update(settings)
            self.Modified()

    def SetNormal(self, *normal: Any) -> None:
        """Three numbers, or a sequence of them."""
        self.Set(normal=_three(normal))

    def SetOrigin(self, *origin: Any) -> None:
        """Three numbers, or a sequence of them."""
        self.Set(origin=_three(origin))

    def GetCut(self) -> Optional[Cut]:
        """The last cut, with its figures."""
        return self._cut

    def GetError(self) -> Optional[Error]:
        """Why the last update gave nothing; None where it did."""
        return self._error

    def FillInputPortInformation(self, port: int, info: Any) -> int:
        """Data sets, and composites of them."""
        info.Set(self.INPUT_REQUIRED_DATA_TYPE(), 'vtkDataSet')
        info.Append(self.INPUT_REQUIRED_DATA_TYPE(), 'vtkCompositeDataSet')
        return 1

    def RequestDataObject(self, request: Any, inputs: Any, outputs: Any) -> int:
        """Makes the output: one part, or several."""
        is_single = self._probe is None or self._probe.shape == 'single'
        wanted = vtkPolyData if is_single else vtkMultiBlockDataSet
        information = outputs.GetInformationObject(0)
        if not isinstance(information.Get(vtkDataObject.DATA_OBJECT()), wanted):
            information.Set(vtkDataObject.DATA_OBJECT(), wanted())
        return 1

    def RequestData(self, request: Any, inputs: Any, outputs: Any) -> int:
        """Cuts."""
        mesh = inputs[0].GetInformationObject(0).Get(vtkDataObject.DATA_OBJECT())
        output = outputs.GetInformationObject(0).Get(vtkDataObject.DATA_OBJECT())
        self._cut, self._error = None, None
        try:
            self._cut = self._kept.data_of(mesh).cut(self._probe, **self._settings)
        except Error as error:
            self._error = error
            raise
        made = self._cut[0].to_vtk() if isinstance(output, vtkPolyData) else self._cut.to_vtk()
        for part in [made] if isinstance(output, vtkPolyData) else map(made.GetBlock, range(made.GetNumberOfBlocks())):
            _pass_attributes(mesh, part)
        made.GetFieldData().ShallowCopy(mesh.GetFieldData())
        output.ShallowCopy(made)
        return 1


def _three(numbers: Sequence[Any]) -> Union[Any, Sequence[Any]]:
    return numbers[0] if len(numbers) == 1 else tuple(numbers)


def _pass_attributes(mesh: Any, part: Any) -> None:
    """What is active in the input is active in the output: scalars, vectors and others."""
    if not mesh.IsA('vtkDataSet'):
        return
    for given, taken in ((mesh.GetPointData(), part.GetPointData()), (mesh.GetCellData(), part.GetCellData())):
        for kind in range(given.NUM_ATTRIBUTES):
            active = given.GetAbstractAttribute(kind)
            if active is not None and active.GetName() and taken.HasArray(active.GetName()):
                taken.SetActiveAttribute(active.GetName(), kind)
