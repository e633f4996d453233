#include "slice/gpu_upload.h"

#include "cases/case_table.h"
#include "gpu/upload.h"
#include "slice/gpu_points.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace vp::slice
{

namespace
{

constexpr VkBufferUsageFlags kTexels = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;

// Points per task: some 100 us of work.
constexpr std::size_t kGrain = 16384;

template <class Body>
void inParallel(std::size_t count, Body&& body)
{
	tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain),
	                  [&](const tbb::blocked_range<std::size_t>& range)
	                  {
		                  for (std::size_t i = range.begin(); i < range.end(); ++i)
			                  body(i);
	                  });
}

// A texel buffer of `count` elements, element i written by write(i, destination).
template <class Element, class Write>
Status makeTexels(gpu::Device& device, std::size_t count, VkFormat format, std::string_view name, gpu::Buffer& buffer,
                  gpu::TexelView& view, Write&& write)
{
	const std::size_t bytes = std::max<std::size_t>(count, 1) * sizeof(Element);
	Result<gpu::Buffer> made =
	    gpu::Buffer::create(device, bytes, kTexels | VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::Memory::device, name);
	if (!made)
		return made.error();
	Status filled = gpu::fillBuffer(*made, count, sizeof(Element),
	                                [&](std::byte* destination, std::size_t first, std::size_t run)
	                                {
		                                auto* elements = reinterpret_cast<Element*>(destination);
		                                inParallel(run, [&](std::size_t i) { write(first + i, elements[i]); });
	                                });
	if (!filled)
		return filled;
	Result<gpu::TexelView> texels = gpu::TexelView::create(*made, format, name);
	if (!texels)
		return texels.error();
	buffer = std::move(*made);
	view = std::move(*texels);
	return Nothing{};
}

Box boundsOf(const grid::Points& points)
{
	return tbb::parallel_reduce(
	    tbb::blocked_range<std::size_t>(0, points.size(), kGrain), Box{},
	    [&](const tbb::blocked_range<std::size_t>& range, Box box)
	    {
		    for (std::size_t i = range.begin(); i < range.end(); ++i)
			    box.include(points[i]);
		    return box;
	    },
	    [](Box a, const Box& b)
	    {
		    a.include(b);
		    return a;
	    });
}

std::uint32_t cellsKind(const grid::UniformGrid&)
{
	return shared::kCellsAxes;
}
std::uint32_t cellsKind(const grid::RectilinearGrid&)
{
	return shared::kCellsAxes;
}
std::uint32_t cellsKind(const grid::CurvilinearGrid&)
{
	return shared::kCellsLattice;
}
std::uint32_t cellsKind(const grid::UnstructuredGrid& grid)
{
	return grid.recordWidth() == 4 ? shared::kCellsRecord4 : shared::kCellsRecord8;
}

const grid::Points* coordinatesOf(const grid::AnyGrid& grid)
{
	if (const auto* curvilinear = std::get_if<grid::CurvilinearGrid>(&grid))
		return &curvilinear->coordinates();
	if (const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&grid))
		return &unstructured->coordinates();
	return nullptr;
}

// Infinite data would overrun the marks for NaN and for an empty pixel.
constexpr double kLargestValue = 2.0e38;

float shownValue(double value)
{
	return std::isnan(value) ? shared::kNanValue : static_cast<float>(std::clamp(value, -kLargestValue, kLargestValue));
}

} // namespace

std::string GpuLimits::refuse(const gpu::Device& device, std::uint64_t texels_wanted, std::uint64_t bytes_wanted) const
{
	if (texels_wanted > texels)
		return fmt::format("{} texels where the device takes {}", texels_wanted, texels);
	if (bytes_wanted > bytes)
		return fmt::format("{} bytes where a buffer of the device holds {}", bytes_wanted, bytes);
	if (bytes_wanted > device.memoryLeft())
		return fmt::format("{} bytes where the device has {} left", bytes_wanted, device.memoryLeft());
	return {};
}

std::string GpuLimits::refuse(const gpu::Device& device, const grid::Block& block) const
{
	constexpr std::uint64_t kTexelBytes = 16;
	std::uint64_t most = 0;
	if (const grid::Points* points = coordinatesOf(block.grid))
		most = points->size();
	if (const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid))
		most = std::max<std::uint64_t>(most, grid->records().size() / 4);
	return refuse(device, most, kTexelBytes * most);
}

Result<std::unique_ptr<GpuBlock>> uploadBlock(gpu::Device& device, const grid::Block& block)
{
	using Texel = std::array<std::uint32_t, 4>;
	auto made = std::make_unique<GpuBlock>();
	made->cells_kind = std::visit([](const auto& grid) { return cellsKind(grid); }, block.grid);
	made->bounds = block.bounds;
	if (const grid::Points* points = coordinatesOf(block.grid))
	{
		// Not the block's bounds, which may leave out points of no cell.
		made->bounds = boundsOf(*points);
		made->points_kind = points->isDouble() ? shared::kPointsFixed : shared::kPointsFloat;
		const FixedPoints fixed(made->bounds.empty() ? Box{Vec3(0.0), Vec3(0.0)} : made->bounds);
		made->centre = fixed.centre();
		made->unit = fixed.unit();
		const auto write = [&](std::size_t i, Texel& texel)
		{
			const Vec3 point = (*points)[i];
			if (points->isDouble())
				texel = fixed.pack(point);
			else
				for (int axis = 0; axis < 3; ++axis)
					texel[axis] = std::bit_cast<std::uint32_t>(static_cast<float>(point[axis]));
		};
		if (Status done = makeTexels<Texel>(device, points->size(), VK_FORMAT_R32G32B32A32_UINT,
		                                    block.name + " points", made->points, made->point_texels, write);
		    !done)
			return done.error();
	}
	if (const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid))
	{
		const std::vector<std::uint32_t>& ids = grid->records();
		if (Status done = makeTexels<Texel>(device, ids.size() / 4, VK_FORMAT_R32G32B32A32_UINT, block.name + " cells",
		                                    made->cells, made->cell_texels,
		                                    [&](std::size_t i, Texel& texel)
		                                    { std::memcpy(texel.data(), &ids[4 * i], sizeof(Texel)); });
		    !done)
			return done.error();
	}
	return made;
}

Result<GpuValues> uploadValues(gpu::Device& device, const GpuLimits& limits, const grid::Block& block, const FieldChoice& choice)
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
	made.components = tuple ? static_cast<std::uint32_t>(field->components) : 1;
	const int first = tuple ? 0 : choice.component;
	const auto upload = [&](const auto& grid) -> Status
	{
		const std::size_t tuples = on_points ? grid.pointCount() : grid.cellCount();
		std::string why;
		if (!fits(tuples * made.components, tuples * made.components * 4, why))
			return Error{ExitCode::output,
			             fmt::format("array {} of block {} does not fit the device: {}; use --classify cpu",
			                         field->name, block.name, why)};
		return makeTexels<float>(
		    device, tuples * made.components, VK_FORMAT_R32_SFLOAT, block.name + " values", made.buffer, made.texels,
		    [&](std::size_t i, float& texel)
		    {
			    const std::size_t number = i / made.components;
			    const std::size_t source = on_points ? grid.sourcePoint(static_cast<PointId>(number))
			                                         : grid.sourceCell(static_cast<CellId>(number));
			    texel = shownValue(field->value(source, first + static_cast<int>(i - number * made.components)));
		    });
	};
	if (Status done = std::visit(upload, block.grid); !done)
		return done.error();
	return made;
}

} // namespace vp::slice
