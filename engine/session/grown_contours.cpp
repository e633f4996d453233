#include "session/grown_contours.h"

#include "base/messages.h"
#include "measure/sheet_lookup.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

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

// What the sheet has at a place of its box, 0 to 1 along its sides.
Result<double> valueAt(const contour::BoxContourer& contourer, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                       const std::pair<double, double>& at)
{
	const Vec3 size = contourer.box().hi() - contourer.box().lo();
	const glm::dvec2 uv(contourer.box().lo().x + at.first * size.x, contourer.box().lo().y + at.second * size.y);
	const measure::SheetLookup lookup(mesh, sheet.sheet);
	if (const auto place = lookup.at(uv))
		if (const double value = lookup.value(*place, contourer.values()); std::isfinite(value))
			return value;
	return Error{ErrorKind::usage,
	             fmt::format("`contour_at` {} {}: the first sheet has no value there; choose a place that it shows",
	                         at.first, at.second)};
}

// One beside the other.
Result<std::vector<contour::Contour>> growAll(const contour::BoxContourer& contourer, const std::vector<double>& values,
                                              Timeline* timeline)
{
	std::vector<contour::Contour> contours(values.size());
	std::vector<Status> done(values.size(), Nothing{});
	tbb::parallel_for(std::size_t(0), values.size(),
	                  [&](std::size_t i)
	                  {
		                  if (auto grown = contourer.grow(values[i], timeline))
			                  contours[i] = std::move(*grown);
		                  else
			                  done[i] = grown.error();
	                  });
	for (const Status& each : done)
		if (!each)
			return each.error();
	return contours;
}

void tellEmpty(const Session& session, const cut::Cut& slice, std::size_t s, double value,
               const contour::BoxContourer& contourer)
{
	if (!contourer.range())
		return; // it shows nothing, which has been told
	const std::string where = slice.sheets.size() == 1 ? std::string("the sheet") : fmt::format("sheet {}", s);
	warn("`contour` {} is empty: {} has {} from {:.6g} to {:.6g} within its box; give a value between", value, where,
	     slice.sheets[s].field->title(session.blocks), contourer.range()->first, contourer.range()->second);
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
		const contour::BoxContourer contourer(*session.cutter, slice.sheets[s], sheets[s].mesh,
		                                      spec.depth > 0.0 ? std::optional(spec.depth) : std::nullopt);
		std::vector<double> values = spec.values;
		if (is_placed)
		{
			Result<double> value = valueAt(contourer, slice.sheets[s], sheets[s].mesh, *spec.at);
			if (!value && tell == Tell::all)
				return value.error();
			if (value)
				values.push_back(*value);
		}
		if (is_pointed)
			values.push_back(pointed->value);
		Result<std::vector<contour::Contour>> grown = growAll(contourer, values, session.timeline.get());
		if (!grown)
			return grown.error();
		contours[s] = std::move(*grown);
		for (const contour::Contour& contour : contours[s])
			if (contour.mesh.polygons() == 0 && tell == Tell::all)
				tellEmpty(session, slice, s, contour.value, contourer);
	}
	return contours;
}

std::vector<write::ContourPiece> contourPieces(const Contours& contours)
{
	std::vector<write::ContourPiece> pieces;
	for (std::size_t s = 0; s < contours.size(); ++s)
		for (const contour::Contour& contour : contours[s])
			pieces.push_back({&contour.mesh, static_cast<std::int32_t>(s), contour.value});
	return pieces;
}

} // namespace vp::session
