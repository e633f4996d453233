#include "foam_text.h"

#include "foam_cursor.h"
#include "refusal.h"

#include <fmt/format.h>

#include <utility>

namespace
{

constexpr std::string_view kHeadName = "FoamFile";

// Hands each name of a dictionary to `read`, up to its closing brace or the end. `read` takes the value, or returns
// false and takes nothing.
template <class Read>
void eachEntry(FoamCursor& at, const Read& read)
{
	while (at.peek() != 0 && at.peek() != '}')
	{
		const bool is_pattern = at.peek() == '"';
		const std::string_view name = at.word();
		if (name.starts_with("#"))
			at.skipLine();
		else if (name != ";" && (is_pattern || !read(name)))
			at.skipValue();
	}
}

int bytesOf(std::string_view arch, std::string_view name, int otherwise)
{
	const std::size_t found = arch.find(name);
	if (found == arch.npos || found + name.size() + 2 > arch.size())
		return otherwise;
	const std::string_view bits = arch.substr(found + name.size(), 2);
	return bits == "64" ? 8 : bits == "32" ? 4 : otherwise;
}

FoamHead readHead(FoamCursor& at)
{
	FoamHead head;
	if (at.word() != kHeadName)
		throw damaged("it does not begin with FoamFile");
	at.expect('{');
	eachEntry(at,
	          [&](std::string_view name)
	          {
		          if (name != "format" && name != "class" && name != "object" && name != "arch")
			          return false;
		          const std::string value(at.word());
		          if (name == "format")
			          head.is_binary = value == "binary";
		          else if (name == "class")
			          head.type = value;
		          else if (name == "object")
			          head.object = value;
		          else
		          {
			          if (value.starts_with("MSB"))
				          throw damaged("its bytes are in the other order");
			          head.label_bytes = bytesOf(value, "label=", head.label_bytes);
			          head.scalar_bytes = bytesOf(value, "scalar=", head.scalar_bytes);
		          }
		          at.skipValue();
		          return true;
	          });
	at.expect('}');
	at.setHead(head);
	return head;
}

int componentsOfField(std::string_view type)
{
	for (const std::string_view kind : {"vol", "point"})
		if (type.starts_with(kind))
		{
			std::string_view rest = type.substr(kind.size());
			rest = rest.substr(0, rest.find("Field"));
			if (rest.empty())
				return 0;
			std::string name(rest);
			name[0] = static_cast<char>(name[0] - 'A' + 'a');
			return foamComponents(name);
		}
	return 0;
}

// The value of an entry with its semicolon; none, and nothing but a word taken, where it is none that is read here.
std::optional<FoamList> readValue(FoamCursor& at, int components)
{
	const std::string_view word = at.word();
	FoamList list = {components, true, {}};
	if (word == "uniform")
		at.element(components, list.numbers);
	else if (word == "nonuniform")
	{
		const char next = at.peek();
		if (next < '0' || next > '9')
		{
			const std::string_view type = at.word();
			if (!type.starts_with("List<") || foamComponents(type.substr(5, type.find('>') - 5)) != components)
				throw damaged(fmt::format("it has a {} where a list is wanted", type.substr(0, 40)));
		}
		list = at.reals(components);
	}
	else if (word == ";" || word == "{" || word == "(")
		throw damaged("a value is not understood");
	else
		return std::nullopt;
	at.expect(';');
	return list;
}

void readPatch(FoamCursor& at, int components, const std::string& name, FoamField& field)
{
	std::optional<FoamList> value;
	bool has_words = false; // that are not read here
	at.expect('{');
	eachEntry(at,
	          [&](std::string_view key)
	          {
		          if (key.starts_with("$"))
			          has_words = true;
		          if (key == "type" && at.peek() == 'u')
			          has_words |= at.word() == "uniformFixedValue";
		          if (key != "value")
			          return false;
		          value = readValue(at, components);
		          has_words |= !value;
		          return value.has_value();
	          });
	at.expect('}');
	if (value || !has_words)
		field.patches[name] = std::move(value);
}

} // namespace

FoamHead foamHead(std::string_view text)
{
	FoamCursor at(text);
	return readHead(at);
}

FoamList foamPoints(std::string_view text)
{
	FoamCursor at(text);
	readHead(at);
	return at.reals(3);
}

FoamField foamField(std::string_view text)
{
	FoamCursor at(text);
	const int components = componentsOfField(readHead(at).type);
	if (components == 0)
		throw damaged("it is no field of cells or points");
	FoamField field;
	bool has_inside = false;
	eachEntry(at,
	          [&](std::string_view key)
	          {
		          if (key == "internalField" || (key == "value" && !has_inside))
		          {
			          std::optional<FoamList> inside = readValue(at, components);
			          has_inside |= inside.has_value();
			          if (inside)
				          field.inside = std::move(*inside);
			          return inside.has_value();
		          }
		          if (key != "boundaryField" || !at.take('{'))
			          return false;
		          eachEntry(at,
		                    [&](std::string_view patch)
		                    {
			                    if (at.peek() != '{')
				                    return false;
			                    readPatch(at, components, std::string(patch), field);
			                    return true;
		                    });
		          at.expect('}');
		          return true;
	          });
	if (!has_inside)
		throw damaged("it has no internalField that is read here");
	return field;
}

FoamFaces foamFaces(std::string_view text)
{
	FoamCursor at(text);
	const FoamHead head = readHead(at);
	const bool is_compact = head.type == "faceCompactList";
	return at.faces(is_compact);
}

std::vector<std::int64_t> foamLabels(std::string_view text)
{
	FoamCursor at(text);
	readHead(at);
	return at.labels();
}

std::vector<FoamPatch> foamPatches(std::string_view text)
{
	FoamCursor at(text);
	readHead(at);
	std::vector<FoamPatch> patches;
	at.integer();
	at.expect('(');
	while (at.peek() != ')')
	{
		FoamPatch patch;
		patch.name = at.word();
		at.expect('{');
		eachEntry(at,
		          [&](std::string_view key)
		          {
			          if (key == "type")
				          patch.type = at.word();
			          else if (key == "nFaces")
				          patch.faces = at.integer();
			          else if (key == "startFace")
				          patch.first = at.integer();
			          else
				          return false;
			          at.skipValue();
			          return true;
		          });
		at.expect('}');
		if (patch.first < 0 || patch.faces < 0)
			throw damaged("a patch has fewer than no faces");
		patches.push_back(std::move(patch));
	}
	return patches;
}
