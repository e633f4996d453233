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
	if (const double version = file.realOr(own_, "Version", 1.0); version >= 5.0)
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

std::uint64_t checkedCount(double count, const char* name)
{
	if (!(count >= 0.0 && count < static_cast<double>(std::uint64_t(1) << 40)))
		throw damaged(fmt::format("its {} is missing or cannot be", name));
	return static_cast<std::uint64_t>(count);
}

std::uint64_t PackIndex::countOf(const char* name) const
{
	return checkedCount(file_.realOr(own_, name, -1.0), name);
}

bool PackIndex::hasPolyhedra() const
{
	return file_.isSet(own_ + "/NumberOfFaces");
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
	for (const char* list : {"PartOffsets", "NumberOfParts", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets",
	                         "FaceConnectivityOffsets", "FaceOffsetsOffsets", "PolyhedronToFaceIdOffsets"})
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
	const auto countsOf = [this, count](const char* list)
	{ return allRows<std::uint32_t>(list, NumberType::uint32, count); };
	const std::vector<std::uint32_t> none(count, 0), ids = countsOf("NumberOfConnectivityIds");
	const std::vector<std::uint32_t> faces = hasPolyhedra() ? countsOf("NumberOfFaces") : none;
	const std::vector<std::uint32_t> face_ids = hasPolyhedra() ? countsOf("NumberOfFaceConnectivityIds") : none;
	boxes_ = allRows<std::array<double, 6>>("Boxes", NumberType::float64, count);
	PackRun next{};
	std::uint64_t end_of_partition = 0;
	for (std::size_t part = 0; part < parts_.count(); ++part)
	{
		for (std::uint64_t left = parts_.cells[part]; left > 0;)
		{
			next.part = part;
			next.cells = std::min(left, cells_of_run);
			next.ids = ids[runs_.size()];
			next.faces = faces[runs_.size()];
			next.face_ids = face_ids[runs_.size()];
			runs_.push_back(next);
			left -= next.cells;
			next.first_cell += next.cells;
			next.first_id += next.ids;
			next.first_face += next.faces;
			next.first_face_id += next.face_ids;
		}
		const std::size_t partition = parts_.partitionOf(part);
		const bool is_last = part + 1 == parts_.count() || parts_.partitionOf(part + 1) != partition;
		if (is_last && next.first_id != (end_of_partition += partitions_.ids[partition]))
			throw damaged("the runs of a part do not make up the part");
	}
	parts_.all_faces = next.first_face;
	parts_.all_face_ids = next.first_face_id;
	parts_.all_face_ends = next.first_face + partitions_.count();
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

json PackIndex::facts(std::uint64_t bytes_read) const
{
	json facts = factsOf(boxes_);
	facts["parts_read"] = runs_.size();
	facts["bytes_read"] = bytes_read;
	return facts;
}

json PackIndex::factsOfRuns(std::size_t begin, std::size_t end) const
{
	json facts = factsOf(std::span(boxes_).subspan(begin, end - begin));
	if (begin > 0)
		facts["flat_cells"] = facts["hidden_cells"] = facts["cells_without_place"] = 0u;
	return facts;
}

// As the manifest has them (protocol.h). boxes: those whose ends are the bounds.
json PackIndex::factsOf(std::span<const std::array<double, 6>> boxes) const
{
	std::array<double, 6> bounds = boxes[0];
	for (const std::array<double, 6>& box : boxes)
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
	        {"parts", boxes.size()},
	        {"parts_read", 0u},
	        {"bytes_read", 0u},
	        {"arrays", std::move(of_arrays)}};
}

} // namespace vp::reader::vtk
