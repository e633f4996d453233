#pragma once

#include "grid/curved/curved_cells.h"
#include "grid/field.h"
#include "quadratic_cube.h"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

namespace vp::test
{

// A cube from -1 to 1 of quadratic cells of all shapes that fit: columns of hexahedra and of six pyramids in turn, and
// columns of two wedges beside them. Pyramids on the boundary become two tetrahedra. The nodes are moved by a map.
class MixedCube
{
public:
	// full: every second hexahedron has 27 nodes. linear: every second hexahedron has its corners alone.
	struct Choice
	{
		bool full = false;
		bool linear = false;
	};

	MixedCube(int count, const Map& map, const Value& value, const Choice& choice)
	    : count_(count), map_(map), value_(value)
	{
		for (int k = 0; k < count; ++k)
			for (int j = 0; j < count; ++j)
				for (int i = 0; i < count; ++i)
				{
					const Place at{4 * i, 4 * j, 4 * k};
					if ((i + j) % 2 == 1)
						addWedges(at);
					else if (k % 2 == 1)
						addPyramids(at);
					else
						addHexahedron(at, choice.full && (i + k) % 4 == 0, choice.linear && (i + k) % 4 == 0);
				}
	}

	grid::Block block(double tolerance)
	{
		grid::CurvedCells curved;
		curved.points = grid::Points(Array<double>(coordinates_));
		curved.cells.types = types_;
		curved.cells.offsets = offsets_;
		curved.cells.connectivity = nodes_;
		curved.tolerance = tolerance;
		grid::Block block;
		block.name = "mixed";
		if (value_)
			block.fields = {grid::makeField("f", grid::Association::point, 1, std::vector<double>(values_))};
		takeCurvedCells(block, std::move(curved));
		return block;
	}

private:
	using Place = std::array<int, 3>; // four to an edge of a cube
	using Edges = std::initializer_list<std::array<std::size_t, 2>>;

	std::int32_t number(const Place& place)
	{
		const auto [known, is_new] = numbers_.try_emplace(place, static_cast<std::int32_t>(numbers_.size()));
		if (is_new)
		{
			const Vec3 at = map_(Vec3(place[0], place[1], place[2]) / (2.0 * count_) - 1.0);
			coordinates_.insert(coordinates_.end(), {at.x, at.y, at.z});
			values_.push_back(value_ ? value_(at) : 0.0);
		}
		return known->second;
	}
	static Place middle(const std::vector<Place>& corners)
	{
		Place sum{};
		for (const Place& corner : corners)
			for (std::size_t axis = 0; axis < 3; ++axis)
				sum[axis] += corner[axis];
		for (int& axis : sum)
			axis /= static_cast<int>(corners.size());
		return sum;
	}
	void add(std::uint8_t type, const std::vector<Place>& corners, const Edges& edges,
	         const std::vector<Place>& others = {})
	{
		types_.push_back(type);
		for (const Place& corner : corners)
			nodes_.push_back(number(corner));
		for (const auto& [a, b] : edges)
			nodes_.push_back(number(middle({corners[a], corners[b]})));
		for (const Place& other : others)
			nodes_.push_back(number(other));
		offsets_.push_back(static_cast<std::int64_t>(nodes_.size()));
	}
	static std::vector<Place> cornersAt(const Place& at)
	{
		std::vector<Place> corners;
		for (const Place& step : std::initializer_list<Place>{
		         {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 4}, {4, 0, 4}, {4, 4, 4}, {0, 4, 4}})
			corners.push_back({at[0] + step[0], at[1] + step[1], at[2] + step[2]});
		return corners;
	}
	static std::vector<std::vector<Place>> facesAt(const Place& at)
	{
		const std::vector<Place> c = cornersAt(at);
		return {{c[0], c[4], c[7], c[3]}, {c[1], c[2], c[6], c[5]}, {c[0], c[1], c[5], c[4]},
		        {c[3], c[7], c[6], c[2]}, {c[0], c[3], c[2], c[1]}, {c[4], c[5], c[6], c[7]}};
	}
	void addHexahedron(const Place& at, bool full, bool linear)
	{
		const std::vector<Place> corners = cornersAt(at);
		const Edges edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
		                  {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
		if (linear)
			return add(grid::kHexahedron, corners, {});
		std::vector<Place> middles;
		for (const auto& face : facesAt(at))
			middles.push_back(middle(face));
		middles.push_back(middle(corners));
		if (full)
			add(grid::kTriQuadraticHexahedron, corners, edges, middles);
		else
			add(grid::kQuadraticHexahedron, corners, edges);
	}
	void addWedges(const Place& at)
	{
		const std::vector<Place> c = cornersAt(at);
		const Edges edges{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
		add(grid::kQuadraticWedge, {c[0], c[1], c[3], c[4], c[5], c[7]}, edges);
		add(grid::kQuadraticWedge, {c[2], c[3], c[1], c[6], c[7], c[5]}, edges);
	}
	void addPyramids(const Place& at)
	{
		const Place top = middle(cornersAt(at));
		for (const std::vector<Place>& face : facesAt(at))
		{
			const Place of_face = middle(face);
			const bool is_outside =
			    std::ranges::any_of(of_face, [&](int axis) { return axis == 0 || axis == 4 * count_; });
			const Edges edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
			const Edges few{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
			if (!is_outside)
				add(grid::kQuadraticPyramid, {face[3], face[2], face[1], face[0], top}, edges);
			else
				for (const std::size_t second : {1, 2})
					add(grid::kQuadraticTetra, {face[second + 1], face[second], face[0], top}, few);
		}
	}

	int count_;
	Map map_;
	Value value_;
	std::map<Place, std::int32_t> numbers_;
	std::vector<double> coordinates_;
	std::vector<double> values_;
	std::vector<std::uint8_t> types_;
	std::vector<std::int64_t> offsets_{0};
	std::vector<std::int32_t> nodes_;
};

inline grid::Block mixedCube(int count, double tolerance, const Map& map, const Value& value = {},
                             const MixedCube::Choice& choice = {})
{
	return MixedCube(count, map, value, choice).block(tolerance);
}

} // namespace vp::test
