#include "ranks/data/join_pieces.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace vp::ranks
{

namespace
{

using Pieces = std::span<const grid::Block>;

const grid::UnstructuredGrid& gridOf(const grid::Block& block)
{
	return std::get<grid::UnstructuredGrid>(block.grid);
}

const grid::CellList& listOf(const grid::Block& block)
{
	return *gridOf(block).list();
}

bool isListed(const grid::Block& block)
{
	const auto* cells = std::get_if<grid::UnstructuredGrid>(&block.grid);
	return cells && cells->list() && !block.curved && !block.hidden_lattice;
}

bool haveSameArrays(const grid::Block& a, const grid::Block& b)
{
	return std::ranges::equal(a.fields, b.fields,
	                          [](const grid::Field& x, const grid::Field& y) {
		                          return x.name == y.name && x.association == y.association &&
		                                 x.components == y.components && x.type == y.type;
	                          });
}

template <class Number>
grid::Points pointsOf(Pieces pieces)
{
	std::vector<Number> all;
	for (const grid::Block& piece : pieces)
	{
		const grid::Points& points = gridOf(piece).coordinates();
		for (std::size_t p = 0; p < points.size(); ++p)
			for (int axis = 0; axis < 3; ++axis)
				all.push_back(static_cast<Number>(points[p][axis]));
	}
	return grid::Points(Array<Number>(std::move(all)));
}

template <class Id>
std::vector<Id> connectivityOf(Pieces pieces)
{
	std::vector<Id> all;
	Id points = 0;
	for (const grid::Block& piece : pieces)
	{
		listOf(piece).connectivity.as(
		    [&](auto ids)
		    {
			    for (const auto id : ids)
				    all.push_back(static_cast<Id>(id) + points);
		    });
		points += static_cast<Id>(gridOf(piece).pointCount());
	}
	return all;
}

// Offsets of all cells; also of lists that need none alone, since their cells are alike.
std::vector<std::int64_t> offsetsOf(Pieces pieces)
{
	std::vector<std::int64_t> all{0};
	std::int64_t before = 0;
	for (const grid::Block& piece : pieces)
	{
		const grid::CellList& list = listOf(piece);
		const auto length = static_cast<std::int64_t>(list.connectivity.size());
		for (std::size_t cell = 1; cell <= list.size(); ++cell)
		{
			const bool is_last = cell == list.size();
			const std::int64_t end = !list.offsets.empty() ? list.offsets[cell]
			                         : is_last             ? length
			                                               : static_cast<std::int64_t>(list.start(cell));
			all.push_back(before + end);
		}
		before += length;
	}
	return all;
}

// Faces of polyhedra, where there are any.
void joinFaces(Pieces pieces, grid::CellList& joined)
{
	if (std::ranges::all_of(pieces, [](const grid::Block& piece) { return listOf(piece).face_offsets.empty(); }))
		return;
	std::vector<std::int64_t> offsets;
	std::vector<std::int64_t> stream;
	std::int64_t points = 0;
	for (const grid::Block& piece : pieces)
	{
		const grid::CellList& list = listOf(piece);
		for (std::size_t cell = 0; cell < list.size(); ++cell)
		{
			offsets.push_back(static_cast<std::int64_t>(stream.size()));
			if (list.face_offsets.empty() || !list.isPolyhedron(cell))
				continue;
			stream.push_back(static_cast<std::int64_t>(list.faceCount(cell)));
			list.forEachFace(cell,
			                 [&](std::span<const std::int64_t> face)
			                 {
				                 stream.push_back(static_cast<std::int64_t>(face.size()));
				                 for (const std::int64_t p : face)
					                 stream.push_back(p + points);
			                 });
		}
		points += static_cast<std::int64_t>(gridOf(piece).pointCount());
	}
	offsets.push_back(static_cast<std::int64_t>(stream.size()));
	joined.face_offsets = std::move(offsets);
	joined.face_stream = std::move(stream);
}

// Which cells of the file the cells are part of, where curved ones were cut into linear ones.
void joinSources(Pieces pieces, grid::CellList& joined)
{
	if (std::ranges::all_of(pieces, [](const grid::Block& piece) { return listOf(piece).source_cells.empty(); }))
		return;
	std::vector<std::int64_t> sources;
	std::int64_t before = 0;
	for (const grid::Block& piece : pieces)
	{
		const grid::CellList& list = listOf(piece);
		for (std::size_t cell = 0; cell < list.size(); ++cell)
			sources.push_back(before +
			                  (list.source_cells.empty() ? static_cast<std::int64_t>(cell) : list.source_cells[cell]));
		before += static_cast<std::int64_t>(list.source_cells.empty() ? list.size() : gridOf(piece).sourceCellCount());
		joined.source_points += gridOf(piece).sourcePointCount();
	}
	joined.source_cells = std::move(sources);
}

grid::CellList cellsOf(Pieces pieces)
{
	grid::CellList joined;
	std::vector<std::uint8_t> types;
	std::size_t points = 0;
	for (const grid::Block& piece : pieces)
	{
		const grid::CellList& list = listOf(piece);
		if (!list.has_checked_ids) // a wrong one would name a point of the next piece
			grid::checkIds(list.connectivity, gridOf(piece).pointCount());
		types.insert(types.end(), list.types.data(), list.types.data() + list.types.size());
		points += gridOf(piece).pointCount();
	}
	const bool has_offsets =
	    std::ranges::any_of(pieces, [](const grid::Block& piece) { return !listOf(piece).offsets.empty(); }) ||
	    std::ranges::any_of(types, [&](std::uint8_t type) { return type != types[0]; });
	if (has_offsets)
		joined.offsets = offsetsOf(pieces);
	if (points <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
		joined.connectivity = connectivityOf<std::int32_t>(pieces);
	else
		joined.connectivity = connectivityOf<std::int64_t>(pieces);
	joined.types = std::move(types);
	joinFaces(pieces, joined);
	joinSources(pieces, joined);
	return joined;
}

grid::Field fieldOf(Pieces pieces, std::size_t number)
{
	grid::Field joined = pieces[0].fields[number];
	joined.stored.reset();
	std::vector<std::byte> bytes;
	for (const grid::Block& piece : pieces)
	{
		const Array<std::byte> some = grid::inMemory(piece.fields[number]).bytes;
		bytes.insert(bytes.end(), some.data(), some.data() + some.size());
	}
	joined.bytes = std::move(bytes);
	return joined;
}

grid::Block joinedBlock(Pieces pieces)
{
	const bool is_double =
	    std::ranges::any_of(pieces, [](const grid::Block& piece) { return gridOf(piece).coordinates().isDouble(); });
	grid::Block joined;
	joined.name = pieces[0].name;
	joined.length_units = pieces[0].length_units;
	joined.imaging = pieces[0].imaging;
	joined.arrays_left_out = pieces[0].arrays_left_out;
	joined.grid =
	    grid::UnstructuredGrid::listed(is_double ? pointsOf<double>(pieces) : pointsOf<float>(pieces), cellsOf(pieces));
	for (std::size_t f = 0; f < pieces[0].fields.size(); ++f)
		joined.fields.push_back(fieldOf(pieces, f));
	for (const grid::Block& piece : pieces)
		joined.bounds.include(piece.bounds);
	return joined;
}

} // namespace

void joinPieces(read::PartBlocks& read, const read::PartList& list)
{
	std::vector<grid::Block> blocks = std::exchange(read.set.blocks, {});
	const std::vector<read::Part> of_block = std::exchange(read.of_block, {});
	for (std::size_t begin = 0; begin < blocks.size();)
	{
		const auto goesOn = [&](std::size_t b)
		{
			return !list.blocks[of_block[b].block].kind.empty() && of_block[b].block == of_block[begin].block &&
			       isListed(blocks[b]) && haveSameArrays(blocks[b], blocks[begin]);
		};
		std::size_t end = begin + 1;
		while (isListed(blocks[begin]) && end < blocks.size() && goesOn(end))
			++end;
		read.set.blocks.push_back(end == begin + 1 ? std::move(blocks[begin])
		                                           : joinedBlock(Pieces(blocks).subspan(begin, end - begin)));
		read.of_block.push_back(of_block[begin]);
		begin = end;
	}
}

} // namespace vp::ranks
