#pragma once

#include "dicom_frames.h"

#include <string>
#include <vector>

namespace vp::reader::volumes
{

// Frames of DICOM, sorted into volumes: one for each time, or whatever else tells frames in one place apart.
struct DicomSteps
{
	std::vector<std::vector<DicomFrame>> steps; // frames by depth
	std::vector<double> times; // the time of each step, in s or numbered from 0; empty for a single step
	bool are_seconds = false;
};

// Takes the largest stack if there are several, and tells so. Throws a Refusal for frames that are no stack of parallel
// pictures, or not equally many in each place.
DicomSteps stepsOf(DicomFrames& all);

} // namespace vp::reader::volumes
