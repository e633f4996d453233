#pragma once

#include "refine/edge_table.h"
#include "refine/near_cells.h"
#include "refine/part_list.h"
#include "refine/unfinished.h"

#include <array>
#include <cstdint>
#include <stop_token>
#include <utility>
#include <vector>

namespace vp::refine
{

/// Refines cells of any kind where sheets meet them, all of them level by level: each tetrahedron halves the edge that
/// is off most. What an edge is off, and its middle, are computed once for all cells that share it.
class ShapeRefiner
{
public:
	/// The cells must outlive it.
	ShapeRefiner(const grid::CurvedCells& curved, const NearCells& cells, const Sheets& sheets, double reach);

	/// Throws TooManyParts. On a stop request it returns what it has. max_parts: of all cells.
	PartList refine(std::size_t max_parts, const std::stop_token& stop);

	/// Cells that would have got too many parts.
	const Unfinished& unfinished() const { return unfinished_; }

private:
	struct Part
	{
		std::array<std::uint32_t, 4> points;
		std::array<std::uint32_t, 6> edges;
		std::uint32_t near;
		std::uint32_t level; // level of edges that are not known yet
		std::array<Vec3f, 4> places;
	};
	struct DonePart
	{
		std::array<std::uint32_t, 4> points;
		std::uint32_t near;
	};
	/// An edge that a part does not know yet.
	struct Request
	{
		std::uint64_t key;
		std::uint32_t part;
		std::uint8_t edge;
		bool is_forced;
		double allowed;
	};
	using Requests = std::array<std::vector<Request>, EdgeTable::kShards>; // requests of a range of parts, by shard

	void makeFirstParts();
	void findEdges();
	void gather(std::size_t begin, std::size_t end, Requests& requests) const;
	void number(std::size_t shard, const std::vector<Requests>& requests);
	void evaluate(std::size_t shard, std::vector<double>& middles);
	double offOf(const EdgeTable::NewEdge& edge, const double* a, const double* b, const double* middle,
	             double* weights) const;
	void stopLargeCells(std::size_t max_parts, bool all);
	void halveParts();
	void halve(const Part& part, std::vector<Part>& halves, std::vector<DonePart>& done);
	bool mayMeet(const Part& part) const;
	const double* numbersOf(std::uint32_t point) const { return &numbers_[point * cells_.width()]; }
	Vec3 positionOf(std::uint32_t point) const;
	PartList list() const;

	const grid::CurvedCells& curved_;
	const NearCells& cells_;
	const Sheets& sheets_;
	double slack_;
	double least_; // allowed where the tolerance is less than rounding
	EdgeTable edges_;
	std::vector<Part> parts_;
	std::vector<DonePart> done_;
	std::vector<std::uint32_t> done_of_; // parts of each cell that are done, up to counted_
	std::size_t counted_ = 0;
	std::vector<std::uint8_t> is_stopped_; // per cell
	std::vector<std::uint8_t> is_unfinished_;
	bool all_are_stopped_ = false;
	Unfinished unfinished_;
	RawVector<PartPoint> points_; // positions are in numbers_
	RawVector<double> numbers_;   // per point: coordinates, and values as a share of their allowed error
};

} // namespace vp::refine
