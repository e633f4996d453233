#include "grid/curved/curved_types.h"

#include <algorithm>

namespace vp::grid
{

CellShape cornerShape(std::uint8_t type)
{
	switch (type)
	{
	case kQuadraticTetra:
	case kLagrangeTetra:
	case kBezierTetra:
		return CellShape::tetrahedron;
	case kQuadraticHexahedron:
	case kTriQuadraticHexahedron:
	case kBiQuadraticQuadraticHexahedron:
	case kLagrangeHexahedron:
	case kBezierHexahedron:
		return CellShape::hexahedron;
	case kQuadraticWedge:
	case kQuadraticLinearWedge:
	case kBiQuadraticQuadraticWedge:
	case kLagrangeWedge:
	case kBezierWedge:
		return CellShape::wedge;
	case kQuadraticPyramid:
		return CellShape::pyramid;
	default:
		return shapeOf(type);
	}
}

std::uint8_t linearType(CellShape shape)
{
	switch (shape)
	{
	case CellShape::tetrahedron:
		return kTetra;
	case CellShape::pyramid:
		return kPyramid;
	case CellShape::wedge:
		return kWedge;
	default:
		return kHexahedron;
	}
}

int fixedNodes(std::uint8_t type)
{
	switch (type)
	{
	case kQuadraticTetra:
		return 10;
	case kQuadraticHexahedron:
		return 20;
	case kQuadraticWedge:
		return 15;
	case kQuadraticPyramid:
		return 13;
	case kTriQuadraticHexahedron:
		return 27;
	case kQuadraticLinearWedge:
		return 12;
	case kBiQuadraticQuadraticWedge:
		return 18;
	case kBiQuadraticQuadraticHexahedron:
		return 24;
	default:
		return 0;
	}
}

std::size_t nodesOf(std::uint8_t type, const std::array<int, 3>& degrees)
{
	if (std::ranges::any_of(degrees, [](int degree) { return degree < 1 || degree > kMaxDegree; }))
		return 0;
	const CellShape shape = cornerShape(type);
	if (shape != CellShape::hexahedron && degrees[0] != degrees[1])
		return 0;
	const std::size_t a = static_cast<std::size_t>(degrees[0]) + 1;
	const std::size_t b = static_cast<std::size_t>(degrees[1]) + 1;
	const std::size_t c = static_cast<std::size_t>(degrees[2]) + 1;
	if (shape == CellShape::tetrahedron)
		return degrees[0] == degrees[2] ? a * (a + 1) * (a + 2) / 6 : 0;
	return shape == CellShape::hexahedron ? a * b * c : a * (a + 1) / 2 * c;
}

std::optional<int> degreeOf(std::uint8_t type, std::size_t nodes)
{
	for (int degree = 1; degree <= kMaxDegree; ++degree)
		if (nodesOf(type, {degree, degree, degree}) == nodes)
			return degree;
	return std::nullopt;
}

} // namespace vp::grid
