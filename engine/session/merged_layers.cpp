#include "session/merged_layers.h"

#include "shared/slice_types.h"

#include <algorithm>
#include <span>

namespace vp::session
{

namespace
{

// Runs of pixels that have a value: where each begins, its pixels, and their values.
Bytes runsOf(const render::LayerValues& layers)
{
	MessageWriter message;
	const std::size_t pixels = layers.values.size() / layers.channels;
	const auto isEmpty = [&](std::size_t pixel)
	{ return layers.values[pixel * layers.channels] == shared::kEmptyValue; };
	for (std::size_t pixel = 0; pixel < pixels;)
	{
		if (isEmpty(pixel))
		{
			++pixel;
			continue;
		}
		std::size_t end = pixel + 1;
		while (end < pixels && !isEmpty(end))
			++end;
		message.put(pixel);
		message.putAll(
		    std::span<const float>(layers.values).subspan(pixel * layers.channels, (end - pixel) * layers.channels));
		pixel = end;
	}
	return message.take();
}

void takeRuns(const Bytes& runs, const render::LayerValues& layers)
{
	for (MessageReader reader(runs); !reader.atEnd();)
	{
		const auto pixel = reader.get<std::size_t>();
		const auto values = reader.getAll<float>();
		std::ranges::copy(values, layers.values.begin() + static_cast<std::ptrdiff_t>(pixel * layers.channels));
	}
}

} // namespace

bool mergeLayers(Team& team, const render::LayerValues& layers, std::uint64_t& sent)
{
	for (int step = 1; step < team.size(); step *= 2)
	{
		if (team.rank() % (2 * step) != 0)
		{
			const Bytes runs = runsOf(layers);
			sent += runs.size();
			team.send(team.rank() - step, runs);
			return false;
		}
		if (team.rank() + step < team.size())
			takeRuns(team.receive(team.rank() + step), layers);
	}
	return true;
}

} // namespace vp::session
