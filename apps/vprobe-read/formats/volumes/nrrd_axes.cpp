#include "nrrd_axes.h"

#include "vprobe-read/base/refusal.h"
#include "vprobe-read/text/length_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::volumes
{

namespace
{

bool spaceHasTime(const Nrrd& nrrd)
{
	switch (nrrd.space)
	{
	case nrrdSpaceRightAnteriorSuperiorTime:
	case nrrdSpaceLeftAnteriorSuperiorTime:
	case nrrdSpaceLeftPosteriorSuperiorTime:
	case nrrdSpaceScannerXYZTime:
	case nrrdSpace3DRightHandedTime:
	case nrrdSpace3DLeftHandedTime:
		return true;
	default:
		return false;
	}
}

bool hasDirection(const Nrrd& nrrd, unsigned axis)
{
	return nrrd.spaceDim > 0 && std::isfinite(nrrd.axis[axis].spaceDirection[0]);
}

enum class AxisRole
{
	space,
	time,
	component,
	open // no kind
};

AxisRole roleByDirection(const Nrrd& nrrd, unsigned axis)
{
	if (!hasDirection(nrrd, axis))
		return nrrd.axis[axis].kind == nrrdKindTime ? AxisRole::time : AxisRole::component;
	const double* step = nrrd.axis[axis].spaceDirection;
	if (nrrd.spaceDim != 4 || step[3] == 0.0)
		return AxisRole::space;
	if (step[0] != 0.0 || step[1] != 0.0 || step[2] != 0.0)
		throw Refusal("an axis that runs through space and time at once; resample it");
	return AxisRole::time;
}

AxisRole roleByKind(int kind)
{
	switch (kind)
	{
	case nrrdKindUnknown:
		return AxisRole::open;
	case nrrdKindDomain:
	case nrrdKindSpace:
		return AxisRole::space;
	case nrrdKindTime:
		return AxisRole::time;
	default:
		return AxisRole::component;
	}
}

// The distance of samples along an axis without direction, and the place of the first.
std::pair<double, double> rangeOf(const NrrdAxisInfo& axis)
{
	const bool in_cells = axis.center == nrrdCenterCell;
	const double gaps = static_cast<double>(axis.size) - (in_cells ? 0 : 1);
	double spacing = 1.0, first = 0.0;
	if (std::isfinite(axis.spacing))
		spacing = axis.spacing;
	else if (std::isfinite(axis.min) && std::isfinite(axis.max) && gaps > 0)
		spacing = (axis.max - axis.min) / gaps;
	if (std::isfinite(axis.min))
		first = axis.min + (in_cells ? 0.5 * spacing : 0.0);
	else if (std::isfinite(axis.max))
		first = axis.max - (gaps - (in_cells ? 0.5 : 0.0)) * spacing;
	return {spacing, first};
}

std::string orientationOf(int space)
{
	switch (space)
	{
	case nrrdSpaceRightAnteriorSuperior:
	case nrrdSpaceRightAnteriorSuperiorTime:
		return "RAS";
	case nrrdSpaceLeftAnteriorSuperior:
	case nrrdSpaceLeftAnteriorSuperiorTime:
		return "LAS";
	case nrrdSpaceLeftPosteriorSuperior:
	case nrrdSpaceLeftPosteriorSuperiorTime:
		return "LPS";
	default:
		return {};
	}
}

void takeDirections(const Nrrd& nrrd, const NrrdAxes& axes, NrrdPlace& place)
{
	std::array<std::string, 3> units;
	for (std::size_t row = 0; row < 3; ++row)
		units[row] = nrrd.spaceUnits[row] ? nrrd.spaceUnits[row] : "";
	const text::OneLengthUnit one = text::oneLengthUnit(units); // the unit of space, not that of the axes
	for (std::size_t a = 0; a < 3; ++a)
	{
		std::array<double, 3> step;
		for (std::size_t row = 0; row < 3; ++row)
			step[row] = nrrd.axis[axes.space[a]].spaceDirection[row] * one.factors[row];
		place.spacing[a] = std::hypot(step[0], step[1], step[2]);
		for (std::size_t row = 0; row < 3; ++row)
			place.direction[3 * row + a] = step[row] / place.spacing[a];
	}
	if (std::isfinite(nrrd.spaceOrigin[0]))
		for (std::size_t row = 0; row < 3; ++row)
			place.origin[row] = nrrd.spaceOrigin[row] * one.factors[row];
	place.length_units = one.sign;
	place.orientation = orientationOf(nrrd.space);
	if (one.differ)
		place.note = text::unitsDiffer(units);
}

void takeSpacings(const Nrrd& nrrd, const NrrdAxes& axes, NrrdPlace& place)
{
	std::array<std::string, 3> units;
	for (std::size_t a = 0; a < 3; ++a)
		units[a] = nrrd.axis[axes.space[a]].units ? nrrd.axis[axes.space[a]].units : "";
	const text::OneLengthUnit one = text::oneLengthUnit(units);
	for (std::size_t a = 0; a < 3; ++a)
	{
		const auto [spacing, first] = rangeOf(nrrd.axis[axes.space[a]]);
		place.spacing[a] = spacing * one.factors[a];
		place.origin[a] = first * one.factors[a];
	}
	place.length_units = one.sign;
	if (one.differ)
		place.note = text::unitsDiffer(units);
}

} // namespace

grid::NumberType typeOfNrrd(int type)
{
	switch (type)
	{
	case nrrdTypeChar:
		return grid::NumberType::int8;
	case nrrdTypeUChar:
		return grid::NumberType::uint8;
	case nrrdTypeShort:
		return grid::NumberType::int16;
	case nrrdTypeUShort:
		return grid::NumberType::uint16;
	case nrrdTypeInt:
		return grid::NumberType::int32;
	case nrrdTypeUInt:
		return grid::NumberType::uint32;
	case nrrdTypeLLong:
		return grid::NumberType::int64;
	case nrrdTypeULLong:
		return grid::NumberType::uint64;
	case nrrdTypeFloat:
		return grid::NumberType::float32;
	case nrrdTypeDouble:
		return grid::NumberType::float64;
	default:
		throw Refusal("a NRRD file of values of type block, which have no number");
	}
}

NrrdAxes nrrdAxes(const Nrrd& nrrd)
{
	bool has_directions = false;
	for (unsigned i = 0; i < nrrd.dim; ++i)
		has_directions = has_directions || hasDirection(nrrd, i);
	if (has_directions && nrrd.spaceDim != 3 && !(nrrd.spaceDim == 4 && spaceHasTime(nrrd)))
		throw Refusal(fmt::format("a space of {} dimensions; give space directions of three", nrrd.spaceDim));

	std::vector<AxisRole> roles;
	for (unsigned i = 0; i < nrrd.dim; ++i)
		roles.push_back(has_directions ? roleByDirection(nrrd, i) : roleByKind(nrrd.axis[i].kind));
	// Where three kinds say space, the axes without any are none of it.
	const bool is_told = std::count(roles.begin(), roles.end(), AxisRole::space) >= 3;
	NrrdAxes axes;
	std::vector<unsigned> space;
	for (unsigned i = 0; i < nrrd.dim; ++i)
	{
		if (roles[i] == AxisRole::space || (roles[i] == AxisRole::open && !is_told))
			space.push_back(i);
		else if (roles[i] != AxisRole::time)
			axes.components.push_back(i);
		else if (axes.time)
			throw Refusal("two axes of time; write each time of one of them into a file of its own");
		else
			axes.time = i;
	}
	if (space.size() < 3)
		throw Refusal("nothing to slice: fewer than three axes of space");
	if (space.size() > 3)
		throw Refusal(fmt::format("{} axes of space; kinds: in its header say which are not", space.size()));
	std::copy_n(space.begin(), 3, axes.space.begin());
	return axes;
}

NrrdPlace nrrdPlace(const Nrrd& nrrd, const NrrdAxes& axes)
{
	NrrdPlace place;
	if (hasDirection(nrrd, axes.space[0]))
		takeDirections(nrrd, axes, place);
	else
		takeSpacings(nrrd, axes, place);
	for (std::size_t i = 0; i < 9; ++i)
		if (!std::isfinite(place.direction[i]) || !std::isfinite(place.spacing[i % 3]) || place.spacing[i % 3] == 0.0)
			throw damaged("its spacings or directions make no grid");
	return place;
}

std::vector<double> nrrdTimes(const Nrrd& nrrd, const NrrdAxes& axes)
{
	std::vector<double> times;
	if (!axes.time)
		return times;
	const NrrdAxisInfo& axis = nrrd.axis[*axes.time];
	auto [step, first] = rangeOf(axis);
	if (hasDirection(nrrd, *axes.time))
	{
		step = axis.spaceDirection[3];
		first = std::isfinite(nrrd.spaceOrigin[3]) ? nrrd.spaceOrigin[3] : 0.0;
	}
	if (axis.size > 1u << 24)
		throw damaged("it has more times than there can be");
	for (std::size_t t = 0; axis.size > 1 && t < axis.size; ++t)
		times.push_back(first + static_cast<double>(t) * step);
	return times;
}

std::string nrrdTimeUnits(const Nrrd& nrrd, const NrrdAxes& axes)
{
	if (!axes.time)
		return {};
	const char* units = hasDirection(nrrd, *axes.time) ? nrrd.spaceUnits[3] : nrrd.axis[*axes.time].units;
	return units ? units : "";
}

} // namespace vp::reader::volumes
