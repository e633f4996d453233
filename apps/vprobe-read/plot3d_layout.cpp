#include "plot3d_layout.h"

#include "refusal.h"

#include <fmt/format.h>

#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

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
	HeaderReader(const std::string& file, const Plot3dLayout& layout) : in_(file, std::ios::binary), layout_(layout) {}

	std::optional<std::uint64_t> next()
	{
		if (!layout_.binary)
		{
			std::uint64_t value = 0;
			return in_ >> value ? std::optional(value) : std::nullopt;
		}
		std::array<unsigned char, 4> bytes;
		if (!in_.read(reinterpret_cast<char*>(bytes.data()), 4))
			return std::nullopt;
		if (layout_.little_endian)
			std::swap(bytes[0], bytes[3]), std::swap(bytes[1], bytes[2]);
		return std::uint64_t(bytes[0]) << 24 | bytes[1] << 16 | bytes[2] << 8 | bytes[3];
	}
	bool recordMark(std::uint64_t bytes) { return !layout_.byte_counts || next() == bytes; }

private:
	std::ifstream in_;
	const Plot3dLayout& layout_;
};

bool readHeader(const std::string& file, Plot3dLayout& layout)
{
	HeaderReader header(file, layout);
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
		if (!std::isspace(c) && !std::isdigit(c) && !std::strchr("+-.,eEdD", c))
			return false;
	}
	return true;
}

std::uint64_t wordsIn(const std::string& file)
{
	std::ifstream in(file, std::ios::binary);
	std::vector<char> buffer(1 << 16);
	std::uint64_t words = 0;
	bool inside = false;
	while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), in.gcount() > 0)
		for (std::streamsize i = 0; i < in.gcount(); ++i)
		{
			const bool space = std::isspace(static_cast<unsigned char>(buffer[i])) || buffer[i] == ',';
			words += inside && space;
			inside = !space;
		}
	return words + inside;
}

std::uint64_t headerWords(const Plot3dLayout& layout)
{
	return layout.multi_grid + layout.blocks.size() * (layout.flat ? 2 : 3);
}

std::optional<Plot3dLayout> findTextLayout(const std::string& file)
{
	const std::uint64_t words = wordsIn(file);
	for (int bits = 0; bits < 8; ++bits)
	{
		Plot3dLayout layout;
		layout.binary = false;
		layout.multi_grid = bits & 1;
		layout.blanking = bits & 2;
		layout.flat = bits & 4;
		if (!readHeader(file, layout))
			continue;
		std::uint64_t wanted = headerWords(layout);
		for (const auto& block : layout.blocks)
			wanted += pointsOf(block) * ((layout.flat ? 2 : 3) + layout.blanking);
		if (wanted == words)
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
	std::uint64_t there = 0;
	std::uint64_t wanted = 0;
	if (grid.binary)
	{
		there = std::filesystem::file_size(solution);
		wanted = solutionBytes(grid);
	}
	else
	{
		there = wordsIn(solution);
		wanted = headerWords(grid);
		for (const auto& block : grid.blocks)
			wanted += 4 + pointsOf(block) * (grid.flat ? 4 : 5);
	}
	if (there < wanted)
		throw damaged(fmt::format("the solution {} has {} {} where its grid asks for {}", solution, there,
		                          grid.binary ? "bytes" : "numbers", wanted));
}
