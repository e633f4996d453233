#pragma once

#include "pack_division.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vp::reader::convert
{

// The partitions of VTKHDF that hold the parts of a pack: as few as can be, since VTK takes longer for each than for
// the one before. Their lists have 32-bit numbers.
class PackPartitions
{
public:
	explicit PackPartitions(const PackDivision& division);

	// How much a partition, or what stands before a part in its partition, has.
	struct Counts
	{
		std::int64_t points = 0;
		std::int64_t cells = 0;
		std::int64_t ids = 0;
		std::int64_t faces = 0; // that polyhedra have
		std::int64_t face_ids = 0;
	};
	const std::vector<Counts>& partitions() const { return partitions_; }
	const Counts& before(std::size_t part) const { return before_[part]; }

private:
	std::vector<Counts> partitions_;
	std::vector<Counts> before_;
};

// Writes the lists of VTKHDF for a part, as int32: the points of each cell, numbered within the partition, and where
// the list of each cell ends there. A partition begins with one more end, 0.
void gatherIds(const PackDivision& division, const PackPartitions& partitions, std::size_t part, std::byte* to);
void gatherOffsets(const PackDivision& division, const PackPartitions& partitions, std::size_t part, std::byte* to);

// A list of VTKHDF with int32 numbers.
struct PackList
{
	const char* name;
	std::size_t rows;
	std::function<std::size_t(std::size_t part)> rowsOf;
	std::function<void(std::size_t part, std::byte* to)> gather;
};

// Returns those of polyhedra: the points of each face and where they end, the faces of each cell and where they end.
// Each cell has faces of its own, which follow each other. Both arguments are kept.
std::vector<PackList> listsOfFaces(const PackDivision& division, const PackPartitions& partitions);

} // namespace vp::reader::convert
