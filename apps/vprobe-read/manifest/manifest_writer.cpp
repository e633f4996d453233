#include "manifest_writer.h"

#include "read/tolerance.h"
#include "time_choice.h"
#include "vprobe-read/base/bytes_read.h"
#include "vprobe-read/base/read_files.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/curved_cells.h"
#include "vprobe-read/cells/linearize.h"
#include "vprobe-read/cells/patch_polygons.h"
#include "vprobe-read/cells/structured_blocks.h"
#include "vprobe-read/cells/visible_cells.h"
#include "vprobe-read/checks/complaints.h"
#include "vprobe-read/quick/quick_xml.h"

#include <vtkCellTypes.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointSet.h>
#include <vtkRectilinearGrid.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace vp::reader::manifest
{

using nlohmann::json;

namespace
{

std::string typeName(std::uint8_t type)
{
	std::string_view name = vtkCellTypes::GetClassNameFromTypeId(type);
	if (name.starts_with("vtk"))
		name.remove_prefix(3);
	return std::string(name);
}

// The Exodus reader makes up a name for a set that has only a number.
std::string nameOf(std::string_view patch)
{
	constexpr std::string_view unnamed = "Unnamed set ID: ";
	return std::string(patch.starts_with(unnamed) ? patch.substr(unnamed.size()) : patch);
}

} // namespace

void Writer::add(vtkDataObject* object)
{
	if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
	{
		const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
		std::size_t number = 0;
		for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem(), ++number)
		{
			vtkInformation* about = leaf->HasCurrentMetaData() ? leaf->GetCurrentMetaData() : nullptr;
			const char* name = about ? about->Get(vtkCompositeDataSet::NAME()) : nullptr;
			addDataSet(name ? name : fmt::format("block {}", number),
			           vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject()));
		}
	}
	else
		addDataSet("", vtkDataSet::SafeDownCast(object));
}

std::vector<vtkSmartPointer<vtkDataSet>> Writer::collect(const std::function<void()>& read)
{
	std::vector<vtkSmartPointer<vtkDataSet>> found;
	PartFilter parts = std::exchange(parts_, {});
	collected_ = &found;
	read();
	collected_ = nullptr;
	parts_ = std::move(parts);
	return found;
}

// Files of one kind say the same of themselves.
void Writer::warn(std::string line)
{
	if (!collected_ || !hasWarned(line))
		warnings_.push_back({.words = std::move(line)});
}

std::vector<std::string> Writer::warnings() const
{
	std::vector<std::string> lines;
	for (const read::ReadWarning& warning : warnings_)
		lines.push_back(warning.text());
	return lines;
}

bool Writer::hasWarned(const std::string& line) const
{
	return std::ranges::find(warnings_, line, &read::ReadWarning::words) != warnings_.end();
}

json Writer::warningsJson() const
{
	json warnings = json::array();
	for (const read::ReadWarning& warning : warnings_)
		if (warning.count > 0)
			warnings.push_back({{"count", warning.count}, {"words", warning.words}});
		else
			warnings.push_back(warning.words);
	return warnings;
}

void Writer::addPatches(vtkDataObject* object)
{
	auto* composite = vtkCompositeDataSet::SafeDownCast(object);
	if (!composite)
		return;
	const auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
	std::size_t number = 0;
	for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem(), ++number)
	{
		const vtkSmartPointer<vtkPointSet> data =
		    leaf->GetCurrentDataObject()->IsA("vtkPointSet")
		        ? displacement_.movedPatch(vtkPointSet::SafeDownCast(leaf->GetCurrentDataObject()))
		        : nullptr;
		json patch = data ? cells::describePolygons(cell_writer_, data) : json();
		if (patch.is_null())
			continue;
		const char* name =
		    leaf->HasCurrentMetaData() ? leaf->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) : nullptr;
		patch["name"] = name ? nameOf(name) : fmt::format("patch {}", number);
		patches_.push_back(std::move(patch));
	}
}

