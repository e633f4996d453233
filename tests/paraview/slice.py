"""Cuts the data of make_data.py by planes, by the plugin and by ParaView's Slice, and compares the two. The first run, on
one rank, writes its figures; a run on several ranks compares with them.
usage: pvbatch slice.py"""
import json
import os

import paraview.servermanager as servermanager
import paraview.simple as simple
from shared import FOLDER, area_of, cells_of, check, close, counts_of, finish, load

load(globals())
PLANES = [((0.3, 0.4, 0.5), (1, 0, 0)), ((0.5, 0.55, 0.6), (0.3, 0.5, 0.8)), ((0.2, 0.9, 0.4), (0.1, -0.7, 0.4)),
          ((0.51, 0.47, 0.5), (0, 0, 1)), ((-0.7, 1.2, 0.7), (1, 1, 0.2))]
ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
kept = os.path.join(FOLDER, 'slice.json')
figures = {}


def figures_of(source):
    return {'area': area_of(source), 'cells': [int(cell) for cell in cells_of(source)]}


# Slice counts ghost cells, so it gets the tetrahedra before they were parted.
for name, reference in (('tetrahedra.pvtu', 'whole.vtu'), ('shell.vts', 'shell.vts'),
                        ('shell.vts with ghosts', 'shell.vts')):
    data = simple.OpenDataFile(os.path.join(FOLDER, name.split(' ')[0]))
    if 'ghosts' in name:
        data = simple.GhostCellsGenerator(Input=data)
    probe = VolumeProbe(Input=data)  # noqa: F821, from the plugin
    cutter = simple.Slice(Input=simple.OpenDataFile(os.path.join(FOLDER, reference)), Triangulatetheslice=0)
    for number, (origin, normal) in enumerate(PLANES):
        probe.Origin, probe.Normal = origin, normal
        cutter.SliceType.Origin, cutter.SliceType.Normal = origin, normal
        ours, theirs = figures_of(probe), figures_of(cutter)
        what = f'{name}, plane {number}, {ranks} ranks: {len(ours["cells"])} cells, area {ours["area"]:.9f}'
        check(ours['cells'] == theirs['cells'], f'{what}: the cells of Slice')
        check(close(ours['area'], theirs['area'], 2e-5), f'{what}: the area of Slice, {theirs["area"]:.9f}')
        figures[f'{name} {number}'] = ours
    grids, _, cuts = counts_of(probe)
    check(grids == 1 and cuts == len(PLANES), f'{name}, {ranks} ranks: {grids} grid taken for {cuts} cuts')
    arrays = set(probe.PointData.keys()) >= {'pressure', 'velocity'} and 'quality' in probe.CellData.keys()
    check(arrays and 'vtkGhostType' not in probe.CellData.keys(), f'{name}, {ranks} ranks: all arrays, but for ghost marks')
if ranks == 1:
    with open(kept, 'w', encoding='utf-8') as file:
        json.dump(figures, file)
with open(kept, encoding='utf-8') as file:
    single = json.load(file)
for name, ours in figures.items():
    check(ours['cells'] == single[name]['cells'], f'{name}, {ranks} ranks: the cells of one rank')
    check(close(ours['area'], single[name]['area'], 1e-7), f'{name}, {ranks} ranks: the area of one rank')
finish()
