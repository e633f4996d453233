// The share of a data set that each rank reads, and the figures that the ranks tell together.
#include "parted_lattice.h"
#include "ranks/data/warnings_of_all.h"
#include "ranks/picture/merged_layers.h"
#include "ranks/picture/surroundings.h"
#include "ranks/write/joined_stats.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace vp::test
{

namespace
{

std::size_t cellsOf(const grid::Block& block)
{
	return std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid);
}

nlohmann::json sheetWith(std::size_t count, std::size_t greatest, bool has_spot)
{
	nlohmann::json sheet;
	for (const char* key :
	     {"cut_cells", "linear_cut_cells", "polygons", "vertices", "seeds", "hops", "boundary_tests", "tree_tests",
	      "cells_touched", "cells_scanned", "cells_walked", "boundary_faces", "cells_twisted"})
		sheet[key] = count;
	sheet["generations"] = greatest;
	sheet["front_max"] = greatest;
	sheet["crinkle"] = {{"faces", count}, {"vertices", count}};
	sheet["hot_spot_inside"] = has_spot;
	return sheet;
}

nlohmann::json contourWith(std::size_t count, std::size_t greatest)
{
	return {
	    {"cells", count}, {"polygons", count}, {"seeds", count}, {"cells_touched", count}, {"generations", greatest}};
}

} // namespace

// Every block is at one rank, and all ranks know its name, its bounds and its arrays.
TEST(Shares, EachBlockIsAtOneRank)
{
	struct Inputs
	{
		std::vector<std::string> files;
		const char* kind;
	};
	const Inputs kinds[] = {{{"demo:shell:6", "demo:hexes:5", "demo:blob:4"}, "hybrid"},
	                        {{"demo:hexes:5", "demo:tets:3"}, "unstructured"},
	                        {{"demo:blob:5", "demo:shell:4"}, "block-structured"},
	                        {{"demo:blob:5"}, "image"}};
	for (const Inputs& inputs : kinds)
		for (const int size : {1, 2, 3})
		{
			ranks::Ranks alone = ranks::Ranks::alone();
			const grid::BlockSet whole = std::move(ranks::readInputs(alone, inputs.files, {}, nullptr).value());
			const ranks::Share::Counts expected = ranks::countsOf(alone, whole);
			EXPECT_EQ(expected.kind, inputs.kind);
			std::mutex mutex;
			std::vector<int> held(whole.blocks.size(), 0);
			ranks::withTeam(size,
			                [&](ranks::Team& team)
			                {
				                ranks::Ranks ranks(&team);
				                const grid::BlockSet own =
				                    std::move(ranks::readInputs(ranks, inputs.files, {}, nullptr).value());
				                const ranks::Share::Counts counts = ranks::countsOf(ranks, own);
				                EXPECT_EQ(counts.kind, expected.kind);
				                EXPECT_EQ(counts.cells, expected.cells);
				                EXPECT_EQ(counts.points, expected.points);
				                EXPECT_EQ(counts.linear_cells, expected.linear_cells);
				                EXPECT_EQ(counts.linear_points, expected.linear_points);
				                EXPECT_EQ(counts.blocks, expected.blocks);
				                ASSERT_EQ(own.blocks.size(), whole.blocks.size());
				                const std::lock_guard lock(mutex);
				                for (std::size_t b = 0; b < own.blocks.size(); ++b)
				                {
					                const bool is_here = ranks::isHere(ranks, b);
					                held[b] += is_here;
					                EXPECT_EQ(cellsOf(own.blocks[b]), is_here ? cellsOf(whole.blocks[b]) : 0u);
					                EXPECT_EQ(own.blocks[b].name, whole.blocks[b].name);
					                EXPECT_EQ(own.blocks[b].bounds.lo, whole.blocks[b].bounds.lo);
					                EXPECT_EQ(own.blocks[b].bounds.hi, whole.blocks[b].bounds.hi);
					                ASSERT_EQ(own.blocks[b].fields.size(), whole.blocks[b].fields.size());
					                for (std::size_t f = 0; f < own.blocks[b].fields.size(); ++f)
						                EXPECT_EQ(own.blocks[b].fields[f].name, whole.blocks[b].fields[f].name);
				                }
			                });
			EXPECT_EQ(held, std::vector<int>(whole.blocks.size(), 1)) << size;
		}
}

