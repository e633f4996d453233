#include "ranks/joined_across.h"

#include "base/union_find.h"

#include <algorithm>

namespace vp::ranks
{

JoinedAcross joinOverRanks(Team& team, std::span<const std::uint8_t> own, std::vector<Link> links)
{
	std::ranges::sort(links);
	links.erase(std::unique(links.begin(), links.end()), links.end());
	MessageWriter message;
	message.putAll(own);
	message.putAll(links);
	std::vector<std::size_t> first; // number of the first thing of each rank
	std::vector<std::uint8_t> marks;
	std::vector<Link> of_all;
	for (const Bytes& bytes : team.gatherAll(message.take()))
	{
		MessageReader reader(bytes);
		first.push_back(marks.size());
		const auto some_marks = reader.getAll<std::uint8_t>();
		marks.insert(marks.end(), some_marks.begin(), some_marks.end());
		const auto some = reader.getAll<Link>();
		of_all.insert(of_all.end(), some.begin(), some.end());
	}
	const auto numberOf = [&](int rank, std::uint32_t number)
	{ return static_cast<std::uint32_t>(first[static_cast<std::size_t>(rank)] + number); };
	UnionFind joined(marks.size());
	for (const Link& link : of_all)
		joined.join(numberOf(link.rank, link.number), numberOf(link.other, link.other_number));
	for (std::uint32_t i = 0; i < marks.size(); ++i)
		marks[joined.root(i)] |= marks[i];
	JoinedAcross together{joined.count(), {}};
	for (std::uint32_t i = 0; i < own.size(); ++i)
		together.marks.push_back(marks[joined.root(numberOf(team.rank(), i))]);
	return together;
}

} // namespace vp::ranks
