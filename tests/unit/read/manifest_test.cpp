#include "grid/array_facts.h"
#include "parts/file_extents.h"
#include "read/manifest.h"
#include "read/protocol.h"
#include "read/source_stamp.h"
#include "sample_files.h"
#include "tries.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

using namespace vp;
using namespace vp::read;
using nlohmann::json;

namespace
{

// A manifest and its arrays, as a child hands them over.
class Made
{
public:
	Made()
	    : manifest_({{"version", kProtocolVersion},
	                 {"times", {0.5}},
	                 {"left_out", 0},
	                 {"warnings", {"w"}},
	                 {"blocks", json::array()}})
	{
	}

	template <class T>
	json array(const char* type, const std::vector<T>& values)
	{
		bytes_.resize((bytes_.size() + 63) / 64 * 64);
		const std::size_t offset = bytes_.size();
		bytes_.resize(offset + values.size() * sizeof(T));
		if (!values.empty())
			std::memcpy(bytes_.data() + offset, values.data(), values.size() * sizeof(T));
		return {{"type", type}, {"offset", offset}, {"bytes", values.size() * sizeof(T)}};
	}
	json field(const char* name, const char* association, int components, json array)
	{
		array["name"] = name;
		array["association"] = association;
		array["components"] = components;
		return array;
	}
	json& block(std::size_t b) { return manifest_["blocks"][b]; }
	json& manifest() { return manifest_; }
	std::string text() const { return manifest_.dump(); }
	std::vector<std::byte>& bytes() { return bytes_; }

	// Every value of an array of the manifest.
	template <class T>
	T* at(const json& array)
	{
		return reinterpret_cast<T*>(bytes_.data() + array["offset"].get<std::size_t>());
	}

	Result<CheckedInput> check() const { return check(text()); }
	Result<CheckedInput> check(const std::string& text, const std::string& file = {},
	                           const std::string& indexed = {}) const
	{
		// Copied, so that reading past the end shows under a sanitizer.
		const auto copy = std::make_shared<std::vector<std::byte>>(bytes_);
		const SharedBytes shared = {copy, {copy->data(), copy->size()}};
		return checkManifest(text, shared, shared, file, {}, indexed);
	}

private:
	json manifest_;
	std::vector<std::byte> bytes_;
};

// An image, a rectilinear and a curvilinear block of 3 x 2 x 2 points, and a mesh of a tetrahedron, a pyramid as a
// polyhedron and a triangle.
Made makeManifest()
{
	Made made;
	json& blocks = made.manifest()["blocks"];
	const std::vector<float> f(12, 1.0f);
	const std::vector<std::int16_t> g(2, 7);
	const auto arrays = [&]
	{
		return json::array({made.field("f", "point", 1, made.array("float32", f)),
		                    made.field("g", "cell", 1, made.array("int16", g))});
	};
	blocks.push_back({{"name", "image"},
	                  {"kind", "image"},
	                  {"points", {3, 2, 2}},
	                  {"origin", {0.0, 1.0, 2.0}},
	                  {"spacing", {1.0, 1.0, -1.0}}});
	blocks.push_back({{"name", "rectilinear"}, {"kind", "rectilinear"}});
	blocks.back()["axes"] = {made.array<double>("float64", {0.0, 0.5, 0.75}), made.array<double>("float64", {0.0, 1.0}),
	                         made.array<double>("float64", {3.0, 1.0})};
	blocks.push_back({{"name", "curvilinear"}, {"kind", "curvilinear"}, {"points", {3, 2, 2}}});
	std::vector<double> xyz;
	for (int p = 0; p < 12; ++p)
		xyz.insert(xyz.end(), {double(p % 3), double(p / 3 % 2), double(p / 6)});
	blocks.back()["coordinates"] = made.array("float64", xyz);
	for (json& block : blocks)
		block["arrays"] = arrays();

	json mesh = {{"name", "mesh"}, {"kind", "unstructured"}};
	mesh["coordinates"] =
	    made.array<float>("float32", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5f, 0.5f, 1, 0.5f, 0.5f, -1});
	mesh["cells"] = {{"types", made.array<std::uint8_t>("uint8", {10, 42, 5})},
	                 {"offsets", made.array<std::int64_t>("int64", {0, 4, 9, 12})},
	                 {"connectivity", made.array<std::int64_t>("int64", {0, 1, 2, 5, 0, 1, 2, 3, 4, 0, 1, 2})},
	                 {"face_offsets", made.array<std::int64_t>("int64", {0, 0, 22, 22})},
	                 {"face_stream", made.array<std::int64_t>(
	                                     "int64", {5, 4, 0, 3, 2, 1, 3, 0, 1, 4, 3, 1, 2, 4, 3, 2, 3, 4, 3, 3, 0, 4})}};
	mesh["arrays"] = json::array({made.field("v", "point", 3, made.array("float64", std::vector<double>(18, 2.0))),
	                              made.field("id", "cell", 1, made.array<std::int64_t>("int64", {0, 1, 2}))});
	blocks.push_back(mesh);
	return made;
}