// If readers of several ranks say the same of one input, it is told once. Counts are added.
TEST(Shares, WarningsOfAllRanksAreToldOnce)
{
	ranks::withTeam(3,
	                [](ranks::Team& team)
	                {
		                const auto rank = static_cast<std::uint64_t>(team.rank());
		                std::vector<read::InputWarning> own{{"a.pvtu", {rank + 1, "cells are hidden"}}};
		                if (rank > 0)
			                own.push_back({"a.pvtu", {.words = "its times differ"}});
		                if (rank == 2)
			                own.push_back({"b.pvtu", {1, "cells are hidden", "cell is hidden"}});
		                std::vector<std::string> told;
		                for (const read::InputWarning& warning : ranks::warningsOfAll(team, own))
			                told.push_back(warning.input + ": " + warning.warning.text());
		                const std::vector<std::string> expected{"a.pvtu: 6 cells are hidden",
		                                                        "a.pvtu: its times differ", "b.pvtu: 1 cell is hidden"};
		                EXPECT_EQ(told, expected);
	                });
}

// Settings that ranks cannot carry out as one process does are refused by name. One process carries out all of them.
TEST(Shares, WhatRanksCannotCarryOutIsRefused)
{
	struct Refused
	{
		const char* key;
		std::function<void(view::ViewSpec&)> set;
	};
	const Refused refused[] = {{"`lines`", [](auto& spec) { spec.look.lines = 5; }},
	                           {"`color_by`", [](auto& spec) { spec.look.color_by = view::ColorBy::generation; }},
	                           {"`visited`", [](auto& spec) { spec.machine.visited = find::VisitedSet::stamps; }},
	                           {"`strategy`", [](auto& spec) { spec.machine.strategy = find::Strategy::generations; }},
	                           {"`classify`", [](auto& spec) { spec.machine.classify = view::Classify::gpu; }},
	                           {"`surface`", [](auto& spec) { spec.probe.surface = find::PatchName{"wall"}; }},
	                           {"`seeds`", [](auto& spec)
	                            {
		                            spec.probe.seeds = seed::SeedMode::boundary;
		                            spec.probe.window = probe::WindowSize{};
	                            }}};
	ranks::withTeam(1,
	                [&](ranks::Team& team)
	                {
		                const ranks::Ranks ranks(&team);
		                view::ViewSpec plain;
		                EXPECT_TRUE(ranks::canCarryOut(ranks, plain));
		                for (const Refused& r : refused)
		                {
			                view::ViewSpec spec;
			                r.set(spec);
			                const Status status = ranks::canCarryOut(ranks, spec);
			                ASSERT_FALSE(status) << r.key;
			                EXPECT_EQ(status.error().message.find(r.key), 0u) << status.error().message;
			                EXPECT_TRUE(ranks::canCarryOut(ranks::Ranks::alone(), spec));
		                }
		                plain.look.lines = 5;
		                plain.look.no_labels = true;
		                EXPECT_TRUE(ranks::canCarryOut(ranks, plain));
	                });
}

