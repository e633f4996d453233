#include "open_device.h"

#include "base/timeline.h"
#include "surface_options.h"

namespace vp::app
{

namespace
{

Result<OpenedDevice> open(const ProbeOptions& options, DeviceUse use)
{
	const bool needed = use == DeviceUse::draw || options.classify == "gpu" || !options.device.empty();
	const bool may_classify = options.classify == "auto" && !leavesDeviceIdle(options);
	if (use == DeviceUse::classify && (options.classify == "cpu" || (!needed && !may_classify)))
		return OpenedDevice{};
	// A software device would share the CPU's cores, and is not worth the time that it takes to open.
	Result<std::unique_ptr<gpu::Device>> device =
	    gpu::Device::create({.name_or_index = options.device, .hardware_only = !needed});
	if (!device)
		return needed ? Result<OpenedDevice>(device.error()) : OpenedDevice{};
	OpenedDevice opened{std::move(*device), {}};
	if (use == DeviceUse::classify)
		return opened;
	Result<render::Renderer> renderer = render::Renderer::create(*opened.device);
	if (!renderer)
		return renderer.error();
	opened.renderer.emplace(std::move(*renderer));
	return opened;
}

} // namespace

std::future<Result<OpenedDevice>> openDevice(const ProbeOptions& options, DeviceUse use)
{
	return std::async(std::launch::async,
	                  [&options, use]
	                  {
		                  nameThreadRow("device");
		                  return open(options, use);
	                  });
}

} // namespace vp::app
