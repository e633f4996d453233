#include "wrapped_grids.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace face
{

namespace
{

using vprobe::Dataset;
using vprobe::View;

std::vector<double> doubled(const std::vector<double>& values)
{
	std::vector<double> twice;
	for (const double value : values)
		twice.push_back(2.0 * value);
	return twice;
}

double maximum(const vprobe::Mesh& mesh)
{
	const vprobe::MeshArray& values = *mesh.array("value");
	double most = values.value(0);
	for (std::size_t i = 1; i < values.tuples; ++i)
		most = std::max(most, values.value(i));
	return most;
}

} // namespace

TEST(Fields, OthersOnTheSameGridKeepItsNeighborsAndOlderCuts)
{
	Box box(5);
	auto data = Dataset::wrap({box.unstructured()}, vprobe::Classify::cpu);
	ASSERT_TRUE(data);
	ASSERT_TRUE(data->cut(View()));
	const auto before = data->cut(View().array("value"));
	ASSERT_TRUE(before);
	const std::size_t built = data->memory().built;
	ASSERT_GT(built, 0u);

	const std::vector<double> twice = doubled(box.value);
	vprobe::Field value{"value", vprobe::Association::point, 1, twice};
	vprobe::Field more{"more", vprobe::Association::cell, 1, box.number};
	ASSERT_TRUE(data->setFields({{value, more}}));
	EXPECT_EQ(data->memory().built, built);
	ASSERT_EQ(data->arrays().size(), 2u);
	EXPECT_EQ(data->arrays()[1].name, "more");
	const auto after = data->cut(View().array("value"));
	ASSERT_TRUE(after);
	EXPECT_NEAR(*after->figures(0).mean, 2.0 * *before->figures(0).mean, 1e-12);
	EXPECT_NEAR(maximum(after->mesh(0)), 2.0 * maximum(before->mesh(0)), 1e-12);
	EXPECT_EQ(after->mesh(0).array("number"), nullptr);
	EXPECT_NE(before->mesh(0).array("number"), nullptr); // asked for only now

	value.values.size -= 1;
	const auto refused = data->setFields({{value}});
	ASSERT_FALSE(refused);
	EXPECT_EQ(refused.error().kind, vprobe::ErrorKind::input);
	EXPECT_FALSE(data->setFields({}));
	EXPECT_TRUE(data->setFields({{}}));
	EXPECT_TRUE(data->arrays().empty());
	EXPECT_TRUE(data->cut(View()));
}

TEST(Fields, CellsWithoutAVolumeHaveValuesToo)
{
	Box box(5);
	vprobe::Block block = box.unstructured();
	auto& grid = std::get<vprobe::Unstructured>(block.grid);
	const auto* types = static_cast<const std::uint8_t*>(grid.types.data);
	std::vector<std::uint8_t> shown(types, types + grid.types.size);
	std::fill(shown.begin(), shown.begin() + 20, std::uint8_t(0)); // VTK's empty cell
	grid.types = vprobe::Numbers(shown);
	auto data = Dataset::wrap({block}, vprobe::Classify::cpu);
	ASSERT_TRUE(data);
	for (int cut = 0; cut < 2; ++cut)
	{
		std::vector<double> twice;
		for (const std::int32_t number : box.number)
			twice.push_back(2.0 * number);
		ASSERT_TRUE(data->setFields({{{"twice", vprobe::Association::cell, 1, twice}}}));
		const auto made = data->cut(View().normal({0.3, 0.5, 0.8}));
		ASSERT_TRUE(made);
		const vprobe::Mesh mesh = made->mesh(0);
		ASSERT_GT(mesh.polygonCount(), 0u);
		for (std::size_t i = 0; i < mesh.polygonCount(); ++i)
		{
			ASSERT_GE(mesh.cells()[i], 20);
			EXPECT_EQ(mesh.array("twice")->value(i), 2.0 * box.number[static_cast<std::size_t>(mesh.cells()[i])]);
		}
	}
}

TEST(Fields, WhatIsHeldIsTheCallers)
{
	Box box(4);
	const auto held = [](const vprobe::Block& block)
	{
		const auto data = Dataset::wrap({block}, vprobe::Classify::cpu);
		EXPECT_TRUE(data);
		return data->block(0);
	};
	for (const vprobe::Block& block :
	     {box.image(), box.rectilinear(), box.structured(), box.unstructured(), box.polyhedra()})
	{
		const vprobe::HeldBlock found = held(block);
		ASSERT_EQ(found.fields.size(), 2u);
		EXPECT_EQ(found.fields[0].values.data, box.value.data());
		EXPECT_EQ(found.fields[0].values.size, box.value.size());
		EXPECT_EQ(found.fields[1].values.data, box.number.data());
	}
	EXPECT_TRUE(held(box.image()).coordinates.empty());
	EXPECT_EQ(held(box.rectilinear()).coordinates[2].data, box.axis.data());
	EXPECT_EQ(held(box.structured()).coordinates[0].data, box.coordinates.data());
	EXPECT_EQ(held(box.unstructured()).coordinates[0].data, box.coordinates.data());
	EXPECT_EQ(held(box.unstructured()).connectivity.data, box.connectivity.data());
	EXPECT_EQ(held(box.unstructured(true)).connectivity.data, box.narrow.data());
}

TEST(Fields, FramesAreTheSweepsAndTheProbeIsAFile)
{
	const auto data = Dataset::open("demo:shell:8", {.classify = vprobe::Classify::cpu});
	ASSERT_TRUE(data);
	View view;
	ASSERT_TRUE(view.set("frames", "4"));
	std::vector<double> areas;
	ASSERT_TRUE(data->sweep(view,
	                        [&](const vprobe::SweepFrame& frame)
	                        {
		                        areas.push_back(frame.cut.figures(0).area);
		                        return true;
	                        }));
	ASSERT_EQ(areas.size(), 4u);
	for (int k = 3; k >= 0; --k)
	{
		const auto frame = data->frame(view, k);
		ASSERT_TRUE(frame);
		EXPECT_EQ(frame->count, 4);
		EXPECT_EQ(frame->cut.figures(0).area, areas[static_cast<std::size_t>(k)]);
		EXPECT_FALSE(frame->time);
	}
	EXPECT_EQ(data->frame(view, 4).error().kind, vprobe::ErrorKind::usage);
	ASSERT_TRUE(view.set("path", "times"));
	EXPECT_EQ(data->frame(view, 0).error().kind, vprobe::ErrorKind::usage);
	const auto text = data->probeText(View().shape(vprobe::ProbeShape::paddlewheel).vanes(5));
	ASSERT_TRUE(text);
	EXPECT_NE(text->find("\"sheets\""), std::string::npos);
}

TEST(Fields, TimesGoByAndComeBack)
{
	const auto folder = std::filesystem::temp_directory_path() / "vprobe_face_times";
	std::filesystem::create_directories(folder);
	std::ofstream list(folder / "steps.pvd");
	list << R"(<VTKFile type="Collection" version="0.1"><Collection>)";
	for (const int step : {0, 1})
	{
		const std::string name = "step" + std::to_string(step) + ".vti";
		std::ofstream file(folder / name);
		file << R"(<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian"><ImageData )"
		     << R"(WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 1 0 1 0 1">)"
		     << R"(<PointData><DataArray type="Float32" Name="value" format="ascii">)";
		for (int i = 0; i < 8; ++i)
			file << 10 * step + 1 << ' ';
		file << "</DataArray></PointData></Piece></ImageData></VTKFile>";
		list << R"(<DataSet timestep=")" << step << R"(" file=")" << name << R"("/>)";
	}
	list << "</Collection></VTKFile>";
	list.close();

	const auto data = Dataset::open((folder / "steps.pvd").string(), {.time = "0", .classify = vprobe::Classify::cpu});
	ASSERT_TRUE(data) << data.error().message;
	View times;
	ASSERT_TRUE(times.set("path", "times"));
	std::vector<vprobe::Cut> cuts;
	const auto swept = data->sweep(times,
	                               [&](const vprobe::SweepFrame& frame)
	                               {
		                               EXPECT_EQ(frame.time, frame.index);
		                               cuts.push_back(frame.cut);
		                               return true;
	                               });
	ASSERT_TRUE(swept) << swept.error().message;
	ASSERT_EQ(cuts.size(), 2u);
	EXPECT_EQ(maximum(cuts[0].mesh(0)), 1.0);
	EXPECT_EQ(maximum(cuts[1].mesh(0)), 11.0);
	EXPECT_EQ(*data->cut(View())->figures(0).mean, 1.0);
	EXPECT_EQ(maximum(cuts[1].mesh(0)), 11.0);
	std::filesystem::remove_all(folder);
}

} // namespace face
