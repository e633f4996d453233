#pragma once

#include "grid/imaging.h"
#include "read/protocol.h"
#include "read/read_warning.h"
#include "vprobe-read/arrays/array_writer.h"
#include "vprobe-read/base/array_wish.h"
#include "vprobe-read/base/part_filter.h"
#include "vprobe-read/cells/cell_lists.h"
#include "vprobe-read/convert/convert.h"
#include "vprobe-read/manifest/displacement.h"

#include <nlohmann/json.hpp>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkImageData;
class vtkUnstructuredGrid;

namespace vp::reader::manifest
{

// Describes an array that is not handed over.
nlohmann::json describeLeftOut(const char* association, const std::string& name, grid::NumberType type, int components);

// Turns the data sets of a reader into blocks of the manifest, with their arrays.
class Writer
{
public:
	// `refine`: how many times the linear parts of curved cells are halved, or a tolerance. `keeps`: whether kept() is
	// needed. `parts`: the parts to hand over.
	Writer(double refine, ArrayWish wish, bool keeps, PartFilter parts = {})
	    : refine_(refine), wish_(std::move(wish)), keeps_(keeps), parts_(std::move(parts))
	{
	}

	// Reads a file without VTK and adds its block. Offers the file's times too. Returns false, and adds nothing, if the
	// file is left to VTK. layers: the wanted layers of a lattice; without a value, all layers. stays_above: as of
	// readQuickly().
	bool addQuickly(const std::string& file, int threads, const std::optional<CellLayers>& layers = {},
	                std::uint64_t stays_above = ~std::uint64_t(0));
	// Adds an object that is alone in its file. It may be split into slabs.
	void addLone(vtkDataObject* object);
	// Calls `read`, and returns the data sets that it adds in place of describing them.
	std::vector<vtkSmartPointer<vtkDataSet>> collect(const std::function<void()>& read);
	// Adds layers of an image, or of a rectilinear or curvilinear grid. Its part has been begun.
	void addLayers(vtkDataObject* object, const CellLayers& layers);
	// Adds a grid that was read from a pack. facts: its "pack" (protocol.h), with "flat_cells" and "hidden_cells", and
	// the "facts" about its arrays as "arrays", by "point:NAME" or "cell:NAME", but without lists: its points that are
	// farthest from the center, and the numbers of its cells in the file that was packed.
	void addPack(vtkUnstructuredGrid* grid, nlohmann::json facts, std::span<const std::array<double, 3>> farthest,
	             std::span<const std::uint32_t> numbers);
	// Adds one whose cells stay in their file, as `describe` describes it (protocol.h), and then its facts. Returns
	// false, and adds nothing, if it is not described. Adds nothing either if it is null, since nobody asks for it.
	using DescribePlaces = std::function<std::optional<nlohmann::json>(arrays::Writer& writer)>;
	bool addPackInPlace(const DescribePlaces& describe, const std::function<nlohmann::json()>& factsOfIt,
	                    std::span<const std::array<double, 3>> farthest);
	// Every data set in `object` that holds three-dimensional cells becomes a block.
	void add(vtkDataObject* object);
	// Adds a piece of an image whose subscripts begin with `first`, as a rectilinear block: its points have exactly the
	// places that they have in the whole image.
	void addImageOf(vtkImageData* piece, const std::array<int, 3>& first);
	PartFilter& parts() { return parts_; }
	// Moves the points of what is added from now on.
	void setDisplacement(Displacement displacement) { displacement_ = std::move(displacement); }
	Displacement& displacement() { return displacement_; }
	// Adds the data sets of polygons in `object` as patches of the boundary, by their names. The object may be of any
	// kind, or null.
	void addPatches(vtkDataObject* object);
	// Notes an array of the next data set that was not read, as describeLeftOut() describes it.
	void noteLeftOut(nlohmann::json array) { left_out_.push_back(std::move(array)); }
	// Sets the prefix for the names of blocks that are added from now on.
	void setPrefix(std::string prefix) { prefix_ = std::move(prefix); }
	void offerTimes(std::vector<double> times) { times_ = std::move(times); }
	const std::vector<double>& times() const { return times_; }
	void setLengthUnits(std::string units) { length_units_ = std::move(units); }
	void setImaging(grid::Imaging imaging) { imaging_ = std::move(imaging); }
	// Tells how many resolutions the file has.
	void offerLevels(std::size_t levels) { levels_ = levels; }
	// Throws a Refusal if the file has no such level.
	void refuseOtherLevel(std::size_t level) const;
	void setTimeUnits(std::string units) { time_units_ = std::move(units); }
	void setSandbox(std::string text) { sandbox_ = std::move(text); }
	void warn(std::string line);
	std::vector<std::string> warnings() const; // that were given so far

	bool isEmpty() const { return blocks_.empty(); }
	// Returns the data sets that became blocks.
	const std::vector<convert::KeptBlock>& kept() const { return kept_; }

	// Returns the manifest. Throws a Refusal if there is nothing to slice.
	std::string finish();

private:
	void addDataSet(const std::string& name, vtkDataSet* data);
	bool addSlab(vtkDataSet* data);
	bool describeLattice(vtkDataSet* data, nlohmann::json& block);
	nlohmann::json describeArrays(vtkDataSet* points, vtkDataSet* cells);
	vtkSmartPointer<vtkDataSet> withWishedArrays(vtkDataSet* given, nlohmann::json& left_out) const;
	std::string fullName(const std::string& name) const;
	void addBlock(const std::string& name, nlohmann::json block);
	bool hasWarned(const std::string& line) const;
	nlohmann::json warningsJson() const;

	void keep(const std::string& name, vtkDataSet* data);
	nlohmann::json takePackCounts(nlohmann::json& facts);
	nlohmann::json describePack(nlohmann::json facts, std::span<const std::array<double, 3>> farthest);

	double refine_;
	ArrayWish wish_;
	bool keeps_;
	std::vector<convert::KeptBlock> kept_;
	arrays::Writer writer_{read::kArraysFd};
	arrays::Writer cell_writer_{read::kCellsFd};
	nlohmann::json blocks_ = nlohmann::json::array();
	nlohmann::json patches_ = nlohmann::json::array();
	std::vector<double> times_;
	std::vector<read::ReadWarning> warnings_;
	std::string sandbox_;
	std::string length_units_;
	grid::Imaging imaging_;
	std::string time_units_;
	std::size_t levels_ = 1;
	cells::CellCounts counts_;
	nlohmann::json left_out_ = nlohmann::json::array();
	std::string prefix_;
	PartFilter parts_;
	std::vector<vtkSmartPointer<vtkDataSet>>* collected_ = nullptr; // what is added goes there, if it is not null
	Displacement displacement_;
};

} // namespace vp::reader::manifest
