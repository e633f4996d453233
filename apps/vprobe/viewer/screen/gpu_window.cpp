#include "viewer/screen/gpu_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/imgui.h>

#include <cmath>
#include <cstdlib>

namespace vp::app
{

namespace
{

constexpr int kMinWindowWidth = 640;
constexpr int kMinWindowHeight = 400;

std::string lastComplaint()
{
	const char* words = nullptr;
	glfwGetError(&words);
	return words ? words : "no reason given";
}

// GLFW 3.4 tries Wayland before X11. Without Wayland, libwayland then complains on standard error.
void preferX11WithoutWayland()
{
#ifdef GLFW_PLATFORM
	const auto names = [](const char* variable)
	{
		const char* value = std::getenv(variable);
		return value && *value;
	};
	if (!names("WAYLAND_DISPLAY") && !names("WAYLAND_SOCKET") && glfwPlatformSupported(GLFW_PLATFORM_X11))
		glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
}

// Many desktops on X11 do not say that a screen has small pixels. A screen of so many rows is taken for one on which
// letters of the usual number of pixels are too small: the interface is as large as on one of 1080 rows.
double scaleOfScreen()
{
	constexpr int kManyRows = 2000;
	constexpr double kUsualRows = 1080.0;
	GLFWmonitor* monitor = glfwGetPrimaryMonitor();
	const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
	return mode && mode->height >= kManyRows ? mode->height / kUsualRows : 1.0;
}

Window& windowOf(GLFWwindow* handle)
{
	return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

} // namespace

Result<std::unique_ptr<Window>> Window::create(const std::string& title, int width, int height)
{
	preferX11WithoutWayland();
	if (!glfwInit())
		return Error{ErrorKind::device,
		             fmt::format("no window can be opened ({}); set DISPLAY to a screen, or draw with vprobe render",
		                         lastComplaint())};
	glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
	glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
	// The window grows with its letters; GLFW does that where the desktop tells the scale.
	float across = 1.0f;
	float along = 1.0f;
	if (GLFWmonitor* monitor = glfwGetPrimaryMonitor())
		glfwGetMonitorContentScale(monitor, &across, &along);
	const double scale = across > 1.0f ? 1.0 : scaleOfScreen();
	GLFWwindow* handle =
	    glfwCreateWindow(static_cast<int>(std::lround(scale * width)), static_cast<int>(std::lround(scale * height)),
	                     title.c_str(), nullptr, nullptr);
	if (!handle)
	{
		const std::string reason = lastComplaint();
		glfwTerminate();
		return Error{ErrorKind::device, fmt::format("no window can be opened ({}); draw with vprobe render", reason)};
	}
	glfwSetWindowSizeLimits(handle, kMinWindowWidth, kMinWindowHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
	std::unique_ptr<Window> window(new Window(handle));
	glfwSetWindowUserPointer(handle, window.get());
	// The user interface gets every event too, and takes those that are meant for it. The listener asks it.
	glfwSetCursorPosCallback(handle,
	                         [](GLFWwindow* of, double x, double y)
	                         {
#if IMGUI_VERSION_NUM >= 18700 // an older version asks GLFW for the position in each frame
		                         ImGui_ImplGlfw_CursorPosCallback(of, x, y);
#endif
		                         if (const auto& tell = windowOf(of).events_.cursor)
			                         tell(x, y);
	                         });
	glfwSetMouseButtonCallback(handle,
	                           [](GLFWwindow* of, int button, int action, int modifiers)
	                           {
		                           ImGui_ImplGlfw_MouseButtonCallback(of, button, action, modifiers);
		                           if (const auto& tell = windowOf(of).events_.button)
			                           tell(button, action == GLFW_PRESS, modifiers);
	                           });
	glfwSetScrollCallback(handle,
	                      [](GLFWwindow* of, double across, double along)
	                      {
		                      ImGui_ImplGlfw_ScrollCallback(of, across, along);
		                      if (const auto& tell = windowOf(of).events_.wheel)
			                      tell(along, windowOf(of).modifiers_);
	                      });
	glfwSetKeyCallback(handle,
	                   [](GLFWwindow* of, int key, int scancode, int action, int modifiers)
	                   {
		                   ImGui_ImplGlfw_KeyCallback(of, key, scancode, action, modifiers);
		                   windowOf(of).modifiers_ = modifiers;
		                   if (const auto& tell = windowOf(of).events_.key)
			                   tell(key, action != GLFW_RELEASE, modifiers);
	                   });
	glfwSetCharCallback(handle,
	                    [](GLFWwindow* of, unsigned character)
	                    {
		                    ImGui_ImplGlfw_CharCallback(of, character);
		                    if (const auto& tell = windowOf(of).events_.typed)
			                    tell(static_cast<char32_t>(character));
	                    });
	glfwSetCursorEnterCallback(handle, ImGui_ImplGlfw_CursorEnterCallback);
	glfwSetWindowFocusCallback(handle, ImGui_ImplGlfw_WindowFocusCallback);
	glfwSetWindowRefreshCallback(handle, [](GLFWwindow* of) { ++windowOf(of).exposures_; });
	glfwSetDropCallback(handle,
	                    [](GLFWwindow* of, int count, const char** names) {
		                    windowOf(of).drop({names, names + count});
	                    });
	return window;
}

Window::~Window()
{
	glfwDestroyWindow(window_);
	glfwTerminate();
}

std::vector<const char*> Window::instanceExtensions()
{
	std::uint32_t count = 0;
	const char** names = glfwGetRequiredInstanceExtensions(&count);
	return names ? std::vector<const char*>(names, names + count) : std::vector<const char*>();
}

Result<VkSurfaceKHR> Window::makeSurface(VkInstance instance) const
{
	VkSurfaceKHR surface = VK_NULL_HANDLE;
	if (glfwCreateWindowSurface(instance, window_, nullptr, &surface) != VK_SUCCESS)
		return Error{
		    ErrorKind::device,
		    fmt::format("the device cannot draw into a window ({}); draw with vprobe render", lastComplaint())};
	return surface;
}

void Window::drop(std::vector<std::string> files) const
{
	if (events_.drop)
		events_.drop(std::move(files));
}

void Window::hear(double seconds)
{
	if (seconds > 0.0)
		glfwWaitEventsTimeout(seconds);
	else
		glfwPollEvents();
}

void Window::wake()
{
	glfwPostEmptyEvent();
}

VkExtent2D Window::pixels() const
{
	int width = 0;
	int height = 0;
	glfwGetFramebufferSize(window_, &width, &height);
	return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

double Window::scale() const
{
	float across = 1.0f;
	float along = 1.0f;
	glfwGetWindowContentScale(window_, &across, &along);
	return across > 1.0f ? across : scaleOfScreen();
}

double Window::refreshRate() const
{
	GLFWmonitor* monitor = glfwGetPrimaryMonitor();
	const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
	return mode && mode->refreshRate > 0 ? mode->refreshRate : 60.0;
}

bool Window::minimized() const
{
	return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != 0;
}

void Window::minimize()
{
	glfwIconifyWindow(window_);
}

void Window::restore()
{
	glfwRestoreWindow(window_);
}

void Window::resize(int width, int height)
{
	glfwSetWindowSize(window_, width, height);
}

bool Window::closes() const
{
	return glfwWindowShouldClose(window_) != 0;
}

void Window::stayOpen()
{
	glfwSetWindowShouldClose(window_, GLFW_FALSE);
}

void Window::setTitle(const std::string& title)
{
	glfwSetWindowTitle(window_, title.c_str());
}

bool Window::fullScreen() const
{
	return glfwGetWindowMonitor(window_) != nullptr;
}

void Window::setFullScreen(bool full)
{
	if (full == fullScreen())
		return;
	if (!full)
		return glfwSetWindowMonitor(window_, nullptr, place_[0], place_[1], place_[2], place_[3], 0);
	GLFWmonitor* monitor = glfwGetPrimaryMonitor();
	const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
	if (!mode)
		return;
	glfwGetWindowPos(window_, &place_[0], &place_[1]);
	glfwGetWindowSize(window_, &place_[2], &place_[3]);
	glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

} // namespace vp::app
