#pragma once

#include "sample_files.h"

// PLOT3D files as Fortran and C programs write them; f is Density.
struct Plot3dForm
{
	bool binary = true;
	bool big_endian = false;
	bool byte_counts = false;
	bool multi_grid = false;
	bool doubles = false;
	bool blanking = false;
};

// Two blocks with multi_grid, one otherwise.
void writePlot3d(const std::string& grid, const std::string& solution, const Plot3dForm& form);

std::vector<SampleFile> plot3dSamples();
