#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::meshes
{

// The faces of a zone of polyhedra, from 0. A face's normal points from its left element to its right one.
struct TecplotFaces
{
	std::vector<std::int64_t> starts = {0}; // faces + 1 offsets into corners
	std::vector<std::int64_t> corners;
	std::vector<std::int64_t> left, right; // elements; -1 where there is none
};

// A zone of a Tecplot text file.
struct TecplotZone
{
	std::string title;
	std::array<std::uint32_t, 3> points{1, 1, 1}; // the sides of an ordered zone
	std::string element_type;                     // empty for an ordered zone; "BRICK", "TETRAHEDRON" ...
	std::size_t nodes = 0;
	std::size_t elements = 0;
	std::optional<double> time;                                     // none if it is shown at all times
	std::set<std::size_t> cell_variables;                           // by number, from 0
	std::vector<std::shared_ptr<const std::vector<double>>> values; // by variable; null where it is passive
	std::shared_ptr<const std::vector<std::int64_t>> corners;       // the corners of all elements, from 0
	std::shared_ptr<const TecplotFaces> faces;                      // the faces of polyhedra
};

struct TecplotFile
{
	std::vector<std::string> variables; // each name once
	std::vector<TecplotZone> zones;
};

// The corners of an element of this type, 0 for a type that is not read or has any number of them.
int tecplotCorners(const std::string& element_type);

// Throws a Refusal for what is damaged or not read.
TecplotFile parseTecplot(std::string_view text);

} // namespace vp::reader::meshes
