#include "ensight_case.h"

#include "base/real_text.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace vp::reader::meshes
{

namespace
{

using CaseWords = std::vector<std::string>;

// Words between white space; double quotes hold a name with white space together.
CaseWords caseWordsOf(std::string_view line)
{
	CaseWords words;
	std::string word;
	bool is_quoted = false, has_word = false;
	for (const char c : line)
	{
		const bool is_space = c == ' ' || (c >= '\t' && c <= '\r');
		if (c == '"')
		{
			is_quoted = !is_quoted;
			has_word = true;
		}
		else if (is_space && !is_quoted)
		{
			if (has_word)
				words.push_back(std::move(word));
			word.clear();
			has_word = false;
		}
		else
		{
			word += c;
			has_word = true;
		}
	}
	if (has_word)
		words.push_back(std::move(word));
	return words;
}

std::optional<std::int64_t> wholeNumber(const std::string& word)
{
	std::int64_t value = 0;
	const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
	if (error != std::errc() || end != word.data() + word.size())
		return std::nullopt;
	return value;
}

std::int64_t wantedNumber(const CaseWords& words, std::string_view key)
{
	const auto value = words.empty() ? std::nullopt : wholeNumber(words[0]);
	if (!value)
		throw damaged(fmt::format("its \"{}\" is no number", key));
	return *value;
}

// Takes the numbers of the time set and the file set off the front, if `least` words remain behind them.
void takeSets(CaseWords& words, std::size_t least, EnSightCase::Files& files)
{
	for (std::optional<std::int64_t>* set : {&files.time_set, &files.file_set})
	{
		if (words.size() <= least || !wholeNumber(words[0]))
			return;
		*set = wholeNumber(words[0]);
		words.erase(words.begin());
	}
}

// A time set as it is written.
struct WrittenTimes
{
	std::optional<std::int64_t> steps;
	std::vector<double> times;
	std::vector<std::int64_t> numbers;
	std::int64_t start = 0;
	std::int64_t increment = 1;
};

class CaseParser
{
public:
	explicit CaseParser(const std::string& file) : folder_(std::filesystem::path(file).parent_path()), in_(file) {}

	EnSightCase parse()
	{
		std::string section, key;
		CaseWords words;
		const auto finish = [&]
		{
			if (!key.empty())
				takeEntry(section, key, std::move(words));
			key.clear();
			words.clear();
		};
		for (std::string line; std::getline(in_, line);)
		{
			const CaseWords all = caseWordsOf(line);
			if (all.empty() || all[0].starts_with('#'))
				continue;
			const auto colon = line.find(':');
			if (colon == line.npos && all.size() == 1 && isSection(all[0]))
			{
				finish();
				section = all[0];
			}
			else if (colon != line.npos && line.find('"') >= colon)
			{
				finish();
				key = fmt::format("{}", fmt::join(caseWordsOf(line.substr(0, colon)), " "));
				words = caseWordsOf(line.substr(colon + 1));
			}
			else // values go on over lines
				words.insert(words.end(), all.begin(), all.end());
		}
		finish();
		if (about_.model.names.empty())
			throw damaged("it names no model");
		for (const auto& [number, set] : times_)
			about_.time_sets[number] = timeSet(number, set);
		return std::move(about_);
	}

private:
	static bool isSection(const std::string& word)
	{
		return word.size() > 2 &&
		       std::ranges::all_of(word, [](char c) { return (c >= 'A' && c <= 'Z') || c == '_'; }) && word != "NAN";
	}

	void takeEntry(const std::string& section, const std::string& key, CaseWords words)
	{
		if (section == "FORMAT" && key == "type")
			takeType(words);
		else if (section == "GEOMETRY")
			takeGeometry(key, std::move(words));
		else if (section == "VARIABLE")
			takeVariable(key, std::move(words));
		else if (section == "TIME")
			takeTimes(key, words);
		else if (section == "FILE")
			takeFileSet(key, words);
		else if (section == "MATERIAL" && about_.left_out.end() == std::ranges::find(about_.left_out, "materials"))
			about_.left_out.emplace_back("materials");
	}

	void takeType(const CaseWords& words)
	{
		if (words.empty() || words[0] != "ensight" || (words.size() > 1 && words[1] != "gold"))
			throw Refusal(fmt::format("a case of type \"{}\"; save it as \"ensight gold\"", fmt::join(words, " ")));
		about_.is_gold = words.size() > 1;
	}

	void takeGeometry(const std::string& key, CaseWords words)
	{
		if (key != "model")
		{
			about_.left_out.push_back(key == "measured" ? "measured particles" : key + " files");
			return;
		}
		if (const auto only = std::ranges::find(words, "change_coords_only"); only != words.end())
		{
			about_.changes_coordinates_only = true;
			if (only + 1 != words.end())
				about_.step_of_cells =
				    static_cast<std::size_t>(std::max<std::int64_t>(wholeNumber(only[1]).value_or(0), 0));
			words.erase(only, words.end());
		}
		takeSets(words, 1, about_.model);
		if (words.empty())
			throw damaged("its model has no file");
		about_.model.names = {words[0]};
	}

	void takeVariable(const std::string& key, CaseWords words)
	{
		if (key == "constant per case" || key == "constant per case file")
			return takeConstant(key, std::move(words));
		static const std::map<std::string, int, std::less<>> kinds = {
		    {"scalar", 1}, {"vector", 3}, {"tensor", 6}, {"tensor symm", 6}, {"tensor asym", 9}};
		std::string_view kind = key;
		const bool is_complex = kind.starts_with("complex ");
		if (is_complex)
			kind.remove_prefix(8);
		const bool per_node = kind.ends_with(" per node");
		const bool per_element = kind.ends_with(" per element");
		const std::size_t end = per_node ? 9 : per_element ? 12 : 0;
		const auto components = kinds.find(kind.substr(0, kind.size() - end));
		const std::size_t files = is_complex ? 2 : 1;
		EnSightCase::Variable variable;
		takeSets(words, 1 + files, variable.files);
		if (end == 0 || components == kinds.end())
		{
			about_.left_out.push_back(words.empty() ? key : fmt::format("{} ({})", words[0], key));
			return;
		}
		if (words.size() < 1 + files)
			throw damaged(fmt::format("its \"{}\" {} has no file", key, words.empty() ? "" : words[0]));
		variable.name = words[0];
		variable.files.names.assign(words.begin() + 1, words.begin() + 1 + static_cast<std::ptrdiff_t>(files));
		variable.per_node = per_node;
		variable.components = components->second;
		about_.variables.push_back(std::move(variable));
	}

	void takeConstant(const std::string& key, CaseWords words)
	{
		EnSightCase::Constant constant;
		// A name may be a number too: the set is one if a name and a value follow.
		if (words.size() > 2 && wholeNumber(words[0]) && !parseReal(words[1]))
		{
			constant.time_set = wholeNumber(words[0]);
			words.erase(words.begin());
		}
		if (words.empty())
			return;
		constant.name = words[0];
		if (key.ends_with("file"))
		{
			about_.left_out.push_back(fmt::format("{} (constant per case)", constant.name));
			return;
		}
		for (std::size_t i = 1; i < words.size(); ++i)
			constant.values.push_back(parseReal(words[i]).value_or(std::numeric_limits<double>::quiet_NaN()));
		about_.constants.push_back(std::move(constant));
	}

	void takeTimes(const std::string& key, CaseWords words)
	{
		if (key == "time set")
			time_set_ = wantedNumber(words, key);
		WrittenTimes& set = times_[time_set_];
		if (key.ends_with(" file") && !words.empty())
			words = wordsOfFile(words[0]);
		if (key == "number of steps")
			set.steps = wantedNumber(words, key);
		else if (key == "filename start number")
			set.start = wantedNumber(words, key);
		else if (key == "filename increment")
			set.increment = wantedNumber(words, key);
		else if (key.starts_with("filename numbers"))
			for (const std::string& word : words)
				set.numbers.push_back(wantedNumber({word}, key));
		else if (key.starts_with("time values"))
			for (const std::string& word : words)
			{
				const std::optional<double> time = parseReal(word);
				if (!time || !std::isfinite(*time))
					throw damaged(fmt::format("its time \"{}\" is no number", word.substr(0, 20)));
				set.times.push_back(*time);
			}
	}

	CaseWords wordsOfFile(const std::string& name) const
	{
		std::ifstream in(folder_ / name);
		if (!in)
			throw Refusal(fmt::format("its file {} cannot be opened; keep them together", name));
		std::ostringstream text;
		text << in.rdbuf();
		return caseWordsOf(text.str());
	}

	void takeFileSet(const std::string& key, const CaseWords& words)
	{
		if (key == "file set")
			file_set_ = wantedNumber(words, key);
		EnSightCase::FileSet& set = about_.file_sets[file_set_];
		if (key == "filename index")
			set.files.push_back({wantedNumber(words, key), 0});
		else if (key == "number of steps")
		{
			const std::int64_t steps = wantedNumber(words, key);
			if (steps < 0)
				throw damaged(fmt::format("its file set {} has {} steps", file_set_, steps));
			if (set.files.empty() || set.files.back().steps > 0)
				set.files.push_back({});
			set.files.back().steps = static_cast<std::size_t>(steps);
		}
	}

	EnSightCase::TimeSet timeSet(std::int64_t number, const WrittenTimes& written)
	{
		const auto given = static_cast<std::int64_t>(written.times.size());
		const std::int64_t steps = written.steps.value_or(given);
		if (steps < 0 || steps > given)
			throw damaged(fmt::format("its time set {} has {} time values for {} steps", number, given, steps));
		if (steps < given)
			about_.notes.push_back(fmt::format("time set {} has {} time values for {} steps; the first ones are used",
			                                   number, given, steps));
		if (!written.numbers.empty() && static_cast<std::int64_t>(written.numbers.size()) < steps)
			throw damaged(
			    fmt::format("its time set {} has {} file numbers for {} steps", number, written.numbers.size(), steps));
		EnSightCase::TimeSet set;
		set.times.assign(written.times.begin(), written.times.begin() + steps);
		for (std::int64_t i = 0; i < steps; ++i)
		{
			std::int64_t at = 0;
			if (!written.numbers.empty())
				at = written.numbers[static_cast<std::size_t>(i)];
			else if (__builtin_mul_overflow(i, written.increment, &at) ||
			         __builtin_add_overflow(at, written.start, &at))
				throw damaged(fmt::format("its time set {} has file numbers that are too large", number));
			set.numbers.push_back(at);
		}
		return set;
	}

	std::filesystem::path folder_;
	std::ifstream in_;
	EnSightCase about_;
	std::map<std::int64_t, WrittenTimes> times_;
	std::int64_t time_set_ = 1;
	std::int64_t file_set_ = 1;
};

} // namespace

EnSightCase readEnSightCase(const std::string& file)
{
	return CaseParser(file).parse();
}

} // namespace vp::reader::meshes
