#include "gpu/driver_name.h"

#include "gpu/device.h"

namespace vp::gpu
{

std::string driverName(const Device& device)
{
	VkPhysicalDeviceDriverProperties driver{};
	driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
	VkPhysicalDeviceProperties2 properties{};
	properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
	properties.pNext = &driver;
	vkGetPhysicalDeviceProperties2(device.physical(), &properties);
	const std::string name = driver.driverName;
	const std::string version = driver.driverInfo;
	if (version.empty())
		return name;
	return name.empty() || device.name().find(name) != std::string::npos ? version : name + " " + version;
}

} // namespace vp::gpu
