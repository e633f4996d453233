#include "bindings.h"
#include "work.h"

#include <vprobe/view.h>

#include <string>

namespace binding
{

void addView(py::module_& module)
{
	using vprobe::View;
	py::class_<View>(module, "View")
	    .def(py::init<>())
	    .def(py::init<const View&>())
	    .def("set", [](View& view, const std::string& key, const std::string& value) { valueOf(view.set(key, value)); })
	    .def("read", [](View& view, const std::string& state) { valueOf(view.read(state)); })
	    .def("json", &View::json)
	    .def("check", [](const View& view) { valueOf(view.check()); });
}

} // namespace binding
