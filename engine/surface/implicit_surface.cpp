#include "surface/implicit_surface.h"

#include "surface/number_text.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <vector>

namespace vp::surface
{

namespace
{

// Numbers parted by commas; none where one is no number.
std::optional<std::vector<double>> numbersOf(std::string_view text)
{
	std::vector<double> numbers;
	for (;;)
	{
		const std::size_t comma = text.find(',');
		const std::optional<double> number = numberOf(text.substr(0, comma));
		if (!number)
			return std::nullopt;
		numbers.push_back(*number);
		if (comma == std::string_view::npos)
			return numbers;
		text.remove_prefix(comma + 1);
	}
}

using Numbers = std::vector<double>;

Result<Quadric> makeSphere(const Numbers& n)
{
	if (n[0] <= 0.0)
		return Error{ErrorKind::usage, "a radius is above 0"};
	return Quadric::sphere(n[0]);
}

Result<Quadric> makeCylinder(const Numbers& n)
{
	if (n[0] <= 0.0)
		return Error{ErrorKind::usage, "a radius is above 0"};
	return Quadric::cylinder(n[0]);
}

Result<Quadric> makeCone(const Numbers& n)
{
	if (n[0] <= 0.0 || n[0] >= 90.0)
		return Error{ErrorKind::usage, "half a cone's opening angle lies between 0 and 90 degrees"};
	return Quadric::cone(n[0]);
}

Result<Quadric> makeEllipsoid(const Numbers& n)
{
	if (n[0] <= 0.0 || n[1] <= 0.0 || n[2] <= 0.0)
		return Error{ErrorKind::usage, "half axes are above 0"};
	return Quadric::ellipsoid(n[0], n[1], n[2]);
}

Result<Quadric> makeQuadric(const Numbers& n)
{
	Quadric::Coefficients coefficients;
	std::copy(n.begin(), n.end(), coefficients.begin());
	if (std::all_of(n.begin(), n.end() - 1, [](double number) { return number == 0.0; }))
		return Error{ErrorKind::usage, "is constant; give one of the first nine numbers another value than 0"};
	return Quadric(coefficients);
}

struct QuadricWord
{
	std::string_view word;
	std::size_t numbers;
	const char* takes;
	Result<Quadric> (*make)(const Numbers& numbers);
};

constexpr QuadricWord kWords[] = {
    {"sphere", 1, "a radius, such as sphere:1.5", makeSphere},
    {"cylinder", 1, "a radius, such as cylinder:1.5", makeCylinder},
    {"cone", 1, "half its opening angle in degrees, such as cone:30", makeCone},
    {"ellipsoid", 3, "three half axes, such as ellipsoid:2,1,1", makeEllipsoid},
    {"quadric", 10, "ten numbers, of xx,yy,zz,xy,xz,yz,x,y,z,1", makeQuadric},
};

} // namespace

Result<ImplicitSurface> ImplicitSurface::parse(const std::string& text)
{
	const std::size_t colon = text.find(':');
	const std::string_view word = std::string_view(text).substr(0, colon);
	const std::string_view rest = colon == std::string::npos ? "" : std::string_view(text).substr(colon + 1);
	const std::optional<Numbers> numbers = numbersOf(rest);
	if (word == "iso")
	{
		if (!numbers || numbers->size() != 1)
			return Error{ErrorKind::usage, "after iso: goes a value, such as iso:0.5"};
		return ImplicitSurface(text, IsoValue{numbers->front()});
	}
	for (const QuadricWord& known : kWords)
	{
		if (word != known.word)
			continue;
		if (!numbers || numbers->size() != known.numbers)
			return Error{ErrorKind::usage, fmt::format("takes {}", known.takes)};
		Result<Quadric> quadric = known.make(*numbers);
		return quadric ? Result<ImplicitSurface>(ImplicitSurface(text, *quadric)) : quadric.error();
	}
	if (colon != std::string::npos)
		return Error{ErrorKind::usage, "is no surface; take sphere:R, cylinder:R, cone:DEGREES, ellipsoid:A,B,C, "
		                               "quadric: and ten numbers, iso:VALUE, or an expression in x, y and z"};
	Result<Expression> expression = Expression::parse(text);
	return expression ? Result<ImplicitSurface>(ImplicitSurface(text, *expression)) : expression.error();
}

bool ImplicitSurface::isAboutOrigin() const
{
	return !std::holds_alternative<Expression>(kind_);
}

Curved ImplicitSurface::placed(const Axes& axes) const
{
	if (const Quadric* quadric = std::get_if<Quadric>(&kind_))
		return quadric->placed(axes);
	return PlacedExpression(std::get<Expression>(kind_), axes);
}

} // namespace vp::surface
