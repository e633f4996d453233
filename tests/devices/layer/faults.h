#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <cstdint>
#include <optional>

namespace vp::layer
{

/// Errors that a call may return, as bits.
enum FaultBits : unsigned
{
	kHostMemory = 1,
	kDeviceMemory = 2,
	kLost = 4,
	kSurface = 8,
	kOutOfDate = 16,
	kLate = 32,
	kMemory = kHostMemory | kDeviceMemory,
	kAll = kMemory | kLost,
	kShowing = kAll | kSurface | kOutOfDate,
	kAcquiring = kShowing | kLate
};

/// The fault that VPROBE_LAYER_FAULT asks for, as "lost:17": the 17th call that may return it does. Kinds: host, device
/// (memory), lost, surface (a lost one), date (a swapchain that is out of date), late (no image to draw to in time).
/// Once lost, a device or a surface stays so, until another device is made. How many such calls there were is written
/// to the file that VPROBE_LAYER_COUNT names, when the program ends. Thread safe.
class Faults
{
public:
	Faults();
	~Faults();
	Faults(const Faults&) = delete;
	Faults& operator=(const Faults&) = delete;

	/// Counts a call that may return `bits`. What it is to return in place of being made.
	std::optional<VkResult> next(unsigned bits);
	/// Another device is made: neither it nor its surface is lost.
	void renew() { is_lost_ = false; }

private:
	unsigned kind_ = 0;
	VkResult result_ = VK_SUCCESS;
	std::uint64_t at_ = 0;
	std::atomic<std::uint64_t> calls_{0};
	std::atomic<bool> is_lost_{false};
};

} // namespace vp::layer
