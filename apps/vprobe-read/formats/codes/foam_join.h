#pragma once

#include "foam_case.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vp::reader::codes
{

// A patch of one part.
struct FoamPatchOfPart
{
	std::size_t part, patch;
};

// The mesh of a region, and where it has what its parts have. A case that is whole has no parts.
struct FoamRegion
{
	FoamMesh mesh;
	std::vector<FoamMesh> parts;      // without their faces
	std::vector<FoamNumbers> numbers; // that the parts' points and cells have in the whole
	bool has_numbers = true;          // false if the numbers are this program's, not the case's
	// For each patch of the whole: those that its faces come from, in the order of the faces.
	std::vector<std::vector<FoamPatchOfPart>> patches;
};

// Puts the parts of a mesh together. Faces between processors join what is on their two sides. The numbers of points
// and cells are those of the case, if all parts tell them and they fit; else one part follows the other. Throws a
// Refusal if two parts do not fit together.
FoamRegion joinFoamParts(std::vector<FoamMesh> parts, std::vector<FoamNumbers> numbers);

} // namespace vp::reader::codes
