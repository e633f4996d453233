#pragma once

#include "grid/block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace vp::test
{

// Witnesses that use nothing of the rooms they testify about: plain loops over all cells, in double.

struct TestPlane
{
	Vec3 origin;
	Vec3 normal; // may have any length
};

// Signed distances with a canonical unit normal: the tie rule says that the first nonzero component is positive.
class Side
{
public:
	explicit Side(const TestPlane& plane) : origin_(plane.origin)
	{
		const Vec3 magnitude = glm::abs(plane.normal);
		normal_ = glm::normalize(plane.normal / std::max({magnitude.x, magnitude.y, magnitude.z}));
		for (int axis = 0; axis < 3; ++axis)
			if (normal_[axis] != 0.0)
			{
				if (normal_[axis] < 0.0)
					normal_ *= -1.0;
				break;
			}
	}
	const Vec3& normal() const { return normal_; }
	double distance(const Vec3& p) const
	{
		return normal_.x * (p.x - origin_.x) + normal_.y * (p.y - origin_.y) + normal_.z * (p.z - origin_.z);
	}
	bool positive(const Vec3& p) const { return distance(p) >= 0.0; }

private:
	Vec3 origin_;
	Vec3 normal_;
};

template <class Visit>
auto visitGrid(const grid::Block& block, Visit&& visit)
{
	return std::visit(std::forward<Visit>(visit), block.grid);
}

inline std::size_t cellCount(const grid::Block& block)
{
	return visitGrid(block, [](const auto& grid) { return grid.cellCount(); });
}

inline bool isCut(const grid::Block& block, CellId cell, const Side& side)
{
	return visitGrid(block,
	                 [&](const auto& grid)
	                 {
		                 grid::CellFaces faces;
		                 grid.cellFaces(cell, faces);
		                 const auto positive = [&](PointId p) { return side.positive(grid.point(p)); };
		                 return std::ranges::any_of(faces.points, positive) &&
		                        !std::ranges::all_of(faces.points, positive);
	                 });
}

// In ascending order.
inline std::vector<CellId> scanCutCells(const grid::Block& block, const TestPlane& plane)
{
	const Side side(plane);
	std::vector<CellId> cells;
	for (CellId c = 0; c < cellCount(block); ++c)
		if (isCut(block, c, side))
			cells.push_back(c);
	return cells;
}

inline std::vector<CellId> sorted(std::vector<CellId> cells)
{
	std::ranges::sort(cells);
	return cells;
}

// Returns the cells across the cut faces of a cell.
inline std::vector<CellId> cutNeighbors(const grid::Block& block, CellId cell, const Side& side)
{
	std::vector<CellId> found;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          grid::CellFaces faces;
		          grid.cellFaces(cell, faces);
		          for (int f = 0; f < faces.size(); ++f)
		          {
			          const auto positive = [&](PointId p) { return side.positive(grid.point(p)); };
			          if (std::ranges::any_of(faces[f], positive) && !std::ranges::all_of(faces[f], positive))
				          grid.forEachNeighbor(cell, f, [&](CellId n) { found.push_back(n); });
		          }
	          });
	return found;
}

// The points of a cell, each once.
inline std::vector<Vec3> cellCorners(const grid::Block& block, CellId cell)
{
	return visitGrid(block,
	                 [&](const auto& grid)
	                 {
		                 grid::CellFaces faces;
		                 grid.cellFaces(cell, faces);
		                 std::ranges::sort(faces.points);
		                 faces.points.erase(std::unique(faces.points.begin(), faces.points.end()), faces.points.end());
		                 std::vector<Vec3> corners;
		                 for (const PointId p : faces.points)
			                 corners.push_back(grid.point(p));
		                 return corners;
	                 });
}

using Tetrahedron = std::array<Vec3, 4>;

// A cell as tetrahedra from its center to the fans of its faces about the faces' means: cells that share a face share
// its fan.
inline std::vector<Tetrahedron> cellTetrahedra(const grid::Block& block, CellId cell)
{
	std::vector<Tetrahedron> parts;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          grid::CellFaces faces;
		          grid.cellFaces(cell, faces);
		          Vec3 center(0.0);
		          const std::vector<Vec3> corners = cellCorners(block, cell);
		          for (const Vec3& corner : corners)
			          center += corner / static_cast<double>(corners.size());
		          for (int f = 0; f < faces.size(); ++f)
		          {
			          Vec3 middle(0.0);
			          for (const PointId p : faces[f])
				          middle += grid.point(p) / static_cast<double>(faces[f].size());
			          for (std::size_t i = 0; i < faces[f].size(); ++i)
				          parts.push_back({center, middle, grid.point(faces[f][i]),
				                           grid.point(faces[f][(i + 1) % faces[f].size()])});
		          }
	          });
	return parts;
}

