#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "render/passes/picture_part.h"

#include <cstdint>
#include <vector>

namespace vp::render
{

// Values, and with mesh lines how much of one is at a pixel.
constexpr VkFormat layerFormat(bool mesh)
{
	return mesh ? VK_FORMAT_R32G32_SFLOAT : VK_FORMAT_R32_SFLOAT;
}
constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
constexpr VkFormat kPictureFormat = VK_FORMAT_R8G8B8A8_UNORM;

// Samples are summed by blending: in single precision where the device blends it, else in half, as every device does.
VkFormat sumFormat(gpu::Device& device);

// The images of one picture size: what is drawn into, summed up and handed out. Kept from picture to picture. All but
// the picture itself are as high as the part that is drawn at once.
class Targets
{
public:
	Targets() = default;
	// sum: whether samples are summed up for all pixels at once (ComposePass::record()).
	static Result<Targets> create(gpu::Device& device, const PicturePart& first, std::uint32_t layers, bool mesh,
	                              bool sum = false);
	~Targets();
	Targets(Targets&& other) noexcept { swap(other); }
	Targets& operator=(Targets&& other) noexcept
	{
		Targets taken(std::move(other));
		swap(taken);
		return *this;
	}

	bool holds(const PicturePart& part, std::uint32_t layers, bool mesh, bool sum) const;
	// Goes on to another part of the same size.
	void setFirstRow(std::uint32_t row) { part_.first_row = row; }
	const PicturePart& part() const { return part_; }
	VkExtent2D extent() const { return part_.extent; }
	VkImageView layer(std::size_t i) const { return layer_views_[i]; } // to draw into
	VkImageView layers() const { return layers_view_; }                // all, as an array
	// Copies the finished picture into an image of its size, or into `pixels`. The picture must be a source of copies.
	void recordCopy(VkCommandBuffer commands, const gpu::Image* into) const;
	// The picture's RGBA bytes as in a file, whose colors are not multiplied by alpha. After `pixels` was written and
	// waited for.
	std::vector<std::uint8_t> readPixels(bool is_opaque) const;

	gpu::Image values; // a layer a sheet
	gpu::Image lines;
	gpu::Image sum;     // where it is needed
	gpu::Image picture; // colors multiplied by alpha
	gpu::Buffer pixels; // the picture, for the host

private:
	void swap(Targets& other) noexcept;

	gpu::Device* device_ = nullptr;
	PicturePart part_;
	std::vector<VkImageView> layer_views_;
	VkImageView layers_view_ = VK_NULL_HANDLE;
};

// Viewport and scissor over the whole of an extent.
void coverAll(VkCommandBuffer commands, VkExtent2D extent);
// The same viewport, of which only a part is drawn.
void coverPart(VkCommandBuffer commands, VkExtent2D extent, const VkRect2D& part);

} // namespace vp::render
