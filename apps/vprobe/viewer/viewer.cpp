#include "viewer/viewer.h"

#include "options/trace_option.h"
#include "report/stats_json.h"
#include "viewer/frame_loop.h"
#include "viewer/panels/panels.h"

#include <fmt/format.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <optional>
#include <utility>

namespace vp::app
{

namespace
{

using Clock = std::chrono::steady_clock;

struct InterfaceContext
{
	InterfaceContext()
	{
		IMGUI_CHECKVERSION();
		ImGui::CreateContext();
		ImGui::GetIO().IniFilename = nullptr; // panels have fixed places
		ImGui::GetIO().ConfigDragClickToInputText = true;
	}
	~InterfaceContext() { ImGui::DestroyContext(); }
	InterfaceContext(const InterfaceContext&) = delete;
	InterfaceContext& operator=(const InterfaceContext&) = delete;
};

struct WindowBackend
{
	explicit WindowBackend(const Window& window) { ImGui_ImplGlfw_InitForVulkan(window.handle(), false); }
	~WindowBackend() { ImGui_ImplGlfw_Shutdown(); }
	WindowBackend(const WindowBackend&) = delete;
	WindowBackend& operator=(const WindowBackend&) = delete;
};

nlohmann::json stagesJson(const std::vector<StageFigure>& stages)
{
	nlohmann::json list = nlohmann::json::array();
	for (const StageFigure& stage : stages)
		list.push_back({{"stage", (stage.track == Timeline::Track::gpu ? "gpu " : "") + stage.name},
		                {"depth", stage.depth},
		                {"median", stage.median}});
	return list;
}

// A device may be lost now and then. If it is lost twice within this time, another device is tried.
constexpr std::chrono::seconds kLastsAtLeast{10};

Result<std::unique_ptr<gpu::Device>> openWindowDevice(const view::MachineSpec& machine, const std::string& avoid,
                                                      WindowTimes& times)
{
	const TimedSection section(&times.own(), "open device", 0, Timeline::Track::setup);
	return gpu::Device::create({.name_or_index = machine.device,
	                            .validation = {},
	                            .instance_extensions = Window::instanceExtensions(),
	                            .swapchain = true,
	                            .avoid = avoid,
	                            .memory = static_cast<std::uint64_t>(machine.device_memory)});
}

// Runs the window on a device. figures: figures of the device, once it has opened.
Status runOnDevice(Window& window, const ViewerOptions& options, const std::string& avoid, Lasting& lasting,
                   nlohmann::json& figures)
{
	Result<std::unique_ptr<gpu::Device>> made = openWindowDevice(options.state.machine, avoid, lasting.times);
	if (!made)
		return made.error();
	const std::shared_ptr<gpu::Device> device = std::move(*made);
	lasting.times.setDevice(*device);
	figures["device"] = device->name();
	makeFonts(window.scale());
	Result<std::unique_ptr<Screen>> screen = Screen::create(*device, window);
	if (!screen)
		return screen.error();
	if (!lasting.notice.empty())
		lasting.notice += fmt::format("; the window goes on with {}", device->name());
	FrameLoop loop(window, **screen, device, options.read_state, lasting);
	Status ended = loop.run();
	figures["validation_messages"] = device->validationMessages();
	if (const auto rows = (*screen)->rowsSent())
		figures["rows_sent"] = *rows;
	return ended;
}

} // namespace

Result<ExitCode> runViewer(const ViewerOptions& options)
{
	const view::PictureSize size = options.state.look.size;
	Result<std::optional<write::TraceFile>> trace = openTrace(options.trace);
	if (!trace)
		return trace.error();
	std::shared_ptr<std::FILE> commands;
	if (!options.commands.empty())
	{
		Result<std::shared_ptr<std::FILE>> opened = Script::open(options.commands);
		if (!opened)
			return opened.error();
		commands = std::move(*opened);
	}
	Result<std::unique_ptr<Window>> window =
	    Window::create("Volume Probes", static_cast<int>(size.width), static_cast<int>(size.height));
	if (!window)
		return window.error();
	const InterfaceContext context;
	const WindowBackend backend(**window);
	Lasting lasting{interact::History(options.state), {}, {}, {}, 0, {}, false, {}, WindowTimes(std::move(*trace))};
	if (commands)
		lasting.commands.emplace(std::move(commands), Window::wake);
	nlohmann::json figures;
	std::string avoid;
	std::optional<Moment> lost;
	for (;;)
	{
		Status ended = runOnDevice(**window, options, avoid, lasting, figures);
		if (ended)
			break;
		if (figures.is_null())
			return ended.error(); // there was no device to begin with
		const bool soon = lost && Clock::now() - *lost < kLastsAtLeast;
		if (soon && !avoid.empty())
		{
			const char* kept = "; what was set is kept: the next vprobe view brings it back";
			return Error{ended.error().kind, ended.error().message + (lasting.frames > 0 ? kept : "")};
		}
		// If a device was lost twice so soon, another one is tried.
		avoid = soon ? std::string(figures["device"]) : std::string();
		lost = Clock::now();
		lasting.notice = ended.error().message;
	}
	nlohmann::json told = lasting.meter.json();
	told.update(figures);
	told["stages"] = stagesJson(lasting.times.stages());
	if (Status written = lasting.times.commit(); !written)
		return written.error();
	const Result<ExitCode> written = writeStats(options.stats, {}, told.dump(2) + "\n");
	if (!written || !lasting.lost_files)
		return !written || !lasting.interrupt.came() ? written : ExitCode::interrupted;
	return ExitCode::output;
}

} // namespace vp::app
