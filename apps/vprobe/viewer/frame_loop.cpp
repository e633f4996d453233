#include "viewer/frame_loop.h"

#include "base/frame_scope.h"
#include "report/console.h"
#include "viewer/pointer/key_codes.h"

#include <fmt/format.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_vulkan.h>

#include <algorithm>
#include <utility>

namespace vp::app
{

namespace
{

using Clock = std::chrono::steady_clock;

// A software device draws the window on the same cores that cut, so more frames than the eye needs would slow down
// cuts.
constexpr double kSoftwareFrameRate = 50.0;
// A picture that is under way triggers the next frame. If it takes long, the interface continues at this pace.
constexpr double kSoftwareWaitsFor = 0.035;
// While nothing moves, the window is still drawn at this pace, for texts that show a time.
constexpr double kIdleSeconds = 0.25;
constexpr std::chrono::milliseconds kStaysAwake{500};

} // namespace

FrameLoop::FrameLoop(Window& window, Screen& screen, std::shared_ptr<gpu::Device> device, const ReadState& read_state,
                     Lasting& lasting)
    : window_(window), screen_(screen), device_(*device), lasting_(lasting),
      document_(lasting.history, device, Window::wake, read_state, lasting.times),
      frame_seconds_(1.0 / (device->isSoftware() ? kSoftwareFrameRate : window.refreshRate())), scale_(window.scale()),
      dark_(document_.settings.dark)
{
	document_.parts = lasting.parts;
	if (!lasting.notice.empty())
		document_.notify(std::exchange(lasting.notice, {}), true);
	applyTheme(dark_, scale_);
	listen();
}

FrameLoop::~FrameLoop()
{
	window_.listen({});
	lasting_.meter.forgetPicture();
}

void FrameLoop::heard()
{
	last_event_ = Clock::now();
	document_.noteInput(last_event_);
}

void FrameLoop::listen()
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
		if (down && !ImGui::GetIO().WantCaptureMouse)
			document_.parts.panel_keys = false;
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

void FrameLoop::obey()
{
	if (lasting_.commands &&
	    lasting_.commands->run({document_, window_, screen_, document_.shown() == drawn_, lasting_.frames}))
		heard();
}

bool FrameLoop::isAwake() const
{
	return !document_.isIdle() || Clock::now() - last_event_ < kStaysAwake;
}

// Call this after each check of what moves.
void FrameLoop::noteWaking()
{
	if (!isAwake())
		awake_since_.reset();
	else if (!awake_since_)
		awake_since_ = Clock::now();
}

double FrameLoop::frameSeconds() const
{
	if (!isAwake())
		return kIdleSeconds;
	return device_.isSoftware() && document_.isDrawing() ? std::max(frame_seconds_, kSoftwareWaitsFor) : frame_seconds_;
}

double FrameLoop::secondsToNextFrame() const
{
	// The time counts from begin to begin, since on a slow device presenting a frame takes most of the time to the next
	// one.
	const double since = std::chrono::duration<double>(Clock::now() - frame_begin_).count();
	return std::max(0.0, frameSeconds() - since);
}

Status FrameLoop::followScale()
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

// The arrow keys move through menus, questions, the start page, and after F6 through the panel. Enter or Space chooses.
// On a slider Enter lets a number be typed, and after Space the arrow keys move it. Otherwise they turn the probe.
void FrameLoop::followKeyboard()
{
	ImGuiIO& io = ImGui::GetIO();
	const std::vector<interact::Key> pressed = keyboard_.takePressed();
	const bool at_start = !document_.facts() && !document_.loader().isBusy();
	using interact::Key;
	// ImGui would close a menu where the arrow keys ask for the one beside it.
	OpenParts& parts = document_.parts;
	const auto steps = std::ranges::count(pressed, Key::right) - std::ranges::count(pressed, Key::left);
	if (parts.open_menu && steps != 0)
		parts.opens_menu = *parts.open_menu + static_cast<int>(steps);
	const bool goes_sideways = parts.open_menu && (steps != 0 || keyboard_.holdsSideways());
	const bool moves = !goes_sideways && (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup) ||
	                                      document_.parts.panel_keys || at_start);
	io.ConfigFlags = moves ? io.ConfigFlags | ImGuiConfigFlags_NavEnableKeyboard
	                       : io.ConfigFlags & ~ImGuiConfigFlags_NavEnableKeyboard;
#if IMGUI_VERSION_NUM < 18700 // a newer version takes Enter for a choice by itself, and quick keys
	for (const auto& [key, input] :
	     {std::pair{Key::enter, ImGuiNavInput_Activate}, std::pair{Key::enter, ImGuiNavInput_Input},
	      std::pair{Key::space, ImGuiNavInput_Activate}, std::pair{Key::left, ImGuiNavInput_KeyLeft_},
	      std::pair{Key::right, ImGuiNavInput_KeyRight_}, std::pair{Key::up, ImGuiNavInput_KeyUp_},
	      std::pair{Key::down, ImGuiNavInput_KeyDown_}, std::pair{Key::escape, ImGuiNavInput_Cancel}})
		if (moves && !io.WantTextInput && std::ranges::find(pressed, key) != pressed.end())
			io.NavInputs[input] = 1.0f;
#endif
}

