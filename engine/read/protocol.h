#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace vp::read
{

// What vprobe-read and its parent agree on. The child is started as
//   vprobe-read TIME SOLUTION REFINE DISPLACE PATCHES THREADS ARRAYS FILE
// with TIME last, first, a number or # and an index, SOLUTION empty or a PLOT3D q file, REFINE how many times the
// linear parts of curved cells are halved, DISPLACE what Exodus displacements are multiplied with, 0 for none, and
// PATCHES 1 where the parts of the boundary that the file names are wanted, else 0, THREADS the most threads to use,
// and ARRAYS which arrays are wanted, in lines: "*" for all, "^" for the one that is shown where none is named, and a
// name behind "=". It writes arrays into two shared memories, each array at a multiple of kArrayAlignment: kCellsFd
// takes the points and cells of unstructured blocks, which are needed no more once a grid is built, kArraysFd all else.
// One JSON manifest that describes them goes into kManifestFd:
//
//   {"version", "times": [..], "left_out": cells, "warnings": [..], "blocks": [{"name", "kind", "arrays": [..], ..}],
//    "patches": [{"name", "coordinates": array, "starts": array, "corners": array}]}, the latter where asked for
//   image         "points": [nx, ny, nz], "origin": [..], "spacing": [..]
//   rectilinear   "axes": [array, array, array] of float64
//   curvilinear   "points": [nx, ny, nz], "coordinates": array
//   unstructured  "coordinates": array, "cells": {"types", "offsets", "connectivity", "face_offsets", "face_stream",
//                 "source_cells", "source_cell_count", "source_point_count"}; the latter five where there is need,
//                 offsets unless all cells are of one type and lie one after the other, connectivity of int32 or int64;
//                 "points": [nx, ny, nz] where points and cells, hidden ones too, are those of a lattice
//
// An array is {"type": "float32" ..., "offset", "bytes"}, and among "arrays" also has "name", "association",
// "components" and, where the file names them, "units". One that nobody asked for has "left_out": true, and no place.
// So the manifest has "length_units".
constexpr int kProtocolVersion = 5;
constexpr int kArraysFd = 3;
constexpr int kManifestFd = 4;
constexpr int kCellsFd = 5;
constexpr std::size_t kArrayAlignment = 64;

// A child that refuses its input ends with this exit code and a last line on standard error that starts with this mark.
constexpr int kRefusedExitCode = 2;
constexpr std::string_view kReasonMark = "vprobe-read: ";

constexpr std::array<std::string_view, 35> kEndings = {
    ".vti", ".vtr",    ".vts", ".vtu",    ".pvti", ".pvtr",  ".pvts", ".pvtu", ".htg", ".vtm",    ".vthb", ".vtk",
    ".pvd", ".series", ".hdf", ".vtkhdf", ".mhd",  ".mha",   ".nrrd", ".nhdr", ".nii", ".nii.gz", ".xyz",  ".x",
    ".g",   ".p3d",    ".bin", ".cgns",   ".case", ".encas", ".foam", ".ex2",  ".e",   ".exo",    ".exii"};

} // namespace vp::read
