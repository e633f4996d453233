#include "bindings.h"
#include "work.h"

// The face of the library as it is. The package vprobe makes of it what users see, with its own checks and documents.
PYBIND11_MODULE(_core, module)
{
	binding::startListening(module);
	binding::addView(module);
	binding::addCut(module);
	binding::addDataset(module);
}
