#include "viewer/viewer.h"

#include "report/stats_json.h"
#include "viewer/commands.h"
#include "viewer/gpu_film_screen.h"
#include "viewer/gpu_screen.h"
#include "viewer/gpu_window.h"
#include "viewer/key_codes.h"
#include "viewer/keyboard.h"
#include "viewer/panels.h"

#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_vulkan.h>
#include <nlohmann/json.hpp>

#include <chrono>

namespace vp::app
{

namespace
{

using Clock = std::chrono::steady_clock;

// A software device draws the window on the cores that cut: more frames than the eye needs would cost cuts.
constexpr double kSoftwareFrameRate = 50.0;
// Nothing moves: the window is drawn now and then for what tells the time.
constexpr double kIdleSeconds = 0.25;
constexpr std::chrono::milliseconds kStaysAwake{500};

struct InterfaceContext
{
	InterfaceContext()
	{
		IMGUI_CHECKVERSION();
		ImGui::CreateContext();
		ImGui::GetIO().IniFilename = nullptr; // the places of panels are fixed
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

class Viewer
{
public:
	// commands: null where there are none.
	Viewer(Window& window, Screen& screen, std::shared_ptr<gpu::Device> device, const ViewerOptions& options,
	       std::shared_ptr<std::FILE> commands);

	Result<ExitCode> run();
	const Meter& meter() const { return meter_; }

private:
	void listen();
	void heard(); // input came
	void obey();  // --commands
	Status showFrame();
	Status followScale();
	static void followKeyboard();
	double secondsToNextFrame() const;
	bool isAwake() const;

	Window& window_;
	Screen& screen_;
	gpu::Device& device_;
	Document document_;
	std::optional<Commands> commands_;
	PointerController hand_{document_};
	Keyboard keyboard_{document_, hand_};
	Meter meter_;
	double frame_seconds_;
	double scale_;
	bool dark_;
	ScenePart scene_;
	std::uint64_t frames_ = 0;          // shown so far
	Moment frame_begin_ = Clock::now(); // of the last frame
	Moment last_frame_ = Clock::now();  // when it had been presented
	Moment last_event_ = Clock::now();
	std::shared_ptr<const PresentedFrame> drawn_;
	FilmScreen film_screen_{device_};
};

Viewer::Viewer(Window& window, Screen& screen, std::shared_ptr<gpu::Device> device, const ViewerOptions& options,
               std::shared_ptr<std::FILE> commands)
    : window_(window), screen_(screen), device_(*device),
      document_(options.state, device, Window::wake, options.read_state),
      frame_seconds_(1.0 / (device->isSoftware() ? kSoftwareFrameRate : window.refreshRate())), scale_(window.scale()),
      dark_(document_.settings.dark)
{
	if (commands)
		commands_.emplace(std::move(commands), Window::wake);
	applyTheme(dark_, scale_);
	listen();
}

void Viewer::heard()
{
	last_event_ = Clock::now();
	document_.noteInput(last_event_);
}

void Viewer::listen()
{
	WindowEvents events;
	events.cursor = [this](double x, double y)
	{
		heard();
		hand_.moveTo({x, y});
	};
	events.button = [this](int button, bool down, int)
	{
		heard();
		const std::optional<Button> known = buttonOf(button);
		if (known && down)
			hand_.press(*known, !ImGui::GetIO().WantCaptureMouse);
		else if (known)
			hand_.release(*known);
	};
	events.wheel = [this](double amount, int)
	{
		heard();
		hand_.wheel(amount, !ImGui::GetIO().WantCaptureMouse);
	};
	events.key = [this](int key, bool down, int modifiers)
	{
		heard();
		keyboard_.press(key, down, modifiers);
	};
	events.typed = [this](char32_t character) { keyboard_.type(character); };
	events.drop = [this](std::vector<std::string> files)
	{
		heard();
		document_.open(std::move(files));
	};
	window_.listen(std::move(events));
}

void Viewer::obey()
{
	if (commands_ && commands_->run({document_, window_, screen_, document_.shown() == drawn_, frames_}))
		heard();
}

bool Viewer::isAwake() const
{
	return !document_.isIdle() || Clock::now() - last_event_ < kStaysAwake;
}

double Viewer::secondsToNextFrame() const
{
	// From begin to begin: where the device is slow, presenting a frame takes most of the time to the next one.
	const double since = std::chrono::duration<double>(Clock::now() - frame_begin_).count();
	return std::max(0.0, (isAwake() ? frame_seconds_ : kIdleSeconds) - since);
}

Status Viewer::followScale()
{
	if (const double scale = window_.scale() * document_.settings.text_size; scale != scale_)
	{
		scale_ = scale;
		applyTheme(document_.settings.dark, scale_);
		makeFonts(scale_);
		if (Status taken = screen_.takeFonts(); !taken)
			return taken;
	}
	if (dark_ != document_.settings.dark)
		applyTheme(dark_ = document_.settings.dark, scale_);
	window_.setFullScreen(document_.parts.full_screen);
	return Nothing{};
}

// Menus and questions go by the arrows too; else those turn the probe.
void Viewer::followKeyboard()
{
	ImGuiIO& io = ImGui::GetIO();
	const bool asks = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
	io.ConfigFlags = asks ? io.ConfigFlags | ImGuiConfigFlags_NavEnableKeyboard
	                      : io.ConfigFlags & ~ImGuiConfigFlags_NavEnableKeyboard;
}

Status Viewer::showFrame()
{
	frame_begin_ = Clock::now();
	if (Status followed = followScale(); !followed)
		return followed;
	ImGui_ImplVulkan_NewFrame();
	ImGui_ImplGlfw_NewFrame();
	followKeyboard();
	ImGui::NewFrame();
	Desk desk{document_, hand_, meter_, scale_};
	scene_ = showPanels(desk);
	hand_.place(scene_, scale_);
	ImGui::Render();

	const std::shared_ptr<const PresentedFrame> shown = document_.shown();
	std::vector<Placement> pictures;
	const std::shared_ptr<const render::Picture> film = document_.playback().filmPicture();
	Result<std::shared_ptr<const gpu::Image>> frame =
	    film ? film_screen_.image(film) : Result<std::shared_ptr<const gpu::Image>>(shown ? shown->image : nullptr);
	if (!frame)
		return frame.error();
	if (*frame)
		pictures.push_back({*frame, glm::ivec2(scene_.lo), glm::ivec2(scene_.size)});
	if (document_.parts.plane_pane && shown && shown->pane && !film)
	{
		const ScenePart pane = paneOf(scene_, scale_);
		pictures.push_back({shown->pane->image, glm::ivec2(pane.lo), glm::ivec2(pane.size)});
	}
	const bool was_awake = isAwake();
	Result<bool> presented = screen_.show(pictures, *ImGui::GetDrawData(), window_.pixels());
	if (!presented)
		return presented.error();
	last_frame_ = Clock::now();
	if (!*presented)
		return Nothing{};
	++frames_;
	meter_.frame(last_frame_, was_awake);
	meter_.picture(shown, last_frame_);
	return Nothing{};
}

Result<ExitCode> Viewer::run()
{
	while (!window_.closes() && !document_.wantsToQuit())
	{
		window_.hear(secondsToNextFrame());
		obey();
		// What was heard goes to the render thread at once; the window's next frame need not be waited for.
		document_.update({static_cast<std::uint32_t>(scene_.size.x), static_cast<std::uint32_t>(scene_.size.y)});
		if (window_.minimized() || window_.pixels().width == 0)
		{
			frame_begin_ = last_frame_ = Clock::now();
			continue;
		}
		const bool new_picture = document_.shown() != drawn_;
		const bool captures = commands_ && commands_->wantsFrame();
		if (secondsToNextFrame() > 0.0 && !new_picture && !captures)
			continue;
		drawn_ = document_.shown();
		if (Status shown = showFrame(); !shown)
		{
			document_.keepState();
			return Error{shown.error().kind,
			             shown.error().message + "; what was set is kept: the next vprobe view brings it back"};
		}
	}
	return ExitCode::done;
}

} // namespace

Result<ExitCode> runViewer(const ViewerOptions& options)
{
	const view::PictureSize size = options.state.look.size;
	std::shared_ptr<std::FILE> commands;
	if (!options.commands.empty())
	{
		Result<std::shared_ptr<std::FILE>> opened = Commands::open(options.commands);
		if (!opened)
			return opened.error();
		commands = std::move(*opened);
	}
	Result<std::unique_ptr<Window>> window =
	    Window::create("Volume Probes", static_cast<int>(size.width), static_cast<int>(size.height));
	if (!window)
		return window.error();
	Result<std::unique_ptr<gpu::Device>> made =
	    gpu::Device::create({.name_or_index = options.state.machine.device,
	                         .validation = {},
	                         .instance_extensions = Window::instanceExtensions(),
	                         .swapchain = true});
	if (!made)
		return made.error();
	const std::shared_ptr<gpu::Device> device = std::move(*made);
	const auto surface = (*window)->makeSurface(device->instance());
	if (!surface)
		return surface.error();
	const InterfaceContext context;
	const WindowBackend backend(**window);
	makeFonts((*window)->scale());
	Result<std::unique_ptr<Screen>> screen = Screen::create(*device, *surface, (*window)->pixels());
	if (!screen)
		return screen.error();
	Viewer viewer(**window, **screen, device, options, std::move(commands));
	Result<ExitCode> ended = viewer.run();
	if (!ended)
		return ended;
	nlohmann::json figures = viewer.meter().json();
	figures["device"] = device->name();
	figures["validation_messages"] = device->validationMessages();
	return writeStats(options.stats, {}, figures.dump(2) + "\n");
}

} // namespace vp::app
