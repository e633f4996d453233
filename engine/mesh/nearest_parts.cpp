#include "mesh/nearest_parts.h"

#include "base/parallel_for.h"
#include "grid/shown_value.h"
#include "mesh/nearest_point_cells.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <unordered_map>

namespace vp::mesh
{

namespace
{

constexpr std::size_t kPolygonsAtOnce = 512;

// The points of a cell, each once.
template <grid::Grid G>
void takePoints(const G& grid, CellId cell, std::vector<PointId>& points)
{
	points.clear();
	if (grid.shape(cell) != grid::CellShape::polyhedron)
	{
		for (const PointId p : grid.cellPoints(cell))
			points.push_back(p);
		return;
	}
	grid::CellFaces faces;
	grid.cellFaces(cell, faces);
	points = faces.points;
	std::ranges::sort(points);
	points.erase(std::unique(points.begin(), points.end()), points.end());
}

// The parts of one polygon whose cell has several values.
struct Parted
{
	std::size_t polygon;
	std::vector<NearestPointCells::Corner> corners;
	std::vector<NearestPointCells::Part> parts;
};

// The result for a chunk of polygons.
struct ChunkParts
{
	std::vector<double> values; // one for each polygon; it counts if the polygon stays as it is
	std::vector<Parted> parted;
};

class Parting
{
public:
	Parting(const grid::BlockSet& blocks, const SheetMesh& mesh, std::span<const grid::Field* const> fields,
	        int component)
	    : blocks_(blocks), mesh_(mesh), fields_(fields), component_(component)
	{
	}

	ChunkParts partsOf(std::size_t begin, std::size_t end) const
	{
		ChunkParts chunk;
		NearestPointCells cells;
		std::vector<PointId> ids;
		std::vector<ValuedPoint> points;
		std::vector<Vec3> places;
		for (std::size_t p = begin; p < end; ++p)
		{
			takeValues(mesh_.polygon_cells[p], ids, points);
			chunk.values.push_back(points.empty() ? std::numeric_limits<double>::quiet_NaN() : points[0].value);
			const auto isSame = [&](const ValuedPoint& at)
			{ return at.value == points[0].value || (std::isnan(at.value) && std::isnan(points[0].value)); };
			if (std::ranges::all_of(points, isSame))
				continue;
			places.clear();
			for (const std::uint32_t v : mesh_.polygon(p))
				places.push_back(mesh_.positions[v]);
			cells.part(places, points);
			if (cells.parts().size() == 1)
				chunk.values.back() = cells.parts()[0].value;
			else if (!cells.parts().empty())
				chunk.parted.push_back({p, cells.corners(), cells.parts()});
		}
		return chunk;
	}

private:
	// Nothing where the block lacks the array.
	void takeValues(const BlockCell& at, std::vector<PointId>& ids, std::vector<ValuedPoint>& points) const
	{
		points.clear();
		const grid::Field* field = fields_[at.block];
		if (!field || component_ >= field->components)
			return;
		std::visit(
		    [&](const auto& grid)
		    {
			    takePoints(grid, at.cell, ids);
			    for (const PointId p : ids)
				    points.push_back({grid.point(p), grid::shownValue(*field, grid.sourcePoint(p), component_)});
		    },
		    blocks_.blocks[at.block].grid);
	}

	const grid::BlockSet& blocks_;
	const SheetMesh& mesh_;
	std::span<const grid::Field* const> fields_;
	int component_;
};

// Writes the polygons that stay and the parts of others, in their order.
class PartWriter
{
public:
	PartWriter(const SheetMesh& from, NearestParts& to) : from_(from), to_(to)
	{
		to.mesh.positions = from.positions;
		to.mesh.edges = from.edges;
		to.mesh.rim_starts = from.rim_starts;
		to.mesh.rim_shares = from.rim_shares;
		to.mesh.polygon_starts.push_back(0);
		to.mesh.seam_pairs = from.seam_pairs;
		to.mesh.cells_twisted = from.cells_twisted;
		to.mesh.flat = from.flat;
	}

	void keep(std::size_t polygon, double value)
	{
		for (std::uint32_t corner = from_.polygon_starts[polygon]; corner < from_.polygon_starts[polygon + 1]; ++corner)
			addCorner(from_.polygon_vertices[corner], false, !from_.is_added.empty() && from_.is_added[corner]);
		close(polygon, value);
	}

