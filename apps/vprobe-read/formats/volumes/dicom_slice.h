#pragma once

#include <optional>
#include <string>

namespace vp::reader::volumes
{

// Holds the facts that a DICOM file gives about its series in its first bytes.
struct DicomSlice
{
	std::string file;
	std::string series; // its unique id, or that of the image of which it is a part
	int frames = 1;
	bool is_part = false; // an image of many frames was split into files
	int parts = 0;        // how many these are, if the file says so
};

// Null for a file that is no DICOM image.
std::optional<DicomSlice> dicomSlice(const std::string& file);

} // namespace vp::reader::volumes
