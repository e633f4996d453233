#pragma once

#include "grid/curved/curved_cells.h"
#include "grid/field.h"

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace vp::test
{

using Map = std::function<Vec3(Vec3)>;
using Value = std::function<double(Vec3)>;

// A cube from -1 to 1 as count^3 cubes, each of six quadratic tetrahedra. The nodes are moved by a map.
inline grid::Block quadraticCube(int count, double tolerance, const Map& map, const Value& value = {})
{
	constexpr std::array<std::array<int, 3>, 6> steps{
	    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
	constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
	const int width = 2 * count + 1;
	std::vector<double> points;
	std::vector<double> values;
	for (int k = 0; k < width; ++k)
		for (int j = 0; j < width; ++j)
			for (int i = 0; i < width; ++i)
			{
				const Vec3 at = map(Vec3(i, j, k) / double(count) - 1.0);
				points.insert(points.end(), {at.x, at.y, at.z});
				values.push_back(value ? value(at) : 0.0);
			}
	std::vector<std::int32_t> nodes;
	for (int cube = 0; cube < count * count * count; ++cube)
		for (const auto& axes : steps)
		{
			std::array<glm::ivec3, 4> corners;
			corners[0] = 2 * glm::ivec3(cube % count, cube / count % count, cube / count / count);
			for (std::size_t c = 1; c < 4; ++c)
			{
				corners[c] = corners[c - 1];
				corners[c][axes[c - 1]] += 2;
			}
			const auto add = [&](const glm::ivec3& at) { nodes.push_back(at.x + width * (at.y + width * at.z)); };
			for (const glm::ivec3& corner : corners)
				add(corner);
			for (const auto& [a, b] : edges)
				add((corners[a] + corners[b]) / 2);
		}
	const std::size_t cells = nodes.size() / 10;
	std::vector<std::int64_t> offsets;
	for (std::size_t c = 0; c <= cells; ++c)
		offsets.push_back(static_cast<std::int64_t>(10 * c));
	grid::CurvedCells curved;
	curved.points = grid::Points(Array<double>(std::move(points)));
	curved.cells.types = std::vector<std::uint8_t>(cells, grid::kQuadraticTetra);
	curved.cells.offsets = std::move(offsets);
	curved.cells.connectivity = std::move(nodes);
	curved.tolerance = tolerance;
	grid::Block block;
	block.name = "cube";
	if (value)
		block.fields = {grid::makeField("f", grid::Association::point, 1, std::move(values))};
	takeCurvedCells(block, std::move(curved));
	return block;
}

} // namespace vp::test
