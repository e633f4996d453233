#include "dicom_slice.h"

#include <gdcmAttribute.h>
#include <gdcmReader.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <sstream>

namespace
{

// What is asked for stands far in front.
constexpr std::size_t kHeadBytes = 256 << 10;

// Empty without the mark. GDCM reads old files without it as well, but takes many others for them.
std::string headOf(const std::string& file)
{
	std::ifstream in(file, std::ios::binary);
	std::string head(kHeadBytes, '\0');
	in.read(head.data(), static_cast<std::streamsize>(head.size()));
	head.resize(static_cast<std::size_t>(in.gcount()));
	return head.size() > 132 && head.compare(128, 4, "DICM") == 0 ? head : std::string();
}

// Whether the data have types where the header says so; GDCM never comes back from a file that has none. The header's
// first element says how long the rest of it is.
bool hasTypesAsSaid(std::string_view head)
{
	constexpr std::size_t kFirstEnd = 144;
	const auto syntax = head.find(std::string_view("\x02\x00\x10\x00UI", 6));
	if (head.size() < kFirstEnd || syntax == head.npos || head.size() - syntax < 8)
		return false;
	const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(head[at])); };
	const std::size_t length = byte(syntax + 6) | byte(syntax + 7) << 8;
	std::string_view name = head.substr(syntax + 8, length);
	while (!name.empty() && (name.back() == '\0' || name.back() == ' '))
		name.remove_suffix(1);
	if (name == "1.2.840.10008.1.2" || name == "1.2.840.10008.1.2.1.99")
		return true; // without types, or compressed
	const std::size_t data = kFirstEnd + (byte(140) | byte(141) << 8 | byte(142) << 16);
	return data + 6 <= head.size() && std::isupper(head[data + 4]) && std::isupper(head[data + 5]);
}

template <class Attribute>
Attribute attributeOf(const gdcm::DataSet& data)
{
	Attribute attribute = {};
	if (data.FindDataElement(attribute.GetTag()) && !data.GetDataElement(attribute.GetTag()).IsEmpty())
		attribute.SetFromDataElement(data.GetDataElement(attribute.GetTag()));
	return attribute;
}

} // namespace

double DicomSlice::depth() const
{
	const auto& a = axes;
	return origin[0] * (a[1] * a[5] - a[2] * a[4]) + origin[1] * (a[2] * a[3] - a[0] * a[5]) +
	       origin[2] * (a[0] * a[4] - a[1] * a[3]);
}

std::optional<DicomSlice> dicomSlice(const std::string& file)
{
	std::istringstream head(headOf(file));
	if (!hasTypesAsSaid(head.view()))
		return std::nullopt;
	gdcm::Reader reader;
	reader.SetStream(head);
	// The rows are the last that is asked for below; the pixels lie far behind.
	if (!reader.ReadUpToTag(gdcm::Tag(0x0028, 0x0010), std::set<gdcm::Tag>{}))
		return std::nullopt;
	const gdcm::DataSet& data = reader.GetFile().GetDataSet();
	if (attributeOf<gdcm::Attribute<0x0028, 0x0010>>(data).GetValue() == 0) // rows
		return std::nullopt;

	DicomSlice slice;
	slice.file = file;
	slice.series = attributeOf<gdcm::Attribute<0x0020, 0x000e>>(data).GetValue();
	const auto place = attributeOf<gdcm::Attribute<0x0020, 0x0032>>(data);
	const auto axes = attributeOf<gdcm::Attribute<0x0020, 0x0037>>(data);
	for (unsigned i = 0; i < 3 && data.FindDataElement(place.GetTag()); ++i)
		slice.origin[i] = place.GetValue(i);
	for (unsigned i = 0; i < 6 && data.FindDataElement(axes.GetTag()); ++i)
		slice.axes[i] = axes.GetValue(i);
	slice.number = attributeOf<gdcm::Attribute<0x0020, 0x0013>>(data).GetValue();
	if (data.FindDataElement(gdcm::Tag(0x0028, 0x0008)))
		slice.frames = std::max(1, attributeOf<gdcm::Attribute<0x0028, 0x0008>>(data).GetValue());
	return slice;
}
