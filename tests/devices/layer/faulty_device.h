#pragma once

#include <map>
#include <string>

namespace vp::layer
{

/// The environment of a program whose device fails (faults.h says how). count: a file for the number of calls that
/// might have failed. There is no validation: when a device is lost, the layer waits until the true one is idle,
/// whichever thread uses the queue.
inline std::map<std::string, std::string> faultyDevice(const std::string& fault, const std::string& count)
{
	return {{"VK_LAYER_PATH", VPROBE_TEST_LAYERS},
	        {"VK_INSTANCE_LAYERS", "VK_LAYER_VPROBE_test"},
	        {"VPROBE_VALIDATION", "0"},
	        {"VPROBE_LAYER_FAULT", fault},
	        {"VPROBE_LAYER_COUNT", count}};
}

/// The environment of a program whose device lacks something (restrictions.h says what). Validation holds the program
/// to what the layer tells.
inline std::map<std::string, std::string> restrictedDevice(const std::string& restrictions)
{
	return {{"VK_LAYER_PATH", VPROBE_TEST_LAYERS},
	        {"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation:VK_LAYER_VPROBE_test"},
	        {"VPROBE_LAYER_RESTRICT", restrictions}};
}

/// The environment of a program whose driver tells figures of pipelines (given.h).
inline std::map<std::string, std::string> givenExecutables()
{
	return {{"VK_LAYER_PATH", VPROBE_TEST_LAYERS},
	        {"VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation:VK_LAYER_VPROBE_test"},
	        {"VPROBE_LAYER_GIVE", "executables"}};
}

} // namespace vp::layer
