#include "cut/planes_on_device.h"

#include "base/timeline.h"
#include "mesh/build_mesh.h"
#include "mesh/host_records.h"

namespace vp::cut
{

namespace
{

std::vector<find::SheetInBlock<surface::Plane>> planesInBlocks(const grid::BlockSet& blocks,
                                                               std::span<const SheetCut> sheets)
{
	std::vector<find::SheetInBlock<surface::Plane>> planes;
	for (const SheetCut& sheet : sheets)
		for (const grid::Block& block : blocks.blocks)
			planes.push_back({&block, sheet.sheet.plane(), nullptr, {}});
	return planes;
}

// Classifies what the device leaves to the CPU, as the traversal does.
void walk(const find::SheetInBlock<surface::Plane>& plane, find::CellCut& cut)
{
	grid::CellFaces faces;
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.codes[i] & shared::kCodeWalk)
			cut.codes[i] = std::visit([&](const auto& grid)
			                          { return find::classifyByWalk(grid, plane.surface, cut.cells[i], faces); },
			                          plane.block->grid);
}

} // namespace

PlanesOnDevice::PlanesOnDevice(classify::GpuBlocks& blocks, std::span<SheetCut> sheets, Timeline* timeline)
    : blocks_(blocks), sheets_(sheets), timeline_(timeline), on_cpu_(planesInBlocks(blocks.blocks(), sheets)),
      cpu_(on_cpu_), fronts_(on_cpu_.size())
{
}

Result<std::unique_ptr<PlanesOnDevice>> PlanesOnDevice::create(classify::GpuBlocks& blocks, std::span<SheetCut> sheets,
                                                               Timeline* timeline)
{
	std::vector<probe::Sheet> planes;
	std::vector<std::optional<grid::FieldChoice>> fields;
	for (const SheetCut& sheet : sheets)
	{
		planes.push_back(sheet.sheet);
		fields.push_back(sheet.field);
	}
	Result<classify::PlanesOnGpu> on_gpu = classify::planesOnGpu(blocks, planes, fields);
	if (!on_gpu)
		return on_gpu.error();
	std::unique_ptr<PlanesOnDevice> made(new PlanesOnDevice(blocks, sheets, timeline));
	made->records_ = std::move(on_gpu->records);
	auto classifier = classify::GpuClassifier::create(
	    blocks, std::move(on_gpu->sheets), [cpu = &made->cpu_](auto fronts) { return cpu->classify(fronts); },
	    timeline);
	if (!classifier)
		return classifier.error();
	made->classifier_ = std::move(*classifier);
	return made;
}

Status PlanesOnDevice::classifyKnown()
{
	const std::size_t blocks = blocks_.blocks().blocks.size();
	std::vector<find::Front> fronts;
	std::vector<find::CellCut*> cuts;
	for (std::size_t i = 0; i < on_cpu_.size(); ++i)
	{
		if (i % blocks >= sheets_[i / blocks].cuts.size())
			continue;
		find::BlockCut& known = sheets_[i / blocks].cuts[i % blocks];
		if (known.cutCells() == 0 && (known.hasSpans() || known.cells().cells.empty()))
			continue;
		if (auto* spans = std::get_if<find::SpanCut>(&known.found))
		{
			fronts_[i] = find::asOneFront(*on_cpu_[i].block, known);
			spans->classified_at_once = true;
		}
		cuts.push_back(known.hasSpans() ? &fronts_[i] : &std::get<find::CellCut>(known.found));
		fronts.push_back({i, cuts.back()->cells, cuts.back()->codes});
	}
	if (fronts.empty())
		return Nothing{};
	if (Status done = classifier_->classify(fronts); !done)
		return done;
	for (std::size_t f = 0; f < fronts.size(); ++f)
		walk(on_cpu_[fronts[f].sheet], *cuts[f]);
	return Nothing{};
}

Status PlanesOnDevice::finish()
{
	classifier_.reset(); // waits
	for (std::size_t s = 0; s < sheets_.size(); ++s)
		sheets_[s].records = records_[s];
	return addHostRecords();
}

// Returns the cells of a cut that the CPU walked. The device left their records empty.
find::CellCut PlanesOnDevice::walkedCells(std::size_t sheet, std::size_t block) const
{
	const find::BlockCut& known = sheets_[sheet].cuts[block];
	const find::CellCut& cut =
	    known.hasSpans() ? fronts_[sheet * blocks_.blocks().blocks.size() + block] : known.cells();
	find::CellCut walked;
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.codes[i] & shared::kCodeWalk && cut.codes[i] & shared::kCodeCut)
		{
			walked.cells.push_back(cut.cells[i]);
			walked.codes.push_back(cut.codes[i]);
		}
	walked.cut_cells = walked.cells.size();
	return walked;
}

Status PlanesOnDevice::addHostRecords()
{
	const TimedSection section(timeline_, "emit");
	const grid::BlockSet& blocks = blocks_.blocks();
	for (std::size_t s = 0; s < sheets_.size(); ++s)
	{
		SheetCut& sheet = sheets_[s];
		std::vector<find::BlockCut> walked(blocks.blocks.size());
		std::vector<mesh::ShownBlock> left;
		for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
		{
			if (blocks_.holds(b))
				walked[b].found = walkedCells(s, b);
			left.push_back(
			    mesh::shownBlock(b, blocks_.holds(b) ? walked[b] : sheet.cuts[b], sheet.seeds.faces_in_plane[b]));
		}
		const mesh::SheetMesh mesh = mesh::buildMesh(blocks, sheet.sheet, left);
		if (mesh.polygons() == 0)
			continue;
		const auto records = mesh::recordsFromMesh(blocks, sheet.sheet, mesh, sheet.field);
		if (Status added = sheet.records->appendHostRecords(records); !added)
			return added;
	}
	return Nothing{};
}

} // namespace vp::cut
