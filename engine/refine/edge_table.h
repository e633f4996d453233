#pragma once

#include "base/key_numbers.h"
#include "base/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vp::refine
{

/// The edges of all parts, known by their ends. They lie in shards, each of which one core works on: so there are no
/// locks, and the numbers do not depend on how many cores there are.
class EdgeTable
{
public:
	static constexpr std::uint32_t kUnknown = 0xFFFFFFFFu;
	static constexpr std::size_t kShards = 64;

	struct Edge
	{
		double priority = -1.0;         // above 0 if it has to be halved: how far its middle is off
		std::uint32_t point = kUnknown; // its middle
		std::uint8_t level = 0;         // how often edges were halved for it
		std::uint8_t is_halved = 0;     // by a part
	};
	/// An edge that a part has, and nobody asked for before.
	struct NewEdge
	{
		std::uint32_t number; // number in its shard
		std::uint32_t near;   // the cell whose shape functions give its middle
		std::array<std::uint32_t, 2> ends;
		std::array<Vec3f, 2> places; // places of the ends in the cell's coordinates
		double allowed;              // allowed error of the middle
		bool is_forced;              // the edge is always halved
		std::uint32_t point;         // its middle, as an index into the shard's list
	};
	struct Shard
	{
		KeyNumbers numbers{64};
		std::vector<Edge> edges;
		std::vector<NewEdge> made;
	};

	static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b)
	{
		return a < b ? std::uint64_t(a) << 32 | b : std::uint64_t(b) << 32 | a;
	}
	static std::size_t shardOf(std::uint64_t key)
	{
		key ^= key >> 32;
		return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ull) >> 58);
	}

	Shard& shard(std::size_t s) { return shards_[s]; }
	Edge& operator[](std::uint32_t edge) { return shards_[edge % kShards].edges[edge / kShards]; }
	const Edge& operator[](std::uint32_t edge) const { return shards_[edge % kShards].edges[edge / kShards]; }
	static std::uint32_t idOf(std::size_t shard, std::uint32_t number)
	{
		return static_cast<std::uint32_t>(number * kShards + shard);
	}
	static constexpr std::uint32_t kMaxNumber = kUnknown / kShards - 1;

private:
	std::array<Shard, kShards> shards_;
};

} // namespace vp::refine
