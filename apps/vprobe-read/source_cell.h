#pragma once

#include "cell_split.h"

#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <span>
#include <vector>

class vtkCell;
class vtkIdList;
class vtkUnstructuredGrid;

// Cells whose shape functions are not linear: quadratic, Lagrange and Bézier.
bool isCurved(std::uint8_t type);

// One kind of curved cell: how it is cut, and where its points lie in the cell's own coordinates. Those of a pyramid
// run from its base square to (1/2, 1/2, 1), so that the middle of two places is the middle of the edge between them.
struct CellKind
{
	CellSplit split;
	std::vector<vp::Vec3> at;
	bool handles = false; // its points are not places (Bézier)
};

// Takes the curved cells of a grid one after the other.
class SourceCells
{
public:
	explicit SourceCells(vtkUnstructuredGrid* grid);
	~SourceCells();

	// Throws a Refusal where a cell's points or degrees do not fit its type.
	const CellKind& enter(vtkIdType cell, std::uint8_t type, vtkIdList* points);

	// The shape functions of the cell entered last.
	std::span<const double> weights(const vp::Vec3& at);

private:
	struct KindKey
	{
		std::uint8_t type;
		std::array<int, 3> degrees;
		vtkIdType points;
		auto operator<=>(const KindKey&) const = default;
	};

	std::array<int, 3> degreesOf(vtkIdType cell, std::uint8_t type, vtkIdType points) const;
	vtkCell* prototype(std::uint8_t type);

	vtkUnstructuredGrid* grid_;
	std::map<KindKey, CellKind> kinds_;
	std::map<std::uint8_t, vtkSmartPointer<vtkCell>> prototypes_;
	vtkIdType entered_ = -1;
	std::uint8_t type_ = 0;
	vtkCell* shape_ = nullptr; // of the cell entered; null until it is needed
	std::vector<double> weights_;
};
