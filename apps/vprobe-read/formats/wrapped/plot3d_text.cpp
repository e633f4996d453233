#include "plot3d_text.h"

#include "base/real_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace vp::reader::wrapped
{

namespace
{

// Repeated numbers take no room in a file, so that it says nothing about how many there may be.
constexpr std::uint64_t kMaxRepeated = 1u << 27;

constexpr std::string_view kFortranBlanks = " \t\r\n\v\f,";

// Takes numbers one after the other, and writes them.
class Plot3dBytes
{
public:
	Plot3dBytes(const std::vector<double>& numbers, const std::string& name, MemoryFile& to)
	    : numbers_(numbers), name_(name), to_(to)
	{
	}

	void takeWhole(std::uint64_t count)
	{
		std::vector<std::int32_t> whole;
		for (const double number : next(count))
		{
			if (number != std::floor(number) || std::abs(number) > std::numeric_limits<std::int32_t>::max())
				throw damaged(fmt::format("{} where a whole number is wanted", number));
			whole.push_back(static_cast<std::int32_t>(number));
		}
		to_.append({reinterpret_cast<const char*>(whole.data()), whole.size() * sizeof whole[0]});
	}

	void takeReal(std::uint64_t count)
	{
		const std::span<const double> reals = next(count);
		to_.append({reinterpret_cast<const char*>(reals.data()), reals.size_bytes()});
	}

	void end() const
	{
		if (at_ != numbers_.size())
			throw damaged(fmt::format("{} has {} numbers where its grid asks for {}", name_, numbers_.size(), at_));
		to_.end();
	}

private:
	std::span<const double> next(std::uint64_t count)
	{
		if (count > numbers_.size() - at_)
			throw damaged(fmt::format("{} has {} numbers, fewer than its grid asks for", name_, numbers_.size()));
		const std::span<const double> taken = std::span(numbers_).subspan(at_, count);
		at_ += count;
		return taken;
	}

	const std::vector<double>& numbers_;
	const std::string& name_;
	MemoryFile& to_;
	std::size_t at_ = 0;
};

std::uint64_t pointsOfBlock(const std::array<std::uint64_t, 3>& block)
{
	return block[0] * block[1] * block[2];
}

} // namespace

std::vector<double> fortranNumbers(std::string_view text)
{
	std::vector<double> numbers;
	std::uint64_t repeated = 0;
	for (std::size_t at = text.find_first_not_of(kFortranBlanks); at != text.npos;)
	{
		const std::size_t end = std::min(text.find_first_of(kFortranBlanks, at), text.size());
		std::string_view word = text.substr(at, end - at);
		at = text.find_first_not_of(kFortranBlanks, end);
		std::uint64_t times = 1;
		const std::string_view whole = word;
		if (const std::size_t star = word.find('*'); star != word.npos)
		{
			const auto [behind, error] = std::from_chars(word.data(), word.data() + star, times);
			if (error != std::errc() || behind != word.data() + star || (repeated += times) > kMaxRepeated)
				throw damaged(fmt::format("\"{}\" repeats a number in a way that cannot be", whole.substr(0, 40)));
			word.remove_prefix(star + 1);
		}
		const std::optional<double> number = parseReal(word);
		if (!number)
			throw damaged(fmt::format("\"{}\" where a number is wanted", whole.substr(0, 40)));
		numbers.insert(numbers.end(), times, *number);
	}
	return numbers;
}

void writeGridAsBytes(const std::vector<double>& numbers, const Plot3dLayout& layout, MemoryFile& to)
{
	const std::string name = "the grid";
	Plot3dBytes bytes(numbers, name, to);
	const std::uint64_t axes = layout.flat ? 2 : 3;
	bytes.takeWhole(layout.multi_grid + layout.blocks.size() * axes);
	for (const auto& block : layout.blocks)
	{
		bytes.takeReal(pointsOfBlock(block) * axes);
		if (layout.blanking)
			bytes.takeWhole(pointsOfBlock(block));
	}
	bytes.end();
}

void writeSolutionAsBytes(const std::vector<double>& numbers, const Plot3dLayout& grid, const std::string& name,
                          MemoryFile& to)
{
	Plot3dBytes bytes(numbers, name, to);
	bytes.takeWhole(grid.multi_grid + grid.blocks.size() * (grid.flat ? 2 : 3));
	for (const auto& block : grid.blocks)
		bytes.takeReal(4 + pointsOfBlock(block) * (grid.flat ? 4 : 5));
	bytes.end();
}

} // namespace vp::reader::wrapped
