#include "base/parallel_for.h"
#include "grid/demo/demo_points.h"

#include <algorithm>
#include <array>
#include <span>

namespace vp::grid::demo
{

namespace
{

using HexahedronIds = std::array<std::int64_t, 8>;

HexahedronIds hexahedronAt(const LatticePoints& points, std::size_t i, std::size_t j, std::size_t k)
{
	const auto p = static_cast<std::int64_t>(points(i, j, k));
	const auto row = static_cast<std::int64_t>(points.side);
	const std::int64_t layer = row * row;
	return {p, p + 1, p + 1 + row, p + row, p + layer, p + 1 + layer, p + 1 + row + layer, p + row + layer};
}

// `count` cells of one shape, their ids yet to be filled.
struct CellsOfOneShape
{
	Filled<std::int64_t> ids;
	CellList list;

	CellsOfOneShape(std::size_t count, std::uint8_t vtk_type, int points) : ids(count * points)
	{
		const Filled<std::int64_t> offsets(count + 1);
		const Filled<std::uint8_t> types(count);
		parallelFor(tbb::blocked_range<std::size_t>(0, count + 1, 65536),
		            [&](const tbb::blocked_range<std::size_t>& range)
		            {
			            for (std::size_t c = range.begin(); c < range.end(); ++c)
			            {
				            offsets[c] = static_cast<std::int64_t>(c * points);
				            if (c < count)
					            types[c] = vtk_type;
			            }
		            });
		list.types = types.array();
		list.offsets = offsets.array();
		list.connectivity = ids.array();
	}
};

Block makeUnstructured(const Filled<float>& xyz, const CellList& cells)
{
	Block block;
	block.grid = UnstructuredGrid::listed(Points(xyz.array()), cells);
	block.fields = fieldsAt(xyz);
	return block;
}

// A list of cells of several shapes, made one after the other.
class CellListMaker
{
public:
	void add(std::uint8_t vtk_type, std::span<const std::int64_t> ids)
	{
		types_.push_back(vtk_type);
		ids_.insert(ids_.end(), ids.begin(), ids.end());
		offsets_.push_back(static_cast<std::int64_t>(ids_.size()));
	}

	CellList take()
	{
		CellList cells;
		cells.types = std::move(types_);
		cells.offsets = std::move(offsets_);
		cells.connectivity = std::move(ids_);
		return cells;
	}

private:
	std::vector<std::uint8_t> types_;
	std::vector<std::int64_t> offsets_{0};
	std::vector<std::int64_t> ids_;
};

// The cells of `mixed`, written one after the other.
class MixedCells
{
public:
	explicit MixedCells(int n) : side_(n), points_(n), center_(static_cast<std::int64_t>(points_.count())) {}

	CellList list()
	{
		const std::size_t first_wedge = side_ / 3;
		const std::size_t first_split = 2 * side_ / 3;
		for (std::size_t k = 0; k < side_; ++k)
			for (std::size_t j = 0; j < side_; ++j)
				for (std::size_t i = 0; i < side_; ++i)
				{
					const HexahedronIds corners = hexahedronAt(points_, i, j, k);
					if (i < first_wedge)
						add(12, corners);
					else if (i < first_split)
						addWedges(corners);
					else
						addSplit(corners, i == first_split && first_split > first_wedge);
				}
		return cells_.take();
	}

	std::size_t splitCells() const { return (side_ - 2 * side_ / 3) * side_ * side_; }

private:
	void add(std::uint8_t vtk_type, std::span<const std::int64_t> ids) { cells_.add(vtk_type, ids); }

	void addWedges(const HexahedronIds& c)
	{
		add(13, std::array{c[0], c[2], c[1], c[4], c[6], c[5]});
		add(13, std::array{c[0], c[3], c[2], c[4], c[7], c[6]});
	}

	// A pyramid on the -i face where the wedges are across it, two tetrahedra on every other face, their apex in the
	// center. Both cells at a face halve it from its lowest corner, so that the halves meet.
	void addSplit(const HexahedronIds& c, bool wedges_behind)
	{
		const ShapeTopology& hexahedron = topology(CellShape::hexahedron);
		for (int f = 0; f < hexahedron.faces; ++f)
		{
			std::array<std::int64_t, 4> face;
			for (int corner = 0; corner < 4; ++corner)
				face[corner] = c[hexahedron.face[f][corner]];
			// Towards the apex the base runs counter-clockwise: from outside, clockwise.
			std::ranges::reverse(face);
			std::rotate(face.begin(), std::ranges::min_element(face), face.end());
			if (f == 0 && wedges_behind)
				add(14, std::array{face[0], face[1], face[2], face[3], center_});
			else
			{
				add(10, std::array{face[0], face[1], face[2], center_});
				add(10, std::array{face[0], face[2], face[3], center_});
			}
		}
		++center_;
	}

