#include "exodus_cells.h"

#include "exodus_forms.h"
#include "exodus_points.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/new_nodes.h"
#include "vprobe-read/hdf5/netcdf_file.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkExodusIIReader.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <string_view>

namespace vp::reader::wrapped
{

namespace
{

// Another order of the nodes in faces must bring them this much nearer to the faces' middles than the manual's.
constexpr double kClearlyNearer = 0.99;

std::vector<std::int64_t> blockIds(const hdf5::NetcdfFile& file, std::size_t blocks)
{
	std::vector<std::int64_t> ids(blocks);
	std::iota(ids.begin(), ids.end(), 1);
	if (const int variable = file.variable("eb_prop1"); variable >= 0)
		if (const std::vector<double> given = file.values(variable); given.size() == blocks)
			std::ranges::transform(given, ids.begin(), [](double id) { return std::llround(id); });
	return ids;
}

std::string familyOf(std::string name)
{
	name.resize(std::min(name.size(), std::size_t(3)));
	std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::toupper(c); });
	return name;
}

// The numbers of the points of each cell, from 0.
std::vector<vtkIdType> connectivityOf(const hdf5::NetcdfFile& file, const OddExodusBlock& block, vtkIdType points)
{
	const std::vector<double> given = file.values(file.variable(block.connectivity.c_str()));
	std::vector<vtkIdType> ids;
	ids.reserve(given.size());
	for (const double node : given)
	{
		if (!(node >= 1.0 && node <= static_cast<double>(points)))
			throw damaged(fmt::format("block {} lists node {} of {}", block.id, node, points));
		ids.push_back(static_cast<vtkIdType>(node) - 1);
	}
	return ids;
}

// Leaves out the points that no cell uses, and numbers those in `ids` anew.
vtkSmartPointer<vtkUnstructuredGrid> withUsedPoints(vtkUnstructuredGrid* grid, std::vector<vtkIdType>& ids)
{
	std::vector<vtkIdType> numbers(static_cast<std::size_t>(grid->GetNumberOfPoints()), -1);
	for (const vtkIdType id : ids)
		numbers[static_cast<std::size_t>(id)] = 0;
	vtkNew<vtkIdList> kept;
	for (std::size_t p = 0; p < numbers.size(); ++p)
		if (numbers[p] == 0)
			numbers[p] = kept->InsertNextId(static_cast<vtkIdType>(p));
	for (vtkIdType& id : ids)
		id = numbers[static_cast<std::size_t>(id)];
	const auto made = vtkSmartPointer<vtkUnstructuredGrid>::New();
	vtkNew<vtkPoints> points;
	points->SetDataType(grid->GetPoints()->GetDataType());
	grid->GetPoints()->GetPoints(kept, points);
	made->SetPoints(points);
	made->GetPointData()->CopyAllOn();
	made->GetPointData()->CopyAllocate(grid->GetPointData(), kept->GetNumberOfIds());
	vtkNew<vtkIdList> to;
	to->SetNumberOfIds(kept->GetNumberOfIds());
	std::iota(to->begin(), to->end(), vtkIdType(0));
	made->GetPointData()->CopyData(grid->GetPointData(), kept, to);
	made->GetCellData()->ShallowCopy(grid->GetCellData());
	made->SetFieldData(grid->GetFieldData());
	return made;
}

// The cells of a block that VTK reads as they are.
void leaveOutPoints(vtkMultiBlockDataSet* parent, unsigned int child, vtkUnstructuredGrid* grid)
{
	vtkCellArray* cells = grid->GetCells();
	if (!cells || !grid->GetPoints() || grid->GetFaces()) // polyhedra list their points in their faces too
		return;
	cells->ConvertTo64BitStorage();
	vtkTypeInt64Array* listed = cells->GetConnectivityArray64();
	std::vector<vtkIdType> ids(listed->GetPointer(0), listed->GetPointer(0) + listed->GetNumberOfValues());
	std::vector<bool> is_used(static_cast<std::size_t>(grid->GetNumberOfPoints()));
	for (const vtkIdType id : ids)
	{
		if (id < 0 || id >= grid->GetNumberOfPoints())
			throw damaged(fmt::format("a cell lists point {} of {}", id, grid->GetNumberOfPoints()));
		is_used[static_cast<std::size_t>(id)] = true;
	}
	if (std::ranges::find(is_used, false) == is_used.end())
		return;
	const auto made = withUsedPoints(grid, ids);
	vtkNew<vtkTypeInt64Array> renumbered;
	renumbered->SetNumberOfValues(listed->GetNumberOfValues());
	std::ranges::copy(ids, renumbered->GetPointer(0));
	vtkNew<vtkCellArray> new_cells;
	new_cells->SetData(cells->GetOffsetsArray64(), renumbered);
	made->SetCells(grid->GetCellTypesArray(), new_cells);
	parent->SetBlock(child, made);
}

