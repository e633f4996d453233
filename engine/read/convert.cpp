#include "read/convert.h"

#include "base/messages.h"
#include "read/child.h"
#include "read/input_limits.h"
#include "read/manifest.h"

#include <fmt/format.h>

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

Status convert(const std::string& input, const ReadOptions& options, const std::string& target,
               const std::string& beside)
{
	const fs::path pieces = fs::path(target).parent_path() / fs::path(target).stem();
	const bool has_pieces = fs::path(target).extension() == ".vtm";
	std::error_code ignored;
	if (has_pieces && fs::exists(pieces, ignored))
		return Error{ErrorKind::output,
		             fmt::format("{}: is there already; move it away, or choose another name", pieces.string())};
	ReadOptions reading = options;
	reading.convert_to = target;
	reading.convert_beside = beside;
	Result<InputLimits> limits = inputLimits(input, options.solution, options.format);
	if (!limits)
		return limits.error();
	limits->time *= 4; // packing takes longer than reading
	const Result<HandedOver> handed = runReader(input, reading, *limits);
	Status done = handed ? Status(Nothing{}) : handed.error();
	if (handed)
	{
		const Result<CheckedInput> checked = checkManifest(handed->manifest, handed->arrays, handed->cells);
		if (!checked)
			done = Error{ErrorKind::input, fmt::format("{}: truncated or damaged: {}", input, checked.error().message)};
		else
			for (const std::string& warning : checked->warnings)
				warn("{}: {}", input, warning);
	}
	if (!done && has_pieces)
		fs::remove_all(pieces, ignored);
	return done;
}

} // namespace vp::read
