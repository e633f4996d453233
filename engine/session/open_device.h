#pragma once

#include "base/result.h"
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

// A device, null where the CPU does without, and for drawing what draws on it.
struct OpenedDevice
{
	std::shared_ptr<gpu::Device> device;
	std::optional<render::Renderer> renderer;
};

// Opens the device that the settings ask for on a thread of its own, while inputs are read. None is an error where it
// is asked for by name, draws, or must classify; otherwise the CPU does the work.
std::future<Result<OpenedDevice>> openDevice(const view::ViewSpec& spec, DeviceUse use);

/// Whether a cut leaves nothing for a device to classify: neither what replaces sheets nor an iso value does.
bool leavesDeviceIdle(const view::ProbeSpec& probe);

} // namespace vp::session
