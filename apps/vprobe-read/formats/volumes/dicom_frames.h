#pragma once

#include "dicom_form.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vp::reader::volumes
{

class DicomItem;

// Tells frames apart that lie in the same place: by a time, an echo time, a direction of diffusion, ...
struct DicomKey
{
	std::string name;    // as it stands in a line to the user
	double number = 0.0; // one of these two is used
	std::string text;
	double seconds = 0.0; // in one unit of the number; 0: it has no unit of time
	bool is_time = false;
};

// A picture of a file: where it lies, and what its stored values stand for.
struct DicomFrame
{
	std::string file;
	std::size_t index = 0; // in its file
	DicomPixelForm form;
	bool has_place = false;
	std::array<double, 3> origin{0.0, 0.0, 0.0};              // mm, the center of its first pixel
	std::array<double, 6> axes{1.0, 0.0, 0.0, 0.0, 1.0, 0.0}; // directions of its rows and columns
	std::array<double, 2> spacing{1.0, 1.0};                  // mm, from column to column and from row to row
	double slope = 1.0;
	double intercept = 0.0;
	std::string stack;   // frames of one stack belong together; mostly empty
	double number = 0.0; // in its series, or in its file
	std::vector<DicomKey> keys;

	std::array<double, 3> normal() const;
	// Where it lies along the normal of its plane.
	double depth() const;
};

// The frames of one or more files, and what has to be told of them.
struct DicomFrames
{
	std::vector<DicomFrame> frames;
	std::vector<std::string> notes;                    // each once
	bool has_units = true;                             // whether places are in mm
	bool is_segmentation = false;                      // its first file is one
	std::optional<std::pair<double, double>> window{}; // rescaled values that its first file shows black and white

	void note(const std::string& line);
};

// Adds the frames of a file; root: its data set without the pixels. Throws a Refusal for frames that have no place.
void addFramesOf(const std::string& file, const DicomItem& root, DicomFrames& all);

} // namespace vp::reader::volumes
