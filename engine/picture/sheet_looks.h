#pragma once

#include "render/scene/scene.h"
#include "session/sheet_stats.h"
#include "session/times_seen.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vp::picture
{

// Computes how the sheets of a session look. Whatever does not change between pictures is computed once.
class SheetLooks
{
public:
	SheetLooks(const session::Session& session, view::ResolvedLook choice);

	const view::ResolvedLook& choice() const { return choice_; }
	void setChoice(view::ResolvedLook choice);
	// Call this when the values of the arrays have changed.
	void forgetScales();
	// From now on colors reach over the values that were seen at several times. Null: over those of the session's time.
	void setTimesSeen(std::shared_ptr<const session::TimesSeen> seen) { times_seen_ = std::move(seen); }
	const session::TimesSeen* timesSeen() const { return times_seen_.get(); }
	// If the settings ask for the range of all times, and nobody has looked at them, looks at them.
	Status seeTimesIfAsked();

	// Returns the scale of the shown array, or of generations. sheets: all sheets of the cut.
	Result<std::optional<render::ValueScale>> scaleOf(const cut::Cut& slice,
	                                                  std::span<const session::SheetStats> sheets, bool has_nan);
	// Returns the scale of an array.
	Result<std::optional<render::ValueScale>> scaleOf(const std::optional<grid::FieldChoice>& field, bool has_nan);
	// Returns the drawing of a sheet, without its records.
	Result<render::SheetDrawing> drawing(const cut::SheetCut& sheet, const session::SheetStats& stats);

private:
	void reachOverTimes(const grid::FieldChoice& field, render::ValueScale& scale);
	// Returns the scale of an array, with the ends that the look asks for. sheets: the sheets that show the array.
	void chooseEnds(const std::optional<grid::FieldChoice>& field, render::ValueScale& scale,
	                std::span<const session::SheetStats* const> sheets) const;
	render::ColorMap colorsByFile(const std::optional<grid::FieldChoice>& field) const;
	void takeFromFile();
	bool usesScanWindow() const;
	std::string unitsOf(const std::optional<grid::FieldChoice>& field) const;

	const session::Session& session_;
	view::ResolvedLook choice_;
	std::vector<std::pair<std::optional<grid::FieldChoice>, std::optional<render::ValueScale>>> scales_;
	std::shared_ptr<const session::TimesSeen> times_seen_;
	// The windows of scans that were found first, for all times.
	std::vector<std::pair<grid::FieldChoice, std::pair<double, double>>> windows_;
	std::map<std::string, render::ColorMap> colors_; // maps that single sheets ask for
};

// Describes the place of a sheet in a caption. A coordinate that is only rounding, compared with the largest of the
// bounds or of the others, becomes 0.
std::string caption(const probe::Sheet& sheet, const Box& bounds = {});

// Returns a caption behind the time of the session's values, if the inputs have times.
std::string withTime(const session::Session& session, const std::string& caption);

// Returns the arrays that the sheets show, each once.
std::vector<grid::FieldChoice> shownFields(const session::Session& session);

// Returns true if a picture of the sheet shows places without a value.
bool hasNan(const session::SheetStats& sheet);

} // namespace vp::picture