// Calls use(KIND, PARENT, CHILD, GRID) for each block of elements, and for each set. KIND: the name of what it is.
template <class Use>
void forEachGrid(vtkMultiBlockDataSet* objects, Use&& use)
{
	for (unsigned int kind = 0; kind < objects->GetNumberOfBlocks(); ++kind)
	{
		auto* parent = vtkMultiBlockDataSet::SafeDownCast(objects->GetBlock(kind));
		const char* name =
		    objects->HasMetaData(kind) ? objects->GetMetaData(kind)->Get(vtkCompositeDataSet::NAME()) : nullptr;
		for (unsigned int child = 0; parent && child < parent->GetNumberOfBlocks(); ++child)
			if (auto* grid = vtkUnstructuredGrid::SafeDownCast(parent->GetBlock(child)))
				use(std::string_view(name ? name : ""), parent, child, grid);
	}
}

// For each of the element's nodes in faces and inside, the node of the cell that it is. Writers list these in more than
// one order, so their places tell: in the right order they are where the edges about them say, or near there.
std::vector<std::uint8_t> bestOrder(const ExodusForm& form, const std::vector<vtkIdType>& ids,
                                    const cells::NewNodes& at)
{
	const std::size_t size = form.nodes.size();
	const std::size_t others = size - form.in_place;
	ExodusForm edges = form; // without the nodes in question
	edges.nodes.resize(form.in_place);
	const std::vector<std::vector<double>> weights = edges.weights();
	std::vector<double> costs(others * others);
	for (std::size_t first = 0; first + size <= ids.size(); first += size)
		for (std::size_t slot = 0; slot < others; ++slot)
		{
			Vec3 expected(0.0);
			const std::vector<double>& of_slot = weights[form.nodes[form.in_place + slot]];
			for (std::size_t n = 0; n < form.in_place; ++n)
				expected += of_slot[n] * at.at(ids[first + n]);
			for (std::size_t node = 0; node < others; ++node)
			{
				const Vec3 off = at.at(ids[first + form.in_place + node]) - expected;
				costs[node * others + slot] += glm::dot(off, off);
			}
		}
	std::vector<std::uint8_t> order(others);
	std::iota(order.begin(), order.end(), std::uint8_t(0));
	const auto costOf = [&](const std::vector<std::uint8_t>& slots)
	{
		double sum = 0.0;
		for (std::size_t node = 0; node < others; ++node)
			sum += costs[node * others + slots[node]];
		return sum;
	};
	std::vector<std::uint8_t> best = order;
	const double of_manual = costOf(order);
	double least = of_manual;
	while (std::next_permutation(order.begin(), order.end()))
		if (const double cost = costOf(order); cost < least)
		{
			least = cost;
			best = order;
		}
	if (!(least < kClearlyNearer * of_manual))
		std::ranges::sort(best);
	std::vector<std::uint8_t> nodes;
	for (const std::uint8_t slot : best)
		nodes.push_back(form.nodes[form.in_place + slot]);
	return nodes;
}

