#include "ensight_case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace
{
// Larger than any file's number, small enough for an integer.
constexpr double kMaxFileNumber = 1e15;
} // namespace

EnSightCase readEnSightCase(const std::string& file)
{
	EnSightCase about;
	std::ifstream in(file);
	std::string section, set, key;
	for (std::string line; std::getline(in, line);)
	{
		const auto colon = line.find(':');
		const Words words = wordsOf(colon == line.npos ? line : line.substr(colon + 1));
		if (line.starts_with("#") || wordsOf(line).empty())
			continue;
		if (colon == line.npos && words.size() == 1 && std::isupper(static_cast<unsigned char>(line[0])))
			section = words[0];
		if (colon != line.npos)
			key = fmt::format("{}", fmt::join(wordsOf(line.substr(0, colon)), " "));
		if (section == "FORMAT" && key == "type" && (words.size() < 2 || words[1] != "gold"))
			throw NotUnderstood();
		if (section == "GEOMETRY" && key == "model" && colon != line.npos)
			about.geometry = {key, words};
		if (section == "VARIABLE" && colon != line.npos)
			about.variables.push_back({key, words});
		if (section != "TIME" || (colon == line.npos && words[0] == "TIME"))
			continue;
		if (key == "time set")
			set = words.empty() ? "" : words[0];
		EnSightCase::TimeSet& times = about.sets[set];
		for (const std::string& word : words)
		{
			const double value = std::atof(word.c_str());
			if (key == "time values")
				times.times.push_back(value);
			else if (key == "filename numbers")
				times.numbers.push_back(value);
			else if (key == "filename start number")
				times.start = value;
			else if (key == "filename increment")
				times.increment = value;
		}
	}
	return about;
}

std::string fileAt(const EnSightCase& about, std::string name, const std::string& set, std::optional<double> time)
{
	const auto star = name.find('*');
	if (star == name.npos)
		return name;
	const auto found = about.sets.find(set);
	if (found == about.sets.end() || !time || found->second.times.empty())
		throw NotUnderstood();
	const EnSightCase::TimeSet& times = found->second;
	std::size_t step = 0;
	while (step + 1 < times.times.size() && static_cast<float>(times.times[step + 1]) <= static_cast<float>(*time))
		++step;
	const double number =
	    step < times.numbers.size() ? times.numbers[step] : times.start + static_cast<double>(step) * times.increment;
	if (!(std::abs(number) < kMaxFileNumber))
		throw NotUnderstood();
	const auto width = std::min(name.find_first_not_of('*', star), name.size()) - star;
	return name.replace(star, width, fmt::format("{:0{}}", static_cast<long>(number), width));
}
