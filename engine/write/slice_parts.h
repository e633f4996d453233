#pragma once

#include "base/result.h"
#include "write/atomic_file.h"
#include "write/slice_table.h"

#include <cstddef>
#include <string>

namespace vp::write
{

// A part of a slice of which each process has one: a .vtp in a folder of the stem of a .pvtp, beside that: out.pvtp and
// out/part_0.vtp. It is written under another name, and gets its own on commit(), when all parts are written. The
// .pvtp comes last (writePartIndex).
class SlicePart
{
public:
	static Result<SlicePart> write(const SliceTable& table, const std::string& index, std::size_t number);

	Status commit() { return file_.commit(); }

private:
	explicit SlicePart(AtomicFile file) : file_(std::move(file)) {}

	AtomicFile file_;
};

// Writes the .pvtp that names so many parts. like: has the columns of each of them.
Status writePartIndex(const SliceTable& like, const std::string& index, std::size_t parts);

// All of it, of one part.
Status writePvtp(const SliceTable& table, const std::string& path);

} // namespace vp::write
