#pragma once

#include "base/result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

struct GLFWwindow;

namespace vp::app
{

// Shows pictures in a window of X11 by sending it pixels, without the device. This is for devices that cannot present
// to the window, and for windows on another machine: only rows that have changed are sent. For the window's thread.
class RowSender
{
public:
	// Returns an error of ErrorKind::device if the window is not an X11 window with eight bits per channel.
	static Result<std::unique_ptr<RowSender>> create(GLFWwindow* window);

	// Returns true if a network lies between the program and the screen, as with ssh -X. A window must exist.
	static bool isRemote();

	// pixels: B, G, R and a byte that is ignored, row by row from the top. all: sends all rows, since the window has
	// lost its content.
	void send(std::span<const std::byte> pixels, std::uint32_t width, std::uint32_t height, bool all);
	std::uint64_t rowsSent() const { return rows_sent_; }

private:
	explicit RowSender(GLFWwindow* window) : window_(window) {}

	GLFWwindow* window_;
	std::vector<std::byte> sent_; // what the window shows
	std::uint32_t width_ = 0;
	std::uint64_t rows_sent_ = 0;
};

} // namespace vp::app
