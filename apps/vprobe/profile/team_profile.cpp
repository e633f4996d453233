#include "profile/team_profile.h"

#include "profile/spread.h"
#include "ranks/write/joined_stats.h"

namespace vp::app
{

namespace
{

using nlohmann::json;

// Adds every number of `other` to that of the same key in `sum`.
void addNumbers(json& sum, const json& other)
{
	for (auto& [key, value] : sum.items())
		if (value.is_object())
			addNumbers(value, other[key]);
		else
			value = value.get<std::size_t>() + other[key].get<std::size_t>();
}

json rankJson(const Profile& own, const json& document)
{
	json rank = ranks::resourcesOf(own.session.ranks(), own.session.blocks());
	for (const char* key : {"cut_ms", "frame_ms", "setup_ms", "cut_cells_mean", "stages", "memory_bytes"})
		rank[key] = document[key];
	return rank;
}

} // namespace

nlohmann::json profileOfTeam(const Profile& own)
{
	if (!own.session.ranks().team())
		return profileJson(own);
	ranks::MessageWriter message;
	message.put(rankJson(own, profileJson(own)).dump(-1, ' ', false, json::error_handler_t::replace));
	own.log.put(message);
	ProfileLog log;
	json ranks = json::array();
	json memory;
	for (const ranks::Bytes& bytes : own.session.ranks().team()->gatherAll(message.take()))
	{
		ranks::MessageReader reader(bytes);
		json rank = json::parse(reader.getText());
		if (ranks.empty())
		{
			log = own.log;
			memory = rank["memory_bytes"];
		}
		else
		{
			log.include(reader);
			addNumbers(memory, rank["memory_bytes"]);
		}
		ranks.push_back(std::move(rank));
	}
	json whole = profileJson({own.session, log, own.path, own.picture});
	whole["memory_bytes"] = std::move(memory);
	whole["ranks"] = std::move(ranks);
	return whole;
}

} // namespace vp::app
