#include "api/states.h"
#include "base/messages.h"
#include "grid/curved/curved_cells.h"
#include "read/build_block.h"
#include "read/check_curved.h"
#include "read/check_mesh.h"
#include "read/collapsed_cells.h"
#include "read/manifest.h"
#include "read/placed_cells.h"
#include "read/prisms.h"
#include "read/tolerance.h"

#include <fmt/format.h>

#include <algorithm>

namespace vprobe
{

namespace
{

using vp::Array;
using vp::read::Unusable;

static_assert(static_cast<int>(NumberType::float64) == static_cast<int>(vp::grid::NumberType::float64));

template <class T>
Array<T> shared(const Numbers& numbers, const char* what)
{
	if (numbers.type != numberTypeOf<T>())
		throw Unusable(fmt::format("{}: another number type than it should have", what));
	if (numbers.size > 0 && !numbers.data)
		throw Unusable(fmt::format("{}: has no memory", what));
	if (reinterpret_cast<std::uintptr_t>(numbers.data) % alignof(T) != 0)
		throw Unusable(fmt::format("{}: its memory is not aligned", what));
	return {numbers.owner, static_cast<const T*>(numbers.data), numbers.size};
}

vp::grid::Points pointsOf(const Numbers& numbers)
{
	if (numbers.size % 3 != 0)
		throw Unusable("coordinates: points without three coordinates");
	const vp::grid::Points points = numbers.type == NumberType::float64
	                                    ? vp::grid::Points(shared<double>(numbers, "coordinates"))
	                                    : vp::grid::Points(shared<float>(numbers, "coordinates"));
	if (points.size() >= vp::kMaxBlockIds)
		throw Unusable(fmt::format("a block of {} points is too large; split it", points.size()));
	return points;
}

// Returns ids of 32 or 64 bits as 64 bits.
Array<std::int64_t> wide(const Numbers& numbers, const char* what)
{
	if (numbers.type != NumberType::int32)
		return shared<std::int64_t>(numbers, what);
	const Array<std::int32_t> narrow = shared<std::int32_t>(numbers, what);
	return Array<std::int64_t>(std::vector<std::int64_t>(narrow.data(), narrow.data() + narrow.size()));
}

std::uint64_t product(const std::array<std::uint32_t, 3>& n, std::uint32_t less)
{
	return std::uint64_t(n[0] - less) * (n[1] - less) * (n[2] - less);
}

void checkTolerance(const vp::grid::CellList& cells, double tolerance)
{
	if (vp::read::isTolerance(tolerance) && tolerance >= vp::read::kMinTolerance)
		return;
	const auto types = cells.types.span();
	const auto curved = std::ranges::find_if(types, vp::grid::isCurved);
	throw Unusable(
	    fmt::format("cell {} of type {} is curved, and `tolerance` is {}; give one from {} to below 1, or cells "
	                "of linear types",
	                curved - types.begin(), *curved, tolerance, vp::read::kMinTolerance));
}

// Makes the grid of a block. `points` and `cells` get the number of values that its arrays need.
struct Wrapper
{
	vp::read::CheckedBlock& block;
	std::uint64_t points = 0;
	std::uint64_t cells = 0;
	double tolerance = 0.0;   // tolerance of curved cells
	std::size_t unplaced = 0; // number of cells left out because a point is not finite

	void takeLattice(const std::array<std::uint32_t, 3>& lattice)
	{
		points = product(lattice, 0);
		cells = product(lattice, 1);
	}
	static std::array<std::uint32_t, 3> latticeOf(const std::array<std::size_t, 3>& n)
	{
		return vp::read::latticeOf({n[0], n[1], n[2]});
	}

