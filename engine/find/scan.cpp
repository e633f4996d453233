#include "find/scan.h"

#include "base/huge_vector.h"
#include "base/parallel_for.h"
#include "base/raw_vector.h"
#include "find/cell_signs.h"
#include "find/point_sides.h"
#include "grid/lone_faces.h"
#include "seed/boundary_cut.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>
#include <type_traits>

namespace vp::find
{

namespace
{

constexpr std::size_t kPoints = 1 << 16; // at a time
constexpr std::size_t kCells = 1 << 16;
constexpr std::size_t kRuns = 64;

using Sides = HugeVector<std::uint8_t>;

std::pair<CellId, std::uint32_t> placeOf(const FlatFace& flat)
{
	return {flat.face.cell, flat.face.face};
}

/// The sides of all points of a cell.
struct CellSides
{
	unsigned any = 0;

	void add(unsigned side) { any |= side; }
	bool isOnOneSide() const { return any == kPositive || any == kNegative; }
	bool isCut() const { return (any & (kPositive | kNegative)) == (kPositive | kNegative); }
	bool mayBeFlat() const { return any & kInSurface; }
	bool namesNoPoint() const { return any & kNoPoint; }
};

template <class Surface>
class Scanner
{
public:
	Scanner(const grid::UnstructuredGrid& grid, const Box& bounds, const Surface& surface,
	        const seed::SheetWindow* window, const grid::CellFilter& filter)
	    : grid_(grid), bounds_(bounds), surface_(surface), window_(window), filter_(filter),
	      checks_ids_(grid.list() && !grid.list()->has_checked_ids),
	      sides_(checks_ids_ ? std::bit_ceil(grid.pointCount()) : grid.pointCount())
	{
		for (int s = 0; s < grid::kTableShapes; ++s)
			codes_of_[s] = caseCodes(static_cast<grid::CellShape>(s));
	}

	/// Looks at the cells of runs that are in memory.
	Scan scan(const grid::CellRuns& all, std::span<const std::uint32_t> runs)
	{
		std::vector<std::uint32_t> parts; // each once
		for (const std::uint32_t run : runs)
			if (const std::uint32_t part = all.runs()[run].part; parts.empty() || parts.back() != part)
				parts.push_back(part);
		tracedFor(std::size_t(0), parts.size(),
		          [&](std::size_t part) { takeSides(grid_, surface_, all.pointsOf(parts[part]), sides_.data()); });
		parts_.resize((runs.size() + kRuns - 1) / kRuns);
		const auto scanRuns = [&](const auto& scanRange)
		{
			forParts(runs.size(), kRuns,
			         [&](std::size_t begin, std::size_t end, std::size_t part)
			         {
				         for (const std::uint32_t number : runs.subspan(begin, end - begin))
				         {
					         const grid::CellRuns::Run& run = all.runs()[number];
					         scanRange(run.first_cell, run.first_cell + run.cells, parts_[part]);
				         }
			         });
		};
		const grid::CellList& list = *grid_.list();
		if (list.offsets.empty())
			list.connectivity.as(
			    [&](auto ids) {
				    withPoints([&]<int kCount>()
				               { scanRuns([&](auto&&... range) { scanAlike<kCount>(ids.data(), range...); }); });
			    });
		else
			scanRuns([&](auto&&... range) { scanAny(range...); });
		Scan scan = joined();
		scan.cut.scanned = 0;
		for (const std::uint32_t run : runs)
			scan.cut.scanned += all.runs()[run].cells;
		return scan;
	}

	Scan scan()
	{
		std::fill(sides_.begin() + static_cast<std::ptrdiff_t>(grid_.pointCount()), sides_.end(), kNoPoint);
		forParts(grid_.pointCount(), kPoints,
		         [&](std::size_t begin, std::size_t end, std::size_t)
		         { takeSides(grid_, surface_, bounds_, begin, end, sides_.data()); });
		const grid::CellList* list = grid_.list();
		const std::size_t cells = list ? list->size() : grid_.cellCount();
		parts_.resize((cells + kCells - 1) / kCells);
		if (list && list->offsets.empty() && cells > 0)
			list->connectivity.as([&](auto ids) { scanAlike(ids.data(), cells); });
		else
			forParts(cells, kCells,
			         [&](std::size_t begin, std::size_t end, std::size_t part) { scanAny(begin, end, parts_[part]); });
		return joined();
	}

private:
	struct Part
	{
		RawVector<CellId> cells;
		RawVector<std::uint32_t> codes;
		grid::LoneFaces<FlatFace> flat;
		grid::CellFaces faces; // for several uses
	};

	/// Calls act(begin, end, part) for parts of a range, on all cores.
	template <class Act>
	static void forParts(std::size_t count, std::size_t grain, Act&& act)
	{
		tracedFor(std::size_t(0), (count + grain - 1) / grain,
		          [&](std::size_t part) { act(part * grain, std::min((part + 1) * grain, count), part); });
	}

