#pragma once

#include "vprobe-read/base/request.h"
#include "vprobe-read/text/xml_tree.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

class vtkDataArray;

namespace vp::reader::meshes
{

// The values of a DataItem, and its sides, the slowest first.
struct XdmfValues
{
	vtkSmartPointer<vtkDataArray> array; // has one component
	std::vector<std::uint64_t> sides;

	std::uint64_t count() const;
};

// The XML of an XDMF file and what it names: other elements of itself, and data in HDF5 and binary files beside it.
class XdmfDocument
{
public:
	// `text` must outlive the document.
	XdmfDocument(std::string file, std::string_view text);

	const text::XmlElement& root() const { return xml_.root; }

	// The elements of this name in another, also where that takes them over from a grid elsewhere (xi:include).
	std::vector<const text::XmlElement*> children(const text::XmlElement& of, std::string_view name) const;
	// The first of them; null if there is none.
	const text::XmlElement* child(const text::XmlElement& of, std::string_view name) const;

	// Whether another grid takes over parts of this one.
	bool isTakenOver(const text::XmlElement& grid) const;

	// The values of a DataItem. Throws a Refusal for one that is damaged or not read.
	XdmfValues values(const text::XmlElement& item) const;
	// The values of a DataItem for each of so many points or cells of a lattice (x first) as an array that stays in its
	// file, if the request lets it. Null for one that cannot stay there.
	vtkSmartPointer<vtkDataArray> storedValues(const text::XmlElement& item, const std::array<std::uint32_t, 3>& points,
	                                           const std::string& name, const Request& request) const;

private:
	struct Item;
	Item itemOf(const text::XmlElement& element) const;
	std::string pathOf(std::string_view name) const; // names are relative to the folder of this file
	const text::XmlElement& resolved(const text::XmlElement& element) const;
	const text::XmlElement* atPath(std::string_view path) const;
	void collectTakenOver(const text::XmlElement& from);
	const text::XmlElement* includedGrid(const text::XmlElement& include) const;
	std::string_view contents(const text::XmlElement& element) const;

	std::string file_;
	std::string_view text_;
	text::XmlFile xml_;
	std::set<const text::XmlElement*> taken_over_;
};

// Numbers between blanks or commas.
std::vector<double> xdmfNumbers(std::string_view text);

} // namespace vp::reader::meshes
