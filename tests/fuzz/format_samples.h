#pragma once

#include "sample_files.h"

// Samples of the formats that only the fuzzer writes: pieces of lattices, AMR, OpenFOAM, binary EnSight, polyhedra,
// curved cells. They need only be readable.
std::vector<SampleFile> formatSamples();

// Sets of some MiB, each of which takes seconds.
std::vector<SampleFile> largeSamples();
