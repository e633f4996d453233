#pragma once

#include "grid/block.h"
#include "ranks/ranks.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace vp::ranks
{

/// Returns what a rank holds and has used: parts, cells, bytes of layers, memory and processor time. There must be
/// several.
nlohmann::json resourcesOf(const Ranks& ranks, const grid::BlockSet& blocks);

/// Returns the lines of a table from all ranks, with the rank's number in front of each; only the first rank gets it.
/// One process gets its own table. title: a line.
std::string tableOfAll(const Ranks& ranks, const std::string& title, const std::string& lines);

/// Puts what all ranks tell of the sheets and contours of a frame together. One process gets its own.
nlohmann::json figuresOfAll(const Ranks& ranks, nlohmann::json own);

/// Puts the documents of all ranks together, and adds "ranks": what depends on how the parts were dealt
/// out. The first rank gets the whole. One process gets its own document.
nlohmann::json documentOfAll(const Ranks& ranks, const grid::BlockSet& blocks, nlohmann::json own);

} // namespace vp::ranks
