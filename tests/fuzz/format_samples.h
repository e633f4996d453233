#pragma once

#include "sample_files.h"

// Of the formats that only the fuzzer writes: pieces of lattices, AMR, OpenFOAM, binary EnSight, polyhedra, curved
// cells. What they hold beside being readable is not told.
std::vector<SampleFile> formatSamples();

// Sets of some MiB, each of which takes seconds.
std::vector<SampleFile> largeSamples();
