#pragma once

#include "exhaustive.h"
#include "mesh/sheet_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace vp::test
{

// The edges of a cell, and those of its faces that are on the boundary, by their points.
struct CellEdges
{
	std::set<std::pair<PointId, PointId>> edges;
	std::vector<std::set<PointId>> boundary_faces;
};

inline CellEdges edgesOf(const grid::Block& block, CellId cell)
{
	CellEdges result;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          grid::CellFaces faces;
		          grid.cellFaces(cell, faces);
		          for (int f = 0; f < faces.size(); ++f)
		          {
			          for (std::size_t i = 0; i < faces[f].size(); ++i)
				          result.edges.insert(std::minmax(faces[f][i], faces[f][(i + 1) % faces[f].size()]));
			          bool inner = false;
			          grid.forEachNeighbor(cell, f, [&](CellId) { inner = true; });
			          if (!inner)
				          result.boundary_faces.emplace_back(faces[f].begin(), faces[f].end());
		          }
	          });
	return result;
}

// Returns true if every face has one neighbor, and is a whole face of it.
inline bool conforms(const grid::Block& block)
{
	return block.name != "three_on_a_face" && block.name != "two_to_one";
}

// Every edge of a polygon is another's too, or lies on the boundary. most: how often a face may be cut; where a curved
// surface cuts one more than once the edges of several pairs of polygons may run between the same two vertices.
inline void expectWatertight(const grid::Block& block, const mesh::SheetMesh& mesh, int most = 1)
{
	struct Use
	{
		int polygons = 0;
		bool on_boundary = false;
	};
	std::map<std::pair<std::uint32_t, std::uint32_t>, Use> uses;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const CellEdges cell = edgesOf(block, mesh.polygon_cells[p].cell);
		const auto polygon = mesh.polygon(p);
		for (std::size_t i = 0; i < polygon.size(); ++i)
		{
			const std::uint32_t v = polygon[i];
			const std::uint32_t w = polygon[(i + 1) % polygon.size()];
			Use& use = uses[std::minmax(v, w)];
			++use.polygons;
			for (const std::set<PointId>& face : cell.boundary_faces)
				use.on_boundary |= face.contains(mesh.edges[v].lower) && face.contains(mesh.edges[v].higher) &&
				                   face.contains(mesh.edges[w].lower) && face.contains(mesh.edges[w].higher);
		}
	}
	for (const auto& [edge, use] : uses)
	{
		if (most == 1)
		{
			EXPECT_EQ(use.polygons, use.on_boundary ? 1 : 2);
		}
		else
		{
			EXPECT_TRUE(use.on_boundary || use.polygons % 2 == 0);
		}
	}
}

} // namespace vp::test
