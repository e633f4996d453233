#pragma once

#include "contour/box_contour.h"
#include "session/sheet_stats.h"
#include "write/slice_table.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace vp::session
{

// The contours of a slice, per sheet.
using Contours = std::vector<std::vector<contour::Contour>>;

// A value on one sheet of a slice, as a pointer has found it.
struct PointedValue
{
	std::size_t sheet = 0;
	double value = 0.0;

	bool operator==(const PointedValue&) const = default;
};

// What is told of contours that cannot be grown; else they are left out.
enum class Tell
{
	all,   // values that are not on a sheet in a word, a place that is not cut as an error
	unfit, // of a frame among many: sheets that can have none, as an error
	nothing
};

// sheets: sheetStats() of the slice. pointed: one more, which is never told of. None where none is asked for. Sheets
// that are no planes are a usage error, sheets without values at points an input error. Section "contour".
Result<Contours> growContours(const Session& session, const cut::Cut& slice, const std::vector<SheetStats>& sheets,
                              const view::ContourSpec& spec, Tell tell,
                              const std::optional<PointedValue>& pointed = {});

// For files; the contours must outlive them.
std::vector<write::ContourPiece> contourPieces(const Contours& contours);

} // namespace vp::session
