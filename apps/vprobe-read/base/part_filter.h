#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <set>
#include <string_view>

namespace vp::reader
{

// Layers of cells of a lattice along its last axis, from `begin` to before `end`.
struct CellLayers
{
	std::size_t begin = 0;
	std::size_t end = 0;

	std::size_t count() const { return end - begin; }
};

// Says which parts of a file are handed over. A part is a piece, a block, or anything that can be cut on its own. Parts
// are numbered in the order of the file, and a number does not depend on which parts are asked for.
class PartFilter
{
public:
	enum class Mode
	{
		all,
		list,  // none; the parts are only counted
		chosen // those that are asked for
	};

	PartFilter() = default;
	// text: empty for all, "?" for a list, or numbers with commas between. "/" and a number may follow: a lattice that
	// is alone in its file is split into so many slabs.
	explicit PartFilter(std::string_view text);

	bool filters() const { return mode_ != Mode::all; }
	bool lists() const { return mode_ == Mode::list; }
	// Begins the next part, which has about so many cells. Returns false if it is not asked for. A part within a part
	// belongs to the outer one.
	bool begin(std::size_t cells);
	// Begins the next lattice that is alone in its file, with so many layers of so many cells each, or a pack, whose
	// runs of cells count as layers. Its slabs are the
	// parts of one block with these facts (see beginBlock()). Returns the layers that are asked for, which are
	// adjacent, or nothing.
	std::optional<CellLayers> beginLattice(nlohmann::json facts, std::size_t layers, std::size_t cells_of_layer);
	// Returns true if such a lattice is split here.
	bool splits() const { return filters() && !isInside() && !in_block_ && slabs_ > 1; }
	// From here to endBlock(), parts belong to one block, which is cut as a whole if all its parts are in one process.
	// facts: properties of the whole block, such as its kind and its points; or null.
	void beginBlock(nlohmann::json facts);
	void endBlock() { in_block_ = false; }
	// Everything between enter() and leave() belongs to the part that was begun last.
	void enter() { ++depth_; }
	void leave() { --depth_; }
	bool isInside() const { return depth_ > 0; }

	// Returns the number of the part that was begun last, or of the first part of a slab.
	std::size_t number() const { return number_; }
	// Return {"cells", "block"} for each part, and the facts of blocks by their numbers.
	nlohmann::json parts() const { return parts_; }
	nlohmann::json blocks() const { return blocks_; }

private:
	Mode mode_ = Mode::all;
	std::size_t slabs_ = 1;
	std::size_t number_ = 0;
	std::set<std::size_t> chosen_;
	nlohmann::json parts_ = nlohmann::json::array();
	nlohmann::json blocks_ = nlohmann::json::array();
	bool in_block_ = false;
	int depth_ = 0;
};

// As long as an object of this class exists, everything that is added belongs to the part that was begun last.
class InsidePart
{
public:
	explicit InsidePart(PartFilter& filter) : filter_(filter) { filter_.enter(); }
	~InsidePart() { filter_.leave(); }
	InsidePart(const InsidePart&) = delete;
	InsidePart& operator=(const InsidePart&) = delete;

private:
	PartFilter& filter_;
};

} // namespace vp::reader
