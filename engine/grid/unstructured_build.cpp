#include "grid/unstructured.h"

#include "grid/adjacency.h"
#include "grid/morton.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace vp::grid
{

namespace
{

// VTK's cell type numbers.
constexpr std::uint8_t kTetra = 10;
constexpr std::uint8_t kVoxel = 11;
constexpr std::uint8_t kHexahedron = 12;
constexpr std::uint8_t kWedge = 13;
constexpr std::uint8_t kPyramid = 14;
constexpr std::uint8_t kPolyhedron = 42;

CellShape shapeOf(std::uint8_t vtk_type)
{
	switch (vtk_type)
	{
	case kTetra:
		return CellShape::tetrahedron;
	case kPyramid:
		return CellShape::pyramid;
	case kWedge:
		return CellShape::wedge;
	case kPolyhedron:
		return CellShape::polyhedron;
	case kVoxel:
	case kHexahedron:
		break;
	}
	return CellShape::hexahedron;
}

// A voxel's points lie in lattice order.
constexpr std::array<std::uint8_t, 8> kVoxelOrder{0, 1, 3, 2, 4, 5, 7, 6};

template <class Body>
void forRanges(std::size_t count, Body&& body)
{
	tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096),
	                  [&](const tbb::blocked_range<std::size_t>& range)
	                  {
		                  for (std::size_t i = range.begin(); i < range.end(); ++i)
			                  body(i);
	                  });
}

Box finiteBounds(const Points& points)
{
	return tbb::parallel_reduce(
	    tbb::blocked_range<std::size_t>(0, points.size(), 65536), Box{},
	    [&](const tbb::blocked_range<std::size_t>& range, Box box)
	    {
		    for (std::size_t p = range.begin(); p < range.end(); ++p)
			    if (const Vec3 x = points[p]; std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z))
				    box.include(x);
		    return box;
	    },
	    [](Box a, const Box& b)
	    {
		    a.include(b);
		    return a;
	    });
}

template <class Number>
Points gathered(const Points& points, const RawVector<std::uint32_t>& order)
{
	const std::shared_ptr<Number[]> xyz(new Number[3 * order.size()]);
	forRanges(order.size(),
	          [&](std::size_t p)
	          {
		          const Vec3 x = points[order[p]];
		          for (int axis = 0; axis < 3; ++axis)
			          xyz[3 * p + axis] = static_cast<Number>(x[axis]);
	          });
	return Points(Array<Number>(xyz, xyz.get(), 3 * order.size()));
}

} // namespace

// Builds the parts of a grid in the order they depend on each other.
class UnstructuredBuilder
{
public:
	UnstructuredBuilder(const Points& points, const CellList& cells) : points_(points), cells_(cells) {}

	UnstructuredGrid build(const std::vector<FaceLink>& links)
	{
		chooseCells();
		const MortonCurve curve(finiteBounds(points_));
		orderCells(curve);
		orderPoints(curve);
		writePolyhedra();
		writeRecords();
		matchCells(links);
		nameSources();
		return std::move(grid_);
	}

private:
	std::size_t keptCell(std::size_t n) const { return kept_.empty() ? n : kept_[n]; }
	bool isPolyhedron(std::size_t source) const { return cells_.types[source] == kPolyhedron; }

	// Calls visit(point id) for the points of a cell, of a polyhedron once per face.
	template <class Visit>
	void forEachPoint(std::size_t source, Visit&& visit) const
	{
		if (isPolyhedron(source))
			return forEachFace(source,
			                   [&](std::span<const std::int64_t> face)
			                   {
				                   for (const std::int64_t p : face)
					                   visit(p);
			                   });
		const std::int64_t* ids = cells_.connectivity.data() + cells_.offsets[source];
		const int count = topology(shapeOf(cells_.types[source])).points;
		for (int i = 0; i < count; ++i)
			visit(ids[i]);
	}

	template <class Visit>
	void forEachFace(std::size_t source, Visit&& visit) const
	{
		const std::int64_t* stream = cells_.face_stream.data() + cells_.face_offsets[source];
		std::int64_t faces = *stream++;
		for (; faces > 0; --faces)
		{
			visit(std::span(stream + 1, static_cast<std::size_t>(*stream)));
			stream += 1 + *stream;
		}
	}

	void chooseCells()
	{
		const std::size_t count = cells_.types.size();
		std::array<std::size_t, 256> of_type{};
		for (const std::uint8_t type : cells_.types.span())
			++of_type[type];
		std::size_t kept = 0;
		for (int type = 0; type < 256; ++type)
		{
			const auto vtk_type = static_cast<std::uint8_t>(type);
			if (isSliceable(vtk_type))
				kept += of_type[type];
			else if (const int dimension = vtkDimension(vtk_type); dimension >= 0 && dimension < 3)
				grid_.left_out_ += of_type[type];
		}
		if (kept > kMaxBlockIds || points_.size() > kMaxBlockIds)
			throw std::length_error("a block holds at most 3221225472 cells or points");
		if (count > 0xFFFFFFFFu)
			throw std::length_error("a block lists at most 4294967295 cells");
		if (kept < count)
		{
			kept_.reserve(kept);
			for (std::size_t c = 0; c < count; ++c)
				if (isSliceable(cells_.types[c]))
					kept_.push_back(c);
		}
		grid_.cell_count_ = kept;
		has_polyhedra_ = of_type[kPolyhedron] > 0;
		if (kept > 0 && kept == of_type[kTetra])
			grid_.width_ = grid_.face_width_ = 4;
	}

