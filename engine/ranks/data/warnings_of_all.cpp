#include "ranks/data/warnings_of_all.h"

#include "ranks/message.h"

#include <algorithm>

namespace vp::ranks
{

std::vector<read::InputWarning> warningsOfAll(Team& team, const std::vector<read::InputWarning>& own)
{
	MessageWriter message;
	for (const read::InputWarning& warning : own)
	{
		message.put(warning.input);
		message.put(warning.warning.count);
		message.put(warning.warning.words);
		message.put(warning.warning.words_for_one);
	}
	std::vector<read::InputWarning> all;
	for (const Bytes& of_rank : team.gatherAll(message.take()))
		for (MessageReader reader(of_rank); !reader.atEnd();)
		{
			read::InputWarning next;
			next.input = reader.getText();
			next.warning.count = reader.get<std::uint64_t>();
			next.warning.words = reader.getText();
			next.warning.words_for_one = reader.getText();
			const auto same =
			    std::ranges::find_if(all, [&](const read::InputWarning& told)
			                         { return told.input == next.input && told.warning.words == next.warning.words; });
			if (same == all.end())
				all.push_back(std::move(next));
			else
				same->warning.count += next.warning.count;
		}
	return all;
}

} // namespace vp::ranks
