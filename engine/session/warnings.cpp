#include "base/digits.h"
#include "base/messages.h"
#include "parts/part_store.h"
#include "session/session.h"
#include "session/sheet_stats.h"
#include "session/value_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
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
	if (session.view().field)
		if (const std::vector<bool> covered = blocksCoveredByOthers(session.blocks(), *session.view().field);
		    !covered.empty())
			warn(
			    "{} of {} blocks have no array {} and lie where another block has it, so pictures leave them out; name "
			    "another `array` to see them",
			    std::ranges::count(covered, true), covered.size(), session.view().field->name);
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

bool isMuch(const measure::Overlap& overlap)
{
	constexpr double kShare = 1e-3;
	return overlap.share >= kShare;
}

void reportOverlap(const Session& session, const cut::Cut& slice, const std::vector<SheetStats>& sheets)
{
	measure::Overlap worst;
	std::size_t where = 0;
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		const measure::Overlap overlap = sheets[s].overlap.value_or(overlapOf(session, slice, s, sheets[s]));
		if (!isMuch(overlap) || overlap.area <= worst.area)
			continue;
		worst = overlap;
		where = s;
	}
	if (isMuch(worst))
		warn("{} and {} overlap: an area of {:.4g} in {} counts twice; if they are no parts of one data set, name one "
		     "of "
		     "them, or say what they are by `inputs`",
		     session.inputs()[worst.inputs.first], session.inputs()[worst.inputs.second], worst.area,
		     sheetName(where, sheets.size()));
}

void reportRowsAcross(const Session& session)
{
	constexpr double kMuch = 0.25;
	constexpr std::uint64_t kLarge = 64 << 20; // less takes less than a tenth of a second
	for (const grid::Block& block : session.blocks().blocks)
		for (const grid::Field& field : block.fields)
		{
			if (!field.stored || field.stored->layout().is_padded)
				continue;
			const parts::PartUse use = field.stored->use();
			if (use.bytes_met < kLarge || static_cast<double>(use.met) < kMuch * static_cast<double>(use.all))
				continue;
			note("{} lies in rows, of which this cut reads {} of {}; `vprobe convert` to a .vtkhdf file makes bricks, "
			     "of which it reads a few percent",
			     field.name, use.met, use.all);
			return;
		}
}

} // namespace vp::session
