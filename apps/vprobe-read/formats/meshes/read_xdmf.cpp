// XDMF 2 and 3 by a parser of our own: Debian's VTK has no reader, and libxdmf brings another HDF5 and MPI.
#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/own_names.h"
#include "vprobe-read/manifest/time_choice.h"
#include "xdmf_cells.h"
#include "xdmf_document.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace vp::reader::meshes
{

namespace
{

std::string small(std::string_view text)
{
	std::string words(text);
	std::transform(words.begin(), words.end(), words.begin(), [](unsigned char c) { return std::tolower(c); });
	return words;
}

std::string typeOf(const text::XmlElement& element, std::string_view key)
{
	const std::string_view type = element.attribute(key);
	return small(type.empty() ? element.attribute("Type") : type);
}

class Grids
{
public:
	Grids(const XdmfDocument& document, const Request& request, manifest::Writer& manifest)
	    : document_(document), request_(request), manifest_(manifest)
	{
	}

	void add()
	{
		const text::XmlElement* domain = document_.child(document_.root(), "Domain");
		if (!domain)
			throw damaged("it has no Domain");
		std::vector<std::vector<double>> lists;
		collectTimes(*domain, lists);
		std::vector<double> times = manifest::unitedTimes(lists);
		time_ = manifest::chooseInLists(times, request_);
		addChildren(*domain, "");
		manifest_.offerTimes(std::move(times));
	}

private:
	static bool isTemporal(const text::XmlElement& grid)
	{
		return typeOf(grid, "GridType") == "collection" && small(grid.attribute("CollectionType")) == "temporal";
	}

	// Returns the time of each grid of a temporal collection.
	std::vector<double> timesOf(const text::XmlElement& collection) const
	{
		const std::vector<const text::XmlElement*> grids = document_.children(collection, "Grid");
		std::vector<double> times;
		const text::XmlElement* all = document_.child(collection, "Time");
		const text::XmlElement* item = all ? document_.child(*all, "DataItem") : nullptr;
		std::vector<double> given;
		if (item)
		{
			const XdmfValues values = document_.values(*item);
			for (std::uint64_t i = 0; i < values.count(); ++i)
				given.push_back(values.array->GetTuple1(static_cast<vtkIdType>(i)));
			if (small(all->attribute("TimeType")) == "hyperslab" && given.size() == 3)
			{
				const std::vector<double> slab = std::exchange(given, {});
				for (std::size_t i = 0; i < grids.size(); ++i)
					given.push_back(slab[0] + slab[1] * static_cast<double>(i));
			}
		}
		for (std::size_t i = 0; i < grids.size(); ++i)
		{
			const text::XmlElement* own = document_.child(*grids[i], "Time");
			const auto value = own ? xdmfNumbers(own->attribute("Value")) : std::vector<double>();
			times.push_back(!value.empty() ? value[0] : i < given.size() ? given[i] : static_cast<double>(i));
		}
		return times;
	}

	void collectTimes(const text::XmlElement& from, std::vector<std::vector<double>>& lists) const
	{
		for (const text::XmlElement* grid : document_.children(from, "Grid"))
			if (isTemporal(*grid))
				lists.push_back(timesOf(*grid));
			else
				collectTimes(*grid, lists);
	}

	void addChildren(const text::XmlElement& of, const std::string& path)
	{
		std::size_t number = 0;
		for (const text::XmlElement* grid : document_.children(of, "Grid"))
		{
			std::string name(grid->attribute("Name"));
			if (name.empty())
				name = fmt::format("grid {}", number);
			++number;
			addGrid(*grid, path.empty() ? name : path + "/" + name);
		}
	}

	void addGrid(const text::XmlElement& grid, const std::string& path)
	{
		if (isTemporal(grid))
		{
			if (const auto place = time_ ? time_->placeIn(timesOf(grid)) : std::nullopt)
				addGrid(*document_.children(grid, "Grid")[*place], path);
			return;
		}
		const std::string type = typeOf(grid, "GridType");
		if (type == "collection" || type == "tree")
			return addChildren(grid, path);
		if (type == "subset")
			return manifest_.warn(fmt::format("the subset {} is left out", path));
		// A mesh that the grids of a series share.
		if (document_.isTakenOver(grid) && document_.children(grid, "Attribute").empty())
			return;
		const text::XmlElement* topology = document_.child(grid, "Topology");
		const text::XmlElement* geometry = document_.child(grid, "Geometry");
		if (!topology || !geometry)
		{
			// dolfin writes a mesh once, and its values in a grid for each time.
			manifest_.warn(fmt::format("the grid {} has no mesh and is left out", path));
			return;
		}
		const vtkSmartPointer<vtkDataSet> data = meshOf(*topology, *geometry);
		addAttributes(grid, data);
		manifest_.setPrefix(path);
		manifest_.add(data);
	}

	const text::XmlElement& itemOf(const text::XmlElement& element, std::size_t which) const
	{
		const auto items = document_.children(element, "DataItem");
		if (which >= items.size())
			throw damaged(fmt::format("a {} without its DataItem", element.name));
		return *items[which];
	}

	// Points of a lattice, x first.
	static std::array<int, 3> lattice(const text::XmlElement& topology)
	{
		const std::vector<double> sides = xdmfNumbers(
		    topology.has("Dimensions") ? topology.attribute("Dimensions") : topology.attribute("NumberOfElements"));
		if (sides.size() != 3)
			throw Refusal("nothing to slice: a lattice of two dimensions");
		std::array<int, 3> points;
		for (std::size_t a = 0; a < 3; ++a)
		{
			if (!(sides[a] >= 1.0) || sides[a] > 1e9)
				throw damaged("a lattice of impossible size");
			points[2 - a] = static_cast<int>(sides[a]);
		}
		return points;
	}

	vtkSmartPointer<vtkDataSet> meshOf(const text::XmlElement& topology, const text::XmlElement& geometry) const
	{
		const std::string type = typeOf(topology, "TopologyType");
		if (type == "3dcorectmesh")
			return image(topology, geometry);
		if (type == "3drectmesh")
			return rectilinear(topology, geometry);
		if (type == "3dsmesh")
		{
			const auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
			grid->SetDimensions(lattice(topology).data());
			grid->SetPoints(points(geometry));
			return grid;
		}
		if (type.starts_with("2d"))
			throw Refusal("nothing to slice: a lattice of two dimensions");
		return unstructured(topology, geometry, type);
	}

	vtkSmartPointer<vtkDataSet> image(const text::XmlElement& topology, const text::XmlElement& geometry) const
	{
		const XdmfValues origin = document_.values(itemOf(geometry, 0));
		const XdmfValues step = document_.values(itemOf(geometry, 1));
		if (origin.count() != 3 || step.count() != 3)
			throw damaged("an origin or distances without three numbers");
		const auto grid = vtkSmartPointer<vtkImageData>::New();
		grid->SetDimensions(lattice(topology).data());
		// As the sides, z comes first.
		grid->SetOrigin(origin.array->GetTuple1(2), origin.array->GetTuple1(1), origin.array->GetTuple1(0));
		grid->SetSpacing(step.array->GetTuple1(2), step.array->GetTuple1(1), step.array->GetTuple1(0));
		return grid;
	}

	vtkSmartPointer<vtkDataSet> rectilinear(const text::XmlElement& topology, const text::XmlElement& geometry) const
	{
		const auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
		grid->SetDimensions(lattice(topology).data());
		grid->SetXCoordinates(document_.values(itemOf(geometry, 0)).array);
		grid->SetYCoordinates(document_.values(itemOf(geometry, 1)).array);
		grid->SetZCoordinates(document_.values(itemOf(geometry, 2)).array);
		return grid;
	}

	vtkSmartPointer<vtkPoints> points(const text::XmlElement& geometry) const
	{
		const std::string type = typeOf(geometry, "GeometryType");
		const auto places = vtkSmartPointer<vtkPoints>::New();
		places->SetDataTypeToDouble();
		if (type.empty() || type == "xyz")
		{
			const XdmfValues values = document_.values(itemOf(geometry, 0));
			if (values.count() % 3 != 0)
				throw damaged("points without three coordinates");
			for (std::uint64_t i = 0; i < values.count(); i += 3)
			{
				const auto at = static_cast<vtkIdType>(i);
				places->InsertNextPoint(values.array->GetTuple1(at), values.array->GetTuple1(at + 1),
				                        values.array->GetTuple1(at + 2));
			}
		}
		else if (type == "x_y_z")
		{
			std::array<XdmfValues, 3> axes;
			for (std::size_t a = 0; a < 3; ++a)
			{
				axes[a] = document_.values(itemOf(geometry, a));
				if (axes[a].count() != axes[0].count())
					throw damaged("points without three coordinates");
			}
			for (vtkIdType i = 0; i < axes[0].array->GetNumberOfTuples(); ++i)
				places->InsertNextPoint(axes[0].array->GetTuple1(i), axes[1].array->GetTuple1(i),
				                        axes[2].array->GetTuple1(i));
		}
		else if (type == "xy" || type == "x_y")
			throw Refusal("nothing to slice: points of two dimensions");
		else
			throw Refusal(fmt::format("a geometry of type {}, which is not read", type.substr(0, 20)));
		return places;
	}

	vtkSmartPointer<vtkDataSet> unstructured(const text::XmlElement& topology, const text::XmlElement& geometry,
	                                         const std::string& type) const
	{
		const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
		grid->SetPoints(points(geometry));
		const XdmfValues ids = document_.values(itemOf(topology, 0));
		std::vector<vtkIdType> stream(ids.count());
		const auto base = xdmfNumbers(topology.attribute("BaseOffset"));
		const auto first = base.empty() ? 0 : static_cast<vtkIdType>(base[0]);
		for (std::size_t i = 0; i < stream.size(); ++i)
			stream[i] = static_cast<vtkIdType>(ids.array->GetTuple1(static_cast<vtkIdType>(i)));
		if (type == "mixed")
			insertMixedXdmfCells(stream, first, grid);
		else
			insertXdmfCells(stream, first, type, topology, grid);
		return grid;
	}

	// Values of a lattice with straight axes may stay in their file.
	vtkSmartPointer<vtkDataArray> storedValues(const text::XmlElement& item, vtkDataSet* data, bool at_points,
	                                           const std::string& name) const
	{
		std::array<int, 3> points;
		if (auto* image = vtkImageData::SafeDownCast(data))
			image->GetDimensions(points.data());
		else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
			grid->GetDimensions(points.data());
		else
			return nullptr;
		std::array<std::uint32_t, 3> items;
		for (std::size_t axis = 0; axis < 3; ++axis)
			items[axis] = static_cast<std::uint32_t>(points[axis] - (at_points ? 0 : 1));
		return document_.storedValues(item, items, name, request_);
	}

	void addAttributes(const text::XmlElement& grid, vtkDataSet* data) const
	{
		for (const text::XmlElement* attribute : document_.children(grid, "Attribute"))
		{
			const std::string center = small(attribute->attribute("Center"));
			const bool at_points = center.empty() || center == "node";
			const std::string given(attribute->attribute("Name"));
			if (!at_points && center != "cell")
			{
				manifest_.warn(fmt::format("{} has values of each {} and is left out", given, center.substr(0, 20)));
				continue;
			}
			vtkFieldData* arrays = data->GetPointData();
			if (!at_points)
				arrays = data->GetCellData();
			const std::string name = manifest::ownName(arrays, given.empty() ? "array" : given, manifest_);
			const text::XmlElement& item = itemOf(*attribute, 0);
			if (const auto stored = storedValues(item, data, at_points, name))
			{
				arrays->AddArray(stored);
				continue;
			}
			const XdmfValues values = document_.values(item);
			const auto tuples =
			    static_cast<std::uint64_t>(at_points ? data->GetNumberOfPoints() : data->GetNumberOfCells());
			if (tuples == 0 || values.count() % tuples != 0 || values.count() / tuples > 64)
				throw damaged(fmt::format("{} has {} values for {} {}s", name, values.count(), tuples,
				                          at_points ? "point" : "cell"));
			// The values lie as VTK wants them, but are one component so far.
			const auto array = vtkSmartPointer<vtkDataArray>::Take(values.array->NewInstance());
			array->SetNumberOfComponents(static_cast<int>(values.count() / tuples));
			array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
			std::copy_n(static_cast<const char*>(values.array->GetVoidPointer(0)),
			            values.count() * static_cast<std::size_t>(values.array->GetDataTypeSize()),
			            static_cast<char*>(array->GetVoidPointer(0)));
			array->SetName(name.c_str());
			arrays->AddArray(array);
		}
	}

	const XdmfDocument& document_;
	const Request& request_;
	manifest::Writer& manifest_;
	std::optional<manifest::TimeInList> time_;
};

} // namespace

void readXdmf(const Request& request, manifest::Writer& manifest)
{
	const MappedText file(request.file);
	const XdmfDocument document(request.file, file.text());
	Grids(document, request, manifest).add();
}

} // namespace vp::reader::meshes
