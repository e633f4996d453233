#pragma once

#include "base/result.h"
#include "render/passes/fragment_lists.h"
#include "render/picture.h"
#include "render/scene/scene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace vp
{
class Timeline;
}
namespace vp::gpu
{
class Device;
class Image;
} // namespace vp::gpu

namespace vp::render
{

// Draws scenes without a window. Holds the pipelines and the images of the last size. One thread at a time.
class Renderer
{
public:
	// The device outlives it. most_fragment_bytes: what the lists of surface fragments may take; a picture that needs
	// more is drawn in strips. raster_side: sheets' polygons of up to so many pixels (at most shared::kMaxRasterSide)
	// are drawn by a compute shader, others by the hardware's rasterizer; 0: all by the latter; unset: as suits the
	// device.
	static Result<Renderer> create(gpu::Device& device, std::uint64_t most_fragment_bytes = kMaxFragmentBytes,
	                               std::optional<std::uint32_t> raster_side = {});
	~Renderer();
	Renderer(Renderer&&) noexcept;
	Renderer& operator=(Renderer&&) noexcept;

	// Each sheet into a layer of values, surfaces into lists of fragments, layers, lists and outline into colors, the
	// overlay over them. Section "draw" with "prepare", "wait" and "pixels" in it, and GPU sections "layers",
	// "surfaces" (where there are any), "compose", "overlay" and "copy" on the timeline, where there is one. More
	// sheets than shared::kMaxLayers or surfaces than shared::kMaxSurfaces are a usage error.
	Result<Picture> draw(const Scene& scene, Timeline* timeline = nullptr);

	// The same into an image of the scene's size and kPictureFormat that nothing submitted still uses, made with
	// TRANSFER_DST usage; it is left as gpu::kCopyFrom. Colors are multiplied by alpha. Each sample is submitted by
	// itself, so that a window on the same queue is not kept waiting, and between them `goes_on` (which may be empty)
	// is asked: where it says no the image holds nothing and false comes back.
	Result<bool> drawInto(const Scene& scene, const gpu::Image& into, const std::function<bool()>& goes_on = {},
	                      Timeline* timeline = nullptr);

	// By the last draw(), over all its samples: layers that were as they should be already are not drawn again.
	std::size_t layersDrawn() const;

private:
	struct Private;
	explicit Renderer(std::unique_ptr<Private> made);

	std::unique_ptr<Private> private_;
};

} // namespace vp::render
