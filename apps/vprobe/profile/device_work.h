#pragma once

#include "gpu/invocations.h"
#include "gpu/pipeline_figures.h"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <string>
#include <vector>

namespace vp::gpu
{
class Device;
}

namespace vp::app
{

// The work of the device for the planes of a profile: how often its shaders ran, and what the driver tells of its
// pipelines.
class DeviceWork
{
public:
	void add(const gpu::PassInvocations& of_plane);

	// Adds to a profile `pipelines`, to its gpu_stages `vertices`, `fragments` and `computes`, and to its `not_counted`
	// what the device does not tell.
	void put(nlohmann::json& profile, const gpu::Device& device) const;

private:
	struct PerPlane
	{
		std::vector<double> vertices, fragments, computes;
	};

	std::map<std::string, PerPlane> passes_;
};

// Returns the table's lines about the work of the device; an empty text without one.
std::string deviceWorkText(const nlohmann::json& profile);

} // namespace vp::app
