#include "grid/adjacency.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace vp::grid
{

namespace
{

constexpr std::uint32_t kEnd = 0xFFFFFFFFu;

// Faces with one lowest point, some 24 in a mesh of tetrahedra, are compared one with the other up to here; at the tip
// of a fan of thousands they are sorted.
constexpr std::size_t kMostCompared = 128;

// As many cells on one face know all the others; in larger crowds (cells given thousands of times) each knows the one
// before and the one after, which still leads to all.
constexpr std::size_t kMostLinked = 64;

// The distinct points of a face, ascending; kEnd in what is left of the four places. Faces of more than four
// are compared apart.
struct FaceKey
{
	std::array<PointId, 4> ids{kEnd, kEnd, kEnd, kEnd};

	PointId lowest() const { return ids[0]; }
	bool hasArea() const { return ids[2] != kEnd; }
	bool operator==(const FaceKey& other) const
	{
		return ids[1] == other.ids[1] && ids[2] == other.ids[2] && ids[3] == other.ids[3] && ids[0] == other.ids[0];
	}
	// The lowest is left out: only faces that share it are compared.
	std::uint32_t hash() const { return ids[1] * 0x9E3779B1u ^ ids[2] * 0x85EBCA77u ^ ids[3] * 0xC2B2AE3Du; }
};

void order(PointId& a, PointId& b)
{
	const PointId lower = std::min(a, b);
	b = std::max(a, b);
	a = lower;
}

// Of the points `corners` of a table shape, three or four.
inline FaceKey keyOf(const std::uint32_t* record, const std::array<std::uint8_t, 4>& corners, int size)
{
	FaceKey key;
	auto& ids = key.ids;
	for (int i = 0; i < 3; ++i)
		ids[i] = record[corners[i]];
	if (size == 4)
	{
		ids[3] = record[corners[3]];
		order(ids[0], ids[1]);
		order(ids[2], ids[3]);
		order(ids[0], ids[2]);
		order(ids[1], ids[3]);
		order(ids[1], ids[2]);
	}
	else
	{
		order(ids[0], ids[1]);
		order(ids[1], ids[2]);
		order(ids[0], ids[1]);
	}
	if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[3])
		std::fill(std::unique(ids.begin(), ids.begin() + size), ids.end(), kEnd);
	return key;
}

struct KeyedSlot
{
	FaceKey key;
	std::uint32_t slot;
};

// Faces with the same points.
struct Meeting
{
	FaceKey key;
	std::uint32_t first;
	std::uint32_t second = kEnd;
};

// Scratch of one thread.
struct Workspace
{
	std::vector<KeyedSlot> faces;      // with one lowest point
	std::vector<std::uint32_t> hashes; // of the meetings, apart so that a search stays in few cache lines
	std::vector<Meeting> meetings;
	std::vector<std::pair<std::uint32_t, std::uint32_t>> crowd; // meeting and slot of every third and further face
	std::vector<PointId> ids;
	struct Polygon
	{
		std::vector<PointId> points;
		std::uint32_t slot;
	};
	std::vector<Polygon> polygons;                  // faces of more than four points
	std::vector<std::vector<std::uint32_t>> crowds; // slots of faces that three or more cells share
};

class FaceMatcher
{
public:
	explicit FaceMatcher(const FaceSlots& faces) : faces_(faces) {}

	std::vector<std::vector<CellId>> match()
	{
		// A face is pushed on the chain of its lowest point; the chain runs through the slots that will hold the
		// neighbours, so that matching takes four bytes a point and no copy of the faces.
		heads_ = std::vector<std::atomic<std::uint32_t>>(faces_.points);
		tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces_.points, 65536),
		                  [&](const auto& range)
		                  {
			                  for (std::size_t p = range.begin(); p < range.end(); ++p)
				                  heads_[p].store(kEnd, std::memory_order_relaxed);
		                  });
		listPolyhedronOwners();
		tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces_.cells, 4096),
		                  [&](const auto& range) { chainFaces(range.begin(), range.end()); });
		tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces_.points, 2048),
		                  [&](const auto& range)
		                  {
			                  Workspace& work = workspaces_.local();
			                  for (std::size_t p = range.begin(); p < range.end(); ++p)
				                  matchChain(heads_[p].load(std::memory_order_relaxed), work);
		                  });
		settleCrowds();
		return std::move(several_);
	}

