#include "classify/gpu_upload.h"

#include "base/parallel_for.h"
#include "base/parallel_reduce.h"
#include "cases/case_table.h"
#include "classify/gpu_points.h"
#include "gpu/upload.h"
#include "grid/shown_value.h"
#include "mesh/mesh_records.h"
#include "shared/classify_types.h"
#include "shared/slice_types.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace vp::classify
{

namespace
{

// The shader reads the ids of the grid's own records.
static_assert(shared::kShapeMark == grid::UnstructuredGrid::kShapeMark);
static_assert(static_cast<int>(grid::CellShape::hexahedron) == 3 && static_cast<int>(grid::CellShape::wedge) == 2 &&
              static_cast<int>(grid::CellShape::pyramid) == 1);

using Texel = std::array<std::uint32_t, 4>;
using Tuple = std::array<float, 4>;

// Points per task: some 100 us of work.
constexpr std::size_t kGrain = 16384;

// Makes an array of `count` elements. write(i, destination) writes element i.
template <class Element, class Write>
Result<gpu::ShaderArray> makeArray(gpu::Device& device, std::size_t count, VkFormat format, std::string_view name,
                                   Write&& write)
{
	const std::size_t bytes = std::max<std::size_t>(count, 1) * sizeof(Element);
	Result<gpu::ShaderArray> array =
	    gpu::ShaderArray::create(device, bytes, format, gpu::Memory::device, name, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
	if (!array)
		return array.error();
	const auto fill = [&](std::byte* destination, std::size_t first, std::size_t run)
	{
		auto* elements = reinterpret_cast<Element*>(destination);
		tracedFor(tbb::blocked_range<std::size_t>(0, run, kGrain),
		          [&](const tbb::blocked_range<std::size_t>& range)
		          {
			          for (std::size_t i = range.begin(); i < range.end(); ++i)
				          write(first + i, elements[i]);
		          });
	};
	if (Status filled = gpu::fillBuffer(array->buffer(), count, sizeof(Element), fill); !filled)
		return filled.error();
	return array;
}

Box pointBounds(const grid::Points& points)
{
	const auto include = [&](const tbb::blocked_range<std::size_t>& range, Box box)
	{
		for (std::size_t i = range.begin(); i < range.end(); ++i)
			box.include(points[i]);
		return box;
	};
	const auto join = [](Box a, const Box& b)
	{
		a.include(b);
		return a;
	};
	return parallelReduce(points.size(), kGrain, Box{}, include, join);
}

std::uint32_t cellsKind(const grid::AnyGrid& grid)
{
	if (std::holds_alternative<grid::CurvilinearGrid>(grid))
		return shared::kCellsLattice;
	if (const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&grid))
		return unstructured->recordWidth() == 4 ? shared::kCellsRecord4 : shared::kCellsRecord8;
	return shared::kCellsAxes;
}

const grid::Points* coordinatesOf(const grid::AnyGrid& grid)
{
	if (const auto* curvilinear = std::get_if<grid::CurvilinearGrid>(&grid))
		return &curvilinear->coordinates();
	if (const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&grid))
		return &unstructured->coordinates();
	return nullptr;
}

Result<gpu::ShaderArray> uploadPoints(gpu::Device& device, const grid::Points& points, const FixedPoints& fixed,
                                      const std::string& name)
{
	return makeArray<Texel>(device, points.size(), VK_FORMAT_R32G32B32A32_UINT, name,
	                        [&](std::size_t i, Texel& texel)
	                        {
		                        const Vec3 point = points[i];
		                        if (points.isDouble())
		                        {
			                        texel = fixed.pack(point);
			                        return;
		                        }
		                        for (int axis = 0; axis < 3; ++axis)
			                        texel[axis] = std::bit_cast<std::uint32_t>(static_cast<float>(point[axis]));
		                        texel[3] = 0;
	                        });
}

std::uint32_t tupleTexels(int components)
{
	return (static_cast<std::uint32_t>(components) + 3) / 4;
}

} // namespace

std::string whyNotOnDevice(const gpu::Device& device, const GpuLimits& limits, const grid::Block& block)
{
	std::uint64_t most = 0; // elements of one array
	std::uint64_t sum = 0;
	const auto count = [&](std::uint64_t texels)
	{
		most = std::max(most, texels);
		sum += texels;
	};
	if (const grid::Points* points = coordinatesOf(block.grid))
		count(points->size());
	if (const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid))
		count(grid->cellCount() * grid->recordWidth() / 4);
	// Any array may be needed later.
	std::uint64_t values = 0;
	for (const grid::Field& field : block.fields)
		values = std::max<std::uint64_t>(values, field.tuples() * tupleTexels(field.components));
	count(values);

	constexpr std::uint64_t kTexelBytes = sizeof(Texel);
	if (most > limits.elements)
		return fmt::format("an array of {} elements where the device takes {}", most, limits.elements);
	if (kTexelBytes * most > limits.bytes)
		return fmt::format("{} bytes where a buffer of the device holds {}", kTexelBytes * most, limits.bytes);
	if (kTexelBytes * sum > device.memoryLeft())
		return fmt::format("{} bytes where the device has {} left", kTexelBytes * sum, device.memoryLeft());
	return {};
}

