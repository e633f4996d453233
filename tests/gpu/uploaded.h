#pragma once

#include "classify/gpu_blocks.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace vp::test
{

inline std::unique_ptr<classify::GpuBlocks> upload(gpu::Device& device, const grid::BlockSet& set,
                                                   const classify::GpuBlocksOptions& options = {})
{
	auto made = classify::GpuBlocks::create(device, set, options);
	EXPECT_TRUE(made) << made.error().message;
	return std::move(*made);
}

} // namespace vp::test
