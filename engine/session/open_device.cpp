#include "session/open_device.h"

namespace vp::session
{

namespace
{

Result<OpenedDevice> open(const view::ViewSpec& spec, DeviceUse use, Timeline* timeline)
{
	const view::Classify classify = spec.machine.classify;
	const bool needed = use == DeviceUse::draw || classify == view::Classify::gpu || !spec.machine.device.empty();
	const bool may_classify = classify == view::Classify::automatic && !leavesDeviceIdle(spec.probe);
	if (use == DeviceUse::classify && (classify == view::Classify::cpu || (!needed && !may_classify)))
		return OpenedDevice{};
	const TimedSection section(timeline, "open device", 0, Timeline::Track::setup);
	// A software device would share the CPU's cores, and is not worth the time that it takes to open.
	Result<std::unique_ptr<gpu::Device>> device =
	    gpu::Device::create({.name_or_index = spec.machine.device,
	                         .hardware_only = !needed,
	                         .memory = static_cast<std::uint64_t>(spec.machine.device_memory)});
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

bool leavesDeviceIdle(const view::ProbeSpec& probe)
{
	const surface::ImplicitSurface* form = view::implicitSurface(probe.surface);
	return view::replacesSheets(probe.surface) || (form && form->isoValue());
}

std::future<Result<OpenedDevice>> openDevice(const view::ViewSpec& spec, DeviceUse use, Timeline* timeline)
{
	return std::async(std::launch::async,
	                  [spec, use, timeline]
	                  {
		                  nameThreadRow("device");
		                  return open(spec, use, timeline);
	                  });
}

} // namespace vp::session
