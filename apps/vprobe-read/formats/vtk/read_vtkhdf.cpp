// VTKHDF files of one data set, and collections of several.
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vtkhdf_set.h"
#include "vtkhdf_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace vp::reader::vtk
{

namespace
{

const std::string kVtkHdf = "/VTKHDF";

// The first files of version 1.0 name no type.
std::string typeOf(const hdf5::File& file, const std::string& root)
{
	const std::string type = file.textOr(root, "Type");
	if (!type.empty())
		return type;
	return !file.realsOr(root, "WholeExtent").empty() ? "ImageData"
	       : file.isSet(root + "/Types")              ? "UnstructuredGrid"
	                                                  : "";
}

void refuseOtherKinds(const std::string& type)
{
	if (isOneOf(type, {"ImageData", "UnstructuredGrid"}))
		return;
	if (type == "PolyData")
		throw Refusal("nothing to slice: VTKHDF of type PolyData, and polygons hold no three-dimensional cells");
	const char* remedy = isOneOf(type, {"OverlappingAMR", "NonOverlappingAMR"}) ? "save it as .vthb from ParaView"
	                     : type == "HyperTreeGrid"                              ? "save it as .htg from ParaView"
	                     : type == "PartitionedDataSet"                         ? "save it as .vtm from ParaView"
	                                                    : "save image data or unstructured grids";
	throw Refusal(fmt::format("VTKHDF of type {}, which is not read; {}", type.substr(0, 40), remedy));
}

// Reads the data sets of a collection, in the order that they say. The tree of their names (Assembly) is passed over.
void readCollection(const Request& request, manifest::Writer& manifest, const hdf5::File& file)
{
	std::vector<std::pair<double, std::string>> sets; // by index
	for (const std::string& name : file.namesIn(kVtkHdf))
	{
		const std::string root = kVtkHdf + "/" + name;
		const std::string type = file.isSet(root) ? "" : typeOf(file, root);
		if (isOneOf(type, {"ImageData", "UnstructuredGrid"}))
			sets.emplace_back(file.realOr(root, "Index", 0.0), name);
		else if (!type.empty() && type != "PolyData") // which has no three-dimensional cells
			manifest.warn(fmt::format("the data set {} of type {} is left out", name, type.substr(0, 40)));
	}
	if (sets.empty())
		throw Refusal(fmt::format("nothing to slice: VTKHDF of type {} without image data and unstructured grids; save "
		                          "it as .vtm from ParaView",
		                          typeOf(file, kVtkHdf)));
	std::ranges::stable_sort(sets, {}, &std::pair<double, std::string>::first);
	const std::vector<double> times = VtkHdfStep::timesOf(file, kVtkHdf + "/" + sets[0].second);
	for (const auto& [index, name] : sets)
	{
		const std::string root = kVtkHdf + "/" + name;
		if (VtkHdfStep::timesOf(file, root) != times)
			throw Refusal(fmt::format("its data sets {} and {} have different times; save them in files of their own",
			                          sets[0].second, name));
		manifest.setPrefix(name);
		readVtkHdfSet({file, typeOf(file, root), root, "/vprobe/" + name}, request, manifest);
	}
}

} // namespace

void readHdf(const Request& request, manifest::Writer& manifest)
{
	const hdf5::File file(request.file);
	const std::string type = typeOf(file, kVtkHdf);
	const double version = file.realOr(kVtkHdf, "Version", 0.0);
	if (!file.has(kVtkHdf) || type.empty())
		throw Refusal("not a VTKHDF file, though its first bytes are HDF5's, or a damaged one");
	if (version > 2.0)
		throw Refusal(fmt::format("VTKHDF of version {}; versions 1 and 2 are read", version));
	if (isOneOf(type, {"PartitionedDataSetCollection", "MultiBlockDataSet"}))
		return readCollection(request, manifest, file);
	refuseOtherKinds(type);
	readVtkHdfSet({file, type, kVtkHdf, "/vprobe"}, request, manifest);
}

} // namespace vp::reader::vtk
