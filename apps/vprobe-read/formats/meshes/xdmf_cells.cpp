#include "xdmf_cells.h"

#include "vprobe-read/base/refusal.h"
#include "xdmf_document.h"

#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>

namespace vp::reader::meshes
{

namespace
{

struct XdmfCell
{
	std::string_view name; // in small letters
	int number;            // in a mixed topology
	int type;
	vtkIdType corners; // 0 where the file says it
};

constexpr XdmfCell kXdmfCells[] = {
    {"polyvertex", 1, VTK_POLY_VERTEX, 0},
    {"polyline", 2, VTK_POLY_LINE, 0},
    {"polygon", 3, VTK_POLYGON, 0},
    {"triangle", 4, VTK_TRIANGLE, 3},
    {"quadrilateral", 5, VTK_QUAD, 4},
    {"tetrahedron", 6, VTK_TETRA, 4},
    {"pyramid", 7, VTK_PYRAMID, 5},
    {"wedge", 8, VTK_WEDGE, 6},
    {"hexahedron", 9, VTK_HEXAHEDRON, 8},
    {"edge_3", 34, VTK_QUADRATIC_EDGE, 3},
    {"quadrilateral_9", 35, VTK_BIQUADRATIC_QUAD, 9},
    {"triangle_6", 36, VTK_QUADRATIC_TRIANGLE, 6},
    {"quadrilateral_8", 37, VTK_QUADRATIC_QUAD, 8},
    {"tetrahedron_10", 38, VTK_QUADRATIC_TETRA, 10},
    {"pyramid_13", 39, VTK_QUADRATIC_PYRAMID, 13},
    {"wedge_15", 40, VTK_QUADRATIC_WEDGE, 15},
    {"wedge_18", 41, VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18},
    {"hexahedron_20", 48, VTK_QUADRATIC_HEXAHEDRON, 20},
    {"hexahedron_24", 49, VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24},
    {"hexahedron_27", 50, VTK_TRIQUADRATIC_HEXAHEDRON, 27},
};
constexpr std::int64_t kXdmfPolyhedron = 16;

void insertXdmfCell(vtkUnstructuredGrid* grid, int type, const vtkIdType* ids, vtkIdType count, vtkIdType first)
{
	std::vector<vtkIdType> corners(ids, ids + count);
	for (vtkIdType& corner : corners)
	{
		corner -= first;
		if (corner < 0 || corner >= grid->GetNumberOfPoints())
			throw damaged(fmt::format("a cell lists point {} of {}", corner, grid->GetNumberOfPoints()));
	}
	grid->InsertNextCell(type, count, corners.data());
}

template <class Next, class Run>
void insertXdmfPolyhedron(Next& next, Run& run, vtkIdType first, vtkUnstructuredGrid* grid)
{
	vtkNew<vtkIdList> faces;
	const vtkIdType count = next();
	faces->InsertNextId(count);
	for (vtkIdType f = 0; f < count; ++f)
	{
		const vtkIdType corners = next();
		faces->InsertNextId(corners);
		const vtkIdType* ids = run(corners);
		for (vtkIdType c = 0; c < corners; ++c)
		{
			if (ids[c] - first < 0 || ids[c] - first >= grid->GetNumberOfPoints())
				throw damaged("a face lists a point that is not there");
			faces->InsertNextId(ids[c] - first);
		}
	}
	grid->InsertNextCell(VTK_POLYHEDRON, faces);
}

} // namespace

void insertXdmfCells(const std::vector<vtkIdType>& stream, vtkIdType first, const std::string& type,
                     const text::XmlElement& topology, vtkUnstructuredGrid* grid)
{
	const auto cell = std::ranges::find(kXdmfCells, type, &XdmfCell::name);
	if (cell == std::end(kXdmfCells))
		throw Refusal(fmt::format("a topology of type {}, which is not read", type.substr(0, 20)));
	const auto given = xdmfNumbers(topology.attribute("NodesPerElement"));
	const vtkIdType corners = cell->corners ? cell->corners : given.empty() ? 1 : static_cast<vtkIdType>(given[0]);
	if (corners < 1 || stream.size() % static_cast<std::size_t>(corners) != 0)
		throw damaged("its cells do not fill their list");
	for (std::size_t at = 0; at < stream.size(); at += static_cast<std::size_t>(corners))
		insertXdmfCell(grid, cell->type, stream.data() + at, corners, first);
}

void insertMixedXdmfCells(const std::vector<vtkIdType>& stream, vtkIdType first, vtkUnstructuredGrid* grid)
{
	std::size_t at = 0;
	const auto next = [&]
	{
		if (at >= stream.size())
			throw damaged("its cells run past the end of their list");
		return stream[at++];
	};
	const auto run = [&](vtkIdType count)
	{
		if (count < 0 || static_cast<std::size_t>(count) > stream.size() - at)
			throw damaged("its cells run past the end of their list");
		at += static_cast<std::size_t>(count);
		return stream.data() + at - count;
	};
	while (at < stream.size())
	{
		const vtkIdType number = next();
		if (number == kXdmfPolyhedron)
		{
			insertXdmfPolyhedron(next, run, first, grid);
			continue;
		}
		const auto cell = std::ranges::find(kXdmfCells, number, &XdmfCell::number);
		if (cell == std::end(kXdmfCells))
			throw damaged(fmt::format("a cell of type {}", number));
		const vtkIdType corners = cell->corners ? cell->corners : next();
		insertXdmfCell(grid, cell->type, run(corners), corners, first);
	}
}

} // namespace vp::reader::meshes
