#include "complaints.h"
#include "formats.h"
#include "hdf5_parts.h"
#include "manifest_writer.h"
#include "mapped_text.h"
#include "refusal.h"
#include "time_choice.h"

#include <vtkCGNSReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <string_view>

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

std::uint64_t wholeOf(std::string_view bytes, bool is_big_endian)
{
	std::uint64_t value = 0;
	for (std::size_t b = 0; b < bytes.size(); ++b)
		value = value << 8 | static_cast<unsigned char>(bytes[is_big_endian ? b : bytes.size() - 1 - b]);
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
		const bool is_big_endian = text[kAdfOrderAt] == 'B';
		block = wholeOf(text.substr(kAdfEndAt, 8), is_big_endian);
		offset = wholeOf(text.substr(kAdfEndAt + 8, 4), is_big_endian);
	}
	if (!in || !block || !offset || *block > std::uint64_t(1) << 50)
		throw damaged("its header cannot be followed");
	const std::uint64_t wanted = *block * kAdfBlock + *offset + 1;
	const auto bytes = std::filesystem::file_size(file);
	if (bytes < wanted)
		throw damaged(fmt::format("{} bytes where its header asks for {}", bytes, wanted));
}

} // namespace

void readCgns(const Request& request, ManifestWriter& manifest)
{
	refuseShortAdf(request.file);
	refuseMissingParts(request.file);
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
	updateAtTime(*reader, request, manifest);
	if (wasNoted("refer to invalid solution nodes"))
	{
		// The reader would show the first solution at each time.
		reader->SetUseUnsteadyPattern(true);
		updateAtTime(*reader, request, manifest);
		manifest.warn("solutions belong to times by the number at the end of their names; where none fits, the first "
		              "one is shown");
	}
	manifest.add(reader->GetOutputDataObject(0));
	// Names stand in both kinds of CGNS files as they are.
	if (manifest.isEmpty() && MappedText(request.file).text().find("ParentElements") != std::string_view::npos)
		throw Refusal(
		    "nothing to slice: only the ParentElements of its faces tell the cells, which are not read; write "
		    "sections of NFACE_n as well");
}
