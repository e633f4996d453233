#include "complaints.h"
#include "formats.h"
#include "manifest_writer.h"
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

// An ADF file's header says at byte 146 where its last byte is: a block of 4096 bytes in 8 hexadecimal digits and an
// offset in 4 (ADF_internals.c of the CGNS library). Reads past the end come back as zeros or old buffers.
constexpr std::size_t kAdfEndAt = 146;
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
	const auto block = hexadecimal(text.substr(kAdfEndAt, 8));
	const auto offset = hexadecimal(text.substr(kAdfEndAt + 8, 4));
	if (!in || !block || !offset)
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
}
