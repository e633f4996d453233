#pragma once

#include "dicom_frames.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkDataSet;

namespace vp::reader::volumes
{

// The grid of parallel frames in the order of their depth, at least two, without values: an image where they are as far
// apart from each other, a rectilinear or curvilinear grid where they are not. Throws a Refusal where files of one
// picture are unevenly far apart, since one may be missing, and where frames lie on no line.
vtkSmartPointer<vtkDataSet> gridOfFrames(const std::vector<DicomFrame>& frames);

} // namespace vp::reader::volumes
