#include "cf_grid.h"

#include <cmath>

namespace vp::reader::volumes
{

namespace
{

constexpr double kTurn = 360.0;

// The same longitude, as near as can be to another one.
double nearTo(double other, double longitude)
{
	return longitude - kTurn * std::round((longitude - other) / kTurn);
}

template <class Visit>
void forEachBeside(std::size_t i, std::size_t width, std::size_t count, Visit&& visit)
{
	if (i % width > 0)
		visit(i - 1);
	if (i % width + 1 < width && i + 1 < count)
		visit(i + 1);
	if (i >= width)
		visit(i - width);
	if (i + width < count)
		visit(i + width);
}

bool isHalfTurnOff(double a, double b)
{
	return std::abs(a - b) > kTurn / 2 * (1 + 1e-9);
}

} // namespace

std::vector<bool> unwrapLongitudes(std::vector<double>& places, std::size_t width)
{
	std::vector<bool> is_sound(places.size(), true), is_done(places.size(), false);
	bool has_jump = false;
	for (std::size_t i = 0; i < places.size() && !has_jump; ++i)
		forEachBeside(i, width, places.size(),
		              [&](std::size_t other) { has_jump = has_jump || isHalfTurnOff(places[i], places[other]); });
	if (!has_jump)
		return is_sound;

	double last = NAN;
	std::vector<std::size_t> next;
	for (std::size_t first = 0; first < places.size(); ++first)
	{
		if (is_done[first] || !std::isfinite(places[first]))
			continue;
		if (std::isfinite(last)) // behind missing ones
			places[first] = nearTo(last, places[first]);
		is_done[first] = true;
		next.assign(1, first);
		for (std::size_t n = 0; n < next.size(); ++n)
			forEachBeside(next[n], width, places.size(),
			              [&](std::size_t other)
			              {
				              if (is_done[other] || !std::isfinite(places[other]))
					              return;
				              places[other] = nearTo(places[next[n]], places[other]);
				              is_done[other] = true;
				              next.push_back(other);
			              });
		last = places[first];
	}
	for (std::size_t i = 0; i < places.size(); ++i)
		forEachBeside(i, width, places.size(),
		              [&](std::size_t other)
		              {
			              if (isHalfTurnOff(places[i], places[other]))
				              is_sound[i] = is_sound[other] = false;
		              });
	return is_sound;
}

} // namespace vp::reader::volumes
