#pragma once

#include "measure/sheet_lookup.h"
#include "session/frame.h"
#include "session/session.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// What the sheets of a cut show at a place, with copies of all it takes: it may be asked on another thread than the
// session's, and outlives that.
class SheetLookups
{
public:
	SheetLookups(const session::Session& session, std::shared_ptr<const session::Frame> cut, bool by_generation);

	struct Found
	{
		std::string array; // name and component; empty where nothing is shown
		double value;      // NaN where there is none
		std::string block; // its name, or its number where there are several
		std::size_t cell;  // as the file numbers it
	};
	// sheet: of the cut. content_uv: see interact::SheetHit. None where the grid is not cut.
	std::optional<Found> at(std::size_t sheet, const glm::dvec2& content_uv) const;

	const std::shared_ptr<const session::Frame>& cut() const { return cut_; }

private:
	struct OfSheet
	{
		measure::SheetLookup lookup;
		std::string array;
		bool nearest; // ids and categories are those of the nearest vertex
		std::vector<double> of_vertices;
		std::vector<double> of_polygons;
		std::vector<std::uint64_t> cells; // per polygon, the file's numbers
	};

	std::shared_ptr<const session::Frame> cut_;
	std::vector<std::optional<OfSheet>> sheets_; // none of what is no plane
	std::vector<std::string> blocks_;            // names
};

} // namespace vp::app
