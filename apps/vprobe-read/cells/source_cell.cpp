#include "source_cell.h"

#include "grid/curved/pyramid_weights.h"
#include "refine/cell_kind.h"
#include "vprobe-read/base/refusal.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::cells
{

namespace
{

// refine::CellKind has room for a hexahedron of this degree. VTK supports no higher degree either.
constexpr int kMaxDegree = 10;

bool hasDegrees(std::uint8_t type)
{
	return (type >= VTK_LAGRANGE_TETRAHEDRON && type <= VTK_LAGRANGE_WEDGE) ||
	       (type >= VTK_BEZIER_TETRAHEDRON && type <= VTK_BEZIER_WEDGE);
}

bool isTetrahedron(std::uint8_t type)
{
	return type == VTK_LAGRANGE_TETRAHEDRON || type == VTK_BEZIER_TETRAHEDRON;
}

bool isHexahedron(std::uint8_t type)
{
	return type == VTK_LAGRANGE_HEXAHEDRON || type == VTK_BEZIER_HEXAHEDRON;
}

vtkIdType pointsOfDegrees(std::uint8_t type, const std::array<int, 3>& degrees)
{
	const vtkIdType a = degrees[0] + 1;
	const vtkIdType b = degrees[1] + 1;
	const vtkIdType c = degrees[2] + 1;
	if (isTetrahedron(type))
		return a * (a + 1) * (a + 2) / 6;
	return isHexahedron(type) ? a * b * c : a * (a + 1) / 2 * c;
}

// Returns the number of points of a quadratic type, which is fixed, or 0 for other types.
vtkIdType fixedPoints(std::uint8_t type)
{
	switch (type)
	{
	case VTK_QUADRATIC_TETRA:
		return 10;
	case VTK_QUADRATIC_HEXAHEDRON:
		return 20;
	case VTK_QUADRATIC_WEDGE:
		return 15;
	case VTK_QUADRATIC_PYRAMID:
		return 13;
	case VTK_TRIQUADRATIC_HEXAHEDRON:
		return 27;
	case VTK_QUADRATIC_LINEAR_WEDGE:
		return 12;
	case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
		return 18;
	case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
		return 24;
	case VTK_TRIQUADRATIC_PYRAMID:
		return 19;
	default:
		return 0;
	}
}

CellSplit splitOf(std::uint8_t type, const std::array<int, 3>& degrees, std::span<const Vec3> at)
{
	switch (type)
	{
	case VTK_QUADRATIC_TETRA:
		return splitTetrahedron(2, at);
	case VTK_QUADRATIC_HEXAHEDRON:
	case VTK_TRIQUADRATIC_HEXAHEDRON:
	case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
		return splitHexahedron({2, 2, 2}, at);
	case VTK_QUADRATIC_WEDGE:
	case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
		return splitWedge(2, 2, at);
	case VTK_QUADRATIC_LINEAR_WEDGE:
		return splitWedge(2, 1, at);
	case VTK_QUADRATIC_PYRAMID:
		return splitPyramid(13);
	case VTK_TRIQUADRATIC_PYRAMID:
		return splitPyramid19();
	default:
		break;
	}
	if (isHexahedron(type))
		return splitHexahedron(degrees, at);
	if (isTetrahedron(type))
		return at.size() == 15 ? splitTetrahedron15() : splitTetrahedron(degrees[0], at);
	CellSplit split = at.size() == 21 ? splitWedge21() : splitWedge(degrees[0], degrees[2], at);
	// The first triangle of these cells faces the second. In VTK's linear wedges it faces outward.
	for (CellSplit::Part& part : split.parts)
		std::rotate(part.nodes.begin(), part.nodes.begin() + 3, part.nodes.begin() + 6);
	return split;
}

} // namespace

bool isCurved(std::uint8_t type)
{
	return fixedPoints(type) > 0 || hasDegrees(type);
}

void findShapeArrays(vtkUnstructuredGrid* grid)
{
	vtkCellData* cells = grid->GetCellData();
	if (vtkDataArray* degrees = cells->GetArray("HigherOrderDegrees");
	    degrees && degrees->GetNumberOfComponents() == 3 && !cells->GetHigherOrderDegrees())
		cells->SetHigherOrderDegrees(degrees);
	vtkPointData* points = grid->GetPointData();
	if (vtkDataArray* weights = points->GetArray("RationalWeights");
	    weights && weights->GetNumberOfComponents() == 1 && !points->GetRationalWeights())
		points->SetRationalWeights(weights);
}

SourceCells::SourceCells(vtkUnstructuredGrid* grid) : grid_(grid) {}

SourceCells::~SourceCells() = default;

std::array<int, 3> SourceCells::degreesOf(vtkIdType cell, std::uint8_t type, vtkIdType points) const
{
	std::array<int, 3> degrees = {0, 0, 0};
	vtkDataArray* given = grid_->GetCellData()->GetHigherOrderDegrees();
	// Some Lagrange cells have points in the middle of faces. They do not belong to any degree.
	const bool with_middles =
	    type == VTK_LAGRANGE_TETRAHEDRON ? points == 15 : type == VTK_LAGRANGE_WEDGE && points == 21;
	if (with_middles)
		return {2, 2, 2};
	if (given && !isTetrahedron(type))
	{
		if (given->GetNumberOfComponents() != 3 || given->GetNumberOfTuples() != grid_->GetNumberOfCells())
			throw damaged("the degrees of the cells do not match them");
		for (int axis = 0; axis < 3; ++axis)
		{
			const double degree = given->GetComponent(cell, axis);
			if (!(degree >= 1.0 && degree <= 1000.0))
				throw damaged(fmt::format("cell {} is of degree {}", cell, degree));
			degrees[static_cast<std::size_t>(axis)] = static_cast<int>(degree);
		}
	}
	else
		do
			++degrees[0], ++degrees[1], ++degrees[2];
		while (pointsOfDegrees(type, degrees) < points);

	const bool skewed = !isHexahedron(type) && degrees[0] != degrees[1];
	if (pointsOfDegrees(type, degrees) != points || skewed)
		throw damaged(fmt::format("cell {} of type {} and degrees {} {} {} lists {} points", cell, type, degrees[0],
		                          degrees[1], degrees[2], points));
	if (*std::max_element(degrees.begin(), degrees.end()) > kMaxDegree)
		throw Refusal(fmt::format("cell {} is of degree {}; degrees up to {} can be read", cell,
		                          *std::max_element(degrees.begin(), degrees.end()), kMaxDegree));
	return degrees;
}

vtkCell* SourceCells::prototype(std::uint8_t type)
{
	auto& made = prototypes_[type];
	if (!made)
		made = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
	return made;
}

CellKind& SourceCells::enter(vtkIdType cell, std::uint8_t type, vtkIdList* points)
{
	type_ = type;
	points_ = points;
	const vtkIdType fixed = fixedPoints(type);
	if (fixed > 0 && points->GetNumberOfIds() < fixed)
		throw damaged(fmt::format("cell {} of type {} lists {} points", cell, type, points->GetNumberOfIds()));
	if (fixed > 0)
		points->SetNumberOfIds(fixed);
	KindKey key{type, {0, 0, 0}, points->GetNumberOfIds()};
	if (fixed == 0)
		key.degrees = degreesOf(cell, type, key.points);
	weights_.resize(static_cast<std::size_t>(key.points));

	const auto [known, is_new] = kinds_.try_emplace(key);
	CellKind& kind = known->second;
	kind_ = &kind;
	if (!is_new)
		return kind;
	vtkCell* shape = fixed > 0 ? prototype(type) : grid_->GetCell(cell);
	const double* coordinates = shape->GetParametricCoords();
	for (vtkIdType p = 0; p < key.points; ++p, coordinates += 3)
	{
		const double up = coordinates[2];
		if (type == VTK_QUADRATIC_PYRAMID)
			kind.at.emplace_back(coordinates[0] * (1 - up) + 0.5 * up, coordinates[1] * (1 - up) + 0.5 * up, up);
		else
			kind.at.emplace_back(coordinates[0], coordinates[1], up);
	}
	kind.degrees = key.degrees;
	kind.split = splitOf(type, key.degrees, kind.at);
	kind.handles = type >= VTK_BEZIER_TETRAHEDRON && type <= VTK_BEZIER_WEDGE;
	kind.order = NodeOrder(type, key.degrees, kind.at);
	return kind;
}

std::span<const double> SourceCells::ownWeights(const Vec3& at)
{
	auto& functions = functions_[kind_];
	if (!functions)
		functions = std::make_unique<refine::CellKind>(type_, weights_.size(), kind_->degrees);
	rational_.clear();
	if (vtkDataArray* rational = kind_->handles ? grid_->GetPointData()->GetRationalWeights() : nullptr)
		for (vtkIdType node = 0; node < points_->GetNumberOfIds(); ++node)
			rational_.push_back(rational->GetComponent(points_->GetId(node), 0));
	functions->weighNodes(at, rational_, weights_.data());
	return weights_;
}

std::span<const double> SourceCells::weights(const Vec3& at)
{
	if (hasDegrees(type_))
		return ownWeights(at);
	if (type_ == VTK_QUADRATIC_PYRAMID)
	{
		grid::weighPyramid(at, weights_);
		return weights_;
	}
	Vec3 place = at;
	prototype(type_)->InterpolateFunctions(&place.x, weights_.data());
	return weights_;
}

} // namespace vp::reader::cells
