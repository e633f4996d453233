#pragma once

#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/refusal.h"

#include <optional>
#include <string_view>

namespace vp::reader::volumes
{

// One array of NumPy's format (numpy.lib.format, versions 1 to 3).
struct NpyArray
{
	arrays::ValueLayout layout;
	std::string_view values;
};

// Thrown for an array whose values are no plain numbers.
class UnreadNpyType : public Refusal
{
public:
	using Refusal::Refusal;
};

// Null for an array that is no volume: of fewer than three axes. With four, the one that runs fastest is the
// components; two are those of a picture, if it is wanted. C order, NumPy's own, has z first and x last; Fortran order
// the other way round. Throws a Refusal for what is damaged, and an UnreadNpyType.
std::optional<NpyArray> parseNpy(std::string_view file, bool takes_pictures = false);

} // namespace vp::reader::volumes
