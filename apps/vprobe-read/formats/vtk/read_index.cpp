// Files that only name others: multiblock and AMR indices, collections over time, series.
#include "base/real_text.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/read_files.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/boxes/amr_cover.h"
#include "vprobe-read/checks/complaints.h"
#include "vprobe-read/checks/xml_check.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"
#include "vprobe-read/text/json_text.h"
#include "vprobe-read/text/text_cursor.h"

#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace vp::reader::vtk
{

namespace fs = std::filesystem;

namespace
{

// Deeper nesting than any writer makes.
constexpr int kMaxDepth = 64;

std::string attributeOf(vtkXMLDataElement* element, const char* name)
{
	const char* value = element->GetAttribute(name);
	return value ? value : "";
}

vtkSmartPointer<vtkXMLDataElement> rootOf(const std::string& file)
{
	checks::refuseShortXml(file);
	const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(file.c_str()));
	if (!root)
		throw damaged("its XML cannot be parsed");
	checks::refuseOnComplaint();
	return root;
}

std::string beside(const std::string& index, const std::string& file)
{
	return (fs::path(index).parent_path() / file).string();
}

// A file that an index names. It may not be an index itself, so that no circle is followed.
Request pieceOf(const Request& request, const std::string& file)
{
	Request piece = request;
	piece.format.clear();
	piece.file = beside(request.file, file);
	if (!fs::is_regular_file(piece.file))
		throw Refusal(fmt::format("its piece {} cannot be opened; keep them together", piece.file));
	noteFile(piece.file.c_str()); // whether or not it is read: no output may take its place
	return piece;
}

void readElements(const Request& request, vtkXMLDataElement* parent, const std::string& path, int depth,
                  manifest::Writer& manifest)
{
	if (depth > kMaxDepth)
		throw damaged("its blocks are nested too deeply");
	for (int i = 0; i < parent->GetNumberOfNestedElements(); ++i)
	{
		vtkXMLDataElement* element = parent->GetNestedElement(i);
		const std::string kind = element->GetName() ? element->GetName() : "";
		std::string name = attributeOf(element, "name");
		if (name.empty())
			name = fmt::format("{} {}", kind == "DataSet" ? "block" : "group",
			                   element->GetAttribute("index") ? attributeOf(element, "index") : std::to_string(i));
		const std::string full = path.empty() ? name : path + "/" + name;
		if (kind == "DataSet")
		{
			const std::string file = attributeOf(element, "file");
			if (file.empty())
				continue; // an empty leaf
			manifest.setPrefix(full);
			const Request piece = pieceOf(request, file);
			if (!manifest.parts().begin(manifest.parts().lists() ? cellsOfXml(piece.file) : 0))
				continue;
			const InsidePart inside(manifest.parts());
			addXml(piece, formats::xmlTypeOfFile(piece.file), manifest);
		}
		else if (kind == "Block" || kind == "Piece" || kind == "Partitions")
			readElements(request, element, full, depth + 1, manifest);
	}
}

// A file that an index over time names: of any format but such an index.
void readStep(const Request& request, const std::string& file, manifest::Writer& manifest)
{
	Request step = request;
	step.file = beside(request.file, file);
	step.time = Request::Time::last;
	step.format.clear();
	const std::string ending = fs::path(step.file).extension().string();
	if (ending == ".pvd" || ending == ".series")
		throw damaged("it names a file that is a list of files itself");
	if (!fs::is_regular_file(step.file))
		throw Refusal(fmt::format("its file {} cannot be opened; keep them together", step.file));
	formats::readAnyFormat(step, manifest);
}

struct Step
{
	double time;
	std::string file;
	std::string name;
};

// Files of one time are parts of it, as in ParaView.
void readSteps(const Request& request, const std::vector<Step>& steps, manifest::Writer& manifest)
{
	std::vector<double> times;
	for (const Step& step : steps)
		times.push_back(step.time);
	times = manifest::inOrder(std::move(times));
	if (times.empty())
		throw Refusal("nothing to slice: it names no files");
	const double chosen = manifest::chooseTime(times, request);
	const auto parts = std::count_if(steps.begin(), steps.end(), [&](const Step& step) { return step.time == chosen; });
	for (const Step& step : steps)
		if (step.time == chosen)
		{
			manifest.setPrefix(parts > 1 ? step.name : "");
			readStep(request, step.file, manifest);
		}
	manifest.offerTimes(std::move(times));
}

} // namespace

