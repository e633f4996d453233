#include "wrap.h"

#include "arrays.h"
#include "work.h"

#include <pybind11/stl.h>

#include <string>
#include <tuple>

namespace binding
{

namespace
{

using Points3 = std::array<std::size_t, 3>;

vprobe::Numbers take(const py::dict& block, const char* name)
{
	return block.contains(name) ? numbersOf(block[name], name) : vprobe::Numbers();
}

decltype(vprobe::Block::grid) gridOf(const py::dict& block)
{
	const auto kind = block["kind"].cast<std::string>();
	if (kind == "image")
		return vprobe::Image3{block["points"].cast<Points3>(), block["origin"].cast<vprobe::Vector3>(),
		                      block["spacing"].cast<vprobe::Vector3>()};
	if (kind == "rectilinear")
		return vprobe::Rectilinear{take(block, "x"), take(block, "y"), take(block, "z")};
	if (kind == "structured")
		return vprobe::Structured{block["points"].cast<Points3>(), take(block, "coordinates")};
	return vprobe::Unstructured{take(block, "coordinates"),
	                            take(block, "types"),
	                            take(block, "offsets"),
	                            take(block, "connectivity"),
	                            take(block, "face_offsets"),
	                            take(block, "face_stream"),
	                            block.contains("tolerance") ? block["tolerance"].cast<double>() : 0.0,
	                            block.contains("checks_ids_later")};
}

} // namespace

std::vector<vprobe::Field> fieldsOf(const py::list& fields)
{
	std::vector<vprobe::Field> made;
	for (const py::handle& each : fields)
	{
		const auto [name, place, components, array, units] =
		    each.cast<std::tuple<std::string, std::string, int, py::object, std::string>>();
		const auto association = place == "point" ? vprobe::Association::point : vprobe::Association::cell;
		made.push_back({name, association, components, numbersOf(array, "the array " + name), units});
	}
	return made;
}

std::vector<vprobe::Block> blocksOf(const py::list& blocks)
{
	std::vector<vprobe::Block> made;
	for (const py::handle& each : blocks)
	{
		const auto block = each.cast<py::dict>();
		made.push_back({gridOf(block), fieldsOf(block["fields"]), block["name"].cast<std::string>(), {}});
	}
	return made;
}

} // namespace binding
