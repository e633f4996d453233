#pragma once

#include "sample_files.h"

// Files that name others, and volumes of NRRD and NIfTI.
std::vector<SampleFile> moreSamples(const std::vector<SampleFile>& pieces);
