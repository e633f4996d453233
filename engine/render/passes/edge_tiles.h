#pragma once

#include "gpu/buffer.h"
#include "shared/render_types.h"

#include <cstdint>

namespace vp::render
{

// Squares of shared::kEdgeTile pixels along a side.
constexpr std::uint32_t edgeTilesOver(std::uint32_t pixels)
{
	return (pixels + shared::kEdgeTile - 1) / shared::kEdgeTile;
}

// The squares of a picture in which its later samples are drawn: those that a pixel at an edge depends on.
class EdgeTiles
{
public:
	// Before recording, while no submission draws. reach: pixels around it that the color of a pixel depends on. The
	// picture has at most maxTexelBufferElements squares.
	Status prepare(gpu::Device& device, VkExtent2D extent, std::uint32_t reach);
	// Lists none of them; a transfer, to be seen by what lists them. What has used them is waited for.
	void recordEmpty(VkCommandBuffer commands) const;
	// After they were listed by a compute shader.
	static void recordListed(VkCommandBuffer commands);

	// All squares, row by row: not 0 where a pixel at an edge depends on the square.
	const gpu::Buffer& tiles() const { return tiles_; }
	VkBufferView texels() const { return texels_.handle(); }
	// A shared::TileList, and the numbers of its squares.
	const gpu::Buffer& listed() const { return listed_; }
	const shared::EdgePush& push() const { return push_; }
	std::uint32_t count() const { return push_.tiles_across * push_.tiles_down; }

private:
	gpu::Buffer tiles_;
	gpu::TexelView texels_;
	gpu::Buffer listed_;
	shared::EdgePush push_{};
};

} // namespace vp::render
