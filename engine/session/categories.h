#pragma once

#include "grid/block.h"
#include "grid/field_choice.h"
#include "ranks/ranks.h"
#include "view/view_spec.h"

#include <string>
#include <utility>
#include <vector>

namespace vp::session
{

/// An array that names categories, such as the tissues of a segmentation, with nothing between two of them.
struct CategoryArray
{
	std::string name;
	grid::Association association = grid::Association::point;
	std::vector<double> values; // ascending; empty if there are more than grid::kMaxCategories, or several components

	bool operator==(const CategoryArray&) const = default;
};

/// Finds the arrays of integers that name categories: by their names (grid::namesCategories), because the file says
/// so (grid::Imaging::labels), or because they have at most 32 values and are no ramp of gray. A ramp has more than 8
/// values, and where they change from one tuple to the next, it is mostly to the next value. Arrays with fewer than 8
/// tuples a value are too small to tell. All ranks call this together.
std::vector<CategoryArray> findCategories(const grid::BlockSet& blocks, const ranks::Ranks& ranks);

/// Returns the names that the file has for the values of an array, by ascending values; mostly none.
std::vector<std::pair<double, std::string>> labelNames(const grid::BlockSet& blocks, const grid::FieldChoice& field);

/// Marks the arrays that are not interpolated: those found, all, or none. Returns true if a mark has changed.
bool markCategories(grid::BlockSet& blocks, const std::vector<CategoryArray>& found, view::Interpolate interpolate);

} // namespace vp::session
