#pragma once

#include "base/key_numbers.h"
#include "mesh/clip.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::mesh
{

// Clips polygons of a mesh, one at a time, at one side after the other. The vertices that it makes on the rim are added
// to the mesh, and polygons share them.
class PolygonClipper
{
public:
	// A polygon, or a part of one.
	struct Loop
	{
		std::vector<std::uint32_t> corners;
		std::vector<std::uint8_t> is_added; // per corner; empty if no corner is added (SheetMesh::is_added)
	};

	PolygonClipper(const Vec3& origin, std::span<const ClipSide> sides, Corners corners, SheetMesh& mesh);

	// Leaves in part() and others() what is left of a polygon. Returns false where that is nothing.
	bool clip(std::span<const std::uint32_t> polygon, std::span<const std::uint8_t> is_added);
	const Loop& part() const { return part_; }
	std::vector<Loop>& others() { return others_; } // if the polygon is not convex

	// Where an edge lies on another across a seam, and both are cut at the side, the cuts are a pair as their ends are.
	void pairAcrossSeams(unsigned side);

private:
	// A vertex made on the rim, where a side cuts the edge between two others.
	struct Cut
	{
		std::uint32_t from;
		std::uint32_t to;
		unsigned side;
	};

	double within(std::uint32_t v, unsigned side) const;
	bool clipPart(unsigned side);
	bool clipAt(unsigned side);
	bool staysAdded(std::size_t i, unsigned side) const;
	void partAlong(unsigned side);
	bool isOnRim(std::uint32_t v) const { return v >= first_made_; }
	std::uint32_t cutOf(std::uint32_t a, std::uint32_t b, unsigned side);

	Vec3 origin_;
	std::span<const ClipSide> sides_;
	Corners corners_;
	SheetMesh& mesh_;
	std::size_t first_made_;          // vertex
	std::vector<KeyNumbers> numbers_; // per side
	std::vector<Cut> made_;           // per vertex from first_made_
	Loop part_;
	Loop whole_;               // what part_ is clipped from
	std::vector<Loop> others_; // parts of the same polygon
};

} // namespace vp::mesh
