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

/// Finds out which of some faces of a block one cell alone has, where neighbors are not known. Two cells have the same
/// face where their sets of distinct points are equal, as in matchFaces() of grid/build/adjacency.h.
/// Face: what stands for a face, such as BoundaryIndex::Face.
template <class Face>
class LoneFaces
{
public:
	/// Faces of fewer than three distinct points have no area, and are left out.
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

	/// In no order.
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
	/// Faces of more points are told by their lowest ones and their number: no two of a cell complex have those alike.
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