Result<std::unique_ptr<GpuBlock>> uploadBlock(gpu::Device& device, const grid::Block& block)
{
	auto made = std::make_unique<GpuBlock>();
	made->cells_kind = cellsKind(block.grid);
	made->bounds = block.bounds;
	if (const grid::Points* points = coordinatesOf(block.grid))
	{
		// The block's bounds would not do: they leave out points without a cell.
		made->bounds = pointBounds(*points);
		made->points_kind = points->isDouble() ? shared::kPointsFixed : shared::kPointsFloat;
		const FixedPoints fixed(made->bounds.empty() ? Box{Vec3(0.0), Vec3(0.0)} : made->bounds);
		made->center = fixed.center();
		made->unit = fixed.unit();
		Result<gpu::ShaderArray> array = uploadPoints(device, *points, fixed, block.name + " points");
		if (!array)
			return array.error();
		made->points = std::move(*array);
	}
	if (const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid))
	{
		const std::size_t parts = grid->recordWidth() / 4;
		const auto part = [&](std::size_t i) { return grid->record(static_cast<CellId>(i / parts)) + 4 * (i % parts); };
		Result<gpu::ShaderArray> array =
		    makeArray<Texel>(device, grid->cellCount() * parts, VK_FORMAT_R32G32B32A32_UINT, block.name + " cells",
		                     [&](std::size_t i, Texel& texel) { std::memcpy(texel.data(), part(i), sizeof(Texel)); });
		if (!array)
			return array.error();
		made->cells = std::move(*array);
	}
	return made;
}

Result<GpuValues> uploadValues(gpu::Device& device, const grid::Block& block, const grid::FieldChoice& choice)
{
	GpuValues made;
	const grid::Field* field = choice.in(block);
	if (!field)
		return made;
	const bool on_points = choice.association == grid::Association::point;
	const bool tuple = choice.component == grid::kMagnitude;
	if (on_points)
		made.kind = tuple ? shared::kValuesPointTuple : shared::kValuesPoint;
	else
		made.kind = tuple ? shared::kValuesCellTuple : shared::kValuesCell;
	made.nearest = field->categorical;
	made.tuple_texels = tupleTexels(field->components);

	const auto upload = [&](const auto& grid)
	{
		const std::size_t count = on_points ? grid.pointCount() : grid.cellCount();
		const auto source = [&](std::size_t i) -> std::size_t
		{ return on_points ? grid.sourcePoint(static_cast<PointId>(i)) : grid.sourceCell(static_cast<CellId>(i)); };
		const std::string name = block.name + " values";
		if (!tuple)
			return makeArray<float>(device, count, VK_FORMAT_R32_SFLOAT, name,
			                        [&](std::size_t i, float& texel)
			                        { texel = mesh::drawnValue(field->value(source(i), choice.component)); });
		const std::size_t width = made.tuple_texels;
		// The shader takes the length of the tuple.
		const auto weight = [&](int c) { return std::sqrt(grid::magnitudeWeight(field->components, c)); };
		return makeArray<Tuple>(device, count * width, VK_FORMAT_R32G32B32A32_SFLOAT, name,
		                        [&](std::size_t i, Tuple& texel)
		                        {
			                        const std::size_t at = source(i / width);
			                        const int first = static_cast<int>(i % width) * 4;
			                        for (int c = 0; c < 4; ++c)
				                        texel[c] =
				                            first + c < field->components
				                                ? mesh::drawnValue(weight(first + c) * field->value(at, first + c))
				                                : 0.0f;
		                        });
	};
	Result<gpu::ShaderArray> array = std::visit(upload, block.grid);
	if (!array)
		return array.error();
	made.array = std::move(*array);
	return made;
}

Result<gpu::ShaderArray> uploadCaseTables(gpu::Device& device)
{
	const std::vector<std::uint32_t> cases = cases::packedCaseTables();
	return makeArray<Texel>(device, cases.size() / 4, VK_FORMAT_R32G32B32A32_UINT, "case tables",
	                        [&](std::size_t i, Texel& texel)
	                        { std::memcpy(texel.data(), &cases[4 * i], sizeof(Texel)); });
}

Result<gpu::ShaderArray> uploadNoValues(gpu::Device& device)
{
	return makeArray<float>(device, 1, VK_FORMAT_R32_SFLOAT, "no values",
	                        [](std::size_t, float& texel) { texel = 0.0f; });
}

} // namespace vp::classify
