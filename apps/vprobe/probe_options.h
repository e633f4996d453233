#pragma once

#include "probe/probe_file.h"
#include "vector_options.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace vp::app
{

// INPUT... and the PROBE options, as they stand on the command line.
struct ProbeOptions
{
	std::vector<std::string> inputs;
	std::string probe = "single"; // or another built-in one, or a .json file; empty: own_probe
	std::optional<probe::ProbeFile> own_probe{};
	std::vector<double> origin;         // three numbers, or none: the center of the bounds
	std::optional<std::string> normal;  // x, y, z or three numbers
	std::vector<double> up;             // three numbers, or none
	std::vector<double> window;         // none, or width and height
	std::optional<std::string> surface; // in place of planes, see surface_options.h
	bool crinkle = false;               // the cells that are cut, whole
	bool reads_patches = false;         // no option: another one needs them
	bool may_scan = false;              // no option: the first cut may do without neighbors, see needsNeighbors()
	bool reads_all_arrays = true;       // no option: not only those that are shown
	bool reads_again = true;            // no option: the inputs may be read at other times
	std::optional<int> vanes;
	std::vector<double> offsets;
	std::optional<int> sheets;
	std::optional<std::string> corners; // keep where none is given
	std::string array;
	std::string component;
	std::vector<double> threshold; // none, or LO and HI
	std::string time = "last";
	std::string solution;
	int refine = 0;
	double displace = 0.0;
	std::string seeds = "auto";
	std::string outside = "nearest";
	std::string visited;  // none: cells are found the fastest way, which may need neither
	std::string strategy; // none: the plan's own choice
	bool explain = false; // the plan is wanted in place of the cut
	std::string classify = "auto";
	std::string device;
	int threads = 0;
	VectorOptions vectors; // launched from the sheets

	bool operator==(const ProbeOptions&) const = default;
};

// Adds them to a command.
CLI::Option* addInputs(CLI::App& command, ProbeOptions& options);
void addProbeOptions(CLI::App& command, ProbeOptions& options); // with the device's
void addDeviceOptions(CLI::App& command, ProbeOptions& options);
void addExplain(CLI::App& command, ProbeOptions& options); // of commands that end with a cut

} // namespace vp::app