	/// Cells of one shape, whose ids follow each other.
	template <class Id>
	void scanAlike(const Id* ids, std::size_t cells)
	{
		withPoints(
		    [&]<int kCount>()
		    {
			    forParts(cells, kCells,
			             [&](std::size_t begin, std::size_t end, std::size_t part)
			             { scanAlike<kCount>(ids, begin, end, parts_[part]); });
		    });
	}
	/// Calls act<POINTS OF A CELL>(), where all cells are alike.
	template <class Act>
	void withPoints(const Act& act) const
	{
		const int points = grid::topology(grid_.shape(0)).points;
		points == 4   ? act.template operator()<4>()
		: points == 5 ? act.template operator()<5>()
		: points == 6 ? act.template operator()<6>()
		              : act.template operator()<8>();
	}
	template <int kCount, class Id>
	void scanAlike(const Id* ids, std::size_t begin, std::size_t end, Part& part) const
	{
		if (checks_ids_)
			scanAlike<kCount, true>(ids, begin, end, part);
		else
			scanAlike<kCount, false>(ids, begin, end, part);
	}
	/// kChecks: there is a power of two of sides. So whatever an id is, its lower bits name one, and the upper bits of
	/// all ids together tell whether one of them is too great.
	template <int kCount, bool kChecks, class Id>
	void scanAlike(const Id* ids, std::size_t begin, std::size_t end, Part& part) const
	{
		using Bits = std::make_unsigned_t<Id>;
		const std::uint8_t* of = sides_.data();
		const auto mask = static_cast<Bits>(sides_.size() - 1);
		const bool is_voxel = grid_.list()->types[0] == grid::kVoxel;
		const std::uint32_t* codes = codes_of_[static_cast<std::size_t>(grid_.shape(0))];
		Bits bits = 0;
		for (std::size_t c = begin; c < end; ++c)
		{
			const Id* cell_ids = ids + c * kCount;
			CellSides sides;
			for (int v = 0; v < kCount; ++v)
			{
				const auto id = static_cast<Bits>(cell_ids[v]);
				if constexpr (kChecks)
					bits |= id;
				sides.add(of[kChecks ? id & mask : id]);
			}
			if (sides.isOnOneSide()) [[likely]]
				continue;
			if (kChecks && bits > mask)
				refuseIds();
			const auto code = [&]
			{
				unsigned index = 0;
				for (int v = 0; v < kCount; ++v)
					index |= (of[cell_ids[is_voxel ? grid::kVoxelOrder[v] : v]] & kPositive) << v;
				return codes[index];
			};
			take(static_cast<CellId>(c), sides, code, part);
		}
		if (kChecks && bits > mask)
			refuseIds();
	}
	/// One of them names no point.
	void refuseIds() const { grid::checkIds(grid_.list()->connectivity, grid_.pointCount()); }

	/// Cells of any shape, in either state of the grid.
	void scanAny(std::size_t begin, std::size_t end, Part& part) const
	{
		const grid::CellList* list = grid_.list();
		for (std::size_t c = begin; c < end; ++c)
		{
			if (list && !grid::isSliceable(list->types[c]))
				continue;
			const auto cell = static_cast<CellId>(c);
			CellSides sides;
			if (grid_.shape(cell) != grid::CellShape::polyhedron)
				for (const PointId p : grid_.cellPoints(cell))
					sides.add(sides_[p]);
			else
			{
				grid_.cellFaces(cell, part.faces);
				for (const PointId p : part.faces.points)
					sides.add(sides_[p]);
			}
			if (!sides.isOnOneSide())
				take(
				    cell, sides, [&] { return codeOf(cell); }, part);
		}
	}

	template <class Code>
	void take(CellId cell, const CellSides& sides, const Code& code, Part& part) const
	{
		if (sides.namesNoPoint())
			refuseIds();
		if (filter_ && !filter_(cell))
			return;
		if (sides.mayBeFlat())
			takeFlatFaces(cell, sides.isCut(), part);
		if (!sides.isCut() || (window_ && !isInWindow(cell, part.faces)))
			return;
		part.cells.push_back(cell);
		part.codes.push_back(code());
	}

	std::uint32_t codeOf(CellId cell) const
	{
		const grid::CellShape shape = grid_.shape(cell);
		if (shape == grid::CellShape::polyhedron)
			return shared::kCodeCut | shared::kCodeWalk;
		const grid::CellPoints points = grid_.cellPoints(cell);
		unsigned index = 0;
		for (int v = 0; v < points.size; ++v)
			index |= (sides_[points.id[v]] & kPositive) << v;
		return codes_of_[static_cast<std::size_t>(shape)][index];
	}

	bool isInWindow(CellId cell, grid::CellFaces& faces) const
	{
		if (window_->holdsCell(grid_, cell))
			return true;
		grid_.cellFaces(cell, faces);
		return window_->meets(seed::boxOf(grid_, faces.points)) && window_->meetsCell(grid_, surface_, faces);
	}

