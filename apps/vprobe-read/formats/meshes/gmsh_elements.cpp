// Gmsh's reference manual, "Node ordering", beside the pictures of VTK's cells.
#include "gmsh_elements.h"

#include <vtkCellType.h>

#include <algorithm>

namespace vp::reader::meshes
{

namespace
{

constexpr std::uint8_t kWedge6[] = {3, 4, 5, 0, 1, 2}; // VTK's base is seen from outside
constexpr std::uint8_t kTetra10[] = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
constexpr std::uint8_t kHexahedron27[] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  11, 13, 9,  16, 18,
                                          19, 17, 10, 12, 14, 15, 22, 23, 21, 24, 20, 25, 26};
constexpr std::uint8_t kWedge18[] = {0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11, 15, 17, 16};
constexpr std::uint8_t kPyramid13[] = {0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12};

constexpr GmshElement kElements[] = {
    {},
    {2, 2, VTK_LINE},
    {3, 3, VTK_TRIANGLE},
    {4, 4, VTK_QUAD},
    {4, 4, VTK_TETRA},
    {8, 8, VTK_HEXAHEDRON},
    {6, 6, VTK_WEDGE, kWedge6},
    {5, 5, VTK_PYRAMID},
    {3, 3, VTK_QUADRATIC_EDGE},
    {6, 6, VTK_QUADRATIC_TRIANGLE},
    {9, 9, VTK_BIQUADRATIC_QUAD},
    {10, 10, VTK_QUADRATIC_TETRA, kTetra10},
    {27, 27, VTK_TRIQUADRATIC_HEXAHEDRON, kHexahedron27},
    {18, 18, VTK_BIQUADRATIC_QUADRATIC_WEDGE, kWedge18},
    {14, 13, VTK_QUADRATIC_PYRAMID, kPyramid13}, // VTK has none with a node in its base
    {1, 1, VTK_VERTEX},
    {8, 8, VTK_QUADRATIC_QUAD},
    {20, 20, VTK_QUADRATIC_HEXAHEDRON, kHexahedron27},
    {15, 15, VTK_QUADRATIC_WEDGE, kWedge18},
    {13, 13, VTK_QUADRATIC_PYRAMID, kPyramid13},
};

// An element of higher order: only its number of nodes is known, to get past it.
struct GmshHigher
{
	std::int64_t type;
	int nodes;
	std::string_view name{};
};

constexpr GmshHigher kHigher[] = {
    {20, 9},
    {21, 10},
    {22, 12},
    {23, 15},
    {24, 15},
    {25, 21},
    {26, 4},
    {27, 5},
    {28, 6},
    {29, 20, "tetrahedra of order 3"},
    {30, 35, "tetrahedra of order 4"},
    {31, 56, "tetrahedra of order 5"},
    {32, 22, "tetrahedra of order 4"},
    {33, 28, "tetrahedra of order 5"},
    {36, 16},
    {37, 25},
    {38, 36},
    {39, 12},
    {40, 16},
    {41, 20},
    {71, 84, "tetrahedra of order 6"},
    {90, 40, "prisms of order 3"},
    {91, 75, "prisms of order 4"},
    {92, 64, "hexahedra of order 3"},
    {93, 125, "hexahedra of order 4"},
    {106, 126, "prisms of order 5"},
    {118, 30, "pyramids of order 3"},
    {119, 55, "pyramids of order 4"},
    {120, 91, "pyramids of order 5"},
    {137, 16, "tetrahedra of order 3"},
};

} // namespace

GmshElement gmshElement(std::int64_t type)
{
	if (type > 0 && type < static_cast<std::int64_t>(std::size(kElements)))
		return kElements[type];
	const auto higher = std::ranges::find(kHigher, type, &GmshHigher::type);
	return higher == std::end(kHigher) ? GmshElement{} : GmshElement{higher->nodes};
}

std::string_view gmshNameOf(std::int64_t type)
{
	const auto higher = std::ranges::find(kHigher, type, &GmshHigher::type);
	return higher == std::end(kHigher) ? std::string_view() : higher->name;
}

} // namespace vp::reader::meshes
