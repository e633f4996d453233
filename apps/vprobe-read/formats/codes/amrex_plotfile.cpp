// After the source of AMReX: AMReX_PlotFileUtil.cpp, AMReX_VisMF.cpp and AMReX_FabConv.cpp.
#include "amrex_plotfile.h"

#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vp::reader::codes
{

namespace
{

constexpr std::int64_t kMaxAmrexBoxes = 10'000'000;
constexpr std::int64_t kLargestAmrexIndex = 1 << 30;

// All whole numbers of a text, whatever stands between them.
std::vector<std::int64_t> wholesIn(std::string_view text)
{
	std::vector<std::int64_t> numbers;
	for (std::size_t at = 0; at < text.size();)
	{
		const bool is_number = (text[at] >= '0' && text[at] <= '9') ||
		                       (text[at] == '-' && at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9');
		if (!is_number)
		{
			++at;
			continue;
		}
		const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), numbers.emplace_back());
		if (error != std::errc())
			throw damaged("a number is too large");
		at = static_cast<std::size_t>(end - text.data());
	}
	return numbers;
}

// "((0,0,0) (31,31,31) (0,0,0))": the first and the last cell, and 0 for values at cells.
void readAmrexBox(std::span<const std::int64_t> numbers, std::array<std::int64_t, 3>& lo,
                  std::array<std::int64_t, 3>& hi)
{
	if (numbers.size() < 9)
		throw damaged("a box without three axes");
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		lo[axis] = numbers[axis];
		hi[axis] = numbers[3 + axis];
		if (std::abs(lo[axis]) > kLargestAmrexIndex || std::abs(hi[axis]) > kLargestAmrexIndex || hi[axis] < lo[axis])
			throw damaged(fmt::format("a box from {} to {}", lo[axis], hi[axis]));
		if (numbers[6 + axis] != 0)
			throw Refusal("values of AMReX at the corners of cells, which are not read");
	}
}

std::int64_t countOf(text::Cursor& at, std::int64_t most)
{
	const std::int64_t count = at.integer();
	if (count < 0 || count > most)
		throw damaged(fmt::format("a count of {}", count));
	return count;
}

double finite(text::Cursor& at)
{
	const double number = at.real();
	if (!std::isfinite(number))
		throw damaged("a size that is no number");
	return number;
}

class AmrexHeaderParser
{
public:
	explicit AmrexHeaderParser(std::string_view text) : at_(text) {}

	AmrexPlot parse()
	{
		at_.line(); // HyperCLaw-V1.1
		const std::int64_t components = countOf(at_, 100000);
		at_.line();
		for (std::int64_t c = 0; c < components; ++c)
			plot_.names.emplace_back(at_.line());
		if (const std::int64_t dimensions = at_.integer(); dimensions != 3)
			throw Refusal(fmt::format("nothing to slice: a plot file of AMReX of {} dimensions", dimensions));
		plot_.time = at_.real();
		levels_ = static_cast<std::size_t>(countOf(at_, 40)) + 1;
		for (double& place : plot_.lo)
			place = finite(at_);
		for (int axis = 0; axis < 3; ++axis)
			finite(at_); // where the domain ends
		readLevels();
		for (std::size_t level = 0; level < levels_; ++level)
			readBoxes(level);
		return std::move(plot_);
	}

private:
	void readLevels()
	{
		at_.line();
		const std::vector<std::int64_t> ratios = wholesIn(at_.line());
		for (std::size_t level = 0; level + 1 < levels_; ++level)
		{
			if (level >= ratios.size() || ratios[level] < 1 || ratios[level] > 1024)
				throw damaged("a level has no ratio to the next");
			plot_.levels.ratios.push_back(static_cast<int>(ratios[level]));
		}
		const std::vector<std::int64_t> domains = wholesIn(at_.line());
		at_.line(); // steps
		for (std::size_t level = 0; level < levels_; ++level)
		{
			std::array<std::int64_t, 3> hi;
			readAmrexBox(std::span(domains).subspan(std::min(9 * level, domains.size())), plot_.first.emplace_back(),
			             hi);
			for (double& size : plot_.sizes.emplace_back())
				if (size = finite(at_); !(size > 0.0))
					throw damaged("cells without a size");
		}
		plot_.is_cartesian = at_.integer() == 0;
		at_.integer(); // the number of a boundary
	}

	// Boxes by the places of their ends; the level's own file has them by cells.
	void readBoxes(std::size_t level)
	{
		if (at_.integer() != static_cast<std::int64_t>(level))
			throw damaged("its levels do not follow each other");
		const std::int64_t boxes = countOf(at_, kMaxAmrexBoxes);
		at_.line();    // the time
		at_.integer(); // the step
		for (std::int64_t box = 0; box < 6 * boxes; ++box)
			at_.real();
		plot_.folders.emplace_back(at_.word()); // Level_0/Cell
	}

