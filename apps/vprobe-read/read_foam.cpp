#include "complaints.h"
#include "foam_doubles.h"
#include "formats.h"
#include "manifest_writer.h"
#include "refusal.h"
#include "time_choice.h"

#include <vtkDoubleArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>
#include <vtkStringArray.h>

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace
{

struct CloseGzip
{
	void operator()(gzFile_s* file) const { gzclose_r(file); }
};
using Gzip = std::unique_ptr<gzFile_s, CloseGzip>;

bool isWholeGzip(const fs::path& path)
{
	Gzip file(gzopen(path.c_str(), "rb"));
	std::array<char, 1 << 16> buffer;
	int got = 0;
	while (file && (got = gzread(file.get(), buffer.data(), buffer.size())) > 0)
	{
	}
	// Only closing tells whether the checksum at the end was there and right.
	return file && got == 0 && gzclose_r(file.release()) == Z_OK;
}

// The reader leaves out a field whose compressed file ends early.
void refuseShortGzips(const fs::path& folder)
{
	std::error_code none;
	for (const auto& entry : fs::directory_iterator(folder, none))
	{
		if (entry.path().extension() != ".gz")
			continue;
		if (!isWholeGzip(entry.path()) || entry.file_size() == 0)
			throw damaged(fmt::format("{} ends early", entry.path().string()));
	}
}

void widen(vtkOpenFOAMReader& reader, const Request& request, std::optional<double> time, ManifestWriter& manifest)
{
	std::vector<std::string> times;
	for (vtkIdType i = 0; time && i < reader.GetTimeNames()->GetNumberOfValues(); ++i)
		if (reader.GetTimeValues()->GetValue(i) <= *time)
			times.push_back(reader.GetTimeNames()->GetValue(i));
	widenFoam({fs::path(request.file).parent_path(), std::move(times)}, reader.GetOutputDataObject(0), manifest);
}

bool isTime(const fs::path& folder)
{
	const std::string name = folder.filename().string();
	char* end = nullptr;
	std::strtod(name.c_str(), &end);
	return end != name.c_str() && *end == '\0';
}

double lastTimeIn(const fs::path& folder)
{
	double last = -1.0;
	std::error_code none;
	for (const auto& entry : fs::directory_iterator(folder, none))
		if (entry.is_directory() && isTime(entry.path()))
			last = std::max(last, std::strtod(entry.path().filename().c_str(), nullptr));
	return last;
}

// The mesh of the case, or of one of its regions.
bool hasMesh(const fs::path& folder)
{
	std::error_code none;
	if (fs::is_directory(folder / "constant" / "polyMesh", none))
		return true;
	for (const auto& entry : fs::directory_iterator(folder / "constant", none))
		if (fs::is_directory(entry.path() / "polyMesh", none))
			return true;
	return false;
}

// The parts of a decomposed case lie in processor0, processor1 and so on, or all together in processorsN.
void refuseDecomposed(const fs::path& folder, ManifestWriter& manifest)
{
	double last = -1.0;
	bool is_decomposed = false;
	std::error_code none;
	for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, none))
		if (const std::string name = entry.path().filename().string();
		    entry.is_directory() && name.starts_with("processor") && name.find_first_of("0123456789") != name.npos)
		{
			is_decomposed = true;
			last = std::max(last, lastTimeIn(entry.path()));
		}
	if (is_decomposed && !hasMesh(folder))
		throw Refusal("a case that is decomposed among processors, which is not read; run reconstructPar (and "
		              "reconstructParMesh, if that says so) in its folder");
	if (is_decomposed && last > lastTimeIn(folder.empty() ? "." : folder))
		manifest.warn(
		    fmt::format("its times up to {} lie with the processors and are not shown; run reconstructPar", last));
}

} // namespace

// In a pass of its own, without fields: those of patches can be of kinds that the reader complains about.
void addFoamPatches(const Request& request, ManifestWriter& manifest)
{
	vtkNew<vtkOpenFOAMReader> reader;
	reader->SetFileName(request.file.c_str());
	reader->SetCacheMesh(false);
	reader->UpdateInformation();
	for (int i = 0; i < reader->GetNumberOfPatchArrays(); ++i)
	{
		const std::string name = reader->GetPatchArrayName(i);
		reader->SetPatchArrayStatus(name.c_str(), name.find("patch/") != std::string::npos);
	}
	reader->DisableAllCellArrays();
	reader->DisableAllPointArrays();
	reader->DisableAllLagrangianArrays();
	const Request at = request;
	widen(*reader, request, updateAtTime(*reader, at, manifest), manifest);
	manifest.addPatches(reader->GetOutputDataObject(0));
}

void readFoam(const Request& request, ManifestWriter& manifest)
{
	refuseDecomposed(fs::path(request.file).parent_path(), manifest);
	takeWarningsToo(); // which is how this reader tells of files that end early
	vtkNew<vtkOpenFOAMReader> reader;
	reader->SetFileName(request.file.c_str());
	reader->SetDecomposePolyhedra(false);
	reader->SetCreateCellToPoint(true);
	reader->SetCacheMesh(false);
	reader->UpdateInformation();
	refuseOnComplaint();
	// The cells of each region; its patches, sets and particles are flat.
	bool has_cells = false;
	for (int i = 0; i < reader->GetNumberOfPatchArrays(); ++i)
	{
		const std::string name = reader->GetPatchArrayName(i);
		const bool cells = name.ends_with("internalMesh");
		reader->SetPatchArrayStatus(name.c_str(), cells);
		has_cells |= cells;
	}
	if (!has_cells)
		throw damaged("no constant/polyMesh with cells beside it");
	reader->EnableAllCellArrays();
	reader->EnableAllPointArrays();
	reader->DisableAllLagrangianArrays();
	const std::optional<double> time = updateAtTime(*reader, request, manifest);
	const fs::path folder = fs::path(request.file).parent_path();
	refuseShortGzips(folder / "constant" / "polyMesh");
	for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder))
		if (time && entry.is_directory() && std::strtod(entry.path().filename().c_str(), nullptr) == *time)
			refuseShortGzips(entry.path());
	widen(*reader, request, time, manifest);
	manifest.add(reader->GetOutputDataObject(0));
	if (request.patches)
		addFoamPatches(request, manifest);
}
