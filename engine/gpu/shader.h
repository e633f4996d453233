#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "gpu/shader_array.h"

#include <array>
#include <deque>
#include <span>
#include <vector>

namespace vp::gpu
{

// One binding of descriptor set 0, the only set a pipeline has.
struct Binding
{
	std::uint32_t binding;
	VkDescriptorType type;
	std::uint32_t count = 1;
};

struct SpecialisationConstant
{
	std::uint32_t id;
	std::uint32_t value; // the bits of an int, uint, float or bool (0, 1)
};

struct ComputePipelineInfo
{
	std::string_view shader; // a name from vp::shaders, as "classify.comp"
	std::vector<Binding> bindings;
	std::uint32_t push_bytes = 0;
	std::vector<SpecialisationConstant> constants;
	std::span<const std::uint32_t> spirv = {}; // in place of a built-in shader
};

// For dynamic rendering; viewport and scissor are dynamic.
struct GraphicsPipelineInfo
{
	std::string_view vertex_shader;
	std::string_view fragment_shader;
	std::vector<Binding> bindings;                 // seen by both stages
	std::uint32_t push_bytes = 0;                  // seen by both stages
	std::vector<SpecialisationConstant> constants; // used by both stages
	std::vector<VkVertexInputBindingDescription> vertex_bindings;
	std::vector<VkVertexInputAttributeDescription> vertex_attributes;
	VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
	VkCullModeFlags cull = VK_CULL_MODE_NONE;
	VkPolygonMode polygon_mode = VK_POLYGON_MODE_FILL;
	VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
	std::vector<VkFormat> color_formats;                     // may be empty
	std::vector<VkPipelineColorBlendAttachmentState> blends; // one a color format; empty writes without blending
	VkFormat depth_format = VK_FORMAT_UNDEFINED;
	bool depth_test = false;
	bool depth_write = false;
	VkCompareOp depth_compare = VK_COMPARE_OP_LESS_OR_EQUAL;
};

VkPipelineColorBlendAttachmentState noBlending();
VkPipelineColorBlendAttachmentState premultipliedOver(); // source over destination, colors premultiplied by alpha

// A compute or graphics pipeline with its layouts. Move-only, as Buffer.
class Pipeline
{
public:
	Pipeline() = default;
	static Result<Pipeline> create(Device& device, const ComputePipelineInfo& info, std::string_view name);
	static Result<Pipeline> create(Device& device, const GraphicsPipelineInfo& info, std::string_view name);
	~Pipeline();
	Pipeline(Pipeline&& other) noexcept { swap(other); }
	Pipeline& operator=(Pipeline&& other) noexcept
	{
		Pipeline taken(std::move(other));
		swap(taken);
		return *this;
	}

	explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }
	VkPipeline handle() const { return handle_; }
	VkPipelineLayout layout() const { return layout_; }
	VkDescriptorSetLayout setLayout() const { return set_layout_; }
	std::span<const Binding> bindings() const { return bindings_; }

	// Binds the pipeline and, unless null, its descriptor set.
	void bind(VkCommandBuffer commands, VkDescriptorSet set = VK_NULL_HANDLE) const;
	void push(VkCommandBuffer commands, const void* data, std::uint32_t bytes) const;
	template <class T>
	void push(VkCommandBuffer commands, const T& data) const
	{
		push(commands, &data, sizeof(T));
	}

private:
	Result<Pipeline> static withLayout(Device& device, std::span<const Binding> bindings, std::uint32_t push_bytes,
	                                   VkShaderStageFlags stages, VkPipelineBindPoint bind_point,
	                                   std::string_view name);
	void swap(Pipeline& other) noexcept;

	Device* device_ = nullptr;
	VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
	VkPipelineLayout layout_ = VK_NULL_HANDLE;
	VkPipeline handle_ = VK_NULL_HANDLE;
	VkPipelineBindPoint bind_point_ = VK_PIPELINE_BIND_POINT_COMPUTE;
	VkShaderStageFlags stages_ = 0;
	std::vector<Binding> bindings_;
};

// Descriptor sets of one pipeline, grown as needed and given back together. A set may be written only while no
// submission uses it.
class DescriptorSets
{
public:
	DescriptorSets() = default;
	DescriptorSets(Device& device, const Pipeline& pipeline, std::string_view name);
	~DescriptorSets();
	DescriptorSets(DescriptorSets&& other) noexcept { swap(other); }
	DescriptorSets& operator=(DescriptorSets&& other) noexcept
	{
		DescriptorSets taken(std::move(other));
		swap(taken);
		return *this;
	}

	// Set number i, made on first use; pointers into the pools stay valid.
	Result<VkDescriptorSet> get(std::size_t i);

private:
	void swap(DescriptorSets& other) noexcept;

	Device* device_ = nullptr;
	VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
	std::vector<VkDescriptorPoolSize> sizes_;
	std::vector<VkDescriptorPool> pools_;
	std::vector<VkDescriptorSet> sets_;
	std::string name_;
};

// Collects what goes into a set, then writes it in one call.
class DescriptorWriter
{
public:
	DescriptorWriter& buffer(std::uint32_t binding, VkDescriptorType type, VkBuffer buffer, VkDeviceSize offset = 0,
	                         VkDeviceSize size = VK_WHOLE_SIZE);
	DescriptorWriter& storageBuffer(std::uint32_t binding, VkBuffer handle, VkDeviceSize offset = 0,
	                                VkDeviceSize size = VK_WHOLE_SIZE)
	{
		return buffer(binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, handle, offset, size);
	}
	DescriptorWriter& uniformBuffer(std::uint32_t binding, VkBuffer handle, VkDeviceSize offset = 0,
	                                VkDeviceSize size = VK_WHOLE_SIZE)
	{
		return buffer(binding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, handle, offset, size);
	}
	DescriptorWriter& texels(std::uint32_t binding, VkBufferView view,
	                         VkDescriptorType type = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER);
	DescriptorWriter& array(std::uint32_t binding, const ShaderArray::Place& place);
	DescriptorWriter& storageImage(std::uint32_t binding, VkImageView view);
	DescriptorWriter& sampledImage(std::uint32_t binding, VkImageView view, VkSampler sampler,
	                               VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
	void write(const Device& device, VkDescriptorSet set);

private:
	VkWriteDescriptorSet& add(std::uint32_t binding, VkDescriptorType type, std::uint32_t element);

	std::vector<VkWriteDescriptorSet> writes_;
	// Deques: what a write points to must not move.
	std::deque<VkDescriptorBufferInfo> buffers_;
	std::deque<VkDescriptorImageInfo> images_;
	std::deque<VkBufferView> views_;
};

} // namespace vp::gpu
