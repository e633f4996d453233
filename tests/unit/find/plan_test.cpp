#include "cut/cutter.h"
#include "find/plan.h"
#include "grid/demo/demo.h"
#include "mesh/listed_mesh.h"
#include "surface/implicit_surface.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>

namespace vp::test
{

namespace
{

using Row = std::vector<std::string>; // the cells of a line of a table in Markdown

/// The rows below the headings of docs/CUTTING.md that begin with `| options |`.
std::vector<Row> tableRows()
{
	std::ifstream file(VPROBE_SOURCE_DIR "/docs/CUTTING.md");
	std::vector<Row> rows;
	bool inside = false;
	for (std::string line; std::getline(file, line);)
	{
		if (!line.starts_with("|"))
			inside = false;
		if (inside && !line.starts_with("| ---"))
		{
			Row row;
			std::istringstream cells(line.substr(1));
			for (std::string cell; std::getline(cells, cell, '|');)
				if (const auto begin = cell.find_first_not_of(' '); begin != std::string::npos)
					row.push_back(cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin));
			rows.push_back(row);
		}
		inside = inside || line.starts_with("| options |");
	}
	return rows;
}

/// The settings from the options of a row, and whether a device classifies.
struct Case
{
	cut::CutRequest request;
	bool on_device = false;
};

void setSurface(const std::string& text, cut::CutRequest& request)
{
	if (text.starts_with("patch="))
		request.surface = find::PatchName{text.substr(6)};
	else if (const auto index = surface::parseGridIndex(text))
		request.surface = index->at(0.0);
	else
		request.probe.sheets[0].form = surface::ImplicitSurface::parse(text).value();
}

Case caseOf(const std::string& options, const grid::BlockSet& blocks)
{
	Case made;
	cut::CutRequest& request = made.request;
	request.probe.sheets = {probe::makeSheet(blocks.bounds().center(), {0.0, 0.0, 1.0})};
	request.field = grid::chooseField(blocks, "").value();
	std::string words = options;
	std::erase(words, '`');
	std::istringstream stream(words);
	for (std::string option, value; stream >> option;)
	{
		if (option == "none")
			continue;
		stream >> value;
		if (option == "--window")
			request.probe.sheets[0].window = probe::centeredWindow(1.0, 1.0);
		else if (option == "--threshold")
			request.threshold = find::Threshold{0.0, 1.0};
		else if (option == "--seeds")
			request.seeds.mode = value == "hotspot" ? seed::SeedMode::hotspot : seed::SeedMode::boundary;
		else if (option == "--outside")
			request.seeds.outside = seed::OutsidePolicy::report;
		else if (option == "--visited")
			request.in_generations = true;
		else if (option == "--surface")
			setSurface(value, request);
		else if (option == "--strategy")
			request.strategy = find::strategyNamed(value).value();
		else if (option == "--classify" && value != "cpu")
		{
			made.on_device = true;
			if (value == "gpu")
				request.device_first = true;
		}
		else
			EXPECT_EQ(option, "--classify") << "of " << options;
		if (option == "--window" || option == "--threshold" || value == "auto,")
			std::getline(stream >> std::ws, value, value == "auto," ? '\n' : ' '); // the second number, or a remark
	}
	return made;
}

Result<find::CutPlan> planOf(const cut::CutRequest& request, const grid::BlockSet& blocks,
                             const find::DeviceProfile* device)
{
	return find::planCut(request.forPlan(), blocks, device);
}

std::string told(const Case& asked, const grid::BlockSet& blocks, bool with_classifier)
{
	// As the command line does before it asks for a plan.
	if (asked.request.surface)
		if (const auto* index = std::get_if<surface::GridIndex>(&*asked.request.surface))
			if (!find::checkGridIndex(blocks, {.axis = index->axis, .first = index->index, .last = index->index}))
				return "refused";
	const find::DeviceProfile device{std::vector<bool>(blocks.blocks.size(), true)};
	const auto plan = planOf(asked.request, blocks, asked.on_device ? &device : nullptr);
	if (!plan)
		return "refused";
	EXPECT_EQ(plan->sheets.size(), 1u);
	const find::BlockPlan& way = plan->sheets.at(0).at(0);
	EXPECT_NE(way.reason(), "");
	const std::string strategy = nameOf(way.strategy);
	return with_classifier ? strategy + " on " + nameOf(way.classifier) : strategy;
}

grid::BlockSet demo(const char* name, bool builds_neighbors = true)
{
	return std::move(grid::makeDemo(name, 6, builds_neighbors).value());
}

} // namespace

