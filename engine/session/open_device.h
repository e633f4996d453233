#pragma once

#include "base/result.h"
#include "base/timeline.h"
#include "gpu/device.h"
#include "render/renderer.h"
#include "view/view_spec.h"

#include <future>
#include <memory>
#include <optional>

namespace vp::session
{

enum class DeviceUse
{
	classify, // a device is wanted for the GPU classifier only
	draw      // a device is needed in any case
};

// An open device, or null if the CPU needs none. For drawing, it comes with a renderer.
struct OpenedDevice
{
	std::shared_ptr<gpu::Device> device;
	std::optional<render::Renderer> renderer;
};

// Opens the device of the settings on a thread of its own, while inputs are read. A missing device is an error if the
// settings name one, if it must draw, or if it must classify. Otherwise the CPU does the work. A trace shows the
// thread: the timeline must outlive it.
std::future<Result<OpenedDevice>> openDevice(const view::ViewSpec& spec, DeviceUse use, Timeline* timeline);

/// Returns true if a cut leaves nothing for a device to classify: a surface that replaces the sheets, or an iso value.
bool leavesDeviceIdle(const view::ProbeSpec& probe);

} // namespace vp::session
