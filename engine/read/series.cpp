#include "read/series.h"

#include "base/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <numeric>
#include <string_view>

namespace vp::read
{

namespace
{

constexpr std::string_view kSeriesPrefix = "series:";
constexpr std::string_view kDemo = "demo:";
constexpr char kEnd = '\0'; // ends names of files and times, since no name holds it

bool isDigit(char c)
{
	return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// The grid of a file, and its times.
struct FileFacts
{
	std::vector<std::uint64_t> geometry; // each block's; 0 where it is not known
	std::vector<double> times;
};

Result<FileFacts> factsOf(const std::string& file, ReadOptions options)
{
	options.time = {};
	options.arrays = {.all = false};
	options.builds_neighbors = false;
	options.for_one_cut = true;
	options.patches = false;
	options.identifies_geometry = true;
	const Result<grid::BlockSet> set = readInputs({file}, options, nullptr);
	if (!set)
		return set.error();
	FileFacts facts{{}, set->times};
	for (const grid::Block& block : set->blocks)
		facts.geometry.push_back(block.geometry);
	return facts;
}

bool haveOneGrid(const FileFacts& a, const FileFacts& b)
{
	return a.geometry == b.geometry && !a.geometry.empty() &&
	       std::ranges::none_of(a.geometry, [](std::uint64_t number) { return number == 0; });
}

// Returns the files in the order of their times.
FileSeries inOrder(const std::vector<std::string>& files, const std::vector<double>& times)
{
	std::vector<std::size_t> order(files.size());
	std::iota(order.begin(), order.end(), std::size_t(0));
	std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
	FileSeries series;
	for (const std::size_t i : order)
	{
		series.files.push_back(files[i]);
		series.times.push_back(times[i]);
	}
	return series;
}

std::vector<double> countedTimes(std::size_t count)
{
	std::vector<double> times(count);
	std::iota(times.begin(), times.end(), 0.0);
	return times;
}

// Returns the one time of each file; nothing if files have none. known: the facts of the first files.
Result<std::optional<std::vector<double>>> timesInFiles(const std::vector<std::string>& files,
                                                        const std::vector<FileFacts>& known, const ReadOptions& options)
{
	std::vector<double> times;
	for (std::size_t i = 0; i < files.size(); ++i)
	{
		const Result<FileFacts> facts = i < known.size() ? Result<FileFacts>(known[i]) : factsOf(files[i], options);
		if (!facts)
			return facts.error();
		if (facts->times.size() > 1)
			return Error{ErrorKind::usage, fmt::format("`inputs` times: {} has {} times of its own; leave it out, or "
			                                           "take `inputs` blocks",
			                                           files[i], facts->times.size())};
		if (facts->times.empty())
			return std::optional<std::vector<double>>();
		times.push_back(facts->times[0]);
	}
	std::vector<double> sorted = times;
	std::ranges::sort(sorted);
	// Files that all say the same time are told apart by their names.
	const bool is_clear = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
	return is_clear ? std::optional(std::move(times)) : std::nullopt;
}

Result<std::vector<std::string>> asSeries(const std::vector<std::string>& inputs, const std::vector<FileFacts>& known,
                                          const ReadOptions& options)
{
	Result<std::optional<std::vector<double>>> own = timesInFiles(inputs, known, options);
	if (!own)
		return own.error();
	std::optional<std::vector<double>> times = std::move(*own);
	if (!times)
		times = numbersOfNames(inputs);
	if (!times)
		times = countedTimes(inputs.size());
	return std::vector{seriesInput(inOrder(inputs, *times))};
}

} // namespace

std::optional<std::vector<double>> numbersOfNames(const std::vector<std::string>& names)
{
	if (names.size() < 2)
		return std::nullopt;
	// The stretch in which all names differ, widened to whole numbers.
	std::size_t before = std::string::npos, after = std::string::npos;
	for (const std::string& name : names)
	{
		const std::string& first = names.front();
		if (&name == &first)
			continue;
		const std::size_t least = std::min(first.size(), name.size());
		const std::size_t same = static_cast<std::size_t>(
		    std::mismatch(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(least), name.begin()).first -
		    first.begin());
		before = std::min(before, same);
		const std::size_t tail = static_cast<std::size_t>(
		    std::mismatch(first.rbegin(), first.rbegin() + static_cast<std::ptrdiff_t>(least - same), name.rbegin())
		        .first -
		    first.rbegin());
		after = std::min(after, tail);
	}
	const std::string& first = names.front();
	while (before > 0 && isDigit(first[before - 1]))
		--before;
	while (after > 0 && isDigit(first[first.size() - after]))
		--after;
	std::vector<double> numbers;
	for (const std::string& name : names)
	{
		double number = 0.0;
		const char* stop = name.data() + name.size() - after;
		if (name.size() <= before + after || !std::all_of(name.data() + before, stop, isDigit))
			return std::nullopt;
		if (std::from_chars(name.data() + before, stop, number).ec != std::errc())
			return std::nullopt;
		numbers.push_back(number);
	}
	std::vector<double> sorted = numbers;
	std::ranges::sort(sorted);
	if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
		return std::nullopt;
	return numbers;
}

std::string seriesInput(const FileSeries& series)
{
	std::string input(kSeriesPrefix);
	for (std::size_t i = 0; i < series.files.size(); ++i)
		input += fmt::format("{}{}{}{}", series.times[i], kEnd, series.files[i], kEnd);
	return input;
}

std::optional<FileSeries> parseSeries(const std::string& input)
{
	if (!input.starts_with(kSeriesPrefix) || !input.ends_with(kEnd))
		return std::nullopt;
	FileSeries series;
	std::string_view rest = std::string_view(input).substr(kSeriesPrefix.size());
	const auto next = [&]
	{
		const std::string_view word = rest.substr(0, rest.find(kEnd));
		rest.remove_prefix(std::min(word.size() + 1, rest.size()));
		return word;
	};
	while (!rest.empty())
	{
		const std::string_view time = next();
		std::from_chars(time.data(), time.data() + time.size(), series.times.emplace_back());
		series.files.emplace_back(next());
	}
	return series;
}

Result<std::vector<std::string>> takeInputs(const std::vector<std::string>& inputs, InputsAs as,
                                            const ReadOptions& options)
{
	if (inputs.size() < 2 || as == InputsAs::blocks)
		return inputs;
	const auto demo = std::ranges::find_if(inputs, [](const std::string& input) { return input.starts_with(kDemo); });
	if (as == InputsAs::times && demo != inputs.end())
		return Error{ErrorKind::usage, fmt::format("`inputs` times: {} is no file; name files only", *demo)};
	if (as == InputsAs::times)
		return asSeries(inputs, {}, options);
	if (demo != inputs.end() || !numbersOfNames(inputs))
		return inputs;
	std::vector<FileFacts> facts;
	for (const std::string& file : {inputs[0], inputs[1]})
	{
		Result<FileFacts> found = factsOf(file, options);
		if (!found)
			return inputs; // reading it will tell why
		facts.push_back(std::move(*found));
	}
	if (!haveOneGrid(facts[0], facts[1]) || facts[0].times.size() > 1 || facts[1].times.size() > 1)
		return inputs;
	warn("{} and {} more are taken as times of one series, since their grids are the same; `inputs` blocks puts them "
	     "together",
	     inputs[0], inputs.size() - 1);
	return asSeries(inputs, facts, options);
}

} // namespace vp::read
