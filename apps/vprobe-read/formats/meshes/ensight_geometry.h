#pragma once

#include "ensight_cursor.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace vp::reader::meshes
{

// Elements of one type in a part. Their nodes are points of the part, from 0.
struct EnSightElements
{
	std::string type; // without the g_ of ghosts
	bool is_ghost = false;
	std::int64_t count = 0;
	std::vector<std::int64_t> nodes;      // the nodes of all elements, one after the other
	std::vector<std::int64_t> sizes;      // nsided: nodes of each; nfaced: faces of each
	std::vector<std::int64_t> face_sizes; // nfaced: nodes of each face
};

struct EnSightPart
{
	enum class Kind
	{
		unstructured,
		curvilinear,
		rectilinear,
		uniform
	};
	Kind kind = Kind::unstructured;
	std::string name;
	std::vector<double> coordinates;  // x, y, z of each point; not of rectilinear and uniform blocks
	std::vector<std::int64_t> global; // EnSight 6: which of the file's nodes the points are
	std::vector<EnSightElements> elements;
	std::array<std::int64_t, 3> along = {0, 0, 0}; // points of a block along its axes
	std::array<std::vector<double>, 3> axes;       // rectilinear: places; uniform: origin and distance
	std::vector<std::int64_t> blanks;              // a mark for each point of a block; 0 hides it
	std::vector<std::int64_t> ghosts;              // a mark for each cell of a block; 1 is a ghost

	std::int64_t points() const;
	std::int64_t cells() const;
};

struct EnSightGeometry
{
	bool is_gold = false;
	bool swaps = false;        // the byte order of a binary file
	std::vector<double> nodes; // EnSight 6: x, y, z of those that all parts share
	std::map<std::int64_t, EnSightPart> parts;
};

// How many nodes an element of this type has; 0 for nsided, nfaced and unknown types.
std::int64_t ensightNodesOf(std::string_view type);
bool isEnSightElement(std::string_view type);

// Takes the g_ of ghosts off.
std::string_view ensightTypeOf(std::string_view word, bool& is_ghost);

// Reads the geometry of a step. Throws a Refusal if it is damaged. `may_lack_cells`: those of another step stand for
// them.
EnSightGeometry readEnSightGeometry(const EnSightFile& file, std::string_view step, bool is_gold, bool may_lack_cells);

// Gives the parts that have no elements those of another step. Throws a Refusal if the points are not as many.
void takeEnSightCells(EnSightGeometry& geometry, const EnSightGeometry& other, const std::string& name);

} // namespace vp::reader::meshes
