#pragma once

#include "grid/field.h"
#include "write/slice_table.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::write
{

// An array of a VTK XML file. The memory of its values stays the caller's.
struct XmlArray
{
	std::string name;                     // as it stands in the file: escaped by xmlText()
	std::optional<grid::NumberType> type; // none: texts, each ended by a zero byte
	int components = 1;
	std::span<const std::byte> bytes;

	std::size_t tuples() const;
};

template <class Values>
XmlArray xmlArray(std::string name, grid::NumberType type, int components, const Values& values)
{
	return {std::move(name), type, components, std::as_bytes(std::span(values))};
}

// `texts` as joinTexts() gives them.
XmlArray xmlTexts(std::string name, std::string_view texts);

template <class Texts>
std::string joinTexts(const Texts& texts)
{
	std::string joined;
	for (const std::string_view text : texts)
		joined.append(text) += '\0';
	return joined;
}

// The arrays of one set: points, cells or the file. No two have the same name.
class XmlArrays
{
public:
	// Takes the place of an array that has this name already: a reader finds one of them only.
	void add(XmlArray array);
	// Gives the columns names that differ, also where they become alike as text of a file.
	void add(std::span<const Column> columns);

	bool empty() const { return arrays_.empty(); }
	auto begin() const { return arrays_.begin(); }
	auto end() const { return arrays_.end(); }

private:
	std::vector<XmlArray> arrays_;
};

// Least and greatest value, or length of vectors, without NaN. Nothing for texts, and where no value is a number: VTK's
// writer has its own limits of numbers there, which a reader takes for values.
std::optional<std::pair<double, double>> valueRange(const XmlArray& array);

} // namespace vp::write
