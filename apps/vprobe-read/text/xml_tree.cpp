#include "xml_tree.h"

#include "vprobe-read/base/refusal.h"

#include <expat.h>

#include <algorithm>
#include <memory>

namespace vp::reader::text
{

namespace
{

constexpr std::size_t kMaxXmlDepth = 16;
constexpr std::size_t kMaxElements = 1 << 18;
constexpr std::size_t kMaxElementBytes = 64u << 20;

// The elements of a file without the long texts between them, and where each rest of it came from.
class Abridged
{
public:
	Abridged(std::string_view text, bool is_whole)
	{
		if (is_whole)
			take(text, 0, text.size());
		for (std::size_t at = is_whole ? text.size() : 0; at < text.size();)
		{
			const std::size_t tag = std::min(text.find('<', at), text.size());
			if (tag - at > kMaxShortText)
				at = tag;
			const std::size_t end = std::min(text.find('>', tag), text.size() - 1) + 1;
			take(text, at, std::max(end, tag));
			at = std::max(end, tag);
		}
	}

	const std::string& text() const { return text_; }
	void append(std::string_view words) { text_ += words; }
	std::uint64_t placeOf(std::uint64_t at) const
	{
		const auto above = std::upper_bound(cuts_.begin(), cuts_.end(), at,
		                                    [](std::uint64_t wanted, const Cut& cut) { return wanted < cut.at; });
		return above == cuts_.begin() ? at : above[-1].place + (at - above[-1].at);
	}

private:
	struct Cut
	{
		std::uint64_t at;    // in the abridged text
		std::uint64_t place; // in the file
	};
	void take(std::string_view text, std::size_t begin, std::size_t end)
	{
		if (begin != taken_)
			cuts_.push_back({text_.size(), begin});
		text_ += text.substr(begin, end - begin);
		taken_ = end;
	}

	std::string text_;
	std::vector<Cut> cuts_;
	std::size_t taken_ = 0;
};

// The place of the current event in the text, -1 on an error, and its length. Expat 2.9 deprecates the functions that
// all versions have.
std::int64_t byteIndex(XML_Parser parser)
{
#if XML_MAJOR_VERSION * 100 + XML_MINOR_VERSION >= 209
	return XML_GetCurrentByteIndex64(parser);
#else
	return XML_GetCurrentByteIndex(parser);
#endif
}
std::uint64_t byteCount(XML_Parser parser)
{
#if XML_MAJOR_VERSION * 100 + XML_MINOR_VERSION >= 209
	return XML_GetCurrentByteCount64(parser);
#else
	return static_cast<std::uint64_t>(XML_GetCurrentByteCount(parser));
#endif
}

class TreeBuilder
{
public:
	// is_whole: whether entities are expanded, and all texts kept.
	TreeBuilder(const Abridged& text, bool is_whole)
	    : text_(text), is_whole_(is_whole), parser_(XML_ParserCreate(nullptr), XML_ParserFree)
	{
	}