vtkSmartPointer<vtkUnstructuredGrid> rebuilt(const hdf5::NetcdfFile& file, const OddExodusBlock& block,
                                             vtkUnstructuredGrid* grid)
{
	ExodusForm form = exodusForms()[block.form];
	std::vector<vtkIdType> ids = connectivityOf(file, block, grid->GetNumberOfPoints());
	const std::size_t size = form.nodes.size();
	if (ids.size() != size * static_cast<std::size_t>(grid->GetNumberOfCells()))
		throw damaged(
		    fmt::format("block {} lists {} nodes for {} cells", block.id, ids.size(), grid->GetNumberOfCells()));
	const auto made = withUsedPoints(grid, ids);
	cells::NewNodes nodes(made);
	std::ranges::copy(bestOrder(form, ids, nodes), form.nodes.begin() + static_cast<std::ptrdiff_t>(form.in_place));
	const std::vector<std::vector<double>> weights = form.weights();
	const FullCell& cell = *form.cell;
	std::vector<int> own(cell.nodes.size(), -1);
	for (std::size_t n = 0; n < size; ++n)
		own[form.nodes[n]] = static_cast<int>(n);

	vtkNew<vtkIdList> listed;
	vtkNew<vtkCellArray> cells;
	vtkNew<vtkUnsignedCharArray> types;
	std::vector<vtkIdType> of_cell(cell.nodes.size());
	std::vector<vtkIdType> about;
	for (std::size_t first = 0; first + size <= ids.size(); first += size)
	{
		listed->SetNumberOfIds(static_cast<vtkIdType>(size));
		std::copy_n(ids.begin() + static_cast<std::ptrdiff_t>(first), size, listed->begin());
		nodes.enterCell(listed);
		for (std::size_t n = 0; n < of_cell.size(); ++n)
		{
			if (own[n] >= 0)
			{
				of_cell[n] = ids[first + static_cast<std::size_t>(own[n])];
				continue;
			}
			const std::vector<std::uint8_t>& corners = cell.nodes[n];
			about.clear();
			for (const std::uint8_t corner : corners)
				about.push_back(of_cell[corner]);
			std::ranges::sort(about);
			of_cell[n] = nodes.between(about, [&] { return std::span(weights[n]); });
		}
		cells->InsertNextCell(static_cast<vtkIdType>(of_cell.size()), of_cell.data());
		types->InsertNextValue(cell.type);
	}
	made->SetPoints(nodes.points());
	made->GetPointData()->Initialize();
	for (int a = 0; a < nodes.data()->GetNumberOfArrays(); ++a)
		made->GetPointData()->AddArray(nodes.data()->GetArray(a));
	made->SetCells(types, cells);
	return made;
}

} // namespace

std::vector<OddExodusBlock> oddExodusBlocks(const std::string& path)
{
	const hdf5::NetcdfFile file(path);
	const std::size_t blocks = std::min(file.length("num_el_blk"), std::size_t(1) << 20);
	const std::vector<std::int64_t> ids = blockIds(file, blocks);
	std::vector<OddExodusBlock> odd;
	for (std::size_t b = 0; b < blocks; ++b)
	{
		const std::string name = fmt::format("connect{}", b + 1);
		const int variable = file.variable(name.c_str());
		const auto sides = variable < 0 ? decltype(file.dimensions(0))() : file.dimensions(variable);
		if (sides.size() != 2 || sides[0].second == 0)
			continue; // empty, or polyhedra
		const std::string type = file.text(variable, "elem_type");
		const std::string family = familyOf(type);
		const std::size_t nodes = sides[1].second;
		const auto plain = plainExodusNames(family);
		if (!plain || isPlainExodus(family, nodes))
			continue;
		const auto forms = exodusForms();
		const auto form = std::ranges::find_if(forms, [&](const ExodusForm& known)
		                                       { return known.family == family && known.nodes.size() == nodes; });
		if (form == forms.end())
			throw Refusal(fmt::format("block {} has elements of type {} with {} nodes, which cannot be read; write "
			                          "them as {}",
			                          ids[b], type, nodes, *plain));
		odd.push_back({ids[b], name, static_cast<std::size_t>(form - forms.begin())});
	}
	return odd;
}

void putExodusCellsRight(const std::string& path, const std::vector<OddExodusBlock>& odd, vtkExodusIIReader* reader,
                         vtkMultiBlockDataSet* objects)
{
	const hdf5::NetcdfFile file(path);
	const auto put =
	    [&](std::string_view kind, vtkMultiBlockDataSet* parent, unsigned int child, vtkUnstructuredGrid* grid)
	{
		const auto id = reader->GetObjectId(vtkExodusIIReader::ELEM_BLOCK, static_cast<int>(child));
		const auto found = kind == "Element Blocks" ? std::ranges::find(odd, id, &OddExodusBlock::id) : odd.end();
		if (found == odd.end())
			leaveOutPoints(parent, child, grid);
		else
			parent->SetBlock(child, rebuilt(file, *found, grid));
	};
	forEachGrid(objects, put);
}

bool hasExodusPolyhedra(const std::string& path)
{
	const hdf5::NetcdfFile file(path);
	const std::size_t blocks = std::min(file.length("num_el_blk"), std::size_t(1) << 20);
	for (std::size_t block = 1; block <= blocks; ++block)
		if (file.variable(fmt::format("facconn{}", block).c_str()) >= 0)
			return true;
	return false;
}

void leaveOutExodusPoints(vtkMultiBlockDataSet* objects, bool numbers_nodes)
{
	const auto leaveOut =
	    [numbers_nodes](std::string_view, vtkMultiBlockDataSet* parent, unsigned int child, vtkUnstructuredGrid* grid)
	{
		if (numbers_nodes)
			numberExodusNodes(grid);
		leaveOutPoints(parent, child, grid);
	};
	forEachGrid(objects, leaveOut);
}

} // namespace vp::reader::wrapped
