#pragma once

#include "dicom_frames.h"

#include <vector>

namespace vp::reader::volumes
{

class DicomItem;

// Where the frames lie of a file whose frames have no positions of their own (RT dose, nuclear medicine, secondary
// captures): each along the normal of the first one, in mm from the file's position. Keys of nuclear medicine are added
// to the frames. Throws a Refusal where the frames are no slices.
std::vector<double> frameOffsets(const DicomItem& root, DicomFrames& all, std::vector<DicomFrame>& frames);

} // namespace vp::reader::volumes
