#include "classify/gpu_records.h"

#include "gpu/upload.h"

#include <algorithm>

namespace vp::classify
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
		idle_.reserve(made_ + 1); // whoever gives a page back may not fail
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

namespace
{

// write(first, to) writes records into memory of the host or the device.
template <class Write>
Status appendRecords(SheetRecords& sheet, std::size_t records, const Write& write)
{
	for (std::size_t begun = 0; begun < records;)
	{
		const std::size_t count = std::min<std::size_t>(records - begun, sheet.pool->pageRecords());
		Result<std::shared_ptr<RecordPage>> page = sheet.pool->take(RecordPool::Writer::host);
		if (!page)
			return page.error();
		Status filled =
		    gpu::fillBuffer((*page)->buffer, count, sizeof(shared::PolygonRecord),
		                    [&](std::byte* to, std::size_t first, std::size_t run)
		                    { write(begun + first, std::span(reinterpret_cast<shared::PolygonRecord*>(to), run)); });
		if (!filled)
			return filled;
		sheet.pages.push_back({std::move(*page), static_cast<std::uint32_t>(count)});
		begun += count;
	}
	return Nothing{};
}

} // namespace

Status SheetRecords::appendHostRecords(std::span<const shared::PolygonRecord> records)
{
	return appendRecords(*this, records.size(),
	                     [&](std::size_t first, std::span<shared::PolygonRecord> to)
	                     { std::copy_n(records.begin() + static_cast<std::ptrdiff_t>(first), to.size(), to.begin()); });
}

Status SheetRecords::appendHostRecords(const mesh::MeshRecords& records)
{
	return appendRecords(*this, records.count(),
	                     [&](std::size_t first, std::span<shared::PolygonRecord> to) { records.write(first, to); });
}

namespace
{

// More than rounding makes neighbors do.
bool overlap(const Box& a, const Box& b)
{
	constexpr double kRounding = 1e-9;
	for (int axis = 0; axis < 3; ++axis)
	{
		const double shared = std::min(a.hi[axis], b.hi[axis]) - std::max(a.lo[axis], b.lo[axis]);
		if (shared <= kRounding * std::max(a.hi[axis] - a.lo[axis], b.hi[axis] - b.lo[axis]))
			return false;
	}
	return true;
}

} // namespace

bool mayFold(const grid::BlockSet& blocks)
{
	return std::ranges::any_of(blocks.blocks, [](const grid::Block& block) { return !block.inverted.empty(); });
}

bool mayOverlap(const grid::BlockSet& blocks)
{
	constexpr std::size_t kMaxLookedAt = 64;
	if (blocks.blocks.size() > kMaxLookedAt || mayFold(blocks))
		return true;
	for (const grid::Block& block : blocks.blocks)
		for (const grid::Block* other = blocks.blocks.data(); other != &block; ++other)
			if (overlap(block.bounds, other->bounds))
				return true;
	return false;
}

namespace
{

mesh::UvBounds uvBoundsOf(const shared::PolygonRecord& record)
{
	mesh::UvBounds bounds;
	for (std::uint32_t i = 0; i < (record.vertices & shared::kRecordVertices); ++i)
		bounds = bounds.with(glm::dvec2(record.uv[2 * i], record.uv[2 * i + 1]));
	return bounds;
}

template <class Records>
Result<std::shared_ptr<SheetRecords>> sheetOf(std::shared_ptr<RecordPool> pool, const Records& records,
                                              const mesh::UvBounds& bounds, double longest)
{
	auto sheet = std::make_shared<SheetRecords>(std::move(pool));
	sheet->bounds = bounds;
	sheet->longest = longest;
	if (Status added = sheet->appendHostRecords(records); !added)
		return added.error();
	return sheet;
}

} // namespace

Result<std::shared_ptr<SheetRecords>> recordsFromHost(std::shared_ptr<RecordPool> pool,
                                                      std::span<const shared::PolygonRecord> records)
{
	mesh::UvBounds bounds;
	double longest = 0.0;
	for (const shared::PolygonRecord& record : records)
	{
		const mesh::UvBounds of_record = uvBoundsOf(record);
		bounds = bounds.with(of_record);
		longest = std::max(longest, glm::distance(of_record.lo, of_record.hi));
	}
	return sheetOf(std::move(pool), records, bounds, longest);
}

Result<std::shared_ptr<SheetRecords>> recordsFromMesh(std::shared_ptr<RecordPool> pool,
                                                      const mesh::MeshRecords& records)
{
	constexpr std::size_t kMaxParts = 256; // each is drawn for itself
	auto sheet = sheetOf(std::move(pool), records, records.bounds(), records.longest());
	if (!sheet)
		return sheet;
	(*sheet)->overlapping = records.parts().size() > kMaxParts;
	if (!(*sheet)->overlapping)
		(*sheet)->parts = records.parts();
	return sheet;
}

} // namespace vp::classify
