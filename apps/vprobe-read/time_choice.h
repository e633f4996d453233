#pragma once

#include "request.h"

class ManifestWriter;
class vtkAlgorithm;

// Updates a reader at the time asked for, and offers all of its times. Throws a Refusal if the reader complained.
void updateAtTime(vtkAlgorithm& reader, const Request& request, ManifestWriter& manifest);
