#pragma once

#include "shared/slice_types.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <random>
#include <vector>

namespace vp::render::test
{

// The square of half a side `half` about the origin in polygons without holes or laps: columns by rows of quadrangles
// with corners out of place, some cut along a diagonal, some along one that has a corner more, which rounding puts on
// one side of it or the other (`bends`). Values are within 0..1.
class Tiling
{
public:
	Tiling(std::mt19937& random, const glm::ivec2& sides, double half, bool bends);
	Tiling(std::mt19937& random, int side, double half, bool bends) : Tiling(random, {side, side}, half, bends) {}

	std::vector<vp::shared::PolygonRecord> records() const;

private:
	void addCell(std::mt19937& random, std::uint32_t a, std::uint32_t row, unsigned kinds);

	std::vector<glm::dvec2> points_;
	std::vector<std::vector<std::uint32_t>> polygons_; // their corners' numbers
};

} // namespace vp::render::test
