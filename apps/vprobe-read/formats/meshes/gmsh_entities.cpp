#include "gmsh_entities.h"

#include <array>

namespace vp::reader::meshes
{

GmshEntities::Tag GmshEntities::wholeOf(Tag dimension, Tag tag) const
{
	const auto found = of.find({dimension, tag});
	return found != of.end() && found->second.parent.first == dimension ? found->second.parent.second : tag;
}

std::vector<std::int32_t> GmshEntities::groupsOf(Tag dimension, Tag tag) const
{
	const auto found = of.find({dimension, tag});
	if (found == of.end())
		return {};
	if (!found->second.groups.empty() || found->second.parent.first != dimension)
		return found->second.groups;
	const auto parent = of.find(found->second.parent);
	return parent == of.end() ? std::vector<std::int32_t>() : parent->second.groups;
}

std::int32_t GmshEntities::partitionOf(Tag dimension, Tag tag) const
{
	const auto found = of.find({dimension, tag});
	return found == of.end() ? 0 : found->second.partition;
}

void readGmshEntities(GmshSection& section, bool is_41, bool is_partitioned, GmshEntities& entities)
{
	if (is_partitioned)
	{
		section.size(); // the number of partitions
		const std::size_t ghosts = section.checked(section.size(), 4);
		for (std::size_t i = 0; i < ghosts; ++i)
		{
			entities.ghosts.insert(section.integer());
			section.integer(); // its partition
		}
	}
	std::array<std::size_t, 4> counts;
	for (std::size_t& count : counts)
		count = section.checked(section.size(), 8);
	for (std::size_t dimension = 0; dimension < 4; ++dimension)
		for (std::size_t i = 0; i < counts[dimension]; ++i)
		{
			const auto tag = section.integer();
			GmshEntities::Entity& entity = entities.of[{static_cast<GmshEntities::Tag>(dimension), tag}];
			if (is_partitioned)
			{
				entity.parent.first = section.integer();
				entity.parent.second = section.integer();
				const std::size_t partitions = section.checked(section.size(), 2);
				for (std::size_t p = 0; p < partitions; ++p)
				{
					const auto partition = static_cast<std::int32_t>(section.integer());
					if (p == 0)
						entity.partition = partition;
				}
			}
			const int places = dimension == 0 && is_41 ? 3 : 6;
			for (int p = 0; p < places; ++p)
				section.real();
			const std::size_t groups = section.checked(section.size(), 2);
			for (std::size_t g = 0; g < groups; ++g)
				entity.groups.push_back(static_cast<std::int32_t>(section.integer()));
			if (dimension == 0)
				continue;
			const std::size_t boundaries = section.checked(section.size(), 2);
			for (std::size_t b = 0; b < boundaries; ++b)
				section.integer();
		}
}

} // namespace vp::reader::meshes