	void add(const Parted& parted)
	{
		constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
		vertices_.assign(parted.corners.size(), kNone);
		for (const NearestPointCells::Part& part : parted.parts)
			for (const std::uint32_t corner : part.corners)
				if (vertices_[corner] == kNone)
					vertices_[corner] = vertexAt(parted.polygon, parted.corners[corner]);
		for (const NearestPointCells::Part& part : parted.parts)
		{
			for (std::size_t i = 0; i < part.corners.size(); ++i)
			{
				const std::uint32_t from = part.corners[i];
				const std::uint32_t to = part.corners[(i + 1) % part.corners.size()];
				addCorner(vertices_[from], NearestPointCells::sharedSide(parted.corners[from], parted.corners[to]) < 0,
				          false);
			}
			close(parted.polygon, part.value);
		}
	}

	void finish()
	{
		if (std::ranges::find(is_inner_, 1) != is_inner_.end())
			to_.mesh.is_inner = std::move(is_inner_);
		if (!from_.is_added.empty())
			to_.mesh.is_added = std::move(is_added_);
	}

private:
	// A place on a side of polygons, however they name it.
	struct OnSide
	{
		std::uint32_t low;
		std::uint32_t high;
		std::int64_t place;

		bool operator==(const OnSide&) const = default;
	};
	struct HashOnSide
	{
		std::size_t operator()(const OnSide& at) const
		{
			return (std::size_t(at.low) * 0x9e3779b97f4a7c15u ^ at.high) * 0x9e3779b97f4a7c15u ^
			       static_cast<std::size_t>(at.place);
		}
	};

	std::uint32_t newVertex(const Vec3& place)
	{
		to_.mesh.positions.push_back(place);
		to_.mesh.rim_starts.push_back(static_cast<std::uint32_t>(to_.mesh.rim_shares.size()));
		return static_cast<std::uint32_t>(to_.mesh.positions.size() - 1);
	}

	std::uint32_t vertexAt(std::size_t polygon, const NearestPointCells::Corner& corner)
	{
		constexpr double kSteps = 1 << 30; // a side has so many
		const auto corners = from_.polygon(polygon);
		if (corner.vertex >= 0)
			return corners[static_cast<std::size_t>(corner.vertex)];
		if (corner.sides[0] < 0)
			return newVertex(corner.place);
		const auto side = static_cast<std::size_t>(corner.sides[0]);
		const auto [low, high] = std::minmax({corners[side], corners[side + 1 < corners.size() ? side + 1 : 0]});
		const Vec3 way = from_.positions[high] - from_.positions[low];
		const double part = glm::dot(corner.place - from_.positions[low], way) / glm::dot(way, way);
		const OnSide place{low, high, std::llround(part * kSteps)};
		const auto known = on_sides_.find(place);
		return known != on_sides_.end() ? known->second : (on_sides_[place] = newVertex(corner.place));
	}

	void addCorner(std::uint32_t vertex, bool is_inner, bool is_added)
	{
		to_.mesh.polygon_vertices.push_back(vertex);
		is_inner_.push_back(is_inner);
		is_added_.push_back(is_added);
	}

	void close(std::size_t polygon, double value)
	{
		to_.mesh.polygon_starts.push_back(static_cast<std::uint32_t>(to_.mesh.polygon_vertices.size()));
		to_.mesh.polygon_cells.push_back(from_.polygon_cells[polygon]);
		to_.mesh.boundary_polygons += polygon >= from_.polygons() - from_.boundary_polygons;
		to_.values.push_back(value);
	}

	const SheetMesh& from_;
	NearestParts& to_;
	std::vector<std::uint32_t> vertices_; // by the number of a corner, if a part has it
	std::unordered_map<OnSide, std::uint32_t, HashOnSide> on_sides_;
	std::vector<std::uint8_t> is_inner_;
	std::vector<std::uint8_t> is_added_;
};

} // namespace

NearestParts nearestParts(const grid::BlockSet& blocks, const SheetMesh& mesh,
                          std::span<const grid::Field* const> fields, int component)
{
	const std::size_t count = mesh.polygons();
	std::vector<ChunkParts> chunks((count + kPolygonsAtOnce - 1) / kPolygonsAtOnce);
	const Parting parting(blocks, mesh, fields, component);
	tracedFor(std::size_t(0), chunks.size(),
	          [&](std::size_t chunk)
	          {
		          const std::size_t begin = chunk * kPolygonsAtOnce;
		          chunks[chunk] = parting.partsOf(begin, std::min(begin + kPolygonsAtOnce, count));
	          });
	NearestParts parts;
	PartWriter writer(mesh, parts);
	for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
	{
		auto next = chunks[chunk].parted.begin();
		for (std::size_t i = 0; i < chunks[chunk].values.size(); ++i)
		{
			const std::size_t polygon = chunk * kPolygonsAtOnce + i;
			if (next != chunks[chunk].parted.end() && next->polygon == polygon)
				writer.add(*next++);
			else
				writer.keep(polygon, chunks[chunk].values[i]);
		}
	}
	writer.finish();
	return parts;
}

} // namespace vp::mesh
