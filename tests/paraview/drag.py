"""A client of a server with several ranks: drags the plane 20 times, draws each time, then takes another array, another
input and a plane that misses. What was built to find cells is counted on the server. Ends without taking leave.
usage: pvpython drag.py PORT [--leave-at-once]"""
import os
import sys

import paraview.servermanager as servermanager
import paraview.simple as simple
from shared import FOLDER, area_of, check, counts_of, failures, load

simple.Connect('localhost', int(sys.argv[1]))
load(globals(), remote=True)
data = simple.OpenDataFile(os.path.join(FOLDER, 'tetrahedra.pvtu'))
field = simple.Calculator(Input=data, Function='2*pressure', ResultArrayName='other')
probe = VolumeProbe(Input=field)  # noqa: F821, from the plugin
view = simple.CreateRenderView(ViewSize=[200, 150])
probe.UpdatePipeline()  # what it gives is known then
simple.Show(probe, view)
if '--leave-at-once' in sys.argv:
    simple.Render(view)
    probe.Normal = (0.3, 0.5, 0.8)
    os._exit(0)
ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
check(ranks == 2, f'a server of {ranks} ranks')
areas = []
for step in range(20):
    probe.Origin, probe.Normal = (0.5, 0.5, 0.1 + 0.04 * step), (0.3, 0.1 * step, 0.8)
    simple.Render(view)
    areas.append(area_of(probe))
check(min(areas) > 0 and len(set(areas)) == 20, f'20 sheets, areas {min(areas):.3f} to {max(areas):.3f}')
counts = counts_of(probe)
check(counts[:2] == [1, 1], f'{counts[2]} cuts: {counts[0]} grid was taken, neighbors were built {counts[1]} time')
check(20 <= counts[2] <= 22, f'a drag costs a cut: {counts[2]} for the first sheet and 20 others')
field.Function = '3*pressure'
simple.Render(view)
after = counts_of(probe)
check(after == [1, 1, counts[2] + 1], f'another array costs a cut: {after}')
probe.UpdatePipeline()
span = probe.PointData['other'].GetRange()
there = probe.PointData['pressure'].GetRange()
check(abs(span[1] - 3 * there[1]) < 1e-5, f'and it is shown: to {span[1]:.4f}, thrice {there[1]:.4f}')
probe.Input = simple.OpenDataFile(os.path.join(FOLDER, 'shell.vts'))
probe.Origin = (0.2, 1.2, 0.7)
simple.Render(view)
check(area_of(probe) > 0 and counts_of(probe)[0] == 2, f'another input: {counts_of(probe)}')
probe.Origin, probe.Normal = (9, 9, 9), (0, 0, 1)
simple.Render(view)
check(area_of(probe) == 0, 'a plane that misses gives nothing')
sys.stdout.flush()
os._exit(1 if failures else 0)
