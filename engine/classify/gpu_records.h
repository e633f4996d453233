#pragma once

#include "gpu/buffer.h"
#include "grid/block.h"
#include "mesh/mesh_records.h"
#include "shared/slice_types.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace vp::classify
{

// Room for polygon records in device memory: a storage buffer in scalar layout, and the same seen as RGBA32UI texels,
// five a record, which software devices read faster.
struct RecordPage
{
	gpu::Buffer buffer;
	gpu::TexelView texels;
	std::uint64_t last_use = 0; // submission after which nobody reads the page; set when it is given back
};

constexpr std::uint32_t kRecordTexels = sizeof(shared::PolygonRecord) / 16;

// Pages lent to slices and taken back when the last holder of a slice lets go. Thread safe.
class RecordPool : public std::enable_shared_from_this<RecordPool>
{
public:
	// 5 MiB a page; a smaller page is for tests.
	static constexpr std::uint32_t kPageRecords = 65536;

	static std::shared_ptr<RecordPool> create(gpu::Device& device, std::uint32_t page_records = kPageRecords);

	// A page for the host to write must not be in use by a submission; one for the GPU may, as submissions run in order
	// with a barrier before they write.
	enum class Writer
	{
		gpu,
		host
	};
	Result<std::shared_ptr<RecordPage>> take(Writer writer);

	gpu::Device& device() const { return device_; }
	std::uint32_t pageRecords() const { return page_records_; }
	std::size_t bytes() const; // bytes of all pages, lent or not

private:
	RecordPool(gpu::Device& device, std::uint32_t page_records) : device_(device), page_records_(page_records) {}

	gpu::Device& device_;
	std::uint32_t page_records_;
	mutable std::mutex mutex_;
	std::vector<std::unique_ptr<RecordPage>> idle_;
	std::size_t made_ = 0;
};

// A sheet's polygons as they lie in device memory: draw the first `count` records of every page. Whatever is submitted
// after the classifier's last generation sees them; no further barrier is needed to read them in a shader.
struct SheetRecords
{
	struct Page
	{
		std::shared_ptr<const RecordPage> page;
		std::uint32_t count = 0;

		VkBuffer buffer() const { return page->buffer.handle(); }
		VkBufferView texels() const { return page->texels.handle(); }
	};
	// Which cells records belong to: record `first + i` of a page is for cell `first_cell + i` of the block's CellCut.
	// Records from the CPU have no run; they carry the cell only.
	struct Run
	{
		std::uint32_t page;
		std::uint32_t first;
		std::uint32_t count;
		std::uint32_t block;
		std::uint32_t first_cell;
	};

	explicit SheetRecords(std::shared_ptr<RecordPool> from) : pool(std::move(from)) {}

	std::shared_ptr<RecordPool> pool;
	std::vector<Page> pages;
	std::vector<Run> runs;
	std::optional<mesh::UvBounds> bounds; // bounds of all polygons, if they are known
	std::optional<double> longest;        // greatest diagonal of a polygon's bounds, if it is known
	// Polygons may cover each other, and the last one counts; or polygons of different parts may, and that of the later
	// part counts. parts: numbers of the records, over all pages, with which each part after the first begins.
	bool overlapping = false;
	std::vector<std::size_t> parts;

	std::size_t count() const; // number of records, including those without vertices

	// Adds pages of records made on the CPU: cells that were walked, and blocks that the device does not hold.
	Status appendHostRecords(std::span<const shared::PolygonRecord> records);
	Status appendHostRecords(const mesh::MeshRecords& records);
};

// Returns true if polygons of a plane's cut within one block may lie on each other: where the grid is folded over.
bool mayFold(const grid::BlockSet& blocks);
// Returns true if any polygons may lie on each other, also of blocks whose boxes overlap. With many blocks the boxes
// are not compared, and the answer is true.
bool mayOverlap(const grid::BlockSet& blocks);

// All records from the CPU: the path of the CPU classifier.
Result<std::shared_ptr<SheetRecords>> recordsFromHost(std::shared_ptr<RecordPool> pool,
                                                      std::span<const shared::PolygonRecord> records);

// Those of a mesh, written straight into device memory where that is mapped; blocks are parts.
Result<std::shared_ptr<SheetRecords>> recordsFromMesh(std::shared_ptr<RecordPool> pool,
                                                      const mesh::MeshRecords& records);

} // namespace vp::classify
