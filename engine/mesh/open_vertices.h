#pragma once

#include <cstdint>
#include <vector>

namespace vp::mesh
{

/// Tells the vertices around which polygons close a ring from those at an open rim, without a search. Each polygon adds
/// a number for the neighbor that follows a vertex and takes one away for the neighbor that comes before it: those of a
/// ring cancel each other. Where polygons wind in different ways, closed vertices may be taken for open ones. The other
/// way round there is a chance of 2^-64.
class OpenVertices
{
public:
	explicit OpenVertices(std::size_t vertices) : sums_(vertices), used_(vertices) {}

	/// An edge of a polygon, in the way that the polygon winds.
	void add(std::uint32_t from, std::uint32_t to)
	{
		sums_[from] += mixed(to);
		sums_[to] -= mixed(from);
		used_[from] = 1;
	}
	/// A vertex of no polygon is open.
	bool isOpen(std::uint32_t vertex) const { return sums_[vertex] != 0 || !used_[vertex]; }

private:
	/// Vigna's splitmix64: as good as random.
	static std::uint64_t mixed(std::uint64_t x)
	{
		x += 0x9E3779B97F4A7C15ull;
		x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9ull;
		x = (x ^ x >> 27) * 0x94D049BB133111EBull;
		return x ^ x >> 31;
	}

	std::vector<std::uint64_t> sums_;
	std::vector<std::uint8_t> used_;
};

} // namespace vp::mesh
