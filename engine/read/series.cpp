#include "read/series.h"

#include "base/file_pattern.h"
#include "base/messages.h"
#include "read/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string_view>

namespace vp::read
{

namespace
{

constexpr std::string_view kSeriesPrefix = "series:";
constexpr std::string_view kStackPrefix = "stack:";
constexpr std::string_view kDemo = "demo:";
// Readers say the first of a slice that is read alone, and the second of a file that is more than a slice.
constexpr std::string_view kNoCells = "it holds no three-dimensional cells";
constexpr std::string_view kHasPages = " pages, and a slice has one";
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

std::vector<std::string> asStack(std::vector<std::string> inputs)
{
	if (const std::optional<std::vector<double>> numbers = numbersOfNames(inputs))
		inputs = inOrder(inputs, *numbers).files;
	return {stackInput(inputs)};
}

// Returns true for a file of DICOM. One slice stands for its whole series.
bool isDicom(const std::string& file)
{
	const Format* format = formatOfEnding(file);
	std::error_code error;
	if (!std::filesystem::is_regular_file(file, error))
		return false;
	std::array<char, 4> mark{};
	std::ifstream in(file, std::ios::binary);
	in.seekg(128).read(mark.data(), mark.size());
	return (format && format->name == "dicom") || std::string_view(mark.data(), mark.size()) == "DICM";
}

// Returns true if the files are slices of one volume, by the first two of them.
bool areSlices(const std::vector<std::string>& files, const ReadOptions& options)
{
	const Result<FileFacts> both = factsOf(stackInput({files[0], files[1]}), options);
	if (both)
		return true;
	const std::string& why = both.error().message;
	if (isDicom(files[0]))
		return why.ends_with(kNoCells); // two pictures of one place are times of a slice
	// If anything else is wrong with a picture, reading all of them tells it.
	return isPictureName(files[0]) && why.find(kHasPages) == std::string::npos;
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

std::string stackInput(const std::vector<std::string>& files)
{
	std::string input(kStackPrefix);
	for (const std::string& file : files)
		input += file + kEnd;
	return input;
}

std::vector<std::string> parseStack(const std::string& input)
{
	if (!input.starts_with(kStackPrefix) || !input.ends_with(kEnd))
		return {};
	std::vector<std::string> files;
	for (std::string_view rest = std::string_view(input).substr(kStackPrefix.size()); !rest.empty();)
	{
		files.emplace_back(rest.substr(0, rest.find(kEnd)));
		rest.remove_prefix(files.back().size() + 1);
	}
	return files;
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

namespace
{

// Puts the files that a pattern matches in its place. A pattern of pictures is a volume in slices, which stays one
// input unless they are to be something else.
std::vector<std::string> withFilesOfPatterns(const std::vector<std::string>& inputs, InputsAs as)
{
	const bool keeps_pictures = as == InputsAs::automatic || (as == InputsAs::stack && inputs.size() == 1);
	std::vector<std::string> all;
	for (const std::string& input : inputs)
	{
		const std::vector<std::string> files =
		    isFilePattern(input) ? filesOfPattern(input) : std::vector<std::string>();
		if (files.empty() || (keeps_pictures && std::ranges::all_of(files, isPictureName)))
			all.push_back(input);
		else
			all.insert(all.end(), files.begin(), files.end());
	}
	return all;
}

} // namespace

Result<std::vector<std::string>> takeInputs(const std::vector<std::string>& given, InputsAs as,
                                            const ReadOptions& options)
{
	const std::vector<std::string> inputs = withFilesOfPatterns(given, as);
	if (inputs.size() < 2 || as == InputsAs::blocks)
		return inputs;
	const auto demo = std::ranges::find_if(inputs, [](const std::string& input) { return input.starts_with(kDemo); });
	if (as != InputsAs::automatic && demo != inputs.end())
		return Error{ErrorKind::usage, fmt::format("`inputs` {}: {} is no file; name files only",
		                                           as == InputsAs::times ? "times" : "stack", *demo)};
	if (as == InputsAs::times)
		return asSeries(inputs, {}, options);
	if (as == InputsAs::stack)
		return asStack(inputs);
	const bool are_numbered = numbersOfNames(inputs).has_value();
	const bool are_pictures = std::ranges::all_of(inputs, isPictureName) || std::ranges::all_of(inputs, isDicom);
	if (demo != inputs.end() || (!are_numbered && !are_pictures))
		return inputs;
	if (are_pictures && areSlices(inputs, options))
		return asStack(inputs);
	if (!are_numbered)
		return inputs;
	Result<FileFacts> first = factsOf(inputs[0], options);
	if (!first && !are_pictures && areSlices(inputs, options))
		return asStack(inputs);
	if (!first)
		return inputs; // reading it will tell why
	Result<FileFacts> second = factsOf(inputs[1], options);
	if (!second)
		return inputs;
	const std::vector<FileFacts> facts{std::move(*first), std::move(*second)};
	if (!haveOneGrid(facts[0], facts[1]) || facts[0].times.size() > 1 || facts[1].times.size() > 1)
		return inputs;
	note("{} and {} more are taken as times of one series, since their grids are the same; `inputs` blocks puts them "
	     "together",
	     inputs[0], inputs.size() - 1);
	return asSeries(inputs, facts, options);
}

} // namespace vp::read
