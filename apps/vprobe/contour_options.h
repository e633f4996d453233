#pragma once

#include "base/result.h"

#include <vector>

namespace CLI
{
class App;
}

namespace vp::app
{

struct ProbeOptions;

// The contours that grow from the sheets, as they stand on the command line.
struct ContourOptions
{
	std::vector<double> values; // of every sheet
	std::vector<double> at;     // none, or U and V on the first sheet, whose value there is taken
	double depth = 0.0;         // of the box, in the grid's units; 0: it follows from the window
	double opacity = 1.0;       // 0 to 1

	bool isGiven() const { return !values.empty() || !at.empty(); }
	bool operator==(const ContourOptions&) const = default;
};

void addContourOptions(CLI::App& command, ContourOptions& options);

// Tells, before any input is read, what cannot be: a usage error.
Status checkContours(const ContourOptions& options, const ProbeOptions& probe);

} // namespace vp::app
