// Plot files of AMReX and BoxLib, by a parser of our own, which compares all sizes with the files first.
#include "amrex_plotfile.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/boxes/cell_boxes.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/own_names.h"

#include <vtkImageData.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

namespace vp::reader::codes
{

namespace
{

namespace fs = std::filesystem;

// The boxes of each level, and where their values are.
std::vector<std::vector<AmrexBoxData>> amrexBoxes(const fs::path& plot, AmrexPlot& about)
{
	std::vector<std::vector<AmrexBoxData>> levels;
	for (std::size_t level = 0; level < about.folders.size(); ++level)
	{
		if (about.folders[level].find("..") != std::string::npos || about.folders[level].starts_with('/'))
			throw damaged("a level lies elsewhere");
		const MappedText text((plot / (about.folders[level] + "_H")).string());
		levels.push_back(parseAmrexLevel(text.text()));
		about.levels.boxes.emplace_back();
		for (const AmrexBoxData& box : levels.back())
		{
			boxes::AmrBox& known = about.levels.boxes.back().emplace_back(boxes::AmrBox{{}, {}, "", 0});
			for (std::size_t axis = 0; axis < 3; ++axis)
			{
				known.lo[axis] = static_cast<int>(box.lo[axis]);
				known.hi[axis] = static_cast<int>(box.hi[axis]);
			}
		}
	}
	return levels;
}

boxes::CellBox placeOf(const AmrexPlot& about, std::size_t level, const AmrexBoxData& box)
{
	boxes::CellBox place = {};
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		const double size = about.sizes[level][axis];
		const std::int64_t first = about.first[level][axis];
		place.lo[axis] = about.lo[axis] + size * static_cast<double>(box.lo[axis] - first);
		place.hi[axis] = about.lo[axis] + size * static_cast<double>(box.hi[axis] + 1 - first);
		place.cells[axis] = static_cast<std::size_t>(box.hi[axis] - box.lo[axis] + 1);
	}
	return place;
}

} // namespace

void readAmrex(const Request& request, manifest::Writer& manifest)
{
	const fs::path plot =
	    fs::is_directory(request.file) ? fs::path(request.file) : fs::path(request.file).parent_path();
	const MappedText header((plot / "Header").string());
	AmrexPlot about = parseAmrexHeader(header.text());
	const std::vector<std::vector<AmrexBoxData>> levels = amrexBoxes(plot, about);
	manifest::makeOwnNames(about.names, manifest);
	if (!about.is_cartesian)
		manifest.warn("its coordinates are not Cartesian; they are shown as they are");
	boxes::offerOnlyTime(about.time, request, manifest);
	std::set<std::string> taken;
	for (std::string& name : about.names)
	{
		const std::string given = name;
		for (int number = 2; !taken.insert(name).second; ++number)
			name = fmt::format("{} {}", given, number);
		if (name != given)
			manifest.warn(fmt::format("two cell arrays are called {}; the later one is shown as {}", given, name));
	}
	std::vector<boxes::CellArrayName> names;
	for (const std::string& name : about.names)
		names.push_back({name});
	const boxes::CellArrayChoice choice(request, names);
	std::string open_name;
	std::unique_ptr<MappedText> open;
	for (std::size_t level = 0; level < levels.size(); ++level)
		for (std::size_t b = 0; b < levels[level].size(); ++b)
		{
			const AmrexBoxData& box = levels[level][b];
			const std::string path = ((plot / about.folders[level]).parent_path() / box.file).string();
			if (path != open_name)
				open = std::make_unique<MappedText>(open_name = path);
			const auto image = boxes::imageOfBox(placeOf(about, level, box));
			for (std::size_t c = 0; c < about.names.size(); ++c)
				if (std::ranges::find(choice.wanted(), about.names[c]) != choice.wanted().end())
					boxes::addCellArray(image, about.names[c], amrexValues(open->text(), box, about.names.size(), c));
			boxes::markCovered(about.levels, level, about.levels.boxes[level][b], image);
			choice.noteLeftOut(manifest);
			manifest.setPrefix(fmt::format("level {}, box {}", level, b));
			manifest.add(image);
		}
}

} // namespace vp::reader::codes
