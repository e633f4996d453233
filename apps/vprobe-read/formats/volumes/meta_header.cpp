#include "meta_header.h"

#include "base/real_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

namespace vp::reader::volumes
{

namespace
{

// Longer than any header, so that a binary file with the wrong ending is not searched to its end.
constexpr int kMaxLines = 1000;
constexpr std::uint64_t kMaxDataFiles = 1 << 20;

std::string_view trimmed(std::string_view text)
{
	while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
		text.remove_prefix(1);
	while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
		text.remove_suffix(1);
	return text;
}

std::vector<std::string_view> metaWords(std::string_view text)
{
	std::vector<std::string_view> words;
	for (text = trimmed(text); !text.empty(); text = trimmed(text))
	{
		const auto end = std::find_if(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) != 0; });
		words.push_back(text.substr(0, static_cast<std::size_t>(end - text.begin())));
		text.remove_prefix(words.back().size());
	}
	return words;
}

std::vector<double> realsIn(std::string_view key, std::string_view text)
{
	std::vector<double> numbers;
	for (const std::string_view word : metaWords(text))
	{
		const std::optional<double> number = parseReal(word);
		if (!number || !std::isfinite(*number))
			throw damaged(fmt::format("its {} has something else in place of a number", key));
		numbers.push_back(*number);
	}
	return numbers;
}

std::int64_t integerIn(std::string_view key, std::string_view text)
{
	const std::vector<double> number = realsIn(key, text);
	if (number.size() != 1 || std::abs(number[0]) > 1e15)
		throw damaged(fmt::format("its {} is no number that can be", key));
	return static_cast<std::int64_t>(number[0]);
}

std::uint64_t metaValueBytes(std::string_view type)
{
	if (type == "MET_CHAR" || type == "MET_UCHAR" || type == "MET_ASCII_CHAR")
		return 1;
	if (type == "MET_SHORT" || type == "MET_USHORT")
		return 2;
	if (type == "MET_INT" || type == "MET_UINT" || type == "MET_LONG" || type == "MET_ULONG" || type == "MET_FLOAT")
		return 4;
	if (type == "MET_LONG_LONG" || type == "MET_ULONG_LONG" || type == "MET_DOUBLE")
		return 8;
	return 0;
}

bool isTrue(std::string_view value)
{
	return value.starts_with('T') || value.starts_with('t') || value.starts_with('1');
}

// The name of a slice by "name%03d.raw", where a pattern has no more than one number.
std::string nameByPattern(std::string_view pattern, long number)
{
	const auto begin = pattern.find('%');
	const auto end = pattern.find_first_not_of("0123456789", begin + 1);
	if (end == pattern.npos || !(pattern[end] == 'd' || pattern[end] == 'i' || pattern[end] == 'u') ||
	    pattern.find('%', end) != pattern.npos)
		throw damaged("the pattern of its data files cannot be followed");
	const std::string_view digits = pattern.substr(begin + 1, end - begin - 1);
	int width = 0;
	std::from_chars(digits.data(), digits.data() + digits.size(), width);
	const char fill = digits.starts_with('0') ? '0' : ' ';
	std::string text = std::to_string(number);
	if (static_cast<int>(text.size()) < std::min(width, 64))
		text.insert(0, static_cast<std::size_t>(std::min(width, 64)) - text.size(), fill);
	return fmt::format("{}{}{}", pattern.substr(0, begin), text, pattern.substr(end + 1));
}

