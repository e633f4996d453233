#pragma once

#include "measure/sheet_lookup.h"
#include "session/frame.h"
#include "session/session.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vp::app
{

// Finds what the sheets of a cut show at a place. It holds copies of everything that it needs, so another thread than
// the session's may use it, and it may outlive the session.
class SheetLookups
{
public:
	SheetLookups(const session::Session& session, std::shared_ptr<const session::Frame> cut, bool by_generation);

	struct Found
	{
		std::string array; // name and component; empty if no array is shown
		double value;      // NaN if there is no value
		std::string block; // name of the block, or its number if it has no name; empty if there is only one
		std::size_t cell;  // number in the file
	};
	// sheet: number of the sheet in the cut. content_uv: see interact::SheetHit. Returns nothing if the grid is not cut
	// there.
	std::optional<Found> at(std::size_t sheet, const glm::dvec2& content_uv) const;

	// Counts the values that sheets show of the array that the scene shows, in as many bins as `bins` has. place:
	// returns the place of a value, 0 to 1; values elsewhere do not count.
	void count(const std::function<double(double value)>& place, std::span<std::size_t> bins) const;

	const std::shared_ptr<const session::Frame>& cut() const { return cut_; }

private:
	struct OfSheet
	{
		measure::SheetLookup lookup;
		std::string array;
		bool is_scenes; // shows the array of the scene, not one of its own
		std::vector<double> of_vertices;
		std::vector<double> of_polygons;
		std::vector<std::uint64_t> cells; // per polygon, number in the file
	};

	std::shared_ptr<const session::Frame> cut_;
	std::vector<std::optional<OfSheet>> sheets_; // empty for a sheet that is not a plane
	std::vector<std::string> blocks_;            // names
};

} // namespace vp::app
