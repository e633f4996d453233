#pragma once

#include "base/prefetch.h"
#include "mesh/edge_places.h"
#include "mesh/fan_sense.h"
#include "mesh/mesh_chunk.h"
#include "mesh/tidy_polygons.h"

namespace vp::mesh
{

// Writes a part to its place in a mesh.
template <grid::Grid G, class Reader, class Surface>
class MeshChunkWriter
{
public:
	// extent: of the grid's points. normal: of a plane; curved surfaces have their polygons turned to where the heights
	// rise.
	MeshChunkWriter(const G& grid, const Vec3& extent, const Reader& reader, std::uint32_t block,
	                const Surface& surface, const Vec3& normal, const MeshChunk& part, SheetMesh& mesh)
	    : grid_(grid), extent_(extent), reader_(reader), block_(block), surface_(surface), normal_(normal),
	      facing_(normal), part_(part), mesh_(mesh), positions_(part.edges.size()), parts_(part.edges.size()),
	      numbers_(part.edges.size()), rises_(kCurved ? part.edges.size() : 0)
	{
	}

	MeshCleanup write()
	{
		writeVertices();
		writePolygons();
		return doubts_;
	}

private:
	static constexpr bool kCurved = surface::kIsCurved<Surface>;
	static constexpr int kMaxCorners = Reader::kTetrahedra ? 4 : cases::kMaxPolygon; // a table's polygon

	static constexpr std::uint32_t kAhead = 16; // number of vertices whose edges' ends are fetched in advance

	void prefetchEnds(std::uint32_t vertex) const
	{
		if constexpr (requires { reader_.xyz(PointId{}); })
			if (vertex < part_.edges.size())
			{
				prefetch(reader_.xyz(positiveOf(part_.edges[vertex])));
				prefetch(reader_.xyz(negativeOf(part_.edges[vertex])));
			}
	}

	double heightAt(const Surface& surface, PointId p, const Vec3& place) const
	{
		if constexpr (kCurved)
			return surface::heightAt(grid_, surface, p);
		else
			return surface.signedDistance(place);
	}

	// Also places the vertices that another part writes: their polygons here are to be looked at.
	void writeVertices()
	{
		if constexpr (!kCurved && std::is_same_v<G, grid::UnstructuredGrid>)
			doubts_.at_points = grid_.coordinates().isDouble() ? placeInPlane<double>() : placeInPlane<float>();
		else
			doubts_.at_points = placeEach();
		std::uint32_t next = part_.first_vertex;
		std::uint32_t begin = 0;
		for (const auto& [vertex, number] : part_.foreign)
		{
			next = writeVertices(begin, vertex, next);
			numbers_[vertex] = number;
			begin = vertex + 1;
		}
		writeVertices(begin, static_cast<std::uint32_t>(part_.edges.size()), next);
	}
	// Writes the vertices [begin, end), which are this part's. Returns the number after theirs.
	std::uint32_t writeVertices(std::uint32_t begin, std::uint32_t end, std::uint32_t next)
	{
		const std::uint64_t* edges = part_.edges.data();
		const double* parts = parts_.data();
		EdgePoint* to = mesh_.edges.data() + next;
		std::uint32_t* numbers = numbers_.data();
		for (std::uint32_t v = begin; v < end; ++v)
		{
			*to++ = {block_, lowerOf(edges[v]), higherOf(edges[v]), parts[v]};
			numbers[v] = next + (v - begin);
		}
		std::copy_n(positions_.begin() + begin, end - begin, mesh_.positions.begin() + next);
		return next + (end - begin);
	}

	template <class Number>
	bool placeInPlane()
	{
		const Number* xyz = grid_.coordinates().template numbers<Number>();
		const std::uint64_t* edges = part_.edges.data();
		const std::size_t last = part_.edges.size() - 1;
		double* parts = parts_.data();
		Vec3* positions = positions_.data();
		return EdgePlaces<PlacedFrom::positive>(surface_).place(
		    part_.edges.size(),
		    [=](std::size_t v)
		    {
			    const std::uint64_t ahead = edges[std::min(v + kAhead, last)];
			    prefetch(xyz + 3 * std::size_t(positiveOf(ahead)));
			    prefetch(xyz + 3 * std::size_t(negativeOf(ahead)));
			    return edgeEnds(xyz, positiveOf(edges[v]), negativeOf(edges[v]));
		    },
		    [=](std::size_t v, double from_positive, TwoDoubles xy, double z)
		    {
			    // The part was made as 1 minus a number from 0 to 1. So taking it from 1 rounds nothing.
			    parts[v] = select(positiveOf(edges[v]) < negativeOf(edges[v]), from_positive, 1.0 - from_positive);
			    storeTwo(&positions[v].x, xy);
			    positions[v].z = z;
		    });
	}

