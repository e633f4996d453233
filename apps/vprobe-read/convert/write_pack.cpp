// An unstructured grid in parts that lie together in space: VTKHDF 1.0 in partitions, or 2.0 with several times, which
// VTK reads, or 2.5 with polyhedra, and beside it a group `vprobe` that other programs pass over. docs/FORMATS.md
// describes the group. An index is a pack without the values of arrays, which stay in the file that it is of.
#include "convert.h"
#include "hdf5_output.h"
#include "indexed_file.h"
#include "pack_columns.h"
#include "pack_division.h"
#include "pack_facts.h"
#include "pack_head.h"
#include "pack_order.h"
#include "pack_ranges.h"
#include "pack_steps.h"
#include "pack_times.h"
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/base/request.h"

#include "read/run_ranges.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace vp::reader::convert
{

namespace
{

Array<std::byte> bytesOf(vtkDataArray& values)
{
	const auto size =
	    static_cast<std::size_t>(values.GetNumberOfValues()) * static_cast<std::size_t>(values.GetDataTypeSize());
	return {nullptr, static_cast<const std::byte*>(values.GetVoidPointer(0)), size};
}

class PackWriter
{
public:
	// root: the group of the data set. own: the one beside it. indexed: the file that keeps the values, or null.
	PackWriter(vtkUnstructuredGrid* grid, const TimesToPack& times, std::size_t most_cells, int threads, Handle root,
	           Handle own, const IndexedFile* indexed)
	    : grid_(grid), places_(grid->GetPoints()->GetData()), root_(std::move(root)), own_(std::move(own)),
	      indexed_(indexed), times_(grid, times), division_(grid, most_cells, threads), partitions_(division_)
	{
	}

	// Writes all but the values of arrays.
	void writeGrid()
	{
		writePackHead(grid_, division_, partitions_, root_, own_);
		if (times_.times().size() == 1)
			writeAttribute(own_, "Time", H5T_NATIVE_DOUBLE, std::array{times_.times()[0]});
		addCells(root_, own_);
		if (!indexed_ || !division_.areAlike())
			addTypes(root_);
		if (division_.polyhedra().hasPolyhedra())
			for (PackList& list : listsOfFaces(division_, partitions_))
				add(root_, list.name, H5T_NATIVE_INT32, {list.rows}, std::move(list.rowsOf), std::move(list.gather));
		addArrays("PointData", grid_->GetPointData(), true);
		addArrays("CellData", grid_->GetCellData(), false);
		writeVersion();
		if (times_.areSeveral())
			writeSteps();
		writeColumns(division_, columns_);
	}

	// Writes the values at the next time. Takes the grid out of those that were read at that time.
	void writeArrays(std::size_t time, TimesToPack::Read& read)
	{
		const vtkSmartPointer<vtkUnstructuredGrid> grid = times_.takeGrid(time, read);
		std::deque<Column> columns;
		for (PackedArray& array : arrays_)
		{
			array.field.bytes = bytesOf(*times_.valuesAt(time, grid, array.values, array.on_points));
			array.facts.include(array.field);
			if (array.ranges)
				columns.push_back({&*array.ranges, read::bytesOfRanges(array.field),
				                   [this](std::size_t part) { return division_.runs(part).size(); },
				                   [this, &array](std::size_t part, std::byte* to)
				                   { gatherRanges(division_, part, array.field, to); }});
			if (!array.rows)
			{
				array.places.push_back(placeOf(array, time));
				continue;
			}
			const std::size_t bytes =
			    static_cast<std::size_t>(array.field.components) * grid::byteSize(array.field.type);
			const auto rows = [this, on_points = array.on_points](std::size_t part)
			{ return on_points ? division_.points(part) : division_.cells(part); };
			columns.push_back({&*array.rows, bytes, [rows](std::size_t part) { return rows(part).size(); },
			                   [rows, bytes, from = array.field.bytes.data()](std::size_t part, std::byte* to)
			                   { copyRows(from, bytes, rows(part), to); }});
		}
		writeColumns(division_, columns);
	}

	// Writes what is known when all values were written. warnings: those of the file's reader, for an index.
	void writeFacts(const std::vector<std::string>& warnings) const
	{
		for (const PackedArray& array : arrays_)
		{
			array.facts.write(array.own, times_.areSeveral());
			if (!array.rows)
				writePlaces(array.own, array.field, array.places, array.swaps);
		}
		if (!indexed_)
			return;
		indexed_->writeStamp(own_);
		for (std::size_t i = 0; i < warnings.size(); ++i)
			writeText(own_, fmt::format("Warning {}", i + 1).c_str(), warnings[i]);
	}

	// Returns lines on what cuts read of the file that the index is of.
	std::vector<std::string> linesAboutFile() const
	{
		std::vector<std::string> lines;
		std::string copied;
		bool keeps_any = false;
		for (const PackedArray& array : arrays_)
			if (array.rows)
				copied += fmt::format("{}{}", copied.empty() ? "" : ", ", array.values->GetName());
			else
				keeps_any = true;
		if (keeps_any)
			lines = linesAboutOrder(division_);
		if (!copied.empty())
			lines.push_back(fmt::format("what is not in one piece of plain numbers is in the index, too: {}", copied));
		return lines;
	}

private:
	// gather: writes the rows of a part, of which there are `rowsOf`.
	void add(hid_t group, const char* name, hid_t type, std::vector<hsize_t> sides,
	         std::function<std::size_t(std::size_t)> rowsOf, std::function<void(std::size_t, std::byte*)> gather)
	{
		std::size_t bytes = H5Tget_size(type);
		for (std::size_t side = 1; side < sides.size(); ++side)
			bytes *= sides[side];
		lists_.emplace_back(group, name, type, std::move(sides));
		columns_.push_back({&lists_.back(), bytes, std::move(rowsOf), std::move(gather)});
	}

	void addCells(hid_t root, hid_t own)
	{
		const hsize_t points = division_.allPoints();
		const hsize_t cells = division_.types().size();
		const auto pointsOf = [this](std::size_t part) { return division_.points(part).size(); };
		const auto cellsOf = [this](std::size_t part) { return division_.cells(part).size(); };
		const auto copy = [](std::span<const std::uint32_t> from, std::byte* to)
		{ std::ranges::copy(std::as_bytes(from), to); };
		add(root, "Points", places_->GetDataType() == VTK_FLOAT ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE, {points, 3},
		    pointsOf, [this](std::size_t part, std::byte* to) { gatherPlaces(part, to); });
		add(
		    root, "Connectivity", H5T_NATIVE_INT32, {division_.allIds()},
		    [this](std::size_t part) { return division_.ids(part); },
		    [this](std::size_t part, std::byte* to) { gatherIds(division_, partitions_, part, to); });
		add(own, "PointNumbers", H5T_NATIVE_UINT32, {points}, pointsOf,
		    [this, copy](std::size_t part, std::byte* to) { copy(division_.points(part), to); });
		add(own, "CellNumbers", H5T_NATIVE_UINT32, {cells}, cellsOf,
		    [this, copy](std::size_t part, std::byte* to) { copy(division_.cells(part), to); });
	}

	void addTypes(hid_t root)
	{
		add(
		    root, "Offsets", H5T_NATIVE_INT32, {division_.types().size() + partitions_.partitions().size()},
		    [this](std::size_t part)
		    { return division_.cells(part).size() + (partitions_.before(part).cells == 0 ? 1 : 0); },
		    [this](std::size_t part, std::byte* to) { gatherOffsets(division_, partitions_, part, to); });
		add(
		    root, "Types", H5T_NATIVE_UINT8, {division_.types().size()},
		    [this](std::size_t part) { return division_.cells(part).size(); },
		    [this](std::size_t part, std::byte* to)
		    { copyRows(std::as_bytes(division_.types()).data(), 1, division_.cells(part), to); });
	}

	void gatherPlaces(std::size_t part, std::byte* to) const
	{
		if (const int type = places_->GetDataType(); type == VTK_FLOAT || type == VTK_DOUBLE)
			return copyRows(bytesOf(*places_).data(), type == VTK_FLOAT ? 12 : 24, division_.points(part), to);
		for (const std::uint32_t point : division_.points(part))
		{
			const std::array<double, 3> at = division_.place(point);
			std::memcpy(to, at.data(), sizeof(at));
			to += sizeof(at);
		}
	}

	void addArrays(const char* name, vtkDataSetAttributes* fields, bool on_points)
	{
		const Handle values = groupInOrder(root_, name), own = groupInOrder(own_, name);
		for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
		{
			vtkDataArray* array = fields->GetArray(i);
			const auto type = array ? arrays::numberTypeOfVtk(array->GetDataType()) : std::nullopt;
			if (!type || !array->GetName())
				continue;
			const std::string plain = nameInGroup(own, array->GetName());
			const auto components = static_cast<hsize_t>(array->GetNumberOfComponents());
			const hsize_t rows = on_points ? division_.allPoints() : division_.types().size();
			std::vector<hsize_t> sides = {rows * times_.count()};
			if (components > 1)
				sides.push_back(components);
			arrays_.push_back({.values = array,
			                   .on_points = on_points,
			                   .name = plain,
			                   .rows_of_time = rows,
			                   .own = groupInOrder(own, plain.c_str())});
			PackedArray& added = arrays_.back();
			if (const char* units = arrays::unitsOf(array); units && *units)
				writeText(added.own, "Units", units);
			if (indexed_ || plain != array->GetName())
				writeText(added.own, "Name", array->GetName());
			added.field.components = static_cast<int>(components);
			added.field.type = *type;
			added.field.bytes = bytesOf(*array);
			if (const auto place = indexed_ ? indexed_->placeOf(on_points, array->GetName(), added.field, times_.kept())
			                                : std::nullopt)
				added.swaps = place->swaps;
			else
				added.rows.emplace(values, plain.c_str(), typeOf(array->GetDataType()), std::move(sides));
			if (on_points)
				added.ranges.emplace(added.own, "RunRanges", H5T_NATIVE_FLOAT,
				                     std::vector<hsize_t>{division_.allRuns() * times_.count(),
				                                          2 * read::columnsOfRanges(added.field.components)});
		}
	}

	// Older versions of the program look for all arrays of an index in its file, as this machine writes numbers, and
	// for no faces.
	void writeVersion() const
	{
		const bool is_plain = std::ranges::none_of(arrays_, [this](const PackedArray& array)
		                                           { return indexed_ && (array.rows || array.swaps); });
		const std::int64_t version = division_.polyhedra().hasPolyhedra() ? 4
		                             : !is_plain                          ? 3
		                             : times_.areSeveral()                ? 2
		                                                                  : 1;
		writeAttribute(own_, "Version", H5T_NATIVE_INT64, std::array<std::int64_t, 2>{version, 0});
	}

	void writeSteps() const
	{
		std::vector<StepsOfArray> steps;
		for (const PackedArray& array : arrays_)
			if (array.rows)
				steps.push_back({array.on_points, array.name, array.rows_of_time});
		writePackSteps(root_, times_.times(), partitions_.partitions().size(), division_.polyhedra().hasPolyhedra(),
		               steps);
	}

	struct PackedArray
	{
		vtkDataArray* values; // at the time that was kept
		bool on_points;
		std::string name; // in the pack
		hsize_t rows_of_time;
		Handle own;          // the group with what a pack says of it
		grid::Field field{}; // its values at the time that is written
		PackFacts facts{};
		std::optional<RowWriter> rows{};     // its values, if they do not stay in the file that an index is of
		std::vector<std::uint64_t> places{}; // else where they begin there at each time
		bool swaps = false;                  // likewise, whether the bytes of numbers are in the other order
		std::optional<RowWriter> ranges{};   // for values of points: between which those of each run lie
	};

	std::uint64_t placeOf(const PackedArray& array, std::size_t time) const
	{
		const char* name = array.values->GetName();
		if (const auto place = indexed_->placeOf(array.on_points, name, array.field, time))
			return place->offset;
		throw Refusal(
		    fmt::format("has the array {} as plain numbers, but not {}; use vprobe pack", name, times_.nameOf(time)));
	}

	vtkUnstructuredGrid* grid_;
	vtkDataArray* places_;
	Handle root_, own_;
	const IndexedFile* indexed_;
	PackTimes times_;
	PackDivision division_;
	PackPartitions partitions_;
	std::deque<RowWriter> lists_;
	std::deque<Column> columns_; // lists of points and cells
	std::deque<PackedArray> arrays_;
};

void writeKind(hid_t group, int major, int minor, const char* type)
{
	writeAttribute(group, "Version", H5T_NATIVE_INT64, std::array<std::int64_t, 2>{major, minor});
	writeText(group, "Type", type);
}

bool hasPolyhedra(const KeptBlock& block)
{
	return PackFaces(vtkUnstructuredGrid::SafeDownCast(block.data)).hasPolyhedra();
}

// Several blocks become a collection: a group for each, and a tree of links that names them.
std::deque<PackWriter> writersOf(const std::vector<KeptBlock>& blocks, const TimesToPack& times, hid_t file,
                                 const Request& request, const IndexedFile* indexed)
{
	Handle root = groupInOrder(file, "VTKHDF");
	Handle own = groupInOrder(file, "vprobe");
	std::deque<PackWriter> writers;
	const bool has_polyhedra = std::ranges::any_of(blocks, hasPolyhedra);
	if (blocks.size() == 1)
	{
		writeKind(root, has_polyhedra || times.times.size() > 1 ? 2 : 1, has_polyhedra ? 5 : 0, "UnstructuredGrid");
		writers.emplace_back(vtkUnstructuredGrid::SafeDownCast(blocks[0].data), times, request.cells_of_part,
		                     request.threads, std::move(root), std::move(own), indexed);
		return writers;
	}
	const int minor = has_polyhedra ? 5 : 1;
	writeKind(root, 2, minor, "PartitionedDataSetCollection");
	const Handle tree = groupInOrder(root, "Assembly");
	for (const KeptBlock& block : blocks)
	{
		const std::string name = nameInGroup(root, block.name.empty() ? "block" : block.name);
		Handle of_block = groupInOrder(root, name.c_str());
		writeKind(of_block, 2, minor, "UnstructuredGrid");
		writeAttribute(of_block, "Index", H5T_NATIVE_INT64, std::array{static_cast<std::int64_t>(writers.size())});
		checked(H5Lcreate_soft(("/VTKHDF/" + name).c_str(), tree, name.c_str(), H5P_DEFAULT, H5P_DEFAULT));
		writers.emplace_back(vtkUnstructuredGrid::SafeDownCast(block.data), times, request.cells_of_part,
		                     request.threads, std::move(of_block), groupInOrder(own, name.c_str()), indexed);
	}
	return writers;
}

} // namespace

std::vector<std::string> writePack(const std::vector<KeptBlock>& blocks, const TimesToPack& times,
                                   const std::string& path, const Request& request)
{
	H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
	std::optional<IndexedFile> indexed;
	if (request.writesIndex())
		indexed.emplace(request.file, request.stamp);
	if (indexed && blocks.size() != 1)
		throw Refusal("has several blocks, and indices are made of one alone; use vprobe pack");
	std::vector<std::string> lines;
	Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
	{
		std::deque<PackWriter> writers = writersOf(blocks, times, file, request, indexed ? &*indexed : nullptr);
		for (PackWriter& writer : writers)
			writer.writeGrid();
		for (std::size_t time = 0; time < std::max<std::size_t>(times.times.size(), 1); ++time)
		{
			TimesToPack::Read read = time == times.kept ? TimesToPack::Read() : times.read(time);
			for (PackWriter& writer : writers)
				writer.writeArrays(time, read);
		}
		for (const PackWriter& writer : writers)
			writer.writeFacts(request.said);
		if (indexed)
			lines = writers[0].linesAboutFile();
		else if (std::ranges::any_of(blocks, hasPolyhedra))
			lines.emplace_back(
			    "has polyhedra, so its pack is VTKHDF 2.5; VTK 9.1 crashes on it, and other programs that "
			    "read earlier versions may, too");
	}
	if (H5Fflush(file, H5F_SCOPE_LOCAL) < 0)
		throw NoRoom(kNoRoom);
	file.close();
	return lines;
}

} // namespace vp::reader::convert
