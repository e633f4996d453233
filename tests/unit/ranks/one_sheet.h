#pragma once

#include "cut/cutter.h"
#include "exhaustive.h"
#include "measure/stats.h"
#include "parted_lattice.h"
#include "ranks/join/borders.h"
#include "ranks/search/rank_to_rank.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>

namespace vp::test
{

inline const grid::FieldChoice kHeight{"hills", grid::Association::point, 0};
inline const grid::FieldChoice kWind{"wind", grid::Association::point, grid::kMagnitude};

inline cut::CutRequest requestFor(const TestPlane& plane)
{
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	request.field = kHeight;
	return request;
}

inline std::size_t sumOf(const ranks::Ranks& ranks, std::size_t own)
{
	return ranks.sum(own, [](std::size_t& sum, std::size_t other) { sum += other; });
}

// What is told of a sheet. All ranks get the same.
struct Figures
{
	std::size_t cells = 0;
	std::size_t polygons = 0;
	std::size_t vertices = 0;
	std::size_t components = 0;
	std::size_t boundary_polygons = 0;
	double area = 0.0;
	double boundary_area = 0.0;
	double mean = 0.0;
	double least = 0.0;
	double most = 0.0;
	bool hangs = false;
};

// Counts are the same, and sums but for the order in which the corners of a polygon are listed.
inline void expectSame(const Figures& found, const Figures& expected, const std::string& where)
{
	constexpr double kRounding = 1e-12;
	EXPECT_EQ(found.cells, expected.cells) << where;
	EXPECT_EQ(found.polygons, expected.polygons) << where;
	EXPECT_EQ(found.vertices, expected.vertices) << where;
	EXPECT_EQ(found.components, expected.components) << where;
	EXPECT_EQ(found.boundary_polygons, expected.boundary_polygons) << where;
	EXPECT_NEAR(found.area, expected.area, kRounding) << where;
	EXPECT_NEAR(found.boundary_area, expected.boundary_area, kRounding) << where;
	EXPECT_NEAR(found.mean, expected.mean, kRounding) << where;
	EXPECT_NEAR(found.least, expected.least, kRounding) << where;
	EXPECT_NEAR(found.most, expected.most, kRounding) << where;
	EXPECT_FALSE(found.hangs) << where;
}

struct OneSheet
{
	cut::Cutter cutter;
	cut::Cut cut;
	mesh::SheetMesh mesh;
	ranks::Borders borders;

	OneSheet(const ranks::Ranks& ranks, const grid::BlockSet& blocks, const cut::CutRequest& request)
	    : cutter(blocks), cut(std::move(ranks::carryOut(ranks, cutter, request, {}).value())),
	      mesh(cut.mesh(blocks, 0)), borders(ranks::joinBorders(ranks, blocks, cut.sheets[0].cuts, mesh))
	{
	}

	const cut::SheetCut& sheet() const { return cut.sheets[0]; }
};

inline Figures figuresOf(const ranks::Ranks& ranks, const grid::BlockSet& blocks, const OneSheet& sheet)
{
	std::size_t cells = 0;
	for (const find::BlockCut& cut : sheet.sheet().cuts)
		cells += cut.cutCells();
	const measure::SheetMeasure measured = measure::measureOf(ranks::sumUp(ranks, blocks, sheet.mesh, kHeight), true);
	return {.cells = sumOf(ranks, cells),
	        .polygons = sumOf(ranks, sheet.mesh.polygons()),
	        .vertices = sumOf(ranks, sheet.mesh.positions.size() - sheet.borders.vertices_elsewhere),
	        .components = ranks::componentsOf(ranks, sheet.borders, sheet.mesh),
	        .boundary_polygons = sumOf(ranks, sheet.mesh.boundary_polygons),
	        .area = measured.area,
	        .boundary_area = measured.boundary_area,
	        .mean = measured.mean.value_or(0.0),
	        .least = measured.min.value_or(0.0),
	        .most = measured.max.value_or(0.0),
	        .hangs = sheet.borders.hangs};
}

} // namespace vp::test
