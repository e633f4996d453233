#pragma once

#include "base/prefetch.h"
#include "mesh/mesh_chunk.h"
#include "mesh/tidy_polygons.h"

namespace vp::mesh
{

// Writes a part to its place in a mesh.
template <grid::Grid G, class Reader, class Surface>
class MeshChunkWriter
{
public:
	// normal: of a plane; curved surfaces have their polygons turned to where the heights rise.
	MeshChunkWriter(const G& grid, const Reader& reader, std::uint32_t block, const Surface& surface,
	                const Vec3& normal, const MeshChunk& part, SheetMesh& mesh)
	    : grid_(grid), reader_(reader), block_(block), surface_(surface), facing_(normal), part_(part), mesh_(mesh),
	      positions_(part.edges.size()), numbers_(part.edges.size()), rises_(kCurved ? part.edges.size() : 0)
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

	static constexpr std::uint32_t kAhead = 16; // vertices, whose edges' ends are fetched in advance

	void prefetchEnds(std::uint32_t vertex) const
	{
		if constexpr (requires { reader_.xyz(PointId{}); })
			if (vertex < part_.edges.size())
			{
				prefetch(reader_.xyz(lowerOf(part_.edges[vertex])));
				prefetch(reader_.xyz(higherOf(part_.edges[vertex])));
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
		// Copies, that what is written cannot be thought to change what is read.
		const Reader reader = reader_;
		const Surface surface = surface_;
		Vec3* positions = positions_.data();
		std::uint32_t* numbers = numbers_.data();
		auto foreign = part_.foreign.begin();
		std::uint32_t next = part_.first_vertex;
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
				positions[v] = placeOfAnyNumbering(a, b, t, da >= 0.0);
			else
				positions[v] = placeOnEdge(a, b, t);
			if (foreign != part_.foreign.end() && foreign->first == v)
			{
				numbers[v] = foreign++->second;
				continue;
			}
			mesh_.edges[next] = {block_, lower, higher, t};
			mesh_.positions[next] = positions[v];
			numbers[v] = next++;
		}
		doubts_.at_points = at_points;
	}

	void writePolygons()
	{
		const Facing facing = facing_;
		const Vec3* positions = positions_.data();
		bool slivers = false;
		std::uint32_t begin = 0;
		std::uint32_t* corners = mesh_.polygon_vertices.data() + part_.first_corner;
		for (std::size_t i = 0; i < part_.cells.size(); ++i)
		{
			const std::uint32_t end = part_.ends[i];
			for (std::uint32_t c = begin; c < end; ++c)
				corners[c] = part_.corners[c];
			const std::span polygon(corners + begin, end - begin);
			slivers = !(kCurved ? Facing(riseOf(polygon)) : facing).turn(positions, polygon) || slivers;
			mesh_.polygon_starts[part_.first_polygon + i + 1] = part_.first_corner + end;
			mesh_.polygon_cells[part_.first_polygon + i] = {block_, part_.cells[i]};
			begin = end;
		}
		for (std::uint32_t c = 0; c < begin; ++c)
			corners[c] = numbers_[corners[c]];
		doubts_.slivers = slivers;
	}

	// Where the heights rise about a polygon: from its cell's points below to those above.
	Vec3 riseOf(std::span<const std::uint32_t> polygon) const
	{
		Vec3 rise(0.0);
		for (const std::uint32_t v : polygon)
			rise += rises_[v];
		return rise;
	}

	const G& grid_;
	const Reader& reader_;
	std::uint32_t block_;
	const Surface& surface_;
	const Facing facing_;
	const MeshChunk& part_;
	SheetMesh& mesh_;
	RawVector<Vec3> positions_;        // per vertex of the part
	RawVector<std::uint32_t> numbers_; // the same, in the mesh
	RawVector<Vec3> rises_;            // per vertex, of a curved surface: along its edge, to the point above
	MeshCleanup doubts_;
};

} // namespace vp::mesh
