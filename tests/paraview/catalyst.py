"""The script that Catalyst runs on each rank: a paddlewheel through the simulation's cells, one picture a step."""
import os

from paraview import servermanager, simple
from paraview.catalyst import Options

simple.LoadPlugin(os.environ['VPROBE_PLUGIN'], remote=False, ns=globals())
FOLDER = os.environ['VPROBE_SCRATCH']

cubes = simple.TrivialProducer(registrationName='cubes')
probe = VolumeProbe(registrationName='probe', Input=cubes)  # noqa: F821, from the plugin
probe.ProbeType = 'Paddlewheel'
probe.Origin, probe.Normal, probe.Up = (1.0, 0.5, 0.5), (0.2, 1.0, 0.1), (0.0, 0.0, 1.0)
view = simple.CreateRenderView(ViewSize=[320, 240])
shown = simple.Show(probe, view)
simple.ColorBy(shown, ('POINTS', 'heat'))
shown.LookupTable = simple.GetColorTransferFunction('heat')
shown.LookupTable.RescaleTransferFunction(-1.0, 2.0)
options = Options()


def catalyst_execute(info):
    probe.UpdatePipeline(info.time)
    if info.cycle == 0:
        view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (1.0, -4.5, 2.5), (1.0, 0.5, 0.5), (0, 0, 1)
    simple.SaveScreenshot(os.path.join(FOLDER, f'step-{info.cycle}.png'), view)
    probe.UpdatePropertyInformation()
    counts = [int(probe.GetPropertyValue(name)) for name in ('GridsTaken', 'NeighborsBuilt', 'CutsMade')]
    rank = servermanager.vtkProcessModule.GetProcessModule().GetPartitionId()
    with open(os.path.join(FOLDER, f'steps-{rank}.txt'), 'a', encoding='utf-8') as file:
        print(info.cycle, *counts, probe.PointData['heat'].GetRange()[1], file=file)
