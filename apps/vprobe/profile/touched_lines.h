#pragma once

#include "session/frame.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace vp::app
{

// The memory that a stage reads or writes while it cuts one plane, each line of 64 bytes once.
struct Touched
{
	double lines = 0.0;
	double runs = 0.0; // lines with no line just before them: where the memory must be found anew

	Touched& operator+=(const Touched& more);
};

// Counts different lines of memory. An array is known by a number, and begins at the beginning of a line.
class LineCount
{
public:
	// Counts bytes [at, at + size) of an array.
	void touch(std::uint32_t array, std::uint64_t at, std::uint64_t size);
	// Counts all of an array that nothing else touches.
	void touchAll(double size);
	Touched result();

private:
	std::vector<std::uint64_t> lines_;
	std::uint64_t last_ = ~std::uint64_t(0);
	Touched whole_{};
};

// Counts what `traverse` and `emit` touch for a frame, by what they have found and made: what is read of the grid, what
// remembers the visited cells, and what is written. It is not counted while they work, since that would slow them down.
std::map<std::string, Touched, std::less<>> touchedBy(const grid::BlockSet& blocks, const session::Frame& frame);

} // namespace vp::app
