#pragma once

#include "lattice_sets.h"

#include <glm/vec2.hpp>

namespace vp::test
{

// A box in two polyhedra: a prism over a polygon that is simple, mostly concave, and lies within the box's base, and
// the rest of the box, which has a hole for it. Faces are listed either way round, points in any order.
struct PrismSet
{
	RawSet raw;                      // cell 0 is the prism, cell 1 the rest
	std::vector<glm::dvec2> polygon; // counter-clockwise
	double height;                   // height of the box over its base from (0, 0) to (1, 1), before it is placed
	Vec3 axes[3];                    // how it is placed: p -> shift + p.x axes[0] + p.y axes[1] + p.z axes[2]
	Vec3 shift;

	Vec3 placed(const Vec3& p) const { return shift + p.x * axes[0] + p.y * axes[1] + p.z * axes[2]; }
};

PrismSet prismSet(unsigned seed);

// Anywhere, across the prism's axis, along it, through points of the set.
TestPlane prismPlane(const PrismSet& set, unsigned seed);

// The section of a cell by a plane, by convex parts alone: the prism counts as the prisms over the triangles between
// the origin and its polygon's sides, with their signs.
struct PrismSection
{
	double area = 0.0;
	double moment = 0.0; // moment of linearAt()
};

PrismSection sectionOfPrism(const PrismSet& set, const TestPlane& plane);
PrismSection sectionOfBox(const PrismSet& set, const TestPlane& plane);

} // namespace vp::test