void Writer::addDataSet(const std::string& name, vtkDataSet* read)
{
	json left_out = std::exchange(left_out_, json::array());
	if (read && collected_)
	{
		// A reader may use its data set again for the next file.
		collected_->push_back(vtkSmartPointer<vtkDataSet>::Take(read->NewInstance()));
		collected_->back()->ShallowCopy(read);
		return;
	}
	if (!read || read->GetNumberOfCells() == 0 || !parts_.begin(static_cast<std::size_t>(read->GetNumberOfCells())))
		return;
	const vtkSmartPointer<vtkDataSet> given = displacement_.moved(read);
	const vtkSmartPointer<vtkDataSet> wanted =
	    wish_.all ? vtkSmartPointer<vtkDataSet>(given) : withWishedArrays(given, left_out);
	vtkDataSet* data = wanted;
	json block;
	vtkDataSet* point_data = data;
	std::optional<cells::LinearCells> linear;
	if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
	{
		const vtkIdType file_points = grid->GetNumberOfPoints();
		const bool curved = read::isTolerance(refine_) && cells::keepsCurved(grid, refine_);
		if (!curved)
			linear = cells::linearize(grid, static_cast<int>(refine_));
		if (linear)
			point_data = grid = linear->grid;
		json cells = cells::writeCells(cell_writer_, grid, counts_, curved);
		if (cells.is_null())
			return;
		if (linear)
		{
			cells["source_cells"] =
			    arrays::writeInt64(cell_writer_, std::span<const std::int64_t>(linear->source_cells));
			cells["source_cell_count"] = data->GetNumberOfCells();
			cells["source_point_count"] = file_points;
		}
		block = {{"kind", "unstructured"}, {"coordinates", cells::writeCoordinates(cell_writer_, grid->GetPoints())}};
		block["cells"] = std::move(cells);
	}
	else if (!describeLattice(data, block))
		return;
	block["arrays"] = describeArrays(point_data, data);
	for (json& array : left_out)
		block["arrays"].push_back(std::move(array));
	addBlock(name, std::move(block));
	if (keeps_)
		keep(name, wanted);
}

void Writer::addPack(vtkUnstructuredGrid* grid, json facts, std::span<const std::array<double, 3>> farthest,
                     std::span<const std::uint32_t> numbers)
{
	const std::size_t before = blocks_.size();
	const cells::CellCounts counts = counts_;
	addDataSet("", grid);
	if (blocks_.size() == before)
		return;
	counts_ = counts; // the file tells them
	json& block = blocks_.back();
	const json of_arrays = takePackCounts(facts);
	for (json& array : block["arrays"])
		if (const std::string key =
		        fmt::format("{}:{}", array.at("association").get<std::string>(), array.at("name").get<std::string>());
		    of_arrays.contains(key))
			array["facts"] = of_arrays.at(key);
	block["pack"] = describePack(std::move(facts), farthest);
	block["pack"]["numbers"] = arrays::writeInt64(cell_writer_, numbers);
}

// Takes what is told elsewhere out of the facts. Returns those about arrays.
json Writer::takePackCounts(json& facts)
{
	counts_.flat += facts.at("flat_cells").get<std::size_t>();
	counts_.hidden += facts.at("hidden_cells").get<std::size_t>();
	json of_arrays = std::exchange(facts["arrays"], {});
	for (const char* told : {"arrays", "flat_cells", "hidden_cells"})
		facts.erase(told);
	return of_arrays;
}

json Writer::describePack(json facts, std::span<const std::array<double, 3>> farthest)
{
	if (!farthest.empty())
		facts["farthest"] = writer_.write(grid::NumberType::float64, farthest.data(), farthest.size_bytes());
	return facts;
}

bool Writer::addPackInPlace(const DescribePlaces& describe, const std::function<json()>& factsOfIt,
                            std::span<const std::array<double, 3>> farthest)
{
	std::optional<json> block = displacement_.isOn() ? std::nullopt : describe(writer_);
	if (!block || block->is_null())
		return block.has_value();
	json facts = factsOfIt();
	takePackCounts(facts);
	(*block)["pack"] = describePack(std::move(facts), farthest);
	for (json& array : left_out_)
		(*block)["arrays"].push_back(std::move(array));
	left_out_ = json::array();
	addBlock("", std::move(*block));
	return true;
}

void Writer::addImageOf(vtkImageData* piece, const std::array<int, 3>& first)
{
	if (displacement_.isOn())
		return add(piece);
	json block;
	json left_out = std::exchange(left_out_, json::array());
	const vtkSmartPointer<vtkDataSet> wanted =
	    wish_.all ? vtkSmartPointer<vtkDataSet>(piece) : withWishedArrays(piece, left_out);
	if (piece->GetNumberOfCells() == 0 || !describeLattice(piece, block))
		return;
	if (block["kind"] == "image")
		block = cells::describeImageOf(writer_, piece, first);
	block["arrays"] = describeArrays(wanted, wanted);
	for (const json& array : left_out)
		block["arrays"].push_back(array);
	addBlock("", std::move(block));
}

// Keeps a copy, since a reader may use its data set again for the next file.
void Writer::keep(const std::string& name, vtkDataSet* data)
{
	const auto copy = vtkSmartPointer<vtkDataSet>::Take(data->NewInstance());
	copy->ShallowCopy(data);
	kept_.push_back({fullName(name), copy});
}

std::string Writer::fullName(const std::string& name) const
{
	return prefix_.empty() ? name : name.empty() ? prefix_ : prefix_ + "/" + name;
}

void Writer::addBlock(const std::string& name, json block)
{
	block["name"] = fullName(name);
	if (parts_.filters())
		block["part"] = parts_.number();
	blocks_.push_back(std::move(block));
}

