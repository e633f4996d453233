#pragma once

#include "request.h"

#include <optional>
#include <vector>

class ManifestWriter;
class vtkAlgorithm;

// Finite times, ascending and each once.
std::vector<double> inOrder(std::vector<double> times);

// The one of ascending times that is asked for. Throws a Refusal for an index past the last.
double chooseTime(const std::vector<double>& times, const Request& request);

// The same for any times; none if there are none. Throws a Refusal for an index then.
std::optional<double> chooseIfAny(const std::vector<double>& times, const Request& request);

// Updates a reader at the time asked for, and offers all of its times. Returns the chosen one, if it has any. Throws a
// Refusal if the reader complained.
std::optional<double> updateAtTime(vtkAlgorithm& reader, const Request& request, ManifestWriter& manifest);
