#include "vectors/trace_mesh.h"

#include <array>
#include <cmath>

namespace vp::vectors
{

void addRibbons(const Curves& curves, std::span<const double> values, double width, const Vec3& wished,
                std::span<const double> turns, TraceMesh& mesh)
{
	for (std::size_t c = 0; c < curves.count(); ++c)
	{
		const std::vector<Vec3> across = directionsAcross(curves, c, wished);
		for (std::size_t i = curves.starts[c]; i < curves.starts[c + 1]; ++i)
		{
			const Vec3 x = across[i - curves.starts[c]];
			const Vec3 y = glm::cross(curves.directions[i], x);
			const double turn = turns.empty() ? 0.0 : turns[i];
			const Vec3 half = 0.5 * width * (std::cos(turn) * x + std::sin(turn) * y);
			const std::uint32_t left = mesh.addVertex(curves.points[i] - half, values[i]);
			const std::uint32_t right = mesh.addVertex(curves.points[i] + half, values[i]);
			if (i > curves.starts[c])
				mesh.addPolygon(std::array{left - 2, left - 1, right, left});
		}
	}
}

} // namespace vp::vectors
