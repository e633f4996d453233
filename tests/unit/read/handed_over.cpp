#include "handed_over.h"

#include "read/mapping.h"
#include "vprobe-read/quick/quick_xml.h"

#include <cstdlib>
#include <string_view>

#include <sys/mman.h>

using namespace vp::read;
using nlohmann::json;

namespace
{

std::string_view textOf(std::span<const std::byte> bytes)
{
	return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void takeContents(json& value, const SharedBytes& memory)
{
	if (value.is_object() && value.contains("offset") && value.contains("bytes"))
	{
		const auto bytes = memory.bytes.subspan(value["offset"].get<std::size_t>(), value["bytes"].get<std::size_t>());
		value["offset"] = std::hash<std::string_view>()(textOf(bytes));
	}
	else if (value.is_structured())
		for (json& each : value)
			takeContents(each, memory);
}

} // namespace

json handedOver(const std::string& file, const ReadOptions& options)
{
	const auto limits = inputLimits(file, "");
	if (!limits)
		return {{"error", limits.error().message}};
	const auto handed = runReader(file, options, *limits);
	if (!handed)
		return {{"error", handed.error().message}, {"kind", handed.error().kind}};
	json manifest = json::parse(handed->manifest);
	for (json& block : manifest["blocks"])
	{
		const bool has_cells = block.contains("cells");
		for (auto& [key, value] : block.items())
			takeContents(value, has_cells && key != "arrays" ? handed->cells : handed->arrays);
	}
	manifest.erase("bytes_read"); // readers of one file may read it in other ways
	return manifest;
}

json handedOverByVtk(const std::string& file, const ReadOptions& options)
{
	setenv("VPROBE_READ_WITH_VTK", "1", 1);
	json manifest = handedOver(file, options);
	unsetenv("VPROBE_READ_WITH_VTK");
	return manifest;
}

bool isReadQuickly(const std::string& file)
{
	const Descriptor arrays(memfd_create("arrays", MFD_CLOEXEC));
	const Descriptor cells(memfd_create("cells", MFD_CLOEXEC));
	vp::reader::arrays::Writer array_writer(arrays.get());
	vp::reader::arrays::Writer cell_writer(cells.get());
	return vp::reader::quick::readQuickly(file, {}, 2, array_writer, cell_writer).has_value();
}
