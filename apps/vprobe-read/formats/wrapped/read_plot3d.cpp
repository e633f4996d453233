#include "plot3d_layout.h"
#include "plot3d_text.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/complaints.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/text/text_end.h"

#include <vtkMultiBlockDataSet.h>
#include <vtkMultiBlockPLOT3DReader.h>
#include <vtkNew.h>

#include <fmt/format.h>

#include <filesystem>

namespace vp::reader::wrapped
{

namespace
{

// VTK's numbers of what it can derive from a solution, beside the Density, Momentum and StagnationEnergy that stand in
// it.
constexpr int kPressure = 110;
constexpr int kTemperature = 120;
constexpr int kVelocity = 200;

// bluntfinxyz.bin has bluntfinq.bin beside it; wing.xyz, wing.x and wing.g have wing.q. Empty where there is none.
std::string solutionBeside(const std::string& file)
{
	namespace fs = std::filesystem;
	const fs::path path = file;
	std::error_code ignored;
	const fs::path other_ending = fs::path(path).replace_extension(".q");
	if (other_ending != path && fs::is_regular_file(other_ending, ignored))
		return other_ending.string();
	const std::string name = path.filename().string();
	if (const auto at = name.rfind("xyz"); at != name.npos)
	{
		const fs::path other_name = path.parent_path() / (name.substr(0, at) + 'q' + name.substr(at + 3));
		if (fs::is_regular_file(other_name, ignored))
			return other_name.string();
	}
	return {};
}

} // namespace

void readPlot3d(const Request& request, manifest::Writer& manifest)
{
	const Plot3dLayout layout = findPlot3dLayout(request.file);
	if (layout.flat)
		throw Refusal("nothing to slice: a PLOT3D grid of two dimensions");

	MemoryFile grid_bytes, solution_bytes; // made from text
	if (!layout.binary)
		writeGridAsBytes(fortranNumbers(MappedText(request.file).text()), layout, grid_bytes);
	vtkNew<vtkMultiBlockPLOT3DReader> reader;
	reader->SetXYZFileName(layout.binary ? request.file.c_str() : grid_bytes.path().c_str());
	reader->SetAutoDetectFormat(false);
	reader->SetBinaryFile(true);
	if (layout.little_endian || !layout.binary)
		reader->SetByteOrderToLittleEndian();
	else
		reader->SetByteOrderToBigEndian();
	reader->SetHasByteCount(layout.byte_counts);
	reader->SetMultiGrid(layout.multi_grid);
	reader->SetDoublePrecision(layout.doubles || !layout.binary); // text may have all digits
	reader->SetIBlanking(layout.blanking);
	reader->SetTwoDimensionalGeometry(layout.flat);

	const std::string solution = request.solution.empty() ? solutionBeside(request.file) : request.solution;
	if (solution.empty())
		manifest.warn("no solution lies beside this PLOT3D grid; --solution names one");
	else
	{
		if (layout.binary)
			refuseShortSolution(solution, layout);
		else
			writeSolutionAsBytes(fortranNumbers(MappedText(solution).text()), layout,
			                     fmt::format("the solution {}", solution), solution_bytes);
		reader->SetQFileName(layout.binary ? solution.c_str() : solution_bytes.path().c_str());
		for (const int function : {kPressure, kTemperature, kVelocity})
			reader->AddFunction(function);
	}
	if (!layout.binary &&
	    (text::endsInsideALine(request.file) || (!solution.empty() && text::endsInsideALine(solution))))
		manifest.warn(text::kCutTextWarning);
	reader->Update();
	checks::refuseOnComplaint();
	manifest.add(reader->GetOutput());
}

} // namespace vp::reader::wrapped
