#pragma once

#include "grid/orientation.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vp::grid
{

/// A file of a scanner, a microscope or a camera says how it is looked at. Pictures begin with it; no figure depends on
/// it.
struct Imaging
{
	std::string orientation{}; // how the coordinates lie, as parseOrientation() takes it; mostly empty
	bool gray = false;         // its values are shown in gray, as in the field's own programs
	bool labels = false;       // its values name categories, as in a segmentation
	std::optional<std::pair<double, double>> window{};         // the values that are black and white, low < high
	std::vector<std::pair<double, std::string>> label_names{}; // by ascending values; mostly empty

	bool operator==(const Imaging&) const = default;
};

} // namespace vp::grid
