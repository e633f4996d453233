// A file of nothing but values, whose layout the user gives.
#include "read/raw_layout.h"
#include "vprobe-read/arrays/stored_array.h"
#include "vprobe-read/base/bytes_read.h"
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace vp::reader::volumes
{

namespace
{

// Where parts are asked for, the values of others are not touched.
void addVolume(const Request& request, const MappedText& file, std::string_view values, arrays::ValueLayout layout,
               const Vec3& spacing, manifest::Writer& manifest)
{
	const bool splits = manifest.parts().splits() && std::ranges::all_of(layout.points, [](auto n) { return n > 1; });
	const std::uint64_t plane = std::uint64_t(layout.points[0]) * layout.points[1];
	CellLayers layers{0, std::max(layout.points[2], 1u) - 1};
	if (splits)
	{
		const std::optional<CellLayers> wanted =
		    manifest.parts().beginLattice({{"kind", "image"}, {"points", plane * layout.points[2]}}, layers.end,
		                                  std::size_t(layout.points[0] - 1) * (layout.points[1] - 1));
		if (!wanted)
			return;
		layers = *wanted;
		layout.points[2] = static_cast<std::uint32_t>(layers.count() + 1);
		values = values.substr(plane * layers.begin * byteSize(layout.type), layout.byteCount());
	}
	if (!request.leaves(values.size()))
		countMapped(values.size());
	const auto image = arrays::imageOf(arrays::arrayInFile(request, file, values, layout, "values"), layout.points);
	image->SetSpacing(spacing.x, spacing.y, spacing.z);
	if (!splits)
		return manifest.add(image);
	const InsidePart inside(manifest.parts());
	const auto first = static_cast<int>(layers.begin);
	image->SetExtent(0, static_cast<int>(layout.points[0]) - 1, 0, static_cast<int>(layout.points[1]) - 1, first,
	                 first + static_cast<int>(layers.count()));
	manifest.addImageOf(image, {0, 0, 0});
}

} // namespace

void readRaw(const Request& request, manifest::Writer& manifest)
{
	const auto given = read::parseRaw(request.raw);
	if (!given || given->size[0] == 0)
		throw Refusal("a raw volume does not say how large it is; add --raw-size NXxNYxNZ");
	const arrays::ValueLayout layout{given->size, 1, given->type, given->is_big_endian};
	const MappedText file(request.file);
	const std::uint64_t bytes = layout.byteCount();
	if (file.text().size() < bytes)
		throw damaged(fmt::format("{} bytes where {} values of {} take {}", file.text().size(),
		                          read::rawSizeText(given->size), read::rawTypeText(given->type), bytes));
	// Headers stand before the values.
	addVolume(request, file, file.text().substr(file.text().size() - bytes), layout, given->spacing, manifest);
}

} // namespace vp::reader::volumes
