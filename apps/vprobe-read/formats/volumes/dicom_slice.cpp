#include "dicom_slice.h"

#include "dicom_item.h"
#include "vprobe-read/base/bytes.h"

#include <gdcmReader.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>

namespace vp::reader::volumes
{

namespace
{

// All that is asked for stands far in front.
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

// Whether the elements of the header (group 2) are what the standard has there, each within the file. GDCM ends the
// program at others.
bool hasSoundHeader(std::string_view head)
{
	const auto number = [&](std::size_t at, std::size_t bytes) { return integerAt(head.data() + at, bytes); };
	std::size_t at = 132;
	while (head.size() - at >= 12 && number(at, 2) == 2)
	{
		const std::string_view type = head.substr(at + 4, 2);
		if (!std::isupper(static_cast<unsigned char>(type[0])) || !std::isupper(static_cast<unsigned char>(type[1])))
			return false;
		const bool is_long = type == "OB" || type == "OW" || type == "UN" || type == "UT" || type == "SQ";
		const std::size_t length = is_long ? number(at + 8, 4) : number(at + 6, 2);
		at += is_long ? 12 : 8;
		if (length > head.size() - at)
			return false;
		at += length;
	}
	return true;
}

// Whether the data have types where the header says so; GDCM never comes back from a file that has none. The header's
// first element says how long the rest of it is.
bool hasTypesAsSaid(std::string_view head)
{
	constexpr std::size_t kFirstEnd = 144;
	const auto syntax = head.find(std::string_view("\x02\x00\x10\x00UI", 6));
	if (head.size() < kFirstEnd || syntax == head.npos || head.size() - syntax < 8)
		return false;
	std::string_view name = head.substr(syntax + 8, integerAt(head.data() + syntax + 6, 2));
	while (!name.empty() && (name.back() == '\0' || name.back() == ' '))
		name.remove_suffix(1);
	if (name == "1.2.840.10008.1.2" || name == "1.2.840.10008.1.2.1.99")
		return true; // without types, or compressed
	const std::size_t data = kFirstEnd + integerAt(head.data() + 140, 3);
	return data + 6 <= head.size() && std::isupper(head[data + 4]) && std::isupper(head[data + 5]);
}

} // namespace

std::optional<DicomSlice> dicomSlice(const std::string& file)
{
	std::istringstream head(headOf(file));
	if (head.view().empty() || !hasSoundHeader(head.view()) || !hasTypesAsSaid(head.view()))
		return std::nullopt;
	gdcm::Reader reader;
	reader.SetStream(head);
	// The rows are the last that is asked for below; the pixels lie far behind.
	// GDCM may say that it failed where it stopped within deflated data; the rows tell.
	reader.ReadUpToTag(gdcm::Tag(0x0028, 0x0010), std::set<gdcm::Tag>{});
	const DicomItem root(reader.GetFile().GetDataSet());
	if (root.hint(gdcm::Tag(0x0028, 0x0010)).value_or(0.0) == 0.0) // rows
		return std::nullopt;

	DicomSlice slice;
	slice.file = file;
	slice.parts = static_cast<int>(std::clamp(root.hint(gdcm::Tag(0x0020, 0x9163)).value_or(0.0), 0.0, 1e6));
	slice.series = root.text(gdcm::Tag(0x0020, 0x9161));
	slice.is_part = !slice.series.empty() && slice.parts != 1;
	if (!slice.is_part)
		slice.series = root.text(gdcm::Tag(0x0020, 0x000e));
	slice.frames = static_cast<int>(std::clamp(root.hint(gdcm::Tag(0x0028, 0x0008)).value_or(1.0), 1.0, 1e9));
	return slice;
}

} // namespace vp::reader::volumes
