#include "grid/array_facts.h"
#include "grid/block.h"
#include "read/check_mesh.h"
#include "read/packed_cells.h"
#include "read/read.h"
#include "sample_files.h"

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <span>
#include <vector>

using namespace vp;
using namespace vp::read;

namespace
{

// Two tetrahedra of five points with a common face, each a part of its own. The second reaches to x = 3.
struct TwoParts
{
	TemporaryFolder folder;
	std::string path = folder / "two";
	std::string bytes;
	std::vector<float> places{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 3, 1, 1};
	std::vector<std::uint32_t> point_numbers{0, 1, 2, 3, 1, 2, 3, 4};
	std::vector<std::int32_t> ids{0, 1, 2, 3, 0, 2, 1, 3};
	std::vector<double> f{0, 10, 20, 30, 10, 20, 30, 40};
	std::vector<std::int16_t> g{1, 2, 3, 4};
	std::vector<double> later_f{1, 11, 21, 31, 11, 21, 31, 41};
	std::vector<std::int16_t> later_g{-1, -2, -3, -4};
	std::uint8_t type = grid::kTetra;
	std::vector<std::int32_t> ends{0, 4, 0, 4};
	// If the second one is a polyhedron in another partition: the points of its faces, and ends as VTKHDF has them.
	std::vector<std::int32_t> face_ids{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
	std::vector<std::int32_t> face_ends{0, 0, 3, 6, 9, 12};
	std::vector<std::int32_t> polyhedron_ends{0, 0, 0, 4};

	template <class T>
	PackedCells::List list(const std::vector<T>& values, std::size_t in_row)
	{
		const std::uint64_t offset = bytes.size() + 7; // nothing needs to be aligned
		bytes.resize(offset);
		bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
		return {offset, in_row * sizeof(T)};
	}

	PackedCells::Contents contents()
	{
		grid::Field of_points, of_cells;
		of_points.name = "f";
		of_points.type = grid::NumberType::float64;
		of_cells.name = "g";
		of_cells.association = grid::Association::cell;
		of_cells.components = 2;
		of_cells.type = grid::NumberType::int16;
		PackedCells::Contents contents;
		contents.runs = {{{{0, 0, 0}, {1, 1, 1}}, 0, 1, 0}, {{{0, 0, 0}, {3, 1, 1}}, 1, 1, 1}};
		contents.run_ids = {4, 4};
		contents.all_cells = {1, 1};
		contents.points = {4, 4};
		contents.first_ids = {0, 0};
		contents.first_ends = {0, 2};
		contents.all_points = 5;
		contents.type = type;
		contents.places = list(places, 3);
		contents.point_numbers = list(point_numbers, 1);
		contents.ids = list(ids, 1);
		contents.cell_numbers = list(std::vector<std::uint32_t>{7, 9}, 1).offset;
		contents.types = list(std::vector<std::uint8_t>{grid::kTetra, grid::kTetra}, 1);
		contents.ends = list(ends, 1);
		contents.arrays = {
		    {.field = of_points, .row_bytes = 8, .times = {{list(f, 1).offset}, {list(later_f, 1).offset}}},
		    {.field = of_cells, .row_bytes = 4, .times = {{list(g, 2).offset}, {list(later_g, 2).offset}}}};
		const auto facts = std::make_shared<grid::ArrayFacts>();
		facts->tuples = 5;
		contents.arrays[0].times[1].facts = facts;
		writeContents(path, bytes);
		contents.file = std::make_shared<const parts::OpenFile>(path);
		return contents;
	}
};

PackedCells::Contents withPolyhedron(TwoParts& two)
{
	two.type = 0;
	PackedCells::Contents contents = two.contents();
	contents.types = two.list(std::vector<std::uint8_t>{grid::kTetra, grid::kPolyhedron}, 1);
	contents.run_faces = {0, 4};
	contents.run_face_ids = {0, 12};
	contents.face_ids = two.list(two.face_ids, 1);
	contents.face_ends = two.list(two.face_ends, 1);
	contents.polyhedron_ends = two.list(two.polyhedron_ends, 1);
	writeContents(two.path, two.bytes);
	contents.file = std::make_shared<const parts::OpenFile>(two.path);
	return contents;
}

std::vector<std::int64_t> idsOf(const PackedCells& cells)
{
	const grid::CellList list = cells.cells();
	std::vector<std::int64_t> ids;
	for (std::size_t i = 0; i < list.connectivity.size(); ++i)
		ids.push_back(list.connectivity[i]);
	return ids;
}

void fetch(grid::CellRuns& cells, std::initializer_list<std::uint32_t> runs)
{
	cells.fetch(std::vector<std::uint32_t>(runs));
}

grid::Block blockOf(const std::shared_ptr<PackedCells>& cells)
{
	grid::Block block;
	block.grid = grid::UnstructuredGrid::listedInRuns(cells->points(), cells->cells());
	block.fields = cells->fields();
	block.runs = cells;
	return block;
}

// x = `at`
struct AcrossX
{
	double at;
	bool meets(const Box& box) const { return box.lo.x <= at && at <= box.hi.x; }
};

} // namespace

// The first tetrahedron has values from 0 to 30, and the second from 10 to 40; one later they are greater by one.
TEST(PackedCells, KnowWhichRunsHoldAValue)
{
	using Runs = std::vector<std::uint32_t>;
	TwoParts two;
	PackedCells::Contents contents = two.contents();
	PackedCells told(contents);
	EXPECT_EQ(told.holding(told.fields()[0], 0, 99.0), told.all()); // the file does not say

	contents.arrays[0].times[0].ranges = two.list(std::vector<float>{0, 30, 10, 40}, 1).offset;
	contents.arrays[0].times[1].ranges = two.list(std::vector<float>{1, 31, 11, 40}, 1).offset; // 41 in truth
	writeContents(two.path, two.bytes);
	contents.file = std::make_shared<const parts::OpenFile>(two.path);
	const auto cells = std::make_shared<PackedCells>(contents);
	const auto holding = [&](double value) { return cells->holding(cells->fields()[0], 0, value); };
	EXPECT_EQ(holding(-1.0), Runs{});
	EXPECT_EQ(holding(0.0), Runs{0});
	EXPECT_EQ(holding(9.5), Runs{0});
	EXPECT_EQ(holding(10.0), (Runs{0, 1}));
	EXPECT_EQ(holding(30.5), Runs{1});
	EXPECT_EQ(holding(40.5), Runs{});
	EXPECT_EQ(cells->holding(cells->fields()[0], grid::kMagnitude, 99.0), cells->all());
	EXPECT_EQ(cells->holding(cells->fields()[1], 0, 99.0), cells->all()); // values of cells
	fetch(*cells, {0, 1});

	grid::Block block = blockOf(cells);
	const grid::Field before = block.fields[0];
	cells->goTo(1, {}, block);
	EXPECT_EQ(holding(0.5), Runs{});
	EXPECT_EQ(holding(9.5), Runs{0});
	EXPECT_EQ(cells->holding(before, 0, 99.0), cells->all()); // another time has its own
	fetch(*cells, {0});
	EXPECT_THROW(fetch(*cells, {1}), parts::Unreadable); // its 41 lies outside

	contents.arrays[0].times[1].ranges = two.bytes.size() - 8; // room for one run
	EXPECT_THROW(PackedCells cut(contents), Unusable);
}

TEST(PackedCells, AreReadRunByRun)
{
	for (const std::uint8_t type : {grid::kTetra, std::uint8_t(0)}) // told of all, or of each
	{
		TwoParts two;
		two.type = type;
		PackedCells cells(two.contents());
		EXPECT_EQ(cells.meeting(AcrossX{2.0}), std::vector<std::uint32_t>{1});
		EXPECT_EQ(cells.meeting(AcrossX{0.5}), (std::vector<std::uint32_t>{0, 1}));
		EXPECT_TRUE(cells.meeting(AcrossX{5.0}).empty());

		fetch(cells, {1});
		EXPECT_EQ(idsOf(cells), (std::vector<std::int64_t>{0, 0, 0, 0, 1, 3, 2, 4}));
		EXPECT_EQ(cells.points()[4], Vec3(3.0, 1.0, 1.0));
		EXPECT_EQ(cells.fields()[0].value(4, 0), 40.0);
		EXPECT_EQ(cells.fields()[1].value(1, 1), 4.0);
		EXPECT_EQ(cells.cellNumbers().value(1, 0), 9.0);
		EXPECT_EQ(cells.cells().types[1], grid::kTetra);
		EXPECT_EQ(cells.cells().start(1), 4u);
		EXPECT_EQ(cells.pointsOf(1)[3], 4u);
		const std::uint64_t of_part = 4 * (12 + 4 + 8), of_run = 16 + 4 + (type == 0 ? 1 + 4 : 0);
		parts::PartUse use = cells.use();
		EXPECT_EQ(use.all, 2u);
		EXPECT_EQ(use.kept, 1u);
		EXPECT_EQ(use.read, 1u);
		EXPECT_EQ(use.bytes_read, of_part + of_run);

		cells.startCounting();
		fetch(cells, {0, 1});
		EXPECT_EQ(idsOf(cells), (std::vector<std::int64_t>{0, 1, 2, 3, 1, 3, 2, 4}));
		use = cells.use();
		EXPECT_EQ(use.met, 2u);
		EXPECT_EQ(use.read, 1u);
		EXPECT_EQ(use.bytes_met, 2 * (of_part + of_run));
		EXPECT_EQ(use.bytes_read, of_part + of_run);
	}
}

TEST(PackedCells, AreSharedByProcesses)
{
	TwoParts two;
	PackedCells::Contents contents = two.contents();
	contents.own = {1, 2};
	const auto cells = std::make_shared<PackedCells>(contents);
	EXPECT_TRUE(cells->isShare());
	EXPECT_EQ(cells->ownCells(), 1u);
	EXPECT_EQ(cells->all(), std::vector<std::uint32_t>{1});
	EXPECT_EQ(cells->meeting(AcrossX{0.5}), std::vector<std::uint32_t>{1}); // the first meets it, too
	EXPECT_EQ(cells->use().all, 1u);
	fetch(*cells, {1});
	EXPECT_EQ(idsOf(*cells), (std::vector<std::int64_t>{0, 0, 0, 0, 1, 3, 2, 4})); // numbered as in the whole

	grid::BlockSet blocks;
	blocks.blocks.push_back(blockOf(cells));
	blocks.blocks[0].whole = std::make_shared<const grid::WholeGrid>();
	grid::readAllParts(blocks);
	const auto& grid = std::get<grid::UnstructuredGrid>(blocks.blocks[0].grid);
	ASSERT_EQ(grid.cellCount(), 1u);
	EXPECT_TRUE(grid.hasNeighbors());
	EXPECT_EQ(grid.sourceCell(0), 1u);

	for (const grid::CellRuns::Range wrong : {grid::CellRuns::Range{1, 1}, grid::CellRuns::Range{0, 3}})
	{
		contents.own = wrong;
		EXPECT_THROW(PackedCells none(contents), Unusable);
	}
}

TEST(PackedCells, HaveTheFacesOfPolyhedra)
{
	TwoParts two;
	const auto cells = std::make_shared<PackedCells>(withPolyhedron(two));
	fetch(*cells, {1});
	const grid::CellList list = cells->cells();
	EXPECT_EQ(list.types[1], grid::kPolyhedron);
	std::vector<std::vector<std::int64_t>> faces;
	list.forEachFace(1, [&](std::span<const std::int64_t> face) { faces.emplace_back(face.begin(), face.end()); });
	EXPECT_EQ(faces, (std::vector<std::vector<std::int64_t>>{{1, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}}));
	const std::uint64_t of_faces = 12 * 4 + 4 * 4 + 4; // ids, ends, and the end of the cell's
	EXPECT_EQ(cells->use().bytes_read, 4 * (12 + 4 + 8) + 16 + 4 + 1 + 4 + of_faces);
	const auto grid = std::get<grid::UnstructuredGrid>(blockOf(cells).grid);
	EXPECT_EQ(grid.faceCount(1), 4);

	fetch(*cells, {0});
	const std::vector<CellId> both{0, 1};
	const grid::UnstructuredGrid linked = grid::UnstructuredGrid::buildPart(grid, both);
	std::vector<std::size_t> neighbors; // the polyhedron has one: the tetrahedron, across the face that both have
	for (CellId c = 0; c < linked.cellCount(); ++c)
		if (linked.sourceCell(c) == 1)
			for (int f = 0; f < linked.faceCount(c); ++f)
				linked.forEachNeighbor(c, f, [&](CellId n) { neighbors.push_back(linked.sourceCell(n)); });
	EXPECT_EQ(neighbors, std::vector<std::size_t>{0});
}

TEST(PackedCells, WithFacesThatCannotBeAreRefused)
{
	const auto refuses = [](const std::function<void(TwoParts&)>& damage)
	{
		TwoParts two;
		damage(two);
		PackedCells cells(withPolyhedron(two));
		EXPECT_THROW(fetch(cells, {1}), parts::Unreadable);
	};
	refuses([](TwoParts& two) { two.face_ids[3] = 4; });
	refuses([](TwoParts& two) { two.face_ids[3] = -1; });
	refuses([](TwoParts& two) { two.face_ends = {0, 0, 2, 6, 9, 12}; }); // a face of two points
	refuses([](TwoParts& two) { two.face_ends = {0, 0, 3, 9, 6, 12}; });
	refuses([](TwoParts& two) { two.face_ends = {0, 0, 3, 6, 9, 11}; });
	refuses([](TwoParts& two) { two.polyhedron_ends = {0, 0, 0, 3}; });
	refuses([](TwoParts& two) { two.polyhedron_ends = {0, 0, -2000000000, 2000000000}; });
	refuses([](TwoParts& two) { two.places[21] = 3.5f; }); // outside the box

	const auto contradicts = [](const std::function<void(PackedCells::Contents&)>& damage)
	{
		TwoParts two;
		PackedCells::Contents contents = withPolyhedron(two);
		damage(contents);
		EXPECT_THROW(PackedCells cells(contents), Unusable);
	};
	contradicts([](PackedCells::Contents& contents) { contents.run_faces.pop_back(); });
	contradicts([](PackedCells::Contents& contents) { contents.run_face_ids = {0, std::uint64_t(1) << 33}; });
	contradicts([](PackedCells::Contents& contents) { contents.face_ids.offset = contents.file->size() - 40; });
	contradicts([](PackedCells::Contents& contents) { contents.face_ends.offset = contents.file->size() - 8; });
	contradicts([](PackedCells::Contents& contents) { contents.polyhedron_ends.row_bytes = 0; });
	contradicts([](PackedCells::Contents& contents) { contents.type = grid::kTetra; });
}

// The pack is an index: the values of points lie in another file, and those of cells do not.
TEST(PackedCells, ReadTheValuesOfTwoFiles)
{
	TwoParts two, pack;
	PackedCells::Contents contents = two.contents();
	contents.cell_numbers = two.list(std::vector<std::uint32_t>{1, 0}, 1).offset;
	writeContents(two.path, two.bytes);
	contents.file = std::make_shared<const parts::OpenFile>(two.path);
	two.bytes.clear();
	contents.arrays[0].times = {{two.list(std::vector<double>{0, 10, 20, 30, 40}, 1).offset},
	                            {two.list(std::vector<double>{1, 11, 21, 31, 41}, 1).offset}};
	contents.arrays[0].is_in_source = true;
	writeContents(two.folder / "source", two.bytes);
	const auto without = std::make_shared<PackedCells>(pack.contents());
	contents.source = std::make_shared<const parts::OpenFile>(two.folder / "source");
	const auto cells = std::make_shared<PackedCells>(contents);
	fetch(*cells, {1});
	fetch(*without, {1});
	EXPECT_EQ(cells->fields()[0].value(4, 0), 40.0);
	for (int component = 0; component < 2; ++component)
		EXPECT_EQ(cells->fields()[1].value(1, component), without->fields()[1].value(1, component));
	EXPECT_NE(cells->fields()[1].value(1, 0), 0.0);
	grid::Block block = blockOf(cells);
	grid::Block other = blockOf(without);
	cells->goTo(1, 0, block);
	without->goTo(1, 0, other);
	fetch(*cells, {0, 1});
	fetch(*without, {0, 1});
	EXPECT_EQ(block.fields[0].value(4, 0), 41.0);
	EXPECT_EQ(block.fields[1].value(0, 1), other.fields[1].value(0, 1));
	EXPECT_NE(block.fields[1].value(0, 1), 0.0);
}

// The pack is an index: the values of points and cells lie in another file, in its order.
TEST(PackedCells, ReadTheValuesOfTheFileThatAnIndexIsOf)
{
	TwoParts two;
	PackedCells::Contents contents = two.contents();
	contents.cell_numbers = two.list(std::vector<std::uint32_t>{1, 0}, 1).offset;
	writeContents(two.path, two.bytes);
	contents.file = std::make_shared<const parts::OpenFile>(two.path);
	two.bytes.clear();
	const std::string path = two.folder / "source";
	contents.arrays[0].times = {{two.list(std::vector<double>{0, 10, 20, 30, 40}, 1).offset},
	                            {two.list(std::vector<double>{1, 11, 21, 31, 41}, 1).offset}};
	contents.arrays[1].times = {{two.list(std::vector<std::int16_t>{3, 4, 1, 2}, 2).offset},
	                            {two.list(std::vector<std::int16_t>{-3, -4, -1, -2}, 2).offset}};
	writeContents(path, two.bytes);
	for (PackedCells::ArrayLists& array : contents.arrays)
		array.is_in_source = true;
	EXPECT_THROW(PackedCells without(contents), Unusable);
	contents.source = std::make_shared<const parts::OpenFile>(path);

	const auto cells = std::make_shared<PackedCells>(contents);
	fetch(*cells, {1});
	EXPECT_EQ(cells->fields()[0].value(4, 0), 40.0);
	EXPECT_EQ(cells->fields()[1].value(1, 0), 3.0);
	EXPECT_EQ(cells->cellNumbers().value(1, 0), 0.0);
	const std::uint64_t of_part = 4 * (12 + 4), of_run = 16 + 4;          // ids, and the number of the cell
	EXPECT_EQ(cells->use().bytes_read, of_part + of_run + 5 * 8 + 2 * 4); // all values are one page
	EXPECT_EQ(cells->use().bytes_met, of_part + of_run + 4 * 8 + 4);
	cells->startCounting();
	fetch(*cells, {0});
	EXPECT_EQ(cells->fields()[1].value(0, 1), 2.0);
	EXPECT_EQ(cells->use().bytes_read, of_part + of_run);

	grid::Block block = blockOf(cells);
	cells->goTo(1, 0, block);
	fetch(*cells, {0, 1});
	EXPECT_EQ(block.fields[0].value(0, 0), 1.0);
	EXPECT_EQ(block.fields[0].value(4, 0), 41.0);
	EXPECT_EQ(block.fields[1].value(0, 0), -1.0);
	EXPECT_EQ(block.fields[1].value(1, 1), -4.0);

	contents.all_cells = {1, 2}; // one that nobody sees: there are no values for it
	EXPECT_THROW(PackedCells wrong(contents), Unusable);
	contents.all_cells = {1, 1};
	contents.cell_numbers = contents.point_numbers.offset + 8; // leads to 2 and 3, which are no cells
	PackedCells wrong(contents);
	EXPECT_THROW(fetch(wrong, {0}), parts::Unreadable);
}

TEST(PackedCells, ReadTheValuesOfAnotherTimeAndNothingElse)
{
	TwoParts two;
	const auto cells = std::make_shared<PackedCells>(two.contents());
	fetch(*cells, {0, 1});
	grid::Block block = blockOf(cells);
	const grid::Block before = block;
	EXPECT_EQ(cells->times(), 2u);
	EXPECT_FALSE(cells->factsAt(0, block.fields[0]));
	EXPECT_EQ(cells->factsAt(1, block.fields[0])->tuples, 5u);

	cells->startCounting();
	cells->goTo(1, 0, block);
	EXPECT_EQ(block.fields[0].facts->tuples, 5u);
	EXPECT_EQ(cells->bytesAfter({}), 2u * (16 + 4 * (12 + 4)));
	fetch(*cells, {1});
	EXPECT_EQ(cells->use().bytes_read, 4u * 8 + 4);
	EXPECT_EQ(cells->use().kept, 2u);
	EXPECT_EQ(block.fields[0].value(4, 0), 41.0);
	EXPECT_EQ(block.fields[0].value(0, 0), 0.0); // a point of the other part alone
	EXPECT_EQ(block.fields[1].value(1, 1), -4.0);
	EXPECT_EQ(before.fields[0].value(4, 0), 40.0);
	EXPECT_EQ(before.fields[0].value(0, 0), 0.0);
	fetch(*cells, {0, 1});
	EXPECT_EQ(cells->use().bytes_read, 2u * (4 * 8 + 4));
	EXPECT_EQ(block.fields[0].value(0, 0), 1.0);

	cells->goTo(0, std::nullopt, block);
	cells->renew(block);
	fetch(*block.runs, {1});
	EXPECT_EQ(block.fields[0].value(4, 0), 40.0);
}

TEST(PackedCells, AreRenewedForTheirBlockAlone)
{
	TwoParts two;
	const auto cells = std::make_shared<PackedCells>(two.contents());
	fetch(*cells, {0, 1});
	grid::Block block = blockOf(cells);
	const grid::Block copy = block;
	cells->renew(block);
	fetch(*block.runs, {0});
	EXPECT_EQ(block.runs->use().kept, 1u);
	EXPECT_EQ(block.fields[0].value(4, 0), 0.0);
	EXPECT_EQ(block.fields[0].value(3, 0), 30.0);
	EXPECT_EQ(copy.fields[0].value(4, 0), 40.0);
	EXPECT_EQ(std::get<grid::UnstructuredGrid>(copy.grid).point(4), Vec3(3.0, 1.0, 1.0));
}

TEST(PackedCells, ThatContradictThemselvesAreRefused)
{
	using Damage = std::function<void(PackedCells::Contents&)>;
	const std::vector<Damage> damages = {
	    [](auto& c) { c.runs.clear(); },
	    [](auto& c) { c.runs[1].part = 2; },
	    [](auto& c) { c.runs[0].part = 1; },
	    [](auto& c) { c.runs[1].cells = 0; },
	    [](auto& c) { c.runs[1].cells = 2; },
	    [](auto& c) { c.runs[1].first_cell = 2; },
	    [](auto& c) { c.runs[1].box = Box(); },
	    [](auto& c) {
		    c.run_ids = {4, 5};
	    },
	    [](auto& c) { c.run_ids = {4}; },
	    [](auto& c) { c.all_cells = {1}; },
	    [](auto& c) {
		    c.all_cells = {0, 1};
	    },
	    [](auto& c) { c.points[1] = std::uint64_t(1) << 40; },
	    [](auto& c) { c.first_ids[1] = std::uint64_t(1) << 40; },
	    [](auto& c) { c.first_ids.pop_back(); },
	    [](auto& c) { c.first_ends = {0}; },
	    [](auto& c) { c.points[1] = 60; },
	    [](auto& c) { c.all_points = 0; },
	    [](auto& c) { c.all_points = std::uint64_t(1) << 33; },
	    [](auto& c) { c.type = 5; },
	    [](auto& c) { c.ids.offset = ~std::uint64_t(0); },
	    [](auto& c) { c.arrays[1].times[1].offset = c.file->size() - 3; },
	    [](auto& c) { c.arrays[0].row_bytes = 0; },
	    [](auto& c) { c.arrays[0].times.pop_back(); },
	    [](auto& c) { c.time = 2; },
	};
	for (std::size_t d = 0; d < damages.size(); ++d)
	{
		TwoParts two;
		PackedCells::Contents contents = two.contents();
		damages[d](contents);
		EXPECT_THROW(PackedCells(std::move(contents)), Unusable) << d;
	}
}

TEST(PackedCells, ThatAreDamagedInTheFileAreToldWhereTheyAreRead)
{
	using Damage = std::function<void(TwoParts&)>;
	const std::vector<Damage> damages = {
	    [](TwoParts& two) { two.ids[5] = 4; },           [](TwoParts& two) { two.ids[5] = -1; },
	    [](TwoParts& two) { two.point_numbers[5] = 1; }, [](TwoParts& two) { two.point_numbers[7] = 5; },
	    [](TwoParts& two) { two.places[21] = 3.5f; },    [](TwoParts& two) { two.places[22] = NAN; },
	};
	const std::vector<Damage> damages_of_ends = {
	    [](TwoParts& two) { two.ends[3] = 3; },
	    [](TwoParts& two) {
		    two.ends = {0, 4, 4, 0};
	    },
	};
	const auto expectTold = [](const Damage& damage, std::uint8_t type)
	{
		TwoParts two;
		two.type = type;
		damage(two);
		PackedCells cells(two.contents());
		fetch(cells, {0});
		EXPECT_THROW(fetch(cells, {0, 1}), parts::Unreadable);
		EXPECT_EQ(cells.use().kept, 1u);
	};
	for (const Damage& damage : damages)
		expectTold(damage, grid::kTetra);
	for (const Damage& damage : damages_of_ends)
		expectTold(damage, 0);
}

TEST(PackedCells, OfAFileThatWasCutShortAreTold)
{
	TwoParts two;
	PackedCells cells(two.contents());
	std::filesystem::resize_file(two.path, 20);
	EXPECT_THROW(fetch(cells, {0}), parts::Unreadable);
}

// The pack among the samples, with its cells left in the file and then read, and read as a whole.
TEST(PackedCells, AreThoseOfTheWhole)
{
	const auto sample = std::ranges::find(sampleFiles(), "packed.vtkhdf", &SampleFile::name);
	ASSERT_NE(sample, sampleFiles().end());
	const TemporaryFolder folder;
	const std::string path = folder / sample->name;
	sample->write(path);
	ReadOptions in_place;
	in_place.keeps_in_runs = true;
	auto kept = readInputs({path}, in_place, nullptr);
	ASSERT_TRUE(kept) << kept.error().message;
	ASSERT_TRUE(grid::lacksParts(*kept));
	EXPECT_EQ(kept->cellCount(), sample->cells);
	EXPECT_EQ(kept->pointCount(), sample->points);
	EXPECT_EQ(grid::partUse(*kept)->kept, 0u);
	grid::buildNeighbors(*kept);
	EXPECT_FALSE(grid::lacksParts(*kept));
	const auto whole = readInputs({path}, {}, nullptr);
	ASSERT_TRUE(whole) << whole.error().message;
	EXPECT_EQ(kept->bounds().hi, whole->bounds().hi);
	EXPECT_EQ(grid::partUse(*kept)->read, grid::partUse(*whole)->read);
	expectSampleValues(kept->blocks[0], true);
	const auto numberOf = [](const grid::BlockSet& set, CellId cell) { return grid::cellNumber(set.blocks[0], cell); };
	for (CellId cell = 0; cell < sample->cells; ++cell)
		EXPECT_EQ(numberOf(*kept, cell), numberOf(*whole, cell)) << cell;
}
