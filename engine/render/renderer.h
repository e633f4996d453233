#pragma once

#include "base/result.h"
#include "render/passes/fragment_lists.h"
#include "render/picture.h"
#include "render/scene/layer_values.h"
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

// Draws scenes without a window. It keeps the pipelines, and images of the last size. One thread at a time may use it.
class Renderer
{
public:
	// The device must outlive the renderer. most_fragment_bytes: the limit for the lists of surface fragments; a
	// picture that needs more is drawn in strips. raster_side: sheets are drawn by a compute shader, in which one
	// thread draws a polygon of up to this number of pixels a side (at most shared::kMaxRasterSide). 0: all is drawn by
	// the device's own rasterizer. Unset: whichever is faster on the device.
	static Result<Renderer> create(gpu::Device& device, std::uint64_t most_fragment_bytes = kMaxFragmentBytes,
	                               std::optional<std::uint32_t> raster_side = {});
	~Renderer();
	Renderer(Renderer&&) noexcept;
	Renderer& operator=(Renderer&&) noexcept;

	// Draws each sheet into a layer of values, opaque surfaces with a depth test, and others into lists of fragments.
	// Then layers, surfaces and outline become colors, and the overlay is drawn over them. All samples but the first
	// are drawn near edges only. Adds section "draw" with "prepare", "wait" and "pixels" in it, and GPU sections
	// "layers", "surfaces" (where there are any), "compose", "edges" (with samples), "overlay" and "copy" to the
	// timeline, if there is one. More sheets than shared::kMaxLayers or surfaces than shared::kMaxSurfaces are a usage
	// error. goes_on: if it is not empty, each sample is submitted alone, and it is asked in between. If it returns
	// false, draw() ends with ErrorKind::cancelled.
	Result<Picture> draw(const Scene& scene, Timeline* timeline = nullptr, const std::function<bool()>& goes_on = {});

	// The same with layers and surfaces that others draw a part of. merge is called for each sample, of which every
	// layer and surface is drawn as a whole. Returns nothing if merge says that another process goes on. For pictures
	// that are drawn in one part. All processes have as many sheets and surfaces, with the same opacities.
	Result<std::optional<Picture>> drawMerged(const Scene& scene, const MergeLayers& merge,
	                                          Timeline* timeline = nullptr);

	// The same into an image of the scene's size in kPictureFormat, made with TRANSFER_DST usage. No submitted work may
	// still use it. It is left in layout gpu::kCopyFrom. Colors are multiplied by alpha. Each sample is submitted
	// alone, so that a window on the same queue does not wait long. Between samples `goes_on` is asked, unless it is
	// empty. If it returns false, the content of the image is undefined and draw() returns false.
	Result<bool> drawInto(const Scene& scene, const gpu::Image& into, const std::function<bool()>& goes_on = {},
	                      Timeline* timeline = nullptr);

	// Returns the number of layers that the last draw() drew, over all its samples. Layers that had not changed are not
	// drawn again.
	std::size_t layersDrawn() const;

private:
	struct Private;
	explicit Renderer(std::unique_ptr<Private> made);

	std::unique_ptr<Private> private_;
};

} // namespace vp::render
