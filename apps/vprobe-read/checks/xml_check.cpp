#include "xml_check.h"

#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/nesting.h"
#include "vprobe-read/base/refusal.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <new>
#include <string_view>

namespace vp::reader::checks
{

namespace
{

// Some writers leave line ends or a comment behind the closing tag.
constexpr std::size_t kTailBytes = 1024;

// Visits the values of an attribute wherever it stands in the text.
template <class Visit>
void forEachAttribute(std::string_view text, std::string_view name, Visit&& visit)
{
	const std::string start = fmt::format(" {}=\"", name);
	for (std::size_t at = text.find(start); at != text.npos; at = text.find(start, at))
	{
		at += start.size();
		const std::size_t end = text.find('"', at);
		if (end == text.npos)
			return;
		visit(text.substr(at, end - at));
	}
}

bool hasAttribute(std::string_view element, std::string_view name, std::string_view value)
{
	bool found = false;
	forEachAttribute(element, name, [&](std::string_view given) { found |= given == value; });
	return found;
}

std::string_view elementAt(std::string_view text, std::string_view start)
{
	const std::size_t at = text.find(start);
	return at == text.npos ? std::string_view() : text.substr(at, text.find('>', at) - at);
}

// The arrays behind <AppendedData encoding="raw">. Each starts with its size in bytes. A compressed array starts with
// the number of its blocks, their size, the size of the last one, and the compressed size of each.
class RawArrays
{
public:
	RawArrays(std::string_view bytes, std::string_view file_element)
	    : bytes_(bytes), word_bytes_(hasAttribute(file_element, "header_type", "UInt64") ? 8 : 4),
	      order_(byteOrder(hasAttribute(file_element, "byte_order", "BigEndian"))),
	      compressed_(file_element.find(" compressor=") != file_element.npos)
	{
	}

	bool holds(std::uint64_t offset) const
	{
		if (offset > bytes_.size())
			return false;
		std::string_view rest = bytes_.substr(offset);
		const std::uint64_t first = takeWord(rest);
		if (!compressed_)
			return first <= rest.size();
		takeWord(rest);
		takeWord(rest);
		if (first > rest.size() / word_bytes_)
			return false;
		std::uint64_t left = rest.size() - first * word_bytes_;
		for (std::uint64_t block = 0; block < first; ++block)
		{
			const std::uint64_t size = takeWord(rest);
			if (size > left)
				return false;
			left -= size;
		}
		return true;
	}

private:
	// Returns all ones past the end, which cannot be a size.
	std::uint64_t takeWord(std::string_view& from) const
	{
		if (from.size() < word_bytes_)
		{
			from = {};
			return ~std::uint64_t(0);
		}
		const std::uint64_t value = integerAt(from.data(), word_bytes_, order_);
		from.remove_prefix(word_bytes_);
		return value;
	}

	std::string_view bytes_;
	std::size_t word_bytes_;
	ByteOrder order_;
	bool compressed_;
};

void refuseShortAppendedData(std::string_view text)
{
	const std::size_t appended = text.find("<AppendedData");
	if (appended == text.npos)
		return;
	const std::string_view head = text.substr(0, appended);
	const std::string_view element = elementAt(text.substr(appended), "<AppendedData");
	const std::size_t start = text.find('_', appended + element.size());
	if (!hasAttribute(element, "encoding", "raw") || start == text.npos)
		return;
	const std::size_t end = std::max(text.rfind("</AppendedData"), start + 1);
	const RawArrays arrays(text.substr(start + 1, end - start - 1), elementAt(head, "<VTKFile"));
	forEachAttribute(head, "offset",
	                 [&](std::string_view value)
	                 {
		                 if (value.empty())
			                 return; // the data of this step are those of another
		                 std::uint64_t offset = ~std::uint64_t(0);
		                 std::from_chars(value.data(), value.data() + value.size(), offset);
		                 if (!arrays.holds(offset))
			                 throw damaged(fmt::format("the array at offset {} runs past the end", value));
	                 });
}

// Counts how deeply elements are nested. It uses the parser that VTK uses, so that both see the same elements. What
// cannot be parsed is VTK's to complain of.
class NestingCounter
{
public:
	bool isTooDeep(std::string_view text)
	{
		constexpr std::size_t kPiece = 64u << 20; // Expat counts bytes in an int
		if (!parser_)
			throw std::bad_alloc();
		XML_SetUserData(parser_.get(), this);
		XML_SetElementHandler(parser_.get(), onStart, onEnd);
		auto state = XML_STATUS_OK;
		for (std::size_t at = 0; state == XML_STATUS_OK && at < text.size(); at += kPiece)
		{
			const std::string_view piece = text.substr(at, kPiece);
			state = XML_Parse(parser_.get(), piece.data(), static_cast<int>(piece.size()), XML_FALSE);
		}
		return depth_ > kMaxNestedElements;
	}

private:
	static void onStart(void* self, const XML_Char* name, const XML_Char**)
	{
		auto& counter = *static_cast<NestingCounter*>(self);
		// Appended data need not be XML, and VTK's parser ends there.
		if (++counter.depth_ > kMaxNestedElements || std::string_view(name) == "AppendedData")
			XML_StopParser(counter.parser_.get(), XML_FALSE);
	}
	static void onEnd(void* self, const XML_Char*) { --static_cast<NestingCounter*>(self)->depth_; }

	std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_{XML_ParserCreate(nullptr), XML_ParserFree};
	int depth_ = 0;
};

void refuseDeep(std::string_view text)
{
	if (NestingCounter().isTooDeep(text))
		throw damaged(fmt::format("its XML elements are nested more than {} deep", kMaxNestedElements));
}

void refuseShort(std::string_view text, const std::string& file)
{
	const std::string_view tail = text.substr(text.size() - std::min(text.size(), kTailBytes));
	if (tail.find("</VTKFile") == tail.npos)
		throw damaged(fmt::format("{} ends without </VTKFile>", std::filesystem::path(file).filename().string()));
	refuseShortAppendedData(text);
	refuseDeep(text);
}

bool isIndexOfPieces(std::string_view text)
{
	return elementAt(text, "<VTKFile").find("\"P") != std::string_view::npos;
}

} // namespace

void refuseShortXml(const std::string& file)
{
	const MappedText mapped(file);
	refuseShort(mapped.text(), file);
	if (!isIndexOfPieces(mapped.text()))
		return;
	forEachAttribute(mapped.text(), "Source",
	                 [&](std::string_view piece)
	                 {
		                 const std::string path = (std::filesystem::path(file).parent_path() / piece).string();
		                 const MappedText text(path);
		                 // A piece must not be an index itself, so that there can be no circle.
		                 if (isIndexOfPieces(text.text()))
			                 throw damaged("one of its pieces is an index of pieces");
		                 refuseShort(text.text(), path);
	                 });
}

void refuseDeepXml(const std::string& file)
{
	refuseDeep(MappedText(file).text());
}

} // namespace vp::reader::checks
