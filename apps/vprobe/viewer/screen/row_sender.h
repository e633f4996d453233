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
	// An error of ErrorKind::device where the window is not one of X11 with eight bits a channel.
	static Result<std::unique_ptr<RowSender>> create(GLFWwindow* window);

	// Windows stand on a screen that a network lies before, as under ssh -X. There is a window.
	static bool isRemote();

	// pixels: B, G, R and a byte that is ignored, row by row from the top. all: the window has lost what was sent.
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
