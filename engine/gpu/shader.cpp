#include "gpu/shader.h"

#include "base/timeline.h"
#include "embedded_shaders.h"
#include "gpu/pipeline_figures.h"
#include "gpu/vk_check.h"

#include <fmt/format.h>

#include <cassert>
#include <stdexcept>

namespace vp::gpu
{

namespace
{
// A shader module that lives while a pipeline is made.
class Module
{
public:
	Module(Device& device, std::string_view name) : Module(device, builtIn(name)) {}
	Module(Device& device, std::span<const std::uint32_t> words) : device_(device.handle())
	{
		VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
		info.codeSize = words.size_bytes();
		info.pCode = words.data();
		result_ = vkCreateShaderModule(device_, &info, nullptr, &handle_);
	}
	~Module() { vkDestroyShaderModule(device_, handle_, nullptr); }
	Module(const Module&) = delete;
	Module& operator=(const Module&) = delete;

	VkShaderModule handle() const { return handle_; }
	VkResult result() const { return result_; }

private:
	static std::span<const std::uint32_t> builtIn(std::string_view name)
	{
		const std::span<const std::uint32_t> words = shaders::spirv(name);
		if (words.empty())
			throw std::logic_error(fmt::format("no shader {} was built in", name));
		return words;
	}

	VkDevice device_;
	VkShaderModule handle_ = VK_NULL_HANDLE;
	VkResult result_;
};

// Specialization constants in Vulkan's layout.
struct Specialisation
{
	explicit Specialisation(std::span<const SpecialisationConstant> constants)
	{
		for (const SpecialisationConstant& constant : constants)
		{
			entries.push_back({constant.id, static_cast<std::uint32_t>(4 * values.size()), 4});
			values.push_back(constant.value);
		}
		info = {static_cast<std::uint32_t>(entries.size()), entries.data(), 4 * values.size(), values.data()};
	}
	Specialisation(const Specialisation&) = delete;
	Specialisation& operator=(const Specialisation&) = delete;

