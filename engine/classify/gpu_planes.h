#pragma once

#include "base/result.h"
#include "classify/gpu_sheet_in_block.h"
#include "grid/field_choice.h"
#include "probe/sheet.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vp::classify
{

/// Planes that the device classifies. It decides each cell, looks up its case and writes its polygon to the records of
/// the sheet.
struct PlanesOnGpu
{
	std::vector<GpuSheetInBlock> sheets;                // sheet s in block b: number s * blocks + b
	std::vector<std::shared_ptr<SheetRecords>> records; // per sheet
};

/// fields: one for each sheet. Uploads the arrays that are not on the device yet.
Result<PlanesOnGpu> planesOnGpu(GpuBlocks& blocks, std::span<const probe::Sheet> sheets,
                                std::span<const std::optional<grid::FieldChoice>> fields);

} // namespace vp::classify
