#pragma once

#include "base/vec.h"

#include <optional>
#include <string>
#include <string_view>

namespace vp::grid
{

/// How the coordinates of a file lie, as its format or its header says it. Pictures turn by it; coordinates do not
/// change.
struct Orientation
{
	/// Directions of a patient, as unit vectors of the file's coordinates. Together they are a right-handed or a
	/// left-handed frame of axes.
	struct Patient
	{
		Vec3 left;
		Vec3 front; // anterior
		Vec3 head;  // superior

		bool operator==(const Patient&) const = default;
	};
	std::optional<Patient> patient{};
	bool first_row_is_top = false; // a raster of pixels whose y runs down

	bool isGiven() const { return patient || first_row_is_top; }
	bool operator==(const Orientation&) const = default;
};

/// Returns the orientation of a text: three letters for the directions that x, y and z run to, such as `LPS` or `RAS`
/// (L or R, A or P, and S or I, in any order; H and F are taken for S and I), or `rows-down` for a raster whose first
/// row is the top. Returns an orientation that is not given for any other text.
Orientation parseOrientation(std::string_view text);

/// Returns the letter of the patient's side (L, R, A, P, H, F) that a direction runs to, by its nearest axis.
char sideOf(const Orientation::Patient& patient, const Vec3& direction);

} // namespace vp::grid
