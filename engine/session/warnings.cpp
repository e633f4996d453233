#include "base/digits.h"
#include "base/messages.h"
#include "session/session.h"
#include "session/sheet_stats.h"
#include "session/value_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace vp::session
{

namespace
{

std::string sheetName(std::size_t sheet, std::size_t sheets)
{
	return sheets == 1 ? std::string("the slice") : fmt::format("sheet {}", sheet);
}

} // namespace

bool isEmpty(const cut::SheetCut& sheet)
{
	for (const find::BlockCut& cut : sheet.cuts)
		if (cut.cutCells() > 0)
			return false;
	return std::ranges::all_of(sheet.seeds.faces_in_plane, [](const auto& faces) { return faces.empty(); });
}

Status reportWarnings(const Session& session, const cut::Cut& slice)
{
	for (const std::string& words : slice.warnings)
		warn("{}", words);
	for (const cut::SheetCut& sheet : slice.sheets)
	{
		const Vec3 at = sheet.sheet.origin;
		const bool outside =
		    sheet.isPlane() && session.view().seeds.mode != seed::SeedMode::boundary && !sheet.seeds.hot_spot_inside;
		if (outside && session.view().seeds.outside == seed::OutsidePolicy::refuse)
			return Error{ErrorKind::usage,
			             fmt::format("`origin` {} {} {}: the hot spot lies outside the grid; choose one inside, or "
			                         "`outside` nearest",
			                         at.x, at.y, at.z)};
		if (outside && session.view().seeds.outside == seed::OutsidePolicy::report)
			warn("`origin` {} {} {}: the hot spot lies outside the grid", at.x, at.y, at.z);
		else if (outside && session.view().seeds.mode == seed::SeedMode::hotspot && sheet.seeds.moved_to)
			warn("`origin` {} {} {}: the hot spot lies outside the grid; {} {} {} takes its place", at.x, at.y, at.z,
			     sheet.seeds.moved_to->x, sheet.seeds.moved_to->y, sheet.seeds.moved_to->z);
		if (session.ranks().any(!isEmpty(sheet)))
			continue;
		const Box bounds =
		    session.ranks().sum(session.blocks().bounds(), [](Box& all, const Box& other) { all.include(other); });
		const std::string what = sheetName(static_cast<std::size_t>(&sheet - slice.sheets.data()), slice.sheets.size());
		if (session.view().threshold)
			warn("{} is empty: no cell that is reached has values between {} and {}; widen `threshold`", what,
			     session.view().threshold->lo, session.view().threshold->hi);
		else if (sheet.surface)
			warn("{} is empty: {} shows no cells, or hidden ones only", what, find::nameOf(*sheet.surface));
		else if (sheet.sheet.form && sheet.sheet.form->isoValue())
		{
			const auto [lo, hi] = spanOf(session, *sheet.field).range();
			const int digits = digitsForRange(lo, hi);
			warn("{} is empty: no edge that is reached passes {}; the values of {} go from {:.{}g} to {:.{}g}", what,
			     sheet.sheet.form->isoValue()->value, sheet.field->title(session.blocks()), lo, digits, hi, digits);
		}
		else
		{
			const auto corner = [&](const Vec3& at)
			{
				std::string words;
				for (int axis = 0; axis < 3; ++axis)
					words += fmt::format("{}{:.{}g}", axis ? " " : "", at[axis],
					                     digitsForRange(bounds.lo[axis], bounds.hi[axis]));
				return words;
			};
			warn("{} is empty: the {} misses the grid; its bounds are {} to {}", what,
			     sheet.sheet.window ? "window"
			     : sheet.sheet.form ? "surface"
			                        : "plane",
			     corner(bounds.lo), corner(bounds.hi));
		}
	}
	return Nothing{};
}

void reportBoundarySheets(const Session& session, const std::vector<SheetStats>& sheets)
{
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		const mesh::SheetMesh& mesh = sheets[s].mesh;
		const bool has_boundary = session.ranks().any(mesh.boundary_polygons > 0);
		const bool has_cells = session.ranks().any(mesh.polygons() > mesh.boundary_polygons);
		if (has_boundary && !has_cells)
			warn("{} lies in the boundary of the grid and cuts no cell, so its area is 0; boundary_area, "
			     "boundary_mean and boundary_flux are its figures",
			     sheetName(s, sheets.size()));
	}
}

} // namespace vp::session
