#pragma once

#include "grid/field.h"
#include "read/source_stamp.h"
#include "vprobe-read/quick/plain_arrays.h"

#include <cstdint>
#include <string>
#include <vector>

#include <hdf5.h>

namespace vp::reader::convert
{

// The file that an index is made of. Cuts read its values where they are.
class IndexedFile
{
public:
	// stamp: of the file before it was read. Throws a Refusal unless its values lie there as plain numbers.
	IndexedFile(const std::string& file, const read::SourceStamp& stamp);
	~IndexedFile();
	IndexedFile(const IndexedFile&) = delete;
	IndexedFile& operator=(const IndexedFile&) = delete;

	// Returns where the values of an array begin. Throws a Refusal unless exactly these lie there.
	std::uint64_t placeOf(bool on_points, const std::string& name, const grid::Field& values) const;
	// Writes what the index knows the file by. Throws a Refusal if it has changed since it was read, and NoRoom.
	void writeStamp(hid_t own) const;

private:
	int descriptor_;
	read::SourceStamp stamp_;
	std::vector<quick::PlainArray> arrays_;
};

// Writes into the own group of an array of an index where its values begin in the file, at each time. Throws NoRoom.
void writePlaces(hid_t own, const std::string& name, const grid::Field& values,
                 const std::vector<std::uint64_t>& places);

} // namespace vp::reader::convert
