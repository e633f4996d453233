#pragma once

#include "gmsh_section.h"

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace vp::reader::meshes
{

// Holds the facts that version 4 gives about the entities that elements belong to.
struct GmshEntities
{
	using Tag = GmshSection::Tag;
	struct Entity
	{
		std::vector<std::int32_t> groups;  // physical ones
		std::pair<Tag, Tag> parent{-1, 0}; // dimension and tag, of a part of a partitioned entity
		std::int32_t partition = 0;        // the first one; 0 for none
	};
	std::map<std::pair<Tag, Tag>, Entity> of; // by dimension and tag
	std::set<Tag> ghosts;                     // tags of entities whose elements other partitions own

	// The entity itself, or that of which it is a part.
	Tag wholeOf(Tag dimension, Tag tag) const;
	// Its physical groups, or those of its parent.
	std::vector<std::int32_t> groupsOf(Tag dimension, Tag tag) const;
	std::int32_t partitionOf(Tag dimension, Tag tag) const;
};

// Reads $Entities or $PartitionedEntities of version 4.0 or 4.1.
void readGmshEntities(GmshSection& section, bool is_41, bool is_partitioned, GmshEntities& entities);

} // namespace vp::reader::meshes
