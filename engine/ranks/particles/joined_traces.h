#pragma once

#include "base/result.h"
#include "ranks/ranks.h"
#include "vectors/lattice.h"
#include "vectors/tracer.h"

#include <span>
#include <vector>

namespace vp::ranks
{

/// Returns the lattice on a sheet whose parts the ranks have. All get all launches, in the order of one process.
std::vector<vectors::Launch> launchLattice(const Ranks& ranks, const mesh::SheetMesh& mesh, const probe::Sheet& content,
                                           const vectors::LatticeChoice& choice);

/// As vectors::trace(). A particle is followed by the rank that holds the block which it is in. All ranks get all
/// traces; points in a block of another rank have the numbers of cells that they have there.
Result<vectors::Traces> trace(const Ranks& ranks, const grid::BlockSet& blocks, const grid::FieldChoice& array,
                              std::span<const vectors::Launch> launches, const vectors::TraceOptions& options);

/// Leaves at all ranks, of values at the points of traces, those that the rank with the point's block has. values: of
/// `bytes` bytes a point.
void takeFromOwners(const Ranks& ranks, const grid::BlockSet& blocks, const vectors::Traces& traces,
                    std::span<std::byte> values, std::size_t bytes);
template <class T>
void takeFromOwners(const Ranks& ranks, const grid::BlockSet& blocks, const vectors::Traces& traces,
                    std::vector<T>& values)
{
	takeFromOwners(ranks, blocks, traces, std::as_writable_bytes(std::span(values)), sizeof(T));
}

} // namespace vp::ranks