void readMultiBlock(const Request& request, const std::string& type, manifest::Writer& manifest)
{
	const auto root = rootOf(request.file);
	vtkXMLDataElement* blocks = root->FindNestedElementWithName(type.c_str());
	if (!blocks)
		throw damaged(fmt::format("it has no {} element", type));
	readElements(request, blocks, "", 0, manifest);
}

void readAmr(const Request& request, const std::string& type, manifest::Writer& manifest)
{
	const auto root = rootOf(request.file);
	vtkXMLDataElement* index = root->FindNestedElementWithName(type.c_str());
	if (!index)
		throw damaged(fmt::format("it has no {} element", type));
	boxes::AmrLevels levels = boxes::readAmrLevels(index);
	// Finer levels hide parts of coarser ones and meet them at hanging points, so they stay together.
	std::size_t cells = 0;
	for (const auto& boxes : levels.boxes)
		for (const boxes::AmrBox& box : boxes)
			cells += cellsOfXml(pieceOf(request, box.file).file);
	if (!manifest.parts().begin(cells))
		return;
	const InsidePart inside(manifest.parts());
	if (type == "vtkNonOverlappingAMR")
		levels.ratios.clear();
	for (std::size_t level = 0; level < levels.boxes.size(); ++level)
		for (const boxes::AmrBox& box : levels.boxes[level])
		{
			const Request piece = pieceOf(request, box.file);
			const auto data = loadXml(piece, formats::xmlTypeOfFile(piece.file), manifest);
			auto* image = vtkImageData::SafeDownCast(data);
			if (!image || !boxes::hasCellsOf(box, image))
				throw damaged(fmt::format("{} is no image of the size that its box has", box.file));
			boxes::markCovered(levels, level, box, image);
			manifest.setPrefix(fmt::format("level {}, box {}", level, box.number));
			manifest.add(image);
		}
}

void readCollection(const Request& request, manifest::Writer& manifest)
{
	const auto root = rootOf(request.file);
	vtkXMLDataElement* collection = root->FindNestedElementWithName("Collection");
	if (!collection)
		throw damaged("it has no Collection element");
	std::vector<Step> steps;
	for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i)
	{
		vtkXMLDataElement* element = collection->GetNestedElement(i);
		Step step = {0.0, attributeOf(element, "file"), attributeOf(element, "name")};
		if (element->GetAttribute("timestep"))
		{
			const std::string text = attributeOf(element, "timestep");
			text::Cursor at(text);
			const std::optional<double> time = at.atEnd() ? std::nullopt : parseReal(at.word());
			if (!time || !std::isfinite(*time) || !at.atEnd())
				throw damaged(fmt::format("{} is no time", text));
			step.time = *time;
		}
		if (step.name.empty())
			step.name = "part " + (element->GetAttribute("part") ? attributeOf(element, "part") : std::to_string(i));
		if (!step.file.empty())
			steps.push_back(std::move(step));
	}
	readSteps(request, steps, manifest);
}

void readSeries(const Request& request, manifest::Writer& manifest)
{
	std::vector<Step> steps;
	try
	{
		const nlohmann::json series = text::parseJson(MappedText(request.file).text());
		for (const auto& file : series.at("files"))
			steps.push_back({file.at("time").get<double>(), file.at("name").get<std::string>(), ""});
	}
	catch (const nlohmann::json::exception&)
	{
		throw damaged("not JSON with a list \"files\" of \"name\" and \"time\"");
	}
	std::vector<double> times;
	for (const Step& step : steps)
		times.push_back(step.time);
	manifest::StepsInTime in_order = manifest::stepsInTime(times, manifest);
	if (!manifest::chooseIfAny(in_order.times, request))
		throw Refusal("nothing to slice: it names no files");
	readStep(request, steps[in_order.steps[manifest::chooseStep(in_order.times, request)]].file, manifest);
	manifest.offerTimes(std::move(in_order.times)); // after the file, which may have times of its own
}

} // namespace vp::reader::vtk
