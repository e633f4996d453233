#pragma once

#include "base/result.h"
#include "render/color/color_map.h"

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace vp::app
{

// What is launched from the sheets, as it stands on the command line.
struct VectorOptions
{
	std::string kind = "none"; // tufts, lines, ribbons, tubes
	std::string array;         // empty: the first of three components
	int lattice = 20;          // points along the longer side
	double jitter = 0.0;
	std::optional<double> steps; // else by the kind
	std::optional<double> dt;    // else from the fastest and the lattice's spacing
	std::string direction = "forward";
	std::string part = "whole";
	bool path_lines = false; // the field changes while particles go

	bool on() const { return kind != "none"; }
	// Where none are given: a tuft shows one step, what else there is follows particles a long way.
	double stepsOrDefault() const { return steps.value_or(kind == "tufts" ? 1.0 : 200.0); }
	bool operator==(const VectorOptions&) const = default;
};

// And how it is to look.
struct VectorLookOptions
{
	std::string color;           // an array, or a color; empty: the vector's length
	std::string colormap;        // empty: that of the sheets for their array, else another
	std::optional<double> width; // in the grid's units; else from the lattice's spacing
	double opacity = 1.0;

	bool operator==(const VectorLookOptions&) const = default;
};

struct VectorLook
{
	std::string color;
	std::optional<render::ColorMap> colors; // else see VectorLookOptions
	std::optional<double> width;
	double opacity = 1.0;
};

// look: null where nothing is drawn.
void addVectorOptions(CLI::App& command, VectorOptions& options, VectorLookOptions* look);

// What can be wrong on the command line is told before a large file is read.
Status checkVectorOptions(const VectorOptions& options);
Result<VectorLook> parseVectorLook(const VectorLookOptions& options);

} // namespace vp::app
