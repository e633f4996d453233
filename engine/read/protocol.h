#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace vp::read
{

// The protocol between vprobe-read and its parent. The child is started as
//   vprobe-read TIME SOLUTION REFINE DISPLACE PATCHES THREADS ARRAYS FORMAT RAW TARGET FOLDER PACK PARTS SANDBOX
//   FOLLOW STAYS UNPACK LEVEL FILE [SLICE...]
// TIME: last, first, a number, # and an index, or all where a pack is written. SOLUTION: empty or a PLOT3D q file.
// REFINE: how many times the linear parts of curved cells are halved, or a tolerance, which leaves these cells curved.
// DISPLACE: a factor for displacements, and behind a blank the name of their array if it is given; empty for none.
// PATCHES: 1 to read named parts of the boundary, else 0. THREADS: the maximum number of threads. ARRAYS: the wanted
// arrays, one a line: "*" for all, "^" for the default array, "=" and a name for one. FORMAT: a name of
// format_table.inl, or empty. RAW: the layout of a raw volume (rawText()), or empty. TARGET and FOLDER: of convert(),
// or empty; the child writes into this folder and nowhere else. PACK: the most cells of a part of it, where it is
// written in parts; else empty. PARTS: empty for all, "?" to list them, or their numbers with commas between;
// behind numbers and "?", "/" and into how many slabs a lattice comes apart that is alone in its file. In front of all
// that, "places" to leave the cells of a pack in the file (below), which then comes apart like a lattice. SANDBOX:
// auto, require or off. FOLLOW: folders with files that the input may name, one a line, or "anywhere". STAYS: arrays of
// more bytes than this may stay in the file; empty if none may. UNPACK: empty, see below. LEVEL: of images at several
// resolutions, 0 the finest. SLICE: where several files are the slices of one volume, all of them in their order; FILE
// is the first. The child writes arrays into two shared memories, each array at a multiple of kArrayAlignment. kCellsFd
// gets the points and cells of unstructured blocks, which nobody needs after the grid is built, kArraysFd everything
// else. A JSON manifest that describes them goes to kManifestFd:
//
//   {"version", "times": [..], "left_out": cells, "warnings": [words, or {"count", "words"}, ..], "files": those that
//   were read, "bytes_read": by the child from files, "levels": how many the file has, if there are several, "blocks":
//   [{"name", "kind", "arrays": [..], ..}], "patches": [{"name", "coordinates": array, "starts": array, "corners":
//   array}]},
//   "patches" only on request; where PARTS is not empty, "parts": [{"cells",
//   "block"}] and "wholes": null or {"kind",
//   "points"} for each block that the parts are of; blocks have a "part", and there may be none
//   image         "points": [nx, ny, nz], "origin": [..], "spacing": [..]
//   rectilinear   "axes": [array, array, array] of float64
//   curvilinear   "points": [nx, ny, nz], "coordinates": array
//   unstructured  "coordinates": array, "cells": {"types", "offsets", "connectivity", "face_offsets", "face_stream",
//                 "source_cells", "source_cell_count", "source_point_count", "curved"}; the last six only if needed,
//                 offsets unless all cells are of one type and lie one after the other, connectivity of int32 or int64;
//                 "points": [nx, ny, nz] where points and cells, hidden ones too, are those of a lattice
//
// An array is {"type": "float32" ..., "offset", "bytes"}. In "arrays" it also has "name", "association", "components"
// and, if the file has them, "units". An array that nobody asked for has "left_out": true and no place. An array of a
// lattice that stays in the file has no place either, but "stored": {"file", "part": items of a part along i, j, k,
// "swaps": whether its bytes are in the other order, and either "offset", or "offsets": array of uint64 with the offset
// for each part, ~0 for one that was never written, and "fill": array of uint8 with an item for those}. If
// parts are packed it has "filters" (hdf5::Filters::text()), and for each part as array of uint64 "sizes", its bytes in
// the file, and "left_out_filters", where bit n is set if it was not packed by filter n. Or it has "reader" in
// place of all these: a name ("hdf5", "netcdf", "tiff", "zarr") and words for it. Then the reader finds parts by their
// numbers.
// The manifest has "length_units" and "time_units" if the file has them; "sandbox" says what holds the child ("landlock
// 7, seccomp"); "imaging" is {"orientation", "gray", "labels", "label_names": [[value, name]..], "window"}, each if the
// file says it (grid/imaging.h).
//
// With UNPACK the child stays and unpacks parts of an array that stays in FILE, until its standard input ends. UNPACK
// is the size of each part, a blank and the filters or the "reader". A request is the number of parts as a uint64 on
// standard input; kCellsFd then has three uint64 for each of them: offset, size, left out filters, or its number and
// two zeros. The parts go to kArraysFd, one behind the other from its beginning, and when all are there, their number
// as a uint64 to kManifestFd.
//
// A block of a pack has a "pack": {"points", "cells" that are seen, "cells_without_place", "bounds": [x, y, z of both
// ends], "parts", "parts_read", "bytes_read", "farthest": array of float64, points as of grid::FarthestPoints, if they
// are known, "numbers": array of int64 in kCellsFd, the number in the packed file of each cell}. Its arrays have
// "facts" on all values (grid::ArrayFacts): {"tuples", "spans": [[lo, hi, whether there is -inf, +inf] ..], lo and hi
// null if no value is finite, "values": [..], "changes": [all, to the next value]}, and maybe "least_positive": [..].
//
// With "places" in PARTS, the block of a pack whose lists lie in the file as they are in memory is of kind "packed". It
// has "file", "type" of all cells or 0, "type_of_points", "runs": {"boxes": array of float64, lo and hi of each, and as
// arrays of uint64 "cells", "ids", "parts", with polyhedra also "faces", "face_ids"}, and for each part as arrays of
// uint64 "part_cells", "part_points", "part_first_ids", with which the ids of its points begin, and "part_first_ends",
// its first row in "ends". What else it would have stays in the file: "lists" has the offsets of "points",
// "point_numbers", "ids", "cell_numbers", and of "types" and "ends" where "type" is 0, of "face_ids", "face_ends" and
// "polyhedron_ends" with polyhedra (docs/FORMATS.md); each of the "arrays" has "times" and no "bytes": for each time of
// the file an "offset" and "facts", and maybe "ranges", the offset of its RunRanges; "time" is the index of the one
// that was asked for; and "pack" has no "numbers". "source" is an empty list. If the file is the index of another one,
// it has the five numbers of read::SourceStamp, and the offsets of arrays that are "in_source" are places in that other
// file, where numbers may have the other order of bytes ("swaps"). If the pack came apart, "own_runs" has two
// numbers: the first run that was asked for, and the one behind the last. Other files are read as if PARTS had no
// "places".
//
// Started as "vprobe-read copies", it reads nothing and makes copies of itself, which are as if started with the
// arguments above; see ready_reader.h.
constexpr int kProtocolVersion = 23;
constexpr int kArraysFd = 3;
constexpr int kManifestFd = 4;
constexpr int kCellsFd = 5;
constexpr int kCountsFd = 6; // the child's own: /proc/self/io, which its sandbox does not let it open later
constexpr int kLifeFd = 7;   // a pipe of which the parent holds the other end; the child is killed when that closes
constexpr std::size_t kArrayAlignment = 64;
// A part of an array that stays in the file may not be larger.
constexpr std::uint64_t kMaxPartBytes = std::uint64_t(1) << 28;

// If a child gives up, it ends with one of these exit codes, and its last line on standard error starts with this mark.
constexpr int kRefusedExitCode = 2;   // the input cannot be used
constexpr int kNoMemoryExitCode = 3;  // there was no memory left, or no room for what is handed over
constexpr int kNoRoomExitCode = 4;    // the file of convert() cannot be written
constexpr int kNoSandboxExitCode = 5; // SANDBOX is "require", and the system has none
constexpr std::string_view kReasonMark = "vprobe-read: ";
// Each file that an input names is told in such a line before it is read. So a child that is killed has told where.
constexpr std::string_view kReadingMark = "vprobe-read-file: ";

} // namespace vp::read
