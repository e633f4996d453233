#pragma once

#include "base/result.h"
#include "gpu/vulkan.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace vp::app
{

// Functions that a window calls on events. x points right and y down in pixels of the content; keys and buttons have
// GLFW's numbers. An empty function is not called.
struct WindowEvents
{
	std::function<void(double x, double y)> cursor{};
	std::function<void(int button, bool down, int modifiers)> button{};
	std::function<void(double amount, int modifiers)> wheel{}; // > 0: away from the user
	std::function<void(int key, bool down, int modifiers)> key{};
	std::function<void(char32_t character)> typed{}; // right after its key
	std::function<void(std::vector<std::string> files)> drop{};
};

// A window of the desktop. Only one thread uses it, except for wake().
class Window
{
public:
	// Returns an error of ErrorKind::device if there is no display.
	static Result<std::unique_ptr<Window>> create(const std::string& title, int width, int height);
	~Window();
	Window(const Window&) = delete;
	Window& operator=(const Window&) = delete;

	static std::vector<const char*> instanceExtensions();
	Result<VkSurfaceKHR> makeSurface(VkInstance instance) const;

	void listen(WindowEvents events) { events_ = std::move(events); }
	// Does the same as a drop of files by the user.
	void drop(std::vector<std::string> files) const;

	// Handles the events that have come. Waits for them at most this long.
	void hear(double seconds);
	static void wake(); // ends a wait; any thread may call it

	std::uint64_t exposures() const { return exposures_; } // how often the desktop has lost the window's content
	VkExtent2D pixels() const;                             // size of the content; 0 x 0 while minimized
	double scale() const;                                  // the screen's scale: 2 if letters need twice the pixels
	double refreshRate() const;
	bool minimized() const;
	void minimize();
	void restore();
	void resize(int width, int height); // size of the content; the desktop decides, and does so later
	bool closes() const;                // the user asked to close the window
	void stayOpen();
	void setTitle(const std::string& title);
	void setFullScreen(bool full);
	bool fullScreen() const;
	GLFWwindow* handle() const { return window_; }

private:
	explicit Window(GLFWwindow* window) : window_(window) {}

	GLFWwindow* window_;
	WindowEvents events_;
	int modifiers_ = 0;
	std::uint64_t exposures_ = 0;
	int place_[4] = {}; // where the window was before it was full screen: x, y, width, height
};

} // namespace vp::app
