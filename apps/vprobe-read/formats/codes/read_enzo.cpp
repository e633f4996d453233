// Data of the code Enzo: a text that lists boxes (.hierarchy), and HDF5 files with their values. By a parser of our
// own: VTK's takes only the last digit of a variable's index for its factor, and loops for ever where the text ends
// early.
#include "enzo_hierarchy.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/boxes/amr_cover.h"
#include "vprobe-read/boxes/cell_boxes.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

namespace vp::reader::codes
{

namespace
{

namespace fs = std::filesystem;

// The files of values, each opened when a box of it is first met; the last one stays open.
class EnzoFiles
{
public:
	explicit EnzoFiles(const std::string& hierarchy) : folder_(fs::path(hierarchy).parent_path()) {}

	const hdf5::File& operator[](const std::string& name)
	{
		if (name != name_ || !file_)
		{
			// Files are named from the folder that the code ran in; they lie beside the text.
			const std::string path = (folder_ / fs::path(name).filename()).string();
			if (!fs::is_regular_file(path))
				throw Refusal(fmt::format("its file {} cannot be opened; keep them together", path));
			file_ = std::make_unique<hdf5::File>(path);
			name_ = name;
		}
		return *file_;
	}

private:
	fs::path folder_;
	std::string name_;
	std::unique_ptr<hdf5::File> file_;
};

// Packed files have a group for each box.
std::string enzoGroup(const hdf5::File& file, std::size_t number)
{
	const std::string group = fmt::format("/Grid{:08}", number);
	if (file.has(group))
		return group + "/";
	if (std::ranges::any_of(file.namesIn("/"), [](const std::string& name) { return name.starts_with("Grid0"); }))
		throw damaged(fmt::format("a file of its values has no group for grid {}", number));
	return "/";
}

// The variables that a box has at its cells; particles have one dimension.
std::vector<boxes::CellArrayName> enzoVariables(const hdf5::File& file, const std::string& group,
                                                const boxes::CellBox& box)
{
	std::vector<boxes::CellArrayName> names;
	const std::vector<std::uint64_t> wanted = {box.cells[2], box.cells[1], box.cells[0]};
	for (const std::string& name : file.namesIn(group == "/" ? group : group.substr(0, group.size() - 1)))
		if (file.isSet(group + name))
		{
			const std::vector<std::uint64_t> sides = file.sidesOf(group + name);
			if (sides.size() == 3 && sides != wanted)
				throw Refusal(fmt::format("{} has {} values where its grid has {} cells; write it without ghost zones "
				                          "(WriteGhostZones = 0)",
				                          name, fmt::join(sides, "x"), fmt::join(wanted, "x")));
			if (sides == wanted)
				names.push_back({name});
		}
	return names;
}

} // namespace

void readEnzo(const Request& request, manifest::Writer& manifest)
{
	const MappedText text(request.file);
	const EnzoHierarchy hierarchy = parseEnzoHierarchy(text.text());
	const std::map<std::string, double> factors = enzoFactors(request.file);
	const boxes::AmrLevels levels = enzoLevels(hierarchy);
	boxes::offerOnlyTime(hierarchy.time, request, manifest);
	EnzoFiles files(request.file);
	std::optional<std::set<std::string>> variables; // those of the first grid
	for (std::size_t level = 0; level < levels.boxes.size(); ++level)
		for (const boxes::AmrBox& at : levels.boxes[level])
		{
			const EnzoGrid& grid = hierarchy.grids[at.number];
			const hdf5::File& file = files[at.file];
			const std::string group = enzoGroup(file, grid.number);
			const std::vector<boxes::CellArrayName> names = enzoVariables(file, group, grid.box);
			std::set<std::string> of_this;
			for (const boxes::CellArrayName& each : names)
				of_this.insert(each.name);
			if (!variables)
				variables = of_this;
			if (*variables != of_this)
				throw damaged(fmt::format("grid {} has other variables than grid {}", grid.number,
				                          hierarchy.grids[levels.boxes[0][0].number].number));
			const boxes::CellArrayChoice choice(request, names);
			const auto image = boxes::imageOfBox(grid.box);
			for (const std::string& name : choice.wanted())
			{
				std::vector<double> values = file.reals(group + name);
				if (const auto factor = factors.find(name); factor != factors.end())
					for (double& value : values)
						value *= factor->second;
				boxes::addCellArray(image, name, values);
			}
			boxes::markCovered(levels, level, at, image);
			choice.noteLeftOut(manifest);
			manifest.setPrefix(fmt::format("level {}, grid {}", level, grid.number));
			manifest.add(image);
		}
}

} // namespace vp::reader::codes
