// Results of the code Velodyne (.xamr), by a parser of our own: VTK 9.1's crashes at sound files, and does not look
// whether its arrays are as long as they should be. Only the leaves of its tree of boxes hold values.
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/boxes/cell_boxes.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <vtkImageData.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace vp::reader::codes
{

namespace
{

constexpr const char* kVelodyneRoot = "/AMR";

struct VelodyneLayout
{
	std::array<std::size_t, 3> cells; // in a leaf
	std::array<double, 3> spacing;    // the spacing of level 1
};

VelodyneLayout velodyneLayout(const hdf5::File& file)
{
	const std::vector<double> cells = file.realsOr(kVelodyneRoot, "BlockDims");
	const std::vector<double> spacing = file.realsOr(kVelodyneRoot, "RootDX");
	if (cells.size() != 3 || spacing.size() != 3)
		throw damaged("its root does not say the size of its boxes (BlockDims, RootDX)");
	VelodyneLayout layout = {};
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		if (!(cells[axis] >= 1.0 && cells[axis] <= 65536.0))
			throw damaged(fmt::format("boxes of {} cells", cells[axis]));
		layout.cells[axis] = static_cast<std::size_t>(cells[axis]);
		layout.spacing[axis] = spacing[axis];
	}
	return layout;
}

// Boxes of one group, whose cells are `times` as many along each axis.
void addVelodyneBoxes(const hdf5::File& file, const std::string& group, VelodyneLayout layout, std::size_t times,
                      const Request& request, manifest::Writer& manifest)
{
	if (!file.has(group))
		return;
	for (std::size_t& count : layout.cells)
		count *= times;
	const std::vector<std::int64_t> levels = file.integers(group + "/Level");
	const std::vector<double> corners = file.reals(group + "/X0");
	if (corners.size() != 3 * levels.size())
		throw damaged(fmt::format("{} has {} places for {} boxes", group, corners.size() / 3, levels.size()));
	std::vector<boxes::CellArrayName> names;
	for (const std::string& name : file.namesIn(group)) // boxes, z, y, x, components
		if (const std::vector<std::uint64_t> sides = file.sidesOf(group + "/" + name); sides.size() == 5)
			names.push_back({name, static_cast<int>(sides[4])});
	const boxes::CellArrayChoice choice(request, names);
	std::map<std::string, std::vector<double>> values;
	for (const std::string& name : choice.wanted())
	{
		const std::vector<std::uint64_t> sides = file.sidesOf(group + "/" + name);
		if (sides[0] != levels.size() || sides[1] != layout.cells[2] || sides[2] != layout.cells[1] ||
		    sides[3] != layout.cells[0])
			throw damaged(fmt::format("{}/{} has other sides than its boxes", group, name));
		values[name] = file.reals(group + "/" + name);
	}
	for (std::size_t b = 0; b < levels.size(); ++b)
	{
		if (levels[b] < 1 || levels[b] > 64)
			throw damaged(fmt::format("a box of level {}", levels[b]));
		boxes::CellBox box = {{corners[3 * b], corners[3 * b + 1], corners[3 * b + 2]}, {}, layout.cells};
		for (std::size_t axis = 0; axis < 3; ++axis)
			box.hi[axis] = box.lo[axis] + std::ldexp(layout.spacing[axis], 1 - static_cast<int>(levels[b])) *
			                                  static_cast<double>(box.cells[axis]);
		const auto image = boxes::imageOfBox(box);
		for (const auto& [name, all] : values)
		{
			const std::size_t each = all.size() / levels.size();
			boxes::addCellArray(image, name, std::span(all).subspan(b * each, each));
		}
		choice.noteLeftOut(manifest);
		manifest.setPrefix(fmt::format("level {}, {} {}", levels[b], times == 1 ? "box" : "full box", b));
		manifest.add(image);
	}
}

} // namespace

void readVelodyne(const Request& request, manifest::Writer& manifest)
{
	const hdf5::File file(request.file);
	const VelodyneLayout layout = velodyneLayout(file);
	boxes::offerOnlyTime(file.realOr(kVelodyneRoot, "SimTime", std::numeric_limits<double>::quiet_NaN()), request,
	                     manifest);
	const std::string root = kVelodyneRoot;
	addVelodyneBoxes(file, root + "/Leaves", layout, 1, request, manifest);
	addVelodyneBoxes(file, root + "/FullLeaves", layout, 2, request, manifest);
}

} // namespace vp::reader::codes
