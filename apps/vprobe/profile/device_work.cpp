#include "profile/device_work.h"

#include "gpu/device.h"
#include "profile/spread.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace vp::app
{

namespace
{

using nlohmann::json;

constexpr std::size_t kShownFigures = 4; // for each shader; the document has all

json pipelinesJson()
{
	json list = json::array();
	for (const gpu::ExecutableFigures& shader : gpu::pipelineFigures())
	{
		json figures = json::object();
		for (const auto& [name, value] : shader.figures)
			figures[name] = value;
		list.push_back({{"pipeline", shader.pipeline},
		                {"executable", shader.executable},
		                {"subgroup_size", shader.subgroup_size},
		                {"figures", std::move(figures)}});
	}
	return list;
}

std::string invocationsText(const json& stages)
{
	std::string text;
	for (const json& stage : stages)
		if (stage.contains("computes"))
			text += fmt::format("{:<22} {:>10.0f} {:>10.0f} {:>10.0f}\n", stage["stage"].get<std::string>(),
			                    stage["vertices"].get<double>(), stage["fragments"].get<double>(),
			                    stage["computes"].get<double>());
	return text.empty() ? text
	                    : fmt::format("\n{:<22} {:>10} {:>10} {:>10}\n", "shaders a plane", "vertices", "fragments",
	                                  "computes") +
	                          text;
}

std::string pipelinesText(const json& pipelines)
{
	std::string text;
	for (const json& shader : pipelines)
	{
		text += fmt::format("pipeline {}, {}: subgroups of {}", shader["pipeline"].get<std::string>(),
		                    shader["executable"].get<std::string>(), shader["subgroup_size"].get<int>());
		std::size_t shown = 0;
		for (const auto& [name, value] : shader["figures"].items())
			if (shown++ < kShownFigures)
				text += fmt::format(", {} {:.6g}", name, value.get<double>());
		text += "\n";
	}
	return text.empty() ? text : "\n" + text;
}

} // namespace

void DeviceWork::add(const gpu::PassInvocations& of_plane)
{
	for (const auto& [name, counts] : of_plane)
	{
		PerPlane& pass = passes_[name];
		pass.vertices.push_back(static_cast<double>(counts.vertices));
		pass.fragments.push_back(static_cast<double>(counts.fragments));
		pass.computes.push_back(static_cast<double>(counts.computes));
	}
}

void DeviceWork::put(json& profile, const gpu::Device& device) const
{
	for (json& stage : profile["gpu_stages"])
		if (const auto pass = passes_.find(stage["stage"].get<std::string>()); pass != passes_.end())
			stage.update({{"vertices", medianOf(pass->second.vertices)},
			              {"fragments", medianOf(pass->second.fragments)},
			              {"computes", medianOf(pass->second.computes)}});
	if (!device.features().pipelineStatisticsQuery)
		profile["not_counted"]["invocations"] = "the device does not have pipelineStatisticsQuery";
	const bool tells = gpu::tellsPipelineFigures(device);
	profile["pipelines"] = tells ? pipelinesJson() : json();
	if (!tells)
		profile["not_counted"]["pipelines"] = "the device does not have VK_KHR_pipeline_executable_properties";
}

std::string deviceWorkText(const json& profile)
{
	std::string text = invocationsText(profile["gpu_stages"]);
	return profile.contains("pipelines") ? text + pipelinesText(profile["pipelines"]) : text;
}

} // namespace vp::app
