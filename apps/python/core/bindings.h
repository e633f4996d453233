#pragma once

#include <pybind11/pybind11.h>

namespace binding
{

// Each adds some of the library's classes to the module.
void addView(pybind11::module_& module);
void addCut(pybind11::module_& module);
void addDataset(pybind11::module_& module);

} // namespace binding
