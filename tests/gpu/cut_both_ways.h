#pragma once

#include "classify/gpu_classifier.h"
#include "exhaustive.h"
#include "find/generations.h"
#include "probe/sheet.h"

#include <gtest/gtest.h>

#include <optional>
#include <span>
#include <vector>

namespace vp::test
{

// A block set cut by sheets with the GPU classifier and with the CPU's, from the same seeds.
struct CutBothWays
{
	std::vector<find::CellCut> gpu; // lane s * blocks + b is sheet s in block b
	std::vector<find::CellCut> cpu;
	std::vector<std::shared_ptr<classify::SheetRecords>> records; // per sheet
	std::size_t walked = 0;                                       // cells that only the GPU left to the walk
	std::size_t cells = 0;
	bool singles = false; // the device computed in floats
};

CutBothWays cutBothWays(classify::GpuBlocks& blocks, std::span<const probe::Sheet> sheets,
                        const std::optional<grid::FieldChoice>& field, Timeline* timeline = nullptr);

// Expects the same cells in the same order with the same codes, except for kCodeWalk.
void expectSameCells(const CutBothWays& cut);

// Every record of the GPU is the polygon of its cell, recomputed here in double, or empty where the cell is walked or
// not cut.
void expectRecords(const grid::BlockSet& blocks, std::span<const probe::Sheet> sheets,
                   const std::optional<grid::FieldChoice>& field, const CutBothWays& cut);

} // namespace vp::test