// "PATTERN [FIRST [LAST [STEP]]]", as MetaIO takes it: one file for each index of the last axis.
std::vector<std::string> filesOfPattern(std::string_view value, std::uint64_t count)
{
	std::vector<std::string_view> words = metaWords(value);
	std::vector<std::int64_t> numbers;
	while (numbers.size() < 3 && words.size() > 1 && words.back().find('%') == std::string_view::npos)
	{
		numbers.insert(numbers.begin(), integerIn("ElementDataFile", words.back()));
		words.pop_back();
	}
	const std::string_view pattern = value.substr(0, static_cast<std::size_t>(words.back().end() - value.begin()));
	const std::int64_t first = numbers.empty() ? 1 : numbers[0];
	std::int64_t step = numbers.size() > 2 ? numbers[2] : 1;
	if (numbers.size() == 2)
		step = std::max<std::int64_t>((numbers[1] - first) / static_cast<std::int64_t>(count), 1);
	if (numbers.size() > 1 && (step < 1 || first + step * static_cast<std::int64_t>(count - 1) > numbers[1]))
		throw damaged(fmt::format("the pattern of its data files names fewer than {}", count));
	std::vector<std::string> files;
	for (std::uint64_t i = 0; i < count; ++i)
		files.push_back(nameByPattern(pattern, first + step * static_cast<std::int64_t>(i)));
	return files;
}

// "LIST [AXES]", then a name on each line, of a file with that many axes.
std::vector<std::string> filesOfList(const std::string& value, std::istream& rest,
                                     const std::vector<std::uint64_t>& size)
{
	const std::vector<std::string_view> words = metaWords(value);
	std::size_t axes = words.size() > 1
	                       ? static_cast<std::size_t>(std::max<std::int64_t>(integerIn("ElementDataFile", words[1]), 0))
	                       : 0;
	if (axes == 0 || axes > size.size())
		axes = size.size() - 1;
	std::uint64_t count = 1;
	for (std::size_t axis = axes; axis < size.size(); ++axis)
		if (__builtin_mul_overflow(count, size[axis], &count) || count > kMaxDataFiles)
			throw damaged("it lists more files than there can be");
	std::vector<std::string> files;
	for (std::string line; files.size() < count && std::getline(rest, line);)
		if (const std::string_view name = trimmed(line); !name.empty())
			files.emplace_back(name);
	if (files.size() < count)
		throw damaged(fmt::format("it lists {} data files where its DimSize asks for {}", files.size(), count));
	return files;
}

void findDataFiles(MetaHeader& header, const std::string& value, std::istream& rest)
{
	if (value == "LOCAL" || value == "Local" || value == "local")
		header.header_bytes = rest ? static_cast<std::uint64_t>(rest.tellg()) : 0;
	else if (value.starts_with("LIST"))
		header.data_files = filesOfList(value, rest, header.size);
	else if (value.find('%') == value.npos)
		header.data_files = {value};
	else if (header.size.back() > kMaxDataFiles)
		throw damaged("it lists more files than there can be");
	else
		header.data_files = filesOfPattern(value, header.size.back());
}

void setDirection(MetaHeader& header, std::string_view key, std::string_view value)
{
	const std::vector<double> rows = realsIn(key, value);
	const std::size_t axes = rows.size() == 16 ? 4 : rows.size() == 9 ? 3 : 0;
	if (rows.size() == 4)
		header.direction = {rows[0], rows[2], 0.0, rows[1], rows[3], 0.0, 0.0, 0.0, 1.0};
	if (axes == 0)
		return; // it belongs to a picture
	for (std::size_t axis = 0; axis < 3; ++axis)
		for (std::size_t component = 0; component < 3; ++component)
			header.direction[component * 3 + axis] = rows[axis * axes + component];
	for (std::size_t axis = 0; axes == 4 && axis < 3; ++axis)
		if (rows[axis * 4 + 3] != 0.0 || rows[12 + axis] != 0.0)
			throw Refusal(fmt::format("its {} mixes space and time; write each time into a file of its own", key));
}