void expectRefused(const Made& made, const char* what)
{
	const auto checked = made.check();
	EXPECT_FALSE(checked) << what;
	if (!checked)
	{
		EXPECT_EQ(checked.error().kind, ErrorKind::input) << what;
		EXPECT_FALSE(checked.error().message.empty()) << what;
	}
}

constexpr std::size_t kMesh = 3;

// A manifest of the mesh alone, as that of a pack of ten cells.
Made makePackManifest()
{
	Made made = makeManifest();
	json& blocks = made.manifest()["blocks"];
	blocks = json::array({blocks.back()});
	made.block(0)["pack"] = {{"points", 20},
	                         {"cells", 10},
	                         {"cells_without_place", 3},
	                         {"bounds", {-1.0, 0.0, -1.0, 4.0, 1.0, 1.0}},
	                         {"parts", 5},
	                         {"parts_read", 2},
	                         {"bytes_read", 1000},
	                         {"numbers", made.array<std::int64_t>("int64", {7, 3, 9})}};
	for (json& array : made.block(0)["arrays"])
	{
		array["facts"] = {{"tuples", 20}, {"values", {3.0, 1.0, 3.0}}, {"changes", {4, 2}}};
		array["facts"]["spans"] = json::array({{-1.0, 5.0, false, true}});
		for (int component = 1; component < array["components"]; ++component)
			array["facts"]["spans"].push_back({2.0, 2.0, false, false});
		array["facts"]["spans"].push_back({nullptr, nullptr, false, false});
	}
	return made;
}

TEST(Manifest, TakesTheWholeOfAPack)
{
	const Result<CheckedInput> input = makePackManifest().check();
	ASSERT_TRUE(input) << input.error().message;
	const grid::WholeGrid& whole = *input->blocks[0].whole;
	EXPECT_EQ(whole.cells, 10u);
	EXPECT_EQ(input->unplaced, 3u);
	EXPECT_EQ(whole.bounds.hi.x, 4.0);
	EXPECT_EQ(whole.parts.read, 2u);
	EXPECT_EQ(whole.cell_numbers.value(2, 0), 9.0);
	const grid::Field& field = input->blocks[0].fields[0];
	EXPECT_EQ(grid::valueSpan(field, 0).hi, 5.0);
	EXPECT_TRUE(grid::valueSpan(field, 0).plus_infinity);
	EXPECT_TRUE(grid::valueSpan(field, grid::kMagnitude).empty());
	EXPECT_EQ(field.facts->values.count, 2u);
	EXPECT_EQ(field.facts->values.values[0], 1.0);
}