	std::vector<VkSpecializationMapEntry> entries;
	std::vector<std::uint32_t> values;
	VkSpecializationInfo info{};
};

VkPipelineCreateFlags flagsOf(const Device& device)
{
	return tellsPipelineFigures(device) ? VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR : 0;
}

std::string sectionName(std::string_view pipeline)
{
	return fmt::format("pipeline {}", pipeline);
}

VkPipelineShaderStageCreateInfo stageInfo(VkShaderStageFlagBits stage, const Module& module,
                                          const Specialisation& constants)
{
	VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
	info.stage = stage;
	info.module = module.handle();
	info.pName = "main";
	info.pSpecializationInfo = &constants.info;
	return info;
}
} // namespace

VkPipelineColorBlendAttachmentState noBlending()
{
	VkPipelineColorBlendAttachmentState blend{};
	blend.colorWriteMask =
	    VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
	return blend;
}

VkPipelineColorBlendAttachmentState premultipliedOver()
{
	VkPipelineColorBlendAttachmentState blend = noBlending();
	blend.blendEnable = VK_TRUE;
	blend.srcColorBlendFactor = blend.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
	blend.dstColorBlendFactor = blend.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
	return blend;
}

Result<Pipeline> Pipeline::withLayout(Device& device, std::span<const Binding> bindings, std::uint32_t push_bytes,
                                      VkShaderStageFlags stages, VkPipelineBindPoint bind_point, std::string_view name)
{
	Pipeline pipeline;
	pipeline.device_ = &device;
	pipeline.bind_point_ = bind_point;
	pipeline.stages_ = stages;
	pipeline.bindings_.assign(bindings.begin(), bindings.end());

	std::vector<VkDescriptorSetLayoutBinding> layout_bindings;
	for (const Binding& binding : bindings)
		layout_bindings.push_back({binding.binding, binding.type, binding.count, stages, nullptr});
	VkDescriptorSetLayoutCreateInfo set_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
	set_info.bindingCount = static_cast<std::uint32_t>(layout_bindings.size());
	set_info.pBindings = layout_bindings.data();
	if (Status made = check(vkCreateDescriptorSetLayout(device.handle(), &set_info, nullptr, &pipeline.set_layout_),
	                        "vkCreateDescriptorSetLayout");
	    !made)
		return made.error();
	device.setName(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, pipeline.set_layout_, name);

	assert(push_bytes <= device.limits().maxPushConstantsSize);
	const VkPushConstantRange push{stages, 0, push_bytes};
	VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
	info.setLayoutCount = 1;
	info.pSetLayouts = &pipeline.set_layout_;
	info.pushConstantRangeCount = push_bytes ? 1 : 0;
	info.pPushConstantRanges = &push;
	if (Status made =
	        check(vkCreatePipelineLayout(device.handle(), &info, nullptr, &pipeline.layout_), "vkCreatePipelineLayout");
	    !made)
		return made.error();
	device.setName(VK_OBJECT_TYPE_PIPELINE_LAYOUT, pipeline.layout_, name);
	return pipeline;
}

Result<Pipeline> Pipeline::create(Device& device, const ComputePipelineInfo& info, std::string_view name)
{
	const std::string section_name = sectionName(name);
	const TimedSection section(Timeline::tracingHere(), section_name, 0, Timeline::Track::setup);
	Result<Pipeline> pipeline = withLayout(device, info.bindings, info.push_bytes, VK_SHADER_STAGE_COMPUTE_BIT,
	                                       VK_PIPELINE_BIND_POINT_COMPUTE, name);
	if (!pipeline)
		return pipeline.error();
	const Module module = info.spirv.empty() ? Module(device, info.shader) : Module(device, info.spirv);
	if (Status made = check(module.result(), "vkCreateShaderModule"); !made)
		return made.error();
	const Specialisation constants(info.constants);
	VkComputePipelineCreateInfo create{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
	create.flags = flagsOf(device);
	create.stage = stageInfo(VK_SHADER_STAGE_COMPUTE_BIT, module, constants);
	create.layout = pipeline->layout_;
	if (Status made = check(
	        vkCreateComputePipelines(device.handle(), device.pipelineCache(), 1, &create, nullptr, &pipeline->handle_),
	        "vkCreateComputePipelines");
	    !made)
		return made.error();
	device.setName(VK_OBJECT_TYPE_PIPELINE, pipeline->handle_, name);
	if (create.flags)
		addPipelineFigures(device, pipeline->handle_, name);
	return pipeline;
}

Result<Pipeline> Pipeline::create(Device& device, const GraphicsPipelineInfo& info, std::string_view name)
{
	const std::string section_name = sectionName(name);
	const TimedSection section(Timeline::tracingHere(), section_name, 0, Timeline::Track::setup);
	assert(info.blends.empty() || info.blends.size() == info.color_formats.size());
	Result<Pipeline> pipeline =
	    withLayout(device, info.bindings, info.push_bytes, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT,
	               VK_PIPELINE_BIND_POINT_GRAPHICS, name);
	if (!pipeline)
		return pipeline.error();
	const Module vertex(device, info.vertex_shader);
	const Module fragment(device, info.fragment_shader);
	for (const Module* module : {&vertex, &fragment})
		if (Status made = check(module->result(), "vkCreateShaderModule"); !made)
			return made.error();
	const Specialisation constants(info.constants);
	const std::array stages{stageInfo(VK_SHADER_STAGE_VERTEX_BIT, vertex, constants),
	                        stageInfo(VK_SHADER_STAGE_FRAGMENT_BIT, fragment, constants)};

	VkPipelineVertexInputStateCreateInfo vertex_input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
	vertex_input.vertexBindingDescriptionCount = static_cast<std::uint32_t>(info.vertex_bindings.size());
	vertex_input.pVertexBindingDescriptions = info.vertex_bindings.data();
	vertex_input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(info.vertex_attributes.size());
	vertex_input.pVertexAttributeDescriptions = info.vertex_attributes.data();
	VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
	assembly.topology = info.topology;
	VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
	viewport.viewportCount = viewport.scissorCount = 1;
	VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
	raster.polygonMode = info.polygon_mode;
	raster.cullMode = info.cull;
	raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
	raster.lineWidth = 1.0f;
	VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
	samples.rasterizationSamples = info.samples;
	VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
	depth.depthTestEnable = info.depth_test;
	depth.depthWriteEnable = info.depth_write;
	depth.depthCompareOp = info.depth_compare;
	std::vector<VkPipelineColorBlendAttachmentState> blends = info.blends;
	blends.resize(info.color_formats.size(), noBlending());
	VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
	blend.attachmentCount = static_cast<std::uint32_t>(blends.size());
	blend.pAttachments = blends.data();
	const std::array dynamic_states{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
	VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
	dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamic_states.size());
	dynamic.pDynamicStates = dynamic_states.data();
	VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
	rendering.colorAttachmentCount = static_cast<std::uint32_t>(info.color_formats.size());
	rendering.pColorAttachmentFormats = info.color_formats.data();
	rendering.depthAttachmentFormat = info.depth_format;

	VkGraphicsPipelineCreateInfo create{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
	create.pNext = &rendering;
	create.flags = flagsOf(device);
	create.stageCount = static_cast<std::uint32_t>(stages.size());
	create.pStages = stages.data();
	create.pVertexInputState = &vertex_input;
	create.pInputAssemblyState = &assembly;
	create.pViewportState = &viewport;
	create.pRasterizationState = &raster;
	create.pMultisampleState = &samples;
	create.pDepthStencilState = &depth;
	create.pColorBlendState = &blend;
	create.pDynamicState = &dynamic;
	create.layout = pipeline->layout_;
	if (Status made = check(
	        vkCreateGraphicsPipelines(device.handle(), device.pipelineCache(), 1, &create, nullptr, &pipeline->handle_),
	        "vkCreateGraphicsPipelines");
	    !made)
		return made.error();
	device.setName(VK_OBJECT_TYPE_PIPELINE, pipeline->handle_, name);
	if (create.flags)
		addPipelineFigures(device, pipeline->handle_, name);
	return pipeline;
}

Pipeline::~Pipeline()
{
	if (device_)
		device_->retire(
		    [handle = handle_, layout = layout_, set_layout = set_layout_](VkDevice device)
		    {
			    vkDestroyPipeline(device, handle, nullptr);
			    vkDestroyPipelineLayout(device, layout, nullptr);
			    vkDestroyDescriptorSetLayout(device, set_layout, nullptr);
		    });
}

void Pipeline::bind(VkCommandBuffer commands, VkDescriptorSet set) const
{
	vkCmdBindPipeline(commands, bind_point_, handle_);
	if (set)
		vkCmdBindDescriptorSets(commands, bind_point_, layout_, 0, 1, &set, 0, nullptr);
}

void Pipeline::push(VkCommandBuffer commands, const void* data, std::uint32_t bytes) const
{
	vkCmdPushConstants(commands, layout_, stages_, 0, bytes, data);
}

void Pipeline::swap(Pipeline& other) noexcept
{
	std::swap(device_, other.device_);
	std::swap(set_layout_, other.set_layout_);
	std::swap(layout_, other.layout_);
	std::swap(handle_, other.handle_);
	std::swap(bind_point_, other.bind_point_);
	std::swap(stages_, other.stages_);
	std::swap(bindings_, other.bindings_);
}

} // namespace vp::gpu
