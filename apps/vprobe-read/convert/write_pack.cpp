// An unstructured grid in parts that lie together in space: VTKHDF 1.0 in partitions, which VTK reads, and beside it a
// group `vprobe` that other programs pass over. docs/FORMATS.md describes the group.
#include "convert.h"
#include "grid/farthest_points.h"
#include "grid/labels.h"
#include "hdf5_output.h"
#include "pack_division.h"
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/refusal.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace vp::reader::convert
{

namespace
{

using Bytes = std::vector<std::byte>;

constexpr std::size_t kPartsAtOnce = 64; // are gathered on all threads, and then written

void put(const void* from, std::size_t bytes, Bytes& to)
{
	const auto* first = static_cast<const std::byte*>(from);
	to.insert(to.end(), first, first + bytes);
}

// A list of the file: a row for each point, cell, or corner of a cell.
struct Column
{
	RowWriter rows;
	std::size_t row_bytes;
	// Appends the rows of a part.
	std::function<void(std::size_t part, Bytes& to)> gather;
};

class PackWriter
{
public:
	PackWriter(vtkUnstructuredGrid* grid, std::size_t most_cells, int threads)
	    : grid_(grid), places_(grid->GetPoints()->GetData()), division_(grid, most_cells, threads)
	{
	}

	void write(hid_t file)
	{
		const Handle root = groupInOrder(file, "VTKHDF");
		writeAttribute(root, "Version", H5T_NATIVE_INT64, std::array<std::int64_t, 2>{1, 0});
		writeType(root, "UnstructuredGrid");
		const Handle own = groupInOrder(file, "vprobe");
		writeAttribute(own, "Version", H5T_NATIVE_INT64, std::array<std::int64_t, 2>{1, 0});
		const auto count = [](vtkIdType number) { return std::array<std::int64_t, 1>{number}; };
		writeAttribute(own, "NumberOfPoints", H5T_NATIVE_INT64, count(grid_->GetNumberOfPoints()));
		writeAttribute(own, "NumberOfCells", H5T_NATIVE_INT64, count(grid_->GetNumberOfCells()));
		writeAttribute(own, "PointsOfNoCell", H5T_NATIVE_INT64, count(pointsOfNoCell()));
		writeAttribute(own, "CellsOfRun", H5T_NATIVE_INT64, count(static_cast<vtkIdType>(division_.cellsOfRun())));
		const PackDivision::LeftOut& left_out = division_.leftOut();
		writeAttribute(own, "FlatCells", H5T_NATIVE_INT64, count(left_out.flat));
		writeAttribute(own, "HiddenCells", H5T_NATIVE_INT64, count(left_out.hidden));
		writeAttribute(own, "CellsWithoutPlace", H5T_NATIVE_INT64, count(left_out.unplaced));
		const std::span<const std::uint8_t> types = division_.types();
		if (std::ranges::all_of(types, [&](std::uint8_t type) { return type == types[0]; }))
			writeAttribute(own, "CellType", H5T_NATIVE_INT64, count(types[0]));
		writeCounts(root);
		writeRuns(own);
		writeFarthestPoints(own);
		addCells(root, own);
		addArrays(root, own, "PointData", grid_->GetPointData(), true);
		addArrays(root, own, "CellData", grid_->GetCellData(), false);
		writeColumns();
	}

private:
	void writeCounts(hid_t root) const
	{
		std::vector<std::int64_t> points, cells, ids;
		for (std::size_t part = 0; part < division_.parts(); ++part)
		{
			points.push_back(static_cast<std::int64_t>(division_.points(part).size()));
			cells.push_back(static_cast<std::int64_t>(division_.cells(part).size()));
			ids.push_back(static_cast<std::int64_t>(division_.ids(part)));
		}
		const std::vector<hsize_t> sides = {points.size()};
		writeValues(root, "NumberOfPoints", H5T_NATIVE_INT64, sides, points.data());
		writeValues(root, "NumberOfCells", H5T_NATIVE_INT64, sides, cells.data());
		writeValues(root, "NumberOfConnectivityIds", H5T_NATIVE_INT64, sides, ids.data());
	}

	vtkIdType pointsOfNoCell() const
	{
		std::vector<bool> has_cell(static_cast<std::size_t>(grid_->GetNumberOfPoints()));
		for (std::size_t part = 0; part < division_.parts(); ++part)
			for (const std::uint32_t point : division_.points(part))
				has_cell[point] = true;
		return std::ranges::count(has_cell, false);
	}

	// A box and the number of ids for each run of cells.
	void writeRuns(hid_t own) const
	{
		static_assert(sizeof(PackBox) == 6 * sizeof(double));
		std::vector<PackBox> boxes;
		std::vector<std::uint32_t> counts;
		for (std::size_t part = 0; part < division_.parts(); ++part)
			for (const PackRun& run : division_.runs(part))
			{
				boxes.push_back(run.box);
				counts.push_back(run.ids);
			}
		writeValues(own, "Boxes", H5T_NATIVE_DOUBLE, {boxes.size(), 6}, boxes.data());
		writeValues(own, "NumberOfConnectivityIds", H5T_NATIVE_UINT32, {counts.size()}, counts.data());
	}

	// A camera is set so that it sees all of them.
	void writeFarthestPoints(hid_t own) const
	{
		Box bounds;
		for (std::size_t part = 0; part < division_.parts(); ++part)
			for (const auto& [box, ids] : division_.runs(part))
				if (box.lo[0] <= box.hi[0])
					bounds.include(Box{{box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]}});
		grid::FarthestPoints farthest(bounds.center());
		farthest.include(bounds, static_cast<std::size_t>(grid_->GetNumberOfPoints()),
		                 [this](std::size_t point)
		                 {
			                 const std::array<double, 3> at = division_.place(static_cast<std::uint32_t>(point));
			                 return Vec3(at[0], at[1], at[2]);
		                 });
		const std::vector<Vec3> points = farthest.points();
		writeValues(own, "FarthestPoints", H5T_NATIVE_DOUBLE, {points.size(), 3}, points.data());
	}

	void add(hid_t group, const char* name, hid_t type, std::vector<hsize_t> sides,
	         std::function<void(std::size_t, Bytes&)> gather)
	{
		std::size_t bytes = H5Tget_size(type);
		for (std::size_t side = 1; side < sides.size(); ++side)
			bytes *= sides[side];
		columns_.push_back({RowWriter(group, name, type, std::move(sides)), bytes, std::move(gather)});
	}

	void addCells(hid_t root, hid_t own)
	{
		const hsize_t points = division_.allPoints();
		const hsize_t ids = division_.allIds();
		add(root, "Points", places_->GetDataType() == VTK_FLOAT ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE, {points, 3},
		    [this](std::size_t part, Bytes& to) { gatherPlaces(part, to); });
		add(root, "Connectivity", H5T_NATIVE_INT32, {ids},
		    [this](std::size_t part, Bytes& to) { gatherIds(part, to); });
		add(root, "Offsets", H5T_NATIVE_INT32, {division_.types().size() + division_.parts()},
		    [this](std::size_t part, Bytes& to) { gatherOffsets(part, to); });
		add(root, "Types", H5T_NATIVE_UINT8, {division_.types().size()},
		    [this](std::size_t part, Bytes& to)
		    {
			    for (const std::uint32_t cell : division_.cells(part))
				    to.push_back(static_cast<std::byte>(division_.types()[cell]));
		    });
		add(own, "PointNumbers", H5T_NATIVE_UINT32, {points},
		    [this](std::size_t part, Bytes& to)
		    { put(division_.points(part).data(), 4 * division_.points(part).size(), to); });
		add(own, "CellNumbers", H5T_NATIVE_UINT32, {division_.types().size()},
		    [this](std::size_t part, Bytes& to)
		    { put(division_.cells(part).data(), 4 * division_.cells(part).size(), to); });
	}

	void gatherPlaces(std::size_t part, Bytes& to) const
	{
		const bool is_single = places_->GetDataType() == VTK_FLOAT;
		for (const std::uint32_t point : division_.points(part))
		{
			const std::array<double, 3> at = division_.place(point);
			if (!is_single)
				put(at.data(), sizeof(at), to);
			else
				for (const double number : at)
				{
					const auto single = static_cast<float>(number);
					put(&single, sizeof(single), to);
				}
		}
	}

	void gatherIds(std::size_t part, Bytes& to) const
	{
		thread_local std::vector<std::int32_t> within; // the place of a point in its part
		within.resize(static_cast<std::size_t>(grid_->GetNumberOfPoints()));
		for (std::size_t p = 0; p < division_.points(part).size(); ++p)
			within[division_.points(part)[p]] = static_cast<std::int32_t>(p);
		division_.withLists(
		    [&](const auto* offsets, const auto* ids)
		    {
			    for (const std::uint32_t cell : division_.cells(part))
				    for (auto i = offsets[cell]; i < division_.endOf(cell, offsets); ++i)
					    put(&within[static_cast<std::size_t>(ids[i])], sizeof(std::int32_t), to);
		    });
	}

	void gatherOffsets(std::size_t part, Bytes& to) const
	{
		std::int32_t end = 0;
		put(&end, sizeof(end), to);
		division_.withLists(
		    [&](const auto* offsets, const auto*)
		    {
			    for (const std::uint32_t cell : division_.cells(part))
			    {
				    end += static_cast<std::int32_t>(division_.endOf(cell, offsets) - offsets[cell]);
				    put(&end, sizeof(end), to);
			    }
		    });
	}

	void addArrays(hid_t root, hid_t own, const char* name, vtkDataSetAttributes* fields, bool on_points)
	{
		const Handle values = groupInOrder(root, name);
		const Handle facts = groupInOrder(own, name);
		for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
		{
			vtkDataArray* array = fields->GetArray(i);
			const auto type = array ? arrays::numberTypeOfVtk(array->GetDataType()) : std::nullopt;
			if (!type || !array->GetName())
				continue;
			const std::string plain = nameInGroup(values, array->GetName());
			const auto components = static_cast<hsize_t>(array->GetNumberOfComponents());
			const std::size_t bytes = components * grid::byteSize(*type);
			const auto* from = static_cast<const std::byte*>(array->GetVoidPointer(0));
			std::vector<hsize_t> sides = {on_points ? division_.allPoints() : division_.types().size()};
			if (components > 1)
				sides.push_back(components);
			add(values, plain.c_str(), typeOf(array->GetDataType()), std::move(sides),
			    [this, from, bytes, on_points](std::size_t part, Bytes& to)
			    {
				    const std::span<const std::uint32_t> rows =
				        on_points ? division_.points(part) : division_.cells(part);
				    for (const std::uint32_t row : rows)
					    put(from + row * bytes, bytes, to);
			    });
			writeFacts(facts, plain, *type, *array);
		}
	}

	// The group of an array has "Spans": for each component, and last for the length of the tuple, the least and the
	// greatest value, and whether there are infinite ones, below and above. For one component of integers also its
	// different "Values", and how often they change.
	static void writeFacts(hid_t group, const std::string& name, grid::NumberType type, vtkDataArray& array)
	{
		grid::Field field;
		field.components = array.GetNumberOfComponents();
		field.type = type;
		field.bytes = {nullptr, static_cast<const std::byte*>(array.GetVoidPointer(0)),
		               static_cast<std::size_t>(array.GetNumberOfValues()) * grid::byteSize(type)};
		const Handle facts(H5Gcreate2(group, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
		std::vector<double> rows;
		for (int component = 0; component <= field.components; ++component)
		{
			const auto span = grid::valueSpan(field, component == field.components ? grid::kMagnitude : component);
			rows.insert(rows.end(),
			            {span.lo, span.hi, span.minus_infinity ? 1.0 : 0.0, span.plus_infinity ? 1.0 : 0.0});
		}
		writeValues(facts, "Spans", H5T_NATIVE_DOUBLE, {rows.size() / 4, 4}, rows.data());
		if (field.components > 1 || type >= grid::NumberType::float32)
			return;
		const grid::Distinct found = grid::distinctValues(field, grid::kMaxCategories);
		const grid::Changes changes = grid::changesOf(field, found.all());
		writeValues(facts, "Values", H5T_NATIVE_DOUBLE, {found.count}, found.values.data());
		writeAttribute(facts, "Changes", H5T_NATIVE_UINT64, std::array<std::uint64_t, 2>{changes.all, changes.to_next});
	}

	void writeColumns()
	{
		for (std::size_t first = 0; first < division_.parts(); first += kPartsAtOnce)
		{
			const std::size_t parts = std::min(kPartsAtOnce, division_.parts() - first);
			std::vector<std::vector<Bytes>> gathered(columns_.size(), std::vector<Bytes>(parts));
			division_.forEach(parts,
			                  [&](std::size_t part)
			                  {
				                  for (std::size_t column = 0; column < columns_.size(); ++column)
					                  columns_[column].gather(first + part, gathered[column][part]);
			                  });
			for (std::size_t column = 0; column < columns_.size(); ++column)
			{
				Bytes together;
				for (const Bytes& of_part : gathered[column])
					together.insert(together.end(), of_part.begin(), of_part.end());
				columns_[column].rows.append(together.data(), together.size() / columns_[column].row_bytes);
			}
		}
	}

	vtkUnstructuredGrid* grid_;
	vtkDataArray* places_;
	PackDivision division_;
	std::deque<Column> columns_;
};

} // namespace

void writePack(vtkDataSet* data, const std::string& path, std::size_t cells_of_part, int threads)
{
	H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
	auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
	constexpr vtkIdType most = 0xFFFFFFFF;
	if (grid->GetNumberOfPoints() > most || grid->GetNumberOfCells() > most)
		throw Refusal("has more than 4 294 967 295 points or cells; pack it in several files");
	Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
	PackWriter(grid, cells_of_part, threads).write(file);
	if (H5Fflush(file, H5F_SCOPE_LOCAL) < 0)
		throw NoRoom(kNoRoom);
	file.close();
}

} // namespace vp::reader::convert
