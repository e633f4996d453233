#include "ranks/data/imaging_message.h"

#include <utility>

namespace vp::ranks
{

void putImaging(MessageWriter& to, const grid::Imaging& imaging)
{
	to.put(imaging.orientation);
	to.put(imaging.gray);
	to.put(imaging.labels);
	to.put(imaging.label_names.size());
	for (const auto& [value, name] : imaging.label_names)
	{
		to.put(value);
		to.put(name);
	}
	to.put(imaging.window.has_value());
	const auto [lo, hi] = imaging.window.value_or(std::pair{0.0, 0.0});
	to.put(lo);
	to.put(hi);
}

grid::Imaging getImaging(MessageReader& from)
{
	grid::Imaging imaging;
	imaging.orientation = from.getText();
	imaging.gray = from.get<bool>();
	imaging.labels = from.get<bool>();
	for (auto left = from.get<std::size_t>(); left > 0; --left)
	{
		const auto value = from.get<double>();
		imaging.label_names.emplace_back(value, from.getText());
	}
	const bool has_window = from.get<bool>();
	const auto lo = from.get<double>(), hi = from.get<double>();
	if (has_window)
		imaging.window = {lo, hi};
	return imaging;
}

} // namespace vp::ranks