TEST(Manifest, RefusesAPackThatContradictsItself)
{
	const std::vector<std::function<void(Made&)>> damages = {
	    [](Made& m) { m.block(0)["pack"]["cells"] = -1; },
	    [](Made& m) { m.block(0)["pack"]["parts_read"] = 6; },
	    [](Made& m) { m.block(0)["pack"]["bounds"][0] = 5.0; },
	    [](Made& m) { m.block(0)["pack"]["bounds"].erase(5); },
	    [](Made& m) {
		    m.block(0)["pack"]["numbers"] = m.array<std::int64_t>("int64", {1, 2});
	    },
	    [](Made& m) { m.block(0)["pack"].erase("numbers"); },
	    [](Made& m) { m.block(0)["pack"]["cells_without_place"] = -1; },
	    [](Made& m) { m.block(0)["arrays"][0]["facts"]["spans"].erase(1); },
	    [](Made& m) { m.block(0)["arrays"][0]["facts"]["spans"][0][0] = 6.0; },
	    [](Made& m) { m.block(0)["arrays"][0]["facts"]["spans"][0][2] = 1; },
	    [](Made& m) { m.block(0)["arrays"][0]["facts"]["values"][0] = "x"; },
	    [](Made& m) { m.block(0)["arrays"][0]["facts"].erase("changes"); },
	};
	for (std::size_t d = 0; d < damages.size(); ++d)
	{
		Made made = makePackManifest();
		damages[d](made);
		EXPECT_FALSE(made.check()) << d;
	}
}

// A pack of one tetrahedron, whose lists lie in a file of zeros.
Made makePlacedPack(const std::string& file)
{
	Made made;
	const auto counts = [&](std::uint64_t count) { return made.array<std::uint64_t>("uint64", {count}); };
	json array = {{"name", "f"}, {"association", "point"}, {"components", 1}, {"type", "float32"}};
	json facts = {{"tuples", 4}, {"values", json::array()}, {"changes", {0, 0}}};
	facts["spans"] = json::array({{0.0, 0.0, false, false}, {0.0, 0.0, false, false}});
	array["times"] = json::array({{{"offset", 0}, {"facts", facts}}, {{"offset", 16}, {"facts", facts}}});
	json block = {{"name", "pack"}, {"kind", "packed"}, {"file", file}, {"type", 10}, {"type_of_points", "float64"}};
	block["time"] = 1;
	block["runs"] = {{"boxes", made.array<double>("float64", {0, 0, 0, 1, 1, 1})},
	                 {"cells", counts(1)},
	                 {"ids", counts(4)},
	                 {"parts", counts(0)}};
	block["part_cells"] = counts(1);
	block["part_points"] = counts(4);
	block["part_first_ids"] = counts(0);
	block["part_first_ends"] = counts(0);
	block["lists"] = {{"points", 0}, {"point_numbers", 8}, {"ids", 16}, {"cell_numbers", 24}};
	block["arrays"] = json::array({array});
	block["pack"] = {
	    {"points", 4}, {"cells", 1},      {"cells_without_place", 2}, {"bounds", {0.0, 0.0, 0.0, 1.0, 1.0, 1.0}},
	    {"parts", 1},  {"parts_read", 0}, {"bytes_read", 0}};
	made.manifest()["blocks"].push_back(std::move(block));
	return made;
}

TEST(Manifest, ChecksThePlacesOfAPack)
{
	const TemporaryFolder folder;
	const std::string file = folder / "pack.vtkhdf";
	writeContents(file, std::string(96, '\0'));
	Made made = makePlacedPack(file);
	const Result<CheckedInput> input = made.check(made.text(), file);
	ASSERT_TRUE(input) << input.error().message;
	EXPECT_EQ(input->blocks[0].runs->runs().size(), 1u);
	EXPECT_EQ(input->blocks[0].whole->farthest.size(), 8u); // the corners of the box
	EXPECT_EQ(input->unplaced, 2u);
	EXPECT_EQ(input->blocks[0].runs->times(), 2u);
	EXPECT_TRUE(input->blocks[0].fields[0].is_in_runs);
	EXPECT_FALSE(made.check()); // no file may be read

	// Without any one of its values, and with others in their places.
	const json whole = made.manifest();
	for (const char* within : {"/blocks/0", "/blocks/0/runs", "/blocks/0/lists", "/blocks/0/arrays/0",
	                           "/blocks/0/arrays/0/times/0", "/blocks/0/pack"})
		for (const auto& [key, value] : whole.at(json::json_pointer(within)).items())
			for (const json& other : {json(), json("x"), json(-1), json(1000), json::object()})
			{
				const bool is_words = key == "name" && other.is_string();
				const bool is_none = key == "arrays" && other.is_object();
				const bool only_tells = std::string_view(within).ends_with("pack") && key != "cells" &&
				                        key != "bounds" && key != "parts_read" && other == 1000;
				json changed = whole;
				json& parent = changed.at(json::json_pointer(within));
				if (other.is_null())
					parent.erase(key);
				else
					parent[key] = other;
				EXPECT_EQ(bool(made.check(changed.dump(), file)), is_words || is_none || only_tells)
				    << within << " " << key << other;
			}
	writeContents(file, std::string(95, '\0')); // shorter than the places of its points
	EXPECT_FALSE(made.check(made.text(), file));
}