	std::size_t side_;
	LatticePoints points_;
	std::int64_t center_; // the next center point, in the order of the cells
	CellListMaker cells_;
};

} // namespace

Block makeHexes(int n)
{
	const std::size_t side = n;
	const LatticePoints points(n);
	const CellsOfOneShape cells(side * side * side, 12, 8);
	forRows(side,
	        [&](std::size_t j, std::size_t k)
	        {
		        std::int64_t* ids = &cells.ids[(k * side + j) * side * 8];
		        for (std::size_t i = 0; i < side; ++i)
			        for (const std::int64_t p : hexahedronAt(points, i, j, k))
				        *ids++ = p;
	        });
	return makeUnstructured(shellPoints(n), cells.list);
}

Block makeTets(int n)
{
	// Vertices of a hexahedron, for even and odd lattice cells. The first cell is even.
	static constexpr std::uint8_t split[2][5][4] = {
	    {{1, 3, 4, 6}, {0, 1, 3, 4}, {1, 2, 3, 6}, {1, 4, 5, 6}, {3, 4, 6, 7}},
	    {{0, 2, 7, 5}, {0, 1, 2, 5}, {0, 2, 3, 7}, {0, 4, 5, 7}, {2, 5, 6, 7}}};
	const std::size_t side = n;
	const LatticePoints points(n);
	const CellsOfOneShape cells(5 * side * side * side, 10, 4);
	forRows(side,
	        [&](std::size_t j, std::size_t k)
	        {
		        std::int64_t* ids = &cells.ids[(k * side + j) * side * 20];
		        for (std::size_t i = 0; i < side; ++i)
		        {
			        const HexahedronIds corners = hexahedronAt(points, i, j, k);
			        for (const auto& tetrahedron : split[(i + j + k) % 2])
				        for (const std::uint8_t corner : tetrahedron)
					        *ids++ = corners[corner];
		        }
	        });
	return makeUnstructured(shellPoints(n), cells.list);
}

Block makeMixed(int n)
{
	const LatticePoints points(n);
	MixedCells cells(n);
	const Filled<float> xyz(3 * (points.count() + cells.splitCells()));
	const double step = 2.0 * kHalf / n;
	const auto place = [&](std::size_t p, double i, double j, double k)
	{
		xyz[3 * p] = static_cast<float>(-kHalf + i * step);
		xyz[3 * p + 1] = static_cast<float>(-kHalf + j * step);
		xyz[3 * p + 2] = static_cast<float>(-kHalf + k * step);
	};
	forRows(points.side,
	        [&](std::size_t j, std::size_t k)
	        {
		        for (std::size_t i = 0; i < points.side; ++i)
			        place(points(i, j, k), i, j, k);
	        });
	const std::size_t side = n;
	std::size_t center = points.count();
	for (std::size_t k = 0; k < side; ++k)
		for (std::size_t j = 0; j < side; ++j)
			for (std::size_t i = 2 * side / 3; i < side; ++i)
				place(center++, i + 0.5, j + 0.5, k + 0.5);
	return makeUnstructured(xyz, cells.list());
}

// Lattice axes: i runs along the profile from the leading edge's upper side to the trailing edge, j away from the wall,
// k along the span. The front half are hexahedra, the rear half prisms that stand on the wall.
Block makeLayer(int n)
{
	const LatticePoints points(n);
	const std::size_t side = n;
	CellListMaker cells;
	for (std::size_t k = 0; k < side; ++k)
		for (std::size_t j = 0; j < side; ++j)
			for (std::size_t i = 0; i < side; ++i)
			{
				const HexahedronIds c = hexahedronAt(points, i, j, k);
				if (2 * i < side)
					cells.add(12, c);
				else
				{
					cells.add(13, std::array{c[0], c[1], c[5], c[3], c[2], c[6]});
					cells.add(13, std::array{c[0], c[5], c[4], c[3], c[6], c[7]});
				}
			}
	return makeUnstructured(layerPoints(n), cells.take());
}

} // namespace vp::grid::demo