	text::Cursor at_;
	AmrexPlot plot_;
	std::size_t levels_ = 0;
};

} // namespace

AmrexPlot parseAmrexHeader(std::string_view text)
{
	return AmrexHeaderParser(text).parse();
}

std::vector<AmrexBoxData> parseAmrexLevel(std::string_view text)
{
	text::Cursor at(text);
	for (int line = 0; line < 4; ++line)
		at.line();                                              // version, way of writing, components, ghost cells
	const std::vector<std::int64_t> head = wholesIn(at.line()); // "(4 0"
	if (head.empty() || head[0] < 0 || head[0] > kMaxAmrexBoxes)
		throw damaged("a level does not say how many boxes it has");
	std::vector<AmrexBoxData> boxes;
	for (std::int64_t b = 0; b < head[0]; ++b)
	{
		AmrexBoxData& box = boxes.emplace_back();
		readAmrexBox(wholesIn(at.line()), box.lo, box.hi);
	}
	at.line(); // ")"
	if (at.integer() != head[0])
		throw damaged("not every box of a level has a file");
	for (AmrexBoxData& box : boxes)
	{
		if (at.word() != "FabOnDisk:")
			throw damaged("a box of a level has no file");
		box.file = at.word();
		const std::int64_t offset = at.integer();
		if (offset < 0 || box.file.find('/') != box.file.npos)
			throw damaged("a box lies at a place that cannot be");
		box.offset = static_cast<std::uint64_t>(offset);
	}
	return boxes;
}

// "FAB ((8, (64 11 52 0 1 12 0 1023)),(8, (8 7 6 5 4 3 2 1)))((0,0,0) (15,15,15) (0,0,0)) 2", then the values.
std::vector<double> amrexValues(std::string_view file, const AmrexBoxData& box, std::size_t components,
                                std::size_t component)
{
	constexpr std::size_t longest_head = 1000;
	const std::string_view head = file.substr(std::min<std::uint64_t>(box.offset, file.size()), longest_head);
	const auto end = head.find('\n');
	if (!head.starts_with("FAB ((8") || end == head.npos)
		throw damaged(fmt::format("{} has no values at {}", box.file, box.offset));
	// 8 numbers of the format, then the order of bytes, the box and how many components.
	const std::vector<std::int64_t> numbers = wholesIn(head.substr(0, end));
	const std::int64_t bits = numbers.size() > 9 ? numbers[1] : 0;
	const auto width = static_cast<std::size_t>(bits / 8);
	const std::size_t at_box = 9 + 1 + width;
	if ((bits != 32 && bits != 64) || numbers.size() != at_box + 10 ||
	    numbers.back() != static_cast<std::int64_t>(components))
		throw damaged(fmt::format("{} has values at {} that are no plain numbers", box.file, box.offset));
	const ByteOrder order = byteOrder(numbers[10] == 1);
	std::array<std::int64_t, 3> lo, hi;
	readAmrexBox(std::span(numbers).subspan(at_box, 9), lo, hi);
	std::array<std::uint64_t, 3> sides;
	std::uint64_t count = 1;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		sides[axis] = static_cast<std::uint64_t>(hi[axis] - lo[axis] + 1);
		if (lo[axis] > box.lo[axis] || hi[axis] < box.hi[axis] || __builtin_mul_overflow(count, sides[axis], &count))
			throw damaged(fmt::format("{} has values of another box at {}", box.file, box.offset));
	}
	const std::string_view bytes = file.substr(box.offset + end + 1);
	if (count > bytes.size() / width / components)
		throw damaged(fmt::format("{} ends within its values", box.file));
	std::vector<double> values;
	for (std::int64_t k = box.lo[2]; k <= box.hi[2]; ++k)
		for (std::int64_t j = box.lo[1]; j <= box.hi[1]; ++j)
			for (std::int64_t i = box.lo[0]; i <= box.hi[0]; ++i)
			{
				const std::uint64_t index = component * count + static_cast<std::uint64_t>(i - lo[0]) +
				                            sides[0] * (static_cast<std::uint64_t>(j - lo[1]) +
				                                        sides[1] * static_cast<std::uint64_t>(k - lo[2]));
				const char* place = bytes.data() + index * width;
				values.push_back(width == 4 ? numberAt<float>(place, order) : numberAt<double>(place, order));
			}
	return values;
}

} // namespace vp::reader::codes