// Counts are summed, and of generations the greatest is told: in the document, and in a frame of a sweep.
TEST(RanksOfTeam, FiguresOfADocumentAreThoseOfAll)
{
	ranks::withTeam(3,
	                [](ranks::Team& team)
	                {
		                const ranks::Ranks ranks = ranksOf(team, false);
		                const auto rank = static_cast<std::size_t>(team.rank());
		                const nlohmann::json own{
		                    {"sheets", nlohmann::json::array({sheetWith(1 + rank, 7 - rank, rank == 1)})},
		                    {"contours", nlohmann::json::array({contourWith(10 + rank, 4 + rank)})}};
		                nlohmann::json document = own;
		                document["ms"] = 5;
		                const grid::BlockSet blocks =
		                    shareOf({partOf(Kind::lattice, straight, 0), partOf(Kind::lattice, straight, 1),
		                             partOf(Kind::lattice, straight, 2)},
		                            team.rank());
		                document = ranks::documentOfAll(ranks, blocks, document);
		                const nlohmann::json frame = ranks::figuresOfAll(ranks, own);
		                for (const nlohmann::json& told : {document, frame})
		                {
			                EXPECT_EQ(told["sheets"][0], sheetWith(6, 7, true));
			                EXPECT_EQ(told["contours"][0], contourWith(33, 6));
		                }
		                ASSERT_EQ(document["ranks"].size(), 3u);
		                EXPECT_EQ(document["ranks"][2]["sheets"][0]["cut_cells"], 3);
		                EXPECT_EQ(document["ranks"][2]["cells"], kSteps * kSteps * kSteps);
	                });
}

TEST(RanksOfTeam, BoundsAreThoseOfAll)
{
	ranks::withTeam(
	    3,
	    [](ranks::Team& team)
	    {
		    const ranks::Ranks ranks(&team);
		    const double rank = team.rank();
		    const auto bounds = ranks::boundsOfAll(ranks, mesh::UvBounds{{rank, -rank}, {rank + 1.0, 1.0 - rank}});
		    ASSERT_TRUE(bounds);
		    EXPECT_EQ(bounds->lo, glm::dvec2(0.0, -2.0));
		    EXPECT_EQ(bounds->hi, glm::dvec2(3.0, 1.0));
		    EXPECT_FALSE(ranks::boundsOfAll(ranks, std::nullopt));
	    });
}

// A camera that fits the data takes the same place, whoever holds them.
TEST(RanksOfTeam, TheExtentIsThatOfOneProcess)
{
	const auto reaches = [](const std::vector<Vec3>& points)
	{
		std::vector<double> farthest;
		for (const double x : {-1.0, 0.0, 1.0})
			for (const double y : {-1.0, 0.0, 1.0})
				for (const double z : {-1.0, 0.0, 1.0})
				{
					double most = -1e9;
					for (const Vec3& point : points)
						most = std::max(most, glm::dot(point, Vec3(x, y, z)));
					farthest.push_back(most);
				}
		return farthest;
	};
	const auto imageBlock = [](double x)
	{
		grid::Block block;
		block.name = "image";
		block.grid = grid::UniformGrid({3, 4, 5}, Vec3(x, 0.0, 0.0), Vec3(0.5, 0.3, 0.2));
		grid::finishBlock(block);
		return block;
	};
	const std::vector<grid::Block> cells{partOf(Kind::cells, warped, 0), partOf(Kind::cells, warped, 1)};
	const std::vector<grid::Block> images{imageBlock(0.0), imageBlock(1.0)};
	const std::vector<grid::Block> lattices{latticeBlock(warped, 0.0, false), latticeBlock(warped, 1.0, true)};
	for (const auto& blocks : {cells, images, lattices})
	{
		std::vector<double> expected;
		std::size_t lines = 0;
		withOneAndWithMany(
		    blocks,
		    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
		    {
			    const auto around = ranks::surroundingsOf(ranks, own, render::Outline::box).value();
			    expected = reaches(around.extent);
			    lines = around.outline.size();
		    },
		    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
		    {
			    const auto around = ranks::surroundingsOf(ranks, own, render::Outline::box).value();
			    EXPECT_EQ(reaches(around.extent), expected);
			    EXPECT_EQ(around.outline.size(), lines);
		    });
	}
	// Pieces of one image are in one box.
	withMany(images, true, 1,
	         [](ranks::Ranks& ranks, const grid::BlockSet& own)
	         { EXPECT_EQ(ranks::surroundingsOf(ranks, own, render::Outline::box).value().outline.size(), 12u); });
}

} // namespace vp::test
