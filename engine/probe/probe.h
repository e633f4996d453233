#pragma once

#include "probe/sheet.h"

#include <string>
#include <vector>

namespace vp::probe
{

// More than a picture shows at once (16 layers); each sheet of a slice keeps a byte a cell of visited marks.
constexpr std::size_t kMaxSheets = 64;

// Sheets that move together. They are given in the probe's coordinates, and only the frame, which is to_probe, moves
// them.
struct Probe
{
	std::vector<Sheet> sheets;
	Frame frame{}; // place of the probe in the world
	std::string name{};

	bool operator==(const Probe&) const = default;
};

inline Transform toProbe(const Probe& probe)
{
	return toFrame(probe.frame);
}

// Returns the same probe with its sheets in world coordinates and the world as its frame, as cuts need it. Hidden
// sheets stay.
Probe placed(const Probe& probe);

} // namespace vp::probe
