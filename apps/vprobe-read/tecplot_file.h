#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// A zone of a Tecplot text file.
struct TecplotZone
{
	std::string title;
	std::array<std::uint32_t, 3> points{1, 1, 1}; // of an ordered zone
	std::string element_type;                     // empty for an ordered zone; "BRICK", "TETRAHEDRON" ...
	std::size_t nodes = 0;
	std::size_t elements = 0;
	std::optional<double> time;
	std::set<std::size_t> cell_variables;                           // by number, from 0
	std::vector<std::shared_ptr<const std::vector<double>>> values; // by variable; null where it is passive
	std::shared_ptr<const std::vector<std::int64_t>> corners;       // of all elements, from 0
};

struct TecplotFile
{
	std::vector<std::string> variables;
	std::vector<TecplotZone> zones;
};

// The corners of an element of this type, 0 for a type that is not read.
int tecplotCorners(const std::string& element_type);

// Throws a Refusal for what is damaged or not read.
TecplotFile parseTecplot(std::string_view text);
