#!/usr/bin/env python3
"""Cuts from Python: what a call costs, and how much faster it is than VTK's filters, in one process.

usage: python_cuts.py [--tets N] [--rounds N] [--cpp FILE]
    --tets: cells along an edge of a box that is cut into six tetrahedra each; 118 makes 10 million (default 118)
    --rounds: how often a slice is measured, the first one and a moved one (default 9); medians are told
    --cpp: the program bench_call of the build, for the same call from C++

Prints a table of Markdown. All filters take turns. Run it while nothing else runs.
"""
import argparse
import statistics
import subprocess
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkPlane, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtk3DLinearGridPlaneCutter, vtkCutter, vtkPlaneCutter

import vprobe

SPLIT = [[0, 1, 3, 7], [0, 1, 7, 4], [1, 2, 3, 7], [1, 2, 7, 6], [1, 4, 5, 7], [1, 5, 6, 7]]
NORMAL = np.array((.3, .5, .8)) / np.linalg.norm((.3, .5, .8))


def grid_of(n):
    """A vtkUnstructuredGrid of 6 n^3 tetrahedra, with one array of floats."""
    axis = np.linspace(0, 1, n + 1, dtype=np.float32)
    z, y, x = np.meshgrid(axis, axis, axis, indexing='ij')
    points = np.stack([x + .05 * np.sin(5 * y), y + .05 * np.sin(5 * z), z], axis=-1).reshape(-1, 3)
    ids = np.arange((n + 1) ** 3, dtype=np.int64).reshape(n + 1, n + 1, n + 1)
    corners = []
    for layer in (ids[:-1], ids[1:]):
        corners += [layer[:, :-1, :-1], layer[:, :-1, 1:], layer[:, 1:, 1:], layer[:, 1:, :-1]]
    cells = np.stack([corner.ravel() for corner in corners], axis=1)[:, SPLIT].reshape(-1, 4)
    mesh = vtkUnstructuredGrid()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    mesh.SetPoints(places)
    listed = vtkCellArray()
    listed.SetData(numpy_to_vtkIdTypeArray(np.arange(0, cells.size + 1, 4), deep=True),
                   numpy_to_vtkIdTypeArray(cells.ravel(), deep=True))
    mesh.SetCells(VTK_TETRA, listed)
    values = numpy_to_vtk(np.linalg.norm(points - .5, axis=1), deep=True)
    values.SetName('p')
    mesh.GetPointData().SetScalars(values)
    return mesh


def seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


class Vtk:
    """A filter of VTK that cuts a mesh by a plane."""

    def __init__(self, kind, mesh):
        self.name = kind.__name__
        self.plane = vtkPlane()
        self.plane.SetNormal(*NORMAL)
        self.filter = kind()
        if kind is vtkCutter:
            self.filter.SetCutFunction(self.plane)
            self.filter.GenerateCutScalarsOff()
        else:
            self.filter.SetPlane(self.plane)
        self.filter.SetInputDataObject(mesh)

    def cut(self, origin):
        self.plane.SetOrigin(*origin)
        self.filter.Modified()
        self.filter.Update()


class Ours:
    """This library: points, polygons and the array are asked for, as VTK's filters give them."""

    name = 'vprobe'

    def __init__(self, mesh):
        self.data = vprobe.wrap(mesh, classify='cpu')

    def cut(self, origin):
        piece = self.data.slice(normal=NORMAL, origin=origin, array='p')
        return piece.points, piece.polygons, piece['p']


def large(n, rounds):
    mesh = grid_of(n)
    kinds = (vtkCutter, vtkPlaneCutter, vtk3DLinearGridPlaneCutter)
    center = np.array((.5, .5, .5))
    first = {'vprobe': [], **{kind.__name__: [] for kind in kinds}}
    for _ in range(rounds):  # each time anew, as a script that cuts once
        for kind in kinds:
            filter_ = Vtk(kind, mesh)
            first[kind.__name__].append(seconds(lambda: filter_.cut(center)))
        first['vprobe'].append(seconds(lambda: Ours(mesh).cut(center)))
    ours = Ours(mesh)
    ours.cut(center)
    building = seconds(lambda: ours.cut(center + .01 * NORMAL))
    cutters = [Vtk(kind, mesh) for kind in kinds] + [ours]
    for cutter in cutters:
        cutter.cut(center)
    moved = {cutter.name: [] for cutter in cutters}
    for k in range(rounds):
        for cutter in cutters:
            origin = center + (.02 * k - .07) * NORMAL
            moved[cutter.name].append(seconds(lambda: cutter.cut(origin)))
    first, moved = ({name: statistics.median(times) for name, times in each.items()} for each in (first, moved))
    print(f'A vtkUnstructuredGrid of {mesh.GetNumberOfCells():,} tetrahedra:\n')
    print('| filter | first slice, wrapping included | vprobe is faster | moved slice | vprobe is faster |')
    print('| --- | --- | --- | --- | --- |')
    for name in first:
        ratios = [f'{times[name] / times["vprobe"]:.2f}x' for times in (first, moved)] if name != 'vprobe' else ['', '']
        print(f'| `{name}` | {1e3 * first[name]:.0f} ms | {ratios[0]} | {1e3 * moved[name]:.1f} ms | {ratios[1]} |')
    print(f'\nThe second slice of vprobe builds what tells the neighbors of cells: {building:.1f} s, once.\n')


def small(program):
    data = vprobe.open('demo:shell:16', classify='cpu')
    for _ in range(200):
        data.slice(normal=(.3, .5, .8))
    ours = statistics.median(seconds(lambda: data.slice(normal=(.3, .5, .8))) for _ in range(1000))
    print(f'A call on demo:shell:16: {1e6 * ours:.0f} us from Python', end='')
    if program:
        cpp = float(subprocess.run([program], capture_output=True, text=True, check=True).stdout)
        print(f', {1e6 * cpp:.0f} us from C++, so {1e6 * (ours - cpp):.0f} us more', end='')
    print(' (medians of 1000).')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--tets', type=int, default=118)
    parser.add_argument('--rounds', type=int, default=9)
    parser.add_argument('--cpp')
    options = parser.parse_args()
    if options.tets:
        large(options.tets, options.rounds)
    small(options.cpp)


main()
