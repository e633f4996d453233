#pragma once

#include "sliced_sheet.h"

#include "cut/cutter.h"
#include "measure/stats.h"
#include "mesh/seam_names.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

namespace vp::test
{

// Every edge has two polygons that run along it in opposite senses, or one and lies in a side of the box. Vertices that
// lie on each other at a seam count as one.
inline void expectClosed(const mesh::SheetMesh& mesh, const Box& box)
{
	const mesh::SeamNames names(mesh);
	std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		for (std::size_t i = 0; i < polygon.size(); ++i)
			++uses[{names[polygon[i]], names[polygon[(i + 1) % polygon.size()]]}];
	}
	for (const auto& [edge, count] : uses)
	{
		EXPECT_EQ(count, 1);
		if (uses.contains({edge.second, edge.first}))
			continue;
		bool in_side = false;
		for (int axis = 0; axis < 3; ++axis)
			for (const double side : {box.lo[axis], box.hi[axis]})
				in_side |= std::abs(mesh.positions[edge.first][axis] - side) < 1e-9 &&
				           std::abs(mesh.positions[edge.second][axis] - side) < 1e-9;
		EXPECT_TRUE(in_side) << edge.first << " - " << edge.second;
	}
}

// The figures of one sheet, which must be closed and in one piece. Its area is that of a section of the box, and the
// mean is that of a linear field.
struct Whole
{
	cut::Cut cut;
	mesh::SheetMesh mesh;
	measure::SheetMeasure figures;
};

inline Whole cutWhole(cut::Cutter& cutter, const TestPlane& plane, cut::CutRequest request = inGenerations())
{
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	Whole whole;
	whole.cut = std::move(cutter.cut(std::move(request)).value());
	whole.mesh = whole.cut.mesh(cutter.blocks(), 0);
	whole.figures = measure::measure(cutter.blocks(), whole.mesh, grid::FieldChoice{"f"});
	return whole;
}

} // namespace vp::test