	void takeFlatFaces(CellId cell, bool is_cut, Part& part) const
	{
		grid_.cellFaces(cell, part.faces);
		for (int f = 0; f < part.faces.size(); ++f)
		{
			const std::span<const PointId> face = part.faces[f];
			if (std::ranges::all_of(face, [&](PointId p) { return (sides_[p] & kInSurface) != 0; }) &&
			    (!window_ || window_->meetsFlatFace(grid_, face)) && !hasNeighborAt(cell, f))
				part.flat.add(face, {{cell, static_cast<std::uint32_t>(f)}, is_cut});
		}
	}
	bool hasNeighborAt(CellId cell, int face) const
	{
		bool known = false;
		if (grid_.hasNeighbors())
			grid_.forEachNeighbor(cell, face, [&](CellId) { known = true; });
		return known;
	}

	Scan joined()
	{
		Scan scan;
		std::size_t count = 0;
		grid::LoneFaces<FlatFace> flat;
		std::vector<std::size_t> starts;
		for (const Part& part : parts_)
		{
			starts.push_back(count);
			count += part.cells.size();
			flat.add(part.flat);
		}
		scan.cut.cells.resize(count);
		scan.cut.codes.resize(count);
		for (std::size_t p = 0; p < parts_.size(); ++p)
		{
			std::ranges::copy(parts_[p].cells, scan.cut.cells.begin() + static_cast<std::ptrdiff_t>(starts[p]));
			std::ranges::copy(parts_[p].codes, scan.cut.codes.begin() + static_cast<std::ptrdiff_t>(starts[p]));
		}
		for (const std::uint32_t code : scan.cut.codes)
			scan.cut.cut_cells += (code & shared::kCodeCut) != 0;
		scan.cut.scanned = grid_.cellCount();
		scan.cut.closed = !window_ && !filter_ && !grid_.hasLinks();
		scan.flat = flat.find();
		std::ranges::sort(scan.flat, {}, placeOf);
		return scan;
	}

	const grid::UnstructuredGrid& grid_;
	const Box& bounds_;
	const Surface& surface_;
	const seed::SheetWindow* window_;
	const grid::CellFilter& filter_;
	bool checks_ids_;
	Sides sides_;
	std::array<const std::uint32_t*, grid::kTableShapes> codes_of_;
	std::vector<Part> parts_;
};

} // namespace

template <class Surface>
std::vector<std::uint32_t> runsMet(const grid::Block& block, const Surface& surface, const seed::SheetWindow* window)
{
	const auto find = [&]
	{
		if constexpr (surface::kIsCurved<Surface>)
			if (const surface::BlockValues* of = surface.values())
				return block.runs->holding(*of->field, of->component, of->value);
		return block.runs->meeting(surface);
	};
	std::vector<std::uint32_t> met = find();
	if (window)
		std::erase_if(met, [&](std::uint32_t run) { return !window->meets(block.runs->runs()[run].box); });
	return met;
}

template <class Surface>
Scan scanCells(const grid::Block& block, const Surface& surface, const seed::SheetWindow* window,
               const grid::CellFilter& filter)
{
	Scanner scanner(std::get<grid::UnstructuredGrid>(block.grid), block.bounds, surface, window, filter);
	return block.runs ? scanner.scan(*block.runs, runsMet(block, surface, window)) : scanner.scan();
}

template std::vector<std::uint32_t> runsMet(const grid::Block&, const surface::Plane&, const seed::SheetWindow*);
template std::vector<std::uint32_t> runsMet(const grid::Block&, const surface::BlockSurface&, const seed::SheetWindow*);
template Scan scanCells(const grid::Block&, const surface::Plane&, const seed::SheetWindow*, const grid::CellFilter&);
template Scan scanCells(const grid::Block&, const surface::BlockSurface&, const seed::SheetWindow*,
                        const grid::CellFilter&);

std::vector<std::vector<grid::BoundaryIndex::Face>> facesToShow(const grid::BlockSet& blocks,
                                                                std::span<const Scan> scans)
{
	std::vector<std::vector<grid::BoundaryIndex::Face>> all(scans.size());
	std::vector<std::vector<grid::BoundaryIndex::Face>> left(scans.size());
	const auto isShown = [&](const grid::SeamLink& link)
	{
		const std::pair place(link.other, link.other_face);
		return std::ranges::lower_bound(scans[link.block].flat, place, {}, placeOf)->shown;
	};
	for (std::size_t b = 0; b < scans.size(); ++b)
		for (const FlatFace& flat : scans[b].flat)
			all[b].push_back(flat.face);
	const grid::Interfaces seams = grid::interfacesAmong(blocks, all);
	for (std::uint32_t b = 0; b < scans.size(); ++b)
		for (const FlatFace& flat : scans[b].flat)
		{
			bool is_left = !flat.shown;
			if (const grid::BlockSeams* of_block = seams.of(b); is_left && of_block)
				for (const grid::SeamLink& link : of_block->of(flat.face.cell, flat.face.face))
				{
					const bool comes_first = link.hang != grid::Hang::none
					                             ? link.hang == grid::Hang::small
					                             : std::tie(b, flat.face.cell, flat.face.face) <
					                                   std::tie(link.block, link.other, link.other_face);
					is_left = is_left && !isShown(link) && comes_first;
				}
			if (is_left)
				left[b].push_back(flat.face);
		}
	return left;
}

} // namespace vp::find
