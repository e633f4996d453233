#include "state/state_file.h"

#include "probe/json_reader.h"
#include "state/file_places.h"
#include "write/atomic_file.h"

#include <fmt/format.h>

#include <limits>

namespace vp::state
{

namespace
{

using nlohmann::json;
using probe::JsonReader;

constexpr std::size_t kMaxNumbers = 64; // offsets of a stack
constexpr std::size_t kMaxWords = 64;   // surfaces in a picture
constexpr std::size_t kMaxFiles = 100'000;

bool isJson(const std::string& name)
{
	return name.ends_with(".json");
}

// A setting as it stands in the file; null where it is left out.
struct Writer
{
	const std::string& file;

	json operator()(const std::string* text) const { return text->empty() ? json() : json(*text); }
	template <class T>
	json operator()(const std::vector<T>* list) const
	{
		return list->empty() ? json() : json(*list);
	}
	template <class T>
	json operator()(const std::optional<T>* value) const
	{
		return *value ? json(**value) : json();
	}
	template <class T>
	json operator()(const T* value) const
	{
		return *value;
	}
	json operator()(Files files) const
	{
		json names;
		for (const std::string& name : *files.names)
			names.push_back(relativeTo(file, name));
		return names;
	}
	json operator()(File one) const { return one.name->empty() ? json() : json(relativeTo(file, *one.name)); }
	json operator()(NameOrFile one) const { return isJson(*one.name) ? (*this)(File{one.name}) : (*this)(one.name); }
	json operator()(ProbeChoice choice) const
	{
		if (!*choice.own)
			return *choice.name;
		json own = probe::toJson((*choice.own)->probe);
		if (!(*choice.own)->placed) // the command line says where
			own.erase("to_probe");
		return own;
	}
	json operator()(PathChoice choice) const { return *choice.own ? probe::toJson(**choice.own) : json(*choice.name); }
};

struct Reader
{
	const std::string& file;
	const JsonReader& from;

	void operator()(std::string* text) const { *text = from.text(); }
	void operator()(std::optional<std::string>* text) const { *text = from.words(); }
	void operator()(int* number) const
	{
		*number = from.whole(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
	}
	void operator()(std::optional<int>* number) const { (*this)(&number->emplace()); }
	void operator()(double* number) const { *number = from.number(); }
	void operator()(std::optional<double>* number) const { (*this)(&number->emplace()); }
	void operator()(bool* flag) const { *flag = from.flag(); }
	void operator()(std::vector<double>* numbers) const
	{
		from.expectArray(1, kMaxNumbers, "numbers");
		numbers->clear();
		for (std::size_t i = 0; i < from.size(); ++i)
			numbers->push_back(from.at(i).number());
	}
	void operator()(std::vector<std::string>* words) const
	{
		from.expectArray(1, kMaxWords, "words");
		words->clear();
		for (std::size_t i = 0; i < from.size(); ++i)
			words->push_back(from.at(i).text());
	}
	void operator()(Files files) const
	{
		from.expectArray(1, kMaxFiles, "names of files");
		files.names->clear();
		for (std::size_t i = 0; i < from.size(); ++i)
			files.names->push_back(fromState(file, from.at(i).text()));
	}
	void operator()(File one) const { *one.name = fromState(file, from.text()); }
	void operator()(NameOrFile one) const
	{
		*one.name = isJson(from.text()) ? fromState(file, from.text()) : from.text();
	}
	void operator()(ProbeChoice choice) const
	{
		choose(choice, [&] { return probe::probeFromJson(from.value(), "", from.path()); });
	}
	void operator()(PathChoice choice) const
	{
		choose(choice, [&] { return probe::pathFromJson(from.value(), "", from.path()); });
	}

	template <class Choice, class Read>
	void choose(Choice choice, Read&& read) const
	{
		choice.own->reset();
		choice.name->clear();
		if (from.isString())
			*choice.name = from.text();
		else
			*choice.own = own(read());
	}
	// An error of a document within this one comes after its source's name and a colon; the name is none here.
	template <class T>
	static T own(Result<T> read)
	{
		if (!read)
			throw probe::SchemaError{read.error().message.substr(2)};
		return std::move(*read);
	}
};

template <class T>
std::vector<std::string_view> keysOf(const std::vector<T>& named, std::vector<std::string_view> others = {})
{
	for (const T& one : named)
		others.push_back(one.key);
	return others;
}

Nothing readDocument(const JsonReader& document, const Sections& sections, const std::string& file)
{
	document.expectKeys(keysOf(sections, {"$schema", "version"}));
	const JsonReader version = document["version"];
	if (version.number() != kVersion)
		version.refuse(
		    fmt::format("this program knows version {} only; use the program that wrote the file", kVersion));
	for (const Section& section : sections)
		if (const auto part = document.find(section.key))
		{
			part->expectKeys(keysOf(section.settings));
			for (const Setting& setting : section.settings)
				if (const auto value = part->find(setting.key))
					std::visit(Reader{file, *value}, setting.place);
		}
	return {};
}

struct Words
{
	using Texts = std::vector<std::string>;

	Texts operator()(const std::string* text) const { return text->empty() ? Texts() : Texts{*text}; }
	Texts operator()(const std::optional<std::string>* text) const { return *text ? Texts{**text} : Texts(); }
	Texts operator()(const int* number) const { return {fmt::to_string(*number)}; }
	Texts operator()(const std::optional<int>* number) const { return *number ? (*this)(&**number) : Texts(); }
	Texts operator()(const double* number) const { return {fmt::to_string(*number)}; }
	Texts operator()(const std::optional<double>* number) const { return *number ? (*this)(&**number) : Texts(); }
	Texts operator()(const std::vector<double>* numbers) const
	{
		Texts texts;
		for (const double number : *numbers)
			texts.push_back(fmt::to_string(number));
		return texts;
	}
	Texts operator()(const std::vector<std::string>* words) const { return *words; }
	Texts operator()(const bool*) const { return {}; }
	Texts operator()(Files) const { return {}; }
	Texts operator()(File) const { return {}; }
	Texts operator()(NameOrFile) const { return {}; }
	Texts operator()(ProbeChoice) const { return {}; }
	Texts operator()(PathChoice) const { return {}; }
};

} // namespace

Status save(const Sections& sections, const std::string& file)
{
	json document{{"version", kVersion}};
	for (const Section& section : sections)
		for (const Setting& setting : section.settings)
			if (json value = std::visit(Writer{file}, setting.place); !value.is_null())
				document[section.key][setting.key] = std::move(value);
	Result<write::AtomicFile> out = write::AtomicFile::create(file);
	if (!out)
		return out.error();
	out->write(probe::jsonText(document));
	return out->commit();
}

Status load(const Sections& sections, const std::string& file)
{
	const Result<std::string> text = probe::readText(file);
	if (!text)
		return text.error();
	const Result<json> document = probe::parseJson(*text, file);
	if (!document)
		return document.error();
	return probe::readDocument<Nothing>(*document, file, "",
	                                    [&](const JsonReader& reader) { return readDocument(reader, sections, file); });
}

std::vector<std::string> valuesOf(const Setting& setting)
{
	return std::visit(Words(), setting.place);
}

} // namespace vp::state
