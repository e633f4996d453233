#include "unit_cube.h"

#include <initializer_list>
#include <stdexcept>

using vp::Vec3;

std::vector<CellFrame> unitCubeCells(ParentShape shape)
{
	const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), zero(0, 0, 0);
	switch (shape)
	{
	case ParentShape::hexahedron:
		return {{zero, x, y, z}};
	case ParentShape::wedge:
		return {{zero, x, x + y, z}, {zero, x + y, y, z}};
	case ParentShape::pyramid:
	{
		std::vector<CellFrame> frames;
		for (const auto& [origin, a, b, up] : std::initializer_list<CellFrame>{
		         {zero, x, y, z}, {z, y, x, -z}, {zero, y, z, x}, {x, z, y, -x}, {zero, z, x, y}, {y, x, z, -y}})
			frames.push_back({origin, a, b, 0.5 * up});
		return frames;
	}
	case ParentShape::tetrahedron:
		return {{zero, x, x + y, x + y + z}, {zero, x + y, y, x + y + z}, {zero, y, y + z, x + y + z},
		        {zero, y + z, z, x + y + z}, {zero, z, x + z, x + y + z}, {zero, x + z, x, x + y + z}};
	}
	throw std::logic_error("no such shape");
}
