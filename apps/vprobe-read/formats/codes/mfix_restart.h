#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::codes
{

// Holds the facts in a restart file of MFIX (.RES) that the files of values (.SP1 ...) need.
struct MfixRestart
{
	std::array<std::size_t, 3> cells; // with a layer of ghost cells at each side
	double start = 0.0;               // x behind the first of them
	std::array<std::vector<double>, 3> widths;
	bool is_cylindrical = false;
	std::string length_units;
	double version = 0.0;
	std::size_t phases = 0;           // phases of solids
	std::vector<std::size_t> species; // how many the gas has, and each phase of solids
	std::vector<std::int32_t> flags;  // a flag for each cell: from 10 on, a boundary or nothing
	std::size_t scalars = 0;
	std::size_t reactions = 0;
	bool has_turbulence = false;

	std::size_t cellCount() const { return cells[0] * cells[1] * cells[2]; }
};

MfixRestart parseMfixRestart(std::string_view bytes);

} // namespace vp::reader::codes