TEST(Manifest, ChecksTheFileThatAnIndexIsOf)
{
	const TemporaryFolder folder;
	const std::string index = folder / "a.vtu.vpx", file = folder / "a.vtu";
	writeContents(index, std::string(96, '\0'));
	const auto stamped = [&](std::size_t bytes)
	{
		writeContents(file, std::string(bytes, '\0'));
		const SourceStamp stamp = stampOf(parts::OpenFile(file).descriptor());
		return json{stamp.device, stamp.number, stamp.bytes, stamp.changed, stamp.head};
	};
	Made made = makePlacedPack(index);
	const auto why = [&](const std::string& indexed)
	{
		const Result<CheckedInput> checked = made.check(made.text(), index, indexed);
		return checked ? std::string() : checked.error().message;
	};
	EXPECT_EQ(why(file), "it is no index");
	const json stamp = stamped(32); // four floats at 16, of the later time
	made.block(0)["source"] = stamp;
	made.block(0)["arrays"][0]["in_source"] = true;
	EXPECT_EQ(why(file), "");
	EXPECT_EQ(why(""), "the index of another file; open that file");
	for (std::size_t i = 0; i < stamp.size(); ++i)
	{
		made.block(0)["source"][i] = stamp[i].get<std::uint64_t>() + 1;
		EXPECT_NE(why(file).find("before its file was changed"), std::string::npos) << i;
		made.block(0)["source"] = stamp;
	}
	for (const json& other : {json{1, 2}, json("x"), json(7), json{{"a", 1}}, json{-1, 2, 3, 4, 5}})
	{
		made.block(0)["source"] = other;
		EXPECT_NE(why(file), "") << other;
	}
	made.block(0)["source"] = stamped(31);
	EXPECT_EQ(why(file), "a list of its parts lies outside of the file");
}

} // namespace

TEST(Manifest, ThatHoldsIsTakenWhole)
{
	const auto checked = makeManifest().check();
	ASSERT_TRUE(checked) << checked.error().message;
	ASSERT_EQ(checked->blocks.size(), 4u);
	EXPECT_EQ(checked->times, std::vector<double>{0.5});
	const auto& image = std::get<grid::UniformGrid>(checked->blocks[0].mesh);
	EXPECT_EQ(image.point(11), Vec3(2.0, 2.0, 1.0));
	const auto& rectilinear = std::get<grid::RectilinearGrid>(checked->blocks[1].mesh);
	EXPECT_EQ(rectilinear.point(11), Vec3(0.75, 1.0, 1.0));
	const auto& curvilinear = std::get<grid::CurvilinearGrid>(checked->blocks[2].mesh);
	EXPECT_EQ(curvilinear.point(11), Vec3(2.0, 1.0, 1.0));
	const auto& mesh = std::get<CellMesh>(checked->blocks[kMesh].mesh);
	EXPECT_EQ(mesh.cells.types.size(), 3u);
	EXPECT_EQ(checked->blocks[kMesh].fields[1].value(2, 0), 2.0);
}

TEST(Manifest, NamesUnitsOrNot)
{
	Made made = makeManifest();
	made.block(0)["arrays"][0]["units"] = "K";
	made.manifest()["length_units"] = "mm\n";
	const auto checked = made.check();
	ASSERT_TRUE(checked);
	EXPECT_EQ(checked->blocks[0].fields[0].units, "K");
	EXPECT_EQ(checked->blocks[0].fields[1].units, "");
	EXPECT_EQ(checked->blocks[1].length_units, "mm "); // one line
	EXPECT_EQ(checked->time_units, "");
	made.block(0)["arrays"][0]["units"] = 7;
	expectRefused(made, "units");
	made = makeManifest();
	made.manifest()["time_units"] = "ms";
	EXPECT_EQ(made.check()->time_units, "ms");
	made.manifest()["length_units"] = json::array();
	expectRefused(made, "length_units");
}

