#include "render/color/color_spaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::render
{

namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kWhite[3] = {0.95047, 1.0, 1.08883}; // D65

struct Lab
{
	double l, a, b;
};

Lab toLab(const Rgb& color)
{
	const auto linear = [](double c) { return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92; };
	const double r = linear(color.r);
	const double g = linear(color.g);
	const double b = linear(color.b);
	const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
	const double fx = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / kWhite[0]);
	const double fy = f((0.2126 * r + 0.7152 * g + 0.0722 * b) / kWhite[1]);
	const double fz = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / kWhite[2]);
	return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

Rgb fromLab(const Lab& lab)
{
	const auto inverse = [](double t) { return t > 0.2068966 ? t * t * t : (t - 16.0 / 116.0) / 7.787; };
	const double fy = (lab.l + 16.0) / 116.0;
	const double x = kWhite[0] * inverse(fy + lab.a / 500.0);
	const double y = kWhite[1] * inverse(fy);
	const double z = kWhite[2] * inverse(fy - lab.b / 200.0);
	const auto encoded = [](double c)
	{
		c = std::clamp(c, 0.0, 1.0);
		return c > 0.0031308 ? 1.055 * std::pow(c, 1.0 / 2.4) - 0.055 : 12.92 * c;
	};
	return {encoded(3.2406 * x - 1.5372 * y - 0.4986 * z), encoded(-0.9689 * x + 1.8758 * y + 0.0415 * z),
	        encoded(0.0557 * x - 0.2040 * y + 1.0570 * z)};
}

// Magnitude, saturation and hue about CIELAB's gray axis.
struct Msh
{
	double m, s, h;
};

Msh toMsh(const Rgb& color)
{
	const Lab lab = toLab(color);
	const double m = std::sqrt(lab.l * lab.l + lab.a * lab.a + lab.b * lab.b);
	return {m, m > 1e-3 ? std::acos(std::clamp(lab.l / m, -1.0, 1.0)) : 0.0, std::atan2(lab.b, lab.a)};
}

Rgb fromMsh(const Msh& msh)
{
	const double colored = msh.m * std::sin(msh.s);
	return fromLab({msh.m * std::cos(msh.s), colored * std::cos(msh.h), colored * std::sin(msh.h)});
}

// The hue that a gray of magnitude m takes so that it fades to the color with even steps.
double spunHue(const Msh& to, double m)
{
	if (to.m >= m)
		return to.h;
	const double spin = to.s * std::sqrt(m * m - to.m * to.m) / (to.m * std::sin(to.s));
	return to.h > -kPi / 3.0 ? to.h + spin : to.h - spin;
}

// From here on a color has a hue that tells.
constexpr double kSaturated = 0.05;

Rgb betweenDiverging(const Rgb& first, const Rgb& second, double part)
{
	Msh a = toMsh(first);
	Msh b = toMsh(second);
	const double turn = std::abs(std::remainder(a.h - b.h, 2.0 * kPi));
	if (a.s > kSaturated && b.s > kSaturated && turn > kPi / 3.0)
	{
		// Different hues meet in a gray.
		const Msh middle{std::max({a.m, b.m, 88.0}), 0.0, 0.0};
		(part < 0.5 ? b : a) = middle;
		part = part < 0.5 ? 2.0 * part : 2.0 * part - 1.0;
	}
	if (a.s < kSaturated && b.s > kSaturated)
		a.h = spunHue(b, a.m);
	else if (b.s < kSaturated && a.s > kSaturated)
		b.h = spunHue(a, b.m);
	const auto mix = [part](double x, double y) { return (1.0 - part) * x + part * y; };
	return fromMsh({mix(a.m, b.m), mix(a.s, b.s), mix(a.h, b.h)});
}

// Hue from 0 to 1, saturation, value.
Vec3 toHsv(const Rgb& c)
{
	const double most = std::max({c.r, c.g, c.b});
	const double chroma = most - std::min({c.r, c.g, c.b});
	if (chroma <= 0.0)
		return {0.0, 0.0, most};
	const double sixths = most == c.r   ? (c.g - c.b) / chroma
	                      : most == c.g ? 2.0 + (c.b - c.r) / chroma
	                                    : 4.0 + (c.r - c.g) / chroma;
	return {sixths / 6.0 - std::floor(sixths / 6.0), chroma / most, most};
}

Rgb fromHsv(const Vec3& hsv)
{
	const auto channel = [&](double shift)
	{
		const double k = std::fmod(shift + 6.0 * (hsv.x - std::floor(hsv.x)), 6.0);
		return hsv.z - hsv.z * hsv.y * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
	};
	return {channel(5.0), channel(3.0), channel(1.0)};
}

Rgb betweenHues(const Rgb& first, const Rgb& second, double part)
{
	Vec3 a = toHsv(first);
	Vec3 b = toHsv(second);
	if (std::abs(a.x - b.x) > 0.5)
		(a.x > b.x ? a.x : b.x) -= 1.0;
	return fromHsv(glm::mix(a, b, part));
}

} // namespace

Rgb between(const Rgb& a, const Rgb& b, double part, ColorSpace space)
{
	switch (space)
	{
	case ColorSpace::rgb:
		break;
	case ColorSpace::hsv:
		return betweenHues(a, b, part);
	case ColorSpace::lab:
	{
		const Lab from = toLab(a);
		const Lab to = toLab(b);
		const auto mix = [part](double x, double y) { return (1.0 - part) * x + part * y; };
		return fromLab({mix(from.l, to.l), mix(from.a, to.a), mix(from.b, to.b)});
	}
	case ColorSpace::diverging:
		return betweenDiverging(a, b, part);
	case ColorSpace::step:
		return b;
	}
	return glm::mix(a, b, part);
}

} // namespace vp::render
