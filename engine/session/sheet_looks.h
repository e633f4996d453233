#pragma once

#include "render/scene/scene.h"
#include "session/sheet_stats.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vp::session
{

// How the sheets of a session are to look. What does not change from picture to picture is worked out once.
class SheetLooks
{
public:
	SheetLooks(const Session& session, view::ResolvedLook choice);

	const view::ResolvedLook& choice() const { return choice_; }
	void setChoice(view::ResolvedLook choice);
	// The arrays hold other values now.
	void forgetScales() { scales_.clear(); }

	// Of the array that the sheets show, or of generations. sheets: all of the slice's.
	Result<std::optional<render::ValueScale>> scaleOf(const cut::Cut& slice, std::span<const SheetStats> sheets,
	                                                  bool has_nan);
	// Of an array.
	Result<std::optional<render::ValueScale>> scaleOf(const std::optional<grid::FieldChoice>& field, bool has_nan);
	// Without records.
	Result<render::SheetDrawing> drawing(const cut::SheetCut& sheet, const SheetStats& stats);

private:
	// The array's scale with the ends that the look asks for. sheets: those that show it.
	void chooseEnds(render::ValueScale& scale, std::span<const SheetStats* const> sheets) const;
	void takeLengthUnits();
	std::string unitsOf(const std::optional<grid::FieldChoice>& field) const;

	const Session& session_;
	view::ResolvedLook choice_;
	std::vector<std::pair<std::optional<grid::FieldChoice>, std::optional<render::ValueScale>>> scales_;
	std::map<std::string, render::ColorMap> colors_; // of sheets that wish for one
};

// Where a sheet is, in words. Coordinates that are rounding beside the largest of the grid's bounds, or of the
// others, are 0.
std::string caption(const probe::Sheet& sheet, const Box& bounds = {});

bool hasNan(const SheetStats& sheet);

} // namespace vp::session
