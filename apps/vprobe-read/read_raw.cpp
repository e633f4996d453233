// A file of nothing but values, whose layout the user gives.
#include "formats.h"
#include "manifest_writer.h"
#include "mapped_text.h"
#include "read/raw_layout.h"
#include "refusal.h"
#include "value_image.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <fmt/format.h>

void readRaw(const Request& request, ManifestWriter& manifest)
{
	const auto given = vp::read::parseRaw(request.raw);
	if (!given || given->size[0] == 0)
		throw Refusal("a raw volume does not say how large it is; add --raw-size NXxNYxNZ");
	const ValueLayout layout{given->size, 1, given->type, given->is_big_endian};
	const MappedText file(request.file);
	const std::uint64_t bytes = layout.byteCount();
	if (file.text().size() < bytes)
		throw damaged(fmt::format("{} bytes where {} values of {} take {}", file.text().size(),
		                          vp::read::rawSizeText(given->size), vp::read::rawTypeText(given->type), bytes));
	// Headers stand before the values.
	const auto values = arrayOf(file.text().substr(file.text().size() - bytes), layout, "values");
	const auto image = imageOf(values, layout.points);
	image->SetSpacing(given->spacing.x, given->spacing.y, given->spacing.z);
	manifest.add(image);
}
