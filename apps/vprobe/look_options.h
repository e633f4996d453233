#pragma once

#include "base/result.h"
#include "context_options.h"
#include "contour_options.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "render/scene/scene.h"
#include "vector_options.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace vp::app
{

// The LOOK options, as they stand on the command line.
struct LookOptions
{
	std::string size = "1280x720";
	int samples = 8;
	std::string colormap = "viridis";
	std::string color_by = "array";
	std::vector<double> range; // none, or LO and HI
	std::string range_of = "data";
	bool symmetric = false;
	bool logarithmic = false;
	double opacity = 1.0;
	int lines = 0;
	int bands = 0;
	bool mesh = false;
	bool lit = false;
	std::string background = "gradient";
	std::string camera = "auto";
	std::string outline = "box";
	std::vector<std::string> context;
	std::string axes = "corner";
	bool no_legend = false;
	bool no_labels = false;
	std::string units;
	std::string length_units;
	std::optional<std::string> title; // else the input's name
	VectorLookOptions vectors;
	ContourOptions contour; // with options of their own

	bool operator==(const LookOptions&) const = default;
};

/// Whether what is drawn beside the sheets asks for the neighbors of cells: so no cut can do without them.
bool needsNeighbors(const LookOptions& options);

enum class LookScope
{
	space, // pictures in space: all options
	plane  // flat pictures of sheets: those that mean something there
};

void addLookOptions(CLI::App& command, LookOptions& options, LookScope scope = LookScope::space);

struct LookChoice
{
	render::Look look;
	render::CameraChoice camera;
	std::vector<ContextChoice> context;
	ContourOptions contour;
	double opacity = 1.0;        // of every sheet
	bool range_of_slice = false; // without a range: the colors' ends are those of what the sheets show
	bool symmetric = false;      // and lie alike about 0
	bool by_generation = false;  // colors tell when the traversal met a cell, instead of the array
	std::string units;           // of the array, told behind its name
	bool captions = true;        // where the first sheet is
	bool window_rims = true;     // lines around windows
	VectorLook vectors;
};

// What can be wrong on the command line is told before a large file is read.
Result<LookChoice> parseLook(const LookOptions& options, const std::vector<std::string>& inputs);

// The scale of an array, none without one. Options that need values are an input error where there are none that serve;
// values that a logarithm leaves out are told in a word.
Result<std::optional<render::ValueScale>> valueScale(const grid::BlockSet& blocks,
                                                     const std::optional<grid::FieldChoice>& field,
                                                     const std::vector<std::string>& inputs, const render::Look& look);

} // namespace vp::app
