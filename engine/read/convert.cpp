#include "read/convert.h"

#include "base/messages.h"
#include "base/progress.h"
#include "read/child.h"
#include "read/input_limits.h"
#include "read/manifest.h"
#include "read/sandbox.h"
#include "read/source_stamp.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace vp::read
{

namespace fs = std::filesystem;

bool canConvertTo(const std::string& target)
{
	constexpr std::array<std::string_view, 6> endings = {".vti", ".vtr", ".vts", ".vtu", ".vtm", ".vtkhdf"};
	return std::find(endings.begin(), endings.end(), fs::path(target).extension().string()) != endings.end();
}

namespace
{

// Returns an error if an array is wanted that no block has.
Status checkWish(const CheckedInput& input, const ArrayWish& wish)
{
	std::vector<std::string> known; // each with what it is of: "point:NAME"
	for (const CheckedBlock& block : input.blocks)
	{
		for (const grid::Field& field : block.fields)
			known.push_back(fmt::format("{}:{}", grid::associationName(field.association), field.name));
		known.insert(known.end(), block.arrays_left_out.begin(), block.arrays_left_out.end());
	}
	std::ranges::sort(known);
	known.erase(std::unique(known.begin(), known.end()), known.end());
	for (const std::string& name : wish.names)
		if (std::ranges::none_of(known, [&](const std::string& each)
		                         { return each == name || each == "point:" + name || each == "cell:" + name; }))
			return Error{ErrorKind::usage,
			             fmt::format("`array` {}: no such array; there are: {}", name, fmt::join(known, ", "))};
	return Nothing{};
}

} // namespace

Status convert(const std::string& input, const ReadOptions& options, const std::string& target,
               const std::string& folder)
{
	const char* work = target.ends_with(kIndexEnding) ? "indexing"
	                   : options.cells_of_part > 0    ? "packing"
	                                                  : "converting";
	const Progress progress(fmt::format("{} {}", work, input));
	ReadOptions reading = options;
	reading.convert_to = target;
	reading.convert_folder = folder;
	// Only VTKHDF is written by us, and layer by layer. It takes a fifth of the time: both files fit into the system's
	// memory then.
	constexpr std::uint64_t kWholeArrays = 64 << 20;
	if (fs::path(target).extension() == ".vtkhdf")
		reading.stays_above = std::min(options.stays_above.value_or(kWholeArrays), kWholeArrays);
	else
		reading.stays_above.reset();
	Result<InputLimits> limits = input.starts_with("demo:") ? Result<InputLimits>(limitsWithoutFile())
	                                                        : inputLimits(input, options.solution, options.format);
	if (!limits)
		return limits.error();
	// Packing takes longer than reading, and the grid may be read again for each time.
	limits->time *= options.all_times ? 32 : 4;
	const Result<HandedOver> handed = runReader(input, reading, *limits);
	if (!handed)
		return handed.error();
	const Result<CheckedInput> checked =
	    checkManifest(handed->manifest, handed->arrays, handed->cells, input, followArgument(options.follow));
	if (!checked)
		return unusable(input, checked.error());
	if (Status known = checkWish(*checked, options.arrays); !known)
		return known;
	noteFiles(*checked);
	noteSandbox(checked->sandbox);
	for (const ReadWarning& warning : checked->warnings)
		warn("{}: {}", input, warning.text());
	return Nothing{};
}

} // namespace vp::read