	bool placeEach()
	{
		// Copies, that what is written cannot be thought to change what is read.
		const Reader reader = reader_;
		const Surface surface = surface_;
		bool at_points = false;
		for (std::uint32_t v = 0; v < part_.edges.size(); ++v)
		{
			prefetchEnds(v + kAhead);
			const PointId lower = lowerOf(part_.edges[v]);
			const PointId higher = higherOf(part_.edges[v]);
			const Vec3 a = reader.point(lower);
			const Vec3 b = reader.point(higher);
			const double da = heightAt(surface, lower, a);
			const double t = surface::crossingOf(surface, a, b, da, heightAt(surface, higher, b)); // the signs differ
			if constexpr (kCurved)
				rises_[v] = da >= 0.0 ? a - b : b - a;
			at_points |= t == 0.0 || t == 1.0;
			if constexpr (std::is_same_v<G, grid::UnstructuredGrid>)
				positions_[v] = placeOfAnyNumbering(a, b, t, da >= 0.0);
			else
				positions_[v] = placeOnEdge(a, b, t);
			parts_[v] = t;
		}
		return at_points;
	}

	void writePolygons()
	{
		const FanSense<kMaxCorners> sense(normal_, extent_, positions_.data());
		const std::uint32_t* ends = part_.ends.data();
		const std::uint32_t* corners = part_.corners.data();
		std::uint32_t* to = mesh_.polygon_vertices.data() + part_.first_corner;
		std::uint32_t* starts = mesh_.polygon_starts.data() + part_.first_polygon + 1;
		BlockCell* cells = mesh_.polygon_cells.data() + part_.first_polygon;
		const std::size_t polygons = part_.cells.size();
		// Numbers written behind a polygon belong to the next one, if this part has room for it.
		const std::size_t room = part_.corners.size();
		bool slivers = false;
		std::uint32_t begin = 0;
		for (std::size_t i = 0; i < polygons; ++i)
		{
			const std::uint32_t end = ends[i];
			if (kCurved || begin + kMaxCorners > room || !writeClear(sense, corners + begin, end - begin, to + begin))
				slivers |= !write(std::span(corners + begin, end - begin), to + begin);
			starts[i] = part_.first_corner + end;
			cells[i] = {block_, part_.cells[i]};
			begin = end;
		}
		doubts_.slivers = slivers;
	}

	// Writes a polygon in the plane that is certain to be no sliver and not to repeat a vertex, so that it runs
	// counter-clockwise. Returns false of others. kMaxCorners numbers are read and written, however many corners there
	// are.
	bool writeClear(const FanSense<kMaxCorners>& sense, const std::uint32_t* corners, std::uint32_t count,
	                std::uint32_t* to) const
	{
		if (count - 3 > kMaxCorners - 3)
			return false;
		std::uint32_t fan[kMaxCorners];
		for (std::uint32_t c = 0; c < kMaxCorners; ++c)
		{
			// The first corner behind the last. Bits in place of a choice: the compiler would branch.
			const std::uint32_t taken = 0u - static_cast<std::uint32_t>(c < count);
			fan[c] = corners[0] ^ ((corners[0] ^ corners[c]) & taken);
		}
		bool repeats = corners[count - 1] == fan[0];
		for (std::uint32_t c = 1; c < kMaxCorners; ++c)
			repeats |= (fan[c] == fan[c - 1]) & (c < count);
		const double area = sense.areaOf(fan);
		if (repeats | !sense.isClear(std::abs(area)))
			return false;
		const std::uint32_t* numbers = numbers_.data();
		if (area > 0.0)
			for (std::uint32_t c = 0; c < kMaxCorners; ++c)
				to[c] = numbers[fan[c]];
		else
			for (std::uint32_t c = 0; c < kMaxCorners; ++c)
				to[c] = numbers[corners[c < count ? count - 1 - c : 0]];
		return true;
	}

	// Writes any polygon. Returns whether it needs no tidying.
	bool write(std::span<const std::uint32_t> corners, std::uint32_t* to) const
	{
		std::ranges::copy(corners, to);
		const std::span polygon(to, corners.size());
		const bool clear = (kCurved ? Facing(riseOf(polygon)) : facing_).turn(positions_.data(), polygon);
		for (std::uint32_t& v : polygon)
			v = numbers_[v];
		return clear;
	}

	// Returns the direction in which the heights rise about a polygon: from its cell's points below to those above.
	Vec3 riseOf(std::span<const std::uint32_t> polygon) const
	{
		Vec3 rise(0.0);
		for (const std::uint32_t v : polygon)
			rise += rises_[v];
		return rise;
	}

	const G& grid_;
	const Vec3 extent_;
	const Reader& reader_;
	std::uint32_t block_;
	const Surface& surface_;
	const Vec3 normal_;
	const Facing facing_;
	const MeshChunk& part_;
	SheetMesh& mesh_;
	RawVector<Vec3> positions_;        // per vertex of the part
	RawVector<double> parts_;          // the same: t
	RawVector<std::uint32_t> numbers_; // the same, in the mesh
	RawVector<Vec3> rises_;            // per vertex, of a curved surface: along its edge, to the point above
	MeshCleanup doubts_;
};

} // namespace vp::mesh