	void operator()(const Image3& image)
	{
		const auto lattice = latticeOf(image.points);
		const vp::Vec3 origin(image.origin[0], image.origin[1], image.origin[2]);
		const vp::Vec3 spacing(image.spacing[0], image.spacing[1], image.spacing[2]);
		vp::read::checkImage(lattice, origin, spacing);
		block.mesh = vp::grid::UniformGrid(lattice, origin, spacing);
		takeLattice(lattice);
	}
	void operator()(const Rectilinear& grid)
	{
		const std::array axes{shared<double>(grid.x, "x"), shared<double>(grid.y, "y"), shared<double>(grid.z, "z")};
		for (const Array<double>& axis : axes)
			vp::read::checkAxis(axis);
		takeLattice(latticeOf({axes[0].size(), axes[1].size(), axes[2].size()}));
		block.mesh = vp::grid::RectilinearGrid(axes[0], axes[1], axes[2]);
	}
	void operator()(const Structured& grid)
	{
		const auto lattice = latticeOf(grid.points);
		takeLattice(lattice);
		const vp::grid::Points coordinates = pointsOf(grid.coordinates);
		if (coordinates.size() != points)
			throw Unusable(fmt::format("coordinates: {} points where {} belong", coordinates.size(), points));
		unplaced = vp::read::takePlacedLattice(lattice, coordinates, block);
	}
	void operator()(const Unstructured& grid)
	{
		vp::read::CellMesh mesh;
		mesh.points = pointsOf(grid.coordinates);
		mesh.cells.types = shared<std::uint8_t>(grid.types, "types");
		cells = mesh.cells.types.size();
		points = mesh.points.size();
		if (cells == 0 || cells >= vp::kMaxBlockIds)
			throw Unusable(fmt::format("a block of {} cells cannot be held", cells));
		mesh.cells.offsets = wide(grid.offsets, "offsets");
		if (mesh.cells.offsets.size() != cells + 1)
			throw Unusable(fmt::format("offsets: {} where {} belong", mesh.cells.offsets.size(), cells + 1));
		if (grid.connectivity.type == NumberType::int32)
			mesh.cells.connectivity = shared<std::int32_t>(grid.connectivity, "connectivity");
		else
			mesh.cells.connectivity = shared<std::int64_t>(grid.connectivity, "connectivity");
		if (grid.face_offsets.size > 0)
		{
			mesh.cells.face_offsets = shared<std::int64_t>(grid.face_offsets, "face_offsets");
			mesh.cells.face_stream = shared<std::int64_t>(grid.face_stream, "face_stream");
			if (mesh.cells.face_offsets.size() != cells + 1)
				throw Unusable(
				    fmt::format("face_offsets: {} where {} belong", mesh.cells.face_offsets.size(), cells + 1));
		}
		vp::read::rewritePrisms(mesh.cells);
		mesh.cells.has_checked_ids = !grid.checks_ids_later;
		mesh.curved = vp::read::checkCells(mesh.cells, mesh.points.size(), true);
		vp::read::orderCollapsed(mesh.cells);
		if (mesh.curved)
			checkTolerance(mesh.cells, grid.tolerance);
		unplaced = vp::read::leaveOutUnplaced(mesh);
		block.mesh = std::move(mesh);
		tolerance = grid.tolerance;
	}
};

vp::grid::Field fieldOf(const Field& field)
{
	const auto type = static_cast<vp::grid::NumberType>(field.values.type);
	if (field.values.size > 0 && !field.values.data)
		throw Unusable(fmt::format("the array {} has no memory", field.name));
	vp::grid::Field made;
	made.name = field.name;
	made.association =
	    field.association == Association::point ? vp::grid::Association::point : vp::grid::Association::cell;
	made.components = field.components;
	made.type = type;
	made.units = field.units;
	made.bytes = {field.values.owner, static_cast<const std::byte*>(field.values.data),
	              field.values.size * vp::grid::byteSize(type)};
	return made;
}

// Takes the arrays that say of what degrees Lagrange and Bezier cells are, and how rational, by the names that VTK's
// files give them.
void takeShapeArrays(vp::read::CheckedBlock& block)
{
	auto* mesh = std::get_if<vp::read::CellMesh>(&block.mesh);
	if (!mesh || !mesh->curved)
		return;
	for (const vp::grid::Field& field : block.fields)
	{
		const bool is_point = field.association == vp::grid::Association::point;
		if (!is_point && field.name == "HigherOrderDegrees" && field.components == 3)
		{
			std::vector<std::int32_t> degrees;
			for (std::size_t c = 0; c < field.tuples(); ++c)
				for (int axis = 0; axis < 3; ++axis)
				{
					const double degree = field.value(c, axis);
					const bool is_one = degree >= 1.0 && degree <= vp::grid::kMaxDegree;
					degrees.push_back(is_one ? static_cast<std::int32_t>(degree) : 0);
				}
			mesh->degrees = std::move(degrees);
		}
		if (is_point && field.name == "RationalWeights" && field.components == 1)
		{
			std::vector<double> weights;
			for (std::size_t p = 0; p < field.tuples(); ++p)
				weights.push_back(field.value(p, 0));
			mesh->weights = std::move(weights);
		}
	}
	vp::read::checkCurvedCells(*mesh);
}

} // namespace

vp::grid::BlockSet wrapped(std::vector<Block> blocks, std::vector<ArraySizes>& sizes)
try
{
	if (blocks.empty())
		throw Unusable("no blocks");
	vp::grid::BlockSet set;
	std::size_t unplaced = 0;
	for (Block& block : blocks)
	{
		vp::read::CheckedBlock checked;
		Wrapper wrapper{checked};
		std::visit(wrapper, block.grid);
		unplaced += wrapper.unplaced;
		for (const Field& field : block.fields)
		{
			checked.fields.push_back(fieldOf(field));
			vp::read::checkField(checked.fields.back(), wrapper.points, wrapper.cells);
		}
		sizes.push_back({wrapper.points, wrapper.cells});
		takeShapeArrays(checked);
		checked.length_units = block.length_units;
		set.blocks.push_back(vp::read::buildBlock(std::move(checked), block.name, false, true, wrapper.tolerance));
	}
	set.unplaced = unplaced;
	if (unplaced > 0)
		vp::warn("{}", vp::read::unplacedWarning(unplaced).text());
	// As for files: what further cuts need waits for them. A mixture of listed and other grids does not wait.
	const auto isListed = [](const vp::grid::Block& block) { return !vp::grid::hasNeighbors(block); };
	if (std::ranges::none_of(set.blocks, isListed))
		set.matches_seams = false;
	else if (!std::ranges::all_of(set.blocks, isListed))
		vp::grid::buildNeighbors(set);
	return set;
}
catch (const vp::grid::WrongPoint& wrong)
{
	throw Unusable(wrong.what());
}

namespace
{

// Adds what a grid holds.
struct Holder
{
	HeldBlock& held;

