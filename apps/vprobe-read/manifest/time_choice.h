#pragma once

#include "vprobe-read/base/request.h"

#include <optional>
#include <vector>

class vtkAlgorithm;

namespace vp::reader::manifest
{

class Writer;

// Returns the finite times, ascending and each once.
std::vector<double> inOrder(std::vector<double> times);

// Steps of a file in the order of their times. The file's times may descend, be unsorted or equal.
struct StepsInTime
{
	std::vector<double> times;      // ascending, one for each step
	std::vector<std::size_t> steps; // their numbers in the file, in the same order
};
// Sorts the steps. If a time is not a number, numbers the steps instead, and warns about it.
StepsInTime stepsInTime(const std::vector<double>& times, Writer& manifest);

// Chooses among the times of a file's steps, in whatever order they are, and offers them. Returns the step's number in
// the file, or nothing if there are no times.
std::optional<std::size_t> offerSteps(const std::vector<double>& times, const Request& request, Writer& manifest);

// Unites several lists of times. Each time occurs as often as in the list that has it most often.
std::vector<double> unitedTimes(const std::vector<std::vector<double>>& lists);

// A time, and how many equal ones come before it in a list.
struct TimeInList
{
	double time = 0.0;
	std::size_t repeat = 0;

	// Returns the place in a list. If the list has the time less often, returns its last place. Returns nothing if the
	// list does not have the time.
	std::optional<std::size_t> placeIn(const std::vector<double>& list) const;
};
// Chooses among united times. Returns nothing if there are none.
std::optional<TimeInList> chooseInLists(const std::vector<double>& united, const Request& request);

// Returns the index of the requested time among ascending times. Among equal times it is the first, or the last if the
// last time is requested. Throws a Refusal for an index past the last.
std::size_t chooseStep(const std::vector<double>& times, const Request& request);
// Returns that time.
double chooseTime(const std::vector<double>& times, const Request& request);

// Does the same for times in any order. Returns nothing if there are no times; then an index throws a Refusal.
std::optional<double> chooseIfAny(const std::vector<double>& times, const Request& request);

// Updates a reader at the time asked for, and offers all of its times. Returns the chosen one, if it has any. Throws a
// Refusal if the reader complained.
std::optional<double> updateAtTime(vtkAlgorithm& reader, const Request& request, Writer& manifest);

} // namespace vp::reader::manifest
