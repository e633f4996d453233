#pragma once

#include "base/result.h"
#include "surface/curved.h"
#include "surface/expression.h"
#include "surface/quadric.h"

#include <string>
#include <variant>

namespace vp::surface
{

// The surface where the shown array, which must be an array of points, has this value. It is linear along edges.
struct IsoValue
{
	double value = 0.0;

	bool operator==(const IsoValue&) const = default;
};

// The cutting surface of a sheet that is not a plane, in the coordinates of the sheet: x along its x axis, y along up,
// z along its normal.
class ImplicitSurface
{
public:
	// sphere:R, cylinder:R (about z), cone:DEGREES (about z, half its opening angle), ellipsoid:A,B,C, quadric: and the
	// ten coefficients of Quadric, iso:VALUE. Any other text is an expression in x, y and z (expression.h); the surface
	// is where it is 0. A usage error says what is wrong, without the name of the option.
	static Result<ImplicitSurface> parse(const std::string& text);

	const std::string& text() const { return text_; }
	const IsoValue* isoValue() const { return std::get_if<IsoValue>(&kind_); }
	// Returns true if it is relative to the sheet's origin. An expression has the coordinates of the grid unless it is
	// placed.
	bool isAboutOrigin() const;
	// Do not call this for an iso value, which has no place.
	Curved placed(const Axes& axes) const;

	bool operator==(const ImplicitSurface&) const = default;

private:
	using Kind = std::variant<Quadric, Expression, IsoValue>;

	ImplicitSurface(std::string text, Kind kind) : text_(std::move(text)), kind_(std::move(kind)) {}

	std::string text_;
	Kind kind_;
};

} // namespace vp::surface
