#include "grid/demo.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <new>
#include <numbers>
#include <utility>

namespace vp::grid
{

namespace
{

constexpr int kDefaultCells = 64;

// Half the edge of the boxes of blob, graded and mixed.
constexpr double kHalf = 3.0;

// Memory that is first touched by the threads that fill it.
template <class T>
struct Filled
{
	std::shared_ptr<T[]> data;
	std::size_t size;

	explicit Filled(std::size_t count) : data(new T[count]), size(count) {}
	T& operator[](std::size_t i) const { return data[i]; }
	Array<T> array() const { return Array<T>(data, data.get(), size); }
	Array<std::byte> bytes() const
	{
		return Array<std::byte>(data, reinterpret_cast<const std::byte*>(data.get()), size * sizeof(T));
	}
};

// The points of a lattice of n cells each way.
struct LatticePoints
{
	std::size_t side;

	explicit LatticePoints(int n) : side(n + 1) {}
	std::size_t count() const { return side * side * side; }
	std::size_t operator()(std::size_t i, std::size_t j, std::size_t k) const { return (k * side + j) * side + i; }
};

// Calls body(j, k) for the rows of `side` x `side`.
template <class Body>
void forRows(std::size_t side, Body&& body)
{
	tbb::parallel_for(tbb::blocked_range<std::size_t>(0, side * side, 16),
					  [&](const tbb::blocked_range<std::size_t>& rows)
					  {
						  for (std::size_t row = rows.begin(); row < rows.end(); ++row)
							  body(row % side, row / side);
					  });
}

struct FieldsOfPoints
{
	Filled<float> s;
	Filled<float> v;

	explicit FieldsOfPoints(std::size_t points) : s(points), v(3 * points) {}
	void set(std::size_t p, double sin_3x, double cos_2y, const Vec3& at) const
	{
		s[p] = static_cast<float>(sin_3x * cos_2y + 0.5 * at.z);
		v[3 * p] = static_cast<float>(-at.y);
		v[3 * p + 1] = static_cast<float>(at.x);
		v[3 * p + 2] = 0.3f;
	}
	std::vector<Field> fields() const
	{
		return {{"s", Association::point, 1, NumberType::float32, s.bytes()},
				{"v", Association::point, 3, NumberType::float32, v.bytes()}};
	}
};

// At the coordinates as they are stored.
std::vector<Field> fieldsAt(const Filled<float>& xyz)
{
	const std::size_t count = xyz.size / 3;
	const FieldsOfPoints fields(count);
	tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096),
					  [&](const tbb::blocked_range<std::size_t>& range)
					  {
						  for (std::size_t p = range.begin(); p < range.end(); ++p)
						  {
							  const Vec3 at(xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2]);
							  fields.set(p, std::sin(3.0 * at.x), std::cos(2.0 * at.y), at);
						  }
					  });
	return fields.fields();
}

// For grids whose coordinates are those of three axes: sines by table.
template <class G>
std::vector<Field> fieldsOfAxes(const G& grid, int n)
{
	const LatticePoints points(n);
	std::vector<double> sin_3x(points.side);
	std::vector<double> cos_2y(points.side);
	for (std::size_t i = 0; i < points.side; ++i)
	{
		sin_3x[i] = std::sin(3.0 * grid.coordinate(0, i));
		cos_2y[i] = std::cos(2.0 * grid.coordinate(1, i));
	}
	const FieldsOfPoints fields(points.count());
	forRows(points.side,
			[&](std::size_t j, std::size_t k)
			{
				for (std::size_t i = 0; i < points.side; ++i)
					fields.set(points(i, j, k), sin_3x[i], cos_2y[j],
							   {grid.coordinate(0, i), grid.coordinate(1, j), grid.coordinate(2, k)});
			});
	return fields.fields();
}

