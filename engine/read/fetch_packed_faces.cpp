// How faces of polyhedra are read from a pack and checked (packed_cells.h).
#include "read/cell_types.h"
#include "read/check_mesh.h"
#include "read/packed_cells.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::read
{

// Where the ends of a run's faces begin, with that of the face before. As the ends of cells, they have one more in each
// partition.
std::uint64_t PackedCells::firstFaceEndOf(std::uint32_t number) const
{
	const std::uint32_t part = runs()[number].part;
	return first_faces_[number].face + (contents_.first_ends[part] - parts_[part].first_cell);
}

// Writes the faces of a run's polyhedra as grid::CellList has them. Other cells have none.
void PackedCells::takeFaces(std::uint32_t number) const
{
	const Run& run = runs()[number];
	const FirstFace& first = first_faces_[number];
	std::vector<std::int32_t> ids(contents_.run_face_ids[number]), ends(contents_.run_faces[number] + 1),
	    cell_ends(run.cells + std::size_t(1));
	readRows(contents_.face_ids, first.id, ids.size(), ids.data());
	readRows(contents_.face_ends, firstFaceEndOf(number), ends.size(), ends.data());
	readRows(contents_.polyhedron_ends, firstEndOf(number), cell_ends.size(), cell_ends.data());
	const auto doNotMatch = [this] { return damaged("the faces of a part do not match it"); };
	const auto refuseWrongEnds = [&](std::span<const std::int32_t> list, std::size_t size)
	{
		if (!std::ranges::is_sorted(list) ||
		    std::int64_t(list.back()) - list.front() != static_cast<std::int64_t>(size))
			throw doNotMatch();
	};
	refuseWrongEnds(ends, ids.size());
	refuseWrongEnds(cell_ends, ends.size() - 1);
	takeIds(number, ids);
	const auto* types = types_->as<std::uint8_t>() + run.first_cell;
	auto* firsts = first_of_faces_->as<std::int64_t>() + run.first_cell;
	auto* const stream = face_stream_->as<std::int64_t>();
	std::uint64_t at = first.in_memory;
	for (std::size_t c = 0, face = 0, id = 0; c < run.cells; ++c)
	{
		const auto faces = static_cast<std::size_t>(std::int64_t(cell_ends[c + 1]) - cell_ends[c]);
		const std::uint64_t begin = at;
		std::atomic_ref(firsts[c]).store(static_cast<std::int64_t>(begin), std::memory_order_relaxed);
		stream[at++] = static_cast<std::int64_t>(faces);
		for (const std::size_t end = face + faces; face < end; ++face)
		{
			const auto size = static_cast<std::size_t>(std::int64_t(ends[face + 1]) - ends[face]);
			stream[at++] = static_cast<std::int64_t>(size);
			std::copy_n(ids.begin() + static_cast<std::ptrdiff_t>(id), size, stream + at);
			at += size;
			id += size;
		}
		if (types[c] == kPolyhedron ? !isPolyhedron({stream + begin, at - begin}, contents_.all_points) : faces > 0)
			throw doNotMatch();
	}
	// The run behind it may write the same.
	std::atomic_ref(firsts[run.cells]).store(static_cast<std::int64_t>(at), std::memory_order_relaxed);
}

} // namespace vp::read
