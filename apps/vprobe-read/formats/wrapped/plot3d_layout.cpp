#include "plot3d_layout.h"

#include "plot3d_text.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

namespace vp::reader::wrapped
{

namespace
{

// More blocks, or more points along an axis, than any real grid has; bounds what a foreign file can make us do.
constexpr std::uint64_t kMaxBlocks = 100000;
constexpr std::uint64_t kMaxPlot3dAxisPoints = 1u << 24;
// Some systems write files in whole sectors.
constexpr std::uint64_t kSector = 512;

std::uint64_t pointsOf(const std::array<std::uint64_t, 3>& block)
{
	return block[0] * block[1] * block[2];
}

// The integers of the header, as a candidate layout sees them.
class HeaderReader
{
public:
	// numbers: those of a text.
	HeaderReader(const std::string& file, const Plot3dLayout& layout, const std::vector<double>& numbers)
	    : in_(file, std::ios::binary), layout_(layout), numbers_(numbers)
	{
	}

	std::optional<std::uint64_t> next()
	{
		if (!layout_.binary)
		{
			const double number = at_ < numbers_.size() ? numbers_[at_++] : -1.0;
			const bool is_count = number >= 0.0 && number < 4294967296.0 && number == std::floor(number);
			return is_count ? std::optional(static_cast<std::uint64_t>(number)) : std::nullopt;
		}
		std::array<char, 4> bytes;
		if (!in_.read(bytes.data(), 4))
			return std::nullopt;
		return numberAt<std::uint32_t>(bytes.data(), byteOrder(!layout_.little_endian));
	}
	bool recordMark(std::uint64_t bytes) { return !layout_.byte_counts || next() == bytes; }

private:
	std::ifstream in_;
	const Plot3dLayout& layout_;
	const std::vector<double>& numbers_;
	std::size_t at_ = 0;
};

bool readHeader(const std::string& file, Plot3dLayout& layout, const std::vector<double>& numbers = {})
{
	HeaderReader header(file, layout, numbers);
	std::uint64_t blocks = 1;
	if (layout.multi_grid)
	{
		if (!header.recordMark(4))
			return false;
		blocks = header.next().value_or(0);
		if (!header.recordMark(4))
			return false;
	}
	if (blocks < 1 || blocks > kMaxBlocks)
		return false;
	const int axes = layout.flat ? 2 : 3;
	if (!header.recordMark(blocks * axes * 4))
		return false;
	for (std::uint64_t b = 0; b < blocks; ++b)
	{
		std::array<std::uint64_t, 3> block = {1, 1, 1};
		for (int axis = 0; axis < axes; ++axis)
		{
			block[axis] = header.next().value_or(0);
			if (block[axis] < 1 || block[axis] > kMaxPlot3dAxisPoints)
				return false;
		}
		if (pointsOf(block) > (std::uint64_t(1) << 40))
			return false;
		layout.blocks.push_back(block);
	}
	return header.recordMark(blocks * axes * 4);
}

std::uint64_t headerBytes(const Plot3dLayout& layout)
{
	const std::uint64_t marks = layout.byte_counts ? 8 : 0;
	return (layout.multi_grid ? 4 + marks : 0) + layout.blocks.size() * (layout.flat ? 8 : 12) + marks;
}

std::uint64_t gridBytes(const Plot3dLayout& layout)
{
	const std::uint64_t per_point = (layout.flat ? 2 : 3) * (layout.doubles ? 8 : 4) + (layout.blanking ? 4 : 0);
	std::uint64_t bytes = headerBytes(layout);
	for (const auto& block : layout.blocks)
		bytes += pointsOf(block) * per_point + (layout.byte_counts ? 8 : 0);
	return bytes;
}

std::uint64_t solutionBytes(const Plot3dLayout& layout)
{
	const std::uint64_t number = layout.doubles ? 8 : 4;
	const std::uint64_t per_point = (layout.flat ? 4 : 5) * number;
	const std::uint64_t marks = layout.byte_counts ? 8 : 0;
	std::uint64_t bytes = headerBytes(layout);
	for (const auto& block : layout.blocks)
		bytes += 4 * number + marks + pointsOf(block) * per_point + marks;
	return bytes;
}

bool fits(std::uint64_t wanted, std::uint64_t there)
{
	return wanted == there || (there > wanted && there % kSector == 0 && there - wanted < kSector);
}

bool looksLikeText(const std::string& file)
{
	std::ifstream in(file, std::ios::binary);
	for (int i = 0; i < 256; ++i)
	{
		const int c = in.get();
		if (c == EOF)
			break;
		if (!std::isspace(c) && !std::isdigit(c) &&
		    !std::strchr("+-.,*eEdDqQnNaAiIfFtTyY", c)) // nan and Infinity, and 3*0.5
			return false;
	}
	return true;
}

std::uint64_t headerWords(const Plot3dLayout& layout)
{
	return layout.multi_grid + layout.blocks.size() * (layout.flat ? 2 : 3);
}

std::optional<Plot3dLayout> findTextLayout(const std::string& file)
{
	const std::vector<double> numbers = fortranNumbers(MappedText(file).text());
	for (int bits = 0; bits < 8; ++bits)
	{
		Plot3dLayout layout;
		layout.binary = false;
		layout.multi_grid = bits & 1;
		layout.blanking = bits & 2;
		layout.flat = bits & 4;
		if (!readHeader(file, layout, numbers))
			continue;
		std::uint64_t wanted = headerWords(layout);
		for (const auto& block : layout.blocks)
			wanted += pointsOf(block) * ((layout.flat ? 2 : 3) + layout.blanking);
		if (wanted == numbers.size())
			return layout;
	}
	return std::nullopt;
}

std::optional<Plot3dLayout> findBinaryLayout(const std::string& file)
{
	const std::uint64_t there = std::filesystem::file_size(file);
	// The last bit is the weakest sign of a wrong guess: three coordinates are tried before two.
	for (int bits = 0; bits < 64; ++bits)
	{
		Plot3dLayout layout;
		layout.little_endian = bits & 1;
		layout.byte_counts = bits & 2;
		layout.multi_grid = bits & 4;
		layout.doubles = bits & 8;
		layout.blanking = bits & 16;
		layout.flat = bits & 32;
		if (readHeader(file, layout) && fits(gridBytes(layout), there))
			return layout;
	}
	return std::nullopt;
}

} // namespace

Plot3dLayout findPlot3dLayout(const std::string& file)
{
	const auto layout = looksLikeText(file) ? findTextLayout(file) : findBinaryLayout(file);
	if (!layout)
		throw damaged("no layout of a PLOT3D grid file has its size");
	return *layout;
}

void refuseShortSolution(const std::string& solution, const Plot3dLayout& grid)
{
	const std::uint64_t there = std::filesystem::file_size(solution);
	const std::uint64_t wanted = solutionBytes(grid);
	if (there < wanted)
		throw damaged(fmt::format("the solution {} has {} bytes where its grid asks for {}", solution, there, wanted));
}

} // namespace vp::reader::wrapped
