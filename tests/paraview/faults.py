"""What goes wrong on a rank: there is no hang, and one error, and the filter works on.
usage: pvbatch faults.py"""
import os

import paraview.servermanager as servermanager
import paraview.simple as simple
from shared import FOLDER, area_of, check, finish, load

load(globals())
ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


def heading(text):
    """Errors that follow belong to it; run.sh counts them."""
    print('case: ' + text, flush=True)


heading('an empty rank, 0 errors')
whole = simple.OpenDataFile(os.path.join(FOLDER, 'whole.vtu'))  # all of it is on the first rank
probe = VolumeProbe(Input=whole)  # noqa: F821, from the plugin
probe.Origin, probe.Normal = (0.5, 0.5, 0.5), (0.3, 0.5, 0.8)
area = area_of(probe)
check(area > 0, f'a sheet of area {area:.4f} where {ranks - 1} of {ranks} ranks have no cells')
probe.ProbeType = 'Stack'
probe.UpdatePipeline()
check(area_of(probe) > 0, 'a stack, too')
simple.Delete(probe)

heading('a rank without the array, 1 error')
parted = simple.OpenDataFile(os.path.join(FOLDER, 'tetrahedra.pvtu'))
lacking = simple.ProgrammableFilter(Input=parted)
lacking.Script = '''
output.ShallowCopy(inputs[0].VTKObject)
if output.GetPointData() and self.GetExecutive() and __import__('vtkmodules.vtkParallelCore', fromlist=['x']) \\
        .vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 1:
    output.GetPointData().RemoveArray('pressure')
'''
probe = VolumeProbe(Input=lacking)  # noqa: F821, from the plugin
probe.Origin, probe.Normal = (0.5, 0.5, 0.5), (0.3, 0.5, 0.8)
check(area_of(probe) > 0, 'without a use for the array all is well')
probe.Array = ['POINTS', 'pressure']
probe.UseThreshold, probe.Threshold = 1, (-10, 10)
part = area_of(probe)
check(0 < part < 1.2, f'the other ranks show their part, {part:.4f}')
probe.UseThreshold = 0
check(area_of(probe) > part, 'and all is well again')
simple.Delete(probe)

heading('an expression that is none, 1 error')
probe = VolumeProbe(Input=parted)  # noqa: F821, from the plugin
probe.SurfaceType, probe.Expression = 'Expression', 'x +'
check(area_of(probe) == 0, 'nothing is shown')
simple.Delete(probe)

heading('a probe file that is not there, 1 error')
probe = VolumeProbe(Input=parted)  # noqa: F821, from the plugin
probe.ProbeType, probe.ProbeFile = 'From a File', os.path.join(FOLDER, 'none.json')
check(area_of(probe) == 0, 'nothing is shown')
simple.Delete(probe)

heading('a surface, 1 error')
probe = VolumeProbe(Input=simple.Sphere())  # noqa: F821, from the plugin
check(area_of(probe) == 0, 'nothing is shown')
heading('the end, 0 errors')
finish()
