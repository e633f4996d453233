#include "seed/hot_spots.h"

#include "base/parallel_for.h"
#include "seed/sheet_walk.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vp::seed
{

namespace
{

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr std::size_t kStretch = 16; // cells of a line whose mean breadth decides whether lines are too far apart

template <grid::Grid G>
class Lattice
{
public:
	Lattice(const G& grid, const probe::Sheet& sheet, std::span<const CutFace> rim)
	    : grid_(grid), plane_(sheet.plane()), axes_{sheet.origin, {sheet.xAxis(), sheet.up}}, rim_(rim),
	      in_window_(sheet.window.has_value())
	{
		if (sheet.window)
		{
			u_ = {sheet.window->x0, sheet.window->x1};
			v_ = {sheet.window->y0, sheet.window->y1};
		}
	}

	HotSpots spread(std::span<const CellId> seeds)
	{
		Line spine;
		if (in_window_ && !seeds.empty())
			spine = walkSpine(seeds.front());
		shrinkToCut(spine);
		// The rim of a square of n x n cells has 4 n cells.
		const double high = std::max(0.25 * static_cast<double>(rim_.size()), static_cast<double>(spine.size()));
		const auto enough = static_cast<std::size_t>(std::lround(high / (2.0 * kLatticeCells)));
		if (v_.length() <= 0.0)
			return {};
		const std::size_t lines = in_window_ ? std::max<std::size_t>(enough, 1) : enough; // it may be long and low
		const double apart = v_.length() / static_cast<double>(lines);
		std::vector<Lines> first(lines + 2); // nothing below the lowest and above the highest
		tracedFor(std::size_t(1), lines + 1, [&](std::size_t l) { first[l] = wholeLine(heightOf(l, apart), spine); });
		std::vector<HotSpots> strips(lines + 1);
		const auto refineStrip = [&](std::size_t l)
		{
			const double lo = l == 0 ? v_.lo : heightOf(l, apart);
			const double hi = l == lines ? v_.hi : heightOf(l + 1, apart);
			refine({lo, hi}, first[l], first[l + 1], strips[l]);
		};
		if (lines > 0)
			tracedFor(std::size_t(0), lines + 1, refineStrip);
		HotSpots all;
		add(spine, all);
		for (const Lines& of_height : first)
			for (const Line& line : of_height)
				add(line, all);
		for (const HotSpots& strip : strips)
		{
			all.cells.insert(all.cells.end(), strip.cells.begin(), strip.cells.end());
			all.hops += strip.hops;
		}
		return all;
	}

private:
	using Line = std::vector<PassedCell>; // ascending, without a gap
	using Lines = std::vector<Line>;      // at one height
	using Stretch = std::span<const PassedCell>;

	double heightOf(std::size_t line, double apart) const { return v_.lo + (static_cast<double>(line) - 0.5) * apart; }

	static void add(std::span<const PassedCell> line, HotSpots& spots)
	{
		for (const PassedCell& passed : line)
			spots.cells.push_back(passed.cell);
		spots.hops += line.empty() ? 0 : line.size() - 1;
	}

	void walkAlong(CellId cell, const SheetLine& line, double end, Line& passed) const
	{
		walk(grid_, plane_, axes_, cell, line, end, passed);
	}

	// From side to side through a cell.
	Line walkBoth(CellId cell, int axis, double at, const Range& within) const
	{
		Line line;
		walkAlong(cell, {axis, at, -1}, within.lo, line);
		std::ranges::reverse(line);
		if (!line.empty())
			line.pop_back(); // the first cell comes again
		walkAlong(cell, {axis, at, 1}, within.hi, line);
		return line;
	}

	// Across all lines, through the first seed.
	Line walkSpine(CellId seed) const
	{
		const Section section = sectionOf(grid_, plane_, axes_, seed);
		if (section.corners == 0)
			return {};
		const Range shared = section.range(0).within(u_);
		if (shared.length() < 0.0)
			return {};
		return walkBoth(seed, 1, shared.middle(), v_);
	}

	// The heights between which anything is known to be cut.
	void shrinkToCut(const Line& spine)
	{
		Range cut;
		for (const CutFace& face : rim_)
			for (const Vec3& end : {face.from, face.to})
				cut.include(axes_.uvOf(end).y);
		for (const PassedCell& passed : spine)
		{
			cut.include(passed.from);
			cut.include(passed.to);
		}
		v_ = v_.within(cut);
	}

	// All parts of a line: each begins at the rim or crosses the spine.
	Lines wholeLine(double v, const Line& spine) const
	{
		std::vector<std::pair<double, CellId>> starts;
		for (const CutFace& face : rim_)
		{
			const glm::dvec2 from = axes_.uvOf(face.from);
			const glm::dvec2 to = axes_.uvOf(face.to);
			if ((from.y >= v) != (to.y >= v))
				starts.emplace_back(from.x + (v - from.y) / (to.y - from.y) * (to.x - from.x), face.cell);
		}
		std::ranges::sort(starts);
		Lines lines;
		double covered = -kFar;
		for (const auto& [u, cell] : starts)
		{
			const bool is_end = !lines.empty() && lines.back().back().cell == cell; // u may differ by rounding
			if (u < covered || u > u_.hi || is_end)
				continue;
			// Backwards too: to the left of it the piece may go on to a window's side.
			Line line = walkBoth(cell, 0, v, in_window_ ? u_ : Range{u, kFar});
			if (line.empty())
				continue;
			covered = line.back().to;
			lines.push_back(std::move(line));
		}
		const auto crosses = [&](const PassedCell& passed) { return passed.from <= v && v <= passed.to; };
		if (const auto at = std::ranges::find_if(spine, crosses); at != spine.end())
		{
			const auto holds = [&](const PassedCell& passed) { return passed.cell == at->cell; };
			const auto passes = [&](const Line& line) { return std::ranges::any_of(line, holds); };
			if (std::ranges::none_of(lines, passes))
				lines.push_back(walkBoth(at->cell, 0, v, u_));
		}
		return lines;
	}

	// Adds lines between two heights if cells are small there: one halfway, and then more on both sides of it. There is
	// no line along a window's edge or along the rim.
	template <class Below, class Above>
	void refine(const Range& heights, const Below& below, const Above& above, HotSpots& spots) const
	{
		const bool at_edge = in_window_ && (below.empty() || above.empty()); // there is no line on the other side
		const double breadth = heights.length() / (at_edge ? 0.5 * kLatticeCells : kLatticeCells);
		const std::vector<Stretch> narrow_below = narrowStretches(below, breadth);
		const std::vector<Stretch> narrow_above = narrowStretches(above, breadth);
		const double middle = heights.middle();
		Lines between;
		for (const Stretch& stretch : narrow_below)
			addLines(stretch, heights.lo, middle, between, spots);
		for (const Stretch& stretch : narrow_above)
			addLines(stretch, heights.hi, middle, between, spots);
		if (between.empty())
			return;
		refine({heights.lo, middle}, narrow_below, between, spots);
		refine({middle, heights.hi}, between, narrow_above, spots);
	}

	// The parts of lines whose cells are narrower than that in the mean.
	template <class Parts>
	static std::vector<Stretch> narrowStretches(const Parts& lines, double breadth)
	{
		std::vector<Stretch> narrow;
		for (const Stretch line : lines)
		{
			std::size_t first = line.size(); // first cell of the current run of narrow cells
			for (std::size_t begin = 0; begin < line.size(); begin += kStretch)
			{
				const Stretch part = line.subspan(begin, std::min(kStretch, line.size() - begin));
				double sum = 0.0;
				for (const PassedCell& passed : part)
					sum += passed.breadth;
				const bool is_narrow = sum < breadth * static_cast<double>(part.size());
				if (is_narrow)
					first = std::min(first, begin);
				if (first < line.size() && (!is_narrow || begin + kStretch >= line.size()))
				{
					narrow.push_back(line.subspan(first, (is_narrow ? line.size() : begin) - first));
					first = line.size();
				}
			}
		}
		return narrow;
	}

	// The line at another height beside a stretch, where it is not there yet. It begins anew behind a gap of the
	// domain, whose rim seeds too.
	void addLines(const Stretch& stretch, double height, double other, Lines& lines, HotSpots& spots) const
	{
		for (std::size_t i = 0; i < stretch.size();)
		{
			double reached = coveredFrom(stretch[i], lines);
			if (reached == -kFar)
			{
				Line line = lineBeside(stretch.subspan(i), height, other, spots);
				add(line, spots);
				if (!line.empty())
				{
					reached = line.back().to;
					lines.push_back(std::move(line));
				}
			}
			i += reached == -kFar ? kStretch : 1;
			while (i < stretch.size() && stretch[i].from < reached)
				++i;
		}
	}

	// Returns how far a line beside the cell reaches, or -kFar if there is no such line.
	static double coveredFrom(const PassedCell& beside, const Lines& lines)
	{
		for (const Line& line : lines)
			if (line.front().from <= beside.to && beside.from < line.back().to)
				return line.back().to;
		return -kFar;
	}

	// Over to another height from the first of some cells, and along it as far as they reach.
	Line lineBeside(const Stretch& stretch, double height, double other, HotSpots& spots) const
	{
		const double u = 0.5 * (stretch.front().from + stretch.front().to);
		const int sense = other > height ? 1 : -1;
		Line across;
		walkAlong(stretch.front().cell, {1, u, sense}, other, across);
		add(across, spots);
		Line between;
		if (!across.empty() && across.back().from <= other && other <= across.back().to)
			walkAlong(across.back().cell, {0, other, 1}, stretch.back().to, between);
		return between;
	}

	const G& grid_;
	surface::Plane plane_;
	SheetAxes axes_;
	std::span<const CutFace> rim_;
	bool in_window_;
	Range u_{-kFar, kFar}; // range of the lattice
	Range v_{-kFar, kFar};
};

} // namespace

HotSpots spreadHotSpots(const grid::Block& block, const probe::Sheet& sheet, std::span<const CutFace> rim,
                        std::span<const CellId> seeds)
{
	return std::visit([&](const auto& grid) { return Lattice(grid, sheet, rim).spread(seeds); }, block.grid);
}

} // namespace vp::seed
