#!/usr/bin/env python3
"""Cuts of quadratic cells refined to a tolerance, beside VTK's tessellator and plane cutter, in one process.

usage: refined_cuts.py [--shape SHAPE] [--cubes N] [--chord LENGTH] [--rounds N] [--vtk-rounds N] [--write FILE]
    --shape: tetrahedra, six of a cube, or hexahedra of 20 nodes, one of a cube (default tetrahedra)
    --cubes: along an edge of the box; 55 makes 1 million tetrahedra (default 55)
    --chord: how far VTK's parts may be off (vtkTessellatorFilter's ChordError; default 2e-5)
    --rounds: how often cuts are measured; the least time is told (default 9)
    --vtk-rounds: the same for the tessellator (default 1)
    --write: writes the mesh as a .vtu, and measures nothing

The mesh is a ball of radius 1, so a plane at a distance d cuts an area of pi (1 - d d) out of it. The tolerance is
halved until no area of ours is further off than that of VTK. Prints a table of Markdown.
"""
import argparse
import math
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_TETRA, vtkCellArray, vtkPlane,
                                          vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkPlaneCutter
from vtkmodules.vtkFiltersGeneral import vtkTessellatorFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

# Six tetrahedra about the diagonal of a cube, and the corners that the middles of their edges lie between.
STEPS = ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2))
EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
# Corners of a cube, and of which of them a hexahedron has an edge.
CORNERS = ((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2))
CUBE_EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
NORMAL = np.array((.3, .5, .8)) / np.linalg.norm((.3, .5, .8))


def corners_of(steps):
    """Corners of one of the six, in steps of half a cube, in the sense that VTK wants."""
    corners = [np.zeros(3, np.int64)]
    for axis in steps:
        corners.append(corners[-1] + 2 * np.eye(3, dtype=np.int64)[axis])
    if np.linalg.det(np.array(corners[1:]) - corners[0]) < 0:
        corners[1], corners[2] = corners[2], corners[1]
    return corners


def cells_of_cube(shape):
    """The corners of each cell of a cube, and its edges."""
    if shape == 'hexahedra':
        return [[np.array(corner) for corner in CORNERS]], CUBE_EDGES
    return [corners_of(steps) for steps in STEPS], EDGES


