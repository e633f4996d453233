#pragma once

#include <vprobe/arrays.h>

#include <pybind11/numpy.h>

#include <cstddef>
#include <string>

namespace binding
{

namespace py = pybind11;

// Numbers that share the memory of an array and keep it alive. Throws InputError where it is no block of numbers in
// this machine's order; `what` names it.
vprobe::Numbers numbersOf(const py::handle& array, const std::string& what);

py::dtype dtypeOf(vprobe::NumberType type);

// A read-only array over memory that `owner` keeps alive.
py::array viewOf(vprobe::NumberType type, py::array::ShapeContainer shape, const void* data, const py::handle& owner);

} // namespace binding
