#include "cell_kinds.h"
#include "wrap_data.h"

#include <vtkCellType.h>
#include <vtkDataSet.h>

#include <algorithm>
#include <array>
#include <string>

namespace vprobe_paraview
{

namespace
{

bool isVolume(int type)
{
	switch (type)
	{
	case VTK_TETRA:
	case VTK_VOXEL:
	case VTK_HEXAHEDRON:
	case VTK_WEDGE:
	case VTK_PYRAMID:
	case VTK_PENTAGONAL_PRISM:
	case VTK_HEXAGONAL_PRISM:
	case VTK_POLYHEDRON:
		return true;
	default:
		return false;
	}
}

// Cells of points, lines and surfaces, straight or curved.
bool isFlat(int type)
{
	constexpr std::array<std::array<int, 2>, 9> kFlat{{{VTK_EMPTY_CELL, VTK_QUAD},
	                                                   {VTK_QUADRATIC_EDGE, VTK_QUADRATIC_QUAD},
	                                                   {VTK_BIQUADRATIC_QUAD, VTK_BIQUADRATIC_QUAD},
	                                                   {VTK_QUADRATIC_LINEAR_QUAD, VTK_QUADRATIC_LINEAR_QUAD},
	                                                   {VTK_BIQUADRATIC_TRIANGLE, VTK_QUADRATIC_POLYGON},
	                                                   {VTK_PARAMETRIC_CURVE, VTK_PARAMETRIC_QUAD_SURFACE},
	                                                   {VTK_HIGHER_ORDER_EDGE, VTK_HIGHER_ORDER_POLYGON},
	                                                   {VTK_LAGRANGE_CURVE, VTK_LAGRANGE_QUADRILATERAL},
	                                                   {VTK_BEZIER_CURVE, VTK_BEZIER_QUADRILATERAL}}};
	return std::ranges::any_of(kFlat, [&](const auto& range) { return type >= range[0] && type <= range[1]; });
}

// Cells that the library refines to a tolerance.
bool isRefined(int type)
{
	switch (type)
	{
	case VTK_QUADRATIC_TETRA:
	case VTK_QUADRATIC_HEXAHEDRON:
	case VTK_QUADRATIC_WEDGE:
	case VTK_QUADRATIC_PYRAMID:
	case VTK_TRIQUADRATIC_HEXAHEDRON:
	case VTK_QUADRATIC_LINEAR_WEDGE:
	case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
	case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
	case VTK_LAGRANGE_TETRAHEDRON:
	case VTK_LAGRANGE_HEXAHEDRON:
	case VTK_LAGRANGE_WEDGE:
	case VTK_BEZIER_TETRAHEDRON:
	case VTK_BEZIER_HEXAHEDRON:
	case VTK_BEZIER_WEDGE:
		return true;
	default:
		return false;
	}
}

} // namespace

std::bitset<256> typesIn(const vprobe::Numbers& types)
{
	const auto* begin = static_cast<const unsigned char*>(types.data);
	// Mostly all cells are of one type, which one pass tells in no time.
	std::bitset<256> present;
	if (std::all_of(begin, begin + types.size, [&](unsigned char type) { return type == *begin; }))
		return present.set(*begin);
	std::array<bool, 256> seen{};
	for (std::size_t c = 0; c < types.size; ++c)
		seen[begin[c]] = true;
	for (std::size_t type = 0; type < seen.size(); ++type)
		present[type] = seen[type];
	return present;
}

void refuseOtherTypes(vtkDataSet& data, const std::bitset<256>& present, double tolerance)
{
	bool has_volume = false, are_refined = true;
	std::string others;
	for (int type = 0; type < 256; ++type)
	{
		if (!present[static_cast<std::size_t>(type)] || isFlat(type))
			continue;
		has_volume = true;
		if (type == VTK_CONVEX_POINT_SET)
			throw Refused("cells of type 41 are sets of points without faces; apply the filter Tetrahedralize first");
		if (isVolume(type) || (isRefined(type) && tolerance > 0.0))
			continue;
		are_refined = are_refined && isRefined(type);
		others += (others.empty() ? "" : ", ") + std::to_string(type);
	}
	if (!others.empty())
		throw Refused("cells of type " + others + " are curved; " + (are_refined ? "set Tolerance, or " : "") +
		              "apply the filter Tessellate first");
	if (!has_volume)
		throw NoVolume(std::string("a ") + data.GetClassName() +
		               " without cells that have a volume; apply Slice to it");
}

} // namespace vprobe_paraview
