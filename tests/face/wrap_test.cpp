#include "wrapped_grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

namespace face
{

namespace
{

using vprobe::Dataset;
using vprobe::ErrorKind;
using vprobe::View;

View oblique()
{
	return View().origin({0.47, 0.52, 0.5}).normal({0.3, 0.5, 0.8}).array("value");
}

Dataset wrap(vprobe::Block block)
{
	auto data = Dataset::wrap({std::move(block)}, vprobe::Classify::cpu);
	EXPECT_TRUE(data) << (data ? "" : data.error().message);
	return *data;
}

void refused(vprobe::Block block, const std::string& word)
{
	const auto data = Dataset::wrap({std::move(block)}, vprobe::Classify::cpu);
	ASSERT_FALSE(data) << word;
	EXPECT_EQ(data.error().kind, ErrorKind::input);
	EXPECT_NE(data.error().message.find(word), std::string::npos) << data.error().message;
}

} // namespace

// The plane x + 2 y + 3 z = c cuts all kinds of the same box alike, and its values are those of the formula.
TEST(Wrap, EveryKindOfGridGivesTheSameCut)
{
	Box box(9);
	std::vector<std::pair<std::string, vprobe::Block>> kinds{
	    {"image", box.image()},          {"rectilinear", box.rectilinear()},  {"structured", box.structured()},
	    {"64 bits", box.unstructured()}, {"32 bits", box.unstructured(true)}, {"polyhedra", box.polyhedra()}};
	std::optional<vprobe::Figures> first;
	for (auto& [name, block] : kinds)
	{
		SCOPED_TRACE(name);
		const Dataset data = wrap(std::move(block));
		EXPECT_EQ(data.cellCount(), 729u);
		EXPECT_EQ(data.pointCount(), 1000u);
		for (int round = 0; round < 2; ++round) // the second cut of an unstructured grid is found otherwise
		{
			const auto cut = data.cut(oblique());
			ASSERT_TRUE(cut) << cut.error().message;
			const vprobe::Figures figures = cut->figures(0);
			if (!first)
				first = figures;
			EXPECT_NEAR(figures.area, first->area, 1e-12);
			EXPECT_NEAR(*figures.mean, *first->mean, 1e-12);
			EXPECT_EQ(figures.cut_cells, first->cut_cells);
			EXPECT_EQ(figures.components, 1u);
			const vprobe::Mesh mesh = cut->mesh(0);
			const vprobe::MeshArray* value = mesh.array("value");
			ASSERT_TRUE(value);
			ASSERT_EQ(value->tuples, mesh.pointCount());
			for (std::size_t p = 0; p < mesh.pointCount(); ++p)
			{
				const double* at = mesh.points().data() + 3 * p;
				EXPECT_NEAR(value->value(p), at[0] + 2.0 * at[1] + 3.0 * at[2], 1e-12);
			}
			const vprobe::MeshArray* number = mesh.array("number");
			ASSERT_TRUE(number);
			ASSERT_EQ(mesh.offsets().size(), mesh.polygonCount() + 1);
			for (std::size_t i = 0; i < mesh.polygonCount(); ++i)
				EXPECT_EQ(number->value(i), static_cast<double>(mesh.cells()[i]));
		}
	}
}

TEST(Wrap, ADemoWrappedAgainGivesTheDemosCut)
{
	const auto demo = Dataset::open("demo:shell:8", {.classify = vprobe::Classify::cpu});
	ASSERT_TRUE(demo) << demo.error().message;
	const auto cut = demo->cut(View().normal({0.3, 0.5, 0.8}));
	ASSERT_TRUE(cut);
	EXPECT_GT(cut->mesh(0).polygonCount(), 50u);
	EXPECT_EQ(demo->arrays().empty(), false);
	EXPECT_STREQ(demo->kind(), "curvilinear");
}

TEST(Wrap, BlocksThatAbutAreOneDataSet)
{
	const Box box(4);
	std::vector<vprobe::Block> blocks;
	for (const double x : {0.0, 1.0})
		blocks.push_back({vprobe::Image3{.points = {5, 5, 5}, .origin = {x, 0.0, 0.0}, .spacing = {0.25, 0.25, 0.25}},
		                  box.fields()});
	const auto data = Dataset::wrap(blocks, vprobe::Classify::cpu);
	ASSERT_TRUE(data);
	EXPECT_EQ(data->blockCount(), 2u);
	const auto cut = data->cut(View().normal({0.0, 0.0, 1.0}).origin({1.0, 0.5, 0.4}));
	ASSERT_TRUE(cut);
	EXPECT_NEAR(cut->figures(0).area, 2.0, 1e-12);
	EXPECT_EQ(cut->figures(0).components, 1u);
}

TEST(Wrap, WhatDoesNotFitIsAnErrorThatSaysWhat)
{
	const Box box(3);
	const auto spoiled = [&](const std::function<void(vprobe::Unstructured&)>& spoil)
	{
		vprobe::Block block = box.unstructured();
		spoil(std::get<vprobe::Unstructured>(block.grid));
		return block;
	};
	std::vector<std::int64_t> ids = box.connectivity;
	ids[5] = 64;
	refused(spoiled([&](vprobe::Unstructured& grid) { grid.connectivity = ids; }), "point");
	ids[5] = -1;
	refused(spoiled([&](vprobe::Unstructured& grid) { grid.connectivity = ids; }), "point");
	std::vector<std::uint8_t> types = box.types;
	types[3] = 200;
	refused(spoiled([&](vprobe::Unstructured& grid) { grid.types = types; }), "type");
	std::vector<std::int64_t> offsets = box.offsets;
	offsets[2] = 1000;
	refused(spoiled([&](vprobe::Unstructured& grid) { grid.offsets = offsets; }), "");
	refused(spoiled([&](vprobe::Unstructured& grid) { grid.offsets = vprobe::Numbers(); }), "offsets");
	refused(spoiled([&](vprobe::Unstructured& grid) { grid.types = box.connectivity; }), "types");
	std::vector<double> coordinates = box.coordinates;
	std::ranges::fill(coordinates, std::numeric_limits<double>::quiet_NaN());
	refused(spoiled([&](vprobe::Unstructured& grid) { grid.coordinates = coordinates; }), "every cell has a point");
	refused(spoiled([&](vprobe::Unstructured& grid)
	                { grid.coordinates = std::span(box.coordinates).first(box.coordinates.size() - 1); }),
	        "coordinates");

	vprobe::Block image = box.image();
	image.fields[0].components = 2;
	refused(image, "value");
	image = box.image();
	image.fields[0].values = vprobe::Numbers(nullptr, 64, vprobe::NumberType::float64);
	refused(image, "no memory");
	std::get<vprobe::Image3>((image = box.image()).grid).spacing[1] = 0.0;
	refused(image, "spacing");
	std::get<vprobe::Image3>((image = box.image()).grid).points[2] = 1;
	refused(image, "no cells");
	vprobe::Block structured = box.structured();
	std::get<vprobe::Structured>(structured.grid).points[0] = 5;
	refused(structured, "coordinates");
	EXPECT_EQ(Dataset::wrap({}).error().kind, ErrorKind::input);
}

// The ids of cells of one type may wait for the first cut. Those of others do not.
TEST(Wrap, AWrongIdMayBeAnErrorOfTheFirstCut)
{
	const Box box(3);
	for (const std::int64_t bad : {std::int64_t(-1), std::int64_t(64), std::int64_t(1) << 40})
	{
		std::vector<std::int64_t> ids = box.connectivity;
		ids[100] = bad;
		vprobe::Block block = box.unstructured();
		auto& grid = std::get<vprobe::Unstructured>(block.grid);
		grid.connectivity = ids;
		grid.checks_ids_later = true;
		const auto data = Dataset::wrap({block}, vprobe::Classify::cpu);
		ASSERT_TRUE(data) << data.error().message;
		for (int i = 0; i < 2; ++i)
		{
			const auto cut = data->cut(View());
			ASSERT_FALSE(cut);
			EXPECT_EQ(cut.error().kind, ErrorKind::input);
			EXPECT_EQ(cut.error().message, "a cell lists point " + std::to_string(bad) + " of 64");
			const std::vector<vprobe::Vector3> places{{0.5, 0.5, 0.5}};
			const auto samples = data->sample(places);
			ASSERT_FALSE(samples);
			EXPECT_EQ(samples.error().message, cut.error().message);
		}
	}
	Box others(3);
	std::vector<std::int64_t> ids = box.connectivity;
	ids[5] = 64;
	vprobe::Block mixed = others.polyhedra();
	auto& grid = std::get<vprobe::Unstructured>(mixed.grid);
	grid.connectivity = ids;
	grid.checks_ids_later = true;
	refused(mixed, "point");
}

// Cells with a point without a place are left out, with a warning that counts them. Points of no cell do not matter.
TEST(Wrap, CellsWithoutAPlaceAreLeftOut)
{
	const Box box(3);
	std::vector<double> coordinates = box.coordinates;
	coordinates[1] = std::numeric_limits<double>::quiet_NaN();
	for (vprobe::Block block : {box.unstructured(), box.structured()})
	{
		std::visit(
		    [&](auto& grid)
		    {
			    if constexpr (requires { grid.coordinates; })
				    grid.coordinates = coordinates;
		    },
		    block.grid);
		std::string words;
		const vprobe::MessageListener listener([&](std::string_view line) { words += line; });
		const Dataset data = wrap(block);
		EXPECT_NE(words.find("1 cell is left out"), std::string::npos) << words;
		EXPECT_EQ(data.cellCount(), 26u);
		for (int round = 0; round < 2; ++round)
		{
			const auto cut = data.cut(View().normal({0.0, 0.0, 1.0}).origin({0.5, 0.5, 0.1}).array("value"));
			ASSERT_TRUE(cut);
			EXPECT_NEAR(cut->figures(0).area, 8.0 / 9.0, 1e-12);
			EXPECT_EQ(cut->mesh(0).array("number")->value(0), static_cast<double>(cut->mesh(0).cells()[0]));
		}
	}
	coordinates = box.coordinates;
	coordinates.insert(coordinates.end(), 3, std::numeric_limits<double>::infinity());
	vprobe::Block block = box.unstructured();
	std::get<vprobe::Unstructured>(block.grid).coordinates = coordinates;
	block.fields.clear();
	const auto cut = wrap(block).cut(View());
	ASSERT_TRUE(cut);
	EXPECT_NEAR(cut->figures(0).area, 1.0, 1e-12);
}

// A hexagonal prism and, on top of it, a pentagonal one and the wedge that it lacks.
TEST(Wrap, PrismsOverPentagonsAndHexagons)
{
	constexpr std::array<std::array<double, 2>, 6> kHexagon{{{1, 0}, {2, 0}, {3, 1}, {2, 2}, {1, 2}, {0, 1}}};
	std::vector<double> coordinates;
	for (const double z : {0.0, 1.0, 2.0})
		for (const auto& [x, y] : kHexagon)
			coordinates.insert(coordinates.end(), {x, y, z});
	const std::vector<std::uint8_t> types{16, 15, 13};
	const std::vector<std::int64_t> offsets{0, 12, 22, 28};
	std::vector<std::int64_t> ids{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
	for (const std::int64_t layer : {6, 12}) // without the corner at x = 3
		for (const std::int64_t corner : {0, 1, 3, 4, 5})
			ids.push_back(layer + corner);
	for (const std::int64_t layer : {6, 12})
		for (const std::int64_t corner : {1, 3, 2}) // as VTK turns a wedge
			ids.push_back(layer + corner);
	vprobe::Block block{vprobe::Unstructured{coordinates, types, offsets, ids, {}, {}}, {}};
	const Dataset data = wrap(block);
	EXPECT_EQ(data.cellCount(), 3u);
	for (int round = 0; round < 2; ++round)
	{
		const auto lower = data.cut(View().normal({0.0, 0.0, 1.0}).origin({1.0, 1.0, 0.5}));
		ASSERT_TRUE(lower);
		EXPECT_NEAR(lower->figures(0).area, 4.0, 1e-12);
		EXPECT_EQ(lower->mesh(0).polygonCount(), 1u);
		const auto upper = data.cut(View().normal({0.0, 0.0, 1.0}).origin({1.0, 1.0, 1.5}));
		ASSERT_TRUE(upper);
		EXPECT_NEAR(upper->figures(0).area, 4.0, 1e-12);
		EXPECT_EQ(upper->mesh(0).polygonCount(), 2u);
		EXPECT_EQ(upper->figures(0).components, 1u);
		const auto upright = data.cut(View().normal({0.0, 1.0, 0.0}).origin({1.0, 0.5, 1.0}));
		ASSERT_TRUE(upright);
		EXPECT_NEAR(upright->figures(0).area, 2.0 * 2.0, 1e-12);
	}
	const std::vector<std::int64_t> too_few{0, 11, 21, 27};
	std::get<vprobe::Unstructured>(block.grid).offsets = too_few;
	refused(block, "a prism of 6 sides, lists 11 points");
	ids[3] = 18;
	std::get<vprobe::Unstructured>(block.grid).offsets = offsets;
	std::get<vprobe::Unstructured>(block.grid).connectivity = ids;
	refused(block, "point");
}

// A cube in six tetrahedra, each listed as another cell that is collapsed to four corners. A face may have all four.
TEST(Wrap, TetrahedraListedAsOtherCells)
{
	constexpr std::array<std::array<int, 4>, 6> kCube{
	    {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};
	const std::vector<double> coordinates{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
	struct Way
	{
		std::uint8_t type;
		std::vector<std::size_t> order; // which corner is listed at each place
	};
	const std::vector<Way> ways{{10, {0, 1, 2, 3}},
	                            {12, {0, 1, 2, 2, 3, 3, 3, 3}}, // Ansys
	                            {12, {0, 1, 2, 3, 3, 3, 3, 3}}, // LS-DYNA
	                            {12, {3, 3, 0, 3, 3, 1, 2, 3}}, // the same, turned
	                            {11, {0, 1, 3, 2, 3, 3, 3, 3}},
	                            {13, {0, 1, 2, 3, 3, 3}},
	                            {13, {0, 1, 2, 3, 2, 2}},
	                            {14, {0, 1, 2, 2, 3}},
	                            {14, {0, 1, 2, 3, 3}}};
	for (std::size_t first = 0; first < ways.size(); ++first)
		for (const std::size_t second : {first, std::size_t(0)}) // alone, and beside tetrahedra
		{
			std::vector<std::uint8_t> types;
			std::vector<std::int64_t> offsets{0};
			std::vector<std::int32_t> ids;
			for (std::size_t c = 0; c < kCube.size(); ++c)
			{
				const Way& way = ways[c % 2 ? second : first];
				types.push_back(way.type);
				for (const std::size_t corner : way.order)
					ids.push_back(kCube[c][corner]);
				offsets.push_back(static_cast<std::int64_t>(ids.size()));
			}
			const Dataset data = wrap({vprobe::Unstructured{coordinates, types, offsets, ids, {}, {}}, {}});
			for (const char* strategy : {"scan", "cells", "generations"})
				for (const auto& [normal, area] : {std::pair{vprobe::Vector3{0.0, 0.0, 1.0}, 1.0},
				                                   std::pair{vprobe::Vector3{0.6, 0.8, 0.0}, std::nan("")},
				                                   std::pair{vprobe::Vector3{1.0, 1.0, 1.0}, 0.75 * std::sqrt(3.0)}})
				{
					View view = View().normal(normal).origin({0.5, 0.5, std::isnan(area) ? 0.3 : 0.5});
					ASSERT_TRUE(view.set("strategy", strategy));
					const auto cut = data.cut(view);
					ASSERT_TRUE(cut) << cut.error().message;
					const double wanted = std::isnan(area) ? 1.25 : area; // 1 / 0.8 wide
					EXPECT_NEAR(cut->figures(0).area, wanted, 1e-12) << first << " " << second << " " << strategy;
					EXPECT_EQ(cut->figures(0).components, 1u);
				}
		}
}

// Hexahedra and wedges that are collapsed to wedges and pyramids.
TEST(Wrap, WedgesAndPyramidsListedAsOtherCells)
{
	const std::vector<double> wedge{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};
	const std::vector<double> pyramid{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1};
	struct Case
	{
		const std::vector<double>& coordinates;
		std::uint8_t type;
		std::vector<std::int32_t> ids;
		std::array<double, 3> areas; // at x, y and z = 1/4
	};
	const std::vector<Case> cases{{wedge, 12, {0, 1, 2, 2, 3, 4, 5, 5}, {0.75, 0.75, 0.5}},
	                              {wedge, 12, {0, 3, 4, 1, 2, 5, 5, 2}, {0.75, 0.75, 0.5}},
	                              {pyramid, 12, {0, 1, 2, 3, 4, 4, 4, 4}, {15.0 / 32, 15.0 / 32, 9.0 / 16}},
	                              {pyramid, 13, {0, 3, 4, 1, 2, 4}, {15.0 / 32, 15.0 / 32, 9.0 / 16}}};
	for (const Case& c : cases)
	{
		const std::vector<std::uint8_t> types{c.type};
		const std::vector<std::int64_t> offsets{0, static_cast<std::int64_t>(c.ids.size())};
		const Dataset data = wrap({vprobe::Unstructured{c.coordinates, types, offsets, c.ids, {}, {}}, {}});
		for (const char* strategy : {"scan", "cells", "generations"})
			for (std::size_t axis = 0; axis < 3; ++axis)
			{
				vprobe::Vector3 normal{0.0, 0.0, 0.0};
				normal[axis] = 1.0;
				View view = View().normal(normal).origin({0.25, 0.25, 0.25});
				ASSERT_TRUE(view.set("strategy", strategy));
				const auto cut = data.cut(view);
				ASSERT_TRUE(cut) << cut.error().message;
				EXPECT_NEAR(cut->figures(0).area, c.areas[axis], 1e-12) << int(c.type) << c.ids[1] << " " << axis;
			}
	}
}

TEST(Wrap, ArraysWithoutValuesAndWithNan)
{
	const Box box(3);
	vprobe::Block block = box.image();
	block.fields.clear();
	const auto cut = wrap(block).cut(View());
	ASSERT_TRUE(cut);
	EXPECT_FALSE(cut->figures(0).mean);
	EXPECT_NEAR(cut->figures(0).area, 1.0, 1e-12);

	std::vector<double> nan(64, std::numeric_limits<double>::quiet_NaN());
	block.fields = {{"nan", vprobe::Association::point, 1, nan}};
	const auto of_nan = wrap(block).cut(View());
	ASSERT_TRUE(of_nan);
	EXPECT_FALSE(of_nan->figures(0).mean);
	EXPECT_NEAR(of_nan->figures(0).nan_area, 1.0, 1e-12);
}

TEST(Wrap, SamplesAndTracesAndContours)
{
	const Box box(8);
	std::vector<double> flow;
	for (std::size_t p = 0; p < box.value.size(); ++p)
		flow.insert(flow.end(), {0.0, 0.0, 1.0});
	vprobe::Block block = box.unstructured();
	block.fields.push_back({"flow", vprobe::Association::point, 3, flow});
	const Dataset data = wrap(block);
	const std::vector<vprobe::Vector3> points{{0.1, 0.2, 0.3}, {2.0, 0.0, 0.0}, {0.9, 0.95, 0.5}};
	const auto samples = data.sample(points, {"value", "flow"});
	ASSERT_TRUE(samples) << samples.error().message;
	ASSERT_EQ(samples->columns.size(), 2u);
	EXPECT_NEAR(samples->columns[0].values[0], 0.1 + 0.4 + 0.9, 1e-12);
	EXPECT_EQ(samples->cells[1], -1);
	EXPECT_TRUE(std::isnan(samples->columns[0].values[1]));
	EXPECT_NEAR(samples->columns[1].values[8], 1.0, 1e-12);
	EXPECT_FALSE(data.sample(points, {"none"}));

	View view = View().origin({0.5, 0.5, 0.25}).array("value");
	ASSERT_TRUE(view.set("vectors", "lines"));
	ASSERT_TRUE(view.set("vector_steps", "3"));
	const double values[] = {2.25};
	view.contour(values);
	const auto cut = data.cut(view);
	ASSERT_TRUE(cut) << cut.error().message;
	const vprobe::Traces traces = cut->traces(0);
	ASSERT_GT(traces.offsets.size(), 100u);
	EXPECT_EQ(traces.points.size(), 3 * traces.times.size());
	EXPECT_NEAR(*cut->figures(0).flux, 1.0, 1e-12);
	ASSERT_EQ(cut->contourCount(), 1u);
	EXPECT_EQ(cut->contourValue(0), 2.25);
	const vprobe::Mesh contour = cut->contour(0);
	EXPECT_GT(contour.polygonCount(), 10u);
	for (std::size_t p = 0; p < contour.pointCount(); ++p)
		EXPECT_NEAR(contour.array("value")->value(p), 2.25, 1e-9);
}

namespace
{

// The corner of a ball of radius 1 as one quadratic tetrahedron. Its middles lie on the sphere, so a section at z is
// close to a quarter of a circle.
struct BallCorner
{
	std::vector<double> coordinates;
	std::vector<std::uint8_t> types{24};
	std::vector<std::int64_t> offsets{0, 10};
	std::vector<std::int32_t> nodes{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
	std::vector<double> value; // x x

	BallCorner()
	{
		const double h = std::sqrt(0.5);
		coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, .5, 0, 0, h, h, 0, 0, .5, 0, 0, 0, .5, h, 0, h, 0, h, h};
		for (std::size_t p = 0; p < 10; ++p)
			value.push_back(coordinates[3 * p] * coordinates[3 * p]);
	}
	vprobe::Block block(double tolerance) const
	{
		vprobe::Unstructured grid{coordinates, types, offsets, nodes, {}, {}};
		grid.tolerance = tolerance;
		return {grid, {{"value", vprobe::Association::point, 1, value}}};
	}
};

} // namespace

TEST(Wrap, QuadraticTetrahedraAreRefinedToATolerance)
{
	const BallCorner corner;
	double area = 0.0;
	std::size_t polygons = 0;
	for (const double tolerance : {0.5, 0.01, 0.0005})
	{
		const Dataset data = wrap(corner.block(tolerance));
		EXPECT_EQ(data.cellCount(), 1u);
		EXPECT_EQ(data.pointCount(), 10u);
		std::optional<vprobe::Figures> first;
		for (int round = 0; round < 2; ++round)
		{
			const auto cut = data.cut(View().origin({0, 0, 0.3}).normal({0, 0, 1}).array("value"));
			ASSERT_TRUE(cut) << cut.error().message;
			const vprobe::Figures figures = cut->figures(0);
			const vprobe::Mesh mesh = cut->mesh(0);
			EXPECT_GT(mesh.polygonCount(), polygons);
			ASSERT_TRUE(mesh.array("value"));
			for (const std::int64_t cell : mesh.cells())
				EXPECT_EQ(cell, 0);
			if (!first)
				first = figures;
			EXPECT_EQ(figures.area, first->area);
			EXPECT_EQ(figures.mean, first->mean);
		}
		EXPECT_GT(first->area, area);
		area = first->area;
		polygons = data.cut(View().origin({0, 0, 0.3}).normal({0, 0, 1}))->mesh(0).polygonCount();
		const auto plan = data.plan(View());
		ASSERT_TRUE(plan);
		EXPECT_EQ(plan->front().strategy, "scan");
	}
	EXPECT_NEAR(area, 0.25 * 3.14159265 * (1.0 - 0.09), 0.15); // four points of an arc are no circle
	EXPECT_GT(polygons, 100u);
}

TEST(Wrap, WhatAToleranceDoesNotServeIsRefused)
{
	const BallCorner corner;
	refused(corner.block(0.0), "cell 0 of type 24 is curved, and `tolerance` is 0");
	refused(corner.block(1.5), "`tolerance` is 1.5");
	BallCorner short_of_nodes;
	short_of_nodes.offsets = {0, 9};
	short_of_nodes.nodes.pop_back();
	refused(short_of_nodes.block(0.01), "lists 9 points");
	BallCorner wild;
	wild.nodes[9] = 10;
	refused(wild.block(0.01), "point 10 of 10");
	BallCorner hexahedron;
	hexahedron.types = {25};
	refused(hexahedron.block(0.01), "cell 0 of type 25 lists 10 points");
	BallCorner lagrange;
	lagrange.types = {72};
	refused(lagrange.block(0.01), "no cell of degrees up to 10");
	BallCorner pyramid;
	pyramid.types = {37};
	refused(pyramid.block(0.01), "type 37");
	const auto cut = wrap(corner.block(0.01)).cut(View().threshold(0.0, 1.0));
	ASSERT_FALSE(cut);
	EXPECT_EQ(cut.error().kind, ErrorKind::usage);
	EXPECT_NE(cut.error().message.find("`threshold`"), std::string::npos) << cut.error().message;
}

} // namespace face
