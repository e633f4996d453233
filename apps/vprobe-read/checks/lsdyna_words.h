#pragma once

#include "vprobe-read/base/bytes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace vp::reader::checks
{

// Reads the words of a d3plot file. They have 4 or 8 bytes, in either byte order.
class LsdynaWords
{
public:
	// Throws a Refusal unless the first of the bytes are the control words of a d3plot file.
	explicit LsdynaWords(std::string_view bytes);
	// Reads the words of another file of the same family.
	LsdynaWords(std::string_view bytes, const LsdynaWords& first);

	// Returns true if these bytes begin a d3plot file.
	static bool isHead(std::string_view bytes);

	std::size_t count() const { return bytes_.size() / width_; }
	std::size_t width() const { return width_; }
	// These return a word. They throw a Refusal behind the end.
	std::int64_t integer(std::size_t word) const;
	double real(std::size_t word) const;
	// Returns true if the word ends a part of the file.
	bool isEnd(std::size_t word) const { return word < count() && real(word) == -999999.0; }

private:
	bool hasHead() const;
	template <class Number>
	Number number(std::size_t word) const;

	std::string_view bytes_;
	std::size_t width_ = 4;
	ByteOrder order_ = ByteOrder::little;
};

// Holds the control words, which "LS-DYNA Database Binary Output Files" (LSTC) describes.
struct LsdynaControl
{
	std::int64_t dimensions, nodes, globals, has_temperature, has_places, has_velocities, has_accelerations;
	std::int64_t solids, solid_values, beams, beam_values, shells, shell_values, thick_shells, thick_values;
	std::int64_t integration, user_ids, ale_materials, solid_thermal, rigid_shells = 0;
	bool has_ten_nodes = false;

	explicit LsdynaControl(const LsdynaWords& words);

	// Return the number of words of the mesh, behind the control words, and of each state.
	std::size_t geometryWords() const;
	std::size_t stateWords() const;
	std::size_t placesAt() const { return head_words_ + material_words_ + static_cast<std::size_t>(ale_materials); }
	std::size_t solidsAt() const { return placesAt() + 3 * static_cast<std::size_t>(nodes); }
	std::size_t thickShellsAt() const { return solidsAt() + solidWords() * static_cast<std::size_t>(solids); }

	// Return the number of words of a part of a state.
	std::size_t temperatureWords() const;
	std::size_t massWords() const { return has_temperature >= 10 ? 1 : 0; }
	std::size_t nodesAt() const { return 1 + static_cast<std::size_t>(globals); }
	std::size_t nodeWords() const;
	std::size_t solidValuesAt() const;
	std::size_t thickValuesAt() const;
	// Says what the marks of deletion belong to. They follow all values, and 0 marks a deleted element or node.
	enum class Deletion
	{
		none,
		nodes,
		elements
	} deletion = Deletion::none;
	std::size_t deletionAt() const;

private:
	// A solid takes nine words. Two more would be for nodes in the middle of edges.
	std::size_t solidWords() const { return 9; }
	std::size_t elementCount() const { return static_cast<std::size_t>(solids + thick_shells + shells + beams); }

	std::size_t head_words_ = 64;
	std::size_t material_words_ = 0;
};

} // namespace vp::reader::checks
