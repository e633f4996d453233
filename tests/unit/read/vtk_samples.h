#pragma once

#include "sample_files.h"

// Files of VTK's own formats, MetaImage and Exodus, written by VTK.
std::vector<SampleFile> vtkSamples();