void FrameLoop::drawInterface()
{
	const TimedSection section(&lasting_.times.own(), "interface");
	ImGui_ImplVulkan_NewFrame();
	ImGui_ImplGlfw_NewFrame();
	followKeyboard();
	ImGui::NewFrame();
	Desk desk{document_, hand_, lasting_.meter, scale_};
	scene_ = showPanels(desk);
	hand_.place(scene_, scale_);
	ImGui::Render();
}

Result<bool> FrameLoop::present(const std::vector<Placement>& pictures)
{
	const TimedSection section(&lasting_.times.own(), "present");
	return screen_.show(pictures, *ImGui::GetDrawData(), window_.pixels());
}

// A frame that brings a new picture has the number of that picture.
Status FrameLoop::showTimedFrame(bool has_new_picture)
{
	Timeline& timeline = lasting_.times.own();
	Status shown = Nothing{};
	{
		std::optional<FrameScope> scope;
		if (has_new_picture && drawn_)
			scope.emplace(drawn_->number, FrameScope::Stop::picture);
		const TimedSection section(&timeline, "window frame");
		shown = showFrame();
	}
	lasting_.times.take(timeline, 0.0);
	return shown;
}

Status FrameLoop::showFrame()
{
	frame_begin_ = Clock::now();
	if (Status followed = followScale(); !followed)
		return followed;
	drawInterface();
	const std::shared_ptr<const PresentedFrame> shown = document_.shown();
	std::vector<Placement> pictures;
	const std::shared_ptr<const render::Picture> film = document_.playback().filmPicture();
	Result<std::shared_ptr<const gpu::Image>> frame =
	    film ? film_screen_.image(film) : Result<std::shared_ptr<const gpu::Image>>(shown ? shown->image : nullptr);
	if (!frame)
		return frame.error();
	if (*frame && scene_.size.x >= 1.0 && scene_.size.y >= 1.0)
		pictures.push_back({*frame, glm::ivec2(scene_.lo), glm::ivec2(scene_.size)});
	if (document_.parts.plane_pane && shown && shown->pane && !film)
	{
		const ScenePart pane = paneOf(scene_, scale_);
		if (pixelsOf(pane).width > 0 && pixelsOf(pane).height > 0)
			pictures.push_back({shown->pane->image, glm::ivec2(pane.lo), glm::ivec2(pane.size)});
	}
	const Result<bool> presented = present(pictures);
	if (!presented)
		return presented.error();
	last_frame_ = Clock::now();
	if (!*presented)
		return Nothing{};
	++lasting_.frames;
	lasting_.meter.frame(last_frame_, awake_since_);
	lasting_.meter.picture(shown, last_frame_);
	return Nothing{};
}

// A request to close comes from the window, from a key or a script, or from a signal. Files that are under way are
// written first. A second request does not wait for them.
bool FrameLoop::goesOn()
{
	const bool wished = document_.wantsToQuit();
	if (window_.closes())
	{
		window_.stayOpen();
		document_.quit();
	}
	if (lasting_.interrupt.came() && !wished)
		document_.quit(); // SIGINT and SIGTERM are no faults: nothing is kept for recovery
	if (!document_.wantsToQuit())
		return true;
	const std::vector<std::string> files = document_.filesUnderWay();
	if (files.empty() || document_.wantsToQuitAtOnce())
		return false;
	if (!wished)
		document_.notify(fmt::format("Writing {}; then the window closes. Close it again to leave that out",
		                             fmt::join(files, ", ")));
	return true;
}

void FrameLoop::tellUnsaved(const char* why)
{
	if (!lasting_.commands) // the script has printed them
		for (const std::string& line : document_.failures())
			printLine(line);
	const std::vector<std::string> files = document_.filesUnderWay();
	for (const std::string& file : files)
		printLine(fmt::format("{}: was not written: {}; save it again", file, why));
	lasting_.lost_files |= !files.empty() || !document_.failures().empty();
}

Status FrameLoop::run()
{
	while (goesOn())
	{
		noteWaking();
		window_.hear(secondsToNextFrame());
		if (!document_.wantsToQuit())
			obey();
		if (lasting_.commands && document_.wantsToQuit())
			lasting_.commands->tellErrors(document_);
		// Input goes to the render thread at once, without waiting for the window's next frame.
		document_.update(pixelsOf(scene_));
		noteWaking();
		if (window_.minimized() || window_.pixels().width == 0)
		{
			frame_begin_ = last_frame_ = Clock::now();
			continue;
		}
		const bool new_picture = document_.shown() != drawn_;
		const bool captures = lasting_.commands && lasting_.commands->wantsFrame();
		if (secondsToNextFrame() > 0.0 && !new_picture && !captures)
			continue;
		drawn_ = document_.shown();
		const Status shown = document_.lostDevice() ? Status(*document_.lostDevice()) : showTimedFrame(new_picture);
		if (!shown)
		{
			tellUnsaved("the device was lost");
			if (document_.wantsToQuit())
				return Nothing{};
			document_.keepState();
			lasting_.history = document_.historyToKeep();
			lasting_.parts = document_.parts;
			return shown;
		}
	}
	if (lasting_.commands)
		lasting_.commands->tellErrors(document_);
	tellUnsaved("the window was closed before");
	return Nothing{};
}

} // namespace vp::app
