#include "cgns_steps.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/base/stand_in.h"
#include "vprobe-read/checks/complaints.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/hdf5/hdf5_parts.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"

#include <vtkCGNSReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace vp::reader::wrapped
{

namespace
{

// An ADF file's header says at byte 146 where its last byte is: a block of 4096 bytes and an offset, in 8 and 4 bytes
// (ADF_internals.c of the CGNS library). In files of format A they are hexadecimal digits, in those of format B
// numbers. Reads past the end come back as zeros or old buffers.
constexpr std::size_t kAdfEndAt = 146;
constexpr std::size_t kAdfVersionAt = 25;
constexpr std::size_t kAdfOrderAt = 100;
constexpr std::uint64_t kAdfBlock = 4096;

std::optional<std::uint64_t> hexadecimal(std::string_view digits)
{
	std::uint64_t value = 0;
	const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
	if (error != std::errc() || end != digits.data() + digits.size())
		return std::nullopt;
	return value;
}

void refuseShortAdf(const std::string& file)
{
	std::array<char, kAdfEndAt + 12> head = {};
	std::ifstream in(file, std::ios::binary);
	in.read(head.data(), head.size());
	const std::string_view text(head.data(), head.size());
	if (text.starts_with("\x89HDF"))
		return; // HDF5 checks its own end
	auto block = hexadecimal(text.substr(kAdfEndAt, 8));
	auto offset = hexadecimal(text.substr(kAdfEndAt + 8, 4));
	if (text[kAdfVersionAt] != 'A')
	{
		const ByteOrder order = byteOrder(text[kAdfOrderAt] == 'B');
		block = numberAt<std::uint64_t>(head.data() + kAdfEndAt, order);
		offset = numberAt<std::uint32_t>(head.data() + kAdfEndAt + 8, order);
	}
	if (!in || !block || !offset || *block > std::uint64_t(1) << 50)
		throw damaged("its header cannot be followed");
	const std::uint64_t wanted = *block * kAdfBlock + *offset + 1;
	const auto bytes = std::filesystem::file_size(file);
	if (bytes < wanted)
		throw damaged(fmt::format("{} bytes where its header asks for {}", bytes, wanted));
}

// By the numbers of CGNS' types, from NODE on; 0 for those of no fixed number.
constexpr std::array<int, 22> kCgnsNodes = {0, 0, 1, 2, 3, 3, 6, 4, 8, 9, 4, 10, 5, 14, 6, 15, 18, 8, 20, 27, 0, 13};
constexpr std::int64_t kCgnsMixed = 20, kCgnsPyramid13 = 21;

// Whether a section of mixed types has pyramids of 13 nodes.
bool hasPyramids13(const hdf5::File& file, const std::string& list)
{
	constexpr std::uint64_t chunk = 1 << 20;
	const std::vector<std::uint64_t> sides = file.sidesOf(list);
	const std::uint64_t count = sides.size() == 1 ? sides[0] : 0;
	std::vector<std::int64_t> numbers;
	std::uint64_t first = 0;
	for (std::uint64_t at = 0; at < count;)
	{
		if (numbers.empty() || at - first >= numbers.size())
		{
			first = at;
			numbers = file.integersFrom(list, first, std::min(chunk, count - first));
		}
		const std::int64_t type = numbers[at - first];
		if (type == kCgnsPyramid13)
			return true;
		if (type < 0 || type >= static_cast<std::int64_t>(kCgnsNodes.size()) ||
		    kCgnsNodes[static_cast<std::size_t>(type)] == 0)
			return false;
		at += 1 + static_cast<std::uint64_t>(kCgnsNodes[static_cast<std::size_t>(type)]);
	}
	return false;
}

// VTK's reader leaves pyramids of 13 nodes out without a word.
void refusePyramids13(const hdf5::File& file)
{
	for (const std::string& base : cgnsChildren(file, "/", "CGNSBase_t"))
		for (const std::string& zone : cgnsChildren(file, base, "Zone_t"))
			for (const std::string& section : cgnsChildren(file, zone, "Elements_t"))
			{
				const std::string list = section + "/ElementConnectivity/ data";
				if (!file.isSet(section + "/ data") || !file.isSet(list))
					continue;
				const std::vector<std::int64_t> type = file.integers(section + "/ data");
				if (!type.empty() &&
				    (type[0] == kCgnsPyramid13 || (type[0] == kCgnsMixed && hasPyramids13(file, list))))
					throw Refusal(
					    "pyramids of 13 nodes (PYRA_13), which VTK's CGNS reader leaves out; write PYRA_14 or "
					    "PYRA_5");
			}
}

// VTK's reader shows the last of the steps that have one time.
void tellOfEqualTimes(const hdf5::File& file, manifest::Writer& manifest)
{
	for (const std::string& base : cgnsChildren(file, "/", "CGNSBase_t"))
		for (const std::string& steps : cgnsChildren(file, base, "BaseIterativeData_t"))
		{
			if (!file.isSet(steps + "/TimeValues/ data"))
				continue;
			const std::vector<double> times = file.reals(steps + "/TimeValues/ data");
			if (const std::size_t distinct = manifest::inOrder(times).size(); distinct < times.size())
				manifest.warn(fmt::format("{} of its {} steps have the time of another; the last one of each time is "
				                          "shown",
				                          times.size() - distinct, times.size()));
		}
}

} // namespace

void readCgns(const Request& request, manifest::Writer& manifest)
{
	refuseShortAdf(request.file);
	hdf5::refuseMissingParts(request.file);
	std::vector<double> times;                                  // if they do not rise
	std::unique_ptr<MemoryFile> numbered;                       // a copy that VTK's reader takes then
	if (MappedText(request.file).text().starts_with("\x89HDF")) // files of ADF are not looked at
	{
		const hdf5::File file(request.file);
		refusePyramids13(file);
		times = unsortedCgnsTimes(file);
		if (times.empty())
			tellOfEqualTimes(file, manifest);
		else
			numbered = withNumberedSteps(file, request.file);
	}
	Request at = request;
	std::optional<StandIn> stands_in;
	if (numbered)
	{
		const manifest::StepsInTime steps = manifest::stepsInTime(times, manifest);
		stands_in.emplace(request.file, numbered->path());
		at.time = Request::Time::nearest;
		at.time_value = static_cast<double>(steps.steps[manifest::chooseStep(steps.times, request)]);
	}
	vtkNew<vtkCGNSReader> reader;
	if (!reader->CanReadFile(request.file.c_str()))
		throw damaged("not a CGNS file that can be opened");
	reader->SetFileName(request.file.c_str());
	reader->UpdateInformation();
	reader->EnableAllBases();
	reader->EnableAllFamilies();
	reader->EnableAllPointArrays();
	reader->EnableAllCellArrays();
	reader->SetLoadBndPatch(false);
	reader->SetDoublePrecisionMesh(1);
	manifest::updateAtTime(*reader, at, manifest);
	if (checks::wasNoted("refer to invalid solution nodes"))
	{
		// The reader would show the first solution at each time.
		reader->SetUseUnsteadyPattern(true);
		manifest::updateAtTime(*reader, at, manifest);
		manifest.warn("solutions belong to times by the number at the end of their names; where none fits, the first "
		              "one is shown");
	}
	if (numbered)
		manifest.offerTimes(manifest::stepsInTime(times, manifest).times);
	manifest.add(reader->GetOutputDataObject(0));
	// Names stand in both kinds of CGNS files as they are.
	if (manifest.isEmpty() && MappedText(request.file).text().find("ParentElements") != std::string_view::npos)
		throw Refusal(
		    "nothing to slice: only the ParentElements of its faces tell the cells, which are not read; write "
		    "sections of NFACE_n as well");
}

} // namespace vp::reader::wrapped