	void orderCells(const MortonCurve& curve)
	{
		const std::size_t count = grid_.cell_count_;
		std::unique_ptr<KeyedId[]> items(new KeyedId[count]);
		used_.resize(points_.size());
		forRanges(count,
		          [&](std::size_t n)
		          {
			          Vec3 sum(0.0);
			          int points = 0;
			          forEachPoint(keptCell(n),
			                       [&](std::int64_t p)
			                       {
				                       sum += points_[p];
				                       ++points;
				                       const std::atomic_ref<std::uint8_t> used(used_[p]);
				                       if (!used.load(std::memory_order_relaxed))
					                       used.store(1, std::memory_order_relaxed);
			                       });
			          items[n] = {curve(sum / static_cast<double>(points)), static_cast<std::uint32_t>(n)};
		          });
		sortByKey(items, count);
		grid_.source_cells_.resize(count);
		forRanges(count,
		          [&](std::size_t c) { grid_.source_cells_[c] = static_cast<std::uint32_t>(keptCell(items[c].id)); });
	}

	// Along the same curve as the cells; points of no cell at the end.
	void orderPoints(const MortonCurve& curve)
	{
		const std::size_t count = points_.size();
		std::unique_ptr<KeyedId[]> items(new KeyedId[count]);
		forRanges(count,
		          [&](std::size_t p)
		          {
			          const std::uint64_t unused_last = used_[p] ? 0 : MortonCurve::kLast + 1;
			          items[p] = {curve(points_[p]) | unused_last, static_cast<std::uint32_t>(p)};
		          });
		used_ = {};
		sortByKey(items, count);
		grid_.source_points_.resize(count);
		rank_.resize(count);
		forRanges(count,
		          [&](std::size_t p)
		          {
			          grid_.source_points_[p] = items[p].id;
			          rank_[items[p].id] = static_cast<std::uint32_t>(p);
		          });
		grid_.used_points_ = count;
		while (grid_.used_points_ > 0 && items[grid_.used_points_ - 1].key > MortonCurve::kLast)
			--grid_.used_points_;
		items.reset();
		grid_.points_ = points_.isDouble() ? gathered<double>(points_, grid_.source_points_)
		                                   : gathered<float>(points_, grid_.source_points_);
	}

	void writePolyhedra()
	{
		std::size_t faces = 0;
		std::size_t face_points = 0;
		std::vector<std::size_t> first_point;
		for (std::size_t c = 0; has_polyhedra_ && c < grid_.cell_count_; ++c)
		{
			const std::size_t source = grid_.source_cells_[c];
			if (!isPolyhedron(source))
				continue;
			polyhedra_.push_back(static_cast<CellId>(c));
			grid_.polyhedron_faces_.push_back(static_cast<std::uint32_t>(faces));
			first_point.push_back(face_points);
			const std::size_t cell_faces = cells_.face_stream[cells_.face_offsets[source]];
			forEachFace(source, [&](std::span<const std::int64_t> face) { face_points += face.size(); });
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
			          forEachFace(grid_.source_cells_[polyhedra_[n]],
			                      [&](std::span<const std::int64_t> ids)
			                      {
				                      grid_.face_points_start_[face++] = static_cast<std::uint32_t>(point);
				                      for (const std::int64_t p : ids)
					                      grid_.face_points_[point++] = rank_[p];
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
				          __builtin_prefetch(&cells_.offsets[grid_.source_cells_[c + kAhead]]);
			          if (c + kAhead / 2 < grid_.cell_count_)
				          __builtin_prefetch(cells_.connectivity.data() +
				                             cells_.offsets[grid_.source_cells_[c + kAhead / 2]]);
			          const CellShape shape = shapeOf(cells_.types[source]);
			          std::uint32_t* record = &grid_.records_[c * stride];
			          if (shape == CellShape::polyhedron)
				          return;
			          const std::int64_t* ids = cells_.connectivity.data() + cells_.offsets[source];
			          const bool voxel = cells_.types[source] == kVoxel;
			          const int count = topology(shape).points;
			          for (int i = 0; i < count; ++i)
				          record[i] = rank_[ids[voxel ? kVoxelOrder[i] : i]];
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
		rank_ = {};
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
		grid_.polyhedron_neighbours_.resize(faces.count() - faces.tableSlots());
		faces.polyhedron_neighbours = grid_.polyhedron_neighbours_;
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
			addNeighbour(faces.across(slotOf(a, link.face_a, faces)), b, grid_.several_);
			addNeighbour(faces.across(slotOf(b, link.face_b, faces)), a, grid_.several_);
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
		std::vector<bool> seen;
		grid_.source_cell_count_ = 0;
		for (const std::uint32_t source : grid_.source_cells_)
		{
			if (source >= seen.size())
				seen.resize(source + 1);
			grid_.source_cell_count_ += !seen[source];
			seen[source] = true;
		}
	}

	const Points& points_;
	const CellList& cells_;
	UnstructuredGrid grid_;
	std::vector<std::uint64_t> kept_; // source numbers of the cells, empty where all are
	std::vector<std::uint8_t> used_;  // per source point: whether a cell has it
	RawVector<std::uint32_t> rank_;   // of a source point in the grid
	std::vector<CellId> polyhedra_;
	bool has_polyhedra_ = false;
};

UnstructuredGrid UnstructuredGrid::build(const Points& points, const CellList& cells, std::vector<FaceLink> links)
{
	return UnstructuredBuilder(points, cells).build(links);
}

} // namespace vp::grid
