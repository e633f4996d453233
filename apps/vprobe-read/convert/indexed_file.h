#pragma once

#include "grid/field.h"
#include "parts/file_extents.h"
#include "read/source_stamp.h"
#include "vprobe-read/arrays/plain_array.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <hdf5.h>

namespace vp::reader::convert
{

// Returns the plain arrays of a file; none if its format is not one of those of which we know where arrays lie. What is
// returned need not be so: who uses it compares the values. Defined by formats/vtk.
std::vector<arrays::PlainArray> plainArraysOf(const std::string& file);

// The file that an index is made of. Cuts read those of its values where they are that lie there as plain numbers.
class IndexedFile
{
public:
	// Where the values of an array begin.
	struct Place
	{
		std::uint64_t offset;
		bool swaps; // whether the bytes of a number are in the other order
	};

	// stamp: of the file before it was read. Throws a Refusal if other files were read with it.
	IndexedFile(const std::string& file, const read::SourceStamp& stamp);

	// Returns where these values of an array lie. Nothing if exactly these are nowhere where they might be.
	// time: where to look first.
	std::optional<Place> placeOf(bool on_points, const std::string& name, const grid::Field& values,
	                             std::size_t time) const;
	// Writes what the index knows the file by. Throws a Refusal if it has changed since it was read, and NoRoom.
	void writeStamp(hid_t own) const;

private:
	parts::OpenFile file_;
	read::SourceStamp stamp_;
	std::vector<arrays::PlainArray> arrays_;
};

// Writes into the own group of an array of an index where its values begin in the file, at each time. Throws NoRoom.
void writePlaces(hid_t own, const grid::Field& values, const std::vector<std::uint64_t>& places, bool swaps);

} // namespace vp::reader::convert
