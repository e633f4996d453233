#include "vectors/trace_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vp::vectors
{

namespace
{

constexpr int kTubeSides = 10; // round where shaded smoothly
constexpr int kLineSides = 6;

// Size of an arrow's head, in widths of its shaft.
constexpr double kHeadWidth = 3.2;
constexpr double kHeadLength = 5.0;
constexpr double kLongestHead = 0.45; // share of the whole arrow; else head and shaft are smaller

// Adds rings about a curve, and what lies between them.
class TubeMaker
{
public:
	TubeMaker(const Curves& curves, std::span<const double> values, int sides, TraceMesh& made)
	    : curves_(curves), values_(values), sides_(static_cast<std::uint32_t>(sides)), made_(made)
	{
	}

	void addTube(std::size_t curve, double width)
	{
		takeCurve(curve);
		for (std::size_t i = first_; i < end_; ++i)
		{
			const std::uint32_t ring = addRing(curves_.points[i], i, 0.5 * width);
			i == first_ ? addCap(ring, true) : addMantle(ring - sides_, ring);
		}
		addCap(lastRing(), false);
	}

	void addArrow(std::size_t curve, double width)
	{
		takeCurve(curve);
		const double length = lengthOfCurve();
		const double size = std::min(1.0, kLongestHead * length / (kHeadLength * width));
		const double radius = 0.5 * width * size;
		const double shaft = length - kHeadLength * width * size;
		addCap(addRing(curves_.points[first_], first_, radius), true);
		std::size_t i = first_ + 1;
		double gone = 0.0;
		double piece = glm::length(curves_.points[i] - curves_.points[i - 1]);
		for (; i + 1 < end_ && gone + piece < shaft; ++i)
		{
			gone += piece;
			const std::uint32_t ring = addRing(curves_.points[i], i, radius);
			addMantle(ring - sides_, ring);
			piece = glm::length(curves_.points[i + 1] - curves_.points[i]);
		}
		const Vec3 neck = glm::mix(curves_.points[i - 1], curves_.points[i], (shaft - gone) / piece);
		addHead(neck, i, radius);
	}

private:
	void takeCurve(std::size_t curve)
	{
		first_ = curves_.starts[curve];
		end_ = curves_.starts[curve + 1];
		across_ = directionsAcross(curves_, curve, Vec3(0.0));
	}

	double lengthOfCurve() const
	{
		double length = 0.0;
		for (std::size_t i = first_ + 1; i < end_; ++i)
			length += glm::length(curves_.points[i] - curves_.points[i - 1]);
		return length;
	}

	// From where the shaft ends to the curve's end. i: the point of the curve before which that is.
	void addHead(const Vec3& neck, std::size_t i, double radius)
	{
		const std::uint32_t shaft_end = addRing(neck, i, radius);
		addMantle(shaft_end - sides_, shaft_end);
		const std::uint32_t base = addRing(neck, i, kHeadWidth * radius);
		addMantle(shaft_end, base);
		const std::uint32_t tip = made_.addVertex(curves_.points[end_ - 1], values_[end_ - 1]);
		for (std::uint32_t k = 0; k < sides_; ++k)
			made_.addPolygon(std::array{base + k, base + (k + 1) % sides_, tip});
	}

	// Adds vertices that run right-handed about the curve's direction at its point i. Returns the first.
	std::uint32_t addRing(const Vec3& center, std::size_t i, double radius)
	{
		const Vec3 x = across_[i - first_];
		const Vec3 y = glm::cross(curves_.directions[i], x);
		const auto ring = static_cast<std::uint32_t>(made_.mesh.positions.size());
		for (std::uint32_t k = 0; k < sides_; ++k)
		{
			const double turn = 2.0 * std::numbers::pi * k / sides_;
			made_.addVertex(center + radius * (std::cos(turn) * x + std::sin(turn) * y), values_[i]);
		}
		return ring;
	}
	std::uint32_t lastRing() const { return static_cast<std::uint32_t>(made_.mesh.positions.size()) - sides_; }

	void addMantle(std::uint32_t before, std::uint32_t after)
	{
		for (std::uint32_t k = 0; k < sides_; ++k)
		{
			const std::uint32_t next = (k + 1) % sides_;
			made_.addPolygon(std::array{before + k, before + next, after + next, after + k});
		}
	}

	void addCap(std::uint32_t ring, bool begins)
	{
		cap_.clear();
		for (std::uint32_t k = 0; k < sides_; ++k)
			cap_.push_back(ring + (begins ? sides_ - 1 - k : k));
		made_.addPolygon(cap_);
	}

	const Curves& curves_;
	std::span<const double> values_;
	std::uint32_t sides_;
	TraceMesh& made_;
	std::size_t first_ = 0; // first point of the current curve
	std::size_t end_ = 0;
	std::vector<Vec3> across_;
	std::vector<std::uint32_t> cap_;
};

} // namespace

std::uint32_t TraceMesh::addVertex(const Vec3& place, double value)
{
	mesh.positions.push_back(place);
	values.push_back(value);
	return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void TraceMesh::addPolygon(std::span<const std::uint32_t> vertices)
{
	mesh.polygon_vertices.insert(mesh.polygon_vertices.end(), vertices.begin(), vertices.end());
	mesh.polygon_starts.push_back(static_cast<std::uint32_t>(mesh.polygon_vertices.size()));
	mesh.polygon_cells.push_back({0, kNoCell});
}

void addTubes(const Curves& curves, std::span<const double> values, double width, TraceMesh& mesh)
{
	TubeMaker maker(curves, values, kTubeSides, mesh);
	for (std::size_t c = 0; c < curves.count(); ++c)
		maker.addTube(c, width);
}

void addLines(const Curves& curves, std::span<const double> values, double width, TraceMesh& mesh)
{
	TubeMaker maker(curves, values, kLineSides, mesh);
	for (std::size_t c = 0; c < curves.count(); ++c)
		maker.addTube(c, width);
}

void addArrows(const Curves& curves, std::span<const double> values, double width, TraceMesh& mesh)
{
	TubeMaker maker(curves, values, kLineSides, mesh);
	for (std::size_t c = 0; c < curves.count(); ++c)
		maker.addArrow(c, width);
}

} // namespace vp::vectors
