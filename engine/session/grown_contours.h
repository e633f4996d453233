#pragma once

#include "ranks/search/joined_contour.h"
#include "session/sheet_stats.h"
#include "write/slice_table.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vp::session
{

// The contours of a slice, per sheet.
using Contours = std::vector<std::vector<ranks::GrownContour>>;

// A value that a pointer found on one sheet of a cut.
struct PointedValue
{
	std::size_t sheet = 0;
	double value = 0.0;

	bool operator==(const PointedValue&) const = default;
};

// Which contours that cannot be grown are reported. The others are left out without a word.
enum class Tell
{
	all,   // warns of values that no sheet has; a place that is not cut is an error
	unfit, // for one frame of many: only sheets that can have no contours are an error
	nothing
};

// Grows the contours that the settings ask for. sheets: those of the frame. pointed: one more contour, which is
// never reported. All ranks call it together, and each gets the polygons of its blocks. Sheets that are not planes
// are a usage error; sheets without point values are an input error. Section "contour" on the timeline.
Result<Contours> growContours(const Session& session, const cut::Cut& slice, const std::vector<SheetStats>& sheets,
                              const view::ContourSpec& spec, Tell tell,
                              const std::optional<PointedValue>& pointed = {});

// Returns the contours as files need them. The contours must outlive the result.
std::vector<write::ContourPiece> contourPieces(const Contours& contours);

} // namespace vp::session
