#include "pack_partitions.h"

#include <cstring>
#include <limits>
#include <span>

namespace vp::reader::convert
{

PackPartitions::PackPartitions(const PackDivision& division)
{
	constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
	for (std::size_t part = 0; part < division.parts(); ++part)
	{
		const auto points = static_cast<std::int64_t>(division.points(part).size());
		const auto ids = static_cast<std::int64_t>(division.ids(part));
		const auto faces = static_cast<std::int64_t>(division.faces(part));
		const auto face_ids = static_cast<std::int64_t>(division.faceIds(part));
		if (partitions_.empty() || partitions_.back().points + points > most || partitions_.back().ids + ids > most ||
		    partitions_.back().face_ids + face_ids > most)
			partitions_.emplace_back();
		Counts& all = partitions_.back();
		before_.push_back(all);
		all.points += points;
		all.cells += static_cast<std::int64_t>(division.cells(part).size());
		all.ids += ids;
		all.faces += faces;
		all.face_ids += face_ids;
	}
}

namespace
{

// Writes 32-bit numbers one behind the other.
class NumberWriter
{
public:
	explicit NumberWriter(std::byte* to) : to_(to) {}

	void put(std::int64_t number)
	{
		const auto narrow = static_cast<std::int32_t>(number);
		std::memcpy(to_, &narrow, sizeof(narrow));
		to_ += sizeof(narrow);
	}

private:
	std::byte* to_;
};

// Returns for each point of a part, by its number in the grid, that in its partition. Others may have any number.
std::span<const std::int32_t> numbersInPartition(const PackDivision& division, const PackPartitions& partitions,
                                                 std::size_t part)
{
	thread_local std::vector<std::int32_t> within;
	if (const auto points = division.points(part); !points.empty() && points.back() >= within.size())
		within.resize(points.back() + std::size_t(1));
	auto next = static_cast<std::int32_t>(partitions.before(part).points);
	for (const std::uint32_t point : division.points(part))
		within[point] = next++;
	return within;
}

} // namespace

void gatherIds(const PackDivision& division, const PackPartitions& partitions, std::size_t part, std::byte* to)
{
	const std::span<const std::int32_t> within = numbersInPartition(division, partitions, part);
	NumberWriter writer(to);
	division.withLists(
	    [&](const auto* offsets, const auto* ids)
	    {
		    for (const std::uint32_t cell : division.cells(part))
			    for (auto i = offsets[cell]; i < division.endOf(cell, offsets); ++i)
				    writer.put(within[static_cast<std::size_t>(ids[i])]);
	    });
}

void gatherOffsets(const PackDivision& division, const PackPartitions& partitions, std::size_t part, std::byte* to)
{
	NumberWriter writer(to);
	std::int64_t end = partitions.before(part).ids;
	if (partitions.before(part).cells == 0)
		writer.put(end);
	division.withLists(
	    [&](const auto* offsets, const auto*)
	    {
		    for (const std::uint32_t cell : division.cells(part))
			    writer.put(end += static_cast<std::int64_t>(division.endOf(cell, offsets) - offsets[cell]));
	    });
}

namespace
{

void gatherFaceIds(const PackDivision& division, const PackPartitions& partitions, std::size_t part, std::byte* to)
{
	const std::span<const std::int32_t> within = numbersInPartition(division, partitions, part);
	NumberWriter writer(to);
	for (const std::uint32_t cell : division.cells(part))
		division.polyhedra().forEachFace(cell,
		                                 [&](std::span<const vtkIdType> face)
		                                 {
			                                 for (const vtkIdType id : face)
				                                 writer.put(within[static_cast<std::size_t>(id)]);
		                                 });
}

void gatherFaceOffsets(const PackDivision& division, const PackPartitions& partitions, std::size_t part, std::byte* to)
{
	NumberWriter writer(to);
	std::int64_t end = partitions.before(part).face_ids;
	if (partitions.before(part).cells == 0)
		writer.put(end);
	for (const std::uint32_t cell : division.cells(part))
		division.polyhedra().forEachFace(cell, [&](std::span<const vtkIdType> face)
		                                 { writer.put(end += static_cast<std::int64_t>(face.size())); });
}

void gatherFaces(const PackDivision& division, const PackPartitions& partitions, std::size_t part, std::byte* to)
{
	NumberWriter writer(to);
	const std::int64_t first = partitions.before(part).faces;
	for (std::size_t face = 0; face < division.faces(part); ++face)
		writer.put(first + static_cast<std::int64_t>(face));
}

void gatherPolyhedronOffsets(const PackDivision& division, const PackPartitions& partitions, std::size_t part,
                             std::byte* to)
{
	NumberWriter writer(to);
	std::int64_t end = partitions.before(part).faces;
	if (partitions.before(part).cells == 0)
		writer.put(end);
	for (const std::uint32_t cell : division.cells(part))
	{
		division.polyhedra().forEachFace(cell, [&](std::span<const vtkIdType>) { ++end; });
		writer.put(end);
	}
}

} // namespace

std::vector<PackList> listsOfFaces(const PackDivision& division, const PackPartitions& partitions)
{
	const auto faces = [&](std::size_t part) { return division.faces(part); };
	const auto faceIds = [&](std::size_t part) { return division.faceIds(part); };
	const auto firstEnds = [&](std::size_t part) { return partitions.before(part).cells == 0 ? 1 : 0; };
	const auto faceEnds = [&, firstEnds](std::size_t part) { return division.faces(part) + firstEnds(part); };
	const auto cellEnds = [&, firstEnds](std::size_t part) { return division.cells(part).size() + firstEnds(part); };
	const auto by = [&](const auto& gather)
	{ return [&, gather](std::size_t part, std::byte* to) { gather(division, partitions, part, to); }; };
	const std::size_t count = partitions.partitions().size();
	return {{"FaceConnectivity", division.allFaceIds(), faceIds, by(gatherFaceIds)},
	        {"FaceOffsets", division.allFaces() + count, faceEnds, by(gatherFaceOffsets)},
	        {"PolyhedronToFaces", division.allFaces(), faces, by(gatherFaces)},
	        {"PolyhedronOffsets", division.types().size() + count, cellEnds, by(gatherPolyhedronOffsets)}};
}

} // namespace vp::reader::convert
