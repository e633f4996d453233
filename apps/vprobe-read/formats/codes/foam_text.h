#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::codes
{

// Files of OpenFOAM that hold lists, as text or as bytes, in the precision that they have. What is not understood is a
// Refusal.

struct FoamHead
{
	std::string type; // the file's "class"
	std::string object;
	bool is_binary = false;
	bool is_big_endian = false;
	int label_bytes = 4;
	int scalar_bytes = 8;

	// False if its numbers are in single precision already.
	bool isDouble() const { return !is_binary || scalar_bytes == 8; }
};

struct FoamList
{
	int components = 1;
	bool is_uniform = false;     // then the numbers are those of one element
	std::vector<double> numbers; // element by element
	std::size_t announced = kAny;

	static constexpr std::size_t kAny = static_cast<std::size_t>(-1);

	std::size_t size() const { return is_uniform ? announced : numbers.size() / static_cast<std::size_t>(components); }
	// Whether it has a value for each of so many elements, and for no more.
	bool fits(std::size_t elements) const { return size() == elements || (is_uniform && announced == kAny); }
	const double* at(std::size_t element) const
	{
		return numbers.data() + (is_uniform ? 0 : element * static_cast<std::size_t>(components));
	}
};

// The corners of each face, one face after the other.
struct FoamFaces
{
	std::vector<std::int64_t> starts = {0};
	std::vector<std::int64_t> corners;

	std::size_t size() const { return starts.size() - 1; }
	std::span<const std::int64_t> operator[](std::size_t face) const
	{
		const auto first = static_cast<std::size_t>(starts[face]);
		return std::span(corners).subspan(first, static_cast<std::size_t>(starts[face + 1]) - first);
	}
};

struct FoamPatch
{
	std::string name, type;
	std::vector<std::string> groups;
	std::int64_t first = 0; // face
	std::int64_t faces = 0;
	// In a part of a decomposed case: the part behind its faces, or -1, and the cyclic patch that they are of, if any.
	std::int64_t part_behind = -1;
	std::string cyclic{};
};

// A file's first bytes are enough.
FoamHead foamHead(std::string_view text);

FoamList foamPoints(std::string_view text);
FoamFaces foamFaces(std::string_view text);
// At most so many, as a list of equal ones takes no room.
std::vector<std::int64_t> foamLabels(std::string_view text, std::size_t most);
std::vector<FoamPatch> foamPatches(std::string_view text);

} // namespace vp::reader::codes
