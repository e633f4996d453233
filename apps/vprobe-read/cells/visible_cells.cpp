#include "visible_cells.h"

#include "read/cell_types.h"
#include "vprobe-read/base/refusal.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace vp::reader::cells
{

using grid::NumberType;
using nlohmann::json;

const unsigned char kHiddenCellBits =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;

namespace
{

vtkUnsignedCharArray* marksOf(vtkDataSetAttributes* attributes, vtkIdType wanted)
{
	auto* marks = vtkUnsignedCharArray::SafeDownCast(attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
	if (marks && marks->GetNumberOfValues() != wanted)
		throw damaged("the ghost marks do not match the cells or points");
	return marks;
}

class PointLattice
{
public:
	explicit PointLattice(const std::array<int, 3>& points)
	    : nx_(points[0]), ny_(points[1]), nz_(points[2]), layer_(nx_ * ny_)
	{
	}

	std::size_t cells() const { return (nx_ - 1) * (ny_ - 1) * (nz_ - 1); }

	// Calls visit(cell, its eight points in the order of a hexahedron).
	template <class Visit>
	void forEachCell(Visit&& visit) const
	{
		std::size_t cell = 0;
		for (std::int64_t k = 0; k + 1 < nz_; ++k)
			for (std::int64_t j = 0; j + 1 < ny_; ++j)
				for (std::int64_t i = 0; i + 1 < nx_; ++i, ++cell)
				{
					const std::int64_t low = i + nx_ * j + layer_ * k;
					const std::int64_t high = low + layer_;
					visit(cell, std::array<std::int64_t, 8>{low, low + 1, low + 1 + nx_, low + nx_, high, high + 1,
					                                        high + 1 + nx_, high + nx_});
				}
	}

private:
	std::int64_t nx_, ny_, nz_, layer_;
};

json writePoints(arrays::Writer& writer, vtkDataSet* data)
{
	constexpr vtkIdType chunk_points = 1 << 14;
	std::vector<double> chunk;
	writer.begin();
	for (vtkIdType first = 0; first < data->GetNumberOfPoints(); first += chunk_points)
	{
		chunk.clear();
		for (vtkIdType p = first; p < std::min(first + chunk_points, data->GetNumberOfPoints()); ++p)
		{
			std::array<double, 3> at;
			data->GetPoint(p, at.data());
			chunk.insert(chunk.end(), at.begin(), at.end());
		}
		writer.append(chunk.data(), chunk.size() * sizeof(double));
	}
	return writer.end(NumberType::float64);
}

} // namespace

std::vector<unsigned char> hiddenCellsOf(vtkDataSet* data, const std::array<int, 3>& points)
{
	const PointLattice lattice(points);
	vtkUnsignedCharArray* cell_marks = marksOf(data->GetCellData(), static_cast<vtkIdType>(lattice.cells()));
	vtkUnsignedCharArray* point_marks = marksOf(data->GetPointData(), data->GetNumberOfPoints());
	if (!cell_marks && !point_marks)
		return {};

	std::vector<unsigned char> hidden(lattice.cells(), 0);
	if (cell_marks)
		for (std::size_t c = 0; c < hidden.size(); ++c)
			hidden[c] = cell_marks->GetValue(static_cast<vtkIdType>(c)) & kHiddenCellBits;
	if (point_marks)
		lattice.forEachCell(
		    [&](std::size_t cell, const std::array<std::int64_t, 8>& ids)
		    {
			    for (const std::int64_t id : ids)
				    hidden[cell] |= point_marks->GetValue(id) & vtkDataSetAttributes::HIDDENPOINT;
		    });
	if (std::all_of(hidden.begin(), hidden.end(), [](unsigned char mark) { return mark == 0; }))
		hidden.clear();
	return hidden;
}

json describeVisible(arrays::Writer& writer, vtkDataSet* data, const std::array<int, 3>& points,
                     const std::vector<unsigned char>& hidden)
{
	const auto visible = static_cast<std::size_t>(std::count(hidden.begin(), hidden.end(), 0));
	std::vector<std::uint8_t> types(hidden.size(), read::kEmptyCell);
	std::vector<std::int64_t> offsets = {0};
	std::vector<std::int64_t> connectivity;
	offsets.reserve(hidden.size() + 1);
	connectivity.reserve(8 * visible);
	PointLattice(points).forEachCell(
	    [&](std::size_t cell, const std::array<std::int64_t, 8>& ids)
	    {
		    if (!hidden[cell])
		    {
			    types[cell] = read::kHexahedron;
			    connectivity.insert(connectivity.end(), ids.begin(), ids.end());
		    }
		    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
	    });
	json cells = {{"types", writer.write(NumberType::uint8, types.data(), types.size())},
	              {"offsets", arrays::writeInt64(writer, std::span<const std::int64_t>(offsets))},
	              {"connectivity", arrays::writeIds(writer, std::span<const std::int64_t>(connectivity))}};
	return {{"kind", "unstructured"},
	        {"points", points},
	        {"coordinates", writePoints(writer, data)},
	        {"cells", std::move(cells)}};
}

} // namespace vp::reader::cells
