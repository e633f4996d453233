#pragma once

#include "find/block_cut.h"
#include "grid/block.h"
#include "measure/stats.h"
#include "measure/value_areas.h"
#include "mesh/sheet_mesh.h"
#include "ranks/join/rim_vertices.h"
#include "ranks/ranks.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vp::ranks
{

/// A vertex that several ranks have. If their values differ, each rank counts its own.
struct SharedVertex
{
	std::uint32_t vertex;
	std::uint64_t id;       // the same at all ranks
	std::vector<int> ranks; // the others
};

/// The vertices and faces that a sheet's mesh shares with the meshes of other ranks.
struct Borders
{
	std::size_t vertices_elsewhere = 0;             // vertices of this mesh that count with the mesh of another rank
	std::size_t faces_elsewhere = 0;                // boundary polygons dropped here because another rank shows them
	std::vector<mesh::BlockCell> cells_elsewhere{}; // cells of the dropped polygons
	std::size_t components = 0;                     // pieces in the meshes of all ranks together
	std::vector<SharedVertex> shared{};             // a vertex that rounding has split may have several entries
	std::vector<int> peers{};                       // ranks that may share vertices; ascending
	bool hangs = false; // a cell of one rank meets several smaller ones of another: then nothing here holds
};

/// Joins the meshes of a sheet that the ranks have: a face in the plane that two of them show is dropped at one, and
/// vertices at one place with the same values are counted once. Places that more than rounding has parted are joined
/// for the pieces alone. What lies on the rim of a mesh is sent to the rank that its place belongs to, so traffic
/// follows the rim alone.
///
/// Within a block that one process would have, vertices are joined only where the faces of cells lie on each other, as
/// in one process (mesh/join_vertices.h). One process has no borders, and nothing is changed.
///
/// cuts: what was found in each block.
Borders joinBorders(const Ranks& ranks, const grid::BlockSet& blocks, std::span<const find::BlockCut> cuts,
                    mesh::SheetMesh& mesh);

/// Returns the number of components of a sheet's meshes together. borders: joinBorders() of the mesh.
std::size_t componentsOf(const Ranks& ranks, const Borders& borders, const mesh::SheetMesh& mesh);

/// Returns the sums over the polygons of all ranks. They are exact, so they do not depend on how a sheet is parted.
measure::SheetSums sumUp(const Ranks& ranks, const grid::BlockSet& blocks, const mesh::SheetMesh& mesh,
                         const std::optional<grid::FieldChoice>& field);

/// Returns the areas of all ranks.
measure::ValueAreas sumUp(const Ranks& ranks, measure::ValueAreas own);

/// Counts vertices at one place once: adds to what is shared, and drops from `own` those that another rank counts.
void shareVertices(Team& team, const std::vector<Box>& boxes, std::vector<RimVertex>& own, Borders& borders);

/// The pieces of a mesh.
struct MarkedPieces
{
	std::vector<std::uint32_t> of_vertex; // its piece
	std::vector<std::uint8_t> marks;      // any bits, one byte per piece
};

/// Numbers pieces from 0, without marks. roots: per vertex the one that stands for its piece.
MarkedPieces numbered(std::span<const std::uint32_t> roots);

/// The same where the pieces are known, of a mesh without boundary polygons. Gives each piece the marks of all pieces
/// that it hangs together with, at whatever rank. whole: per block, the block that one process would have in its place.
Borders joinBorders(Team& team, const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                    std::span<const find::BlockCut> cuts, MarkedPieces& pieces, const mesh::SheetMesh& mesh);

} // namespace vp::ranks
