#pragma once

#include <string>

namespace vp::gpu
{

class Device; // device.h

/// Returns the driver of a device with its version, as it calls itself: "Mesa 22.3.6 (LLVM 15.0.6)". The driver's name
/// is left out where the name of the device tells it.
std::string driverName(const Device& device);

} // namespace vp::gpu
