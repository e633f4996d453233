#pragma once

#include "base/vec.h"
#include "write/atomic_file.h"
#include "write/xml_array.h"

#include <cstdint>
#include <span>
#include <string>

namespace vp::write
{

// Cells of one kind: cell c has the points ids[starts[c]] .. ids[starts[c + 1]].
struct XmlCells
{
	std::span<const std::int64_t> starts; // cells + 1, or none
	std::span<const std::int64_t> ids;

	std::size_t count() const { return starts.empty() ? 0 : starts.size() - 1; }
};

// The content of a .vtp file. Cell arrays hold values of the dots first, then of the lines, then of the polygons.
struct PolyData
{
	std::span<const Vec3> points;
	XmlCells dots;
	XmlCells lines;
	XmlCells polygons;
	XmlArrays point_arrays;
	XmlArrays cell_arrays;
	XmlArrays file_arrays;
};

// Writes it as VTK's XML format with raw appended data. The file's commit() tells failures.
void writePolyData(const PolyData& data, AtomicFile& file);

// Writes a .pvtp that names .vtp files, relative to its folder. `like`: has the arrays of each of them.
void writePolyDataIndex(const PolyData& like, std::span<const std::string> parts, AtomicFile& file);

} // namespace vp::write
