#include "pack_index.h"

#include "read/cell_types.h"
#include "read/run_ranges.h"
#include "read/source_stamp.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

namespace vp::reader::vtk
{

using grid::NumberType;
using nlohmann::json;

namespace
{

constexpr std::string_view kOwnList = "own/";

std::uint64_t checkedCount(double count, const char* name)
{
	if (!(count >= 0.0 && count < static_cast<double>(std::uint64_t(1) << 40)))
		throw damaged(fmt::format("its {} is missing or cannot be", name));
	return static_cast<std::uint64_t>(count);
}

} // namespace

bool isVtkHdfPack(const hdf5::File& file, const VtkHdfPack& pack)
{
	return file.has(pack.own) && file.has(pack.own + "/Boxes");
}

PackIndex::PackIndex(const hdf5::File& file, const VtkHdfPack& pack, const WantsVtkHdfArray& wants)
    : file_(file), root_(pack.root), own_(pack.own), steps_(pack.steps), time_(pack.chosen),
      descriptor_(open(file.name().c_str(), O_RDONLY | O_CLOEXEC)),
      partitions_(file,
                  VtkHdfStep(file, root_, file.has(root_ + "/Steps") ? std::optional<std::uint64_t>(0) : std::nullopt)),
      all_points_(countOf("NumberOfPoints")), all_cells_(countOf("NumberOfCells"))
{
	if (descriptor_ < 0)
		throw Refusal("it cannot be opened; check its permissions");
	if (const double version = file.realOr(own_, "Version", 1.0); version >= 4.0)
		throw Refusal(
		    fmt::format("a pack of version {}; install a newer vprobe, or pack it again with this one", version));
	listParts();
	const std::uint64_t lone_points = checkedCount(file_.realOr(own_, "PointsOfNoCell", 0.0), "PointsOfNoCell");
	if (all_points_ > parts_.all_points + lone_points || all_cells_ != parts_.all_cells)
		throw damaged("its parts do not make up the whole");
	refuseMovingGrid();
	listRuns();
	listFarthest();
	if (file_.isSet(own_ + "/Source"))
		source_ =
		    allRows<std::uint64_t>("Source", NumberType::uint64, sizeof(read::SourceStamp) / sizeof(std::uint64_t));
	for (const char* association : {"Point", "Cell"})
		listArrays(association, wants);
}

PackIndex::~PackIndex()
{
	close(descriptor_);
}

std::uint64_t PackIndex::countOf(const char* name) const
{
	return checkedCount(file_.realOr(own_, name, -1.0), name);
}

std::uint8_t PackIndex::typeOfAll() const
{
	const double told = file_.realOr(own_, "CellType", 0.0);
	const auto type = static_cast<std::uint8_t>(told > 0.0 && told < 256.0 ? told : 0.0);
	const auto size = static_cast<std::uint64_t>(read::slicedCellSize(type));
	const auto has_size = [size](const PackRun& run) { return run.ids == size * run.cells; };
	return size > 0 && std::ranges::all_of(runs_, has_size) ? type : 0;
}

NumberType PackIndex::typeOfPoints() const
{
	return file_.numberType(root_ + "/Points") == NumberType::float32 ? NumberType::float32 : NumberType::float64;
}

// All times have the same points and cells, since these are told once.
void PackIndex::refuseMovingGrid() const
{
	for (const char* list : {"PartOffsets", "NumberOfParts", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"})
	{
		const std::string path = root_ + "/Steps/" + list;
		if (!file_.isSet(path))
			continue;
		const bool is_count = list == std::string_view("NumberOfParts");
		const auto wanted = static_cast<std::int64_t>(is_count ? partitions_.count() : 0);
		const std::vector<std::int64_t> numbers = file_.integersFrom(path, 0, times());
		if (std::ranges::any_of(numbers, [wanted](std::int64_t number) { return number != wanted; }))
			throw damaged("its times have other parts than the whole");
	}
}

hdf5::Rows PackIndex::rowsOf(const PackedArray& array, std::size_t time) const
{
	hdf5::Rows rows(file_, descriptor_, root_ + "/" + array.association + "Data/" + array.in_file, array.type);
	rows.narrow(array.first_rows[time], array.association == "Point" ? parts_.all_points : parts_.all_cells);
	return rows;
}

std::optional<hdf5::Rows> PackIndex::rangesOf(const PackedArray& array, std::size_t time) const
{
	const std::string path = own_ + "/" + array.association + "Data/" + array.in_file + "/RunRanges";
	if (array.association != "Point" || !file_.has(path))
		return std::nullopt;
	hdf5::Rows rows(file_, descriptor_, path, NumberType::float32);
	if (rows.components() != 2 * read::columnsOfRanges(static_cast<int>(array.components)) ||
	    rows.size() != runs_.size() * times())
		throw damaged(fmt::format("{} does not match its array", path));
	rows.narrow(steps_[time] * runs_.size(), runs_.size());
	return rows;
}

hdf5::Rows PackIndex::rowsOf(const std::string& list, NumberType type, std::uint64_t count,
                             std::uint64_t components) const
{
	const std::string path =
	    list.starts_with(kOwnList) ? own_ + "/" + list.substr(kOwnList.size()) : root_ + "/" + list;
	hdf5::Rows rows(file_, descriptor_, path, type);
	if (rows.components() != components)
		throw damaged(fmt::format("the rows of {} have {} numbers", path, rows.components()));
	if (rows.size() != count)
		throw damaged(fmt::format("{} has {} rows where {} belong", path, rows.size(), count));
	return rows;
}

template <class Row>
std::vector<Row> PackIndex::allRows(const std::string& name, NumberType type, std::uint64_t size) const
{
	const hdf5::Rows rows(file_, descriptor_, own_ + "/" + name, type);
	if (rows.size() != size || rows.rowBytes() != sizeof(Row))
		throw damaged(fmt::format("its {} do not match its cells", name));
	std::vector<Row> values(size);
	rows.read(0, size, values.data());
	return values;
}

// Parts follow each other in the partitions of VTKHDF. Where the file does not list them, each partition is one.
void PackIndex::listParts()
{
	parts_.all_points = partitions_.all_points;
	parts_.all_cells = partitions_.all_cells;
	parts_.all_ids = partitions_.all_ids;
	parts_.all_ends = partitions_.all_cells + partitions_.count(); // a partition has one more than cells
	parts_.points = partitions_.points;
	parts_.cells = partitions_.cells;
	if (const std::string list = own_ + "/PartPoints"; file_.isSet(list))
	{
		const std::vector<std::uint64_t> sides = file_.sidesOf(list);
		const std::uint64_t count = sides.empty() ? 0 : sides[0];
		parts_.points = vtkHdfCounts(file_, list, 0, count);
		parts_.cells = vtkHdfCounts(file_, own_ + "/PartCells", 0, count);
	}
	std::uint64_t points = 0, cells = 0; // before the part, in its partition
	std::size_t partition = 0;
	std::uint64_t first_cell = 0;
	for (std::size_t part = 0; part < parts_.count() && partition < partitions_.count(); ++part)
	{
		parts_.first_ids.push_back(points);
		parts_.first_cells.push_back(first_cell);
		parts_.first_ends.push_back(first_cell + partition);
		points += parts_.points[part];
		cells += parts_.cells[part];
		first_cell += parts_.cells[part];
		if (points != partitions_.points[partition] || cells != partitions_.cells[partition])
			continue;
		points = cells = 0;
		++partition;
	}
	if (partition < partitions_.count() || points + cells > 0 || parts_.first_ids.size() != parts_.count())
		throw damaged("its parts do not make up its partitions");
}

void PackIndex::listRuns()
{
	const std::uint64_t cells_of_run = countOf("CellsOfRun");
	if (cells_of_run == 0)
		throw damaged("its runs have no cells");
	std::uint64_t count = 0;
	for (const std::uint64_t cells : parts_.cells)
		count += (cells + cells_of_run - 1) / cells_of_run;
	const auto ids = allRows<std::uint32_t>("NumberOfConnectivityIds", NumberType::uint32, count);
	boxes_ = allRows<std::array<double, 6>>("Boxes", NumberType::float64, count);
	std::uint64_t first_cell = 0, first_id = 0, end_of_partition = 0;
	for (std::size_t part = 0; part < parts_.count(); ++part)
	{
		for (std::uint64_t left = parts_.cells[part]; left > 0;)
		{
			const std::uint64_t cells = std::min(left, cells_of_run);
			runs_.push_back({part, first_cell, cells, first_id, ids[runs_.size()]});
			left -= cells;
			first_cell += cells;
			first_id += runs_.back().ids;
		}
		const std::size_t partition = parts_.partitionOf(part);
		const bool is_last = part + 1 == parts_.count() || parts_.partitionOf(part + 1) != partition;
		if (is_last && first_id != (end_of_partition += partitions_.ids[partition]))
			throw damaged("the runs of a part do not make up the part");
	}
	if (runs_.empty())
		throw damaged("it has no cells");
}

void PackIndex::listFarthest()
{
	if (!file_.isSet(own_ + "/FarthestPoints"))
		return;
	const hdf5::Rows rows(file_, descriptor_, own_ + "/FarthestPoints", NumberType::float64);
	constexpr std::uint64_t most = 1 << 16;
	if (rows.components() != 3 || rows.size() > most)
		throw damaged("its farthest points cannot be");
	farthest_.resize(rows.size());
	rows.read(0, rows.size(), farthest_.data());
}

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

// As the manifest has them (protocol.h).
json PackIndex::facts(std::size_t runs_read, std::uint64_t bytes_read) const
{
	std::array<double, 6> bounds = boxes_[0];
	for (const std::array<double, 6>& box : boxes_)
		for (std::size_t axis = 0; axis < 3; ++axis)
		{
			bounds[axis] = std::min(bounds[axis], box[axis]);
			bounds[axis + 3] = std::max(bounds[axis + 3], box[axis + 3]);
		}
	json of_arrays = json::object();
	for (const PackedArray& array : arrays_)
		of_arrays[(array.association == "Point" ? "point:" : "cell:") + array.name] = array.facts[time_];
	const std::uint64_t flat = countOf("FlatCells"), hidden = countOf("HiddenCells"),
	                    unplaced = countOf("CellsWithoutPlace");
	if (flat + hidden + unplaced > all_cells_)
		throw damaged("it has more cells that are left out than cells");
	return {{"points", all_points_},
	        {"cells", all_cells_ - flat - hidden - unplaced},
	        {"flat_cells", flat},
	        {"hidden_cells", hidden},
	        {"cells_without_place", unplaced},
	        {"bounds", bounds},
	        {"parts", runs_.size()},
	        {"parts_read", runs_read},
	        {"bytes_read", bytes_read},
	        {"arrays", std::move(of_arrays)}};
}

} // namespace vp::reader::vtk
