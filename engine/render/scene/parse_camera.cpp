#include "base/angle.h"
#include "render/scene/camera.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace vp::render
{

namespace
{

// A scene that fills the picture is some 2000 times its size away. So its front and its back differ by a part of a
// pixel, and single precision still tells some 8000 depths of it apart.
constexpr double kParallelField = 0.0286; // degrees

// Moves the eye along its line of sight until this field of view shows the focal point as large as before.
Camera withField(Camera camera, double field)
{
	const double before = std::tan(0.5 * camera.vertical_field * kDegree), after = std::tan(0.5 * field * kDegree);
	camera.position = camera.focal_point + before / after * (camera.position - camera.focal_point);
	camera.vertical_field = field;
	return camera;
}

// Numbers between commas and blanks; none where anything else is among them.
std::optional<std::vector<double>> numbersIn(const std::string& text)
{
	std::vector<double> numbers;
	const char* at = text.c_str();
	while (true)
	{
		while (*at == ' ' || *at == ',' || *at == '\t')
			++at;
		if (*at == '\0')
			return numbers;
		char* end = nullptr;
		const double number = std::strtod(at, &end);
		if (end == at || !std::isfinite(number))
			return std::nullopt;
		numbers.push_back(number);
		at = end;
	}
}

CameraChoice fromDirection(const Vec3& direction, const Vec3& up)
{
	CameraChoice choice;
	choice.kind = CameraChoice::Kind::direction;
	choice.direction = direction;
	choice.up = up;
	return choice;
}

CameraChoice fromAngles(double azimuth, double elevation)
{
	const double a = azimuth * kDegree;
	const double e = elevation * kDegree;
	// The direction's derivative by elevation is upright at the poles too.
	return fromDirection({std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)},
	                     {-std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e)});
}

std::optional<CameraChoice> fromName(std::string_view name)
{
	CameraChoice choice;
	if (name == "auto")
		return choice;
	if (name == "sheet")
	{
		choice.kind = CameraChoice::Kind::sheet;
		return choice;
	}
	if (name == "iso")
		return fromDirection({1.0, 1.0, 1.0}, {0.0, 0.0, 1.0});
	const double side = name.starts_with('-') ? -1.0 : 1.0;
	if (side < 0.0)
		name.remove_prefix(1);
	if (name == "x")
		return fromDirection({side, 0.0, 0.0}, {0.0, 0.0, 1.0});
	if (name == "y")
		return fromDirection({0.0, side, 0.0}, {0.0, 0.0, 1.0});
	if (name == "z")
		return fromDirection({0.0, 0.0, side}, {0.0, 1.0, 0.0});
	return std::nullopt;
}

Result<CameraChoice> choiceOf(std::string_view text)
{
	if (auto named = fromName(text))
		return *named;
	const auto numbers = numbersIn(std::string(text));
	if (numbers && numbers->size() == 2)
		return fromAngles((*numbers)[0], (*numbers)[1]);
	if (numbers && numbers->size() == 9)
	{
		const std::vector<double>& n = *numbers;
		CameraChoice choice;
		choice.kind = CameraChoice::Kind::fixed;
		choice.camera.position = {n[0], n[1], n[2]};
		choice.camera.focal_point = {n[3], n[4], n[5]};
		choice.camera.up = {n[6], n[7], n[8]};
		if (choice.camera.position == choice.camera.focal_point)
			return Error{ErrorKind::usage, "position and focal point are the same; move one of them"};
		if (choice.camera.up == Vec3(0.0))
			return Error{ErrorKind::usage, "the up vector is zero; give one of any other length"};
		return choice;
	}
	return Error{ErrorKind::usage,
	             "no view; take auto, x, -x, y, -y, z, -z, iso, sheet, AZ,EL in degrees, or nine numbers: position, "
	             "focal point, up"};
}

} // namespace

double farther(const Camera& camera)
{
	return std::tan(0.5 * kUsualField * kDegree) / std::tan(0.5 * camera.vertical_field * kDegree);
}

CameraChoice projected(CameraChoice choice, Projection projection)
{
	if (projection == Projection::parallel)
		choice.camera = withField(choice.camera, kParallelField);
	return choice;
}

Result<CameraChoice> parseCamera(std::string_view text)
{
	Result<CameraChoice> choice = choiceOf(text);
	if (choice)
		choice->text = text;
	return choice;
}

CameraChoice fixedCamera(const Camera& given)
{
	const Camera camera = given.vertical_field == kParallelField ? withField(given, kUsualField) : given;
	const auto& [p, f, u] = std::tie(camera.position, camera.focal_point, camera.up);
	CameraChoice choice;
	choice.kind = CameraChoice::Kind::fixed;
	choice.camera = camera;
	choice.text = fmt::format("{},{},{},{},{},{},{},{},{}", p.x, p.y, p.z, f.x, f.y, f.z, u.x, u.y, u.z);
	return choice;
}

} // namespace vp::render
