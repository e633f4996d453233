#include "grid/grid.h"

namespace vp::grid
{

void shapeFaces(CellShape shape, const CellPoints& points, CellFaces& faces)
{
	const ShapeTopology& shape_topology = topology(shape);
	std::array<PointId, 4> face;
	for (int f = 0; f < shape_topology.faces; ++f)
	{
		const std::span<const std::uint8_t> corners = shape_topology.facePoints(f);
		for (std::size_t i = 0; i < corners.size(); ++i)
			face[i] = points.id[corners[i]];
		faces.add({face.data(), corners.size()});
	}
}

} // namespace vp::grid
