#pragma once

#include "cut/cutter.h"
#include "measure/stats.h"
#include "tries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

// Maps of a cube from -1 to 1, and sections of blocks whose curved cells are refined.
namespace vp::test
{

inline Vec3 still(Vec3 p)
{
	return p;
}

// The cube as a ball of radius 1.
inline Vec3 ball(Vec3 p)
{
	const Vec3 s = p * p;
	return {p.x * std::sqrt(1 - s.y / 2 - s.z / 2 + s.y * s.z / 3),
	        p.y * std::sqrt(1 - s.z / 2 - s.x / 2 + s.z * s.x / 3),
	        p.z * std::sqrt(1 - s.x / 2 - s.y / 2 + s.x * s.y / 3)};
}

// Curved about the middle, straight elsewhere, and a cube as a whole.
inline Vec3 bulge(Vec3 p)
{
	const double r = glm::dot(p, p);
	return r < 0.49 ? p + 0.3 * (0.49 - r) * Vec3(p.y, p.z, p.x) : p;
}

struct Section
{
	cut::Cut cut;
	mesh::SheetMesh mesh;
	measure::SheetMeasure figures;

	const grid::BlockSet& blocks() const { return *cut.refined; }
};

inline Section section(cut::Cutter& cutter, const Vec3& origin, const Vec3& normal, bool shows_values = false)
{
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(origin, normal)};
	if (shows_values)
		request.field = grid::FieldChoice{"f"};
	Section made;
	Result<cut::Cut> cut = cutter.cut(request);
	if (!cut)
		throw std::runtime_error(cut.error().message);
	made.cut = std::move(*cut);
	made.mesh = made.cut.mesh(cutter.blocks(), 0);
	made.figures = measure::measure(made.blocks(), made.mesh, request.field);
	return made;
}

// Sections of a ball of radius 1 have areas that come close with the tolerance. ballOf(tolerance): of cells about 1/6
// large, whose nodes leave an error. gain: what a tenth of the tolerance leaves of the error.
template <class BallOf>
void expectAreasOfABall(BallOf&& ballOf, double gain)
{
	double before = 1.0;
	for (const double tolerance : {0.1, 0.01, 0.001})
	{
		const grid::BlockSet set = ballOf(tolerance);
		cut::Cutter cutter(set);
		double worst = 0.0;
		Taken taken;
		for (const Vec3& normal : {Vec3(0.3, 0.5, 0.8), Vec3(1, 0.02, 0.03), Vec3(-0.4, 1, 0.7), Vec3(0, 0, 1)})
			for (const double distance : {0.0, 0.31, 0.62})
			{
				if (!taken.next())
					continue;
				const Section cut = section(cutter, distance * glm::normalize(normal), normal);
				const double exact = std::numbers::pi * (1.0 - distance * distance);
				worst = std::max(worst, std::abs(cut.figures.area / exact - 1.0));
				EXPECT_EQ(cut.figures.components, 1u);
			}
		// The rim of a circle is off by the tolerance all around.
		EXPECT_LT(worst, 0.4 * tolerance + 1e-4) << tolerance;
		EXPECT_LT(worst, gain * before) << tolerance;
		before = worst;
	}
}

// The middles of edges that one polygon has alone. Vertices within rounding of each other are one: a plane that passes
// a point by less than that has several there.
inline std::vector<Vec3> openEdges(const mesh::SheetMesh& mesh)
{
	std::map<std::array<std::int64_t, 3>, std::uint32_t> numbers;
	std::vector<std::uint32_t> number;
	for (const Vec3& at : mesh.positions)
	{
		const auto rounded = [](double x) { return std::llround((x + 0.1234567) * 1e9); };
		number.push_back(
		    numbers.try_emplace({rounded(at.x), rounded(at.y), rounded(at.z)}, numbers.size()).first->second);
	}
	std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, Vec3>> edges;
	for (std::size_t p = 0; p < mesh.polygons(); ++p)
	{
		const auto polygon = mesh.polygon(p);
		for (std::size_t i = 0; i < polygon.size(); ++i)
		{
			const std::uint32_t a = polygon[i];
			const std::uint32_t b = polygon[(i + 1) % polygon.size()];
			if (number[a] == number[b])
				continue;
			auto& [sides, middle] = edges[std::minmax(number[a], number[b])];
			++sides;
			middle = 0.5 * (mesh.positions[a] + mesh.positions[b]);
		}
	}
	std::vector<Vec3> open;
	for (const auto& [edge, found] : edges)
		if (found.first % 2 == 1)
			open.push_back(found.second);
	return open;
}

} // namespace vp::test
