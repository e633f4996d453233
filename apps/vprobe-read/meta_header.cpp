#include "meta_header.h"

#include "refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

namespace
{

// Longer than any header, so that a binary file with the wrong ending is not searched to its end.
constexpr int kMaxLines = 1000;

std::string trimmed(std::string_view text)
{
	while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
		text.remove_prefix(1);
	while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
		text.remove_suffix(1);
	return std::string(text);
}

template <class T>
std::vector<T> numbersIn(const std::string& text)
{
	std::istringstream in(text);
	std::vector<T> numbers;
	for (T number; in >> number;)
		numbers.push_back(number);
	return numbers;
}

std::uint64_t bytesOf(std::string_view type)
{
	if (type == "MET_CHAR" || type == "MET_UCHAR")
		return 1;
	if (type == "MET_SHORT" || type == "MET_USHORT")
		return 2;
	if (type == "MET_INT" || type == "MET_UINT" || type == "MET_LONG" || type == "MET_ULONG" || type == "MET_FLOAT")
		return 4;
	if (type == "MET_LONG_LONG" || type == "MET_ULONG_LONG" || type == "MET_DOUBLE")
		return 8;
	return 0;
}

// "LOCAL", one name, "LIST" with a name on each following line, or "PATTERN FIRST LAST STEP" in printf's manner.
std::vector<std::string> dataFiles(const std::string& value, std::istream& rest, std::uint64_t slices)
{
	if (value == "LOCAL" || value == "Local" || value == "local")
		return {};
	std::vector<std::string> files;
	if (value.starts_with("LIST"))
	{
		for (std::string line; files.size() < slices && std::getline(rest, line);)
			if (const std::string name = trimmed(line); !name.empty())
				files.push_back(name);
		return files;
	}
	return {value.substr(0, value.find('%') == value.npos ? value.npos : 0)};
}

} // namespace

MetaHeader readMetaHeader(const std::string& file)
{
	MetaHeader header;
	std::ifstream in(file, std::ios::binary);
	std::uint64_t channels = 1;
	std::string line;
	for (int i = 0; i < kMaxLines && std::getline(in, line); ++i)
	{
		const auto equals = line.find('=');
		if (equals == line.npos)
			continue;
		const std::string key = trimmed(std::string_view(line).substr(0, equals));
		const std::string value = trimmed(std::string_view(line).substr(equals + 1));
		if (key == "DimSize")
			header.size = numbersIn<std::uint64_t>(value);
		else if (key == "ElementType")
		{
			header.type = value.ends_with("_ARRAY") ? value.substr(0, value.size() - 6) : value;
			header.element_bytes = bytesOf(header.type);
		}
		else if (key == "ElementNumberOfChannels")
			channels = std::strtoull(value.c_str(), nullptr, 10);
		else if (key == "CompressedData")
			header.compressed = value.starts_with("T") || value.starts_with("t") || value == "1";
		else if (key == "CompressedDataSize")
			header.compressed_bytes = std::strtoull(value.c_str(), nullptr, 10);
		else if (key == "HeaderSize")
			header.skipped_bytes = static_cast<std::uint64_t>(std::max(0ll, std::strtoll(value.c_str(), nullptr, 10)));
		else if (key == "TransformMatrix" || key == "Orientation" || key == "Rotation")
		{
			const auto rows = numbersIn<double>(value);
			if (rows.size() == 9)
				for (int axis = 0; axis < 3; ++axis)
					for (int component = 0; component < 3; ++component)
						header.direction[component * 3 + axis] = rows[axis * 3 + component];
		}
		else if (key == "ElementSpacing" || (key == "ElementSize" && header.spacing.empty()))
			header.spacing = numbersIn<double>(value);
		else if (key == "ElementDataFile")
		{
			header.data_files = dataFiles(value, in, header.size.size() > 2 ? header.size[2] : 1);
			header.header_bytes = header.data_files.empty() && in ? static_cast<std::uint64_t>(in.tellg()) : 0;
			header.element_bytes *= channels;
			return header;
		}
	}
	throw damaged("its header ends before ElementDataFile");
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

void refuseShortData(const std::string& file, const MetaHeader& header)
{
	namespace fs = std::filesystem;
	std::uint64_t wanted = header.element_bytes;
	for (const std::uint64_t points : header.size)
		if (points == 0 || __builtin_mul_overflow(wanted, points, &wanted))
			throw damaged("its DimSize cannot be");
	if (header.compressed)
		wanted = header.compressed_bytes;

	if (header.data_files.empty())
	{
		const std::uint64_t there =
		    fs::file_size(file) - std::min<std::uint64_t>(fs::file_size(file), header.header_bytes);
		if (there < wanted)
			throw damaged(fmt::format("{} bytes of data where its header asks for {}", there, wanted));
		return;
	}
	for (const std::string& name : header.data_files)
	{
		if (name.empty())
			continue; // a pattern, whose files VTK looks for
		const fs::path path = fs::path(file).parent_path() / name;
		std::error_code error;
		const std::uint64_t there = fs::file_size(path, error);
		if (error)
			throw Refusal(fmt::format("its data file {} cannot be opened; keep both together", path.string()));
		if (there < wanted / header.data_files.size() + header.skipped_bytes)
			throw damaged(fmt::format("its data file {} has {} bytes where {} are asked for", path.string(), there,
			                          wanted / header.data_files.size() + header.skipped_bytes));
	}
}
