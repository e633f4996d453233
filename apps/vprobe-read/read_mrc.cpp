// MRC and CCP4 maps (MRC2014). By a parser of our own: VTK 9.1 turns only the first row of a big-endian file, takes
// mode 6 for two components, and leaves the order of the axes out.
#include "formats.h"
#include "manifest_writer.h"
#include "mapped_text.h"
#include "refusal.h"
#include "value_image.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using vp::grid::NumberType;

namespace
{

constexpr std::size_t kHeaderBytes = 1024;

class MrcHeader
{
public:
	explicit MrcHeader(std::string_view file) : file_(file)
	{
		if (file.size() < kHeaderBytes)
			throw damaged("it ends within its header");
		// The machine stamp is often wrong; an order of axes is one of six.
		const auto is_order = [this]
		{
			std::array<int, 3> axes = {integer(16), integer(17), integer(18)};
			std::sort(axes.begin(), axes.end());
			return axes == std::array<int, 3>{1, 2, 3} || axes == std::array<int, 3>{0, 0, 0};
		};
		if (!is_order())
		{
			swapped_ = true;
			if (!is_order())
				throw damaged("its axes have no order");
		}
	}
	int integer(std::size_t word) const { return number<int>(word); }
	float real(std::size_t word) const { return number<float>(word); }
	bool swapped() const { return swapped_; }

private:
	template <class Number>
	Number number(std::size_t word) const
	{
		std::array<char, 4> bytes;
		std::memcpy(bytes.data(), file_.data() + 4 * word, 4);
		if (swapped_)
			std::reverse(bytes.begin(), bytes.end());
		Number value;
		std::memcpy(&value, bytes.data(), 4);
		return value;
	}

	std::string_view file_;
	bool swapped_ = false;
};

void setType(ValueLayout& layout, int mode)
{
	switch (mode)
	{
	case 0:
		layout.type = NumberType::int8;
		return;
	case 1:
		layout.type = NumberType::int16;
		return;
	case 2:
		layout.type = NumberType::float32;
		return;
	case 3: // complex
		layout.type = NumberType::int16;
		layout.components = 2;
		return;
	case 4:
		layout.type = NumberType::float32;
		layout.components = 2;
		return;
	case 6:
		layout.type = NumberType::uint16;
		return;
	default:
		throw Refusal(fmt::format("values of MRC mode {}, which are not read; convert it to mode 2", mode));
	}
}

} // namespace

void readMrc(const Request& request, ManifestWriter& manifest)
{
	const MappedText file(request.file);
	const MrcHeader header(file.text());
	ValueLayout layout;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		if (header.integer(axis) < 1)
			throw damaged("its size cannot be");
		layout.points[axis] = static_cast<std::uint32_t>(header.integer(axis));
	}
	setType(layout, header.integer(3));
	layout.is_big_endian = header.swapped();
	const int extended = header.integer(23);
	if (extended < 0 || static_cast<std::size_t>(extended) > file.text().size() - kHeaderBytes)
		throw damaged("its extended header runs past its end");
	std::string_view values = file.text().substr(kHeaderBytes + static_cast<std::size_t>(extended));
	values = values.substr(0, std::min<std::uint64_t>(values.size(), layout.byteCount()));
	const auto image = imageOf(arrayOf(values, layout, "density"), layout.points);

	// Columns, rows and sections may run along any of x, y and z; the cell's lengths and the origin are of these.
	std::array<double, 3> spacing = {1.0, 1.0, 1.0};
	std::array<double, 3> origin = {0.0, 0.0, 0.0};
	std::array<double, 9> direction = {};
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		const int given = header.integer(16 + axis);
		const std::size_t space = given == 0 ? axis : static_cast<std::size_t>(given - 1);
		const double length = header.real(10 + space);
		const int intervals = header.integer(7 + space);
		if (std::isfinite(length) && length > 0.0 && intervals > 0)
			spacing[axis] = length / intervals;
		direction[3 * space + axis] = 1.0;
		// Words 50 to 52 place the map; where they are 0, the first indices do.
		origin[space] = header.real(49 + space);
		if (origin[space] == 0.0)
			origin[space] = header.integer(4 + axis) * spacing[axis];
	}
	for (std::size_t angle = 13; angle < 16; ++angle)
		if (header.real(angle) != 90.0f && header.real(angle) != 0.0f)
			manifest.warn(fmt::format("an angle of its cell is {}; it is shown with right angles", header.real(angle)));
	if (!std::all_of(origin.begin(), origin.end(), [](double o) { return std::isfinite(o); }))
		throw damaged("its origin is no place");
	image->SetSpacing(spacing.data());
	image->SetOrigin(origin.data());
	image->SetDirectionMatrix(direction.data());
	manifest.setLengthUnits("Å");
	manifest.addLone(image);
}
