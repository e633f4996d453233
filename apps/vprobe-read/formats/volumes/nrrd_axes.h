#pragma once

#include "grid/number_types.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <teem/nrrd.h>

namespace vp::reader::volumes
{

// The meanings of a NRRD file's axes. Axes of space have a direction, or a kind that says so, or no kind at all;
// one of kind time is time; others are components of the values.
struct NrrdAxes
{
	std::vector<unsigned> components;
	std::array<unsigned, 3> space{};
	std::optional<unsigned> time;
};

// Throws a Refusal if the values are no numbers.
grid::NumberType typeOfNrrd(int type);

// Throws a Refusal unless three axes are of space.
NrrdAxes nrrdAxes(const Nrrd& nrrd);

// Where the first sample is, and the step along each axis: from the directions in space, else from spacings and minima.
struct NrrdPlace
{
	std::array<double, 3> origin{0.0, 0.0, 0.0};
	std::array<double, 3> spacing{1.0, 1.0, 1.0};
	std::array<double, 9> direction{1, 0, 0, 0, 1, 0, 0, 0, 1}; // rows
	std::string length_units;
	std::string orientation; // as grid::parseOrientation() takes it; mostly empty
	std::string note;        // for the user; mostly empty
};
NrrdPlace nrrdPlace(const Nrrd& nrrd, const NrrdAxes& axes);

// Returns the times of the samples along the axis of time, or none if there is no such axis.
std::vector<double> nrrdTimes(const Nrrd& nrrd, const NrrdAxes& axes);
std::string nrrdTimeUnits(const Nrrd& nrrd, const NrrdAxes& axes);

// The numbers of a file whose encoding is text, as they stand there. Nothing where its data files have a pattern.
std::optional<std::string> nrrdText(const std::string& file);

} // namespace vp::reader::volumes
