#pragma once

#include <array>
#include <optional>
#include <string>

// What a DICOM file says of its place in a series, without its pixels.
struct DicomSlice
{
	std::string file;
	std::string series; // its unique id
	std::array<double, 3> origin{0.0, 0.0, 0.0};
	std::array<double, 6> axes{1.0, 0.0, 0.0, 0.0, 1.0, 0.0}; // of its rows and columns
	int number = 0;                                           // in its series
	int frames = 1;

	// Where it lies along the normal of its plane.
	double depth() const;
};

// Null for a file that is no DICOM image.
std::optional<DicomSlice> dicomSlice(const std::string& file);
