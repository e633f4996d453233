#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <teem/nrrd.h>

namespace vp::reader::volumes
{

struct NrrdDeleter
{
	void operator()(Nrrd* nrrd) const { nrrdNuke(nrrd); }
	void operator()(NrrdIoState* state) const { nrrdIoStateNix(state); }
};
using NrrdPointer = std::unique_ptr<Nrrd, NrrdDeleter>;

// Returns the last of teem's lines, which is the cause.
std::string biffReason();

// Returns a file with its values. Throws a Refusal.
NrrdPointer loadNrrd(const std::string& file);

// A header without its values, which lie in one piece of one file as plain numbers.
struct NrrdHead
{
	NrrdPointer nrrd; // has no data
	std::string file;
	std::uint64_t offset = 0;
	bool is_big_endian = false;
};

// Returns nothing if the values lie otherwise, or if loadNrrd() has to say what is wrong.
std::optional<NrrdHead> plainNrrd(const std::string& file);

} // namespace vp::reader::volumes
