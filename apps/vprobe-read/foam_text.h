#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Files of OpenFOAM, as text or as bytes, in the precision that they have. All that is not understood is a Refusal.

struct FoamHead
{
	std::string type; // the file's "class"
	std::string object;
	bool is_binary = false;
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

	std::size_t size() const { return numbers.size() / static_cast<std::size_t>(components); }
	const double* at(std::size_t element) const
	{
		return numbers.data() + (is_uniform ? 0 : element * static_cast<std::size_t>(components));
	}
};

struct FoamField
{
	FoamList inside;
	// By the names of the patches that are written without a pattern. Those without a list take what the cells have.
	// A patch whose value is written in words that are not read here is none of these.
	std::map<std::string, std::optional<FoamList>, std::less<>> patches;
};

// The corners of each face, one face after the other.
struct FoamFaces
{
	std::vector<std::int64_t> starts = {0};
	std::vector<std::int64_t> corners;

	std::size_t size() const { return starts.size() - 1; }
};

struct FoamPatch
{
	std::string name, type;
	std::int64_t first = 0; // face
	std::int64_t faces = 0;
};

// A file's first bytes are enough.
FoamHead foamHead(std::string_view text);

FoamList foamPoints(std::string_view text);
FoamField foamField(std::string_view text);
FoamFaces foamFaces(std::string_view text);
std::vector<std::int64_t> foamLabels(std::string_view text);
std::vector<FoamPatch> foamPatches(std::string_view text);
