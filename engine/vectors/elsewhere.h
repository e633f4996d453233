#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "mesh/sheet_mesh.h"
#include "vectors/vector_array.h"

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace vp::vectors
{

// The facts about other blocks that a process with only some blocks of a set knows. With them it follows particles over
// the borders between processes.
struct BlockBorders
{
	std::vector<std::uint32_t> whole; // per block, the one that a process which holds all has in its place
	std::vector<bool> is_here;        // per block
	std::vector<bool> is_lattice;     // per block
	// Per block, by faceKey(): the cells across a face, in blocks of other processes, or of a lattice that this block
	// and the other are pieces of.
	std::vector<std::unordered_map<std::uint64_t, std::vector<mesh::BlockCell>>> across;

	static std::uint64_t faceKey(CellId cell, int face)
	{
		return std::uint64_t(cell) << 32 | static_cast<std::uint32_t>(face);
	}
	std::span<const mesh::BlockCell> acrossFace(const mesh::BlockCell& cell, int face) const;
	// The one in another piece of the same lattice.
	std::optional<mesh::BlockCell> inSameLattice(const mesh::BlockCell& cell, int face) const;
};

// A cell of another piece of a lattice, its axes those of the source (cell_field.h). A plain struct, which may be sent
// as bytes.
struct FarCell
{
	mesh::BlockCell id;
	std::array<Vec3, 8> corners;
	std::array<std::array<Vec3, 8>, 2> vectors; // at one time or two; of an array of cells the first one
	std::array<mesh::BlockCell, 6> across;      // kNoCell where none is
};

// Borders, and the cells beyond them that are known so far. A process which holds a whole lattice goes from cell to
// cell without an end of a step. So who holds a piece of it needs the cells behind its border to come to the same bits.
class Elsewhere
{
public:
	explicit Elsewhere(const BlockBorders& borders) : borders_(borders) {}

	const BlockBorders& borders() const { return borders_; }
	bool isHere(std::uint32_t block) const { return borders_.is_here[block]; }
	std::optional<std::uint32_t> numberOf(const mesh::BlockCell& cell) const; // among those known
	const FarCell& cell(std::uint32_t number) const { return cells_[number]; }
	void add(const FarCell& cell);

private:
	const BlockBorders& borders_;
	std::deque<FarCell> cells_;
	std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

// A cell that a particle needs, and that is not known here. Thrown in the midst of a step, which is then begun anew.
struct MissingCell
{
	mesh::BlockCell cell;
};

// The cell of a lattice, and those that lie around it in its block, for another process. vectors: of its block.
std::vector<FarCell> cellsAround(const grid::BlockSet& blocks, std::span<const BlockVectors> vectors,
                                 const BlockBorders& borders, const mesh::BlockCell& cell);

} // namespace vp::vectors
