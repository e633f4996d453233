#pragma once

#include "sample_files.h"

// Files of formats that vprobe reads by itself, written here after their published descriptions.
std::vector<SampleFile> ownSamples();
