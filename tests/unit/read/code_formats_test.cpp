#include "read/read.h"
#include "sample_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

using namespace vp;

namespace
{

// Returns the bytes of a sample's file.
std::string bytesOfSample(const std::string& name)
{
	const auto& samples = sampleFiles();
	const auto sample = std::ranges::find(samples, name, &SampleFile::name);
	const TemporaryFolder folder;
	sample->write(folder / name);
	return contentsOf(folder / name);
}

grid::BlockSet readWhole(const std::string& path)
{
	auto set = read::readInputs({path}, {}, nullptr);
	EXPECT_TRUE(set) << (set ? "" : set.error().message);
	return set ? std::move(*set) : grid::BlockSet{};
}

const grid::Field& namedField(const grid::BlockSet& set, const std::string& name)
{
	const auto& fields = set.blocks.at(0).fields;
	const auto found = std::ranges::find(fields, name, &grid::Field::name);
	EXPECT_NE(found, fields.end()) << name;
	return *found;
}

constexpr std::size_t kMeshBytes = 8 * (64 + 3 * kSamplePointCount + 9 * kSampleCellCount);
constexpr std::size_t kStateBytes = 8 * (1 + 6 + 7 * kSamplePointCount + 7 * kSampleCellCount);

std::string repeatedWords(std::size_t count, double value)
{
	std::string bytes;
	for (std::size_t i = 0; i < count; ++i)
		addBytes(bytes, value);
	return bytes;
}

} // namespace

// A mark behind the mesh, and each state in a file of its own.
TEST(CodeFormats, StatesOfLsdynaInFilesBesideTheMesh)
{
	const std::string bytes = bytesOfSample("d3plot");
	ASSERT_GE(bytes.size(), kMeshBytes + 2 * kStateBytes);
	const TemporaryFolder folder;
	const std::string mark = repeatedWords(1, -999999.0);
	writeContents(folder / "d3plot", bytes.substr(0, kMeshBytes) + mark);
	writeContents(folder / "d3plot01", bytes.substr(kMeshBytes, kStateBytes) + mark + std::string(512, '\0'));
	writeContents(folder / "d3plot02", bytes.substr(kMeshBytes + kStateBytes, kStateBytes) + mark);
	const grid::BlockSet set = readWhole(folder / "d3plot");
	EXPECT_EQ(set.times, (std::vector<double>{0.5, 1.5}));
	EXPECT_EQ(namedField(set, "temperature").value(119, 0), sampleValue(Vec3(4, 3, 5)));
	EXPECT_EQ(namedField(set, "displacement").value(119, 0), 0.0);
}

// Places are the first values at nodes, the temperature follows; what follows mass scaling or heat flux is not known.
TEST(CodeFormats, NodesOfLsdynaWithMassScalingOrHeatFlux)
{
	const std::string bytes = bytesOfSample("d3plot");
	for (const auto& [kind, more_words, has_temperature] :
	     {std::tuple{std::int64_t(11), 1, true}, {std::int64_t(2), 3, false}})
	{
		std::string mesh = bytes.substr(0, kMeshBytes), word;
		addBytes(word, kind);
		mesh.replace(8 * 19, 8, word);
		constexpr std::size_t before = 8 * (1 + 6 + 3 * kSamplePointCount + kSamplePointCount);
		const std::string state = bytes.substr(kMeshBytes + kStateBytes, kStateBytes);
		const TemporaryFolder folder;
		writeContents(folder / "d3plot",
		              mesh + state.substr(0, before) +
		                  repeatedWords(static_cast<std::size_t>(more_words) * kSamplePointCount, 0.125) +
		                  state.substr(before) + repeatedWords(1, -999999.0));
		const grid::BlockSet set = readWhole(folder / "d3plot");
		EXPECT_EQ(namedField(set, "displacement").value(119, 0), 0.0);
		const auto isThere = [&](const std::string& name)
		{ return std::ranges::find(set.blocks.at(0).fields, name, &grid::Field::name) != set.blocks[0].fields.end(); };
		EXPECT_EQ(isThere("temperature"), has_temperature);
		if (has_temperature)
		{
			EXPECT_EQ(namedField(set, "temperature").value(119, 0), sampleValue(Vec3(4, 3, 5)));
		}
		EXPECT_FALSE(isThere("velocity"));
		EXPECT_EQ(namedField(set, "stress").value(0, 1), 1.0);
	}
}

