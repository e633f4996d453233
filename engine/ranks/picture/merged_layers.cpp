#include "ranks/picture/merged_layers.h"

#include "shared/slice_types.h"

#include <algorithm>
#include <span>

namespace vp::ranks
{

namespace
{

// Runs of pixels that have a value: where each begins, its pixels, and their values.
void putRuns(const render::LayerValues& layers, MessageWriter& message)
{
	MessageWriter runs;
	std::size_t count = 0;
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
		++count;
		runs.put(pixel);
		runs.putAll(
		    std::span<const float>(layers.values).subspan(pixel * layers.channels, (end - pixel) * layers.channels));
		pixel = end;
	}
	message.put(count);
	message.append(runs.take());
}

void takeRuns(MessageReader& reader, const render::LayerValues& layers)
{
	for (auto left = reader.get<std::size_t>(); left > 0; --left)
	{
		const auto pixel = reader.get<std::size_t>();
		const auto values = reader.getAll<float>();
		std::ranges::copy(values, layers.values.begin() + static_cast<std::ptrdiff_t>(pixel * layers.channels));
	}
}

bool isNearer(const render::SurfacePixel& a, const render::SurfacePixel& b)
{
	return a.depth > b.depth || (a.depth == b.depth && a.order < b.order);
}

// own: of lower ranks.
std::vector<render::SurfacePixel> nearestOf(const std::vector<render::SurfacePixel>& own,
                                            const std::vector<render::SurfacePixel>& other)
{
	std::vector<render::SurfacePixel> all;
	all.reserve(own.size() + other.size());
	auto next = own.begin();
	for (const render::SurfacePixel& fragment : other)
	{
		while (next != own.end() && next->pixel < fragment.pixel)
			all.push_back(*next++);
		if (next != own.end() && next->pixel == fragment.pixel)
		{
			all.push_back(isNearer(fragment, *next) ? fragment : *next);
			++next;
		}
		else
			all.push_back(fragment);
	}
	all.insert(all.end(), next, own.end());
	return all;
}

Bytes messageOf(const render::LayerValues& layers)
{
	MessageWriter message;
	putRuns(layers, message);
	if (layers.surfaces)
	{
		message.putAll(layers.surfaces->nearest);
		message.putAll(layers.surfaces->listed);
	}
	return message.take();
}

void take(const Bytes& bytes, const render::LayerValues& layers)
{
	MessageReader reader(bytes);
	takeRuns(reader, layers);
	if (!layers.surfaces)
		return;
	layers.surfaces->nearest = nearestOf(layers.surfaces->nearest, reader.getAll<render::SurfacePixel>());
	std::vector<render::SurfacePixel>& listed = layers.surfaces->listed;
	const auto others = reader.getAll<render::SurfacePixel>();
	listed.insert(listed.end(), others.begin(), others.end());
}

} // namespace

bool mergeLayers(Team& team, const render::LayerValues& layers, std::uint64_t& sent)
{
	for (int step = 1; step < team.size(); step *= 2)
	{
		if (team.rank() % (2 * step) != 0)
		{
			const Bytes message = messageOf(layers);
			sent += message.size();
			team.send(team.rank() - step, message);
			return false;
		}
		if (team.rank() + step < team.size())
			take(team.receive(team.rank() + step), layers);
	}
	return true;
}

Result<render::Picture> draw(const Ranks& ranks, render::Renderer& renderer, const render::Scene& scene,
                             Timeline* timeline, const std::function<bool()>& goes_on)
{
	if (!ranks.team())
		return renderer.draw(scene, timeline, goes_on);
	const auto merge = [&](const render::LayerValues& layers)
	{ return mergeLayers(*ranks.team(), layers, ranks.sentBytes()); };
	auto drawn = renderer.drawMerged(scene, merge, timeline);
	if (!drawn)
		return drawn.error();
	return drawn->value_or(render::Picture());
}

std::optional<mesh::UvBounds> boundsOfAll(const Ranks& ranks, const std::optional<mesh::UvBounds>& own)
{
	if (!ranks.team())
		return std::nullopt;
	const mesh::UvBounds all =
	    ranks.sum(own.value_or(mesh::UvBounds()), [](auto& sum, const auto& other) { sum = sum.with(other); });
	return all.lo.x <= all.hi.x ? std::optional(all) : std::nullopt;
}

} // namespace vp::ranks
