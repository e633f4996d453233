#include "arrays.h"
#include "bindings.h"
#include "work.h"
#include "wrap.h"

#include <vprobe/cut.h>

#include <pybind11/stl.h>

#include <string>

namespace binding
{

namespace
{

using vprobe::Cut;
using vprobe::Mesh;
using vprobe::NumberType;

// A sheet's or a contour's number, or IndexError.
std::size_t within(std::size_t number, std::size_t count)
{
	if (number >= count)
		throw py::index_error();
	return number;
}

template <class T>
py::array whole(std::span<const T> numbers, const py::object& owner)
{
	return viewOf(vprobe::numberTypeOf<T>(), {static_cast<py::ssize_t>(numbers.size())}, numbers.data(), owner);
}

// The spans of a mesh as arrays that keep it alive. The first of them may interpolate every array.
template <class T>
py::array spanOf(const py::object& self, std::span<const T> (Mesh::*span)() const)
{
	const auto& mesh = self.cast<const Mesh&>();
	return whole(runBriefly([&] { return (mesh.*span)(); }), self);
}

py::list arraysOfMesh(const py::object& self)
{
	const auto& mesh = self.cast<const Mesh&>();
	py::list arrays;
	for (const vprobe::MeshArray& array : runBriefly([&] { return mesh.arrays(); }))
	{
		std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(array.tuples)};
		if (array.components > 1)
			shape.push_back(array.components);
		arrays.append(py::make_tuple(array.name, array.association == vprobe::Association::point ? "point" : "cell",
		                             viewOf(array.type, shape, array.data, self)));
	}
	return arrays;
}

void addMesh(py::module_& module)
{
	py::class_<Mesh>(module, "Mesh")
	    .def_property_readonly("point_count", &Mesh::pointCount)
	    .def_property_readonly("polygon_count", &Mesh::polygonCount)
	    .def("points",
	         [](const py::object& self)
	         {
		         const auto points = self.cast<const Mesh&>().points();
		         return viewOf(NumberType::float64, {static_cast<py::ssize_t>(points.size() / 3), py::ssize_t(3)},
		                       points.data(), self);
	         })
	    .def("offsets", [](const py::object& self) { return spanOf(self, &Mesh::offsets); })
	    .def("connectivity", [](const py::object& self) { return spanOf(self, &Mesh::connectivity); })
	    .def("cells", [](const py::object& self) { return spanOf(self, &Mesh::cells); })
	    .def("blocks", [](const py::object& self) { return spanOf(self, &Mesh::blocks); })
	    .def("arrays", arraysOfMesh);
}

// Of a vector that becomes the array's own.
template <class T>
py::array given(std::vector<T> values, std::vector<py::ssize_t> shape)
{
	auto* kept = new std::vector<T>(std::move(values));
	const py::capsule owner(kept, [](void* data) { delete static_cast<std::vector<T>*>(data); });
	return viewOf(vprobe::numberTypeOf<T>(), std::move(shape), kept->data(), owner);
}

py::tuple tracesOf(const Cut& cut, std::size_t sheet)
{
	vprobe::Traces traces = runBriefly([&] { return cut.traces(sheet); });
	const auto points = static_cast<py::ssize_t>(traces.times.size());
	const auto offsets = static_cast<py::ssize_t>(traces.offsets.size());
	return py::make_tuple(given(std::move(traces.offsets), {offsets}), given(std::move(traces.points), {points, 3}),
	                      given(std::move(traces.times), {points}));
}

py::dict figuresOf(const vprobe::Figures& figures)
{
	using namespace py::literals;
	return py::dict("area"_a = figures.area, "boundary_area"_a = figures.boundary_area,
	                "boundary_mean"_a = figures.boundary_mean, "boundary_flux"_a = figures.boundary_flux,
	                "nan_area"_a = figures.nan_area, "mean"_a = figures.mean, "min"_a = figures.min,
	                "max"_a = figures.max, "flux"_a = figures.flux, "components"_a = figures.components,
	                "cut_cells"_a = figures.cut_cells);
}

Cut withOwn(const Cut& cut, std::size_t sheet, const vprobe::View& view, const py::dict& polygons)
{
	within(sheet, cut.sheetCount());
	const auto numbers = [&](const char* name) { return numbersOf(polygons[name], name); };
	const vprobe::OwnPolygons own{numbers("points"), numbers("offsets"), numbers("connectivity"),
	                              numbers("cells"),  numbers("blocks"),  fieldsOf(polygons["fields"])};
	return run([cut, sheet, view, own](std::stop_token) { return cut.withOwn(sheet, view, own); });
}

} // namespace

void addCut(py::module_& module)
{
	addMesh(module);
	py::class_<Cut>(module, "Cut")
	    .def_property_readonly("sheet_count", &Cut::sheetCount)
	    .def_property_readonly("contour_count", &Cut::contourCount)
	    .def("mesh", [](const Cut& cut, std::size_t sheet) { return cut.mesh(within(sheet, cut.sheetCount())); })
	    .def("figures",
	         [](const Cut& cut, std::size_t sheet)
	         {
		         within(sheet, cut.sheetCount());
		         return figuresOf(runBriefly([&] { return cut.figures(sheet); }));
	         })
	    .def("origin", [](const Cut& cut, std::size_t sheet) { return cut.origin(within(sheet, cut.sheetCount())); })
	    .def("normal", [](const Cut& cut, std::size_t sheet) { return cut.normal(within(sheet, cut.sheetCount())); })
	    .def("traces", [](const Cut& cut, std::size_t sheet) { return tracesOf(cut, within(sheet, cut.sheetCount())); })
	    .def("contour_value",
	         [](const Cut& cut, std::size_t number) { return cut.contourValue(within(number, cut.contourCount())); })
	    .def("contour",
	         [](const Cut& cut, std::size_t number) { return cut.contour(within(number, cut.contourCount())); })
	    .def("with_own", withOwn)
	    .def("save", [](const Cut& cut, const std::string& file)
	         { run([cut, file](std::stop_token) { return cut.save(file); }); });
}

} // namespace binding