	void add(const vp::grid::Points& points) const
	{
		const void* data = points.isDouble() ? static_cast<const void*>(points.doubles()) : points.floats();
		held.coordinates.emplace_back(data, 3 * points.size(),
		                              points.isDouble() ? NumberType::float64 : NumberType::float32, points.owner());
	}
	void operator()(const vp::grid::UniformGrid&) const {}
	void operator()(const vp::grid::RectilinearGrid& grid) const
	{
		for (int a = 0; a < 3; ++a)
			held.coordinates.emplace_back(grid.axis(a).span(), grid.axis(a).owner());
	}
	void operator()(const vp::grid::CurvilinearGrid& grid) const { add(grid.coordinates()); }
	void operator()(const vp::grid::UnstructuredGrid& grid) const
	{
		add(grid.coordinates());
		if (const vp::grid::CellList* list = grid.list())
			list->connectivity.as([&](auto ids) { held.connectivity = {ids, list->connectivity.owner()}; });
	}
};

} // namespace

std::vector<ArraySizes> arraySizes(const vp::grid::BlockSet& blocks)
{
	std::vector<ArraySizes> sizes;
	const auto counts = [](const auto& grid) -> ArraySizes
	{
		if constexpr (requires { grid.sourceCellCount(); })
			return {grid.sourcePointCount(), grid.sourceCellCount()};
		else
			return {grid.pointCount(), grid.cellCount()};
	};
	for (const vp::grid::Block& block : blocks.blocks)
		sizes.push_back(std::visit(counts, block.grid));
	return sizes;
}

vp::Result<std::vector<std::vector<vp::grid::Field>>> checkedFields(const std::vector<ArraySizes>& sizes,
                                                                    const std::vector<std::vector<Field>>& fields)
{
	if (fields.size() != sizes.size())
		return vp::Error{vp::ErrorKind::input,
		                 fmt::format("arrays of {} blocks where there are {}", fields.size(), sizes.size())};
	std::vector<std::vector<vp::grid::Field>> checked(fields.size());
	try
	{
		for (std::size_t b = 0; b < fields.size(); ++b)
			for (const Field& field : fields[b])
			{
				checked[b].push_back(fieldOf(field));
				vp::read::checkField(checked[b].back(), sizes[b].points, sizes[b].cells);
			}
	}
	catch (const Unusable& unusable)
	{
		return vp::Error{vp::ErrorKind::input, unusable.what()};
	}
	return checked;
}

HeldBlock heldBlock(const vp::grid::Block& block)
{
	HeldBlock held{block.name, {}, {}, {}};
	std::visit(Holder{held}, block.grid);
	for (const vp::grid::Field& given : block.fields)
	{
		const vp::grid::Field field = vp::grid::inMemory(given);
		const ArrayInfo info = infoOf(field);
		held.fields.push_back({info.name, info.association, info.components,
		                       Numbers(field.bytes.data(), field.bytes.size() / vp::grid::byteSize(field.type),
		                               info.type, field.bytes.owner()),
		                       info.units});
	}
	return held;
}

} // namespace vprobe
