#pragma once

#include "zarr_group.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vp::reader::volumes
{

// An image of OME-Zarr (NGFF), of versions 0.1 to 0.5: a group whose attributes say which arrays are its levels, and
// where they lie.
struct OmeZarr
{
	struct Axis
	{
		std::string name; // "t", "c", "z", "y", "x", or others
		std::string type; // "time", "channel", "space", or others
		std::string unit; // as the file has it; may be empty
	};
	struct Level
	{
		std::string path;
		std::vector<double> scale, translation; // along each axis
	};

	std::vector<Axis> axes;                          // those in space are the last ones: z, y, x
	std::vector<std::size_t> order;                  // for each axis which side of the arrays it is
	std::vector<Level> levels;                       // the finest first
	std::vector<std::string> channels;               // labels; mostly fewer than there are, or none
	std::optional<std::pair<double, double>> window; // shows the first channel from black to white
	bool labels = false;                             // whether its values name things
	std::size_t images = 0;                          // in the group

	// Returns the first image of a group; nothing if it has none. Throws a Refusal if it cannot be followed.
	static std::optional<OmeZarr> of(const ZarrGroup& group);

	// Puts the axes into their order. Throws a Refusal unless 2 or 3 of them are in space.
	void orderAxes();
	// Gives a coarser level whose place is not told the outer edges of the finest one: its values are means of several.
	void alignEdges(Level& level) const;

	// Returns the place of the axis with such a type; nothing if there is none.
	std::optional<std::size_t> axisOf(const std::string& type) const;
	// Returns the number of the axes in space.
	std::size_t spaceAxes() const;
};

} // namespace vp::reader::volumes
