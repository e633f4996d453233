#pragma once

#include "base/result.h"
#include "surface/curved.h"
#include "surface/expression.h"
#include "surface/quadric.h"

#include <string>
#include <variant>

namespace vp::surface
{

// Where the values of the shown array, which is of points, pass this one; linear along edges.
struct IsoValue
{
	double value = 0.0;

	bool operator==(const IsoValue&) const = default;
};

// What a sheet cuts by where that is no plane, in the sheet's own coordinates: x along its x axis, y along up, z along
// its normal.
class ImplicitSurface
{
public:
	// sphere:R, cylinder:R (about z), cone:DEGREES (about z, half its opening angle), ellipsoid:A,B,C, quadric: and the
	// ten coefficients of Quadric, iso:VALUE; anything else is an expression in x, y and z (expression.h), cut where it
	// is 0. A usage error, without the option's name, tells what is wrong.
	static Result<ImplicitSurface> parse(const std::string& text);

	const std::string& text() const { return text_; }
	const IsoValue* isoValue() const { return std::get_if<IsoValue>(&kind_); }
	// Whether it is about the sheet's origin: an expression is in the grid's coordinates unless it is placed.
	bool isAboutOrigin() const;
	// Not of an iso value, which has no place.
	Curved placed(const Axes& axes) const;

	bool operator==(const ImplicitSurface&) const = default;

private:
	using Kind = std::variant<Quadric, Expression, IsoValue>;

	ImplicitSurface(std::string text, Kind kind) : text_(std::move(text)), kind_(std::move(kind)) {}

	std::string text_;
	Kind kind_;
};

} // namespace vp::surface