// False for a key that says nothing about the data.
bool takeValue(MetaHeader& header, const std::string& key, const std::string& value)
{
	if (key == "DimSize")
	{
		header.size.clear();
		for (const double points : realsIn(key, value))
		{
			if (points < 1.0 || points > 1e12)
				throw damaged("its DimSize cannot be");
			header.size.push_back(static_cast<std::uint64_t>(points));
		}
	}
	else if (key == "ElementType")
	{
		header.type = value.ends_with("_ARRAY") ? value.substr(0, value.size() - 6) : value;
		header.value_bytes = metaValueBytes(header.type);
	}
	else if (key == "ElementNumberOfChannels")
	{
		const std::int64_t channels = integerIn(key, value);
		if (channels < 1 || channels > 1 << 20)
			throw damaged("its ElementNumberOfChannels cannot be");
		header.channels = static_cast<std::uint64_t>(channels);
	}
	else if (key == "BinaryData")
		header.is_text = !isTrue(value);
	else if (key == "BinaryDataByteOrderMSB" || key == "ElementByteOrderMSB")
		header.is_big_endian = isTrue(value);
	else if (key == "CompressedData")
		header.compressed = isTrue(value);
	else if (key == "CompressedDataSize")
		header.compressed_bytes = static_cast<std::uint64_t>(std::max<std::int64_t>(integerIn(key, value), 0));
	else if (key == "HeaderSize")
		header.skipped_bytes = integerIn(key, value);
	else if (key == "TransformMatrix" || key == "Orientation" || key == "Rotation")
		setDirection(header, key, value);
	else if (key == "ElementSpacing" || (key == "ElementSize" && header.spacing.empty()))
		header.spacing = realsIn(key, value);
	else if (key == "Offset" || key == "Position" || key == "Origin")
		header.offset = realsIn(key, value);
	else if (key == "AnatomicalOrientation")
		header.orientation = value;
	else if (key == "DistanceUnits")
		header.units = value;
	else if (key == "ElementToIntensityFunctionSlope")
		header.has_scale = header.has_scale || parseReal(value).value_or(1.0) != 1.0;
	else if (key == "ElementToIntensityFunctionOffset")
		header.has_scale = header.has_scale || parseReal(value).value_or(0.0) != 0.0;
	else
		return false;
	return true;
}

void checkHeader(const MetaHeader& header)
{
	if (header.size.size() < 3)
		throw Refusal("nothing to slice: it has one dimension");
	for (std::size_t axis = 4; axis < header.size.size(); ++axis)
		if (header.size[axis] != 1)
			throw Refusal(fmt::format("an image of {} dimensions; write a file for each volume", header.size.size()));
	if (header.value_bytes == 0)
		throw damaged("its ElementType is unknown");
	if (header.is_text && header.compressed)
		throw damaged("its text cannot be compressed");
}

} // namespace

MetaHeader readMetaHeader(const std::string& file)
{
	MetaHeader header;
	std::ifstream in(file, std::ios::binary);
	std::string line;
	for (int i = 0; i < kMaxLines && std::getline(in, line); ++i)
	{
		const auto equals = line.find('=');
		if (equals == line.npos)
			continue;
		const std::string key(trimmed(std::string_view(line).substr(0, equals)));
		const std::string value(trimmed(std::string_view(line).substr(equals + 1)));
		if (takeValue(header, key, value) || key != "ElementDataFile")
			continue;
		header.is_picture = header.size.size() == 2;
		if (header.is_picture)
			header.size.push_back(1);
		checkHeader(header);
		findDataFiles(header, value, in);
		return header;
	}
	throw damaged("its header ends before ElementDataFile");
}

std::uint64_t MetaHeader::volumeBytes() const
{
	std::uint64_t bytes = value_bytes * channels;
	for (std::size_t axis = 0; axis < 3; ++axis)
		if (__builtin_mul_overflow(bytes, size[axis], &bytes) || bytes > std::uint64_t(1) << 50)
			throw damaged("its DimSize cannot be");
	return bytes;
}

void makeSpacingPositive(MetaHeader& header)
{
	for (std::size_t axis = 0; axis < std::min<std::size_t>(header.spacing.size(), 3); ++axis)
	{
		if (!std::isfinite(header.spacing[axis]) || header.spacing[axis] == 0.0)
			throw damaged("its ElementSpacing makes no grid");
		if (header.spacing[axis] > 0.0)
			continue;
		header.spacing[axis] = -header.spacing[axis];
		for (std::size_t component = 0; component < 3; ++component)
			header.direction[3 * component + axis] *= -1.0;
	}
}

} // namespace vp::reader::volumes
