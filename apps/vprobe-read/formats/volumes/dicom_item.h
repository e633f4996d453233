#pragma once

#include "vprobe-read/base/bytes.h"

#include <gdcmDataSet.h>
#include <gdcmTag.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::volumes
{

// Elements of a DICOM data set, or of an item of a sequence in it.
class DicomItem
{
public:
	explicit DicomItem(gdcm::DataSet data) : data_(std::move(data)) {}

	// Whether the element is there and has a value.
	bool has(const gdcm::Tag& tag) const;
	// All numbers of an element, written as text or in binary; none if it is missing or empty. A tag as a value is
	// group * 65536 + element. Throws a Refusal for text that is no number.
	std::vector<double> numbers(const gdcm::Tag& tag) const;
	// The first of them.
	std::optional<double> number(const gdcm::Tag& tag) const;
	// The same of an element that matters little: none if it is no finite number.
	std::optional<double> hint(const gdcm::Tag& tag) const;
	// Exactly `count` finite numbers, or none. Throws a Refusal if there are others.
	std::vector<double> exactly(std::size_t count, const gdcm::Tag& tag) const;
	// Without the blanks around it, and with ? for what is no plain character; empty if it is missing.
	std::string text(const gdcm::Tag& tag) const;
	// The bytes of the value, in the byte order of this machine; valid as long as the item.
	std::string_view bytes(const gdcm::Tag& tag) const;
	// The items of a sequence; none if it is missing.
	std::vector<DicomItem> items(const gdcm::Tag& tag) const;
	// The first of them.
	std::optional<DicomItem> item(const gdcm::Tag& tag) const;

	const gdcm::DataSet& data() const { return data_; }

private:
	const gdcm::DataElement* find(const gdcm::Tag& tag) const;

	gdcm::DataSet data_;
};

// As the standard's dictionary calls it.
std::string nameOf(const gdcm::Tag& tag);

// Numbers in the order of bytes of this machine. Bytes that are left over do not count.
template <class Number>
std::vector<double> numbersInBytes(std::string_view bytes)
{
	std::vector<double> numbers(bytes.size() / sizeof(Number));
	for (std::size_t i = 0; i < numbers.size(); ++i)
		numbers[i] = static_cast<double>(numberAt<Number>(bytes.data() + i * sizeof(Number)));
	return numbers;
}

} // namespace vp::reader::volumes
