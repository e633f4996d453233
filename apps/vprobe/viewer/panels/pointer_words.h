#pragma once

#include "viewer/panels/panels.h"

#include <optional>
#include <string>

namespace vp::app
{

// What lies under the pointer in the scene.
struct Pointed
{
	interact::SheetHit hit;
	std::optional<SheetLookups::Found> found; // none while the hand moves: values come once it rests
};
std::optional<Pointed> pointedAt(const Desk& desk);

// For the status line: what lies under the pointer, else where the probe stands.
std::string pointerLine(const Desk& desk);

// Its value, on the sheet of the cut; none where that is no number.
std::optional<session::PointedValue> valueOf(const Desk& desk, const Pointed& pointed);

// "T [K] = 293.2", of the array that the sheet shows.
std::string valueWords(const Desk& desk, const Pointed& pointed);
std::string cellWords(const Pointed& pointed);

} // namespace vp::app
