#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <set>
#include <string_view>

// Layers of cells of a lattice, along its last axis: from `begin` to before `end`.
struct CellLayers
{
	std::size_t begin = 0;
	std::size_t end = 0;

	std::size_t count() const { return end - begin; }
};

// Which parts of a file are handed over: pieces, blocks or whatever can be cut on its own, numbered as they come. The
// number of a part is the same whichever parts are asked for.
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
	// text: empty for all, "?" for a list, or numbers with commas between. Behind that may stand "/" and into how many
	// slabs a lattice comes apart that is alone in its file.
	explicit PartFilter(std::string_view text);

	bool filters() const { return mode_ != Mode::all; }
	bool lists() const { return mode_ == Mode::list; }
	// Goes on to the next part, of about so many cells. False where it is not asked for. A part within a part belongs
	// to it.
	bool begin(std::size_t cells);
	// Goes on to the next lattice that is alone in its file, of so many layers with so many cells each. Its slabs are
	// parts of one block, with these facts (beginBlock()). Returns the layers that are asked for, which follow each
	// other, or nothing.
	std::optional<CellLayers> beginLattice(nlohmann::json facts, std::size_t layers, std::size_t cells_of_layer);
	// Whether such a lattice comes apart here.
	bool splits() const { return filters() && !isInside() && !in_block_ && slabs_ > 1; }
	// The parts from here to end() belong to one block that is cut as a whole where all parts are in one process.
	// facts: what is known of the whole, such as its kind and its points; or null.
	void beginBlock(nlohmann::json facts);
	void endBlock() { in_block_ = false; }
	// What lies between belongs to the part begun last.
	void enter() { ++depth_; }
	void leave() { --depth_; }
	bool isInside() const { return depth_ > 0; }

	// Of the part begun last, or of the first one of a slab.
	std::size_t number() const { return number_; }
	// {"cells", "block"} for each part, and the facts of blocks by their numbers.
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

// Lets what is added belong to the part begun last, while it lives.
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
