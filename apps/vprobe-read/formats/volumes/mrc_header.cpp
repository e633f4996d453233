// Words are counted from 0; those of the format's description ("MRC2014", Cheng et al., J. Struct. Biol. 192, 2015)
// from 1. IMOD's additions: https://bio3d.colorado.edu/imod/doc/mrc_format.txt
#include "mrc_header.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::reader::volumes
{

using grid::NumberType;

namespace
{

constexpr std::size_t kMrcHeaderBytes = 1024;
constexpr int kImodStamp = 1146047817; // "IMOD"

enum ImodFlag
{
	signed_bytes = 1,
	standard_origin = 4,
	packed_bytes = 16
};

} // namespace

template <class Number>
Number MrcHeader::number(std::size_t word) const
{
	return numberAt<Number>(file_.data() + 4 * word, order_);
}

bool MrcHeader::hasOrderOfAxes() const
{
	std::array<int, 3> axes = {integer(16), integer(17), integer(18)};
	std::sort(axes.begin(), axes.end());
	if (axes == std::array<int, 3>{0, 0, 0}) // not said; then the mode tells the order of bytes
		return integer(3) >= 0 && integer(3) < 1 << 16;
	return axes == std::array<int, 3>{1, 2, 3};
}

// The machine stamp is often wrong; an order of axes is one of six.
void MrcHeader::chooseOrder()
{
	if (hasOrderOfAxes())
		return;
	order_ = ByteOrder::big;
	if (!hasOrderOfAxes())
		throw damaged("its axes have no order");
}

void MrcHeader::setType()
{
	const int flags = by_imod_ ? integer(39) : 0;
	switch (mode_)
	{
	case 0:
		if (flags & packed_bytes)
			throw Refusal("bytes of two values each (IMOD's flag 16); convert it with newstack -mode 0");
		layout_.type = by_imod_ && !(flags & signed_bytes) ? NumberType::uint8 : NumberType::int8;
		return;
	case 1:
		layout_.type = NumberType::int16;
		return;
	case 2:
		layout_.type = NumberType::float32;
		return;
	case 3:
	case 4:
		throw Refusal(
		    fmt::format("complex values (MRC mode {}), which are a transform; transform it back to mode 2", mode_));
	case 6:
	case 12:
		layout_.type = NumberType::uint16;
		return;
	case 16: // IMOD's colors
		layout_.components = 3;
		layout_.type = NumberType::uint8;
		return;
	case 101:
		layout_.type = NumberType::uint8;
		return;
	default:
		throw Refusal(fmt::format("values of MRC mode {}, which are not read; convert it to mode 2", mode_));
	}
}

// Space groups from 401 on mark a stack of volumes, each of as many sections as the cell has along z.
void MrcHeader::splitVolumes()
{
	const int group = integer(22);
	const int sections = integer(9);
	if (group < 401 || group > 630)
		return;
	if (sections < 1 || layout_.points[2] % static_cast<std::uint32_t>(sections) != 0)
		throw damaged(fmt::format("a stack of volumes of {} sections each has {}", sections, layout_.points[2]));
	volumes_ = layout_.points[2] / static_cast<std::uint32_t>(sections);
	layout_.points[2] = static_cast<std::uint32_t>(sections);
}

MrcHeader::MrcHeader(std::string_view file) : file_(file)
{
	if (file.size() < kMrcHeaderBytes)
		throw damaged("it ends within its header");
	chooseOrder();
	mode_ = integer(3);
	by_imod_ = integer(38) == kImodStamp;
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		if (integer(axis) < 1)
			throw damaged("its size cannot be");
		layout_.points[axis] = static_cast<std::uint32_t>(integer(axis));
	}
	setType();
	splitVolumes();
	layout_.is_big_endian = order_ == ByteOrder::big;
	const int extended = integer(23);
	if (extended < 0 || static_cast<std::size_t>(extended) > file.size() - kMrcHeaderBytes)
		throw damaged("its extended header runs past its end");
	values_begin_ = kMrcHeaderBytes + static_cast<std::uint64_t>(extended);
}

std::uint64_t MrcHeader::bytesOfVolume() const
{
	if (!isPacked())
		return layout_.byteCount();
	arrays::ValueLayout bytes = layout_;
	bytes.points[0] = bytes.points[0] / 2 + bytes.points[0] % 2;
	return bytes.byteCount();
}

// Unit vectors: the first along x, the second in the plane of x and y.
std::array<std::array<double, 3>, 3> MrcHeader::cellAxes() const
{
	std::array<double, 3> angles;
	for (std::size_t i = 0; i < 3; ++i)
		angles[i] = real(13 + i);
	if (std::all_of(angles.begin(), angles.end(), [](double angle) { return angle == 90.0 || angle == 0.0; }))
		return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
	std::array<double, 3> cosines;
	for (std::size_t i = 0; i < 3; ++i)
		cosines[i] = angles[i] == 90.0 ? 0.0 : std::cos(angles[i] * std::numbers::pi / 180.0);
	const auto [alpha, beta, gamma] = cosines;
	const double sine = std::sqrt(1.0 - gamma * gamma);
	const double y = (alpha - beta * gamma) / sine;
	const double rest = 1.0 - beta * beta - y * y;
	if (!(sine > 1e-6) || !(rest > 1e-6))
		throw damaged("the angles of its cell make no cell");
	return {{{1, 0, 0}, {gamma, sine, 0}, {beta, y, std::sqrt(rest)}}};
}

MrcHeader::Place MrcHeader::place() const
{
	Place place = {{0, 0, 0}, {1, 1, 1}, {}};
	const auto cell = cellAxes();
	// Columns, rows and sections may run along any axis of the cell, whose lengths and angles are of these.
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		const int given = integer(16 + axis);
		const std::size_t space = given == 0 ? axis : static_cast<std::size_t>(given - 1);
		const double length = real(10 + space);
		const int intervals = integer(7 + space);
		if (std::isfinite(length) && length > 0.0 && intervals > 0)
			place.spacing[axis] = length / intervals;
		for (std::size_t row = 0; row < 3; ++row)
		{
			place.direction[3 * row + axis] = cell[space][row];
			place.origin[row] += integer(4 + axis) * place.spacing[axis] * cell[space][row];
		}
	}
	// Words 50 to 52 place the map. Where all are 0, the first indices do.
	const std::array<double, 3> origin = {real(49), real(50), real(51)};
	if (!std::all_of(origin.begin(), origin.end(), [](double o) { return std::isfinite(o); }))
		throw damaged("its origin is no place");
	if (origin == std::array<double, 3>{0, 0, 0})
		return place;
	// IMOD's own origin has the other sign, unless it says otherwise or follows MRC2014, whose version is given then.
	const bool is_turned = by_imod_ && !(integer(39) & standard_origin) && (integer(27) < 20140 || integer(27) > 29999);
	for (std::size_t row = 0; row < 3; ++row)
		place.origin[row] = is_turned ? -origin[row] : origin[row];
	return place;
}

} // namespace vp::reader::volumes
