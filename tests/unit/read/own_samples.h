#pragma once

#include "sample_files.h"

// Files of formats that vprobe reads by itself, written here after their published descriptions.
std::vector<SampleFile> ownSamples();

// The same, of scanners and microscopes.
std::vector<SampleFile> scanSamples();

// The same, of codes for flow and structures, and of surveys.
std::vector<SampleFile> codeSamples();

// The same, of formats that are kept in HDF5, netCDF and Zarr.
std::vector<SampleFile> containerSamples();

// The same, of codes that refine by boxes.
std::vector<SampleFile> boxSamples();

// The same, of further codes for flow and fields.
std::vector<SampleFile> flowSamples();
