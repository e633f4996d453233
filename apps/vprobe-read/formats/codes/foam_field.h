#pragma once

#include "foam_dictionary.h"
#include "vprobe-read/base/refusal.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::codes
{

// A file is sound, but its values cannot be told without running code or looking elsewhere.
class FoamUnknown : public Refusal
{
public:
	using Refusal::Refusal;
};

// The values at the faces of a patch.
struct FoamPatchValues
{
	std::shared_ptr<const FoamList> values; // null: those of the cells beside them
	std::string unknown;                    // why they are not known; mostly empty
};

struct FoamField
{
	std::shared_ptr<const FoamList> inside;
	std::vector<FoamPatchValues> patches; // one for each patch of the mesh
};

// How many numbers an element has in a file of this class; 0 for files that are no fields of cells or of points.
int foamComponentsOfField(std::string_view type);

// A field of so many elements, on a mesh with these patches. Patches take their entries by their own names, else by
// those of their groups, else by patterns. Throws FoamUnknown, or a Refusal for what is damaged.
FoamField foamField(const FoamDocument& document, std::size_t elements, std::span<const FoamPatch> patches);

} // namespace vp::reader::codes
