#pragma once

#include "slice/gpu_blocks.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace vp::test
{

inline std::unique_ptr<slice::GpuBlocks> upload(gpu::Device& device, const grid::BlockSet& set,
                                                const slice::GpuBlocksOptions& options = {})
{
	auto made = slice::GpuBlocks::create(device, set, options);
	EXPECT_TRUE(made) << made.error().message;
	return std::move(*made);
}

} // namespace vp::test
