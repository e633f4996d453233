#pragma once

#include "base/ids.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace vp::grid
{

/// Finds which of some faces of a block belong to one cell only, without knowing neighbors. Two cells have the same
/// face if the sets of its different points are equal, as in matchFaces() of grid/link/adjacency.h. Face: a type that
/// names a face, such as BoundaryIndex::Face.
template <class Face>
class LoneFaces
{
public:
	/// Adds a face. A face with fewer than three different points has no area and is left out.
	void add(std::span<const PointId> points, const Face& face)
	{
		points_.assign(points.begin(), points.end());
		std::ranges::sort(points_);
		points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
		if (points_.size() < 3)
			return;
		Entry entry{{kNoCell, kNoCell, kNoCell, kNoCell}, static_cast<std::uint32_t>(points_.size()), face};
		std::copy_n(points_.begin(), std::min(points_.size(), entry.lowest.size()), entry.lowest.begin());
		entries_.push_back(entry);
	}
	void add(const LoneFaces& more) { entries_.insert(entries_.end(), more.entries_.begin(), more.entries_.end()); }

	/// Returns these faces in no particular order.
	std::vector<Face> find()
	{
		std::ranges::sort(entries_, [](const Entry& a, const Entry& b) { return a.key() < b.key(); });
		std::vector<Face> found;
		for (std::size_t i = 0; i < entries_.size();)
		{
			const std::size_t first = i;
			while (i < entries_.size() && entries_[i].key() == entries_[first].key())
				++i;
			if (i == first + 1)
				found.push_back(entries_[first].face);
		}
		return found;
	}

private:
	/// A face with more points is known by its lowest points and their number. No two faces of a cell complex agree in
	/// these.
	struct Entry
	{
		std::array<PointId, 4> lowest;
		std::uint32_t points;
		Face face;

		auto key() const { return std::tie(points, lowest); }
	};

	std::vector<PointId> points_;
	std::vector<Entry> entries_;
};

} // namespace vp::grid
