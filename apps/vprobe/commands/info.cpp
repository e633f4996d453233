#include "base/digits.h"
#include "base/timeline.h"
#include "commands/commands.h"
#include "grid/check/quality.h"
#include "grid/demo/demo.h"
#include "grid/field_choice.h"
#include "options/spec_options.h"
#include "ranks/data/share.h"
#include "read/formats.h"
#include "read/read.h"
#include "read/sandbox.h"
#include "report/console.h"
#include "session/session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <variant>

namespace vp::app
{

namespace
{

struct InfoOptions
{
	SpecOptions input;
	bool json = false;
	bool formats = false;
};

// An array of the data set, with its range over all blocks.
struct ArrayInfo
{
	const grid::Field* field;
	grid::ValueSpan range; // empty if no value is finite
	bool is_known = true;  // the range; not that of an array that stays in its file
};

std::vector<ArrayInfo> listArrays(const grid::BlockSet& blocks)
{
	std::vector<ArrayInfo> arrays;
	for (const grid::Block& block : blocks.blocks)
		for (const grid::Field& field : block.fields)
		{
			const bool known =
			    std::any_of(arrays.begin(), arrays.end(),
			                [&](const ArrayInfo& a)
			                { return a.field->name == field.name && a.field->association == field.association; });
			if (known)
				continue;
			const int component = field.components == 1 ? 0 : grid::kMagnitude;
			ArrayInfo info = {&field, {}};
			for (const grid::Block& each : blocks.blocks)
				if (const grid::Field* same = grid::FieldChoice{field.name, field.association, component}.in(each))
				{
					info.is_known = info.is_known && !same->stored;
					if (info.is_known)
						info.range.include(grid::valueSpan(*same, component));
				}
			arrays.push_back(info);
		}
	return arrays;
}

// Returns the units of all blocks. Empty if they differ, or if the files name none.
std::string lengthUnits(const grid::BlockSet& blocks)
{
	const auto is_same = [&](const grid::Block& block)
	{ return block.length_units == blocks.blocks.front().length_units; };
	return !blocks.blocks.empty() && std::ranges::all_of(blocks.blocks, is_same) ? blocks.blocks.front().length_units
	                                                                             : std::string();
}

// The points of a structured block, and the distance of those of an image.
struct LatticeFacts
{
	std::array<std::uint32_t, 3> points{};
	std::optional<Vec3> spacing;
};

std::optional<LatticeFacts> latticeOf(const grid::Block& block)
{
	const auto facts = [](const auto& grid) -> std::optional<LatticeFacts>
	{
		if constexpr (std::is_base_of_v<grid::Lattice, std::decay_t<decltype(grid)>>)
			return LatticeFacts{grid.points(), std::nullopt};
		return std::nullopt;
	};
	std::optional<LatticeFacts> found = std::visit(facts, block.grid);
	if (const auto* image = std::get_if<grid::UniformGrid>(&block.grid))
		found->spacing = image->pointAt(1, 1, 1) - image->pointAt(0, 0, 0);
	return found;
}

// Null for an array in memory.
nlohmann::json partsJson(const grid::Field& field)
{
	if (!field.stored)
		return {};
	return {{"all", field.stored->layout().partCount()}, {"shape", field.stored->layout().part}};
}

nlohmann::json infoJson(const grid::BlockSet& blocks, int level)
{
	nlohmann::json arrays = nlohmann::json::array();
	for (const auto& [field, range, is_known] : listArrays(blocks))
		arrays.push_back({{"name", field->name},
		                  {"association", grid::associationName(field->association)},
		                  {"components", field->components},
		                  {"type", grid::numberTypeName(field->type)},
		                  {"range", !is_known       ? nlohmann::json()
		                            : range.empty() ? nlohmann::json{nullptr, nullptr}
		                                            : nlohmann::json{range.lo, range.hi}},
		                  {"parts", partsJson(*field)}});
	nlohmann::json block_list = nlohmann::json::array();
	for (const grid::Block& block : blocks.blocks)
	{
		auto [cells, points] = std::visit(
		    [](const auto& grid) { return std::pair<std::size_t, std::size_t>(grid.cellCount(), grid.pointCount()); },
		    block.grid);
		if (block.whole)
			std::tie(cells, points) = std::tie(block.whole->cells, block.whole->points);
		nlohmann::json& each =
		    block_list.emplace_back(nlohmann::json{{"name", block.name}, {"cells", cells}, {"points", points}});
		each["parts"] = block.whole ? nlohmann::json(block.whole->parts.all) : nlohmann::json();
		if (const auto lattice = latticeOf(block))
		{
			each["lattice"] = lattice->points;
			if (const auto& spacing = lattice->spacing)
				each["spacing"] = {spacing->x, spacing->y, spacing->z};
		}
	}
	nlohmann::json patches = nlohmann::json::array();
	for (const grid::Patch& patch : blocks.patches)
		patches.push_back({{"name", patch.name}, {"faces", patch.faces.size()}});
	nlohmann::json interfaces = nlohmann::json::array();
	for (const grid::Interface& interface : blocks.interfaces.interfaces)
		interfaces.push_back({{"blocks", {interface.a, interface.b}}, {"faces", interface.faces}});
	nlohmann::json overlaps = nlohmann::json::array();
	const grid::BlockOverlaps found = grid::findBlockOverlaps(blocks);
	for (const grid::BlockOverlap& overlap : found.pairs)
		overlaps.push_back(
		    {{"blocks", {overlap.a, overlap.b}}, {"cells", overlap.cells}, {"samples", overlap.samples}});
	const Box bounds = blocks.bounds();
	nlohmann::json units = nullptr;
	if (const std::string known = lengthUnits(blocks); !known.empty())
		units = known;
	const ranks::Share::Counts counts = ranks::countsOf(ranks::Ranks::alone(), blocks);
	return {{"grid",
	         {{"kind", counts.kind},
	          {"cells", counts.cells},
	          {"points", counts.points},
	          {"linear_cells", counts.linear_cells},
	          {"linear_points", counts.linear_points},
	          {"blocks", blocks.blocks.size()},
	          {"cells_left_out", blocks.left_out},
	          {"cells_without_place", blocks.unplaced}}},
	        {"blocks", block_list},
	        {"interfaces", interfaces},
	        {"sandbox", read::sandboxText()},
	        {"overlaps", overlaps},
	        {"patches", patches},
	        {"orientation", blocks.imaging().orientation},
	        {"overlap_pairs", {{"near", found.near}, {"looked_at", found.looked_at}}},
	        {"seam_faces", blocks.interfaces.seam_faces},
	        {"boundary_faces",
	         grid::lacksParts(blocks) ? nlohmann::json() : nlohmann::json(blocks.interfaces.boundary_faces)},
	        {"bounds", {bounds.lo.x, bounds.hi.x, bounds.lo.y, bounds.hi.y, bounds.lo.z, bounds.hi.z}},
	        {"length_units", units},
	        {"times", blocks.times},
	        {"levels", blocks.levels},
	        {"level", level},
	        {"time_units", blocks.time_units.empty() ? nlohmann::json() : nlohmann::json(blocks.time_units)},
	        {"arrays", arrays}};
}

// Returns both ends, with as many digits as the width of the range needs.
std::string rangeWords(double lo, double hi, int most = 15)
{
	const int digits = digitsForRange(lo, hi, most);
	return fmt::format("{:.{}g} to {:.{}g}", lo, digits, hi, digits);
}

// Returns the number of digits to print. More digits than single precision holds would be made up.
int digitsOf(grid::NumberType type)
{
	return type == grid::NumberType::float32 ? 7 : 15;
}

// Returns all times, or, if there are many, enough of them to show how they continue.
std::string timesAsWords(const std::vector<double>& times)
{
	constexpr std::size_t most = 30;
	double largest = 0.0, gap = std::numeric_limits<double>::infinity();
	for (std::size_t t = 0; t < times.size(); ++t)
	{
		largest = std::max(largest, std::abs(times[t]));
		if (t > 0 && times[t] > times[t - 1])
			gap = std::min(gap, times[t] - times[t - 1]);
	}
	const int digits = digitsFor(largest, gap);
	std::string words;
	for (std::size_t t = 0; t < times.size(); ++t)
		if (times.size() <= most || t < 3 || t + 1 == times.size())
			words +=
			    fmt::format("{}{}{:.{}g}", t ? " " : "", t > 3 && times.size() > most ? "... " : "", times[t], digits);
	return words;
}

// If there are many blocks, or pairs of blocks, the first ones are enough.
constexpr std::size_t kMaxPrinted = 12;

void printMore(std::size_t all)
{
	if (all > kMaxPrinted)
		print("        and {} more; --json lists all\n", all - kMaxPrinted);
}

// "11 x 11 x 5 points, 0.5 x 0.5 x 2 apart" of a structured block.
std::string latticeWords(const grid::Block& block)
{
	const auto lattice = latticeOf(block);
	if (!lattice)
		return {};
	const std::string counts = fmt::format("{} points", fmt::join(lattice->points, " x "));
	if (!lattice->spacing)
		return counts;
	const Vec3& apart = *lattice->spacing;
	return fmt::format("{}, {:.7g} x {:.7g} x {:.7g} apart", counts, apart.x, apart.y, apart.z);
}

void printBlocks(const grid::BlockSet& blocks)
{
	if (blocks.blocks.size() == 1)
	{
		if (const std::string lattice = latticeWords(blocks.blocks[0]); !lattice.empty())
			print("        {}\n", lattice);
		if (const auto& whole = blocks.blocks[0].whole)
			print("        in {} parts, of which cuts read those that they meet\n", whole->parts.all);
		return;
	}
	for (std::size_t b = 0; b < std::min(kMaxPrinted, blocks.blocks.size()); ++b)
	{
		const std::string lattice = latticeWords(blocks.blocks[b]);
		print("block   {}: {}, {} cells{}{}\n", b, blocks.blocks[b].name,
		      std::visit([](const auto& grid) { return grid.cellCount(); }, blocks.blocks[b].grid),
		      lattice.empty() ? "" : ", ", lattice);
	}
	printMore(blocks.blocks.size());
}

void printPatches(const grid::BlockSet& blocks)
{
	for (std::size_t p = 0; p < std::min(kMaxPrinted, blocks.patches.size()); ++p)
		print("patch   {}: {} faces\n", blocks.patches[p].name, blocks.patches[p].faces.size());
	printMore(blocks.patches.size());
}

void printMeetings(const grid::BlockSet& blocks)
{
	const grid::Interfaces& seams = blocks.interfaces;
	if (seams.seam_faces)
		print("seams   {} boundary faces lie on another, in {} interface{}; {} bound the domain\n", seams.seam_faces,
		      seams.interfaces.size(), seams.interfaces.size() == 1 ? "" : "s", seams.boundary_faces);
	for (std::size_t i = 0; i < std::min(kMaxPrinted, seams.interfaces.size()); ++i)
	{
		const grid::Interface& interface = seams.interfaces[i];
		const std::string meets = interface.a == interface.b ? "itself" : fmt::format("block {}", interface.b);
		print("        block {} meets {} in {} faces\n", interface.a, meets, interface.faces);
	}
	printMore(seams.interfaces.size());
	const auto& [overlaps, near, looked_at] = grid::findBlockOverlaps(blocks);
	if (looked_at < near)
		print("overlap {} of {} pairs of blocks near each other were looked at\n", looked_at, near);
	for (std::size_t i = 0; i < std::min(kMaxPrinted, overlaps.size()); ++i)
		print("overlap blocks {} and {} have room in common: {} of {} cells looked at\n", overlaps[i].a, overlaps[i].b,
		      overlaps[i].cells, overlaps[i].samples);
	printMore(overlaps.size());
}

void printInfo(const grid::BlockSet& blocks, int level)
{
	const Box bounds = blocks.bounds();
	const ranks::Share::Counts counts = ranks::countsOf(ranks::Ranks::alone(), blocks);
	print("grid    {}, {} cells, {} points, {} block{}\n", counts.kind, counts.cells, counts.points, counts.blocks,
	      counts.blocks == 1 ? "" : "s");
	if (counts.linear_cells != counts.cells)
		print("        cut into {} linear cells with {} points\n", counts.linear_cells, counts.linear_points);
	if (blocks.left_out)
		print("        {} cells of fewer than three dimensions are left out\n", blocks.left_out);
	if (blocks.unplaced)
		print("        {} cells with a point without a place are left out\n", blocks.unplaced);
	printBlocks(blocks);
	if (!grid::lacksParts(blocks))
		printMeetings(blocks);
	printPatches(blocks);
	const std::string units = lengthUnits(blocks);
	print("bounds  x {}, y {}, z {}{}{}\n", rangeWords(bounds.lo.x, bounds.hi.x), rangeWords(bounds.lo.y, bounds.hi.y),
	      rangeWords(bounds.lo.z, bounds.hi.z), units.empty() ? "" : " ", units);
	if (!blocks.times.empty())
		print("times   {}: {}{}{}\n", blocks.times.size(), timesAsWords(blocks.times),
		      blocks.time_units.empty() ? "" : " ", blocks.time_units);
	if (blocks.levels > 1)
		print("levels  {}, of which {} is shown; 0 is the finest\n", blocks.levels, level);
	const auto arrays = listArrays(blocks);
	if (arrays.empty())
		print("arrays  none\n");
	for (const auto& [field, range, is_known] : arrays)
		print("array   {}:{}  {} x {}, {}{}\n", grid::associationName(field->association), field->name,
		      field->components, grid::numberTypeName(field->type), field->components == 1 ? "" : "magnitude ",
		      !is_known       ? fmt::format("stays in the file in {} parts of {}", field->stored->layout().partCount(),
		                                    fmt::join(field->stored->layout().part, " x "))
		      : range.empty() ? "no finite value"
		                      : rangeWords(range.lo, range.hi, digitsOf(field->type)));
}

void listFormats(bool as_json)
{
	nlohmann::json list = nlohmann::json::array();
	for (const read::Format& format : read::formats())
		if (as_json)
			list.push_back({{"name", format.name},
			                {"endings", format.endings},
			                {"what", format.what},
			                {"read", format.read},
			                {"by", format.by}});
		else
			print("{:<13} {}\n{:13} {}\n{:13} read: {}; by {}\n", format.name,
			      format.endings.empty() ? "any ending" : format.endings, "", format.what, "", format.read, format.by);
	if (as_json)
		print("{}\n", list.dump(1, '\t'));
}

Result<ExitCode> runInfo(const InfoOptions& options)
{
	if (options.formats)
	{
		listFormats(options.json);
		return ExitCode::done;
	}
	if (Status ready = prepare(options.input); !ready)
		return ready.error();
	const view::InputSpec& input = options.input.spec.input;
	if (input.files.size() == 1 && input.files.front() == "demo:")
	{
		for (const grid::Demo& demo : grid::demos())
			print("demo:{:<8} {}\n", demo.name, demo.about);
		return ExitCode::done;
	}
	Result<grid::BlockSet> blocks = session::readFacts(options.input.spec);
	if (!blocks)
		return blocks.error();
	if (options.json)
		print("{}\n", infoJson(*blocks, input.level).dump(1, '\t', false, nlohmann::json::error_handler_t::replace));
	else
		printInfo(*blocks, input.level);
	return ExitCode::done;
}

} // namespace

void addInfo(CLI::App& program, Run& run)
{
	auto options = std::make_shared<InfoOptions>();
	CLI::App* command = program.add_subcommand("info", "Tell what an input holds: grid, bounds, times, arrays");
	addInputs(*command, options->input)->required(false);
	addMemory(*command, options->input);
	command->add_flag("--formats", options->formats, "List the formats that can be read, and what is read of each");
	command->add_flag("--json", options->json, "Write JSON for scripts");
	command->callback([&run, options] { run = [options] { return runInfo(*options); }; });
}

} // namespace vp::app
