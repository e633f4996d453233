#include "grid/demo/demo.h"

#include "grid/demo/demo_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <new>
#include <utility>

namespace vp::grid
{

namespace
{

using namespace demo;

constexpr int kDefaultCells = 64;

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
    {{"mixed", "hexahedra, wedges, pyramids and tetrahedra in a box"}, makeMixed, 32.0},
    {{"layer", "the boundary layer of a wing: hexahedra and prisms, up to 10 000 times as long as thick"},
     makeLayer,
     10.0}};

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

Result<BlockSet> makeDemo(std::string_view name, int n, bool builds_neighbors)
{
	const auto maker = std::ranges::find_if(kMakers, [&](const Maker& m) { return m.demo.name == name; });
	if (maker == std::end(kMakers))
		return Error{ErrorKind::input, fmt::format("demo:{}: no such data set; there are {}", name, namesOfDemos())};
	int most = kMaxDemoCells;
	while (maker->slots * most * most * most > static_cast<double>(UnstructuredGrid::kMaxFaceSlots))
		--most;
	if (n < 1 || n > most)
		return Error{ErrorKind::input, fmt::format("demo:{}:{}: N must be 1 to {} for {}; the data sets are {}", name,
		                                           n, most, name, namesOfDemos())};
	try
	{
		BlockSet set;
		set.blocks.push_back(maker->make(n));
		set.blocks[0].name = name;
		if (builds_neighbors && !hasNeighbors(set))
			buildNeighbors(set);
		else
			finishBlock(set.blocks[0]);
		return set;
	}
	catch (const std::bad_alloc&)
	{
		return Error{ErrorKind::out_of_memory,
		             fmt::format("demo:{}:{}: not enough memory; choose a smaller N", name, n)};
	}
}

Result<BlockSet> parseDemo(std::string_view text, bool builds_neighbors)
{
	const std::size_t colon = text.find(':');
	const std::string_view name = text.substr(0, colon);
	if (colon == std::string_view::npos)
		return makeDemo(name, kDefaultCells, builds_neighbors);
	const std::string_view number = text.substr(colon + 1);
	int n = 0;
	const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), n);
	if (error != std::errc() || end != number.data() + number.size())
		return Error{ErrorKind::input,
		             fmt::format("demo:{}: expected NAME or NAME:N with N 1 to {}; the data sets are {}", text,
		                         kMaxDemoCells, namesOfDemos())};
	return makeDemo(name, n, builds_neighbors);
}

} // namespace vp::grid