inline double volumeOf(const Tetrahedron& t)
{
	return glm::dot(t[1] - t[0], glm::cross(t[2] - t[0], t[3] - t[0])) / 6.0;
}

inline bool holds(const Tetrahedron& t, const Vec3& p, double slack)
{
	const double volume = volumeOf(t);
	if (volume == 0.0)
		return false;
	for (int corner = 0; corner < 4; ++corner)
	{
		Tetrahedron part = t;
		part[corner] = p;
		if (volumeOf(part) / volume < -slack)
			return false;
	}
	return true;
}

inline bool anyHolds(const std::vector<Tetrahedron>& parts, const Vec3& p, double slack = 1e-9)
{
	return std::ranges::any_of(parts, [&](const Tetrahedron& part) { return holds(part, p, slack); });
}

// Asks every cell.
class BruteForceLocator
{
public:
	explicit BruteForceLocator(const grid::Block& block)
	{
		for (CellId c = 0; c < cellCount(block); ++c)
		{
			cells_.push_back({{}, cellTetrahedra(block, c)});
			for (const Tetrahedron& part : cells_.back().parts)
				for (const Vec3& corner : part)
					cells_.back().box.include(corner);
		}
	}
	bool cellHolds(CellId cell, const Vec3& p) const
	{
		const Box& box = cells_[cell].box;
		const Vec3 slack(1e-9 * box.diagonal());
		return glm::all(glm::greaterThanEqual(p, box.lo - slack)) && glm::all(glm::lessThanEqual(p, box.hi + slack)) &&
		       anyHolds(cells_[cell].parts, p);
	}
	std::vector<CellId> cellsHolding(const Vec3& p) const
	{
		std::vector<CellId> found;
		for (CellId c = 0; c < cells_.size(); ++c)
			if (cellHolds(c, p))
				found.push_back(c);
		return found;
	}
	const std::vector<Tetrahedron>& parts(CellId cell) const { return cells_[cell].parts; }

private:
	struct Cell
	{
		Box box;
		std::vector<Tetrahedron> parts;
	};
	std::vector<Cell> cells_;
};

inline Vec3 randomDirection(std::mt19937& random)
{
	std::uniform_real_distribution<double> height(-1.0, 1.0);
	std::uniform_real_distribution<double> angle(0.0, 2.0 * std::numbers::pi);
	const double z = height(random);
	const double turn = angle(random);
	const double r = std::sqrt(1.0 - z * z);
	return {r * std::cos(turn), r * std::sin(turn), z};
}

inline Vec3 randomPoint(const Box& box, std::mt19937& random)
{
	std::uniform_real_distribution<double> unit(0.0, 1.0);
	const double x = unit(random);
	const double y = unit(random);
	return box.lo + Vec3(x, y, unit(random)) * box.size();
}

inline std::vector<TestPlane> randomPlanes(const Box& box, int count, unsigned seed)
{
	std::mt19937 random(seed);
	std::vector<TestPlane> planes;
	for (int i = 0; i < count; ++i)
	{
		const Vec3 origin = randomPoint(box, random);
		planes.push_back({origin, randomDirection(random)});
	}
	return planes;
}

// Through vertices, along edges and faces, tangent to the domain, along its diagonals, beside it.
inline std::vector<TestPlane> degeneratePlanes(const grid::Block& block, unsigned seed)
{
	std::mt19937 random(seed);
	std::vector<TestPlane> planes;
	const Box& box = block.bounds;
	for (int axis = 0; axis < 3; ++axis)
	{
		Vec3 normal(0.0);
		normal[axis] = 1.0;
		for (const Vec3& origin : {box.lo, box.hi, box.center(), box.lo - box.size()})
			for (const double sign : {1.0, -1.0})
				planes.push_back({origin, sign * normal});
	}
	std::uniform_int_distribution<CellId> any_cell(0, static_cast<CellId>(cellCount(block) - 1));
	for (int i = 0; i < 20; ++i)
	{
		const std::vector<Vec3> corners = cellCorners(block, any_cell(random));
		Vec3 axis(0.0);
		axis[i % 3] = 1.0;
		planes.push_back({corners[i % corners.size()], axis}); // through a vertex, along the lattice
		planes.push_back({corners[i % corners.size()], {1.0, i % 2 ? -1.0 : 1.0, 0.0}}); // and through a diagonal
		planes.push_back({corners[i % corners.size()], randomDirection(random)});
		// Through three vertices of a cell: an edge and often a whole face.
		const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
		if (normal != Vec3(0.0))
			planes.push_back({corners[0], normal});
	}
	return planes;
}

} // namespace vp::test
