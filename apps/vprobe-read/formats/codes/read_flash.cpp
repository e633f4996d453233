// Files of the code FLASH, by a parser of our own: VTK's crashes at files of FLASH 2 and at arrays of other sides, and
// takes what lies in memory for integers of 16 bits. Leaves of the tree of blocks are read; they do not overlap.
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/boxes/cell_boxes.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <vtkImageData.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace vp::reader::codes
{

namespace
{

constexpr std::int64_t kFlashLeaf = 1;

struct FlashTree
{
	std::vector<double> bounds; // for each block, along each axis from and to
	std::vector<std::int64_t> kinds;
	std::vector<std::int64_t> levels;

	explicit FlashTree(const hdf5::File& file)
	{
		// Neighbors, a parent and children: 5, 9 or 15 by the number of dimensions.
		const std::vector<std::uint64_t> sides = file.sidesOf("/gid");
		if (sides.size() != 2)
			throw damaged("its tree of blocks has no neighbors");
		if (sides[1] == 5 || sides[1] == 9)
			throw Refusal("nothing to slice: blocks of FLASH of fewer than three dimensions");
		bounds = file.reals("/bounding box");
		kinds = file.integers("/node type");
		levels = file.integers("/refine level");
		if (sides[1] != 15 || kinds.size() != sides[0] || levels.size() != sides[0] || bounds.size() != 6 * sides[0])
			throw damaged("its arrays of blocks do not match each other");
	}
};

struct FlashVariable
{
	std::string name;
	std::string path;           // which may end with blanks
	std::vector<double> values; // the values of all blocks
};

std::vector<FlashVariable> flashVariables(const hdf5::File& file)
{
	std::map<std::string, std::string> paths;
	for (const std::string& path : file.namesIn("/"))
		paths[path.substr(0, path.find_last_not_of(' ') + 1)] = "/" + path;
	std::vector<FlashVariable> variables;
	for (const std::string& name : file.texts("/unknown names"))
	{
		if (!paths.contains(name))
			throw damaged(fmt::format("it has no {}, which its list of variables names", name));
		variables.push_back({name, paths[name], {}});
	}
	return variables;
}

double flashTime(const hdf5::File& file)
{
	const std::map<std::string, double> scalars = file.namedNumbers("/real scalars");
	const auto time = scalars.find("time");
	return time != scalars.end()
	           ? time->second
	           : file.columnOr("/simulation parameters", "time", std::numeric_limits<double>::quiet_NaN());
}

void warnOfGeometry(const hdf5::File& file, manifest::Writer& manifest)
{
	for (const char* table : {"/string scalars", "/string parameters", "/string runtime parameters"})
		for (const auto& [name, geometry] : file.namedTexts(table))
			if (name == "geometry" && !geometry.empty() && geometry != "cartesian")
			{
				manifest.warn(fmt::format("its coordinates are {}; they are shown as they are", geometry));
				return;
			}
}

} // namespace

void readFlash(const Request& request, manifest::Writer& manifest)
{
	const hdf5::File file(request.file);
	const FlashTree tree(file);
	const std::size_t blocks = tree.kinds.size();
	std::vector<FlashVariable> variables = flashVariables(file);
	std::array<std::size_t, 3> cells = {0, 0, 0};
	std::vector<boxes::CellArrayName> names;
	for (const FlashVariable& variable : variables)
	{
		const std::vector<std::uint64_t> sides = file.sidesOf(variable.path);
		if (sides.size() != 4 || sides[0] != blocks)
			throw damaged(fmt::format("{} has no values for each of its blocks", variable.name));
		const std::array<std::size_t, 3> of_this = {sides[3], sides[2], sides[1]};
		if (names.empty())
			cells = of_this;
		if (of_this == cells)
			names.push_back({variable.name});
		else // at corners, if a plot file was asked for so
			manifest.warn(fmt::format("{} is not at cells and left out", variable.name));
	}
	if (names.empty())
		throw Refusal("nothing to slice: it holds no variables of a grid (unknown names)");
	boxes::offerOnlyTime(flashTime(file), request, manifest);
	warnOfGeometry(file, manifest);

	const boxes::CellArrayChoice choice(request, names);
	std::erase_if(variables, [&](const FlashVariable& variable)
	              { return std::ranges::find(choice.wanted(), variable.name) == choice.wanted().end(); });
	for (FlashVariable& variable : variables)
		variable.values = file.reals(variable.path);
	for (std::size_t b = 0; b < blocks; ++b)
	{
		if (tree.kinds[b] != kFlashLeaf)
			continue;
		const double* at = tree.bounds.data() + 6 * b;
		const boxes::CellBox box = {{at[0], at[2], at[4]}, {at[1], at[3], at[5]}, cells};
		const auto image = boxes::imageOfBox(box);
		for (const FlashVariable& variable : variables)
			boxes::addCellArray(image, variable.name,
			                    std::span(variable.values).subspan(b * box.cellCount(), box.cellCount()));
		choice.noteLeftOut(manifest);
		manifest.setPrefix(fmt::format("level {}, block {}", tree.levels[b], b));
		manifest.add(image);
	}
}

} // namespace vp::reader::codes
