#pragma once

#include "exhaustive.h"
#include "probe/sheet.h"
#include "slice/gpu_classifier.h"
#include "traverse/bfs.h"

#include <gtest/gtest.h>

#include <optional>
#include <span>
#include <vector>

namespace vp::test
{

// A block set cut by sheets with the GPU classifier and with the CPU's, from the same seeds.
struct CutBothWays
{
	std::vector<traverse::LaneCut> gpu; // lane s * blocks + b is sheet s in block b
	std::vector<traverse::LaneCut> cpu;
	std::vector<std::shared_ptr<slice::SheetRecords>> records; // per sheet
	std::size_t walked = 0;                                    // cells that only the GPU left to the walk
	std::size_t cells = 0;
};

CutBothWays cutBothWays(slice::GpuBlocks& blocks, std::span<const probe::Sheet> sheets,
                        const std::optional<slice::FieldChoice>& field, Timeline* timeline = nullptr);

// The same cells in the same order with the same words, but for kWordWalk.
void expectSameCells(const CutBothWays& cut);

// Every record of the GPU is the polygon of its cell, recomputed here in double, or empty where the cell is walked or
// not cut. singles: the device computed in floats.
void expectRecords(const grid::BlockSet& blocks, std::span<const probe::Sheet> sheets,
                   const std::optional<slice::FieldChoice>& field, const CutBothWays& cut, bool singles = false);

} // namespace vp::test
