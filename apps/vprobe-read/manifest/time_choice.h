#pragma once

#include "vprobe-read/base/request.h"

#include <optional>
#include <vector>

class ManifestWriter;
class vtkAlgorithm;

// Finite times, ascending and each once.
std::vector<double> inOrder(std::vector<double> times);

// Steps of a file whose times may descend, be unsorted or equal.
struct StepsInTime
{
	std::vector<double> times;      // ascending, one for each step
	std::vector<std::size_t> steps; // of the file, in the same order
};
// Numbers the steps where a time is no number, and tells so.
StepsInTime stepsInTime(const std::vector<double>& times, ManifestWriter& manifest);

// Chooses among the times of a file's steps, in whatever order they are, and offers them. Returns the step in the order
// of the file; none if there are no times.
std::optional<std::size_t> offerSteps(const std::vector<double>& times, const Request& request,
                                      ManifestWriter& manifest);

// Times of several lists that belong together: each as often as in the list that has it most often.
std::vector<double> unitedTimes(const std::vector<std::vector<double>>& lists);

// A time, and how many equal ones come before it in a list.
struct TimeInList
{
	double time = 0.0;
	std::size_t repeat = 0;

	// The place in a list: where it has the time less often, the last one. None where it is not there.
	std::optional<std::size_t> placeIn(const std::vector<double>& list) const;
};
// Chooses among united times; none if there are none.
std::optional<TimeInList> chooseInLists(const std::vector<double>& united, const Request& request);

// Which of ascending times is asked for; of equal ones the first, or the last where that is asked for. Throws a Refusal
// for an index past the last.
std::size_t chooseStep(const std::vector<double>& times, const Request& request);
// That time.
double chooseTime(const std::vector<double>& times, const Request& request);

// The same for any times; none if there are none. Throws a Refusal for an index then.
std::optional<double> chooseIfAny(const std::vector<double>& times, const Request& request);

// Updates a reader at the time asked for, and offers all of its times. Returns the chosen one, if it has any. Throws a
// Refusal if the reader complained.
std::optional<double> updateAtTime(vtkAlgorithm& reader, const Request& request, ManifestWriter& manifest);
