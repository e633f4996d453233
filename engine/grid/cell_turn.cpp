#include "grid/cell_turn.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace vp::grid
{

namespace
{

// Rounding of a determinant is some 1e-16 of the product of its edges.
constexpr double kNoVolume = 1e-12;

constexpr CornerFrame kTetrahedronCorners[] = {{{0, 1, 2, 3}}};
constexpr CornerFrame kHexahedronCorners[] = {{{0, 1, 3, 4}}, {{1, 2, 0, 5}}, {{2, 3, 1, 6}}, {{3, 0, 2, 7}},
                                              {{4, 7, 5, 0}}, {{5, 4, 6, 1}}, {{6, 5, 7, 2}}, {{7, 6, 4, 3}}};
// VTK's first triangle faces outward.
constexpr CornerFrame kWedgeCorners[] = {{{0, 2, 1, 3}}, {{1, 0, 2, 4}}, {{2, 1, 0, 5}},
                                         {{3, 4, 5, 0}}, {{4, 5, 3, 1}}, {{5, 3, 4, 2}}};
constexpr CornerFrame kPyramidCorners[] = {{{0, 1, 3, 4}}, {{1, 2, 0, 4}}, {{2, 3, 1, 4}}, {{3, 0, 2, 4}}};

double det(const Vec3& a, const Vec3& b, const Vec3& c)
{
	return glm::dot(a, glm::cross(b, c));
}

// Gathers the signs of a Jacobian's coefficients.
class Signs
{
public:
	// A value and the product of the edges' lengths that it was computed from.
	void add(double value, double scale)
	{
		if (!(scale > 0.0))
			return; // an edge without length
		positive_ = positive_ || value > kNoVolume * scale;
		negative_ = negative_ || value < -kNoVolume * scale;
		flat_ = flat_ || std::abs(value) <= kNoVolume * scale;
	}
	Turn turn() const
	{
		if (flat_ || positive_ == negative_)
			return Turn::mixed;
		return positive_ ? Turn::positive : Turn::negative;
	}

private:
	bool positive_ = false;
	bool negative_ = false;
	bool flat_ = false;
};

Turn turnOfCorners(CellShape shape, std::span<const Vec3> p)
{
	Signs signs;
	for (const CornerFrame& frame : cornerFrames(shape))
	{
		const Vec3 a = p[frame.corner[1]] - p[frame.corner[0]];
		const Vec3 b = p[frame.corner[2]] - p[frame.corner[0]];
		const Vec3 c = p[frame.corner[3]] - p[frame.corner[0]];
		signs.add(det(a, b, c), glm::length(a) * glm::length(b) * glm::length(c));
	}
	return signs.turn();
}

// Linear over the triangles, whose edges change linearly along the third axis: degree 1 over the triangle, 2 along.
Turn turnOfWedge(std::span<const Vec3> p)
{
	// Two edges of either triangle, against VTK's order, which faces outward at the first.
	const Vec3 a[2] = {p[2] - p[0], p[5] - p[3]};
	const Vec3 b[2] = {p[1] - p[0], p[4] - p[3]};
	Signs signs;
	for (int k = 0; k < 3; ++k)
	{
		const Vec3 along = p[k + 3] - p[k];
		const auto scale = [&](int i, int j) { return glm::length(a[i]) * glm::length(b[j]) * glm::length(along); };
		for (int end = 0; end < 2; ++end)
			signs.add(det(a[end], b[end], along), scale(end, end));
		signs.add(det(a[0], b[1], along) + det(a[1], b[0], along), scale(0, 1) + scale(1, 0));
	}
	return signs.turn();
}

// Three vectors by which others are measured, in a frame of their directions.
struct Frame
{
	Frame(const Vec3& u, const Vec3& v, const Vec3& w) : length{glm::length(u), glm::length(v), glm::length(w)}
	{
		const Vec3 unit[3] = {u / length[0], v / length[1], w / length[2]};
		for (int axis = 0; axis < 3; ++axis)
			normal[axis] = glm::cross(unit[(axis + 1) % 3], unit[(axis + 2) % 3]);
		volume = glm::dot(unit[0], normal[0]);
	}
	// Sum of the components' magnitudes, times |volume|.
	double size(const Vec3& v) const
	{
		return std::abs(glm::dot(v, normal[0])) + std::abs(glm::dot(v, normal[1])) + std::abs(glm::dot(v, normal[2]));
	}
	// The most it is for vectors that reach as far along each axis.
	double mostSize(const Vec3& reach) const
	{
		return glm::dot(reach, glm::abs(normal[0]) + glm::abs(normal[1]) + glm::abs(normal[2]));
	}
	// Three vectors that differ from the frame's by less than this size make, over their lengths, a diagonally dominant
	// matrix, so their determinant has the frame's sign; however thin a cell is.
	bool holds(int axis, double size) const { return size < (1.0 - 1e-9) * std::abs(volume) * length[axis]; }
	Turn turn() const { return volume > 0.0 ? Turn::positive : Turn::negative; }

	double length[3];
	Vec3 normal[3];
	double volume;
};

// The trilinear map about the cell's middle: terms of u, v and w, then what makes the edges along them differ. Decides
// the cells that are not far from a parallelepiped, of whatever proportions.
Turn turnOfPlainHexahedron(std::span<const Vec3> p)
{
	const Vec3 a[4] = {p[0] + p[1], p[3] + p[2], p[4] + p[5], p[7] + p[6]};
	const Vec3 d[4] = {p[1] - p[0], p[2] - p[3], p[5] - p[4], p[6] - p[7]};
	const Frame frame((d[0] + d[1]) + (d[2] + d[3]), (a[1] - a[0]) + (a[3] - a[2]), (a[2] - a[0]) + (a[3] - a[1]));
	const double uv = frame.size((d[1] - d[0]) + (d[3] - d[2]));
	const double uw = frame.size((d[2] - d[0]) + (d[3] - d[1]));
	const double vw = frame.size((a[0] - a[1]) + (a[3] - a[2]));
	const double uvw = frame.size((d[0] - d[1]) + (d[3] - d[2]));
	const bool plain = frame.holds(0, uv + uw + uvw) && frame.holds(1, uv + vw + uvw) && frame.holds(2, uw + vw + uvw);
	return plain ? frame.turn() : Turn::mixed;
}

// Uses the 27 Bernstein coefficients. Each edge along u depends on v and w to degree 1, and so on, so their determinant
// has degree 2 in each.
Turn turnOfHexahedron(std::span<const Vec3> p)
{
	if (const Turn turn = turnOfPlainHexahedron(p); turn != Turn::mixed)
		return turn;
	// By position along u, v, w.
	constexpr int at[2][2][2] = {{{0, 4}, {3, 7}}, {{1, 5}, {2, 6}}};
	Vec3 u[2][2];
	Vec3 v[2][2];
	Vec3 w[2][2];
	for (int i = 0; i < 2; ++i)
		for (int j = 0; j < 2; ++j)
		{
			u[i][j] = p[at[1][i][j]] - p[at[0][i][j]];
			v[i][j] = p[at[i][1][j]] - p[at[i][0][j]];
			w[i][j] = p[at[i][j][1]] - p[at[i][j][0]];
		}
	double value[27] = {};
	double scale[27] = {};
	for (int term = 0; term < 64; ++term)
	{
		const auto bit = [&](int b) { return term >> b & 1; };
		const Vec3& x = u[bit(0)][bit(1)]; // at v, w
		const Vec3& y = v[bit(2)][bit(3)]; // at u, w
		const Vec3& z = w[bit(4)][bit(5)]; // at u, v
		const int coefficient = bit(2) + bit(4) + 3 * (bit(0) + bit(5)) + 9 * (bit(1) + bit(3));
		value[coefficient] += det(x, y, z);
		scale[coefficient] += glm::length(x) * glm::length(y) * glm::length(z);
	}
	Signs signs;
	for (int coefficient = 0; coefficient < 27; ++coefficient)
		signs.add(value[coefficient], scale[coefficient]);
	return signs.turn();
}

} // namespace

std::span<const CornerFrame> cornerFrames(CellShape shape)
{
	switch (shape)
	{
	case CellShape::tetrahedron:
		return kTetrahedronCorners;
	case CellShape::hexahedron:
		return kHexahedronCorners;
	case CellShape::wedge:
		return kWedgeCorners;
	case CellShape::pyramid:
		return kPyramidCorners;
	default:
		return {};
	}
}

Turn turnOf(CellShape shape, std::span<const Vec3> points)
{
	switch (shape)
	{
	case CellShape::hexahedron:
		return turnOfHexahedron(points);
	case CellShape::wedge:
		return turnOfWedge(points);
	default:
		return turnOfCorners(shape, points);
	}
}

Turn turnOfEdges(const Box& u, const Box& v, const Box& w)
{
	const Frame frame(u.center(), v.center(), w.center());
	const auto holds = [&](int axis, const Box& box)
	{
		// Edges taken as differences of floats are off by 6e-8 of their own length along each axis.
		const Vec3 rounding = 1e-7 * glm::max(glm::abs(box.lo), glm::abs(box.hi));
		return frame.holds(axis, frame.mostSize(0.5 * box.size() + rounding));
	};
	return holds(0, u) && holds(1, v) && holds(2, w) ? frame.turn() : Turn::mixed;
}

bool orientedAlike(const CellFaces& faces)
{
	std::vector<std::pair<PointId, PointId>> edges;
	for (int f = 0; f < faces.size(); ++f)
		for (std::size_t i = 0; i < faces[f].size(); ++i)
			edges.emplace_back(faces[f][i], faces[f][(i + 1) % faces[f].size()]);
	std::ranges::sort(edges);
	return std::ranges::adjacent_find(edges) == edges.end() &&
	       std::ranges::all_of(edges, [&](const auto& edge)
	                           { return std::ranges::binary_search(edges, std::pair(edge.second, edge.first)); });
}

} // namespace vp::grid
