// How the arrays of a pack are listed (pack_index.h).
#include "pack_index.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <cstddef>
#include <span>

namespace vp::reader::vtk
{

using grid::NumberType;
using nlohmann::json;

void PackIndex::listArrays(const std::string& association, const WantsVtkHdfArray& wants)
{
	for (const std::string& in_file : namesOfArrays(association))
	{
		PackedArray array = arrayOf(association, in_file);
		!source_.empty() && file_.isSet(own_ + "/" + association + "Data/" + in_file + "/Places") ? takePlaces(array)
		                                                                                          : takeRows(array);
		if (wants(association, array.name, array.type, array.components))
		{
			array.facts = factsOf(association, in_file, array.components);
			arrays_.push_back(std::move(array));
		}
	}
}

std::vector<std::string> PackIndex::namesOfArrays(const std::string& association) const
{
	return file_.namesIn((source_.empty() ? root_ : own_) + "/" + association + "Data", hdf5::File::Order::creation);
}

PackedArray PackIndex::arrayOf(const std::string& association, const std::string& in_file) const
{
	const std::string own = own_ + "/" + association + "Data/" + in_file;
	std::string name = file_.textOr(own, "Name");
	if (name.empty())
		name = in_file;
	return {.association = association, .name = name, .in_file = in_file, .units = file_.textOr(own, "Units")};
}

void PackIndex::takeRows(PackedArray& array) const
{
	const std::string path = root_ + "/" + array.association + "Data/" + array.in_file;
	const auto type = file_.numberType(path);
	if (!type)
		throw damaged(fmt::format("the array {} holds no numbers", array.name));
	const hdf5::Rows rows(file_, descriptor_, path, *type);
	const std::uint64_t count = array.association == "Point" ? parts_.all_points : parts_.all_cells;
	if (rows.size() != count * times())
		throw damaged(fmt::format("the array {} has not a value for each {}", array.name, array.association));
	array.type = *type;
	array.components = rows.components();
	const std::string offsets = root_ + "/Steps/" + array.association + "DataOffsets/" + array.in_file;
	const std::vector<std::int64_t> first_rows =
	    file_.isSet(offsets) ? file_.integersFrom(offsets, 0, times()) : std::vector<std::int64_t>(times(), 0);
	for (const std::size_t step : steps_)
	{
		const auto first = static_cast<std::uint64_t>(first_rows[step]);
		if (first > rows.size() - count)
			throw damaged(fmt::format("{} leads out of its array", offsets));
		array.first_rows.push_back(first);
	}
}

void PackIndex::takePlaces(PackedArray& array) const
{
	const std::string group = array.association + "Data/" + array.in_file, own = own_ + "/" + group;
	array.components = checkedCount(file_.realOr(own, "NumberOfComponents", 0.0), "NumberOfComponents");
	const std::optional<NumberType> type = grid::parseNumberType(file_.textOr(own, "Type"));
	if (!type || array.components == 0)
		throw damaged(fmt::format("{} does not say what its values are", own));
	array.type = *type;
	array.swaps = file_.realOr(own, "Swaps", 0.0) != 0.0;
	const auto places = allRows<std::uint64_t>(group + "/Places", NumberType::uint64, times());
	for (const std::size_t step : steps_)
		array.places.push_back(places[step]);
}

// Returns the different values of an array of integers, for each step of the file. Empty if the file does not say them.
std::vector<PackedValues> PackIndex::valuesOf(const std::string& path) const
{
	if (!file_.isSet(path + "/Values"))
		return {};
	const std::vector<double> values = file_.reals(path + "/Values");
	std::vector<double> counts = {static_cast<double>(values.size())}, changes = file_.realsOr(path, "Changes");
	if (file_.isSet(path + "/NumberOfValues"))
	{
		counts = file_.reals(path + "/NumberOfValues");
		changes = file_.reals(path + "/Changes");
	}
	if (counts.size() != times() || changes.size() != 2 * times())
		throw damaged(fmt::format("{} does not match its times", path));
	std::vector<PackedValues> of_steps;
	std::size_t first = 0;
	for (std::size_t step = 0; step < times(); ++step)
	{
		const std::uint64_t count = checkedCount(counts[step], "NumberOfValues");
		if (count > values.size() - first)
			throw damaged(fmt::format("{} has fewer Values than it says", path));
		const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
		of_steps.push_back({{begin, begin + static_cast<std::ptrdiff_t>(count)},
		                    checkedCount(changes[2 * step], "Changes"),
		                    checkedCount(changes[2 * step + 1], "Changes")});
		first += count;
	}
	return of_steps;
}

// Returns the file's facts about all values of an array at each time, as protocol.h has them.
std::vector<json> PackIndex::factsOf(const std::string& association, const std::string& name,
                                     std::uint64_t components) const
{
	const std::string path = own_ + "/" + association + "Data/" + name;
	const hdf5::Rows rows(file_, descriptor_, path + "/Spans", NumberType::float64);
	if (rows.components() != 4 || rows.size() != (components + 1) * times())
		throw damaged(fmt::format("{} does not match its array", path));
	std::vector<std::array<double, 4>> ends(rows.size());
	rows.read(0, rows.size(), ends.data());
	std::vector<double> least;
	if (file_.isSet(path + "/LeastPositive"))
		least = file_.reals(path + "/LeastPositive");
	if (!least.empty() && least.size() != ends.size())
		throw damaged(fmt::format("{} does not match its array", path));
	const std::vector<PackedValues> values = valuesOf(path);
	std::vector<json> of_times;
	for (const std::size_t step : steps_)
	{
		json facts = {{"tuples", association == "Point" ? all_points_ : all_cells_},
		              {"spans", json::array()},
		              {"values", json::array()},
		              {"changes", {0u, 0u}}};
		for (const auto& [lo, hi, minus, plus] : std::span(ends).subspan(step * (components + 1), components + 1))
		{
			const bool is_empty = !(lo <= hi);
			facts["spans"].push_back(
			    {is_empty ? json() : json(lo), is_empty ? json() : json(hi), minus > 0.0, plus > 0.0});
		}
		if (!least.empty())
			facts["least_positive"] = std::span(least).subspan(step * (components + 1), components + 1);
		if (!values.empty())
		{
			facts["values"] = values[step].values;
			facts["changes"] = {values[step].changes, values[step].changes_to_next};
		}
		of_times.push_back(std::move(facts));
	}
	return of_times;
}

} // namespace vp::reader::vtk
