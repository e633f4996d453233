#include "picture/facing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vp::picture
{

namespace
{

constexpr double kAlongAxis = 1.0 - 1e-12; // the part of a unit vector along an axis to which it is parallel
constexpr double kNearAxis = 0.7072;       // the same for a patient's planes that are less than 45 degrees off an axis
constexpr double kLevel = 0.02;            // the sine below which a projection is too short to show what is up

constexpr Vec3 kX{1.0, 0.0, 0.0};
constexpr Vec3 kY{0.0, 1.0, 0.0};
constexpr Vec3 kZ{0.0, 0.0, 1.0};

struct Facing
{
	Vec3 right;
	Vec3 up;
};

// Returns how planes normal to x, y and z are seen.
std::array<Facing, 3> facingsOf(const grid::Orientation& orientation)
{
	if (orientation.first_row_is_top)
		return {Facing{kZ, -kY}, Facing{kX, -kZ}, Facing{kX, -kY}};
	if (!orientation.patient)
		return {Facing{kY, kZ}, Facing{kX, kZ}, Facing{kX, kY}};
	const auto& [left, front, head] = *orientation.patient;
	std::array<Facing, 3> facings;
	const auto put = [&](const Vec3& normal, const Facing& facing)
	{
		for (int axis = 0; axis < 3; ++axis)
			if (normal[axis] != 0.0)
				facings[static_cast<std::size_t>(axis)] = facing;
	};
	put(head, {left, front});
	put(front, {left, head});
	put(left, {-front, head});
	return facings;
}

// Returns the direction that is up where a plane lies along no two axes, and the one that takes its place on planes
// that are nearly normal to it.
std::array<Vec3, 2> upwardsOf(const grid::Orientation& orientation)
{
	if (orientation.patient)
		return {orientation.patient->head, orientation.patient->front};
	if (orientation.first_row_is_top)
		return {-kY, -kZ};
	return {kZ, kY};
}

// Returns the axis along which more than this part of a unit vector lies.
std::optional<int> axisOf(const Vec3& normal, double part)
{
	for (int axis = 0; axis < 3; ++axis)
		if (std::abs(normal[axis]) > part)
			return axis;
	return std::nullopt;
}

// Returns a view of a plane with this normal from the side, and with the projection of the top, of another one.
Facing tilted(const Facing& facing, const Vec3& normal)
{
	const bool is_same_side = glm::dot(glm::cross(facing.right, facing.up), normal) > 0.0;
	const Vec3 up = glm::normalize(facing.up - glm::dot(facing.up, normal) * normal);
	return {glm::cross(up, is_same_side ? normal : -normal), up};
}

Facing facingOf(const Vec3& normal, const grid::Orientation& orientation)
{
	const auto asAlong = [&](int axis)
	{
		const Facing facing = facingsOf(orientation)[static_cast<std::size_t>(axis)];
		return normal[axis] > 0.0 ? facing : Facing{-facing.right, facing.up};
	};
	if (const std::optional<int> axis = axisOf(normal, kAlongAxis))
		return asAlong(*axis);
	if (const std::optional<int> axis = orientation.patient ? axisOf(normal, kNearAxis) : std::nullopt)
		return tilted(asAlong(*axis), normal);
	const auto [usual, other] = upwardsOf(orientation);
	Vec3 up = usual - glm::dot(usual, normal) * normal;
	if (glm::length(up) < kLevel)
		up = other - glm::dot(other, normal) * normal;
	up = glm::normalize(up);
	return {glm::cross(up, normal), up};
}

// Returns the quarter turn of the sheet's own axes, seen from the same side, that brings `facing` nearest.
Facing nearestQuarter(const probe::Sheet& sheet, const Facing& facing)
{
	const Vec3 toward = glm::cross(facing.right, facing.up);
	Facing nearest = facing;
	double most = -2.0;
	for (const Vec3& up : {sheet.up, -sheet.up, sheet.xAxis(), -sheet.xAxis()})
		if (const double along = glm::dot(up, facing.up); along > most)
		{
			most = along;
			nearest = {glm::cross(up, toward), up};
		}
	return nearest;
}

probe::Window turned(const probe::Window& window, const probe::Sheet& from, const Facing& to)
{
	probe::Window result{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
	for (const double x : {window.x0, window.x1})
		for (const double y : {window.y0, window.y1})
		{
			const double right =
			    x * std::round(glm::dot(from.xAxis(), to.right)) + y * std::round(glm::dot(from.up, to.right));
			const double up = x * std::round(glm::dot(from.xAxis(), to.up)) + y * std::round(glm::dot(from.up, to.up));
			result.x0 = std::min(result.x0, right);
			result.x1 = std::max(result.x1, right);
			result.y0 = std::min(result.y0, up);
			result.y1 = std::max(result.y1, up);
		}
	return result;
}

} // namespace

grid::Orientation orientationOf(const grid::BlockSet& blocks)
{
	const auto& all = blocks.blocks;
	const auto is_same = [&](const grid::Block& block)
	{ return block.imaging.orientation == all.front().imaging.orientation; };
	return !all.empty() && std::ranges::all_of(all, is_same) ? grid::parseOrientation(all.front().imaging.orientation)
	                                                         : grid::Orientation{};
}

std::array<std::string, 4> sidesOf(const probe::Sheet& shown, const grid::Orientation::Patient& patient)
{
	std::array<std::string, 4> sides;
	for (std::size_t i = 0; i < sides.size(); ++i)
	{
		const Vec3 axis = i < 2 ? shown.xAxis() : shown.up;
		sides[i] = grid::sideOf(patient, i % 2 == 0 ? -axis : axis);
	}
	return sides;
}

probe::Sheet facingSheet(const probe::Sheet& sheet, const grid::Orientation& orientation, bool keep_up)
{
	Facing facing = facingOf(sheet.normal, orientation);
	if (keep_up)
		facing = {glm::cross(sheet.up, glm::cross(facing.right, facing.up)), sheet.up};
	else if (sheet.window)
		facing = nearestQuarter(sheet, facing);
	probe::Sheet shown = sheet;
	shown.normal = glm::cross(facing.right, facing.up);
	shown.up = facing.up;
	if (sheet.window)
		shown.window = turned(*sheet.window, sheet, facing);
	return shown;
}

} // namespace vp::picture
