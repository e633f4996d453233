"""Times a plane that is dragged through 10 million tetrahedra: the plugin beside ParaView's Slice, in turns.
usage: pvbatch bench_drag.py [MILLIONS [DRAGS]]"""
import sys
import time

import paraview.simple as simple
from shared import counts_of, load

load(globals())
millions = float(sys.argv[1]) if len(sys.argv) > 1 else 10.0
drags = int(sys.argv[2]) if len(sys.argv) > 2 else 20
edge = round((millions * 1e6 / 5) ** (1 / 3))  # of the image, in cells; five tetrahedra for each
image = simple.Wavelet(WholeExtent=[0, edge] * 3)
tetrahedra = simple.Tetrahedralize(Input=image)
tetrahedra.UpdatePipeline()
cells = tetrahedra.GetDataInformation().DataInformation.GetNumberOfCells()
probe = VolumeProbe(Input=tetrahedra)  # noqa: F821, from the plugin
cutter = simple.Slice(Input=tetrahedra)
cutter.Triangulatetheslice = 0


def place(step):
    return [edge * (0.3 + 0.4 * step / drags)] * 3, [0.3 + 0.02 * step, 0.5, 0.8]


def ours(step):
    probe.Origin, probe.Normal = place(step)
    probe.UpdatePipeline()


def theirs(step):
    cutter.SliceType.Origin, cutter.SliceType.Normal = place(step)
    cutter.UpdatePipeline()


def timed(work, step):
    start = time.perf_counter()
    work(step)
    return 1e3 * (time.perf_counter() - start)


first = [timed(work, -1) for work in (ours, theirs)]
second = [timed(work, -2) for work in (ours, theirs)]
times = [sorted(column) for column in zip(*([timed(ours, step), timed(theirs, step)] for step in range(drags)))]
medians = [column[len(column) // 2] for column in times]
found = [source.GetDataInformation().DataInformation.GetNumberOfCells() for source in (probe, cutter)]
print(f'{cells} cells; the last sheet has {found[0]} polygons, that of Slice {found[1]}')
for name, k in (('Volume Probe', 0), ('Slice', 1)):
    print(f'{name}: first {first[k]:.0f} ms, second {second[k]:.0f} ms, a drag {medians[k]:.1f} ms '
          f'({times[k][0]:.1f} to {times[k][-1]:.1f})')
print(f'a drag is {medians[1] / medians[0]:.1f} times as fast; grids, neighbors, cuts: {counts_of(probe)}')
