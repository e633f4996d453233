#include "slice/gpu_surface_lane.h"

#include <bit>
#include <cmath>
#include <cstddef>

namespace vp::slice
{

namespace
{

// Scalar layout: as the shader has it.
static_assert(offsetof(shared::SurfaceLane, cells_i) == 36 && offsetof(shared::SurfaceLane, coefficient) == 88 &&
              sizeof(shared::SurfaceLane) == 168);

Vec3 rounded(const Vec3& v)
{
	return Vec3(Vec3f(v));
}

double sumOfSizes(const Vec3& v)
{
	return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

// The same polynomial in p - to.
Polynomial movedTo(const Vec3& to, const Polynomial& from)
{
	const auto& c = from.coefficient;
	const Vec3 linear(c[1], c[2], c[3]);
	const Vec3 squares(c[4], c[5], c[6]);
	const Vec3 mixed(c[7], c[8], c[9]); // xy, yz, zx
	const Vec3 m = to - from.origin;
	const Vec3 crossed(mixed.x * m.y + mixed.z * m.z, mixed.x * m.x + mixed.y * m.z, mixed.y * m.y + mixed.z * m.x);
	const Vec3 slope = linear + 2.0 * squares * m + crossed;
	const double value = c[0] + glm::dot(linear, m) + glm::dot(squares, m * m) + 0.5 * glm::dot(crossed, m);
	return {to, {value, slope.x, slope.y, slope.z, c[4], c[5], c[6], c[7], c[8], c[9]}};
}

// The coefficients about `centre`, with errors: of their rounding to float, of the move, and, with the constant, of the
// CPU that evaluates the polynomial as it was given. Of the last two a sum of a dozen terms is wrong by less than 2^-48
// of the terms' sizes, which the reach of the points from the polynomial's origin bounds.
void describePolynomial(const Polynomial& given, const Vec3& centre, const Vec3& half, shared::SurfaceLane& lane)
{
	const Polynomial here = movedTo(centre, given);
	const auto& c = given.coefficient;
	const double reach = sumOfSizes(centre - given.origin) + sumOfSizes(half);
	const double linear = std::abs(c[1]) + std::abs(c[2]) + std::abs(c[3]);
	double squares = 0.0;
	for (int i = 4; i < 10; ++i)
		squares += std::abs(c[i]);
	const double sizes = std::abs(c[0]) + (linear + squares * reach) * reach;
	for (std::size_t i = 0; i < here.coefficient.size(); ++i)
	{
		const auto single = static_cast<float>(here.coefficient[i]);
		double error = std::abs(here.coefficient[i] - single);
		if (i == 0)
			error += 0x1p-48 * sizes;
		else if (i < 4)
			error += 0x1p-48 * (linear + squares * reach);
		lane.coefficient[i] = single;
		lane.coefficient_error[i] = boundedAbove(error);
	}
}

// Coordinates as they are, or from the centre.
void fillAxes(const grid::AnyGrid& any, const Vec3& centre, std::span<AxisTexel> axes)
{
	const auto fill = [&](const auto& grid)
	{
		if constexpr (requires { grid.coordinate(0, 0u); })
		{
			std::size_t next = 0;
			for (int axis = 0; axis < 3; ++axis)
				for (std::uint32_t i = 0; i < grid.points()[axis]; ++i)
				{
					const auto place = static_cast<float>(grid.coordinate(axis, i) - centre[axis]);
					axes[next++] = {std::bit_cast<std::uint32_t>(place), 0, 0, 0};
				}
		}
	};
	std::visit(fill, any);
}

} // namespace

shared::SurfaceLane describeSurfaceLane(const grid::Block& block, const GpuBlock& on_device, const GpuSurface& surface,
                                        std::size_t axis_start, std::span<AxisTexel> axes)
{
	const bool fixed = on_device.points && on_device.points_kind == shared::kPointsFixed;
	const Box& bounds = on_device.bounds;
	const Vec3 half = 0.5 * bounds.size() + on_device.unit;
	// An expression is of the coordinates themselves; a polynomial is moved to the block's middle, where floats lose
	// least.
	Vec3 centre(0.0);
	if (!surface.expression)
		centre = fixed ? on_device.centre : rounded(bounds.centre());

	shared::SurfaceLane lane{};
	describeCells(block.grid, axis_start, lane);
	fillAxes(block.grid, centre, axes);
	for (int axis = 0; axis < 3; ++axis)
	{
		double error = 0.0;
		lane.unit[axis] = static_cast<float>(on_device.unit[axis]);
		if (fixed)
		{
			// The low bits, which are left out, what the source is beside the number, and the rounding of the number's
			// conversion and product.
			const double shift = on_device.centre[axis] - centre[axis];
			lane.shift[axis] = static_cast<float>(shift);
			error = 513.0 * on_device.unit[axis] + 0x1p-22 * half[axis] + std::abs(shift - lane.shift[axis]);
		}
		else if (on_device.points)
			lane.shift[axis] = static_cast<float>(-centre[axis]);
		else if (!surface.expression) // the difference's rounding in double
			error = 0x1p-51 * (std::abs(centre[axis]) + half[axis]);
		lane.place_error[axis] = boundedAbove(error);
	}
	if (!surface.expression)
		describePolynomial(surface.polynomial, centre, half, lane);
	return lane;
}

} // namespace vp::slice
