#include "read/read.h"

#include "base/messages.h"
#include "base/timeline.h"
#include "grid/curved/cells_to_points.h"
#include "grid/demo/demo.h"
#include "read/build_block.h"
#include "read/geometry.h"
#include "read/read_ahead.h"
#include "read/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace vp::read
{

namespace
{

struct PartsRead
{
	std::vector<std::size_t> of_block; // the number of the part that each block is of
	std::vector<InputWarning> warnings;
	std::uint64_t bytes_read = 0;
};

// parts: or null.
Result<grid::BlockSet> readFile(ReadAhead& inputs, Timeline* timeline, PartsRead* parts)
{
	const ReadOptions options = inputs.next().options;
	const std::string name_of_file = fileOf(inputs.next().input, options);
	Result<CheckedInput> input = inputs.read(timeline);
	if (!input)
		return input.error();
	for (ReadWarning& warning : input->warnings)
	{
		InputWarning found{name_of_file, std::move(warning)};
		if (parts)
			parts->warnings.push_back(std::move(found));
		else
			tell(found);
	}

	TimedSection timed(timeline, "build");
	const std::string stem = std::filesystem::path(name_of_file).stem().string();
	grid::BlockSet set;
	set.times = std::move(input->times);
	set.time_units = std::move(input->time_units);
	set.levels = input->levels;
	set.left_out = input->left_out;
	set.unplaced = input->unplaced;
	if (parts)
		parts->bytes_read = input->bytes_read;
	for (CheckedBlock& block : input->blocks)
	{
		if (parts)
			parts->of_block.push_back(block.part);
		std::string name = block.name.empty() ? stem : fmt::format("{}: {}", stem, block.name);
		set.blocks.push_back(buildBlock(std::move(block), std::move(name), options.identifies_geometry,
		                                options.for_one_cut, options.refine));
	}
	if (!input->patches.empty())
	{
		buildNeighbors(set, timeline, options.for_one_cut);
		set.patches = grid::findPatches(set, input->patches);
	}
	return set;
}

// Reads the next of the inputs.
Result<grid::BlockSet> readInput(ReadAhead& inputs, Timeline* timeline, PartsRead* parts = nullptr)
{
	const std::string input = inputs.next().input;
	if (!input.starts_with(kDemoPrefix))
		return readFile(inputs, timeline, parts);
	if (inputs.next().options.displace != 0.0)
		return Error{ErrorKind::usage, fmt::format("`displace`: {} is built in and has no displacements; leave the "
		                                           "setting out, or name a file",
		                                           input)};
	if (inputs.next().options.level != 0)
		return Error{ErrorKind::usage,
		             fmt::format("`level`: {} is built in and has one level; leave the setting out", input)};
	inputs.skip();
	TimedSection timed(timeline, "build");
	return grid::parseDemo(std::string_view(input).substr(kDemoPrefix.size()), false);
}

} // namespace

void buildNeighbors(grid::BlockSet& set, Timeline* timeline, bool for_one_cut)
{
	const TimedSection timed(timeline, "adjacency");
	grid::buildNeighbors(set, for_one_cut);
}

std::size_t timeIndex(const std::vector<double>& times, const TimeChoice& choice)
{
	if (times.empty() || choice.kind == TimeChoice::Kind::first)
		return 0;
	if (choice.kind == TimeChoice::Kind::last)
		return times.size() - 1;
	if (choice.kind == TimeChoice::Kind::index)
		return std::min(choice.index, times.size() - 1);
	const auto nearer = [&](double a, double b) { return std::abs(a - choice.value) < std::abs(b - choice.value); };
	return static_cast<std::size_t>(std::min_element(times.begin(), times.end(), nearer) - times.begin());
}

Result<TimeChoice> parseTime(const std::string& text)
{
	if (text == "last")
		return TimeChoice{TimeChoice::Kind::last, 0.0};
	if (text == "first")
		return TimeChoice{TimeChoice::Kind::first, 0.0};
	TimeChoice choice{TimeChoice::Kind::value, 0.0};
	const char* stop = text.data() + text.size();
	const bool is_index = text.starts_with('#');
	if (is_index)
		choice.kind = TimeChoice::Kind::index;
	const auto [end, error] = is_index ? std::from_chars(text.data() + 1, stop, choice.index)
	                                   : std::from_chars(text.data(), stop, choice.value);
	if (error != std::errc() || end != stop || !std::isfinite(choice.value))
		return Error{ErrorKind::usage, "neither last, first, a number nor #INDEX"};
	return choice;
}

std::string timeText(const TimeChoice& time)
{
	switch (time.kind)
	{
	case TimeChoice::Kind::first:
		return "first";
	case TimeChoice::Kind::value:
		return fmt::format("{}", time.value);
	case TimeChoice::Kind::index:
		return fmt::format("#{}", time.index);
	default:
		return "last";
	}
}

namespace
{

// Equal times of one input stay apart; those of several inputs are the same times. Inputs without times have no say in
// the units.
void addTimes(std::vector<double> more, std::string units, std::vector<double>& all, std::string& all_units)
{
	if (!more.empty())
		all_units = all.empty() || all_units == units ? std::move(units) : std::string();
	std::sort(more.begin(), more.end());
	std::vector<double> both;
	std::ranges::set_union(all, more, std::back_inserter(both));
	all = std::move(both);
}

void addSet(grid::BlockSet set, grid::BlockSet& all)
{
	for (grid::Patch& patch : set.patches)
		for (grid::Patch::Face& face : patch.faces)
			face.block += static_cast<std::uint32_t>(all.blocks.size());
	std::move(set.patches.begin(), set.patches.end(), std::back_inserter(all.patches));
	std::move(set.blocks.begin(), set.blocks.end(), std::back_inserter(all.blocks));
	addTimes(std::move(set.times), std::move(set.time_units), all.times, all.time_units);
	all.levels = std::max(all.levels, set.levels);
	all.left_out += set.left_out;
	all.unplaced += set.unplaced;
}

// Adds what a set of several inputs still lacks: neighbors and seams, if they are wanted.
void completeSet(grid::BlockSet& all, const ReadOptions& options, Timeline* timeline)
{
	if (grid::lacksParts(all))
		return;
	const bool all_listed =
	    std::ranges::none_of(all.blocks, [](const grid::Block& block) { return grid::hasNeighbors(block); });
	const bool refines = std::ranges::any_of(all.blocks, [](const grid::Block& b) { return b.curved != nullptr; });
	if (all_listed && (refines || !options.builds_neighbors))
		return;
	if (!grid::hasNeighbors(all))
		buildNeighbors(all, timeline, options.for_one_cut);
	else if (options.for_one_cut)
		all.matches_seams = false;
	else
	{
		TimedSection timed(timeline, "build");
		grid::matchInterfaces(all);
	}
}

Status moveToPoints(const std::vector<std::string>& inputs, const ReadOptions& options, grid::BlockSet& all,
                    Timeline* timeline)
try
{
	if (!options.cell_to_point)
		return Nothing{};
	TimedSection timed(timeline, "build");
	for (grid::Block& block : all.blocks)
		grid::replaceFields(block, grid::fieldsAtPoints(block, std::move(block.fields)));
	return Nothing{};
}
catch (const grid::WrongPoint& wrong)
{
	return Error{ErrorKind::input, fmt::format("{}: {}", fmt::join(inputs, ", "), wrong.what())};
}

} // namespace

Result<grid::BlockSet> readInputs(const std::vector<std::string>& inputs, const ReadOptions& options,
                                  Timeline* timeline)
{
	grid::BlockSet all;
	std::vector<std::string> empty; // partitions, mostly
	ReadAhead ahead(inputs, options);
	for (std::size_t number = 0; number < inputs.size(); ++number)
	{
		const std::string& input = inputs[number];
		Result<grid::BlockSet> set = readInput(ahead, timeline);
		if (!set)
			return set.error();
		for (grid::Block& block : set->blocks)
			block.input = static_cast<std::uint32_t>(number);
		if (options.stop.stop_requested())
			return stopped(fileOf(input, options));
		if (set->blocks.empty())
			empty.push_back(fileOf(input, options));
		addSet(std::move(*set), all);
	}
	if (all.blocks.empty() && !empty.empty())
		return Error{ErrorKind::input,
		             fmt::format("{}: nothing to slice: it holds no three-dimensional cells", empty[0])};
	for (const std::string& input : empty)
		warn("{}: it holds no cells and is left out", input);
	completeSet(all, options, timeline);
	if (Status moved = moveToPoints(inputs, options, all, timeline); !moved)
		return moved.error();
	return all;
}

Result<PartList> listParts(const std::vector<std::string>& inputs, const ReadOptions& options, Timeline* timeline)
{
	PartList list;
	ReadOptions listing = options;
	listing.parts = fmt::format("?/{}", options.slabs);
	ReadAhead ahead(inputs, listing);
	for (std::size_t i = 0; i < inputs.size(); ++i)
	{
		if (inputs[i].starts_with(kDemoPrefix))
		{
			const Result<grid::BlockSet> set = readInput(ahead, timeline);
			if (!set)
				return set.error();
			list.parts.push_back({i, 0, set->cellCount(), list.blocks.size()});
			list.blocks.emplace_back();
			continue;
		}
		const Result<CheckedInput> input = ahead.read(timeline);
		if (!input)
			return input.error();
		list.bytes_read += input->bytes_read;
		for (std::size_t p = 0; p < input->parts.size(); ++p)
			list.parts.push_back({i, p, input->parts[p].cells, list.blocks.size() + input->parts[p].block});
		for (const WholeLattice& whole : input->wholes)
			list.blocks.push_back({whole.kind, whole.points});
		addTimes(input->times, input->time_units, list.times, list.time_units);
	}
	return list;
}

void tell(const InputWarning& warning)
{
	warn("{}: {}", warning.input, warning.warning.text());
}

Result<PartBlocks> readParts(const std::vector<std::string>& inputs, const std::vector<Part>& parts,
                             const ReadOptions& options, Timeline* timeline)
{
	PartBlocks read;
	std::vector<InputToRead> wanted;
	std::vector<std::vector<Part>> of_wanted;
	for (std::size_t i = 0; i < inputs.size(); ++i)
	{
		std::vector<std::size_t> numbers;
		std::vector<Part> of_input;
		for (const Part& part : parts)
			if (part.input == i)
			{
				numbers.push_back(part.number);
				of_input.push_back(part);
			}
		if (numbers.empty())
			continue;
		wanted.push_back({inputs[i], options});
		wanted.back().options.parts = fmt::format("{}/{}", fmt::join(numbers, ","), options.slabs);
		of_wanted.push_back(std::move(of_input));
	}
	ReadAhead ahead(std::move(wanted));
	for (const std::vector<Part>& of_input : of_wanted)
	{
		PartsRead found;
		Result<grid::BlockSet> set = readInput(ahead, timeline, &found);
		if (!set)
			return set.error();
		read.bytes_read += found.bytes_read;
		std::ranges::move(found.warnings, std::back_inserter(read.warnings));
		found.of_block.resize(set->blocks.size(), 0); // those of a built-in data set
		for (const std::size_t number : found.of_block)
			read.of_block.push_back(*std::ranges::find(of_input, number, &Part::number));
		addSet(std::move(*set), read.set);
	}
	completeSet(read.set, options, timeline);
	return read;
}

namespace
{

Result<std::optional<BlockFields>> fieldsOf(ReadAhead& ahead, std::size_t inputs, const grid::BlockSet& set,
                                            Timeline* timeline)
{
	const std::optional<BlockFields> none;
	BlockFields fields;
	const bool cell_to_point = inputs > 0 && ahead.next().options.cell_to_point;
	for (std::size_t i = 0; i < inputs; ++i)
	{
		if (ahead.next().input.starts_with(kDemoPrefix))
			return none;
		Result<CheckedInput> read = ahead.read(timeline);
		if (!read)
			return read.error();
		for (CheckedBlock& block : read->blocks)
		{
			if (fields.size() == set.blocks.size() || geometryOf(block) != set.blocks[fields.size()].geometry)
				return none;
			fields.push_back(std::move(block.fields));
		}
	}
	if (fields.size() != set.blocks.size())
		return none;
	for (std::size_t b = 0; cell_to_point && b < fields.size(); ++b)
		fields[b] = grid::fieldsAtPoints(set.blocks[b], std::move(fields[b]));
	return std::optional(std::move(fields));
}

} // namespace

Result<std::optional<BlockFields>> readFields(const std::vector<std::string>& inputs, const ReadOptions& options,
                                              const grid::BlockSet& set, Timeline* timeline)
{
	ReadAhead ahead(inputs, options);
	return fieldsOf(ahead, inputs.size(), set, timeline);
}

Result<bool> readValues(const std::vector<std::string>& inputs, const ReadOptions& options, grid::BlockSet& set,
                        Timeline* timeline)
{
	ReadAhead ahead(inputs, options);
	return readValues(ahead, inputs.size(), set, timeline);
}

Result<bool> readValues(ReadAhead& ahead, std::size_t inputs, grid::BlockSet& set, Timeline* timeline)
{
	Result<std::optional<BlockFields>> fields = fieldsOf(ahead, inputs, set, timeline);
	if (!fields)
		return fields.error();
	if (!*fields)
		return false;
	for (std::size_t b = 0; b < (*fields)->size(); ++b)
		grid::replaceFields(set.blocks[b], std::move((**fields)[b]));
	return true;
}

} // namespace vp::read
