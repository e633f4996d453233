#include "pack_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vp::reader::convert
{

namespace
{

constexpr std::uint32_t kValuesOfPage = 1024; // each has four bytes
constexpr double kMuch = 0.8;
constexpr std::size_t kFewCells = 1 << 18; // their values are read in no time, in whatever order

using Vector = std::array<double, 3>;

// The range of the distances of a box's corners from the plane through `middle`.
bool meets(const PackBox& box, const Vector& middle, const Vector& normal)
{
	double lo = 0.0, hi = 0.0;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		const double a = (box.lo[axis] - middle[axis]) * normal[axis], b = (box.hi[axis] - middle[axis]) * normal[axis];
		lo += std::min(a, b);
		hi += std::max(a, b);
	}
	return lo <= 0.0 && hi >= 0.0; // never for cells that nobody sees
}

class Pages
{
public:
	explicit Pages(std::size_t values) : is_met_(values / kValuesOfPage + 1) {}
	void meet(std::uint32_t value) { is_met_[value / kValuesOfPage] = true; }
	std::size_t met() const { return static_cast<std::size_t>(std::ranges::count(is_met_, true)); }
	std::size_t all() const { return is_met_.size(); }

private:
	std::vector<bool> is_met_;
};

double shareOfPages(const PackDivision& division)
{
	constexpr std::array<Vector, 3> normals = {{{0.3, 0.5, 0.8}, {0.8, -0.3, 0.5}, {-0.5, 0.8, 0.3}}};
	PackBox bounds;
	std::uint32_t points = 0;
	for (std::size_t part = 0; part < division.parts(); ++part)
	{
		for (const PackRun& run : division.runs(part))
			if (run.box.lo[0] <= run.box.hi[0])
			{
				bounds.include(run.box.lo);
				bounds.include(run.box.hi);
			}
		if (!division.points(part).empty())
			points = std::max(points, division.points(part).back() + 1);
	}
	Vector middle;
	for (std::size_t axis = 0; axis < 3; ++axis)
		middle[axis] = (bounds.lo[axis] + bounds.hi[axis]) / 2.0;
	std::size_t met = 0, all = 0;
	for (const Vector& normal : normals)
	{
		Pages of_points(points), of_cells(division.types().size());
		for (std::size_t part = 0; part < division.parts(); ++part)
		{
			bool is_met = false;
			for (std::size_t r = 0; r < division.runs(part).size(); ++r)
			{
				if (!meets(division.runs(part)[r].box, middle, normal))
					continue;
				is_met = true;
				const std::size_t first = r * division.cellsOfRun();
				const auto cells = division.cells(part).subspan(first);
				for (const std::uint32_t cell : cells.first(std::min(division.cellsOfRun(), cells.size())))
					of_cells.meet(cell);
			}
			for (std::size_t p = 0; is_met && p < division.points(part).size(); ++p)
				of_points.meet(division.points(part)[p]);
		}
		met += of_points.met() + of_cells.met();
		all += of_points.all() + of_cells.all();
	}
	return static_cast<double>(met) / static_cast<double>(all);
}

} // namespace

std::vector<std::string> linesAboutOrder(const PackDivision& division)
{
	const double share = division.types().size() < kFewCells ? 0.0 : shareOfPages(division);
	if (share <= kMuch)
		return {};
	return {
	    fmt::format("its values lie in such an order that a plane needs {:.0f} % of their pages; vprobe pack brings "
	                "them into a better one",
	                100.0 * share)};
}

} // namespace vp::reader::convert