Filled<float> shellPoints(int n)
{
	const LatticePoints points(n);
	std::vector<double> cos_lon(points.side);
	std::vector<double> sin_lon(points.side);
	std::vector<double> cos_lat(points.side);
	std::vector<double> sin_lat(points.side);
	for (std::size_t i = 0; i < points.side; ++i)
	{
		const double t = static_cast<double>(i) / n;
		cos_lon[i] = std::cos(std::numbers::pi * t);
		sin_lon[i] = std::sin(std::numbers::pi * t);
		cos_lat[i] = std::cos(std::numbers::pi * (-0.45 + 0.9 * t));
		sin_lat[i] = std::sin(std::numbers::pi * (-0.45 + 0.9 * t));
	}
	Filled<float> xyz(3 * points.count());
	forRows(points.side,
			[&](std::size_t j, std::size_t k)
			{
				float* row = &xyz[3 * points(0, j, k)];
				for (std::size_t i = 0; i < points.side; ++i, row += 3)
				{
					const double r = 1.0 + 2.0 * static_cast<double>(i) / n;
					row[0] = static_cast<float>(r * cos_lat[k] * cos_lon[j]);
					row[1] = static_cast<float>(r * cos_lat[k] * sin_lon[j]);
					row[2] = static_cast<float>(r * sin_lat[k]);
				}
			});
	return xyz;
}

Block makeShell(int n)
{
	const Filled<float> xyz = shellPoints(n);
	const auto side = static_cast<std::uint32_t>(n + 1);
	Block block;
	block.grid = CurvilinearGrid({side, side, side}, Points(xyz.array()));
	block.fields = fieldsAt(xyz);
	return block;
}

Block makeBlob(int n)
{
	const auto side = static_cast<std::uint32_t>(n + 1);
	const UniformGrid grid({side, side, side}, Vec3(-kHalf), Vec3(2.0 * kHalf / n));
	Block block;
	block.grid = grid;
	block.fields = fieldsOfAxes(grid, n);
	return block;
}

Block makeGraded(int n)
{
	std::vector<double> axis(n + 1);
	for (int i = 0; i <= n; ++i)
	{
		const double t = static_cast<double>(i) / n;
		axis[i] = -kHalf + 2.0 * kHalf * (0.7 * t + 0.3 * t * t);
	}
	const RectilinearGrid grid(axis, axis, axis);
	Block block;
	block.grid = grid;
	block.fields = fieldsOfAxes(grid, n);
	return block;
}

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
		tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count + 1, 65536),
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
	block.grid = UnstructuredGrid::build(Points(xyz.array()), cells);
	block.fields = fieldsAt(xyz);
	return block;
}

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
	// Of the vertices of a hexahedron; the first lattice cell is even.
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

// The cells of `mixed`, written one after the other.
class MixedCells
{
public:
	explicit MixedCells(int n) : side_(n), points_(n), centre_(static_cast<std::int64_t>(points_.count())) {}

	CellList list()
	{
		offsets_.push_back(0);
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
		CellList cells;
		cells.types = std::move(types_);
		cells.offsets = std::move(offsets_);
		cells.connectivity = std::move(ids_);
		return cells;
	}

	std::size_t splitCells() const { return (side_ - 2 * side_ / 3) * side_ * side_; }

private:
	void add(std::uint8_t vtk_type, std::span<const std::int64_t> ids)
	{
		types_.push_back(vtk_type);
		ids_.insert(ids_.end(), ids.begin(), ids.end());
		offsets_.push_back(static_cast<std::int64_t>(ids_.size()));
	}

	void addWedges(const HexahedronIds& c)
	{
		add(13, std::array{c[0], c[2], c[1], c[4], c[6], c[5]});
		add(13, std::array{c[0], c[3], c[2], c[4], c[7], c[6]});
	}

