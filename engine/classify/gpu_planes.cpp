#include "classify/gpu_planes.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace vp::classify
{

namespace
{

// Scalar layout: as the shader has it.
static_assert(offsetof(shared::ClassifyPlane, unit) == 72 && offsetof(shared::ClassifyPlane, error) == 156);

void setHalves(shared::uint* halves, const Vec3& v)
{
	for (int axis = 0; axis < 3; ++axis)
	{
		const auto bits = std::bit_cast<std::uint64_t>(v[axis]);
		halves[2 * axis] = static_cast<std::uint32_t>(bits);
		halves[2 * axis + 1] = static_cast<std::uint32_t>(bits >> 32);
	}
}

void setSingle(float* single, const Vec3& v)
{
	for (int axis = 0; axis < 3; ++axis)
		single[axis] = static_cast<float>(v[axis]);
}

// A bound of |d_here - d_cpu| at a point whose distance d is not exactly the CPU's, d = sum n_i (p_i - o_i). With c the
// center and h the half size of the points, r_i = |c_i - o_i| + h_i bounds |p_i - o_i|. e is the rounding of one
// operation. Vulkan promises that a sum, a product or a conversion is one of the two nearest numbers, not which of
// them ("Precision and Operation of SPIR-V Instructions"):
//
// Doubles, e = 2^-53 since only exact ones are used (Device::hasExactDoubles), fixed-point numbers of unit u: the
// number is off by at most u_i / 2, unpacking adds e |p_i|, and packing e h_i. On each side the difference, the product
// and two sums round once, in all 8 e r_i; twice that is granted.
//
// Floats, e = 2^-23: the number is off by 2^9 u_i <= 2^-29 h_i, its conversion by e h_i, the difference (its two steps
// for float points) by 2 e r_i, the normal by e r_i / 2, product and two sums by 3 e r_i, and the low part of the
// origin by e^2 |o_i| at most: less than 7 e r_i + 2^-46 |o_i|. 8 e r_i is granted, for products of roundings and for
// numbers below 2^-126, which may become 0.
double distanceError(const GpuBlock& block, const Vec3& normal, const Vec3& origin, bool doubles)
{
	double bound = 0.0;
	for (int axis = 0; axis < 3; ++axis)
	{
		const double center = std::abs(block.center[axis]);
		const double half = 0.5 * block.bounds.size()[axis] + block.unit[axis];
		const double reach = std::abs(block.center[axis] - origin[axis]) + half;
		const double error = doubles ? 0.5 * block.unit[axis] + 0x1p-52 * (center + half) + 0x1p-49 * reach
		                             : 0x1p-20 * reach + 0x1p-46 * std::abs(origin[axis]);
		bound += std::abs(normal[axis]) * error;
	}
	return bound;
}

// With distances off by at most E each, a vertex moves along its edge by at most 2 E / |d0 - d1| of the edge: 1e-3 with
// doubles. Floats cannot keep that on fine grids; there the bound, which is ten times what occurs, keeps 1/32.
constexpr double kMinDifferenceDoubles = 2000.0;
constexpr double kMinDifferenceSingles = 64.0;

template <class Lattice>
double fillPlaneAxes(const Lattice& grid, const surface::Plane& plane, const probe::Sheet& sheet, bool doubles,
                     std::span<AxisTexel> axes)
{
	const Vec3 x_axis = sheet.xAxis();
	std::size_t next = 0;
	double error = 0.0;
	for (int axis = 0; axis < 3; ++axis)
	{
		double largest = 0.0;
		for (std::uint32_t i = 0; i < grid.points()[axis]; ++i)
		{
			const double from_origin = grid.coordinate(axis, i) - plane.origin()[axis];
			// One of the three terms that surface::Plane::signedDistance() adds.
			const double share = plane.normal()[axis] * from_origin;
			largest = std::max(largest, std::abs(share));
			const auto bits = doubles ? std::bit_cast<std::uint64_t>(share)
			                          : std::uint64_t(std::bit_cast<std::uint32_t>(static_cast<float>(share)));
			axes[next++] = {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32),
			                std::bit_cast<std::uint32_t>(static_cast<float>(x_axis[axis] * from_origin)),
			                std::bit_cast<std::uint32_t>(static_cast<float>(sheet.up[axis] * from_origin))};
		}
		// Floats: the share's rounding on the CPU, 2^-24, and those of two sums on the device, 2^-23 each. 2^-21 is
		// granted.
		error += 0x1p-21 * largest;
	}
	return error;
}

// Returns the shader's parameters for a plane in a block.
shared::ClassifyPlane describePlane(const grid::Block& block, const GpuBlock& on_device, const GpuValues& values,
                                    bool field_chosen, bool doubles, const probe::Sheet& sheet, std::size_t axis_start,
                                    std::span<AxisTexel> axes)
{
	const surface::Plane plane = sheet.plane();
	const Vec3& normal = plane.normal();
	const Vec3& origin = plane.origin();
	shared::ClassifyPlane to{};
	setHalves(to.normal, normal);
	setHalves(to.origin, origin);
	setHalves(to.center, on_device.center);
	setSingle(to.unit, on_device.unit);
	setSingle(to.single_normal, normal);
	setSingle(to.single_center, on_device.center - origin);
	setSingle(to.single_origin_hi, origin);
	setSingle(to.single_origin_lo, origin - Vec3(Vec3f(origin)));
	setSingle(to.x_axis, sheet.xAxis());
	setSingle(to.y_axis, sheet.up);

	double error = distanceError(on_device, normal, origin, doubles);
	describeCells(block.grid, axis_start, to);
	std::visit(
	    [&](const auto& grid)
	    {
		    if constexpr (requires { grid.coordinate(0, 0u); })
			    error = fillPlaneAxes(grid, plane, sheet, doubles, axes);
	    },
	    block.grid);

	to.error = boundedAbove(error);
	to.least_difference = boundedAbove(error * (doubles ? kMinDifferenceDoubles : kMinDifferenceSingles));
	for (int axis = 0; axis < 3; ++axis)
		if (normal[axis] != 0.0)
			to.inexact_mask |= 1u << (shared::kFixedInexactShift + axis);
	to.nearest = values.nearest;
	to.tuple_texels = values.tuple_texels;
	// Without an array there is nothing to miss; a block that lacks the shown array has no value there.
	to.no_value = field_chosen ? shared::kNanValue : 0.0f;
	to.flipped = glm::dot(normal, sheet.normal) < 0.0;
	return to;
}

GpuSheetInBlock planeInBlock(GpuBlocks& blocks, std::size_t b, const probe::Sheet& sheet,
                             const std::shared_ptr<const GpuField>& field, const std::shared_ptr<SheetRecords>& records)
{
	GpuSheetInBlock made;
	made.block = b;
	if (!blocks.holds(b))
		return made;
	const GpuValues& values = field->blocks[b];
	made.pipeline = blocks.pipeline(blocks.block(b), values);
	made.values = values.array.place();
	made.keeps = field;
	made.records = records;
	made.describe = [&blocks, b, sheet, field](std::size_t axis_start, std::span<AxisTexel> axes, std::byte* told)
	{
		const shared::ClassifyPlane described =
		    describePlane(blocks.blocks().blocks[b], blocks.block(b), field->blocks[b], field->choice.has_value(),
		                  blocks.usesDoubles(), sheet, axis_start, axes);
		std::memcpy(told, &described, sizeof(described));
	};
	return made;
}

} // namespace

Result<PlanesOnGpu> planesOnGpu(GpuBlocks& blocks, std::span<const probe::Sheet> sheets,
                                std::span<const std::optional<grid::FieldChoice>> fields)
{
	Result<GpuBlocks::Fields> values = blocks.fields(fields);
	if (!values)
		return values.error();
	const bool overlapping = mayOverlap(blocks.blocks());
	PlanesOnGpu made;
	for (std::size_t s = 0; s < sheets.size(); ++s)
	{
		made.records.push_back(std::make_shared<SheetRecords>(blocks.recordPool()));
		made.records.back()->overlapping = overlapping;
		for (std::size_t b = 0; b < blocks.blocks().blocks.size(); ++b)
			made.sheets.push_back(planeInBlock(blocks, b, sheets[s], (*values)[s], made.records.back()));
	}
	return made;
}

} // namespace vp::classify
