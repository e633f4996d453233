#pragma once

#include "classify/gpu_classifier.h"
#include "classify/gpu_surfaces.h"

namespace vp::test
{

// All cells of a block, classified on the device and by this program's own loop in double.
struct SurfaceWords
{
	std::size_t cells = 0;
	std::size_t cut = 0;
	std::size_t walked = 0; // cells that only the device left open
};

// Expects that every code the device is sure of is that of the signs of the heights of the cell's points.
SurfaceWords classifyAllCells(classify::GpuBlocks& blocks, std::size_t block, const surface::Curved& surface);

} // namespace vp::test
