#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vp::reader::meshes
{

// Data over nodes or elements at one time, as a post-processing section of a Gmsh file has them.
struct GmshData
{
	std::string name;
	bool of_nodes = true;
	double time = 0.0;
	std::int64_t step = 0;
	std::int64_t partition = 0; // 0 for none
	int components = 1;
	std::vector<std::int64_t> tags;
	std::vector<double> values;
};

// A Gmsh file of version 1, 2 or 4, text or binary.
struct GmshMesh
{
	std::vector<double> coordinates;
	std::unordered_map<std::int64_t, std::int64_t> point_of_tag;

	// By element, in the order of the file; corners are points.
	std::vector<std::uint8_t> types; // VTK's
	std::vector<std::int64_t> offsets{0};
	std::vector<std::int64_t> corners;
	std::vector<std::int64_t> tags;
	std::vector<std::int32_t> physical; // the first group; 0 for none
	std::vector<std::int32_t> entity;
	std::vector<std::int32_t> partition; // the one that owns the element; empty if there are none
	std::vector<std::uint8_t> ghost;     // 1 if another partition owns the element; empty if there are none
	std::map<std::int64_t, std::vector<std::int32_t>> more_groups;   // the others, if an element has several groups
	std::vector<std::pair<std::int64_t, std::int64_t>> other_tags;   // further tags of elements
	std::map<std::pair<int, std::int32_t>, std::string> group_names; // by dimension and number
	std::map<int, std::size_t> unknown_types;                        // Gmsh's, and how many elements have them

	std::vector<GmshData> data;
	bool has_other_data = false;
};

// Throws a Refusal for a file that is damaged, or of another version.
GmshMesh parseGmsh(std::string_view file);

} // namespace vp::reader::meshes
