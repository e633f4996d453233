#pragma once

#include "base/vec.h"
#include "cell_split.h"

#include <vtkType.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::reader::cells
{

class NewNodes;
class SourceCells;

// A point of a linear cell that is being made.
struct Corner
{
	vtkIdType point;
	Vec3 at; // in the source cell's own coordinates
};

struct LinearCell
{
	std::uint8_t type;
	std::array<Corner, 8> corners;
};

// Returns the number of linear cells that a cell's parts become after so many halvings.
double countParts(const CellSplit& split, int level);

// Cuts the cell that `source` and `nodes` have entered into linear ones; new points go to `nodes`.
class PartCutter
{
public:
	PartCutter(NewNodes& nodes, SourceCells& source) : nodes_(nodes), source_(source) {}

	// Returns the parts, halved so many times. They are valid until the next call.
	const std::vector<LinearCell>& parts(const CellSplit& split, std::span<const Corner> points, int level);

private:
	void cut(const CellSplit& split, std::span<const Corner> points, std::vector<LinearCell>& parts);
	Corner middleOf(const CellSplit::Node& node, std::span<const Corner> points);
	void cutOctahedron(const LinearCell& octahedron, std::vector<LinearCell>& parts);

	NewNodes& nodes_;
	SourceCells& source_;
	std::vector<Corner> cut_nodes_;
	std::vector<LinearCell> parts_;
	std::vector<LinearCell> finer_;
};

} // namespace vp::reader::cells