TEST(CutPlan, IsTheTableOfTheDocument)
{
	constexpr std::array kDemos{"blob", "graded", "shell", "tets", "tets"}; // a column each
	const std::vector<Row> rows = tableRows();
	ASSERT_GT(rows.size(), 20u);
	for (std::size_t column = 0; column < kDemos.size(); ++column)
	{
		const bool builds_neighbors = column < 4;
		const grid::BlockSet blocks = demo(kDemos[column], builds_neighbors);
		for (const Row& row : rows)
		{
			ASSERT_EQ(row.size(), 1 + kDemos.size()) << row.front();
			const std::string& expected = row[1 + column];
			const bool with_classifier = row[1].find(" on ") != std::string::npos ||
			                             expected.find(" on ") != std::string::npos ||
			                             row.front().find("--classify") != std::string::npos;
			EXPECT_EQ(told(caseOf(row.front(), blocks), blocks, with_classifier), expected)
			    << kDemos[column] << ' ' << row.front();
		}
	}
}

TEST(CutPlan, NamesTheBlockThatCannotBeCutAsAsked)
{
	const grid::BlockSet blocks = demo("shell");
	Case asked = caseOf("none", blocks);
	asked.request.strategy = find::Strategy::rows;
	const auto plan = planOf(asked.request, blocks, nullptr);
	ASSERT_FALSE(plan);
	EXPECT_EQ(plan.error().kind, ErrorKind::usage);
	EXPECT_EQ(plan.error().message, "rows: not for sheet 0 in block " + blocks.blocks[0].name +
	                                    ": the block has no straight axes; leave it out, or take spans");
}

TEST(CutPlan, LeavesBlocksThatADeviceDoesNotHoldToTheCpu)
{
	const grid::BlockSet blocks = demo("blob");
	const find::DeviceProfile device{std::vector<bool>(blocks.blocks.size(), false)};
	const auto plan = planOf(caseOf("none", blocks).request, blocks, &device);
	ASSERT_TRUE(plan);
	EXPECT_EQ(plan->sheets[0][0].classifier, find::Processor::cpu);
	EXPECT_NE(plan->sheets[0][0].reason().find("limit of the device"), std::string::npos);
}

TEST(CutPlan, HasAWayForEverySheetInEveryBlock)
{
	grid::BlockSet blocks = demo("blob");
	blocks.blocks.push_back(demo("tets").blocks[0]);
	blocks.interfaces = {};
	Case asked = caseOf("none", blocks);
	asked.request.probe.sheets.push_back(asked.request.probe.sheets[0]);
	asked.request.probe.sheets[1].form = surface::ImplicitSurface::parse("sphere:1").value();
	const auto plan = planOf(asked.request, blocks, nullptr);
	ASSERT_TRUE(plan);
	std::string ways;
	for (const auto& sheet : plan->sheets)
		for (const find::BlockPlan& way : sheet)
			ways += std::string(nameOf(way.strategy)) + ' ';
	EXPECT_EQ(ways, "rows cells generations generations ");
}

TEST(CutPlan, IsWhatACutterFollows)
{
	for (const char* name : {"blob", "graded", "shell", "tets"})
	{
		const grid::BlockSet blocks = demo(name);
		cut::Cutter cutter(blocks);
		Case asked = caseOf("none", blocks);
		const cut::SheetCut fastest = std::move(cutter.cut(asked.request).value().sheets[0]);
		const find::Strategy planned = cutter.plan(asked.request)->sheets[0][0].strategy;
		EXPECT_EQ(fastest.cuts[0].hasSpans(), planned == find::Strategy::rows || planned == find::Strategy::spans)
		    << name;
		EXPECT_EQ(fastest.cuts[0].steps(), 0u) << name;
		asked.request.strategy = find::Strategy::generations;
		const cut::SheetCut by_generations = std::move(cutter.cut(asked.request).value().sheets[0]);
		EXPECT_GT(by_generations.cuts[0].steps(), 0u) << name;
		EXPECT_EQ(by_generations.cuts[0].cutCells(), fastest.cuts[0].cutCells()) << name;
		asked.request.strategy = find::Strategy::listed;
		EXPECT_FALSE(cutter.cut(asked.request)) << name;
	}
}

} // namespace vp::test
