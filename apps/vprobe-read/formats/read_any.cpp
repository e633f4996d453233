#include "base/file_pattern.h"
#include "formats.h"
#include "read/formats.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/file_head.h"
#include "vprobe-read/checks/other_programs.h"
#include "vprobe-read/door/door.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vp::reader::formats
{

namespace
{

struct Reader
{
	std::string_view format;
	bool (*recognizes)(const checks::FileHead& head);
	void (*read)(const Request& request, manifest::Writer& manifest);
};

constexpr Reader kReaders[] = {
#define VP_FORMAT(NAME, ENDINGS, WHAT, READ, BY, FILES, SIGN, PROGRAM, ROOM, FUNCTION)                                 \
	{NAME, []([[maybe_unused]] const checks::FileHead& head) -> bool { return SIGN; }, ROOM::read##FUNCTION},
#include "read/format_table.inl"
#undef VP_FORMAT
};

// Why no format was recognized.
Refusal notRecognized(const checks::FileHead& head)
{
	if (head.ends({".q"}))
		return Refusal("a PLOT3D solution; give the grid file, and this one as --solution");
	if (head.starts("#!TDV") || head.starts("#!SZPLT"))
		return Refusal("a binary Tecplot file, which no free library reads; save it as text (.dat)");
	if (head.isHdf5() || head.isNetcdf())
		return Refusal(fmt::format("{} data of another program or damaged ones; see vprobe info --formats",
		                           head.isHdf5() ? "HDF5" : "netCDF"));
	if (read::formatOfEnding(head.file()))
		return damaged(fmt::format("its first bytes are not those of a {} file",
		                           std::filesystem::path(head.file()).extension().string()));
	return Refusal("not a format that can be read; vprobe info --formats lists those that can");
}

// Refuses to become vprobe-read-more, unless that reads the format, or one of the files that a list over time names.
void refuseExecFor(std::string_view format, const checks::FileHead& head)
{
	static bool is_list = false;
	is_list =
	    is_list || format == "series" || (format == "vtk-xml-index" && checks::xmlTypeOf(head.text()) == "Collection");
	if (!is_list && !read::findFormat(format)->in_more)
		door::refuseExec();
}

} // namespace

std::string xmlTypeOfFile(const std::string& file)
{
	return checks::xmlTypeOf(checks::FileHead(file).text());
}

void readAnyXml(const Request& request, manifest::Writer& manifest)
{
	vtk::readXml(request, xmlTypeOfFile(request.file), manifest);
}

void readAnyFormat(const Request& request, manifest::Writer& manifest)
{
	if (request.file.starts_with(kDemoPrefix))
		return readDemo(request, manifest);
	if (!request.slices.empty() && std::all_of(request.slices.begin(), request.slices.end(), isPictureName))
		return volumes::readSlices(request, manifest);
	const checks::FileHead head(request.file);
	if (head.isHdf5())
		needHdf5(request);
	if (head.isFolder())
		checks::refuseOtherPrograms(head); // a folder is taken for a DICOM series otherwise
	const std::string format = request.format.empty() && !request.raw.empty() ? "raw" : request.format;
	const auto suits = [&](const Reader& reader)
	{ return format.empty() ? reader.recognizes(head) : reader.format == format; };
	const auto reader = std::find_if(std::begin(kReaders), std::end(kReaders), suits);
	if (reader == std::end(kReaders) && format.empty())
		checks::refuseOtherPrograms(head);
	if (reader == std::end(kReaders))
		throw notRecognized(head);
	refuseExecFor(reader->format, head);
	if (!request.slices.empty() && reader->format != "dicom")
		return volumes::readStack(request, manifest);
	reader->read(request, manifest);
}

} // namespace vp::reader::formats