def ball(n, shape):
    """A ball of 6 n^3 quadratic tetrahedra, or of n^3 quadratic hexahedra."""
    axis = np.linspace(-1, 1, 2 * n + 1)
    z, y, x = np.meshgrid(axis, axis, axis, indexing='ij')
    xx, yy, zz = x * x, y * y, z * z
    points = np.stack([x * np.sqrt(1 - yy / 2 - zz / 2 + yy * zz / 3), y * np.sqrt(1 - zz / 2 - xx / 2 + zz * xx / 3),
                       z * np.sqrt(1 - xx / 2 - yy / 2 + xx * yy / 3)], axis=-1).reshape(-1, 3)
    width = 2 * n + 1
    k, j, i = np.meshgrid(*3 * [np.arange(0, 2 * n, 2)], indexing='ij')
    base = (i + width * (j + width * k)).ravel()
    shifts = []
    cells_of, edges = cells_of_cube(shape)
    for corners in cells_of:
        nodes = corners + [(corners[a] + corners[b]) // 2 for a, b in edges]
        shifts.append([node[0] + width * (node[1] + width * node[2]) for node in nodes])
    size = len(shifts[0])
    cells = (base[:, None, None] + np.array(shifts)).reshape(-1, size)
    mesh = vtkUnstructuredGrid()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    mesh.SetPoints(places)
    listed = vtkCellArray()
    listed.SetData(numpy_to_vtkIdTypeArray(np.arange(0, cells.size + 1, size), deep=True),
                   numpy_to_vtkIdTypeArray(cells.ravel(), deep=True))
    mesh.SetCells(VTK_QUADRATIC_HEXAHEDRON if shape == 'hexahedra' else VTK_QUADRATIC_TETRA, listed)
    return mesh


def least(work, rounds):
    """Seconds as they pass, and of all cores: the least of each."""
    passed, of_cores = [], []
    for _ in range(rounds):
        begin = time.perf_counter(), time.process_time()
        work()
        passed.append(time.perf_counter() - begin[0])
        of_cores.append(time.process_time() - begin[1])
    return np.array((min(passed), min(of_cores)))


def exact_area(distance):
    return math.pi * (1 - distance * distance)


class Ours:
    """This library, with a tolerance."""

    def __init__(self, mesh, tolerance):
        import vprobe
        self.wrap = lambda: vprobe.wrap(mesh, tolerance=tolerance, classify='cpu')
        self.data = self.wrap()

    def first(self):
        self.data = self.wrap()
        self.moved(.1)

    def moved(self, distance):
        cut = self.data.slice(origin=tuple(distance * NORMAL), normal=tuple(NORMAL))
        cut.points, cut.polygons  # what a filter of VTK leaves
        return cut

    def error(self, distances):
        return max(abs(self.moved(d).area / exact_area(d) - 1) for d in distances)


class Vtk:
    """The tessellator, and the plane cutter on what it makes."""

    def __init__(self, mesh, chord):
        self.tessellator = vtkTessellatorFilter()
        self.tessellator.SetInputDataObject(mesh)
        self.tessellator.SetChordError(chord)
        self.tessellator.SetMaximumNumberOfSubdivisions(5)
        self.tessellator.MergePointsOff()
        self.plane = vtkPlane()
        self.plane.SetNormal(*NORMAL)
        self.cutter = vtkPlaneCutter()
        self.cutter.SetPlane(self.plane)
        self.parts = None

    def tessellate(self):
        self.tessellator.Modified()
        self.tessellator.Update()
        self.parts = self.tessellator.GetOutput()
        self.cutter.SetInputData(self.parts)

    def cut(self, distance):
        self.plane.SetOrigin(*(distance * NORMAL))
        self.cutter.Modified()
        self.cutter.Update()

    def area(self):
        """Of the triangles and polygons that came out."""
        out = self.cutter.GetOutputDataObject(0)
        total = 0.0
        pieces = [out.GetPartition(p) for p in range(out.GetNumberOfPartitions())] if hasattr(
            out, 'GetNumberOfPartitions') else [out]
        for piece in pieces:
            if piece is None or piece.GetNumberOfCells() == 0:
                continue
            points = vtk_to_numpy(piece.GetPoints().GetData()).astype(np.float64)
            starts = vtk_to_numpy(piece.GetPolys().GetOffsetsArray())
            ids = vtk_to_numpy(piece.GetPolys().GetConnectivityArray())
            sizes = np.diff(starts)
            for size in np.unique(sizes):
                first = starts[:-1][sizes == size]
                for corner in range(1, size - 1):
                    a, b, c = (points[ids[first + k]] for k in (0, corner, corner + 1))
                    total += .5 * float(np.abs(np.cross(b - a, c - a) @ NORMAL).sum())
        return total

    def error(self, distances):
        worst = 0.0
        for distance in distances:
            self.cut(distance)
            worst = max(worst, abs(self.area() / exact_area(distance) - 1))
        return worst


def write(mesh, name):
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(name)
    writer.SetInputData(mesh)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.Write()


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument('--shape', choices=('tetrahedra', 'hexahedra'), default='tetrahedra')
    parser.add_argument('--cubes', type=int, default=55)
    parser.add_argument('--chord', type=float, default=2e-5)
    parser.add_argument('--rounds', type=int, default=9)
    parser.add_argument('--vtk-rounds', type=int, default=1)
    parser.add_argument('--write')
    options = parser.parse_args()
    mesh = ball(options.cubes, options.shape)
    if options.write:
        write(mesh, options.write)
        return
    distances = (.1, .35, .6)
    vtk = Vtk(mesh, options.chord)
    tessellating = least(vtk.tessellate, options.vtk_rounds)
    first_plane = least(lambda: vtk.cut(.1), 1)
    theirs = vtk.error(distances)
    tolerance, ours = .5, None
    while ours is None or ours.error(distances) > theirs:
        tolerance /= 2
        ours = Ours(mesh, tolerance)
    first = least(ours.first, max(1, options.rounds // 3))
    places = iter(np.linspace(.1, .6, 10 * options.rounds + 10))
    ours.moved(.1)
    moved = least(lambda: ours.moved(next(places)), options.rounds)
    vtk_moved = least(lambda: vtk.cut(next(places)), options.rounds)
    print(f'{mesh.GetNumberOfCells()} quadratic {options.shape}; VTK makes {vtk.parts.GetNumberOfCells()} parts with chords '
          f'off by {options.chord:g}, and our tolerance is {tolerance:g}\n')
    print('| | vprobe | VTK | ratio | vprobe, all cores | VTK, all cores | ratio |')
    print('| --- | --- | --- | --- | --- | --- | --- |')
    print(f'| error of area | {ours.error(distances):.2g} | {theirs:.2g} | | | | |')
    for name, mine, other in (('first cut, tessellation counted', first, tessellating + first_plane),
                              ('moved, against tessellating again', moved, tessellating + vtk_moved),
                              ('moved, against vtkPlaneCutter on the kept parts', moved, vtk_moved)):
        columns = [f'{1000 * mine[i]:.1f} ms | {1000 * other[i]:.1f} ms | {other[i] / mine[i]:.1f}' for i in (0, 1)]
        print(f'| {name} | {" | ".join(columns)} |')


if __name__ == '__main__':
    main()
