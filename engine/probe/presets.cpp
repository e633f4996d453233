#include "probe/presets.h"

#include "probe/extent.h"

#include <cassert>

namespace vp::probe
{

namespace
{

const Vec3 kX(1.0, 0.0, 0.0);
const Vec3 kY(0.0, 1.0, 0.0);
const Vec3 kZ(0.0, 0.0, 1.0);

Sheet sheetAt(const Frame& frame, const std::optional<WindowSize>& size)
{
	Sheet sheet{frame, {}, {}, {}};
	if (size)
		sheet.window = centeredWindow(size->width, size->height);
	return sheet;
}

} // namespace

Probe single(const Frame& frame, const std::optional<WindowSize>& size)
{
	return {{sheetAt({}, size)}, frame, "single"};
}

Probe trihedral(const Frame& frame, const std::optional<WindowSize>& size)
{
	Probe probe{{}, frame, "trihedral"};
	for (const Vec3& normal : {kX, kY, kZ})
		probe.sheets.push_back(sheetAt(makeFrame(Vec3(0.0), normal), size));
	return probe;
}

Probe paddlewheel(const Frame& frame, const Box& bounds, int vanes, const std::optional<WindowSize>& size)
{
	assert(vanes >= 1 && static_cast<std::size_t>(vanes) <= kMaxSheets);
	const double diagonal = bounds.diagonal();
	const Window window = size ? Window{0.0, size->width, -0.5 * size->height, 0.5 * size->height}
	                           : Window{0.0, diagonal, -0.5 * diagonal, 0.5 * diagonal};
	Probe probe{{}, frame, "paddlewheel"};
	for (int k = 0; k < vanes; ++k)
	{
		Sheet vane{turned({}, Vec3(0.0), kY, 360.0 * k / vanes), {}, {}, {}};
		vane.window = window;
		probe.sheets.push_back(vane);
	}
	return probe;
}

bool reachesAround(const Window& window, const Box& bounds)
{
	constexpr double kRounded = 0.999; // a window that was turned or written to a file is not quite the same
	const double diagonal = kRounded * bounds.diagonal();
	return diagonal > 0.0 && window.width() >= diagonal && window.height() >= diagonal;
}

Probe stack(const Frame& frame, std::span<const double> offsets, const std::optional<WindowSize>& size)
{
	assert(!offsets.empty() && offsets.size() <= kMaxSheets);
	Probe probe{{}, frame, "stack"};
	for (const double offset : offsets)
		probe.sheets.push_back(sheetAt({offset * kZ, kZ, kY}, size));
	return probe;
}

std::vector<double> evenOffsets(const Frame& frame, const Box& bounds, int sheets)
{
	assert(sheets >= 1);
	const Extent extent = extentAlong(bounds, frame.normal, frame.origin);
	std::vector<double> offsets;
	for (int k = 0; k < sheets; ++k)
		offsets.push_back(extent.middle + (2.0 * k + 1.0 - sheets) / sheets * extent.half);
	return offsets;
}

} // namespace vp::probe
