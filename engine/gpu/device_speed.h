#pragma once

#include "gpu/device.h"

namespace vp::gpu
{

// The least time that a device needs for what every picture needs.
struct DeviceSpeed
{
	double submit_ms;         // to submit nothing, and to wait for it
	double pixels_per_second; // written, four bytes each, into its memory; the way there and back included
};

// Measures for about 20 ms, more on a slow device. Takes the best of several tries.
Result<DeviceSpeed> measureSpeed(Device& device);

} // namespace vp::gpu