	bool build(XmlElement& root)
	{
		if (!parser_)
			throw std::bad_alloc();
		path_ = {&root};
		XML_SetUserData(parser_.get(), this);
		XML_SetElementHandler(parser_.get(), onStart, onEnd);
		XML_SetCharacterDataHandler(parser_.get(), onText);
		if (is_whole_)
		{
			XML_SetExternalEntityRefHandler(parser_.get(), onExternalEntity);
			XML_SetSkippedEntityHandler(parser_.get(), onSkippedEntity);
		}
		else
			XML_SetStartDoctypeDeclHandler(parser_.get(), onDoctype);
		const std::string& text = text_.text();
		const auto done = XML_Parse(parser_.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
		if (!foreign_entity_.empty())
			throw Refusal("refers to " + foreign_entity_ +
			              " of another file, which is never opened; put it into this one");
		return done == XML_STATUS_OK;
	}

private:
	std::uint64_t place() const
	{
		return static_cast<std::uint64_t>(std::max<std::int64_t>(byteIndex(parser_.get()), 0));
	}
	void stop() { XML_StopParser(parser_.get(), XML_FALSE); }

	static void onStart(void* self, const XML_Char* name, const XML_Char** attributes)
	{
		auto& builder = *static_cast<TreeBuilder*>(self);
		if (builder.path_.size() > kMaxXmlDepth || ++builder.elements_ > kMaxElements)
			return builder.stop();
		// A parent's list grows only while none of its children is open, so the pointers in the path hold.
		XmlElement& element = builder.path_.back()->children.emplace_back();
		element.name = name;
		for (; attributes[0]; attributes += 2)
			element.attributes.emplace_back(attributes[0], attributes[1]);
		const auto tag_bytes = byteCount(builder.parser_.get());
		// The text behind a tag may have been left out, so the place is that of the tag's last byte and one more.
		// Within an entity, the place is that of the reference to it.
		element.is_from_entity = builder.text_.text()[builder.place()] != '<';
		element.content_begin = builder.text_.placeOf(builder.place() + std::max<std::uint64_t>(tag_bytes, 1) - 1) + 1;
		builder.path_.push_back(&element);
	}
	static void onEnd(void* self, const XML_Char*)
	{
		auto& builder = *static_cast<TreeBuilder*>(self);
		builder.path_.back()->content_end = builder.text_.placeOf(builder.place());
		builder.path_.pop_back();
	}
	static void onText(void* self, const XML_Char* text, int size)
	{
		auto& builder = *static_cast<TreeBuilder*>(self);
		std::string& kept = builder.path_.back()->text;
		const auto bytes = static_cast<std::size_t>(size);
		if (builder.is_whole_ && (builder.kept_bytes_ += bytes) > kMaxElementBytes)
			return builder.stop();
		if (builder.is_whole_ || kept.size() < kMaxShortText)
			kept.append(text, bytes);
	}
	static int onExternalEntity(XML_Parser parser, const XML_Char*, const XML_Char*, const XML_Char*, const XML_Char*)
	{
		static_cast<TreeBuilder*>(XML_GetUserData(parser))->foreign_entity_ = "an entity";
		return XML_STATUS_ERROR;
	}
	static void onSkippedEntity(void* self, const XML_Char* name, int)
	{
		auto& builder = *static_cast<TreeBuilder*>(self);
		builder.foreign_entity_ = "the entity " + std::string(name).substr(0, 80);
		builder.stop();
	}
	static void onDoctype(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int)
	{
		static_cast<TreeBuilder*>(self)->stop();
	}

	const Abridged& text_;
	bool is_whole_;
	std::size_t kept_bytes_ = 0;
	std::string foreign_entity_;
	std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
	std::vector<XmlElement*> path_;
	std::size_t elements_ = 0;
};

} // namespace

std::string_view XmlElement::attribute(std::string_view wanted) const
{
	for (const auto& [key, value] : attributes)
		if (key == wanted)
			return value;
	return {};
}

bool XmlElement::has(std::string_view wanted) const
{
	return std::any_of(attributes.begin(), attributes.end(), [&](const auto& each) { return each.first == wanted; });
}

std::optional<XmlFile> parseXml(std::string_view text, DocumentType type)
{
	XmlFile file;
	// Appended data need not be XML. VTK's parser also stops at the first such tag.
	const std::size_t appended = text.find("<AppendedData");
	std::string_view elements = text;
	if (appended != text.npos)
	{
		const std::size_t tag_end = text.find('>', appended);
		const std::size_t mark = tag_end == text.npos ? text.npos : text.find('_', tag_end);
		const std::size_t end = text.rfind("</AppendedData");
		if (mark == text.npos || end == text.npos || end <= mark)
			return std::nullopt;
		elements = text.substr(0, tag_end + 1);
		file.appended_begin = mark + 1;
		file.appended_end = end;
	}
	const bool is_whole = type == DocumentType::internal && elements.find("<!DOCTYPE") != elements.npos;
	if (is_whole && elements.size() > kMaxElementBytes)
		return std::nullopt;
	Abridged abridged(elements, is_whole);
	if (appended != text.npos)
		abridged.append("</AppendedData></VTKFile>");
	if (abridged.text().size() > kMaxElementBytes)
		return std::nullopt;
	XmlElement top;
	if (!TreeBuilder(abridged, is_whole).build(top) || top.children.size() != 1)
		return std::nullopt;
	file.root = std::move(top.children.front());
	if (appended != text.npos)
	{
		const XmlElement& last = file.root.children.back();
		if (last.name != "AppendedData")
			return std::nullopt;
		file.appended_encoding = last.attribute("encoding");
	}
	return file;
}

} // namespace vp::reader::text
