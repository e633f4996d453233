#include "formats.h"
#include "is_one_of.h"
#include "read/protocol.h"
#include "refusal.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace
{

// XML declarations and comments may stand before the element that names the type.
constexpr std::size_t kHeadBytes = 4096;

std::string headOf(const std::string& file)
{
	std::ifstream in(file, std::ios::binary);
	std::string head(kHeadBytes, '\0');
	in.read(head.data(), static_cast<std::streamsize>(head.size()));
	head.resize(static_cast<std::size_t>(in.gcount()));
	return head;
}

std::string endingOf(const std::string& file)
{
	std::string ending = std::filesystem::path(file).extension().string();
	std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
	return ending;
}

// The value of type="..." in the VTKFile element; empty where there is none.
std::string xmlTypeOf(std::string_view head)
{
	const auto element = head.find("<VTKFile");
	if (element == head.npos)
		return {};
	const auto end = std::min(head.find('>', element), head.size());
	const std::string_view attributes = head.substr(element, end - element);
	auto at = attributes.find(" type");
	if (at == attributes.npos || (at = attributes.find_first_of("\"'", at)) == attributes.npos)
		return {};
	const auto close = attributes.find(attributes[at], at + 1);
	return close == attributes.npos ? std::string() : std::string(attributes.substr(at + 1, close - at - 1));
}

// Where a NIfTI header has its magic, and what stands there.
constexpr std::size_t kNiftiMagicAt = 344;

bool looksLikeNifti(std::string_view head, const std::string& file)
{
	return file.ends_with(".nii.gz") ||
	       (head.size() >= 348 && isOneOf(head.substr(kNiftiMagicAt, 3), {"n+1", "ni1"})) ||
	       (head.size() >= 12 && head.substr(4, 3) == "n+2");
}

} // namespace

std::string xmlTypeOfFile(const std::string& file)
{
	return xmlTypeOf(headOf(file));
}

void readAnyFormat(const Request& request, ManifestWriter& manifest)
{
	const std::string head = headOf(request.file);
	const std::string ending = endingOf(request.file);
	const std::string_view text = head;

	if (text.starts_with("# vtk DataFile"))
		return readLegacy(request, manifest);
	if (const std::string type = xmlTypeOf(text); !type.empty())
		return readXml(request, type, manifest);
	if (ending == ".foam" || ending == ".openfoam")
		return readFoam(request, manifest);
	if (text.starts_with("NRRD"))
		return readNrrd(request, manifest);
	if (isOneOf(ending, {".nii", ".gz", ".hdr"}) && looksLikeNifti(text, request.file))
		return readNifti(request, manifest);
	if (ending == ".series" && text.find('{') != text.npos)
		return readSeries(request, manifest);
	if (isOneOf(ending, {".case", ".encas"}) && text.find("GEOMETRY") != text.npos)
		return readEnSight(request, manifest);
	if (ending == ".cgns" && (text.starts_with("\x89HDF\r\n") || text.find("ADF Database") < 32))
		return readCgns(request, manifest);
	if (text.starts_with("\x89HDF\r\n") && isOneOf(ending, {".hdf", ".vtkhdf", ".h5"}))
		return readHdf(request, manifest);
	if (text.starts_with("CDF\1") || text.starts_with("CDF\2") || text.starts_with("CDF\5"))
		return readExodus(request, manifest);
	if (text.starts_with("\x89HDF\r\n") && isOneOf(ending, {".e", ".g", ".ex2", ".exo", ".exii"}))
		return readExodus(request, manifest);
	if (isOneOf(ending, {".mhd", ".mha"}) && text.find("NDims") != text.npos)
		return readMetaImage(request, manifest);
	if (isOneOf(ending, {".xyz", ".x", ".g", ".p3d", ".bin"}))
		return readPlot3d(request, manifest);
	if (ending == ".q")
		throw Refusal("a PLOT3D solution; give the grid file, and this one as --solution");
	if (std::find(vp::read::kEndings.begin(), vp::read::kEndings.end(), ending) != vp::read::kEndings.end())
		throw damaged(fmt::format("its first bytes are not those of a {} file", ending));
	throw Refusal(fmt::format("not a format that can be read ({})", fmt::join(vp::read::kEndings, " ")));
}