TEST(CodeFormats, DeletedElementsOfLsdynaAreHidden)
{
	const std::string bytes = bytesOfSample("d3plot");
	std::string mesh = bytes.substr(0, kMeshBytes), all_there;
	addBytes(all_there, std::int64_t(-10001));
	mesh.replace(8 * 36, 8, all_there);
	const TemporaryFolder folder;
	writeContents(folder / "d3plot", mesh + bytes.substr(kMeshBytes, kStateBytes) +
	                                     repeatedWords(kSampleCellCount, 1.0) +
	                                     bytes.substr(kMeshBytes + kStateBytes, kStateBytes) + repeatedWords(2, 0.0) +
	                                     repeatedWords(kSampleCellCount - 2, 1.0));
	EXPECT_EQ(readWhole(folder / "d3plot").cellCount(), kSampleCellCount - 2);
}

// The trace at a corner: the five cells below each other there are gone.
TEST(CodeFormats, CellsAboutMissingTracesOfSegyAreHidden)
{
	const std::string bytes = bytesOfSample("survey.sgy");
	constexpr std::size_t trace = 240 + 4 * 6;
	const TemporaryFolder folder;
	writeContents(folder / "a.sgy", bytes.substr(0, 3600) + bytes.substr(3600 + trace)); // the first has i = j = 0
	const grid::BlockSet set = readWhole(folder / "a.sgy");
	EXPECT_EQ(set.cellCount(), kSampleCellCount - 5);
	EXPECT_EQ(set.blocks.at(0).bounds.lo.x, 0.0);
	writeContents(folder / "b.sgy", bytes + bytes.substr(3600, trace));
	const auto twice = read::readInputs({folder / "b.sgy"}, {}, nullptr);
	ASSERT_FALSE(twice);
	EXPECT_NE(twice.error().message.find("several traces"), std::string::npos);
}

// A cube whose upper face is cut into two triangles, and a pyramid on one of its sides.
TEST(CodeFormats, CellsOfFluentByTheirFaces)
{
	const TemporaryFolder folder;
	writeContents(folder / "a.cas", "(2 3)\n(10 (0 1 9 0 3))\n(10 (1 1 9 1 3)(\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n"
	                                "1 0 1\n1 1 1\n0 1 1\n2 0.5 0.5\n))\n(12 (0 1 2 0))\n(12 (2 1 2 1 0)(4 5))\n"
	                                "(13 (0 1 b 0))\n(13 (3 1 1 2 4)(\n2 6 7 3 2 1\n))\n"
	                                "(13 (4 2 b 3 0)(\n4 1 2 3 4 1 0\n3 5 7 6 1 0\n3 5 8 7 1 0\n4 1 5 6 2 1 0\n"
	                                "4 4 3 7 8 1 0\n4 1 4 8 5 1 0\n3 2 3 9 2 0\n3 3 7 9 2 0\n3 7 6 9 2 0\n"
	                                "3 6 2 9 2 0\n))\n");
	const grid::BlockSet set = readWhole(folder / "a.cas");
	ASSERT_EQ(set.blocks.size(), 1u);
	EXPECT_EQ(set.blocks[0].name, "a: zone 2");
	const auto& grid = std::get<grid::UnstructuredGrid>(set.blocks[0].grid);
	ASSERT_EQ(grid.cellCount(), 2u);
	EXPECT_EQ(grid.shape(CellId(0)), grid::CellShape::polyhedron);
	EXPECT_EQ(grid.shape(CellId(1)), grid::CellShape::pyramid);
}

TEST(CodeFormats, ValuesOfAnotherMeshOfFluentAreRefused)
{
	const TemporaryFolder folder;
	writeContents(folder / "a.cas", bytesOfSample("ascii_fluent.cas"));
	writeContents(folder / "a.dat", "(33 (61 1 1))\n");
	const auto set = read::readInputs({folder / "a.cas"}, {}, nullptr);
	ASSERT_FALSE(set);
	EXPECT_NE(set.error().message.find("values of 61 cells where the case has 60"), std::string::npos);
}
