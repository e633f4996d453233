#pragma once

#include "base/key_numbers.h"
#include "base/raw_vector.h"
#include "base/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace vp::refine
{

/// More parts than this are an error. Only cells that a sheet meets before any is refined can be so many.
inline constexpr std::size_t kMaxParts = 20'000'000;

/// Where a cell, or all cells of a cut, would get more parts than this, they are shown as far as they were refined.
inline constexpr std::size_t kMaxPartsOfCell = 10'000;
inline constexpr std::size_t kMaxPartsOfCut = 1'000'000;

/// The tolerance asks for more parts than can be made.
class TooManyParts : public std::length_error
{
public:
	using std::length_error::length_error;
};

/// A point of linear parts.
struct PartPoint
{
	static constexpr std::uint32_t kNode = 0xFFFFFFFFu;

	Vec3 position;
	Vec3 place;                          // in the coordinates of `cell`
	std::uint32_t cell = kNode;          // whose shape functions give the values; kNode: a node of the file
	std::array<std::uint32_t, 2> source; // the points that it lies between; twice the node of the file
};

/// Linear parts of curved cells. A point is known by the two points that it lies between, and a node of the file by its
/// number. So cells that share an edge share the points on it.
class PartList
{
public:
	explicit PartList(std::size_t expected_points) : numbers_(expected_points) {}
	/// Parts that are listed already. Nothing can be added.
	PartList(RawVector<PartPoint> points, RawVector<std::uint32_t> corners, RawVector<std::uint8_t> types,
	         RawVector<std::uint32_t> cells)
	    : numbers_(0), points_(std::move(points)), corners_(std::move(corners)), types_(std::move(types)),
	      cells_(std::move(cells))
	{
	}

	std::uint32_t node(std::uint32_t file_node, const Vec3& position)
	{
		return add({position, Vec3(0.0), PartPoint::kNode, {file_node, file_node}});
	}
	std::uint32_t between(std::uint32_t a, std::uint32_t b, const Vec3& position, const Vec3& place, std::uint32_t cell)
	{
		return add({position, place, cell, {std::min(a, b), std::max(a, b)}});
	}
	/// Adds a linear cell of VTK's type. cell: of which it is part.
	template <class Corners>
	void addPart(std::uint8_t vtk_type, const Corners& corners, std::uint32_t cell)
	{
		if (types_.size() >= kMaxParts)
			throw TooManyParts("too many parts");
		corners_.insert(corners_.end(), corners.begin(), corners.end());
		types_.push_back(vtk_type);
		cells_.push_back(cell);
	}
	/// Adds the parts of another list.
	void append(const PartList& other);

	const RawVector<PartPoint>& points() const { return points_; }
	const RawVector<std::uint32_t>& corners() const { return corners_; } // all parts', one after the other
	const RawVector<std::uint8_t>& types() const { return types_; }      // per part
	const RawVector<std::uint32_t>& cells() const { return cells_; }     // per part: its cell

private:
	std::uint32_t add(const PartPoint& point)
	{
		const std::uint64_t key = std::uint64_t(point.source[0]) << 32 | point.source[1];
		const auto [number, is_new] = numbers_.find(key, static_cast<std::uint32_t>(points_.size()));
		if (is_new)
			points_.push_back(point);
		return number;
	}

	KeyNumbers numbers_; // numbers of points
	RawVector<PartPoint> points_;
	RawVector<std::uint32_t> corners_;
	RawVector<std::uint8_t> types_;
	RawVector<std::uint32_t> cells_;
};

} // namespace vp::refine
