#pragma once

#include "base/result.h"
#include "contour/clip_box.h"
#include "contour/contour_parts.h"
#include "cut/cutter.h"

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

namespace vp
{
class Timeline;
}

namespace vp::contour
{

// The iso surface of one value within the box of a sheet: the pieces that touch the sheet. It is linear along the
// grid's edges, like every iso surface here.
struct Contour
{
	double value = 0.0;
	mesh::SheetMesh mesh;        // polygons face the side where the values rise
	std::size_t components = 0;  // number of pieces, see measure/components.h
	std::size_t cells = 0;       // number of cells that have polygons in the mesh
	std::size_t seeds = 0;       // number of cells of generation 0
	std::size_t generations = 0; // number of generations of the growth
	std::size_t cells_touched = 0;
};

// The bounds of the sheet's window in its frame, without a window those of its cut, which are empty if it shows
// nothing.
Box rectOf(const cut::SheetCut& sheet, const mesh::SheetMesh& mesh);
// depth: see BoxContourer.
ClipBox boxOf(const cut::SheetCut& sheet, const Box& rect, std::optional<double> depth);

// Number of cells that a contour's mesh has polygons of: those of a cell follow each other.
std::size_t cellsOf(const mesh::SheetMesh& mesh);

// Grows contours of one sheet (Speray and Kennon 1990 planned them, "Contours"): the sheet's own cut cells in which the
// value is crossed are generation 0, and the traversal goes on across faces that the iso surface cuts within the box.
// So the work follows the box; of the grid nothing is kept but the slicer's visited marks.
class BoxContourer
{
public:
	// sheet: a plane whose array is of points; mesh: its cut within its window. Both, and the slicer, outlive this.
	// depth: of the box along the normal, half to each side, in the grid's units; none: the smaller side of the window.
	BoxContourer(const cut::Cutter& slicer, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
	             std::optional<double> depth);
	// The same with a box that is known.
	BoxContourer(const cut::Cutter& slicer, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
	             const ClipBox& box);

	// The window times the depth; without a window the bounds of the mesh take its place.
	const ClipBox& box() const { return box_; }

	// Returns the range of the sheet's values at its vertices, or nothing if no value is finite. No contour that grows
	// from the sheet has a value outside the range.
	const std::optional<std::pair<double, double>>& range() const { return range_; }
	// If other processes have parts of the sheet, sets the range of all parts.
	void setRange(const std::optional<std::pair<double, double>>& range) { range_ = range; }
	bool mayHave(double value) const;

	// Per vertex of the mesh; NaN where there is none.
	const std::vector<double>& values() const { return values_; }

	// Section "contour". A stop request ends it between generations with what was found.
	Result<Contour> grow(double value, Timeline* timeline = nullptr, std::stop_token stop = {}) const;

	// The same in steps, where other processes have a part of the blocks. growParts() finds the cells: those that the
	// traversal reaches from the sheet, and from each face on the way to `others`, the boxes of other processes'
	// blocks.
	Result<ContourParts> growParts(double value, std::span<const Box> others) const;
	// The mesh of some cells within the box.
	mesh::SheetMesh clippedMesh(const std::vector<surface::BlockSurface>& surfaces,
	                            const std::vector<find::CellCut>& cuts) const;

private:
	std::vector<std::vector<CellId>> seedsOf(double value) const; // per block
	void findValues();

	const cut::Cutter& slicer_;
	const cut::SheetCut& sheet_;
	const mesh::SheetMesh& mesh_;
	ClipBox box_;
	std::vector<double> values_; // per vertex of the mesh, linear along the edges
	std::optional<std::pair<double, double>> range_;
};

} // namespace vp::contour
