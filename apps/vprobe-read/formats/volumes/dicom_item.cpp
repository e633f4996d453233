#include "dicom_item.h"

#include "vprobe-read/base/refusal.h"

#include "base/real_text.h"

#include <fmt/format.h>

#include <gdcmDict.h>
#include <gdcmDictEntry.h>
#include <gdcmDicts.h>
#include <gdcmGlobal.h>
#include <gdcmSequenceOfItems.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vp::reader::volumes
{

namespace
{

std::string_view withoutBlanks(std::string_view text)
{
	constexpr std::string_view blanks(" \0\t\r\n", 5);
	const auto first = text.find_first_not_of(blanks);
	if (first == text.npos)
		return {};
	return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Files may have text of any characters, or none at all; lines to the user have plain ones.
std::string printable(std::string_view text)
{
	std::string plain(text);
	std::replace_if(
	    plain.begin(), plain.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7f; }, '?');
	return plain;
}

std::vector<double> numbersInText(std::string_view text, const gdcm::Tag& tag)
{
	std::vector<double> numbers;
	while (!text.empty())
	{
		const auto end = std::min(text.find('\\'), text.size());
		const auto word = withoutBlanks(text.substr(0, end));
		const auto number = parseReal(word);
		if (!number)
			throw damaged(fmt::format("{} is \"{}\", which is no number", nameOf(tag), printable(word.substr(0, 32))));
		numbers.push_back(*number);
		text.remove_prefix(std::min(end + 1, text.size()));
	}
	return numbers;
}

// Pairs of group and element.
std::vector<double> tagsInBytes(std::string_view bytes)
{
	std::vector<double> tags;
	const auto halves = numbersInBytes<std::uint16_t>(bytes);
	for (std::size_t i = 0; i + 1 < halves.size(); i += 2)
		tags.push_back(halves[i] * 65536.0 + halves[i + 1]);
	return tags;
}

const gdcm::DictEntry& dictionaryEntry(const gdcm::Tag& tag)
{
	return gdcm::Global::GetInstance().GetDicts().GetPublicDict().GetDictEntry(tag);
}

} // namespace

std::string nameOf(const gdcm::Tag& tag)
{
	const char* name = dictionaryEntry(tag).GetKeyword();
	return name && *name ? name : fmt::format("({:04x},{:04x})", tag.GetGroup(), tag.GetElement());
}

const gdcm::DataElement* DicomItem::find(const gdcm::Tag& tag) const
{
	if (!data_.FindDataElement(tag))
		return nullptr;
	const gdcm::DataElement& element = data_.GetDataElement(tag);
	return element.IsEmpty() ? nullptr : &element;
}

bool DicomItem::has(const gdcm::Tag& tag) const
{
	return find(tag) != nullptr;
}

std::string_view DicomItem::bytes(const gdcm::Tag& tag) const
{
	const auto* element = find(tag);
	const gdcm::ByteValue* value = element ? element->GetByteValue() : nullptr;
	return value ? std::string_view(value->GetPointer(), value->GetLength()) : std::string_view();
}

std::string DicomItem::text(const gdcm::Tag& tag) const
{
	return printable(withoutBlanks(bytes(tag)));
}

std::vector<double> DicomItem::numbers(const gdcm::Tag& tag) const
{
	const auto* element = find(tag);
	if (!element)
		return {};
	gdcm::VR type = element->GetVR();
	if (type == gdcm::VR::INVALID || type == gdcm::VR::UN)
		type = dictionaryEntry(tag).GetVR(); // the file has no types
	switch (static_cast<gdcm::VR::VRType>(type))
	{
	case gdcm::VR::US:
	case gdcm::VR::US_SS:
	case gdcm::VR::US_OW:
	case gdcm::VR::US_SS_OW:
	case gdcm::VR::OW:
		return numbersInBytes<std::uint16_t>(bytes(tag));
	case gdcm::VR::SS:
		return numbersInBytes<std::int16_t>(bytes(tag));
	case gdcm::VR::UL:
		return numbersInBytes<std::uint32_t>(bytes(tag));
	case gdcm::VR::SL:
		return numbersInBytes<std::int32_t>(bytes(tag));
	case gdcm::VR::FL:
		return numbersInBytes<float>(bytes(tag));
	case gdcm::VR::FD:
		return numbersInBytes<double>(bytes(tag));
	case gdcm::VR::AT:
		return tagsInBytes(bytes(tag));
	default:
		return numbersInText(withoutBlanks(bytes(tag)), tag);
	}
}

std::optional<double> DicomItem::number(const gdcm::Tag& tag) const
{
	const auto all = numbers(tag);
	return all.empty() ? std::nullopt : std::optional(all[0]);
}

std::optional<double> DicomItem::hint(const gdcm::Tag& tag) const
{
	try
	{
		const auto first = number(tag);
		return first && std::isfinite(*first) ? first : std::nullopt;
	}
	catch (const Refusal&)
	{
		return std::nullopt;
	}
}

std::vector<double> DicomItem::exactly(std::size_t count, const gdcm::Tag& tag) const
{
	auto all = numbers(tag);
	if (!all.empty() && all.size() != count)
		throw damaged(fmt::format("{} has {} values where {} are wanted", nameOf(tag), all.size(), count));
	for (const double number : all)
		if (!std::isfinite(number))
			throw damaged(fmt::format("{} is not finite", nameOf(tag)));
	return all;
}

std::vector<DicomItem> DicomItem::items(const gdcm::Tag& tag) const
{
	std::vector<DicomItem> all;
	if (!data_.FindDataElement(tag))
		return all;
	const gdcm::SmartPointer<gdcm::SequenceOfItems> sequence = data_.GetDataElement(tag).GetValueAsSQ();
	if (!sequence)
		return all;
	for (gdcm::SequenceOfItems::SizeType i = 1; i <= sequence->GetNumberOfItems(); ++i)
		all.emplace_back(sequence->GetItem(i).GetNestedDataSet());
	return all;
}

std::optional<DicomItem> DicomItem::item(const gdcm::Tag& tag) const
{
	auto all = items(tag);
	return all.empty() ? std::nullopt : std::optional(std::move(all[0]));
}

} // namespace vp::reader::volumes