private:
	CellShape shape(CellId c) const
	{
		if (faces_.record_width == 4)
			return CellShape::tetrahedron;
		const std::uint32_t last = faces_.record(c)[7];
		return last >= faces_.shape_mark ? static_cast<CellShape>(last - faces_.shape_mark) : CellShape::hexahedron;
	}

	CellId cellOf(std::uint32_t slot) const
	{
		if (slot >= faces_.tableSlots())
			return polyhedron_owner_[slot - faces_.tableSlots()];
		return faces_.face_width == 4 ? slot / 4 : slot / 6;
	}

	std::span<const PointId> polygon(std::size_t face) const
	{
		const std::uint32_t begin = faces_.face_points_start[face];
		return faces_.face_points.subspan(begin, faces_.face_points_start[face + 1] - begin);
	}

	// The key of a polyhedron's face and, sorted in `ids`, its distinct points.
	FaceKey polygonKey(std::size_t face, std::vector<PointId>& ids) const
	{
		const std::span<const PointId> points = polygon(face);
		ids.assign(points.begin(), points.end());
		std::ranges::sort(ids);
		ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
		FaceKey key;
		std::copy_n(ids.begin(), std::min<std::size_t>(ids.size(), 4), key.ids.begin());
		return key;
	}

	void listPolyhedronOwners()
	{
		polyhedron_owner_.resize(faces_.count() - faces_.tableSlots());
		for (std::size_t n = 0; n < faces_.polyhedra.size(); ++n)
			for (std::uint32_t f = faces_.polyhedron_faces[n]; f < faces_.polyhedron_faces[n + 1]; ++f)
				polyhedron_owner_[f] = faces_.polyhedra[n];
	}

	void push(std::size_t slot, const FaceKey& key)
	{
		faces_.across(slot) =
		    key.hasArea() ? heads_[key.lowest()].exchange(static_cast<std::uint32_t>(slot), std::memory_order_relaxed)
		                  : kNoCell;
	}

	void chainFaces(std::size_t begin, std::size_t end)
	{
		std::vector<PointId>& ids = workspaces_.local().ids;
		for (std::size_t c = begin; c < end; ++c)
		{
			const CellShape cell_shape = shape(static_cast<CellId>(c));
			const std::uint32_t* record = faces_.record(c);
			std::size_t slot = c * faces_.face_width;
			const std::size_t cell_end = slot + faces_.face_width;
			if (cell_shape == CellShape::polyhedron)
				for (std::uint32_t f = faces_.polyhedron_faces[record[0]]; f < faces_.polyhedron_faces[record[0] + 1];
				     ++f)
					push(faces_.tableSlots() + f, polygonKey(f, ids));
			else
			{
				const ShapeTopology& table = topology(cell_shape);
				for (int f = 0; f < table.faces; ++f, ++slot)
					push(slot, keyOf(record, table.face[f], table.face_size[f]));
			}
			for (; slot < cell_end; ++slot)
				faces_.across(slot) = kNoCell;
		}
	}

	// All faces with one lowest point. Nothing else reads or writes their slots.
	void matchChain(std::uint32_t head, Workspace& work)
	{
		work.faces.clear();
		work.polygons.clear();
		for (std::uint32_t slot = head; slot != kEnd; slot = faces_.across(slot))
		{
			if (slot < faces_.tableSlots())
			{
				const CellId c = cellOf(slot);
				const ShapeTopology& table = topology(shape(c));
				const auto f = slot - std::size_t(c) * faces_.face_width;
				const std::uint32_t* record = faces_.record(c);
				work.faces.push_back({keyOf(record, table.face[f], table.face_size[f]), slot});
				continue;
			}
			const FaceKey key = polygonKey(slot - faces_.tableSlots(), work.ids);
			if (work.ids.size() <= 4)
				work.faces.push_back({key, slot});
			else
				work.polygons.push_back({work.ids, slot});
		}
		if (work.faces.size() > kMostCompared)
			joinEqual(
			    work.faces, [](const KeyedSlot& face) -> auto& { return face.key.ids; }, work);
		else
			compareFaces(work);
		if (!work.polygons.empty())
			joinEqual(
			    work.polygons, [](const Workspace::Polygon& face) -> auto& { return face.points; }, work);
	}

	void compareFaces(Workspace& work)
	{
		work.hashes.clear();
		work.meetings.clear();
		work.crowd.clear();
		for (const KeyedSlot& face : work.faces)
			meet(face.key, face.slot, work);
		for (const Meeting& meeting : work.meetings)
			join(meeting.first, meeting.second);
		if (!work.crowd.empty())
			gatherCrowds(work);
	}

	static void meet(const FaceKey& key, std::uint32_t slot, Workspace& work)
	{
		const std::uint32_t hash = key.hash();
		for (std::size_t m = 0; m < work.hashes.size(); ++m)
		{
			if (work.hashes[m] != hash || !(work.meetings[m].key == key))
				continue;
			if (work.meetings[m].second == kEnd)
				work.meetings[m].second = slot;
			else
				work.crowd.emplace_back(static_cast<std::uint32_t>(m), slot);
			return;
		}
		work.hashes.push_back(hash);
		work.meetings.push_back({key, slot});
	}

	void join(std::uint32_t first, std::uint32_t second)
	{
		faces_.across(first) = kNoCell;
		if (second == kEnd)
			return;
		faces_.across(second) = kNoCell;
		const CellId a = cellOf(first);
		const CellId b = cellOf(second);
		if (a == b)
			return;
		faces_.across(first) = b;
		faces_.across(second) = a;
	}

	static void gatherCrowds(Workspace& work)
	{
		std::ranges::sort(work.crowd);
		for (std::size_t i = 0; i < work.crowd.size();)
		{
			const std::uint32_t m = work.crowd[i].first;
			std::vector<std::uint32_t> slots{work.meetings[m].first, work.meetings[m].second};
			for (; i < work.crowd.size() && work.crowd[i].first == m; ++i)
				slots.push_back(work.crowd[i].second);
			work.crowds.push_back(std::move(slots));
		}
	}

	// Joins the faces whose points, which `points_of` gives, are the same.
	template <class Face, class PointsOf>
	void joinEqual(std::vector<Face>& faces, PointsOf&& points_of, Workspace& work)
	{
		std::ranges::sort(faces, {}, points_of);
		for (std::size_t i = 0; i < faces.size();)
		{
			std::size_t end = i + 1;
			while (end < faces.size() && points_of(faces[end]) == points_of(faces[i]))
				++end;
			join(faces[i].slot, end - i > 1 ? faces[i + 1].slot : kEnd);
			if (end - i > 2)
			{
				std::vector<std::uint32_t>& slots = work.crowds.emplace_back();
				for (std::size_t k = i; k < end; ++k)
					slots.push_back(faces[k].slot);
			}
			i = end;
		}
	}

	// In the order of their lowest slots, so that `several` does not depend on which thread found what.
	void settleCrowds()
	{
		std::vector<std::vector<std::uint32_t>> crowds;
		for (Workspace& work : workspaces_)
			std::ranges::move(work.crowds, std::back_inserter(crowds));
		for (std::vector<std::uint32_t>& slots : crowds)
			std::ranges::sort(slots);
		std::ranges::sort(crowds);
		for (const std::vector<std::uint32_t>& slots : crowds)
			linkCrowd(slots);
	}

	void linkCrowd(const std::vector<std::uint32_t>& slots)
	{
		std::vector<CellId> cells;
		for (const std::uint32_t slot : slots)
		{
			faces_.across(slot) = kNoCell;
			cells.push_back(cellOf(slot));
		}
		std::ranges::sort(cells);
		cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
		const std::size_t reach = cells.size() > kMostLinked ? 1 : cells.size() - 1;
		for (const std::uint32_t slot : slots)
		{
			const std::size_t own = std::ranges::lower_bound(cells, cellOf(slot)) - cells.begin();
			for (std::size_t step = 1; step <= reach; ++step)
			{
				addNeighbour(faces_.across(slot), cells[(own + step) % cells.size()], several_);
				if (cells.size() > kMostLinked)
					addNeighbour(faces_.across(slot), cells[(own + cells.size() - step) % cells.size()], several_);
			}
		}
	}

	const FaceSlots& faces_;
	std::vector<std::vector<CellId>> several_;
	std::vector<std::atomic<std::uint32_t>> heads_; // per point: the first slot of its chain
	std::vector<CellId> polyhedron_owner_;          // per face of a polyhedron: its cell
	tbb::enumerable_thread_specific<Workspace> workspaces_;
};

} // namespace

void addNeighbour(std::uint32_t& across, CellId other, std::vector<std::vector<CellId>>& several)
{
	if (across == kNoCell)
		across = other;
	else if (across >= kMaxBlockIds)
	{
		std::vector<CellId>& cells = several[across - kMaxBlockIds];
		const auto place = std::ranges::lower_bound(cells, other);
		if (place == cells.end() || *place != other)
			cells.insert(place, other);
	}
	else if (across != other)
	{
		several.push_back({std::min<CellId>(across, other), std::max<CellId>(across, other)});
		across = kMaxBlockIds + static_cast<std::uint32_t>(several.size() - 1);
	}
}

std::vector<std::vector<CellId>> matchFaces(const FaceSlots& faces)
{
	return FaceMatcher(faces).match();
}

} // namespace vp::grid
