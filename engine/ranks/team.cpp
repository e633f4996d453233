#include "ranks/team.h"

#include <algorithm>
#include <utility>

namespace vp::ranks
{

void Team::reduce(Bytes& own, const std::function<void(Bytes& into, const Bytes& other)>& add)
{
	for (int step = 1; step < size(); step *= 2)
	{
		if (rank() % (2 * step) != 0)
			return send(rank() - step, own);
		if (rank() + step < size())
			add(own, receive(rank() + step));
	}
}

void Team::broadcast(Bytes& bytes)
{
	int step = 1;
	while (step < size())
		step *= 2;
	for (step /= 2; step > 0; step /= 2)
	{
		if (rank() % (2 * step) == 0 && rank() + step < size())
			send(rank() + step, bytes);
		else if (rank() % (2 * step) == step)
			bytes = receive(rank() - step);
	}
}

std::vector<Bytes> Team::gatherAll(const Bytes& own)
{
	// Along the tree ranks come together in their order.
	MessageWriter message;
	message.putAll(own);
	Bytes all = message.take();
	reduce(all, [](Bytes& into, const Bytes& other) { into.insert(into.end(), other.begin(), other.end()); });
	broadcast(all);
	std::vector<Bytes> of_rank;
	for (MessageReader reader(all); !reader.atEnd();)
		of_rank.push_back(reader.getAll<std::byte>());
	return of_rank;
}

std::vector<Bytes> Team::exchange(std::vector<Bytes> to)
{
	const int ranks = size();
	std::vector<Bytes> from(to.size());
	from[static_cast<std::size_t>(rank())] = std::move(to[static_cast<std::size_t>(rank())]);
	for (int step = 1; step < ranks; ++step)
	{
		const int next = (rank() + step) % ranks;
		const int before = (rank() + ranks - step) % ranks;
		from[static_cast<std::size_t>(before)] = sendReceive(next, to[static_cast<std::size_t>(next)], before);
	}
	return from;
}

std::vector<Bytes> Team::exchange(std::vector<Bytes> to, std::span<const int> with)
{
	const int ranks = size();
	std::vector<Bytes> from(to.size());
	from[static_cast<std::size_t>(rank())] = std::move(to[static_cast<std::size_t>(rank())]);
	const auto isNamed = [&](int other) { return std::ranges::binary_search(with, other); };
	for (int step = 1; step < ranks; ++step)
	{
		const int next = (rank() + step) % ranks;
		const int before = (rank() + ranks - step) % ranks;
		const bool sends = isNamed(next);
		const bool receives = isNamed(before);
		if (!sends && !receives)
			continue;
		Bytes came = sendReceive(sends ? next : -1, to[static_cast<std::size_t>(next)], receives ? before : -1);
		from[static_cast<std::size_t>(before)] = std::move(came);
	}
	return from;
}

bool anyOf(Team& team, bool own)
{
	sumOverAll(team, own, [](bool& sum, bool other) { sum = sum || other; });
	return own;
}

} // namespace vp::ranks
