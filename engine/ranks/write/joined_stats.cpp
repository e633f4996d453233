#include "ranks/write/joined_stats.h"

#include "base/bytes_read.h"
#include "ranks/data/share.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include <sys/resource.h>

namespace vp::ranks
{

namespace
{

using nlohmann::json;

// Counts of a sheet that each rank has of its own cells.
constexpr std::array<std::string_view, 12> kSummed = {
    "cut_cells",      "linear_cut_cells", "polygons",      "vertices",      "seeds",        "hops",
    "boundary_tests", "tree_tests",       "cells_touched", "cells_scanned", "cells_walked", "boundary_faces"};
constexpr std::array<std::string_view, 4> kSummedOfContour = {"cells", "polygons", "seeds", "cells_touched"};
constexpr std::array<std::string_view, 2> kGreatest = {"generations", "front_max"};
// Those of them that are told for each rank.
constexpr std::array<std::string_view, 8> kOfRank = {"cut_cells",  "seeds",         "hops",          "boundary_tests",
                                                     "tree_tests", "cells_touched", "cells_scanned", "generations"};

void addSheet(json& sheet, const json& other)
{
	for (const std::string_view key : kSummed)
		sheet[key] = sheet[key].get<std::size_t>() + other[key].get<std::size_t>();
	sheet["cells_twisted"] = sheet["cells_twisted"].get<std::size_t>() + other["cells_twisted"].get<std::size_t>();
	for (const std::string_view key : kGreatest)
		sheet[key] = std::max(sheet[key].get<std::size_t>(), other[key].get<std::size_t>());
	if (!sheet["crinkle"].is_null())
		for (const char* key : {"faces", "vertices"})
			sheet["crinkle"][key] = sheet["crinkle"][key].get<std::size_t>() + other["crinkle"][key].get<std::size_t>();
	sheet["hot_spot_inside"] = sheet["hot_spot_inside"].get<bool>() || other["hot_spot_inside"].get<bool>();
}

void addContour(json& contour, const json& other)
{
	for (const std::string_view key : kSummedOfContour)
		contour[key] = contour[key].get<std::size_t>() + other[key].get<std::size_t>();
	contour["generations"] =
	    std::max(contour["generations"].get<std::size_t>(), other["generations"].get<std::size_t>());
}

// Parts that ranks read in place: each has its own.
void addParts(json& parts, const json& other)
{
	if (parts.is_null())
		parts = other;
	else if (!other.is_null())
		for (const char* key : {"all", "met", "read", "kept", "bytes_met", "bytes_read"})
			parts[key] = parts[key].get<std::uint64_t>() + other[key].get<std::uint64_t>();
}

void addSheets(json& document, const json& other)
{
	if (document.contains("parts"))
		addParts(document["parts"], other["parts"]);
	for (std::size_t c = 0; document.contains("contours") && c < document["contours"].size(); ++c)
		addContour(document["contours"][c], other["contours"][c]);
	for (std::size_t s = 0; document.contains("sheets") && s < document["sheets"].size(); ++s)
		addSheet(document["sheets"][s], other["sheets"][s]);
}

json sheetsOfRank(const json& document)
{
	json sheets = json::array();
	for (const json& sheet : document.value("sheets", json::array()))
	{
		json& told = sheets.emplace_back();
		for (const std::string_view key : kOfRank)
			told[key] = sheet[key];
	}
	return sheets;
}

std::string textOf(const json& value)
{
	return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace

nlohmann::json resourcesOf(const Ranks& ranks, const grid::BlockSet& blocks)
{
	const Share& share = ranks.share();
	rusage used{};
	getrusage(RUSAGE_SELF, &used);
	rusage reader{};
	getrusage(RUSAGE_CHILDREN, &reader);
	const auto seconds = [](const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * time.tv_usec; };
	const auto cpu = [&](const rusage& of) { return seconds(of.ru_utime) + seconds(of.ru_stime); };
	const std::uint64_t bytes = share.bytes_read + (bytesRead() - share.counted_before); // by readers, and in place
	std::size_t cells = 0;
	for (std::uint32_t b = share.first_own; b < share.end_own; ++b)
		cells += cellsHere(blocks.blocks[b]);
	return {{"parts", share.own_parts},
	        {"cells", cells},
	        {"bytes_read", bytes},
	        {"layer_bytes", ranks.layerBytes()},
	        {"peak_mib", used.ru_maxrss / 1024},
	        {"cpu_s", cpu(used)},
	        {"reader_cpu_s", cpu(reader)}};
}

std::string tableOfAll(const Ranks& ranks, const std::string& title, const std::string& lines)
{
	if (!ranks.team())
		return title + lines;
	MessageWriter message;
	message.put(lines);
	const std::vector<Bytes> of_all = ranks.team()->gatherAll(message.take());
	if (!ranks.isFirst())
		return {};
	std::string table = " rank  " + title;
	for (std::size_t rank = 0; rank < of_all.size(); ++rank)
	{
		std::istringstream lines_of(MessageReader(of_all[rank]).getText());
		for (std::string line; std::getline(lines_of, line);)
			table += fmt::format("{:>5}  {}\n", rank, line);
	}
	return table;
}

nlohmann::json figuresOfAll(const Ranks& ranks, nlohmann::json own)
{
	if (!ranks.team())
		return own;
	MessageWriter message;
	message.put(textOf(own));
	const std::vector<Bytes> of_all = ranks.team()->gatherAll(message.take());
	for (std::size_t rank = 0; rank < of_all.size(); ++rank)
	{
		json of_rank = json::parse(MessageReader(of_all[rank]).getText());
		if (rank == 0)
			own = std::move(of_rank);
		else
			addSheets(own, of_rank);
	}
	return own;
}

nlohmann::json documentOfAll(const Ranks& ranks, const grid::BlockSet& blocks, nlohmann::json own)
{
	if (!ranks.team())
		return own;
	json rank = resourcesOf(ranks, blocks);
	rank["ms"] = own.value("ms", json());
	rank["sheets"] = sheetsOfRank(own);
	json mine = {{"document", own}, {"rank", std::move(rank)}};
	MessageWriter message;
	message.put(textOf(mine));
	json whole = std::move(own);
	json told = json::array();
	for (const Bytes& bytes : ranks.team()->gatherAll(message.take()))
	{
		json of_rank = json::parse(MessageReader(bytes).getText());
		if (told.empty())
			whole = of_rank["document"];
		else
			addSheets(whole, of_rank["document"]);
		told.push_back(std::move(of_rank["rank"]));
	}
	whole["ranks"] = std::move(told);
	return whole;
}

} // namespace vp::ranks