TEST(Manifest, WithWrongArrayPlacesIsRefused)
{
	const std::uint64_t huge = std::numeric_limits<std::uint64_t>::max();
	for (const json& value :
	     {json(huge), json(huge - 63), json(std::uint64_t(1) << 40), json(-64), json(1), json(0.5), json("0"), json()})
	{
		Made made = makeManifest();
		made.block(0)["arrays"][0]["offset"] = value;
		expectRefused(made, "offset");
		made = makeManifest();
		made.block(kMesh)["cells"]["connectivity"]["offset"] = value;
		expectRefused(made, "offset");
	}
	for (const json& value : {json(huge), json(0), json(44), json(52), json(-1), json(1e30), json()})
	{
		Made made = makeManifest();
		made.block(0)["arrays"][0]["bytes"] = value;
		expectRefused(made, "bytes");
		made = makeManifest();
		made.block(2)["coordinates"]["bytes"] = value;
		expectRefused(made, "bytes");
		made = makeManifest();
		made.block(kMesh)["cells"]["types"]["bytes"] = value;
		expectRefused(made, "bytes");
	}
	Made made = makeManifest();
	made.bytes().resize(made.bytes().size() - 1);
	expectRefused(made, "shorter memory");
	made.bytes().clear();
	expectRefused(made, "no memory");
}

TEST(Manifest, WithCountsThatOverflowIsRefused)
{
	for (const json& points :
	     {json({1u << 31, 1u << 31, 4}), json({std::uint64_t(1) << 62, 4, 4}),
	      json({std::uint64_t(1) << 32, std::uint64_t(1) << 32, 2}), json({3, 2, 1}), json({0, 2, 2}), json({-3, 2, 2}),
	      json({3, 2}), json({2048, 2048, 1024}), json(12), json({6, 2, 2}), json({3.0, 2, 2})})
		for (const std::size_t b : {0, 2})
		{
			Made made = makeManifest();
			made.block(b)["points"] = points;
			expectRefused(made, "points");
		}
	for (const json& components : {json(0), json(-1), json(2), json(1u << 31), json(std::uint64_t(1) << 62)})
	{
		Made made = makeManifest();
		made.block(1)["arrays"][1]["components"] = components;
		expectRefused(made, "components");
	}
}

// An empty partition, which may stand among other inputs.
TEST(Manifest, WithoutBlocksHasNone)
{
	Made made = makeManifest();
	made.manifest()["blocks"] = json::array();
	made.manifest()["patches"] = json::array();
	const auto checked = made.check();
	ASSERT_TRUE(checked) << checked.error().message;
	EXPECT_TRUE(checked->blocks.empty());
}

TEST(Manifest, WithWrongTypesOrWordsIsRefused)
{
	const auto refused = [](const char* what, auto&& change)
	{
		Made made = makeManifest();
		change(made);
		expectRefused(made, what);
	};
	refused("array type", [](Made& m) { m.block(0)["arrays"][0]["type"] = "float64"; });
	refused("array type", [](Made& m) { m.block(0)["arrays"][0]["type"] = "float31"; });
	refused("array type", [](Made& m) { m.block(0)["arrays"][0]["type"] = 7; });
	refused("axis type", [](Made& m) { m.block(1)["axes"][0]["type"] = "float32"; });
	refused("axes", [](Made& m) { m.block(1)["axes"].erase(2); });
	refused("coordinate type", [](Made& m) { m.block(2)["coordinates"]["type"] = "int32"; });
	refused("connectivity type", [](Made& m) { m.block(kMesh)["cells"]["connectivity"]["type"] = "int32"; });
	refused("association", [](Made& m) { m.block(0)["arrays"][0]["association"] = "edge"; });
	refused("association", [](Made& m) { m.block(0)["arrays"][0]["association"] = "cell"; });
	refused("kind", [](Made& m) { m.block(0)["kind"] = "tree"; });
	refused("no kind", [](Made& m) { m.block(0).erase("kind"); });
	refused("no cells", [](Made& m) { m.block(kMesh).erase("cells"); });
	refused("blocks", [](Made& m) { m.manifest()["blocks"] = 3; });
	refused("times", [](Made& m) { m.manifest()["times"] = {"now"}; });
	refused("spacing", [](Made& m) { m.block(0)["spacing"] = {1.0, 0.0, 1.0}; });
	refused("spacing",
	        [](Made& m)
	        {
		        m.block(0)["spacing"] = {1.0, 1e308, 1.0};
		        m.block(0)["origin"] = {0.0, 1e308, 0.0};
	        });
	refused("spacing", [](Made& m) { m.block(0)["spacing"] = {1.0, nullptr, 1.0}; });
	refused("origin", [](Made& m) { m.block(0)["origin"] = {1.0}; });
	Made made = makeManifest();
	made.manifest()["version"] = kProtocolVersion + 1;
	ASSERT_FALSE(made.check());
	EXPECT_EQ(made.check().error().kind, ErrorKind::internal); // not the file's fault
	for (const char* text : {"", "{", "[]", "null", "{}", "3", "\"\""})
		EXPECT_FALSE(made.check(text)) << text;
	EXPECT_FALSE(made.check(std::string(1 << 20, '[')));
}

