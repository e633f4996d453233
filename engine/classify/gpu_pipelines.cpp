#include "classify/gpu_pipelines.h"

#include "embedded_shaders.h"
#include "gpu/commands.h"
#include "gpu/compile_shader.h"
#include "shared/classify_types.h"
#include "shared/surface_types.h"
#include "surface/expression_glsl.h"

#include <algorithm>

namespace vp::classify
{

gpu::ComputePipelineInfo classifyPipelineInfo(const gpu::Device& device, const PipelineKinds& kinds)
{
	gpu::ComputePipelineInfo info;
	for (const std::uint32_t binding :
	     {shared::kBindPoints, shared::kBindCells, shared::kBindCases, shared::kBindValues, shared::kBindAxes})
		info.bindings.push_back({binding, gpu::ShaderArray::descriptorType(device)});
	for (const std::uint32_t binding : {shared::kBindFront, shared::kBindCodes, shared::kBindRecords})
		info.bindings.push_back({binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER});
	info.bindings.push_back({shared::kBindSheet, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER});
	info.push_bytes = sizeof(shared::ClassifyPush);
	info.constants = {
	    {shared::kConstantCells, kinds[0]}, {shared::kConstantPoints, kinds[1]}, {shared::kConstantValues, kinds[2]}};
	return info;
}

Status warmUp(gpu::Device& device, const gpu::Pipeline& pipeline, const PipelineKinds& kinds,
              const gpu::ShaderArray::Place& array)
{
	gpu::DescriptorSets sets(device, pipeline, "warm-up");
	Result<VkDescriptorSet> set = sets.get(0);
	if (!set)
		return set.error();
	static_assert(sizeof(shared::ClassifyPlane) <= 1024 && sizeof(shared::ClassifySurface) <= 1024);
	const bool tuple = kinds[2] == shared::kValuesPointTuple || kinds[2] == shared::kValuesCellTuple;
	Result<gpu::ShaderArray> room = gpu::ShaderArray::create(
	    device, 1024, tuple ? VK_FORMAT_R32G32B32A32_SFLOAT : VK_FORMAT_R32_SFLOAT, gpu::Memory::device, "warm-up",
	    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
	if (!room)
		return room.error();

	gpu::DescriptorWriter writer;
	for (const std::uint32_t binding : {shared::kBindPoints, shared::kBindCells, shared::kBindCases, shared::kBindAxes})
		writer.array(binding, array);
	writer.array(shared::kBindValues, room->place());
	for (const std::uint32_t binding : {shared::kBindFront, shared::kBindCodes, shared::kBindRecords})
		writer.storageBuffer(binding, room->buffer().handle());
	writer.uniformBuffer(shared::kBindSheet, room->buffer().handle());
	writer.write(device, *set);
	return gpu::runOnce(device, "warm-up",
	                    [&](VkCommandBuffer commands)
	                    {
		                    // There are no cells: the shader is compiled and returns at once.
		                    pipeline.bind(commands, *set);
		                    pipeline.push(commands, shared::ClassifyPush{0, 0});
		                    vkCmdDispatch(commands, 1, 1, 1);
	                    });
}

Result<std::shared_ptr<const gpu::Pipeline>> SurfacePipelines::get(std::uint32_t cells_kind, std::uint32_t points_kind,
                                                                   const surface::Expression* expression,
                                                                   const gpu::ShaderArray::Place& array)
{
	const PipelineKinds kinds{cells_kind, points_kind, shared::kValuesNone};
	const std::string text = expression ? expression->text() : std::string();
	const std::lock_guard lock(mutex_);
	const auto known =
	    std::ranges::find_if(made_, [&](const Made& made) { return made.kinds == kinds && made.text == text; });
	if (known != made_.end())
		return known->pipeline;
	Result<gpu::Pipeline> made = make(kinds, expression);
	if (!made)
		return made.error();
	if (Status warm = warmUp(device_, *made, kinds, array); !warm)
		return warm.error();
	made_.push_front({kinds, text, std::make_shared<const gpu::Pipeline>(std::move(*made))});
	if (!first_)
		first_ = made_.front().pipeline;
	if (made_.size() > kKept)
		made_.pop_back();
	return made_.front().pipeline;
}

Result<gpu::Pipeline> SurfacePipelines::make(const PipelineKinds& kinds, const surface::Expression* expression)
{
	gpu::ComputePipelineInfo info = classifyPipelineInfo(device_, kinds);
	const bool storage = gpu::ShaderArray::usesStorage(device_);
	if (!expression)
	{
		info.shader = storage ? "classify_quadric.comp.storage" : "classify_quadric.comp";
		return gpu::Pipeline::create(device_, info, "classify quadric");
	}
	Result<std::vector<std::uint32_t>> codes = gpu::compileComputeShader(
	    std::string(shaders::classifyExpressionSource(storage)) + surface::glslOf(*expression));
	if (!codes)
		return codes.error();
	info.spirv = *codes;
	return gpu::Pipeline::create(device_, info, "classify expression");
}

} // namespace vp::classify
