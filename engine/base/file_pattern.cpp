#include "base/file_pattern.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

#include <fnmatch.h>

namespace vp
{

namespace fs = std::filesystem;

namespace
{

bool isDigitOfName(char c)
{
	return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// Takes the digits at the front of a text, without zeros before them.
std::string_view takeDigits(std::string_view& text)
{
	std::size_t end = 0;
	while (end < text.size() && isDigitOfName(text[end]))
		++end;
	std::string_view digits = text.substr(0, end);
	text.remove_prefix(end);
	digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
	return digits;
}

} // namespace

bool comesBefore(const std::string& a, const std::string& b)
{
	std::string_view left = a, right = b;
	while (!left.empty() && !right.empty())
	{
		if (isDigitOfName(left[0]) && isDigitOfName(right[0]))
		{
			const std::string_view m = takeDigits(left), n = takeDigits(right);
			if (m != n)
				return m.size() != n.size() ? m.size() < n.size() : m < n;
			continue;
		}
		if (left[0] != right[0])
			return left[0] < right[0];
		left.remove_prefix(1);
		right.remove_prefix(1);
	}
	return left.empty() != right.empty() ? left.empty() : a < b;
}

bool isPictureName(const std::string& file)
{
	std::string ending = fs::path(file).extension().string();
	std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
	return ending == ".tif" || ending == ".tiff" || ending == ".png";
}

bool isFilePattern(const std::string& path)
{
	std::error_code error;
	return fs::path(path).filename().string().find_first_of("*?[") != std::string::npos && !fs::exists(path, error);
}

std::vector<std::string> filesOfPattern(const std::string& path)
{
	std::error_code error;
	const bool is_folder = fs::is_directory(path, error);
	const fs::path folder = is_folder ? fs::path(path) : fs::path(path).parent_path();
	const std::string pattern = is_folder ? "*" : fs::path(path).filename().string();
	std::vector<std::string> files;
	for (auto entry = fs::directory_iterator(folder.empty() ? "." : folder, error);
	     !error && entry != fs::directory_iterator(); entry.increment(error))
	{
		const std::string name = entry->path().filename().string();
		std::error_code ignored;
		if (!name.starts_with('.') && entry->is_regular_file(ignored) &&
		    fnmatch(pattern.c_str(), name.c_str(), FNM_PERIOD) == 0)
			files.push_back((folder / name).string());
	}
	std::ranges::sort(files, comesBefore);
	return files;
}

} // namespace vp