bool Writer::addQuickly(const std::string& file, int threads, const std::optional<CellLayers>& layers,
                        std::uint64_t stays_above)
{
	if (displacement_.isOn() || collected_)
		return false;
	std::optional<quick::Block> quick =
	    quick::readQuickly(file, wish_, threads, writer_, cell_writer_, layers, stays_above);
	if (!quick)
		return false;
	counts_.flat += quick->flat;
	addBlock("", std::move(quick->block));
	offerTimes(inOrder(std::move(quick->times)));
	return true;
}

// Returns false if there is nothing to show: for flat lattices, for kinds of data sets that never hold
// three-dimensional cells, and if all cells are hidden.
bool Writer::describeLattice(vtkDataSet* data, json& block)
{
	std::array<int, 3> points = {0, 0, 0};
	auto* image = vtkImageData::SafeDownCast(data);
	auto* rectilinear = vtkRectilinearGrid::SafeDownCast(data);
	auto* curvilinear = vtkStructuredGrid::SafeDownCast(data);
	if (image)
		image->GetDimensions(points.data());
	else if (rectilinear)
		rectilinear->GetDimensions(points.data());
	else if (curvilinear)
		curvilinear->GetDimensions(points.data());
	if (points[0] < 2 || points[1] < 2 || points[2] < 2)
	{
		counts_.flat += static_cast<std::size_t>(data->GetNumberOfCells());
		return false;
	}

	if (const std::vector<unsigned char> marks = cells::hiddenCellsOf(data, points); !marks.empty())
	{
		const auto visible = static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 0));
		counts_.hidden += marks.size() - visible;
		if (visible > 0)
			block = cells::describeVisible(cell_writer_, data, points, marks);
		return visible > 0;
	}
	block = image         ? cells::describeImage(writer_, image)
	        : rectilinear ? cells::describeRectilinear(writer_, rectilinear)
	                      : cells::describeCurvilinear(writer_, curvilinear);
	return true;
}

void Writer::refuseOtherLevel(std::size_t level) const
{
	if (level >= levels_)
		throw Refusal(levels_ == 1
		                  ? fmt::format("--level {}: it has one level; leave this out", level)
		                  : fmt::format("--level {}: it has levels 0 to {}; take one of them", level, levels_ - 1));
}

std::string Writer::finish()
{
	for (const auto& [type, cells] : counts_.not_sliced)
		warnings_.push_back({cells, fmt::format("cells of type {} are not shown", typeName(type))});
	if (counts_.hidden > 0)
		warnings_.push_back({counts_.hidden, "ghost or hidden cells are left out"});
	if (counts_.trimmed > 0)
		warnings_.push_back({counts_.trimmed, "cells list more points than their type has; the first ones are used"});
	if (blocks_.empty() && !parts_.filters())
	{
		if (!counts_.not_sliced.empty())
			throw Refusal(
			    fmt::format("nothing to slice: cells of type {} cannot be sliced yet; convert them to linear cells",
			                typeName(counts_.not_sliced.begin()->first)));
		if (counts_.hidden > 0)
			throw Refusal(
			    fmt::format("nothing to slice: all its cells are marked as hidden or as ghosts ({}); take the "
			                "marks away to see them",
			                counts_.hidden));
		if (keeps_ || counts_.flat > 0)
			throw Refusal("nothing to slice: it holds no three-dimensional cells");
	}
	if (std::string note = displacement_.note(); !note.empty())
		warn(std::move(note));
	for (std::string& note : checks::takeNotes())
		warnings_.push_back({.words = std::move(note)});
	json manifest = {{"version", read::kProtocolVersion}, {"times", times_},      {"left_out", counts_.flat},
	                 {"warnings", warningsJson()},        {"files", filesRead()}, {"sandbox", sandbox_},
	                 {"bytes_read", bytesRead()},         {"blocks", blocks_},    {"patches", patches_}};
	if (parts_.filters())
	{
		if (parts_.parts().empty())
			throw Refusal("nothing to slice: it holds no three-dimensional cells");
		manifest["parts"] = parts_.parts();
		manifest["wholes"] = parts_.blocks();
	}
	if (!length_units_.empty())
		manifest["length_units"] = length_units_;
	if (imaging_ != grid::Imaging{})
	{
		json& imaging = manifest["imaging"] = {
		    {"orientation", imaging_.orientation}, {"gray", imaging_.gray}, {"labels", imaging_.labels}};
		if (!imaging_.label_names.empty())
			imaging["label_names"] = imaging_.label_names;
		if (imaging_.window)
			imaging["window"] = {imaging_.window->first, imaging_.window->second};
	}
	if (levels_ > 1)
		manifest["levels"] = levels_;
	if (!time_units_.empty() && !times_.empty())
		manifest["time_units"] = time_units_;
	// Names in files need not be UTF-8.
	return manifest.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace vp::reader::manifest