TEST(Manifest, WithWrongCellsIsRefused)
{
	const auto refused = [](const char* what, const char* list, std::size_t i, std::int64_t value)
	{
		Made made = makeManifest();
		made.at<std::int64_t>(made.block(kMesh)["cells"][list])[i] = value;
		expectRefused(made, what);
	};
	const std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
	for (const std::int64_t id : {std::int64_t(6), std::int64_t(-1), std::int64_t(1) << 32, lowest})
	{
		refused("tetrahedron's id", "connectivity", 3, id);
		refused("polyhedron's id", "connectivity", 5, id);
		refused("triangle's id", "connectivity", 11, id);
		refused("face's id", "face_stream", 2, id);
		refused("last face's id", "face_stream", 21, id);
	}
	refused("falling offsets", "offsets", 1, 10);
	refused("negative offset", "offsets", 1, -4);
	refused("first offset", "offsets", 0, 1);
	refused("last offset", "offsets", 3, 13);
	refused("tetrahedron of three points", "offsets", 1, 3);
	refused("falling face offsets", "face_offsets", 2, -1);
	refused("last face offset", "face_offsets", 3, 23);
	refused("empty face stream", "face_offsets", 2, 0);
	for (const std::int64_t count :
	     {std::int64_t(0), std::int64_t(4), std::int64_t(6), std::int64_t(-5), lowest, -(lowest + 1)})
		refused("faces", "face_stream", 0, count);
	for (const std::int64_t size :
	     {std::int64_t(0), std::int64_t(3), std::int64_t(5), std::int64_t(-4), lowest, lowest + 9})
		refused("face size", "face_stream", 1, size);

	for (const int type : {12, 14, 25, 38, 200, 72})
	{
		Made made = makeManifest();
		made.at<std::uint8_t>(made.block(kMesh)["cells"]["types"])[0] = static_cast<std::uint8_t>(type);
		expectRefused(made, "type");
	}
	Made made = makeManifest();
	made.block(kMesh)["cells"].erase("face_offsets");
	expectRefused(made, "polyhedron without faces");
}

