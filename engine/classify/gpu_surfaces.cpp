#include "classify/gpu_surfaces.h"

#include "surface/gpu_surface.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace vp::classify
{

namespace
{

// Scalar layout: as the shader has it.
static_assert(offsetof(shared::ClassifySurface, cells_i) == 36 &&
              offsetof(shared::ClassifySurface, coefficient) == 128 && sizeof(shared::ClassifySurface) == 208);

double sumOfSizes(const Vec3& v)
{
	return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

// The quadric's polynomial about `center`, with errors: of the coefficients' rounding to float, of the move, and, with
// the constant, of the CPU that evaluates the polynomial as it was given. Of the last two a sum of a dozen terms is
// wrong by less than 2^-48 of the terms' sizes, which the reach of the points from the quadric's origin bounds.
void describeQuadric(const surface::Quadric& quadric, const Vec3& center, const Vec3& half, shared::ClassifySurface& to)
{
	const Vec3 slope = quadric.gradient(center);
	const Vec3& square = quadric.square();
	const Vec3& mixed = quadric.mixed();
	const std::array<double, shared::kQuadricCoefficients> moved{
	    square.x, square.y, square.z, mixed.x, mixed.y, mixed.z, slope.x, slope.y, slope.z, quadric.height(center)};

	const double reach = sumOfSizes(center - quadric.origin()) + sumOfSizes(half);
	const double slopes = sumOfSizes(quadric.linear()) + 2.0 * (sumOfSizes(square) + sumOfSizes(mixed)) * reach;
	const double heights = std::abs(quadric.constant()) + slopes * reach;
	for (std::size_t i = 0; i < moved.size(); ++i)
	{
		const auto single = static_cast<float>(moved[i]);
		double error = std::abs(moved[i] - single);
		if (i == 9)
			error += 0x1p-48 * heights;
		else if (i >= 6)
			error += 0x1p-48 * slopes;
		to.coefficient[i] = single;
		to.coefficient_error[i] = boundedAbove(error);
	}
}

// Coordinates as they are, or from the center.
void fillCoordinateAxes(const grid::AnyGrid& any, const Vec3& center, std::span<AxisTexel> axes)
{
	const auto fill = [&](const auto& grid)
	{
		if constexpr (requires { grid.coordinate(0, 0u); })
		{
			std::size_t next = 0;
			for (int axis = 0; axis < 3; ++axis)
				for (std::uint32_t i = 0; i < grid.points()[axis]; ++i)
				{
					const auto place = static_cast<float>(grid.coordinate(axis, i) - center[axis]);
					axes[next++] = {std::bit_cast<std::uint32_t>(place), 0, 0, 0};
				}
		}
	};
	std::visit(fill, any);
}

// Where an expression's coordinates count from.
void describeAxes(const surface::Axes& axes, shared::ClassifySurface& to)
{
	to.turned = 1;
	for (int i = 0; i < 3; ++i)
	{
		to.x_axis[i] = static_cast<float>(axes.x[i]);
		to.y_axis[i] = static_cast<float>(axes.y[i]);
		to.z_axis[i] = static_cast<float>(axes.z[i]);
	}
}

// The stored places, plus the shift, are differences from `center`.
void describePlaces(const GpuBlock& block, const Vec3& half, const Vec3& center, shared::ClassifySurface& to)
{
	const bool fixed = block.points && block.points_kind == shared::kPointsFixed;
	for (int axis = 0; axis < 3; ++axis)
	{
		const double from = fixed ? block.center[axis] : 0.0;
		const double shift = block.points ? from - center[axis] : 0.0;
		to.unit[axis] = static_cast<float>(block.unit[axis]);
		to.shift[axis] = static_cast<float>(shift);
		double error = std::abs(shift - to.shift[axis]);
		// The low bits, which are left out, what the source is beside the number, the rounding of the number's
		// conversion and product, and that of the center's sums in double. All else is rounded in proportion to what it
		// gives.
		if (fixed)
			error += 513.0 * block.unit[axis] + 0x1p-22 * half[axis] +
			         0x1p-50 * (std::abs(from) + std::abs(center[axis]) + half[axis]);
		to.place_error[axis] = boundedAbove(error);
	}
}

// Returns the shader's parameters for a surface in a block.
shared::ClassifySurface describeSurface(const grid::Block& block, const GpuBlock& on_device,
                                        const surface::Curved& surface, std::size_t axis_start,
                                        std::span<AxisTexel> axes)
{
	const bool fixed = on_device.points && on_device.points_kind == shared::kPointsFixed;
	const Vec3 half = 0.5 * on_device.bounds.size() + on_device.unit;
	shared::ClassifySurface to{};
	Vec3 center(0.0);
	if (const auto* quadric = std::get_if<surface::Quadric>(&surface))
	{
		// Moved to the block's middle, where floats lose least.
		center = fixed ? on_device.center : Vec3(Vec3f(on_device.bounds.center()));
		describeQuadric(*quadric, center, half, to);
	}
	else if (const auto& placed = std::get<surface::PlacedExpression>(surface); placed.isMoved())
	{
		center = placed.axes().origin;
		describeAxes(placed.axes(), to);
	}
	describePlaces(on_device, half, center, to);
	describeCells(block.grid, axis_start, to);
	fillCoordinateAxes(block.grid, center, axes);
	return to;
}

} // namespace

Result<std::vector<GpuSheetInBlock>> surfaceOnGpu(GpuBlocks& blocks, std::span<const surface::BlockSurface> surfaces)
{
	std::vector<GpuSheetInBlock> made(surfaces.size());
	for (std::size_t b = 0; b < surfaces.size(); ++b)
	{
		made[b].block = b;
		const std::optional<surface::Curved> surface = surface::gpuSurfaceOf(surfaces[b]);
		if (!surface || !blocks.holds(b))
			continue;
		const GpuBlock& block = blocks.block(b);
		const auto* placed = std::get_if<surface::PlacedExpression>(&*surface);
		auto pipeline = blocks.surfacePipelines().get(block.cells_kind, block.points_kind,
		                                              placed ? &placed->expression() : nullptr, blocks.cases());
		if (!pipeline)
			return pipeline.error();
		made[b].pipeline = std::move(*pipeline);
		made[b].describe =
		    [&blocks, b, surface = *surface](std::size_t axis_start, std::span<AxisTexel> axes, std::byte* told)
		{
			const shared::ClassifySurface described =
			    describeSurface(blocks.blocks().blocks[b], blocks.block(b), surface, axis_start, axes);
			std::memcpy(told, &described, sizeof(described));
		};
	}
	return made;
}

} // namespace vp::classify
