#include "file_head.h"

#include "base/real_text.h"
#include "lsdyna_words.h"
#include "netcdf_size.h"
#include "slice_files.h"
#include "vprobe-read/base/is_one_of.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace vp::reader::checks
{

namespace
{

// XML declarations and comments may stand before the element that names the type.
constexpr std::size_t kHeadBytes = 4096;

// Offset of the magic in a NIfTI header.
constexpr std::size_t kNiftiMagicAt = 344;

} // namespace

FileHead::FileHead(const std::string& file)
    : file_(file), name_(std::filesystem::path(file).filename().string()), head_(kHeadBytes, '\0')
{
	std::transform(name_.begin(), name_.end(), name_.begin(), [](unsigned char c) { return std::tolower(c); });
	std::ifstream in(file, std::ios::binary);
	in.read(head_.data(), static_cast<std::streamsize>(head_.size()));
	head_.resize(static_cast<std::size_t>(in.gcount()));
}

bool FileHead::ends(std::initializer_list<std::string_view> endings) const
{
	return std::any_of(endings.begin(), endings.end(), [&](std::string_view e) { return name_.ends_with(e); });
}

bool FileHead::isText() const
{
	return std::none_of(head_.begin(), head_.end(), [](unsigned char c) { return c < 0x20 && !std::isspace(c); });
}

bool FileHead::isNifti() const
{
	if (ends({".nii.gz"}))
		return true;
	return (head_.size() >= 348 && isOneOf(text().substr(kNiftiMagicAt, 3), {"n+1", "ni1"})) ||
	       (head_.size() >= 12 && isOneOf(text().substr(4, 3), {"n+2", "ni2"}));
}

bool FileHead::isFolder() const
{
	return std::filesystem::is_directory(file_);
}

bool FileHead::holdsFile(const std::string& name) const
{
	std::error_code ignored;
	return std::filesystem::is_regular_file(std::filesystem::path(file_) / name, ignored);
}

bool FileHead::isOfSlices() const
{
	return head_.empty() && !sliceFiles(file_).empty();
}

bool FileHead::isTecplot() const
{
	if (!isText())
		return false;
	std::string words = head_;
	std::transform(words.begin(), words.end(), words.begin(), [](unsigned char c) { return std::toupper(c); });
	const auto variables = words.find("VARIABLES");
	return variables != words.npos && words.find('=', variables) != words.npos &&
	       (words.find("ZONE", variables) != words.npos || words.size() == kHeadBytes);
}

// Looks for five counts, then a node: its number and three coordinates.
bool FileHead::isUcd() const
{
	if (!isText())
		return false;
	std::istringstream lines(head_);
	std::string line;
	while (std::getline(lines, line) && (line.empty() || line[0] == '#'))
		;
	const auto numbersIn = [](const std::string& text)
	{
		std::istringstream words(text);
		int count = 0;
		for (std::string word; words >> word; ++count)
			if (!parseReal(word))
				return 0;
		return count;
	};
	return numbersIn(line) == 5 && line.find('.') == line.npos && std::getline(lines, line) && numbersIn(line) == 4;
}

// Looks for a 7, then counts that give the file's size in either byte order: see read_ucd_binary.cpp.
bool FileHead::isBinaryUcd() const
{
	return starts("\7") && head_.size() >= 25 && ends({".inp", ".avs", ".ucd", ".dat"});
}

// Looks for "(0 "a comment")", "(1 "...")" or "(2 3)" at the start, and for nodes anywhere.
bool FileHead::isFluent() const
{
	const auto first = text().find_first_not_of(" \t\r\n");
	if (first == head_.npos || head_[first] != '(')
		return false;
	const std::string_view rest = text().substr(first + 1, 3);
	return isOneOf(rest, {"0 \"", "1 \"", "2 3", "2 2"}) || rest.starts_with("10 ") ||
	       (ends({".cas"}) && !rest.empty() && std::isdigit(static_cast<unsigned char>(rest[0])));
}

bool FileHead::isSlc() const
{
	return starts("11111") && head_.size() > 5 && std::isspace(static_cast<unsigned char>(head_[5]));
}

// Looks for 40 lines that begin with C, in EBCDIC or ASCII, then for a known format of samples and their number.
bool FileHead::isSegy() const
{
	constexpr std::size_t samples_at = 3220, format_at = 3224;
	if (head_.size() < 3600 || !(starts("C") || starts("\xC3") || ends({".sgy", ".segy"})))
		return false;
	const auto isPossible = [&](std::size_t high, std::size_t low)
	{
		const auto number = [&](std::size_t at)
		{ return static_cast<unsigned char>(head_[at + high]) * 256 + static_cast<unsigned char>(head_[at + low]); };
		return number(samples_at) > 1 && number(format_at) >= 1 && number(format_at) <= 16;
	};
	return isPossible(0, 1) || isPossible(1, 0);
}

bool FileHead::isD3plot() const
{
	return !isText() && LsdynaWords::isHead(text());
}

bool FileHead::namesFiles() const
{
	const std::string type = xmlTypeOf(head_);
	return !type.empty() && !isOneOf(type, {"ImageData", "RectilinearGrid", "StructuredGrid", "UnstructuredGrid",
	                                        "PolyData", "HyperTreeGrid", "Table", "Molecule"});
}

bool FileHead::holds(const std::string& name) const
{
	if (!names_)
		names_ = isHdf5() ? hdf5Names(file_) : isNetcdf() ? netcdfNames(file_) : std::set<std::string>();
	return names_->contains(name);
}

bool FileHead::holdsLike(const std::string& start) const
{
	holds(start);
	const auto name = names_->lower_bound(start);
	return name != names_->end() && name->starts_with(start);
}

std::string xmlTypeOf(std::string_view head)
{
	const auto element = head.find("<VTKFile");
	if (element == head.npos)
		return {};
	const auto end = std::min(head.find('>', element), head.size());
	const std::string_view attributes = head.substr(element, end - element);
	auto at = attributes.find(" type");
	if (at == attributes.npos || (at = attributes.find_first_of("\"'", at)) == attributes.npos)
		return {};
	const auto close = attributes.find(attributes[at], at + 1);
	return close == attributes.npos ? std::string() : std::string(attributes.substr(at + 1, close - at - 1));
}

} // namespace vp::reader::checks
