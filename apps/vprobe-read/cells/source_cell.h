#pragma once

#include "cell_split.h"
#include "node_order.h"

#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <memory>
#include <span>
#include <vector>

class vtkCell;
class vtkDataArray;
class vtkIdList;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace vp::refine
{
class CellKind;
}

namespace vp::reader::cells
{

// Returns true for cells whose shape functions are not linear: quadratic, Lagrange and Bézier.
bool isCurved(std::uint8_t type);

// Finds the arrays of degrees and of rational weights by their names. Some writers do not say what they are for.
void findShapeArrays(vtkUnstructuredGrid* grid);

// Describes one kind of curved cell: how it is split, and where its points lie in the cell's own coordinates. The
// coordinates of a pyramid run from its base square to (1/2, 1/2, 1), so that the middle of two places is the middle of
// the edge between them.
struct CellKind
{
	CellSplit split;
	std::array<int, 3> degrees;
	std::vector<Vec3> at;
	bool handles = false; // its points are not places (Bézier)
	NodeOrder order;      // that of the file, while the cells are looked at
};

// Takes the curved cells of a grid one after the other.
class SourceCells
{
public:
	explicit SourceCells(vtkUnstructuredGrid* grid);
	~SourceCells();

	// Takes the next cell. `points` must live as long as the cell is in use. Throws a Refusal if the points or the
	// degrees do not fit its type.
	CellKind& enter(vtkIdType cell, std::uint8_t type, vtkIdList* points);

	// Returns the degrees of a Lagrange or Bezier cell, and checks them as enter() does.
	std::array<int, 3> degreesOf(vtkIdType cell, std::uint8_t type, vtkIdType points) const;

	// Returns the shape functions of the cell that was entered last.
	std::span<const double> weights(const Vec3& at);

private:
	struct KindKey
	{
		std::uint8_t type;
		std::array<int, 3> degrees;
		vtkIdType points;
		auto operator<=>(const KindKey&) const = default;
	};

	vtkCell* prototype(std::uint8_t type);
	std::span<const double> ownWeights(const Vec3& at);

	vtkUnstructuredGrid* grid_;
	std::map<KindKey, CellKind> kinds_;
	std::map<std::uint8_t, vtkSmartPointer<vtkCell>> prototypes_;
	// Shape functions of Lagrange and Bezier cells. VTK's own take seconds for cells of degree 8.
	std::map<const CellKind*, std::unique_ptr<refine::CellKind>> functions_;
	std::uint8_t type_ = 0;
	const CellKind* kind_ = nullptr;
	vtkIdList* points_ = nullptr;
	std::vector<double> weights_;
	std::vector<double> rational_;
};

} // namespace vp::reader::cells
