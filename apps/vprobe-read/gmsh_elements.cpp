// Gmsh's reference manual, "Node ordering", beside the pictures of VTK's cells.
#include "gmsh_elements.h"

#include <vtkCellType.h>

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
    // Of higher order: only their number of nodes, to get past them.
    {9},
    {10},
    {12},
    {15},
    {15},
    {21},
    {4},
    {5},
    {6},
    {20},
    {35},
    {56},
};

} // namespace

GmshElement gmshElement(std::int64_t type)
{
	return type > 0 && type < static_cast<std::int64_t>(std::size(kElements)) ? kElements[type] : GmshElement{};
}
