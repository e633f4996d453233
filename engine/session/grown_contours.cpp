#include "session/grown_contours.h"

#include "base/digits.h"
#include "base/messages.h"
#include "measure/sheet_lookup.h"

#include <fmt/format.h>

#include <cmath>

namespace vp::session
{

namespace
{

const char* settingOf(const view::ContourSpec& spec)
{
	return spec.values.empty() && spec.at ? "`contour_at`" : "`contour`";
}

Status checkSheet(const cut::SheetCut& sheet, const char* setting)
{
	if (!sheet.isPlane())
		return Error{ErrorKind::usage, fmt::format("{}: grows from planes, and {} is none; leave one of the two out",
		                                           setting, cut::surfaceName(sheet))};
	if (!sheet.field || sheet.field->association != grid::Association::point)
		return Error{ErrorKind::input,
		             fmt::format("{}: needs values at points{}; choose an array of points with `array`", setting,
		                         sheet.field ? ", and " + sheet.field->name + " has them in cells" : "")};
	return Nothing{};
}

struct ValueThere
{
	bool is_there = false;
	bool is_inside = false; // the place is inside a polygon; else beside one, by rounding
	double value = 0.0;
};

// Returns the sheet's value at a place of its box. The place runs from 0 to 1 along the box's sides.
ValueThere valueAt(const contour::BoxContourer& contourer, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                   const std::pair<double, double>& at)
{
	const Vec3 size = contourer.box().hi() - contourer.box().lo();
	const glm::dvec2 uv(contourer.box().lo().x + at.first * size.x, contourer.box().lo().y + at.second * size.y);
	const measure::SheetLookup lookup(mesh, sheet.sheet);
	const auto place = lookup.at(uv);
	if (!place)
		return {};
	return {true, place->inside, lookup.value(*place, contourer.values())};
}

Result<double> valueOfAll(const Session& session, ValueThere there, const std::pair<double, double>& at)
{
	// Of polygons over each other the last counts, as in one process.
	there = session.ranks().sum(there,
	                            [](ValueThere& all, const ValueThere& higher)
	                            {
		                            if (higher.is_there && (!all.is_there || higher.is_inside || !all.is_inside))
			                            all = higher;
	                            });
	if (there.is_there && std::isfinite(there.value))
		return there.value;
	return Error{ErrorKind::usage,
	             fmt::format("`contour_at` {} {}: the first sheet has no value there; choose a place that it shows",
	                         at.first, at.second)};
}

contour::BoxContourer contourerOf(const Session& session, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                                  const view::ContourSpec& spec)
{
	const auto depth = spec.depth > 0.0 ? std::optional(spec.depth) : std::nullopt;
	const Box rect = ranks::rectOf(session.ranks(), sheet, mesh);
	contour::BoxContourer contourer(session.cutter(), sheet, mesh, contour::boxOf(sheet, rect, depth));
	ranks::shareRange(session.ranks(), contourer);
	return contourer;
}

bool isEmpty(const Session& session, const ranks::GrownContour& contour)
{
	return !session.ranks().any(contour.mesh.polygons() > 0);
}

void tellEmpty(const Session& session, const cut::Cut& slice, std::size_t s, double value,
               const contour::BoxContourer& contourer)
{
	if (!contourer.range())
		return; // it shows nothing, which has been told
	const std::string where = slice.sheets.size() == 1 ? std::string("the sheet") : fmt::format("sheet {}", s);
	const auto [lo, hi] = *contourer.range();
	const int digits = digitsForRange(lo, hi);
	warn("`contour` {} is empty: {} has {} from {:.{}g} to {:.{}g} within its box; give a value between", value, where,
	     slice.sheets[s].field->title(session.blocks()), lo, digits, hi, digits);
}

} // namespace

Result<Contours> growContours(const Session& session, const cut::Cut& slice, const std::vector<SheetStats>& sheets,
                              const view::ContourSpec& spec, Tell tell, const std::optional<PointedValue>& pointed)
{
	if (!spec.isGiven() && !pointed)
		return Contours();
	Contours contours(sheets.size());
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		const bool is_pointed = pointed && pointed->sheet == s;
		const bool is_placed = s == 0 && spec.at.has_value();
		if (spec.values.empty() && !is_placed && !is_pointed)
			continue;
		if (Status fits = checkSheet(slice.sheets[s], settingOf(spec)); !fits)
		{
			if (tell != Tell::nothing)
				return fits.error();
			continue;
		}
		const contour::BoxContourer contourer = contourerOf(session, slice.sheets[s], sheets[s].mesh, spec);
		std::vector<double> values = spec.values;
		if (is_placed)
		{
			const Result<double> value =
			    valueOfAll(session, valueAt(contourer, slice.sheets[s], sheets[s].mesh, *spec.at), *spec.at);
			if (!value && tell == Tell::all)
				return value.error();
			if (value)
				values.push_back(*value);
		}
		if (is_pointed)
			values.push_back(pointed->value);
		Result<std::vector<ranks::GrownContour>> grown =
		    ranks::growContours(session.ranks(), session.blocks(), contourer, values, session.timeline());
		if (!grown)
			return grown.error();
		contours[s] = std::move(*grown);
		for (const ranks::GrownContour& contour : contours[s])
			if (tell == Tell::all && isEmpty(session, contour))
				tellEmpty(session, slice, s, contour.value, contourer);
	}
	return contours;
}

std::vector<write::ContourPiece> contourPieces(const Contours& contours)
{
	std::vector<write::ContourPiece> pieces;
	for (std::size_t s = 0; s < contours.size(); ++s)
		for (const ranks::GrownContour& contour : contours[s])
			pieces.push_back({&contour.mesh, static_cast<std::int32_t>(s), contour.value});
	return pieces;
}

} // namespace vp::session