TEST(Manifest, WithWrongSourcesIsRefused)
{
	const auto with = [](const std::vector<std::int64_t>& sources, std::size_t cells, std::size_t points)
	{
		Made made = makeManifest();
		json& lists = made.block(kMesh)["cells"];
		lists["source_cells"] = made.array<std::int64_t>("int64", sources);
		lists["source_cell_count"] = cells;
		lists["source_point_count"] = points;
		// Cell arrays are as long as the file's cells.
		json& id = made.block(kMesh)["arrays"][1];
		id = made.field("id", "cell", 1, made.array<std::int64_t>("int64", std::vector<std::int64_t>(cells, 5)));
		return made;
	};
	const auto checked = with({1, 1, 0}, 2, 5).check();
	ASSERT_TRUE(checked) << checked.error().message;
	const auto& mesh = std::get<CellMesh>(checked->blocks[kMesh].mesh);
	EXPECT_EQ(mesh.cells.source_points, 5u);
	const auto grid = grid::UnstructuredGrid::build(mesh.points, mesh.cells);
	EXPECT_EQ(grid.cellCount(), 2u);
	EXPECT_EQ(grid.sourceCellCount(), 1u);
	EXPECT_EQ(grid.sourcePointCount(), 5u);
	EXPECT_TRUE(grid.splitsCells());
	EXPECT_EQ(grid.sourceCell(0), 1u);
	EXPECT_EQ(grid.sourceCell(1), 1u);

	expectRefused(with({1, 1, 2}, 2, 5), "source past the end");
	expectRefused(with({1, -1, 0}, 2, 5), "negative source");
	expectRefused(with({1, std::numeric_limits<std::int64_t>::min(), 0}, 2, 5), "lowest source");
	expectRefused(with({1, 1}, 2, 5), "too few sources");
	expectRefused(with({1, 1, 0, 0}, 2, 5), "too many sources");
	expectRefused(with({}, 2, 5), "no sources");
	expectRefused(with({1, 1, 0}, 4, 5), "more cells in the file");
	expectRefused(with({1, 1, 0}, 2, 7), "more points in the file");
	for (const char* key : {"source_cell_count", "source_point_count"})
	{
		Made made = with({1, 1, 0}, 2, 5);
		made.block(kMesh)["cells"].erase(key);
		expectRefused(made, key);
		made.block(kMesh)["cells"][key] = -1;
		expectRefused(made, key);
	}
	Made made = with({1, 1, 0}, 2, 5);
	made.block(kMesh)["arrays"][1] = makeManifest().block(kMesh)["arrays"][1];
	expectRefused(made, "cell array as long as the parts");
}

TEST(Manifest, WithCoordinatesThatAreNoNumbersLosesCellsOrIsRefused)
{
	const auto warnings = [](const Made& made)
	{
		const auto checked = made.check(made.text());
		EXPECT_TRUE(checked) << (checked ? "" : checked.error().message);
		return checked && !checked->warnings.empty() ? checked->warnings.back().text() : std::string();
	};
	for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL})
	{
		Made made = makeManifest();
		made.at<double>(made.block(2)["coordinates"])[35] = value;
		EXPECT_NE(warnings(made).find("left out"), std::string::npos) << "curvilinear";
		made = makeManifest();
		made.at<float>(made.block(kMesh)["coordinates"])[0] = static_cast<float>(value);
		EXPECT_NE(warnings(made).find("left out"), std::string::npos) << "mesh";
		made = makeManifest();
		made.at<double>(made.block(1)["axes"][0])[1] = value;
		expectRefused(made, "axis");
	}
	Made made = makeManifest();
	made.at<double>(made.block(1)["axes"][0])[1] = 5.0;
	expectRefused(made, "axis that turns back");
}

TEST(Manifest, WithFlippedBytesNeverCrashes)
{
	const Made whole = makeManifest();
	const std::string text = whole.text();
	std::mt19937 random(7);
	std::size_t held = 0;
	const int rounds = test::tries(20000);
	for (int round = 0; round < rounds; ++round)
	{
		std::string changed = text;
		Made made = whole;
		for (int flips = 1 + static_cast<int>(random() % 3); flips > 0; --flips)
		{
			if (round % 2 == 0)
				changed[random() % changed.size()] = static_cast<char>("0123456789-.eE[]{}\",:\xff"[random() % 22]);
			else
				made.bytes()[random() % made.bytes().size()] ^= static_cast<std::byte>(1 << random() % 8);
		}
		const auto checked = made.check(changed);
		held += static_cast<bool>(checked);
		EXPECT_TRUE(checked || !checked.error().message.empty());
	}
	EXPECT_GT(held, rounds / 200u); // a flipped value is as good as another
}

TEST(Manifest, OfTooManyLevelsIsRefused)
{
	for (const char bracket : {'[', '{'})
	{
		std::string deep = R"({"version": )";
		for (int level = 0; level < 1'000'000; ++level)
			deep.append(bracket == '[' ? "[" : R"({"a": )");
		const Result<CheckedInput> checked = Made().check(deep);
		ASSERT_FALSE(checked);
		EXPECT_NE(checked.error().message.find("nested too deeply"), std::string::npos) << checked.error().message;
	}
}
