#include "arrays.h"
#include "bindings.h"
#include "work.h"
#include "wrap.h"

#include <vprobe/dataset.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <vector>

namespace binding
{

namespace
{

using vprobe::Cut;
using vprobe::Dataset;
using vprobe::View;

// Makes a call that takes no time, but may have to wait for another call on the data set.
template <class Work>
auto ask(Work work)
{
	return run([work = std::move(work)](std::stop_token) mutable
	           { return vprobe::Result<std::invoke_result_t<Work&>>(work()); });
}

vprobe::Classify classifyOf(const std::string& word)
{
	if (word == "auto")
		return vprobe::Classify::automatic;
	if (word == "gpu")
		return vprobe::Classify::gpu;
	if (word == "cpu")
		return vprobe::Classify::cpu;
	raise({vprobe::ErrorKind::usage, "`classify` " + word + ": takes auto, gpu or cpu"});
}

Dataset openFiles(std::vector<std::string> files, std::string time, std::string solution, double refine,
                  std::optional<double> displace, std::string displace_by, std::string format, std::string inputs,
                  const std::string& classify, std::string device, bool cell_to_point, std::vector<std::string> follow,
                  int level, const py::object& progress)
{
	vprobe::OpenOptions options{.time = std::move(time),
	                            .solution = std::move(solution),
	                            .refine = refine,
	                            .displace = displace,
	                            .displace_by = std::move(displace_by),
	                            .format = std::move(format),
	                            .classify = classifyOf(classify),
	                            .device = std::move(device),
	                            .stop = {},
	                            .inputs = std::move(inputs),
	                            .cell_to_point = cell_to_point,
	                            .follow = std::move(follow),
	                            .level = level,
	                            .keeps_parts = true};
	return run(
	    [files = std::move(files), options = std::move(options)](std::stop_token stop) mutable
	    {
		    options.stop = std::move(stop);
		    return Dataset::open(files, options);
	    },
	    progress);
}

Dataset wrapBlocks(const py::list& blocks, const std::string& classify, std::string device)
{
	return run(
	    [given = blocksOf(blocks), way = classifyOf(classify), device = std::move(device)](std::stop_token stop) mutable
	    { return Dataset::wrap(std::move(given), way, device, std::move(stop)); });
}

py::list arraysOfData(const Dataset& data)
{
	py::list arrays;
	for (const vprobe::ArrayInfo& array : ask([data] { return data.arrays(); }))
		arrays.append(py::make_tuple(array.name, array.association == vprobe::Association::point ? "point" : "cell",
		                             array.components, dtypeOf(array.type), array.units));
	return arrays;
}

py::dict memoryOf(const Dataset& data)
{
	using namespace py::literals;
	const vprobe::MemoryUse use = ask([data] { return data.memory(); });
	return py::dict("geometry"_a = use.geometry, "arrays"_a = use.arrays, "built"_a = use.built,
	                "cutter"_a = use.cutter, "device"_a = use.device, "copied"_a = use.copied);
}

// Numbers that live as long as the array.
py::array sharedArray(const vprobe::Numbers& numbers, std::vector<py::ssize_t> shape)
{
	const py::capsule owner(new std::shared_ptr<const void>(numbers.owner),
	                        [](void* kept) { delete static_cast<std::shared_ptr<const void>*>(kept); });
	return viewOf(numbers.type, std::move(shape), numbers.data, owner);
}

py::array sharedTuples(const vprobe::Numbers& numbers, int components)
{
	const auto tuples = static_cast<py::ssize_t>(numbers.size) / components;
	return components == 1 ? sharedArray(numbers, {tuples}) : sharedArray(numbers, {tuples, components});
}

// (name, coordinates, connectivity or None, {"point:NAME" or "cell:NAME": values}, points, cells)
py::tuple blockOf(const Dataset& data, std::size_t index)
{
	if (index >= ask([data] { return data.blockCount(); }))
		throw py::index_error();
	run([data](std::stop_token stop) { return data.readAll(std::move(stop)); });
	const vprobe::HeldBlock block = ask([data, index] { return data.block(index); });
	py::list coordinates;
	for (const vprobe::Numbers& each : block.coordinates)
		coordinates.append(sharedTuples(each, block.coordinates.size() == 3 ? 1 : 3));
	py::dict fields;
	for (const vprobe::Field& field : block.fields)
		fields[py::str((field.association == vprobe::Association::point ? "point:" : "cell:") + field.name)] =
		    sharedTuples(field.values, field.components);
	const bool has_cells = block.connectivity.data != nullptr;
	return py::make_tuple(block.name, coordinates,
	                      has_cells ? py::object(sharedTuples(block.connectivity, 1)) : py::none(), fields,
	                      block.points, block.cells);
}

py::list planOf(const Dataset& data, const View& view)
{
	py::list rows;
	for (const vprobe::PlanRow& row : run([data, view](std::stop_token) { return data.plan(view); }))
		rows.append(py::make_tuple(row.sheet, row.block, row.strategy, row.classifier, row.reason));
	return rows;
}

// An array of its own.
template <class T>
py::array_t<T> arrayOf(const std::vector<T>& values)
{
	return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::tuple sampleAt(const Dataset& data, const py::array_t<double, py::array::c_style | py::array::forcecast>& points,
                   std::vector<std::string> names)
{
	std::vector<vprobe::Vector3> places(static_cast<std::size_t>(points.shape(0)));
	std::copy_n(points.data(), points.size(), places.empty() ? nullptr : places[0].data());
	const vprobe::Samples samples =
	    run([data, places = std::move(places), names = std::move(names)](std::stop_token stop)
	        { return data.sample(places, names, std::move(stop)); });
	py::list columns;
	for (const vprobe::Samples::Column& column : samples.columns)
		columns.append(py::make_tuple(column.array.name, column.array.components, arrayOf(column.values)));
	return py::make_tuple(arrayOf(samples.cells), arrayOf(samples.blocks), columns);
}

py::array pixelsOf(const vprobe::Image& image)
{
	if (image.rgba.empty())
		return py::array_t<std::uint8_t>(std::vector<py::ssize_t>{0, 0, 4});
	return py::array_t<std::uint8_t>(
	    {static_cast<py::ssize_t>(image.height), static_cast<py::ssize_t>(image.width), py::ssize_t(4)},
	    image.rgba.data());
}

vprobe::Image imageOf(const py::array_t<std::uint8_t, py::array::c_style>& pixels)
{
	return {static_cast<std::uint32_t>(pixels.shape(1)), static_cast<std::uint32_t>(pixels.shape(0)),
	        std::vector<std::uint8_t>(pixels.data(), pixels.data() + pixels.size())};
}

py::array render(const Dataset& data, const View& view, const Cut* cut, const py::object& progress)
{
	const bool has_cut = cut != nullptr;
	return pixelsOf(run([data, view, has_cut, kept = has_cut ? *cut : Cut()](std::stop_token stop)
	                    { return has_cut ? data.render(kept, view, stop) : data.render(view, stop); },
	                    progress));
}

py::tuple frameOf(const Dataset& data, const View& view, int index, bool draws, const py::object& progress)
{
	const vprobe::SweepFrame frame = run([data, view, index, draws](std::stop_token stop)
	                                     { return data.frame(view, index, draws, std::move(stop)); },
	                                     progress);
	return py::make_tuple(frame.count, frame.time, frame.cut, pixelsOf(frame.image));
}

} // namespace

void addDataset(py::module_& module)
{
	using namespace py::literals;
	py::class_<Dataset>(module, "Dataset")
	    .def_static("open", openFiles, "files"_a, "time"_a, "solution"_a, "refine"_a, "displace"_a, "displace_by"_a,
	                "format"_a, "inputs"_a, "classify"_a, "device"_a, "cell_to_point"_a, "follow"_a, "level"_a,
	                "progress"_a)
	    .def_static("wrap", wrapBlocks, "blocks"_a, "classify"_a, "device"_a)
	    .def_property_readonly("kind", [](const Dataset& data) { return ask([data] { return data.kind(); }); })
	    .def_property_readonly("cell_count",
	                           [](const Dataset& data) { return ask([data] { return data.cellCount(); }); })
	    .def_property_readonly("point_count",
	                           [](const Dataset& data) { return ask([data] { return data.pointCount(); }); })
	    .def_property_readonly("block_count",
	                           [](const Dataset& data) { return ask([data] { return data.blockCount(); }); })
	    .def_property_readonly("bounds", [](const Dataset& data) { return ask([data] { return data.bounds(); }); })
	    .def_property_readonly("times", [](const Dataset& data) { return ask([data] { return data.times(); }); })
	    .def("arrays", arraysOfData)
	    .def("block", blockOf)
	    .def("memory", memoryOf)
	    .def("modified", [](const Dataset& data)
	         { ask([own = Dataset(data)]() mutable { return own.modified(), vprobe::Nothing(); }); })
	    .def("set_fields",
	         [](const Dataset& data, const py::list& blocks)
	         {
		         std::vector<std::vector<vprobe::Field>> fields;
		         for (const py::handle& each : blocks)
			         fields.push_back(fieldsOf(each.cast<py::list>()));
		         run([data, fields = std::move(fields)](std::stop_token) mutable
		             { return Dataset(data).setFields(std::move(fields)); });
	         })
	    .def("set_array",
	         [](const Dataset& data, const py::list& fields)
	         {
		         run([data, fields = fieldsOf(fields)](std::stop_token) mutable
		             { return Dataset(data).setArray(std::move(fields)); });
	         })
	    .def(
	        "cut",
	        [](const Dataset& data, const View& view, const py::object& progress)
	        { return run([data, view](std::stop_token stop) { return data.cut(view, std::move(stop)); }, progress); },
	        "view"_a, "progress"_a = py::none())
	    .def("plan", planOf)
	    .def("probe_text", [](const Dataset& data, const View& view)
	         { return run([data, view](std::stop_token) { return data.probeText(view); }); })
	    .def("sample", sampleAt)
	    .def("render", render, "view"_a, "cut"_a = nullptr, "progress"_a = py::none())
	    .def("frame", frameOf, "view"_a, "index"_a, "draws"_a, "progress"_a = py::none());
	module.def("png", [](const py::array_t<std::uint8_t, py::array::c_style>& pixels)
	           { return py::bytes(run([image = imageOf(pixels)](std::stop_token) { return image.png(); })); });
	module.def("difference",
	           [](const py::array_t<std::uint8_t, py::array::c_style>& pixels, const std::string& expected)
	           {
		           const vprobe::ImageDifference difference = run([image = imageOf(pixels), expected](std::stop_token)
		                                                          { return image.differenceFrom(expected); });
		           return py::make_tuple(difference.similarity, difference.mean, difference.text);
	           });
	module.def("save_difference",
	           [](const py::array_t<std::uint8_t, py::array::c_style>& pixels, const std::string& expected,
	              const std::string& file)
	           {
		           run([image = imageOf(pixels), expected, file](std::stop_token)
		               { return image.saveDifferenceFrom(expected, file); });
	           });
	module.def("save_png", [](const py::array_t<std::uint8_t, py::array::c_style>& pixels, const std::string& file)
	           { run([image = imageOf(pixels), file](std::stop_token) { return image.save(file); }); });
}

} // namespace binding
