#include "grid/link/adjacency.h"

#include "base/parallel_for.h"
#include "base/prefetch.h"
#include "grid/link/face_crowds.h"
#include "grid/link/face_meetings.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace vp::grid
{

namespace
{

// Scratch of one thread.
struct Workspace
{
	std::vector<KeyedSlot> faces; // with one lowest point
	Meetings meetings;
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

// kTetrahedra: there is nothing else, which the compiler is to know.
template <bool kTetrahedra>
class FaceMatcher
{
public:
	explicit FaceMatcher(const FaceSlots& faces)
	    : faces_(faces), records_(faces.records.data()), table_slots_(faces.tableSlots())
	{
	}

	std::vector<std::vector<CellId>> match()
	{
		// A face is pushed on the chain of its lowest point; the chain runs through the slots that will hold the
		// neighbors, so that matching takes four bytes a point and no copy of the faces.
		heads_ = std::vector<std::atomic<std::uint32_t>>(faces_.points);
		parallelFor(tbb::blocked_range<std::size_t>(0, faces_.points, 65536),
		            [&](const auto& range)
		            {
			            for (std::size_t p = range.begin(); p < range.end(); ++p)
				            heads_[p].store(kNoSlot, std::memory_order_relaxed);
		            });
		listPolyhedronOwners();
		parallelFor(tbb::blocked_range<std::size_t>(0, faces_.cells, 4096),
		            [&](const auto& range) { chainFaces(range.begin(), range.end()); });
		parallelFor(tbb::blocked_range<std::size_t>(0, faces_.points, 2048),
		            [&](const auto& range)
		            {
			            Workspace& work = workspaces_.local();
			            for (std::size_t p = range.begin(); p < range.end(); ++p)
			            {
				            fetchAhead(p);
				            matchChain(heads_[p].load(std::memory_order_relaxed), work);
			            }
		            });
		std::vector<std::vector<std::uint32_t>> crowds;
		for (Workspace& work : workspaces_)
			std::ranges::move(work.crowds, std::back_inserter(crowds));
		linkCrowds(
		    std::move(crowds), [&](std::uint32_t slot) { return cellOf(slot); },
		    [&](std::uint32_t slot) -> std::uint32_t& { return across(slot); }, several_);
		return std::move(several_);
	}

private:
	static constexpr std::size_t kWidth = kTetrahedra ? 4 : 8;
	static constexpr std::size_t kFaceWidth = kTetrahedra ? 4 : 6;

	// FaceSlots' own, for widths that are known.
	const std::uint32_t* recordOf(std::size_t cell) const { return records_ + cell * (kWidth + kFaceWidth); }
	std::uint32_t& across(std::size_t slot) const
	{
		if (!kTetrahedra && slot >= table_slots_)
			return faces_.polyhedron_neighbors[slot - table_slots_];
		return records_[slot + (slot / kFaceWidth + 1) * kWidth];
	}

	CellShape shape(CellId c) const
	{
		if constexpr (kTetrahedra)
			return CellShape::tetrahedron;
		const std::uint32_t last = recordOf(c)[kWidth - 1];
		return last >= faces_.shape_mark ? static_cast<CellShape>(last - faces_.shape_mark) : CellShape::hexahedron;
	}

	CellId cellOf(std::uint32_t slot) const
	{
		if (!kTetrahedra && slot >= table_slots_)
			return polyhedron_owner_[slot - faces_.tableSlots()];
		return slot / kFaceWidth;
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

	// lowest: of its points, kNoPoint where the face has no area.
	void push(std::size_t slot, PointId lowest)
	{
		across(slot) = lowest != kNoPoint
		                   ? heads_[lowest].exchange(static_cast<std::uint32_t>(slot), std::memory_order_relaxed)
		                   : kNoCell;
	}
	PointId lowestOfPolygon(std::size_t face, std::vector<PointId>& ids) const
	{
		const FaceKey key = polygonKey(face, ids);
		return key.hasArea() ? key.lowest() : kNoPoint;
	}

	void chainFaces(std::size_t begin, std::size_t end)
	{
		std::vector<PointId>& ids = workspaces_.local().ids;
		for (std::size_t c = begin; c < end; ++c)
		{
			const CellShape cell_shape = shape(static_cast<CellId>(c));
			const std::uint32_t* record = recordOf(c);
			std::size_t slot = c * kFaceWidth;
			const std::size_t cell_end = slot + kFaceWidth;
			if (cell_shape == CellShape::polyhedron)
				for (std::uint32_t f = faces_.polyhedron_faces[record[0]]; f < faces_.polyhedron_faces[record[0] + 1];
				     ++f)
					push(faces_.tableSlots() + f, lowestOfPolygon(f, ids));
			else
			{
				const ShapeTopology& table = topology(cell_shape);
				for (int f = 0; f < table.faces; ++f, ++slot)
					push(slot, lowestOf(record, table.face[f], table.face_size[f]));
			}
			for (; slot < cell_end; ++slot)
				across(slot) = kNoCell;
		}
	}

	// The first cell of a chain some points on and those about it: most of the chain is among them.
	void fetchAhead(std::size_t p) const
	{
		constexpr std::size_t kAhead = 16;
		constexpr std::intptr_t kLine = 64; // bytes in a cache line
		if (p + kAhead >= heads_.size())
			return;
		const std::uint32_t slot = heads_[p + kAhead].load(std::memory_order_relaxed);
		if (slot == kNoSlot)
			return;
		const auto at = reinterpret_cast<std::intptr_t>(&across(slot));
		for (int line = -2; line <= 3; ++line)
			vp::prefetch(reinterpret_cast<const void*>(at + line * kLine)); // outside the records there is no harm
	}

	// All faces with one lowest point. Nothing else reads or writes their slots.
	void matchChain(std::uint32_t head, Workspace& work)
	{
		work.faces.clear();
		work.polygons.clear();
		for (std::uint32_t slot = head; slot != kNoSlot; slot = across(slot))
		{
			if (kTetrahedra || slot < table_slots_)
			{
				const CellId c = cellOf(slot);
				const ShapeTopology& table = topology(shape(c));
				const auto f = slot - std::size_t(c) * kFaceWidth;
				const std::uint32_t* record = recordOf(c);
				KeyedSlot& face = work.faces.emplace_back();
				face.key = keyOf(record, table.face[f], table.face_size[f]);
				face.slot = slot;
				continue;
			}
			const FaceKey key = polygonKey(slot - faces_.tableSlots(), work.ids);
			if (work.ids.size() <= 4)
				work.faces.push_back({key, slot});
			else
				work.polygons.push_back({work.ids, slot});
		}
		if (work.faces.size() > kMaxCompared)
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
		work.crowd.clear();
		for (const KeyedSlot& face : work.faces)
			work.meetings.meet(face.key, face.slot,
			                   [&](std::uint32_t m, std::uint32_t slot) { work.crowd.emplace_back(m, slot); });
		for (const Meeting& meeting : work.meetings.all())
			join(meeting.first, meeting.second);
		if (!work.crowd.empty())
			gatherCrowds(work);
		work.meetings.clear();
	}

	void join(std::uint32_t first, std::uint32_t second)
	{
		across(first) = kNoCell;
		if (second == kNoSlot)
			return;
		across(second) = kNoCell;
		const CellId a = cellOf(first);
		const CellId b = cellOf(second);
		if (a == b)
			return;
		across(first) = b;
		across(second) = a;
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
			join(faces[i].slot, end - i > 1 ? faces[i + 1].slot : kNoSlot);
			if (end - i > 2)
			{
				std::vector<std::uint32_t>& slots = work.crowds.emplace_back();
				for (std::size_t k = i; k < end; ++k)
					slots.push_back(faces[k].slot);
			}
			i = end;
		}
	}

	const FaceSlots& faces_;
	std::uint32_t* records_;
	std::size_t table_slots_;
	std::vector<std::vector<CellId>> several_;
	std::vector<std::atomic<std::uint32_t>> heads_; // per point: the first slot of its chain
	std::vector<CellId> polyhedron_owner_;          // per face of a polyhedron: its cell
	tbb::enumerable_thread_specific<Workspace> workspaces_;
};

} // namespace

std::vector<std::vector<CellId>> matchFaces(const FaceSlots& faces)
{
	return faces.record_width == 4 ? FaceMatcher<true>(faces).match() : FaceMatcher<false>(faces).match();
}

} // namespace vp::grid
