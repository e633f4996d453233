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

// What a window hears; x to the right and y down in pixels of its content, keys and buttons as GLFW numbers them. A
// function that is empty hears nothing.
struct WindowEvents
{
	std::function<void(double x, double y)> cursor{};
	std::function<void(int button, bool down, int modifiers)> button{};
	std::function<void(double amount, int modifiers)> wheel{}; // > 0: away from the user
	std::function<void(int key, bool down, int modifiers)> key{};
	std::function<void(char32_t character)> typed{}; // right after its key
	std::function<void(std::vector<std::string> files)> drop{};
};

// A window of the desktop. Of one thread, but for wake().
class Window
{
public:
	// An error of ErrorKind::device where there is no display.
	static Result<std::unique_ptr<Window>> create(const std::string& title, int width, int height);
	~Window();
	Window(const Window&) = delete;
	Window& operator=(const Window&) = delete;

	static std::vector<const char*> instanceExtensions();
	Result<VkSurfaceKHR> makeSurface(VkInstance instance) const;

	void listen(WindowEvents events) { events_ = std::move(events); }
	// The same as a drop of files by hand.
	void drop(std::vector<std::string> files) const;

	// Hears what has come; waits at most so long for it.
	void hear(double seconds);
	static void wake(); // from any thread: ends a wait

	std::uint64_t exposures() const { return exposures_; } // how often the desktop has lost what the window showed
	VkExtent2D pixels() const;                             // of the content; 0 x 0 while minimized
	double scale() const; // of the screen: 2 where letters are to have twice the pixels
	double refreshRate() const;
	bool minimized() const;
	void minimize();
	void restore();
	void resize(int width, int height); // of the content; the desktop has the last word, later
	bool closes() const;                // the user wishes so
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
