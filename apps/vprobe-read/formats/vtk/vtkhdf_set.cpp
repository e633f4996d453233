// Data sets of VTKHDF 1 and 2 through HDF5: VTK 9.1 reads version 1.0, and takes several times of version 2 for parts.
#include "vtkhdf_set.h"

#include "read/cell_types.h"
#include "shared_faces.h"
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/cells/structured_blocks.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/manifest/time_choice.h"
#include "vtkhdf_pack.h"
#include "vtkhdf_steps.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vp::reader::vtk
{

using grid::NumberType;

namespace
{

constexpr std::uint64_t kMaxComponentsOfVtkHdf = 1 << 16;
constexpr std::size_t kMaxWarnings = 100; // that an index repeats

class VtkHdfReader
{
public:
	VtkHdfReader(const VtkHdfSet& set, const Request& request, manifest::Writer& manifest)
	    : request_(request), manifest_(manifest), file_(set.file), root_(set.root), own_(set.own), type_(set.type),
	      step_(file_, root_, std::nullopt)
	{
	}

	void read()
	{
		const std::vector<double> times = VtkHdfStep::timesOf(file_, root_);
		if (const auto step = manifest::offerSteps(times, request_, manifest_))
			step_ = VtkHdfStep(file_, root_, *step);
		const auto wants = [this](const std::string& association, const std::string& name, NumberType of_values,
		                          std::uint64_t components)
		{ return isWanted(association, name, of_values, components); };
		const VtkHdfPack pack = packAmong(manifest::stepsInTime(times, manifest_).steps);
		if (type_ == "ImageData")
			readImage();
		else if (isVtkHdfPack(file_, pack))
		{
			// The time of a pack that has only one.
			if (const std::vector<double> time = file_.realsOr(own_, "Time"); times.empty() && !time.empty())
				manifest_.offerTimes({time[0]});
			for (std::size_t number = 1; number <= kMaxWarnings; ++number)
				if (std::string line = file_.textOr(own_, fmt::format("Warning {}", number).c_str()); !line.empty())
					manifest_.warn(std::move(line));
			readVtkHdfPack(file_, pack, request_, wants, manifest_);
		}
		else
			readGrid();
	}

private:
	VtkHdfPack packAmong(std::vector<std::size_t> steps) const
	{
		if (steps.empty())
			return {root_, own_, {0}, 0};
		const auto chosen = std::ranges::find(steps, step_.number());
		return {root_, own_, steps, static_cast<std::size_t>(chosen - steps.begin())};
	}

	template <std::size_t N>
	std::array<double, N> attribute(const char* name) const
	{
		const std::vector<double> numbers = file_.realsOr(root_, name);
		if (numbers.size() != N || !std::ranges::all_of(numbers, [](double n) { return std::isfinite(n); }))
			throw damaged(fmt::format("its {} is missing, or has not {} numbers", name, N));
		std::array<double, N> array;
		std::ranges::copy(numbers, array.begin());
		return array;
	}

	void readImage()
	{
		const auto whole = attribute<6>("WholeExtent");
		std::array<int, 6> extent;
		for (std::size_t i = 0; i < 6; ++i)
		{
			if (std::abs(whole[i]) > 1e9)
				throw damaged("its WholeExtent cannot be");
			extent[i] = static_cast<int>(whole[i]);
		}
		// As data sets have them, the slowest first.
		std::vector<std::uint64_t> points, cells;
		for (std::size_t axis = 3; axis-- > 0;)
		{
			if (extent[2 * axis + 1] <= extent[2 * axis])
				throw Refusal("nothing to slice: an image of fewer than three dimensions");
			cells.push_back(static_cast<std::uint64_t>(extent[2 * axis + 1] - extent[2 * axis]));
			points.push_back(cells.back() + 1);
		}
		vtkNew<vtkImageData> image;
		image->SetExtent(extent.data());
		image->SetOrigin(attribute<3>("Origin").data());
		image->SetSpacing(attribute<3>("Spacing").data());
		if (!file_.realsOr(root_, "Direction").empty())
			image->SetDirectionMatrix(attribute<9>("Direction").data());
		may_stay_ = cells::isAxisAligned(image->GetDirectionMatrix()) && !file_.has(pathOf("Point", "vtkGhostType")) &&
		            !file_.has(pathOf("Cell", "vtkGhostType"));
		addLatticeArrays("Point", points, image->GetPointData());
		addLatticeArrays("Cell", cells, image->GetCellData());
		manifest_.add(image);
	}

	// Whether an array is wanted. Notes it if it is not.
	bool isWanted(const std::string& association, const std::string& name, NumberType type, std::uint64_t components)
	{
		if (name == "vtkGhostType")
			return true;
		const bool is_shown = !std::exchange(has_shown_, true);
		const std::string small = association == "Point" ? "point" : "cell";
		const bool is_needed =
		    isOneOf(name, {"HigherOrderDegrees", "RationalWeights"}) ||
		    isOneOf(file_.textOr(pathOf(association, name), "Attribute"), {"HigherOrderDegrees", "RationalWeights"});
		if (is_needed || request_.arrays.wants(small, name, is_shown))
			return true;
		manifest_.noteLeftOut(manifest::describeLeftOut(small.c_str(), name, type, static_cast<int>(components)));
		return false;
	}

	std::string pathOf(const std::string& association, const std::string& name) const
	{
		return root_ + "/" + association + "Data/" + name;
	}

	// Calls add(NAME, TYPE, SIDES) for each array of numbers.
	template <class Add>
	void eachArray(const std::string& association, Add&& add)
	{
		for (const std::string& name : file_.namesIn(root_ + "/" + association + "Data", hdf5::File::Order::creation))
			if (file_.leadsNowhere(pathOf(association, name)))
				manifest_.warn(fmt::format("the array {} is a link that leads nowhere, and is left out; keep the files "
				                           "that it names together",
				                           name));
			else if (const auto type = file_.numberType(pathOf(association, name)))
				add(name, *type, file_.sidesOf(pathOf(association, name)));
			else
				manifest_.warn(fmt::format("the array {} holds no numbers and is left out", name));
	}

	vtkSmartPointer<vtkDataArray> slab(const std::string& path, NumberType type,
	                                   const std::vector<std::uint64_t>& begin, const std::vector<std::uint64_t>& count,
	                                   std::uint64_t components) const
	{
		const std::vector<std::uint64_t> sides = file_.sidesOf(path);
		std::uint64_t values = 1;
		for (std::size_t i = 0; i < count.size(); ++i)
			if (i >= sides.size() || count[i] > sides[i] || __builtin_mul_overflow(values, count[i], &values))
				throw damaged(fmt::format("{} has fewer values than are asked of it", path));
		const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(arrays::vtkTypeOf(type)));
		array->SetNumberOfComponents(static_cast<int>(components));
		array->SetNumberOfTuples(static_cast<vtkIdType>(values / components));
		file_.readSlab(path, begin, count, type, array->GetVoidPointer(0));
		return array;
	}

	void addArray(const std::string& association, const std::string& name, vtkDataArray* array,
	              vtkDataSetAttributes* to) const
	{
		array->SetName(name.c_str());
		to->AddArray(array);
		const std::string role = file_.textOr(pathOf(association, name), "Attribute");
		if (role == "HigherOrderDegrees")
			to->SetHigherOrderDegrees(array);
		else if (role == "RationalWeights")
			to->SetRationalWeights(array);
	}

	// Returns the array of an image if its values may stay in the file, or null.
	vtkSmartPointer<vtkDataArray> inFile(const std::string& path, const std::string& name, NumberType type,
	                                     const std::vector<std::uint64_t>& lattice, std::uint64_t components,
	                                     const std::vector<std::uint64_t>& front) const
	{
		arrays::ValueLayout layout{{}, static_cast<std::uint32_t>(components), type};
		for (std::size_t axis = 0; axis < 3; ++axis)
			layout.points[axis] = static_cast<std::uint32_t>(lattice[2 - axis]);
		if (!may_stay_ || !request_.leaves(layout.byteCount()))
			return nullptr;
		std::optional<arrays::StoredPlace> place = file_.storedPlace(path, layout, front);
		return place ? arrays::storedArray(layout, name, std::move(*place)) : nullptr;
	}

	// Arrays of a file with times have their steps as the slowest side.
	void addLatticeArrays(const std::string& association, const std::vector<std::uint64_t>& lattice,
	                      vtkDataSetAttributes* to)
	{
		eachArray(association,
		          [&](const std::string& name, NumberType type, const std::vector<std::uint64_t>& sides)
		          {
			          const auto has = [&](std::size_t front)
			          {
				          return sides.size() >= front + 3 && sides.size() <= front + 4 &&
				                 std::equal(lattice.begin(), lattice.end(), sides.begin() + static_cast<long>(front));
			          };
			          const std::size_t front = step_.isOneOfSeveral() && has(1) ? 1 : 0;
			          if (!has(front))
				          throw damaged(fmt::format("the array {} has not the sides of the image", name));
			          const std::uint64_t components = sides.size() == front + 4 ? sides.back() : 1;
			          if (components < 1 || components > kMaxComponentsOfVtkHdf)
				          throw damaged(fmt::format("the array {} has {} components", name, components));
			          if (!isWanted(association, name, type, components))
				          return;
			          std::vector<std::uint64_t> begin(sides.size(), 0), count = sides;
			          if (front == 1)
			          {
				          begin[0] = step_.arrayOffset(association, name).value_or(step_.number());
				          count[0] = 1;
			          }
			          if (const auto stored = inFile(pathOf(association, name), name, type, lattice, components,
			                                         std::vector(begin.begin(), begin.begin() + long(front))))
				          return addArray(association, name, stored, to);
			          addArray(association, name, slab(pathOf(association, name), type, begin, count, components), to);
		          });
	}

	void readGrid()
	{
		const VtkHdfParts parts(file_, step_);
		vtkNew<vtkUnstructuredGrid> grid;
		grid->SetPoints(pointsOf(parts));
		addCells(parts, grid);
		addListArrays("Point", parts.first_point, parts.all_points, grid->GetPointData());
		addListArrays("Cell", parts.first_cell, parts.all_cells, grid->GetCellData());
		manifest_.add(grid);
	}

	vtkSmartPointer<vtkPoints> pointsOf(const VtkHdfParts& parts) const
	{
		const std::string path = root_ + "/Points";
		const std::vector<std::uint64_t> sides = file_.sidesOf(path);
		if (sides.size() != 2 || sides[1] != 3)
			throw damaged("its Points have not three coordinates");
		const NumberType type =
		    file_.numberType(path) == NumberType::float32 ? NumberType::float32 : NumberType::float64;
		const auto points = vtkSmartPointer<vtkPoints>::New();
		points->SetData(slab(path, type, {parts.first_point, 0}, {parts.all_points, 3}, 3));
		return points;
	}

	// A list of each part has one number more than the part has things, which the parts before add to its place.
	std::vector<std::int64_t> endsOf(const std::string& name, std::uint64_t first,
	                                 const std::vector<std::uint64_t>& things, std::size_t part,
	                                 std::uint64_t last) const
	{
		if (things[part] == 0)
			return {};
		const std::uint64_t begin = first + part + vtkHdfSum(things, part);
		std::vector<std::int64_t> ends = file_.integersFrom(root_ + "/" + name, begin, things[part] + 1);
		if (ends[0] != 0 || !std::ranges::is_sorted(ends) || static_cast<std::uint64_t>(ends.back()) != last)
			throw damaged(fmt::format("the {} of a part do not match it", name));
		ends.erase(ends.begin());
		return ends;
	}

	void addCells(const VtkHdfParts& parts, vtkUnstructuredGrid* grid) const
	{
		vtkNew<vtkIdTypeArray> offsets, connectivity;
		offsets->SetNumberOfValues(1);
		offsets->SetValue(0, 0);
		std::vector<std::int64_t> ids = file_.integersFrom(root_ + "/Connectivity", parts.first_id, parts.all_ids);
		std::uint64_t first_id = 0, first_point = 0;
		for (std::size_t part = 0; part < parts.count(); ++part)
		{
			const auto ends = endsOf("Offsets", parts.first_cell + parts.first, parts.cells, part, parts.ids[part]);
			for (const std::int64_t end : ends)
				offsets->InsertNextValue(static_cast<vtkIdType>(first_id) + end);
			for (std::uint64_t i = first_id; i < first_id + parts.ids[part]; ++i)
			{
				if (ids[i] < 0 || static_cast<std::uint64_t>(ids[i]) >= parts.points[part])
					throw damaged("a cell has a point that is not there");
				ids[i] += static_cast<std::int64_t>(first_point);
			}
			first_id += ends.empty() ? 0 : parts.ids[part];
			first_point += parts.points[part];
		}
		if (first_id != parts.all_ids)
			throw damaged("a part without cells lists points");
		connectivity->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
		std::ranges::copy(ids, connectivity->GetPointer(0));
		const auto types = slab(root_ + "/Types", NumberType::uint8, {parts.first_cell}, {parts.all_cells}, 1);
		vtkNew<vtkCellArray> cells;
		cells->SetData(offsets, connectivity);
		// Without faces, which come below: otherwise VTK takes the points of polyhedra for lists of faces.
		grid->SetCells(vtkUnsignedCharArray::SafeDownCast(types), cells, nullptr, nullptr);
		const auto* first = static_cast<const std::uint8_t*>(types->GetVoidPointer(0));
		if (std::find(first, first + parts.all_cells, read::kPolyhedron) != first + parts.all_cells)
			addPolyhedra(parts, grid);
	}

	void addPolyhedra(const VtkHdfParts& parts, vtkUnstructuredGrid* grid) const
	{
		if (!file_.has(root_ + "/NumberOfFaces"))
			throw damaged("polyhedra without faces");
		const auto counts = [&](const char* list)
		{ return vtkHdfCounts(file_, root_ + "/" + list, parts.first, parts.count()); };
		const auto before = [&](const char* offset, const char* list)
		{
			const auto given = step_.entry(offset);
			return given ? *given : vtkHdfSum(vtkHdfCounts(file_, root_ + "/" + list, 0, parts.first), parts.first);
		};
		const auto faces = counts("NumberOfFaces");
		const auto uses = counts("NumberOfPolyhedronToFaceIds");
		const auto corners = counts("NumberOfFaceConnectivityIds");
		const std::uint64_t first_face = before("FaceOffsetsOffsets", "NumberOfFaces");
		const std::uint64_t first_use = before("PolyhedronToFaceIdOffsets", "NumberOfPolyhedronToFaceIds");
		const std::uint64_t first_corner = before("FaceConnectivityOffsets", "NumberOfFaceConnectivityIds");
		std::vector<SharedFaces> pieces(parts.count());
		for (std::size_t part = 0; part < parts.count(); ++part)
		{
			SharedFaces& piece = pieces[part];
			piece.points = parts.points[part];
			piece.cells = parts.cells[part];
			piece.has_lists = true;
			piece.corners =
			    file_.integersFrom(root_ + "/FaceConnectivity", first_corner + vtkHdfSum(corners, part), corners[part]);
			piece.faces =
			    file_.integersFrom(root_ + "/PolyhedronToFaces", first_use + vtkHdfSum(uses, part), uses[part]);
			piece.corner_ends = endsOf("FaceOffsets", first_face + parts.first, faces, part, corners[part]);
			piece.face_ends =
			    endsOf("PolyhedronOffsets", parts.first_cell + parts.first, parts.cells, part, uses[part]);
		}
		setSharedFaces(pieces, grid);
	}

	void addListArrays(const std::string& association, std::uint64_t first, std::uint64_t tuples,
	                   vtkDataSetAttributes* to)
	{
		eachArray(association,
		          [&](const std::string& name, NumberType type, const std::vector<std::uint64_t>& sides)
		          {
			          const std::uint64_t components = sides.size() == 2 ? sides[1] : 1;
			          if (sides.empty() || sides.size() > 2 || components < 1 || components > kMaxComponentsOfVtkHdf)
				          throw damaged(fmt::format("the array {} is no list of values", name));
			          if (!isWanted(association, name, type, components))
				          return;
			          std::vector<std::uint64_t> begin(sides.size(), 0), count = sides;
			          begin[0] = step_.arrayOffset(association, name).value_or(first);
			          count[0] = tuples;
			          addArray(association, name, slab(pathOf(association, name), type, begin, count, components), to);
		          });
	}

	const Request& request_;
	manifest::Writer& manifest_;
	const hdf5::File& file_;
	std::string root_, own_, type_;
	VtkHdfStep step_;
	bool has_shown_ = false;
	bool may_stay_ = false; // arrays of the image, in the file
};

} // namespace

void readVtkHdfSet(const VtkHdfSet& set, const Request& request, manifest::Writer& manifest)
{
	VtkHdfReader(set, request, manifest).read();
}

} // namespace vp::reader::vtk
