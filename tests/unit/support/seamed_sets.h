#pragma once

#include "test_grids.h"

#include <array>
#include <cmath>
#include <numbers>

namespace vp::test
{

// Block sets that meet in faces without sharing points, and the same domains in one piece.

inline Vec3 warped(double u, double v, double w)
{
	return {u + 0.15 * std::sin(2.0 * v) * w, v + 0.1 * std::cos(1.5 * u + w), 0.7 * w + 0.1 * u * v};
}

inline Vec3 straight(double u, double v, double w)
{
	return {u, v, w};
}

inline Vec3 ring(double u, double v, double w)
{
	const double angle = std::numbers::pi * u; // once around for u in 0..2
	return {(1.0 + v) * std::cos(angle), (1.0 + v) * std::sin(angle), w};
}

using Place = Vec3 (*)(double u, double v, double w);

constexpr int kSteps = 4; // cells along each axis of a unit of u, v, w

inline grid::Block curvilinearBlock(std::string name, std::array<std::uint32_t, 3> points, auto&& point_at)
{
	std::vector<double> xyz;
	for (std::uint32_t k = 0; k < points[2]; ++k)
		for (std::uint32_t j = 0; j < points[1]; ++j)
			for (std::uint32_t i = 0; i < points[0]; ++i)
			{
				const Vec3 p = point_at(i, j, k);
				xyz.insert(xyz.end(), {p.x, p.y, p.z});
			}
	grid::Block block;
	block.name = std::move(name);
	block.grid = grid::CurvilinearGrid(points, grid::Points(Array<double>(std::move(xyz))));
	grid::finishBlock(block);
	return block;
}

// u from u0 to u0 + 1; the turned one runs w, then v backwards, then u.
inline grid::Block latticeBlock(Place place, double u0, bool turned)
{
	constexpr std::uint32_t n = kSteps + 1;
	constexpr double step = 1.0 / kSteps;
	return curvilinearBlock(turned ? "turned" : "plain", {n, n, n},
	                        [&](int i, int j, int k) {
		                        return turned ? place(u0 + step * k, step * (kSteps - j), step * i)
		                                      : place(u0 + step * i, step * j, step * k);
	                        });
}

// u from u0 to u1. Merged hexahedra share their points; the others have eight of their own.
inline grid::Block hexahedraBlock(Place place, double u0, double u1, bool merged, bool closed = false)
{
	const int along = static_cast<int>(std::lround((u1 - u0) * kSteps));
	constexpr double step = 1.0 / kSteps;
	CellListMaker maker;
	std::vector<std::int64_t> ids((along + 1) * (kSteps + 1) * (kSteps + 1), -1);
	const auto corner = [&](int i, int j, int k)
	{
		if (!merged)
			return maker.point(place(u0 + step * i, step * j, step * k));
		const int wrapped = closed ? i % along : i;
		std::int64_t& id = ids[(k * (kSteps + 1) + j) * (along + 1) + wrapped];
		if (id < 0)
			id = maker.point(place(u0 + step * wrapped, step * j, step * k));
		return id;
	};
	for (int k = 0; k < kSteps; ++k)
		for (int j = 0; j < kSteps; ++j)
			for (int i = 0; i < along; ++i)
				maker.cell(12, {corner(i, j, k), corner(i + 1, j, k), corner(i + 1, j + 1, k), corner(i, j + 1, k),
				                corner(i, j, k + 1), corner(i + 1, j, k + 1), corner(i + 1, j + 1, k + 1),
				                corner(i, j + 1, k + 1)});
	return maker.block(merged ? "merged" : "unmerged");
}

inline grid::BlockSet setOfBlocks(std::vector<grid::Block> blocks)
{
	grid::BlockSet set;
	set.blocks = std::move(blocks);
	grid::matchInterfaces(set);
	return set;
}

// The points where u = 0 and u = 2 differ by rounding.
inline grid::Block oGrid()
{
	constexpr double step = 1.0 / kSteps;
	return curvilinearBlock("o_grid", {2 * kSteps + 1, kSteps + 1, kSteps + 1},
	                        [](int i, int j, int k) { return ring(step * i, step * j, step * k); });
}

} // namespace vp::test
