#include "view/state_file.h"

#include "probe/json_reader.h"
#include "probe/path_file.h"
#include "render/font/typeface.h"
#include "view/file_places.h"
#include "view/settings.h"
#include "view/words.h"
#include "write/atomic_file.h"

#include <fmt/format.h>

#include <limits>

namespace vp::view
{

namespace
{

using nlohmann::json;
using probe::JsonReader;

constexpr std::size_t kMaxFiles = 100'000;

bool isFile(const std::string& name)
{
	return name.ends_with(".json") || render::namesFontFile(name);
}

// A setting as it stands in the file; null where it is left out.
struct Writer
{
	const std::string& file;

	json operator()(const std::string* text) const { return text->empty() ? json() : json(*text); }
	json operator()(Bytes bytes) const { return *bytes.value; }
	json operator()(const Text& text) const
	{
		const std::optional<std::string> words = text.get();
		return words ? json(*words) : json();
	}
	json operator()(const Texts& texts) const
	{
		const std::vector<std::string> words = texts.get();
		return words.empty() ? json() : json(words);
	}
	json operator()(const Numbers& list) const
	{
		const std::vector<double> numbers = list.get();
		return numbers.empty() ? json() : json(numbers);
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
	json operator()(NameOrFile one) const { return isFile(*one.name) ? (*this)(File{one.name}) : (*this)(one.name); }
	json operator()(ProbeChoice choice) const
	{
		if (choice.probe->shape != ProbeShape::own)
			return text(choice.probe->shape);
		json own = probe::toJson(choice.probe->own->probe);
		if (!choice.probe->own->placed) // other settings say where
			own.erase("to_probe");
		return own;
	}
	json operator()(PathChoice choice) const
	{
		return choice.sweep->own ? probe::toJson(*choice.sweep->own) : json(pathKindText(*choice.sweep));
	}
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
	void operator()(Bytes bytes) const { *bytes.value = from.number(); }
	void operator()(const Text& text) const
	{
		if (const Status set = text.set(from.text()); !set)
			from.refuse(fmt::format("{}: {}", from.text(), set.error().message));
	}
	void operator()(const Texts& texts) const
	{
		from.expectArray(1, kMaxListed, "words");
		std::vector<std::string> words;
		for (std::size_t i = 0; i < from.size(); ++i)
			words.push_back(from.at(i).text());
		if (const Status set = texts.set(words); !set)
			from.refuse(set.error().message);
	}
	void operator()(const Numbers& list) const
	{
		from.expectArray(list.count ? list.count : 1, list.count ? list.count : kMaxListed, "numbers");
		std::vector<double> numbers;
		for (std::size_t i = 0; i < from.size(); ++i)
			numbers.push_back(from.at(i).number());
		list.set(numbers);
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
		*one.name = isFile(from.text()) ? fromState(file, from.text()) : from.text();
	}
	void operator()(ProbeChoice choice) const
	{
		if (from.isString())
		{
			const Result<ProbeShape> shape = parse<ProbeShape>(from.text());
			if (!shape)
				from.refuse(fmt::format("{}: {}", from.text(), shape.error().message));
			choice.probe->shape = *shape;
			choice.probe->own.reset();
			return;
		}
		choice.probe->own = own(probe::probeFromJson(from.value(), "", from.path()));
		choice.probe->shape = ProbeShape::own;
	}
	void operator()(PathChoice choice) const
	{
		if (!from.isString())
			choice.sweep->own = own(probe::pathFromJson(from.value(), "", from.path()));
		else if (const Status set = setPathKind(*choice.sweep, from.text()); !set)
			from.refuse(fmt::format("{}: {}", from.text(), set.error().message));
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

Nothing readDocument(const JsonReader& document, const std::vector<Section>& sections, const std::string& file)
{
	document.expectKeys(keysOf(sections, {"$schema", "version"}));
	const JsonReader version = document["version"];
	if (version.number() != kStateVersion)
		version.refuse(
		    fmt::format("this program knows version {} only; use the program that wrote the file", kStateVersion));
	for (const Section& section : sections)
		if (const auto part = document.find(section.key))
		{
			part->expectKeys(keysOf(section.settings));
			for (const Setting& setting : section.settings)
				if (const auto value = part->find(setting.key))
				{
					std::visit(Reader{file, *value}, setting.place);
					if (const std::string why = refusal(setting); !why.empty())
						value->refuse(why);
				}
		}
	return {};
}

json stateDocument(const ViewSpec& spec, const std::string& file)
{
	json document{{"version", kStateVersion}};
	// The places of the list are read only.
	for (const Section& section : sectionsOf(const_cast<ViewSpec&>(spec)))
		for (const Setting& setting : section.settings)
			if (json value = std::visit(Writer{file}, setting.place); !value.is_null())
				document[section.key][setting.key] = std::move(value);
	return document;
}

bool isUtf8(const json& value)
try
{
	(void)value.dump(); // looks at every text
	return true;
}
catch (const json::type_error&)
{
	return false;
}

// A name in another encoding would come back as that of another file.
Status refuseOtherEncodings(const json& document, const std::string& file)
{
	for (const auto& [section, settings] : document.items())
		for (const auto& [key, value] : settings.items())
			if (!isUtf8(value))
				return Error{ErrorKind::output,
				             fmt::format("{}: cannot keep /{}/{}, which is not UTF-8; rename the file, or "
				                         "write the text in UTF-8",
				                         file, section, key)};
	return Nothing{};
}

} // namespace

std::string stateText(const ViewSpec& spec, const std::string& file)
{
	return probe::jsonText(stateDocument(spec, file));
}

Status readState(ViewSpec& spec, std::string_view text, const std::string& file)
{
	const Result<json> document = probe::parseJson(text, file);
	if (!document)
		return document.error();
	ViewSpec read = spec;
	Result<Nothing> done = probe::readDocument<Nothing>(
	    *document, file, "", [&](const JsonReader& reader) { return readDocument(reader, sectionsOf(read), file); });
	if (done)
		spec = std::move(read);
	return done;
}

Status saveState(const ViewSpec& spec, const std::string& file)
{
	const json document = stateDocument(spec, file);
	if (Status fits = refuseOtherEncodings(document, file); !fits)
		return fits;
	Result<write::AtomicFile> out = write::AtomicFile::create(file, true);
	if (!out)
		return out.error();
	out->write(probe::jsonText(document));
	return out->commit();
}

Status loadState(ViewSpec& spec, const std::string& file)
{
	const Result<std::string> text = probe::readText(file, InputKind::state);
	return text ? readState(spec, *text, file) : text.error();
}

} // namespace vp::view
