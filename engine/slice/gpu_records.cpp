#include "slice/gpu_records.h"

#include "gpu/upload.h"

#include <algorithm>

namespace vp::slice
{

static_assert(sizeof(shared::PolygonRecord) == 80, "five texels of sixteen bytes");

std::shared_ptr<RecordPool> RecordPool::create(gpu::Device& device, std::uint32_t page_records)
{
	const std::uint32_t texels =
	    device.limits().maxTexelBufferElements / kRecordTexels - 4; // a buffer may come a little larger
	const std::uint32_t stored = device.limits().maxStorageBufferRange / sizeof(shared::PolygonRecord);
	return std::shared_ptr<RecordPool>(new RecordPool(device, std::min({page_records, texels, stored})));
}

Result<std::shared_ptr<RecordPage>> RecordPool::take(Writer writer)
{
	std::unique_ptr<RecordPage> page;
	{
		const std::lock_guard lock(mutex_);
		const auto free =
		    std::find_if(idle_.begin(), idle_.end(),
		                 [&](const auto& idle) { return writer == Writer::gpu || device_.isDone(idle->last_use); });
		if (free != idle_.end())
		{
			page = std::move(*free);
			idle_.erase(free);
		}
	}
	if (!page)
	{
		page = std::make_unique<RecordPage>();
		const VkDeviceSize bytes = VkDeviceSize(page_records_) * sizeof(shared::PolygonRecord);
		Result<gpu::Buffer> buffer =
		    gpu::Buffer::create(device_, bytes,
		                        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
		                            VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
		                        gpu::Memory::device, "polygon records");
		if (!buffer)
			return buffer.error();
		Result<gpu::TexelView> texels = gpu::TexelView::create(*buffer, VK_FORMAT_R32G32B32A32_UINT, "polygon records");
		if (!texels)
			return texels.error();
		page->buffer = std::move(*buffer);
		page->texels = std::move(*texels);
		const std::lock_guard lock(mutex_);
		++made_;
	}
	return std::shared_ptr<RecordPage>(page.release(),
	                                   [pool = shared_from_this()](RecordPage* returned)
	                                   {
		                                   returned->last_use = pool->device_.lastSubmission();
		                                   const std::lock_guard lock(pool->mutex_);
		                                   pool->idle_.emplace_back(returned);
	                                   });
}

std::size_t RecordPool::bytes() const
{
	const std::lock_guard lock(mutex_);
	return made_ * page_records_ * sizeof(shared::PolygonRecord);
}

std::size_t SheetRecords::count() const
{
	std::size_t sum = 0;
	for (const Page& page : pages)
		sum += page.count;
	return sum;
}

Status SheetRecords::appendHostRecords(std::span<const shared::PolygonRecord> records)
{
	while (!records.empty())
	{
		const std::size_t count = std::min<std::size_t>(records.size(), pool->pageRecords());
		Result<std::shared_ptr<RecordPage>> page = pool->take(RecordPool::Writer::host);
		if (!page)
			return page.error();
		if (Status copied = gpu::upload((*page)->buffer, std::as_bytes(records.first(count))); !copied)
			return copied;
		pages.push_back({std::move(*page), static_cast<std::uint32_t>(count)});
		records = records.subspan(count);
	}
	return Nothing{};
}

bool mayOverlap(const grid::BlockSet& blocks)
{
	return blocks.blocks.size() > 1 ||
	       std::ranges::any_of(blocks.blocks, [](const grid::Block& block) { return !block.inverted.empty(); });
}

Result<std::shared_ptr<SheetRecords>> recordsFromHost(std::shared_ptr<RecordPool> pool,
                                                      std::span<const shared::PolygonRecord> records)
{
	auto sheet = std::make_shared<SheetRecords>(std::move(pool));
	if (Status added = sheet->appendHostRecords(records); !added)
		return added.error();
	return sheet;
}

} // namespace vp::slice
