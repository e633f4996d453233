#include "grid/orientation.h"

#include <array>
#include <cmath>
#include <utility>

namespace vp::grid
{

Orientation parseOrientation(std::string_view text)
{
	if (text == "rows-down")
		return {{}, true};
	if (text.size() != 3)
		return {};
	std::array<Vec3, 3> sides{}; // left, front, head
	for (int axis = 0; axis < 3; ++axis)
	{
		Vec3 direction(0.0);
		direction[axis] = 1.0;
		switch (text[static_cast<std::size_t>(axis)])
		{
		case 'L':
			sides[0] = direction;
			break;
		case 'R':
			sides[0] = -direction;
			break;
		case 'A':
			sides[1] = direction;
			break;
		case 'P':
			sides[1] = -direction;
			break;
		case 'S':
		case 'H':
			sides[2] = direction;
			break;
		case 'I':
		case 'F':
			sides[2] = -direction;
			break;
		default:
			return {};
		}
	}
	for (const Vec3& side : sides)
		if (side == Vec3(0.0)) // another one is named twice
			return {};
	return {Orientation::Patient{sides[0], sides[1], sides[2]}, false};
}

char sideOf(const Orientation::Patient& patient, const Vec3& direction)
{
	char nearest = '\0';
	double most = -1.0;
	for (const auto& [axis, letters] :
	     {std::pair{patient.left, "LR"}, std::pair{patient.front, "AP"}, std::pair{patient.head, "HF"}})
		if (const double along = glm::dot(axis, direction); std::abs(along) > most)
		{
			most = std::abs(along);
			nearest = along >= 0.0 ? letters[0] : letters[1];
		}
	return nearest;
}

} // namespace vp::grid
