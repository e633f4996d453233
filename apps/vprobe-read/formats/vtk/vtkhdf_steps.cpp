#include "vtkhdf_steps.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <numeric>

namespace vp::reader::vtk
{

namespace
{

constexpr std::uint64_t kMaxStepsOfVtkHdf = 1 << 20;
// Sums of parts stay far from overflow.
constexpr std::int64_t kMaxCountOfVtkHdf = std::int64_t(1) << 40;

} // namespace

std::vector<double> VtkHdfStep::timesOf(const hdf5::File& file, const std::string& root)
{
	const std::string group = root + "/Steps";
	if (!file.has(group))
		return {};
	const double count = file.realOr(group, "NSteps", 0.0);
	const std::vector<double> values = file.reals(group + "/Values");
	if (!(count >= 1.0) || count > kMaxStepsOfVtkHdf || values.size() < static_cast<std::size_t>(count))
		throw damaged("its Steps do not match their Values");
	return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count)};
}

std::optional<std::uint64_t> VtkHdfStep::entry(const std::string& list) const
{
	const std::string path = root_ + "/Steps/" + list;
	if (!step_ || !file_->isSet(path))
		return std::nullopt;
	const std::int64_t number = file_->integersFrom(path, *step_, 1)[0];
	if (number < 0 || number > kMaxCountOfVtkHdf)
		throw damaged(fmt::format("{} has the entry {}", path, number));
	return static_cast<std::uint64_t>(number);
}

std::vector<std::uint64_t> vtkHdfCounts(const hdf5::File& file, const std::string& list, std::uint64_t first,
                                        std::uint64_t count)
{
	const std::vector<std::int64_t> numbers = file.integersFrom(list, first, count);
	std::int64_t sum = 0;
	for (const std::int64_t number : numbers)
		if (number < 0 || number > kMaxCountOfVtkHdf || (sum += number) > kMaxCountOfVtkHdf)
			throw damaged(fmt::format("{} has more than there can be", list));
	return {numbers.begin(), numbers.end()};
}

std::uint64_t vtkHdfSum(const std::vector<std::uint64_t>& counts, std::size_t end)
{
	return std::accumulate(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(end), std::uint64_t(0));
}

VtkHdfParts::VtkHdfParts(const hdf5::File& file, const VtkHdfStep& step)
{
	const auto counts = [&](const char* list, std::uint64_t begin, std::uint64_t parts)
	{ return vtkHdfCounts(file, step.root() + "/" + list, begin, parts); };
	const std::vector<std::uint64_t> sides = file.sidesOf(step.root() + "/NumberOfPoints");
	const std::uint64_t all = sides.empty() ? 0 : sides[0];
	std::uint64_t count = all;
	if (step.isOneOfSeveral())
	{
		const std::optional<std::uint64_t> given = step.entry("NumberOfParts");
		const std::uint64_t steps = VtkHdfStep::timesOf(file, step.root()).size();
		// Either each time has as many parts as the others, or all have the same parts.
		count = given ? *given : all % steps == 0 ? all / steps : all;
		first = step.entry("PartOffsets").value_or(given || count == all ? 0 : step.number() * count);
	}
	if (first > all || count > all - first)
		throw damaged("its Steps name parts that are not there");
	points = counts("NumberOfPoints", first, count);
	cells = counts("NumberOfCells", first, count);
	ids = counts("NumberOfConnectivityIds", first, count);
	all_points = vtkHdfSum(points, count);
	all_cells = vtkHdfSum(cells, count);
	all_ids = vtkHdfSum(ids, count);
	const auto before = [&](const char* offset, const char* list)
	{
		const std::optional<std::uint64_t> given = step.entry(offset);
		return given ? *given : vtkHdfSum(counts(list, 0, first), first);
	};
	first_point = before("PointOffsets", "NumberOfPoints");
	first_cell = before("CellOffsets", "NumberOfCells");
	first_id = before("ConnectivityIdOffsets", "NumberOfConnectivityIds");
}

} // namespace vp::reader::vtk
