// After the source of Enzo, Grid_WriteHierarchyInformation.C: lines "NAME = VALUES", a group of them for each grid.
#include "enzo_hierarchy.h"

#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

namespace vp::reader::codes
{

namespace
{

// Halving so many times is finer than an index of cells can tell.
constexpr std::size_t kMaxEnzoLevels = 30;

struct EnzoLine
{
	std::string_view name;
	std::string_view values;
};

std::string_view withoutSpace(std::string_view text)
{
	const auto first = text.find_first_not_of(" \t\r");
	return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

std::optional<EnzoLine> nextEnzoLine(text::Cursor& at)
{
	while (!at.atEnd())
	{
		const std::string_view line = at.line();
		if (const auto equals = line.find('='); equals != line.npos)
			return EnzoLine{withoutSpace(line.substr(0, equals)), withoutSpace(line.substr(equals + 1))};
	}
	return std::nullopt;
}

std::array<double, 3> threeNumbers(const EnzoLine& line)
{
	text::Cursor at(line.values);
	std::array<double, 3> numbers;
	for (double& number : numbers)
		if (number = at.real(); !std::isfinite(number))
			throw damaged(fmt::format("{} is no place", line.name));
	return numbers;
}

class EnzoParser
{
public:
	explicit EnzoParser(std::string_view text) : at_(text) {}

	EnzoHierarchy parse()
	{
		while (const std::optional<EnzoLine> line = nextEnzoLine(at_))
			if (line->name == "Grid")
			{
				finishGrid();
				hierarchy_.grids.push_back({static_cast<std::size_t>(number(*line)), {}, ""});
			}
			else if (!hierarchy_.grids.empty())
				read(*line);
		finishGrid();
		if (hierarchy_.grids.empty() || last_named_ > static_cast<std::int64_t>(hierarchy_.grids.size()))
			throw damaged(fmt::format("it lists {} grids and names grid {}", hierarchy_.grids.size(), last_named_));
		return std::move(hierarchy_);
	}

private:
	static std::int64_t number(const EnzoLine& line)
	{
		text::Cursor at(line.values);
		const std::int64_t value = at.integer();
		if (value < 0)
			throw damaged(fmt::format("{} is {}", line.name, value));
		return value;
	}

	void read(const EnzoLine& line)
	{
		EnzoGrid& grid = hierarchy_.grids.back();
		if (line.name == "GridRank" && number(line) != 3)
			throw Refusal(fmt::format("nothing to slice: grids of Enzo of {} dimensions", number(line)));
		if (line.name.starts_with("Pointer:")) // to the next grid of this level, or of the next
			last_named_ = std::max(last_named_, number(line));
		else if (line.name == "GridStartIndex")
			first_ = threeNumbers(line), ++found_;
		else if (line.name == "GridEndIndex")
			last_ = threeNumbers(line), ++found_;
		else if (line.name == "GridLeftEdge")
			grid.box.lo = threeNumbers(line), ++found_;
		else if (line.name == "GridRightEdge")
			grid.box.hi = threeNumbers(line), ++found_;
		else if (line.name == "BaryonFileName")
			grid.file = line.values;
		else if (line.name == "Time" && hierarchy_.grids.size() == 1)
			hierarchy_.time = text::Cursor(line.values).real();
	}

	void finishGrid()
	{
		if (hierarchy_.grids.empty())
			return;
		EnzoGrid& grid = hierarchy_.grids.back();
		if (found_ != 4 || grid.file.empty())
			throw damaged(fmt::format("grid {} has no place, size or file", grid.number));
		found_ = 0;
		for (std::size_t axis = 0; axis < 3; ++axis)
		{
			const double cells = last_[axis] - first_[axis] + 1.0;
			if (!(cells >= 1.0 && cells <= 65536.0))
				throw damaged(fmt::format("grid {} has {} cells along an axis", grid.number, cells));
			grid.box.cells[axis] = static_cast<std::size_t>(cells);
		}
		boxes::imageOfBox(grid.box); // which refuses what cannot be
	}

	text::Cursor at_;
	EnzoHierarchy hierarchy_{{}, std::numeric_limits<double>::quiet_NaN()};
	std::array<double, 3> first_{}, last_{};
	int found_ = 0;
	std::int64_t last_named_ = 0;
};

double spacingOf(const boxes::CellBox& box, std::size_t axis)
{
	return (box.hi[axis] - box.lo[axis]) / static_cast<double>(box.cells[axis]);
}

// Where a box begins among the cells of its size, counted from a corner.
int firstCell(const boxes::CellBox& box, std::size_t axis, double corner)
{
	const double place = (box.lo[axis] - corner) / spacingOf(box, axis);
	if (!(std::abs(place) < INT_MAX / 2) || std::abs(place - std::round(place)) > 0.01)
		throw damaged("a grid does not begin where cells of its level do");
	return static_cast<int>(std::lround(place));
}

} // namespace

EnzoHierarchy parseEnzoHierarchy(std::string_view text)
{
	return EnzoParser(text).parse();
}

boxes::AmrLevels enzoLevels(const EnzoHierarchy& hierarchy)
{
	std::vector<double> spacings; // the spacing of each level, along x
	for (const EnzoGrid& grid : hierarchy.grids)
		spacings.push_back(spacingOf(grid.box, 0));
	std::sort(spacings.rbegin(), spacings.rend());
	const auto isSame = [](double a, double b) { return std::abs(a - b) < 0.01 * a; };
	spacings.erase(std::unique(spacings.begin(), spacings.end(), isSame), spacings.end());
	if (spacings.size() > kMaxEnzoLevels)
		throw damaged(fmt::format("grids of {} levels", spacings.size()));

	boxes::AmrLevels levels;
	levels.boxes.resize(spacings.size());
	for (std::size_t level = 0; level + 1 < spacings.size(); ++level)
	{
		const double ratio = spacings[level] / spacings[level + 1];
		if (!(ratio < 1024.0) || std::abs(ratio - std::round(ratio)) > 0.01 * ratio)
			throw damaged(fmt::format("cells of a level are {} times as long as those of the next", ratio));
		levels.ratios.push_back(static_cast<int>(std::lround(ratio)));
	}
	std::array<double, 3> corner = hierarchy.grids[0].box.lo;
	for (const EnzoGrid& grid : hierarchy.grids)
		for (std::size_t axis = 0; axis < 3; ++axis)
			corner[axis] = std::min(corner[axis], grid.box.lo[axis]);
	for (std::size_t g = 0; g < hierarchy.grids.size(); ++g)
	{
		const EnzoGrid& grid = hierarchy.grids[g];
		const auto level = static_cast<std::size_t>(
		    std::ranges::find_if(spacings, [&](double spacing) { return isSame(spacing, spacingOf(grid.box, 0)); }) -
		    spacings.begin());
		boxes::AmrBox box = {{}, {}, grid.file, g};
		for (std::size_t axis = 0; axis < 3; ++axis)
		{
			box.lo[axis] = firstCell(grid.box, axis, corner[axis]);
			box.hi[axis] = box.lo[axis] + static_cast<int>(grid.box.cells[axis]) - 1;
		}
		levels.boxes.at(level).push_back(std::move(box));
	}
	return levels;
}

// "DataLabel[3] = Temperature" and "#DataCGSConversionFactor[3] = 1.5".
std::map<std::string, double> enzoFactors(const std::string& hierarchy)
{
	const std::string file = std::filesystem::path(hierarchy).replace_extension("").string();
	std::error_code ignored;
	if (!std::filesystem::is_regular_file(file, ignored))
		return {};
	const MappedText text(file);
	text::Cursor at(text.text());
	std::map<std::string, std::string> labels;
	std::map<std::string, double> by_index, factors;
	while (const std::optional<EnzoLine> line = nextEnzoLine(at))
	{
		const auto bracket = line->name.find('[');
		const std::string index(line->name.substr(std::min(bracket, line->name.size())));
		const std::string_view name = line->name.substr(0, bracket);
		if (name == "DataLabel")
			labels[index] = line->values;
		else if (name == "#DataCGSConversionFactor")
			if (const double factor = text::Cursor(line->values).real(); std::isfinite(factor) && factor != 0.0)
				by_index[index] = factor;
	}
	for (const auto& [index, label] : labels)
		if (by_index.contains(index))
			factors[label] = by_index[index];
	return factors;
}

} // namespace vp::reader::codes
