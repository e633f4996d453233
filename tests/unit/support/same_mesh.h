#pragma once

#include "mesh/sheet_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace vp::test
{

// A polygon by its cell and its corners' places, from the least place on.
struct PlacedPolygon
{
	std::uint32_t block;
	CellId cell;
	std::vector<std::array<double, 3>> corners;

	auto operator<=>(const PlacedPolygon&) const = default;
};

inline std::vector<PlacedPolygon> placedPolygons(const mesh::SheetMesh& mesh)
{
	std::vector<PlacedPolygon> polygons;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		PlacedPolygon placed{mesh.polygon_cells[p].block, mesh.polygon_cells[p].cell, {}};
		for (const std::uint32_t v : mesh.polygon(p))
			placed.corners.push_back({mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z});
		std::rotate(placed.corners.begin(), std::min_element(placed.corners.begin(), placed.corners.end()),
		            placed.corners.end());
		polygons.push_back(std::move(placed));
	}
	std::sort(polygons.begin(), polygons.end());
	return polygons;
}

// Expects the same polygons of the same cells at the same places, to the last bit, in any order, and equally many
// vertices.
inline void expectSameMesh(const mesh::SheetMesh& mesh, const mesh::SheetMesh& expected)
{
	EXPECT_EQ(mesh.positions.size(), expected.positions.size());
	EXPECT_EQ(mesh.edges.size(), expected.edges.size());
	EXPECT_EQ(mesh.boundary_polygons, expected.boundary_polygons);
	EXPECT_EQ(mesh.seam_pairs.size(), expected.seam_pairs.size());
	EXPECT_EQ(mesh.cells_twisted, expected.cells_twisted);
	ASSERT_EQ(mesh.polygons(), expected.polygons());
	EXPECT_TRUE(placedPolygons(mesh) == placedPolygons(expected));
}

} // namespace vp::test
