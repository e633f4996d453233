#pragma once

#include <optional>
#include <string>

namespace vp::reader::volumes
{

// What a DICOM file says of its series, from its first bytes.
struct DicomSlice
{
	std::string file;
	std::string series; // its unique id, or that of the image of which it is a part
	int frames = 1;
	bool is_part = false; // of an image of many frames that was split into files
	int parts = 0;        // how many these are, if the file says so
};

// Null for a file that is no DICOM image.
std::optional<DicomSlice> dicomSlice(const std::string& file);

} // namespace vp::reader::volumes
