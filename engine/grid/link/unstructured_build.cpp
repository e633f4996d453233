#include "base/prefetch.h"
#include "grid/link/adjacency.h"
#include "grid/link/cell_order.h"
#include "grid/link/for_ranges.h"
#include "grid/unstructured.h"

#include <bit>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace vp::grid
{

namespace
{

template <class Number>
Points gathered(const Points& points, const HugeVector<std::uint32_t>& order)
{
	const auto xyz = std::make_shared<HugeVector<Number>>(3 * order.size());
	Number* numbers = xyz->data();
	forRanges(order.size(),
	          [&](std::size_t p)
	          {
		          const Vec3 x = points[order[p]];
		          for (int axis = 0; axis < 3; ++axis)
			          numbers[3 * p + axis] = static_cast<Number>(x[axis]);
	          });
	return Points(Array<Number>(xyz, numbers, 3 * order.size()));
}

// Numbers the points of some cells in the order that they have among all.
class PartOfPoints
{
public:
	PartOfPoints(const UnstructuredGrid& listed, std::span<const CellId> cells)
	    : bits_(listed.pointCount() / kBits + 1, 0), before_(bits_.size(), 0)
	{
		for (const CellId cell : cells)
			listed.list()->forEachPoint(
			    cell,
			    [&](std::int64_t p) { bits_[static_cast<std::size_t>(p) / kBits] |= std::uint64_t(1) << p % kBits; });
		for (std::size_t word = 0; word < bits_.size(); ++word)
		{
			before_[word] = static_cast<std::uint32_t>(chosen_.size());
			for (std::uint64_t left = bits_[word]; left != 0; left &= left - 1)
				chosen_.push_back(static_cast<std::uint32_t>(word * kBits + std::countr_zero(left)));
		}
		if (chosen_.size() > std::numeric_limits<std::int32_t>::max())
			throw std::length_error("a part of a block holds at most 2147483647 points");
	}

	const HugeVector<std::uint32_t>& chosen() const { return chosen_; } // ascending
	std::int32_t rank(std::int64_t point) const
	{
		const std::size_t word = static_cast<std::size_t>(point) / kBits;
		const std::uint64_t below = bits_[word] & ((std::uint64_t(1) << point % kBits) - 1);
		return static_cast<std::int32_t>(before_[word]) + std::popcount(below);
	}

private:
	static constexpr std::size_t kBits = 64;

	std::vector<std::uint64_t> bits_;   // one for each point of the grid
	std::vector<std::uint32_t> before_; // those of the part before each word
	HugeVector<std::uint32_t> chosen_;
};

} // namespace

// Builds the parts of a grid in the order they depend on each other.
class UnstructuredBuilder
{
public:
	UnstructuredBuilder(const Points& points, const CellList& cells) : points_(points), cells_(cells) {}

	UnstructuredGrid build(const std::vector<FaceLink>& links)
	{
		takeOrder();
		writePolyhedra();
		writeRecords();
		matchCells(links);
		nameSources();
		return std::move(grid_);
	}

private:
	void takeOrder()
	{
		order_ = orderCells(points_, cells_);
		grid_.cell_count_ = order_.cells.size();
		grid_.left_out_ = order_.left_out;
		grid_.used_points_ = order_.used_points;
		if (order_.all_tetrahedra)
			grid_.width_ = grid_.face_width_ = 4;
		grid_.source_cells_ = std::move(order_.cells);
		grid_.source_points_ = std::move(order_.points);
		grid_.points_ = points_.isDouble() ? gathered<double>(points_, grid_.source_points_)
		                                   : gathered<float>(points_, grid_.source_points_);
	}

	void writePolyhedra()
	{
		std::size_t faces = 0;
		std::size_t face_points = 0;
		std::vector<std::size_t> first_point;
		for (std::size_t c = 0; order_.has_polyhedra && c < grid_.cell_count_; ++c)
		{
			const std::size_t source = grid_.source_cells_[c];
			if (!cells_.isPolyhedron(source))
				continue;
			polyhedra_.push_back(static_cast<CellId>(c));
			grid_.polyhedron_faces_.push_back(static_cast<std::uint32_t>(faces));
			first_point.push_back(face_points);
			const std::size_t cell_faces = cells_.faceCount(source);
			cells_.forEachFace(source, [&](std::span<const std::int64_t> face) { face_points += face.size(); });
			faces += cell_faces;
		}
		checkSlots(grid_.cell_count_ * grid_.face_width_ + faces);
		checkSlots(face_points);
		if (polyhedra_.empty())
			return;
		grid_.polyhedron_faces_.push_back(static_cast<std::uint32_t>(faces));
		grid_.face_points_start_.resize(faces + 1);
		grid_.face_points_start_[faces] = static_cast<std::uint32_t>(face_points);
		grid_.face_points_.resize(face_points);
		forRanges(polyhedra_.size(),
		          [&](std::size_t n)
		          {
			          std::uint32_t face = grid_.polyhedron_faces_[n];
			          std::size_t point = first_point[n];
			          cells_.forEachFace(grid_.source_cells_[polyhedra_[n]],
			                             [&](std::span<const std::int64_t> ids)
			                             {
				                             grid_.face_points_start_[face++] = static_cast<std::uint32_t>(point);
				                             for (const std::int64_t p : ids)
					                             grid_.face_points_[point++] = order_.rank[p];
			                             });
		          });
	}

	static void checkSlots(std::size_t count)
	{
		if (count > UnstructuredGrid::kMaxFaceSlots)
			throw std::length_error("a block holds at most 4294967295 cell faces");
	}

	void writeRecords()
	{
		constexpr std::size_t kAhead = 32; // cells, which may lie anywhere in the list
		const std::size_t width = grid_.width_;
		const std::size_t stride = grid_.recordStride();
		grid_.records_.resize(grid_.cell_count_ * stride);
		forRanges(grid_.cell_count_,
		          [&](std::size_t c)
		          {
			          const std::size_t source = grid_.source_cells_[c];
			          if (c + kAhead < grid_.cell_count_)
				          prefetchStart(grid_.source_cells_[c + kAhead]);
			          if (c + kAhead / 2 < grid_.cell_count_)
				          cells_.connectivity.prefetch(cells_.start(grid_.source_cells_[c + kAhead / 2]));
			          const CellShape shape = shapeOf(cells_.types[source]);
			          std::uint32_t* record = &grid_.records_[c * stride];
			          if (shape == CellShape::polyhedron)
				          return;
			          const int count = topology(shape).points;
			          for (int i = 0; i < count; ++i)
				          record[i] = order_.rank[cells_.point(source, i)];
			          // Ids that can be fetched, should a loop run over all eight.
			          for (std::size_t i = count; i < width; ++i)
				          record[i] = record[0];
			          if (width == 8 && count < 8)
				          record[7] = UnstructuredGrid::kShapeMark + static_cast<std::uint32_t>(shape);
		          });
		for (std::size_t n = 0; n < polyhedra_.size(); ++n)
		{
			std::uint32_t* record = &grid_.records_[std::size_t(polyhedra_[n]) * stride];
			record[0] = static_cast<std::uint32_t>(n);
			record[7] = UnstructuredGrid::kShapeMark + static_cast<std::uint32_t>(CellShape::polyhedron);
		}
		order_.rank = {};
	}

	void prefetchStart(std::size_t source) const
	{
		if (!cells_.offsets.empty())
			vp::prefetch(&cells_.offsets[source]);
	}

	void matchCells(const std::vector<FaceLink>& links)
	{
		FaceSlots faces;
		faces.records = grid_.records_;
		faces.record_width = grid_.width_;
		faces.face_width = grid_.face_width_;
		faces.cells = grid_.cell_count_;
		faces.points = grid_.used_points_;
		faces.shape_mark = UnstructuredGrid::kShapeMark;
		faces.polyhedra = polyhedra_;
		faces.polyhedron_faces = grid_.polyhedron_faces_;
		faces.face_points_start = grid_.face_points_start_;
		faces.face_points = grid_.face_points_;
		grid_.polyhedron_neighbors_.resize(faces.count() - faces.tableSlots());
		faces.polyhedron_neighbors = grid_.polyhedron_neighbors_;
		grid_.several_ = matchFaces(faces);
		grid_.has_links_ = !links.empty();
		if (grid_.has_links_)
			linkFaces(links, faces);
	}

	void linkFaces(const std::vector<FaceLink>& links, const FaceSlots& faces)
	{
		std::vector<CellId> stored(cells_.types.size(), kNoCell);
		forRanges(grid_.cell_count_, [&](std::size_t c) { stored[grid_.source_cells_[c]] = static_cast<CellId>(c); });
		for (const FaceLink& link : links)
		{
			const CellId a = stored[link.cell_a];
			const CellId b = stored[link.cell_b];
			if (a == kNoCell || b == kNoCell || a == b)
				continue;
			addNeighbor(faces.across(slotOf(a, link.face_a, faces)), b, grid_.several_);
			addNeighbor(faces.across(slotOf(b, link.face_b, faces)), a, grid_.several_);
		}
	}

	std::size_t slotOf(CellId cell, int face, const FaceSlots& faces) const
	{
		if (grid_.isPolyhedron(cell))
			return faces.tableSlots() + grid_.polyhedron_faces_[grid_.record(cell)[0]] + face;
		return std::size_t(cell) * faces.face_width + face;
	}

	// Up to here source_cells_ gives places in the list; from here on the file's cells.
	void nameSources()
	{
		grid_.source_point_count_ = cells_.source_points > 0 ? cells_.source_points : points_.size();
		grid_.source_cell_count_ = grid_.cell_count_;
		if (cells_.source_cells.empty())
			return;
		forRanges(grid_.cell_count_,
		          [&](std::size_t c) {
			          grid_.source_cells_[c] = static_cast<std::uint32_t>(cells_.source_cells[grid_.source_cells_[c]]);
		          });
		grid_.source_cell_count_ = countSources(cells_);
	}

	const Points& points_;
	const CellList& cells_;
	CellOrder order_;
	UnstructuredGrid grid_;
	std::vector<CellId> polyhedra_;
};

UnstructuredGrid UnstructuredGrid::listed(Points points, CellList cells)
{
	const CellCounts counts = countCells(points, cells);
	if (counts.alike && cells.connectivity.size() == cells.size() * topology(shapeOf(cells.types[0])).points)
		cells.offsets = {}; // they say no more
	UnstructuredGrid grid;
	grid.cell_count_ = counts.kept;
	grid.left_out_ = counts.left_out;
	grid.used_points_ = points.size();
	grid.source_point_count_ = cells.source_points > 0 ? cells.source_points : points.size();
	grid.source_cell_count_ = cells.source_cells.empty() ? counts.kept : countSources(cells);
	grid.points_ = std::move(points);
	grid.list_ = std::make_shared<const CellList>(std::move(cells));
	return grid;
}

UnstructuredGrid UnstructuredGrid::listedInRuns(Points points, CellList cells)
{
	UnstructuredGrid grid;
	grid.cell_count_ = grid.source_cell_count_ = cells.size();
	grid.used_points_ = grid.source_point_count_ = points.size();
	grid.points_ = std::move(points);
	grid.list_ = std::make_shared<const CellList>(std::move(cells));
	return grid;
}

UnstructuredGrid UnstructuredGrid::buildPart(const UnstructuredGrid& listed, std::span<const CellId> cells)
{
	const CellList& all = *listed.list();
	const PartOfPoints points(listed, cells);
	CellList part;
	std::vector<std::uint8_t> types;
	std::vector<std::int64_t> offsets{0}, sources(cells.begin(), cells.end());
	std::vector<std::int32_t> ids;
	std::vector<std::int64_t> faces, first_faces{0};
	for (const CellId cell : cells)
	{
		types.push_back(all.types[cell]);
		if (all.isPolyhedron(cell))
		{
			faces.push_back(static_cast<std::int64_t>(all.faceCount(cell)));
			all.forEachFace(cell,
			                [&](std::span<const std::int64_t> face)
			                {
				                faces.push_back(static_cast<std::int64_t>(face.size()));
				                for (const std::int64_t p : face)
					                faces.push_back(points.rank(p));
			                });
		}
		else
			all.forEachPoint(cell, [&](std::int64_t p) { ids.push_back(points.rank(p)); });
		offsets.push_back(static_cast<std::int64_t>(ids.size()));
		first_faces.push_back(static_cast<std::int64_t>(faces.size()));
	}
	if (!faces.empty())
	{
		part.face_offsets = std::move(first_faces);
		part.face_stream = std::move(faces);
	}
	part.types = std::move(types);
	part.offsets = std::move(offsets);
	part.connectivity = std::move(ids);
	part.source_cells = std::move(sources);
	UnstructuredGrid grid = build(listed.points_.isDouble() ? gathered<double>(listed.points_, points.chosen())
	                                                        : gathered<float>(listed.points_, points.chosen()),
	                              part);
	for (std::uint32_t& source : grid.source_points_)
		source = points.chosen()[source];
	grid.source_point_count_ = listed.source_point_count_;
	return grid;
}

UnstructuredGrid UnstructuredGrid::build(const Points& points, const CellList& cells, std::vector<FaceLink> links)
{
	if (!cells.has_checked_ids)
		checkIds(cells.connectivity, points.size());
	return UnstructuredBuilder(points, cells).build(links);
}

} // namespace vp::grid