	// A pyramid on the -i face where the wedges are across it, two tetrahedra on every other face, their apex in the
	// centre. Both cells at a face halve it from its lowest corner, so that the halves meet.
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
			std::ranges::rotate(face, std::ranges::min_element(face));
			if (f == 0 && wedges_behind)
				add(14, std::array{face[0], face[1], face[2], face[3], centre_});
			else
			{
				add(10, std::array{face[0], face[1], face[2], centre_});
				add(10, std::array{face[0], face[2], face[3], centre_});
			}
		}
		++centre_;
	}

	std::size_t side_;
	LatticePoints points_;
	std::int64_t centre_; // the next centre point, in the order of the cells
	std::vector<std::uint8_t> types_;
	std::vector<std::int64_t> offsets_;
	std::vector<std::int64_t> ids_;
};

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
	std::size_t centre = points.count();
	for (std::size_t k = 0; k < side; ++k)
		for (std::size_t j = 0; j < side; ++j)
			for (std::size_t i = 2 * side / 3; i < side; ++i)
				place(centre++, i + 0.5, j + 0.5, k + 0.5);
	return makeUnstructured(xyz, cells.list());
}

struct Maker
{
	Demo demo;
	Block (*make)(int n);
	// Face slots of n^3 lattice cells at most, each: UnstructuredGrid numbers them in 32 bits.
	double slots;
};

const Maker kMakers[] = {
	{{"shell", "curvilinear: half a spherical shell, radius 1 to 3"}, makeShell, 0.0},
	{{"hexes", "the shell as explicit hexahedra"}, makeHexes, 6.0},
	{{"tets", "the shell in five tetrahedra a cell"}, makeTets, 20.0},
	{{"blob", "image over -3..3"}, makeBlob, 0.0},
	{{"graded", "rectilinear over -3..3, cells growing along each axis"}, makeGraded, 0.0},
	{{"mixed", "hexahedra, wedges, pyramids and tetrahedra in a box"}, makeMixed, 32.0}};

std::string namesOfDemos()
{
	std::string names;
	for (const Demo& demo : demos())
		names += fmt::format("{}{}", names.empty() ? "" : ", ", demo.name);
	return names;
}

} // namespace

const std::vector<Demo>& demos()
{
	static const std::vector<Demo> all = []
	{
		std::vector<Demo> made;
		for (const Maker& maker : kMakers)
			made.push_back(maker.demo);
		return made;
	}();
	return all;
}

Result<BlockSet> makeDemo(std::string_view name, int n)
{
	const auto maker = std::ranges::find_if(kMakers, [&](const Maker& m) { return m.demo.name == name; });
	if (maker == std::end(kMakers))
		return Error{ExitCode::input, fmt::format("demo:{}: no such data set; there are {}", name, namesOfDemos())};
	int most = kMaxDemoCells;
	while (maker->slots * most * most * most > static_cast<double>(UnstructuredGrid::kMaxFaceSlots))
		--most;
	if (n < 1 || n > most)
		return Error{ExitCode::input, fmt::format("demo:{}:{}: N must be 1 to {} for {}; the data sets are {}", name, n, most,
												  name, namesOfDemos())};
	try
	{
		BlockSet set;
		set.blocks.push_back(maker->make(n));
		set.blocks[0].name = name;
		finishBlock(set.blocks[0]);
		return set;
	}
	catch (const std::bad_alloc&)
	{
		return Error{ExitCode::input, fmt::format("demo:{}:{}: not enough memory; choose a smaller N", name, n)};
	}
}

Result<BlockSet> parseDemo(std::string_view text)
{
	const std::size_t colon = text.find(':');
	const std::string_view name = text.substr(0, colon);
	if (colon == std::string_view::npos)
		return makeDemo(name, kDefaultCells);
	const std::string_view number = text.substr(colon + 1);
	int n = 0;
	const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), n);
	if (error != std::errc() || end != number.data() + number.size())
		return Error{ExitCode::input, fmt::format("demo:{}: expected NAME or NAME:N with N 1 to {}; the data sets are {}", text,
												  kMaxDemoCells, namesOfDemos())};
	return makeDemo(name, n);
}

} // namespace vp::grid
