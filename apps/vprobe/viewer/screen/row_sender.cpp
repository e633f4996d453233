#include "viewer/screen/row_sender.h"

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_X11
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>
#include <X11/Xutil.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace vp::app
{

namespace
{

constexpr std::size_t kPixelBytes = 4;

// Each request to the server has a header. So a few unchanged rows are sent together with the changed rows around them.
constexpr std::uint32_t kMinGap = 4;

} // namespace

Result<std::unique_ptr<RowSender>> RowSender::create(GLFWwindow* window)
{
	Display* display = glfwGetX11Display();
	XWindowAttributes has{};
	const bool is_known = display && XGetWindowAttributes(display, glfwGetX11Window(window), &has) != 0;
	if (!is_known || has.visual->red_mask != 0xff0000 || has.visual->green_mask != 0xff00 ||
	    has.visual->blue_mask != 0xff)
		return Error{ErrorKind::device, "the window takes no pixels of eight bits a channel; draw with vprobe render"};
	return std::unique_ptr<RowSender>(new RowSender(window));
}

bool RowSender::isRemote()
{
	Display* display = glfwGetX11Display();
	const std::string_view name = display ? DisplayString(display) : ":";
	return !name.starts_with(":") && !name.starts_with("unix:") && !name.starts_with("/");
}

void RowSender::send(std::span<const std::byte> pixels, std::uint32_t width, std::uint32_t height, bool all)
{
	const std::size_t row_bytes = kPixelBytes * width;
	all = all || width != width_ || sent_.size() != pixels.size();
	const auto hasChanged = [&](std::uint32_t row)
	{ return all || std::memcmp(&pixels[row * row_bytes], &sent_[row * row_bytes], row_bytes) != 0; };
	Display* display = glfwGetX11Display();
	XImage image{};
	image.width = static_cast<int>(width);
	image.height = static_cast<int>(height);
	image.format = ZPixmap;
	image.data = const_cast<char*>(reinterpret_cast<const char*>(pixels.data())); // X only reads it
	image.byte_order = image.bitmap_bit_order = LSBFirst;
	image.bitmap_unit = image.bitmap_pad = image.bits_per_pixel = 8 * kPixelBytes;
	XWindowAttributes has{};
	XGetWindowAttributes(display, glfwGetX11Window(window_), &has);
	image.depth = has.depth;
	image.bytes_per_line = static_cast<int>(row_bytes);
	XInitImage(&image);
	GC context = XCreateGC(display, glfwGetX11Window(window_), 0, nullptr);
	for (std::uint32_t row = 0; row < height;)
	{
		if (!hasChanged(row))
		{
			++row;
			continue;
		}
		const std::uint32_t first = row;
		std::uint32_t end = row + 1; // after the last one that has changed
		for (row = end; row < height && row < end + kMinGap; ++row)
			if (hasChanged(row))
				end = row + 1;
		XPutImage(display, glfwGetX11Window(window_), context, &image, 0, static_cast<int>(first), 0,
		          static_cast<int>(first), width, end - first);
		rows_sent_ += end - first;
	}
	XFreeGC(display, context);
	XFlush(display);
	sent_.assign(pixels.begin(), pixels.end());
	width_ = width;
}

} // namespace vp::app
