#include "gpu/shader.h"
#include "gpu/vk_check.h"

namespace vp::gpu
{

// Sets in a pool: enough for some lanes and pages. If they are not enough, more pools are made.
constexpr std::uint32_t kSetsPerPool = 32;

DescriptorSets::DescriptorSets(Device& device, const Pipeline& pipeline, std::string_view name)
    : device_(&device), layout_(pipeline.setLayout()), name_(name)
{
	for (const Binding& binding : pipeline.bindings())
		sizes_.push_back({binding.type, binding.count * kSetsPerPool});
}

DescriptorSets::~DescriptorSets()
{
	for (const VkDescriptorPool pool : pools_)
		device_->retire([pool](VkDevice device) { vkDestroyDescriptorPool(device, pool, nullptr); });
}

Result<VkDescriptorSet> DescriptorSets::get(std::size_t i)
{
	while (i >= sets_.size())
	{
		if (sets_.size() == pools_.size() * kSetsPerPool)
		{
			VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
			info.maxSets = kSetsPerPool;
			info.poolSizeCount = static_cast<std::uint32_t>(sizes_.size());
			info.pPoolSizes = sizes_.data();
			VkDescriptorPool pool = VK_NULL_HANDLE;
			if (Status made =
			        check(vkCreateDescriptorPool(device_->handle(), &info, nullptr, &pool), "vkCreateDescriptorPool");
			    !made)
				return made.error();
			pools_.push_back(pool);
			device_->setName(VK_OBJECT_TYPE_DESCRIPTOR_POOL, pool, name_);
		}
		VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO, nullptr, pools_.back(), 1,
		                                 &layout_};
		VkDescriptorSet set = VK_NULL_HANDLE;
		if (Status made = check(vkAllocateDescriptorSets(device_->handle(), &info, &set), "vkAllocateDescriptorSets");
		    !made)
			return made.error();
		// It gets no name of its own: Mesa 22.3 keeps the names of sets that go with their pool.
		sets_.push_back(set);
	}
	return sets_[i];
}

void DescriptorSets::swap(DescriptorSets& other) noexcept
{
	std::swap(device_, other.device_);
	std::swap(layout_, other.layout_);
	std::swap(sizes_, other.sizes_);
	std::swap(pools_, other.pools_);
	std::swap(sets_, other.sets_);
	std::swap(name_, other.name_);
}

VkWriteDescriptorSet& DescriptorWriter::add(std::uint32_t binding, VkDescriptorType type, std::uint32_t element)
{
	VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
	write.dstBinding = binding;
	write.dstArrayElement = element;
	write.descriptorCount = 1;
	write.descriptorType = type;
	return writes_.emplace_back(write);
}

DescriptorWriter& DescriptorWriter::buffer(std::uint32_t binding, VkDescriptorType type, VkBuffer buffer,
                                           VkDeviceSize offset, VkDeviceSize size)
{
	buffers_.push_back({buffer, offset, size});
	add(binding, type, 0).pBufferInfo = &buffers_.back();
	return *this;
}

DescriptorWriter& DescriptorWriter::texels(std::uint32_t binding, VkBufferView view, VkDescriptorType type)
{
	views_.push_back(view);
	add(binding, type, 0).pTexelBufferView = &views_.back();
	return *this;
}

DescriptorWriter& DescriptorWriter::array(std::uint32_t binding, const ShaderArray::Place& place)
{
	return place.texels ? texels(binding, place.texels) : storageBuffer(binding, place.buffer);
}

DescriptorWriter& DescriptorWriter::storageImage(std::uint32_t binding, VkImageView view)
{
	images_.push_back({VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL});
	add(binding, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 0).pImageInfo = &images_.back();
	return *this;
}

DescriptorWriter& DescriptorWriter::sampledImage(std::uint32_t binding, VkImageView view, VkSampler sampler,
                                                 VkImageLayout layout)
{
	images_.push_back({sampler, view, layout});
	add(binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 0).pImageInfo = &images_.back();
	return *this;
}

void DescriptorWriter::write(const Device& device, VkDescriptorSet set)
{
	for (VkWriteDescriptorSet& write : writes_)
		write.dstSet = set;
	vkUpdateDescriptorSets(device.handle(), static_cast<std::uint32_t>(writes_.size()), writes_.data(), 0, nullptr);
}

} // namespace vp::gpu
