#pragma once

#include "viewer/panels/panels.h"

#include <optional>
#include <string>

namespace vp::app
{

// Says what lies under the pointer in the scene.
struct Pointed
{
	interact::SheetHit hit;
	std::optional<SheetLookups::Found> found; // empty while the probe moves: values come once it rests
};
std::optional<Pointed> pointedAt(const Desk& desk);

// Returns the text of the status line: what lies under the pointer, or else where the probe stands.
std::string pointerLine(const Desk& desk);

// Returns the value under the pointer, with the sheet's number in the cut. Returns nothing if the value is not a
// number.
std::optional<session::PointedValue> valueOf(const Desk& desk, const Pointed& pointed);

// Returns text such as "T [K] = 293.2", for the array that the sheet shows.
std::string valueWords(const Desk& desk, const Pointed& pointed);
std::string cellWords(const Pointed& pointed);

} // namespace vp::app
