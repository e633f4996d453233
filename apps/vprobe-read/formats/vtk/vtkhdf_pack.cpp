#include "vtkhdf_pack.h"

#include "base/huge_vector.h"
#include "pack_checks.h"
#include "pack_index.h"
#include "pack_places.h"
#include "point_ranks.h"
#include "read/cell_types.h"
#include "shared_faces.h"
#include "vprobe-read/arrays/value_image.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/manifest/manifest_writer.h"
#include "vprobe-read/quick/tasks.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace vp::reader::vtk
{

using grid::NumberType;

namespace
{

// So large a piece of a list is read by one thread.
constexpr std::size_t kBytesAtOnce = std::size_t(4) << 20;

class PackReader
{
public:
	PackReader(const PackIndex& index, const Request& request, manifest::Writer& manifest)
	    : index_(index), request_(request), manifest_(manifest)
	{
		std::uint64_t first = 0;
		for (const std::uint64_t points : index.parts().points)
			first_points_.push_back(std::exchange(first, first + points));
	}

	void read()
	{
		constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
		if (index_.parts().all_ids < most && index_.parts().all_points < most)
			addAs<vtkTypeInt32Array>();
		else
			addAs<vtkTypeInt64Array>();
	}

private:
	// Reads a list, on all threads, when runTasks() is called.
	void fetch(const hdf5::Rows& rows, void* to)
	{
		const std::uint64_t count = rows.size();
		bytes_read_ += count * rows.rowBytes();
		rows.askFor(0, count);
		const std::uint64_t at_once = std::max<std::uint64_t>(kBytesAtOnce / rows.rowBytes(), 1);
		tasks_.add((count + at_once - 1) / at_once,
		           [=, &rows, first = static_cast<std::byte*>(to)](std::size_t piece, arrays::Scratch&)
		           {
			           const std::uint64_t begin = piece * at_once;
			           rows.read(begin, std::min(at_once, count - begin), first + begin * rows.rowBytes());
		           });
	}

	void runTasks()
	{
		tasks_.run();
		tasks_ = quick::Tasks(request_.threads);
	}

	// Ids: the array that holds the ids of points.
	template <class Ids>
	void addAs()
	{
		using Id = typename Ids::ValueType;
		const PackParts& parts = index_.parts();
		const hdf5::Rows place_rows = index_.rowsOf("Points", index_.typeOfPoints(), parts.all_points, 3);
		const hdf5::Rows number_rows = index_.rowsOf("own/PointNumbers", NumberType::uint32, parts.all_points);
		const hdf5::Rows cell_rows = index_.rowsOf("own/CellNumbers", NumberType::uint32, parts.all_cells);
		const hdf5::Rows id_rows = index_.rowsOf("Connectivity", NumberType::int32, parts.all_ids);

		HugeVector<std::uint32_t> numbers(index_.parts().all_points), cell_numbers(index_.parts().all_cells);
		vtkNew<Ids> connectivity; // whoever keeps the grid keeps it
		connectivity->SetNumberOfValues(static_cast<vtkIdType>(index_.parts().all_ids));
		Id* first = connectivity->GetPointer(0);
		constexpr bool is_wide =
		    sizeof(Id) > sizeof(std::int32_t); // than ids in the file, which else are turned in place
		HugeVector<std::int32_t> narrow(is_wide ? index_.parts().all_ids : 0);
		const std::span<std::int32_t> ids(is_wide ? narrow.data() : reinterpret_cast<std::int32_t*>(first),
		                                  index_.parts().all_ids);
		HugeVector<std::byte> places(numbers.size() * place_rows.rowBytes());
		fetch(number_rows, numbers.data());
		fetch(place_rows, places.data());
		fetch(id_rows, ids.data());
		fetch(cell_rows, cell_numbers.data());
		runTasks();
		const std::uint64_t count = renumber(numbers);

		tasks_.add(index_.runs().size(),
		           [&](std::size_t number, arrays::Scratch&)
		           {
			           const PackRun& run = index_.runs()[number];
			           const auto of_part = pointsOf(run.part, numbers);
			           const std::span<std::int32_t> local = ids.subspan(run.first_id, run.ids);
			           const std::uint64_t first_id = parts.first_ids[run.part];
			           refuseWrongIds(local, first_id, of_part.size());
			           const std::byte* of_first =
			               places.data() + (first_points_[run.part] - first_id) * place_rows.rowBytes();
			           const std::array<double, 6>& box = index_.boxes()[number];
			           if (place_rows.type() == NumberType::float32)
				           refuseOutside(local, reinterpret_cast<const float*>(of_first), box);
			           else
				           refuseOutside(local, reinterpret_cast<const double*>(of_first), box);
			           Id* to = first + run.first_id;
			           for (const std::int32_t id : local)
				           *to++ = static_cast<Id>(of_part[static_cast<std::uint64_t>(id) - first_id]);
		           });
		runTasks();

		vtkNew<vtkUnstructuredGrid> grid;
		vtkNew<vtkPoints> points;
		points->SetData(joined(place_rows, places, numbers, count));
		grid->SetPoints(points);
		setCells<Ids>(connectivity.Get(), grid);
		if (index_.hasPolyhedra())
			setPolyhedra(numbers, count, grid);
		addArrays(numbers, count, grid);
		manifest_.addPack(grid, index_.facts(bytes_read_), index_.farthest(),
		                  {cell_numbers.begin(), cell_numbers.end()});
	}

	// Returns the numbers of the points of a part.
	std::span<std::uint32_t> pointsOf(std::size_t part, HugeVector<std::uint32_t>& numbers) const
	{
		return std::span(numbers).subspan(first_points_[part], index_.parts().points[part]);
	}

	// Turns the numbers of points in the packed file into their places among those that are read. Returns how many are.
	std::uint64_t renumber(HugeVector<std::uint32_t>& numbers)
	{
		PointRanks ranks(index_.allPoints());
		for (std::size_t part = 0; part < index_.parts().count(); ++part)
		{
			const std::span<std::uint32_t> of_part = pointsOf(part, numbers);
			for (std::size_t p = 0; p < of_part.size(); ++p)
			{
				if (of_part[p] >= index_.allPoints() || (p > 0 && of_part[p] <= of_part[p - 1]))
					throw damaged("the points of a part are out of order");
				ranks.note(of_part[p]);
			}
		}
		ranks.count();
		tasks_.add(index_.parts().count(),
		           [&](std::size_t part, arrays::Scratch&)
		           {
			           for (std::uint32_t& number : pointsOf(part, numbers))
				           number = static_cast<std::uint32_t>(ranks.rank(number));
		           });
		runTasks();
		return ranks.size();
	}

	template <class Ids>
	void setCells(Ids* connectivity, vtkUnstructuredGrid* grid)
	{
		using Id = typename Ids::ValueType;
		const PackParts& parts = index_.parts();
		const std::uint64_t count = parts.all_cells;
		vtkNew<Ids> offsets;
		offsets->SetNumberOfValues(static_cast<vtkIdType>(count + 1));
		Id* ends = offsets->GetPointer(0);
		ends[0] = 0;
		vtkNew<vtkUnsignedCharArray> types;
		types->SetNumberOfValues(static_cast<vtkIdType>(count));
		if (const std::uint8_t type = index_.typeOfAll(); type != 0)
		{
			const auto size = static_cast<std::uint64_t>(read::slicedCellSize(type));
			std::fill_n(types->GetPointer(0), count, type);
			for (std::uint64_t c = 1; c <= count; ++c)
				ends[c] = static_cast<Id>(c * size);
		}
		else
		{
			const hdf5::Rows type_rows = index_.rowsOf("Types", NumberType::uint8, count);
			const hdf5::Rows end_rows = index_.rowsOf("Offsets", NumberType::int32, index_.parts().all_ends);
			HugeVector<std::int32_t> local(index_.parts().all_ends);
			fetch(type_rows, types->GetPointer(0));
			fetch(end_rows, local.data());
			runTasks();
			for (const PackRun& run : index_.runs())
			{
				const std::uint64_t first_end =
				    parts.first_ends[run.part] + (run.first_cell - parts.first_cells[run.part]);
				const std::span<std::int32_t> of_run = std::span(local).subspan(first_end, run.cells + 1);
				refuseWrongEnds(of_run, run.ids);
				Id* to = ends + run.first_cell + 1;
				for (const std::int32_t end : of_run.subspan(1))
					*to++ = static_cast<Id>(run.first_id) + static_cast<Id>(end - of_run.front());
			}
		}
		vtkNew<vtkCellArray> cells;
		cells->SetData(offsets.Get(), connectivity);
		// Without faces, which come later: otherwise VTK takes the points of polyhedra for lists of faces.
		grid->SetCells(types, cells, nullptr, nullptr);
	}

	// numbers: those of the points of all parts, of which there are so many.
	void setPolyhedra(HugeVector<std::uint32_t>& numbers, std::uint64_t points, vtkUnstructuredGrid* grid)
	{
		const PackParts& parts = index_.parts();
		const hdf5::Rows id_rows = index_.rowsOf("FaceConnectivity", NumberType::int32, parts.all_face_ids);
		const hdf5::Rows end_rows = index_.rowsOf("FaceOffsets", NumberType::int32, parts.all_face_ends);
		const hdf5::Rows cell_rows = index_.rowsOf("PolyhedronOffsets", NumberType::int32, parts.all_ends);
		HugeVector<std::int32_t> ids(parts.all_face_ids), ends(parts.all_face_ends), cell_ends(parts.all_ends);
		fetch(id_rows, ids.data());
		fetch(end_rows, ends.data());
		fetch(cell_rows, cell_ends.data());
		runTasks();
		SharedFaces faces;
		faces.points = points;
		faces.cells = parts.all_cells;
		faces.has_lists = true;
		const auto addEnds = [](std::span<const std::int32_t> local, std::uint64_t sum, std::vector<std::int64_t>& to)
		{
			refuseWrongEnds(local, sum);
			const std::int64_t first = (to.empty() ? 0 : to.back()) - local.front();
			for (const std::int32_t end : local.subspan(1))
				to.push_back(first + end);
		};
		for (const PackRun& run : index_.runs())
		{
			const auto of_part = pointsOf(run.part, numbers);
			const std::span<const std::int32_t> of_run = std::span(ids).subspan(run.first_face_id, run.face_ids);
			const std::uint64_t first_id = parts.first_ids[run.part];
			refuseWrongIds(of_run, first_id, of_part.size());
			for (const std::int32_t id : of_run)
				faces.corners.push_back(of_part[static_cast<std::uint64_t>(id) - first_id]);
			const std::uint64_t first_end = run.first_face + parts.partitionOf(run.part);
			addEnds(std::span(ends).subspan(first_end, run.faces + 1), run.face_ids, faces.corner_ends);
			const std::uint64_t first_cell_end = run.first_cell + parts.partitionOf(run.part);
			addEnds(std::span(cell_ends).subspan(first_cell_end, run.cells + 1), run.faces, faces.face_ends);
		}
		faces.faces.resize(faces.corner_ends.size());
		std::iota(faces.faces.begin(), faces.faces.end(), std::int64_t(0)); // each cell has its own
		setSharedFaces({faces}, grid);
	}

	// An array of points, each once, from the values that the parts have.
	static vtkSmartPointer<vtkDataArray> joined(const hdf5::Rows& rows, const HugeVector<std::byte>& values,
	                                            const HugeVector<std::uint32_t>& numbers, std::uint64_t count)
	{
		vtkSmartPointer<vtkDataArray> array = emptyArray(rows, count);
		auto* to = static_cast<std::byte*>(array->GetVoidPointer(0));
		const std::size_t bytes = rows.rowBytes();
		for (std::size_t i = 0; i < numbers.size(); ++i)
			std::memcpy(to + numbers[i] * bytes, values.data() + i * bytes, bytes);
		return array;
	}

	static vtkSmartPointer<vtkDataArray> emptyArray(const hdf5::Rows& rows, std::uint64_t count)
	{
		auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(arrays::vtkTypeOf(rows.type())));
		array->SetNumberOfComponents(static_cast<int>(rows.components()));
		array->SetNumberOfTuples(static_cast<vtkIdType>(count));
		return array;
	}

	void addArrays(const HugeVector<std::uint32_t>& numbers, std::uint64_t count, vtkUnstructuredGrid* grid)
	{
		for (const PackedArray& wanted : index_.arrays())
		{
			const hdf5::Rows rows = index_.rowsOf(wanted, index_.time());
			vtkSmartPointer<vtkDataArray> array;
			if (wanted.association == "Point")
			{
				HugeVector<std::byte> values(numbers.size() * rows.rowBytes());
				fetch(rows, values.data());
				runTasks();
				array = joined(rows, values, numbers, count);
			}
			else
			{
				array = emptyArray(rows, index_.parts().all_cells);
				fetch(rows, array->GetVoidPointer(0));
				runTasks();
			}
			array->SetName(wanted.name.c_str());
			if (!wanted.units.empty())
				array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), wanted.units.c_str());
			if (wanted.association == "Point")
				grid->GetPointData()->AddArray(array);
			else
				grid->GetCellData()->AddArray(array);
		}
	}

	const PackIndex& index_;
	const Request& request_;
	manifest::Writer& manifest_;
	quick::Tasks tasks_{request_.threads};
	std::vector<std::uint64_t> first_points_; // where each part begins in the list of all
	std::uint64_t bytes_read_ = 0;
};

// Returns false if the pack cannot be read in place. is_alone: in its file, in no collection. Then it may come apart.
bool addInPlace(const PackIndex& index, const std::string& file, bool is_alone, manifest::Writer& manifest)
{
	PartFilter& filter = manifest.parts();
	PackRange own;
	const auto choose = [&](std::size_t runs, std::uint64_t cells) -> std::optional<PackRange>
	{
		own = {0, runs};
		if (!is_alone || !filter.splits())
			return filter.begin(cells) ? std::optional(own) : std::nullopt;
		const auto chosen =
		    filter.beginLattice({{"kind", "unstructured"}, {"points", index.allPoints()}}, runs, cells / runs);
		if (chosen)
			own = {chosen->begin, chosen->end};
		return chosen ? std::optional(own) : std::nullopt;
	};
	const auto describe = [&](arrays::Writer& writer) { return describePlaces(index, file, choose, writer); };
	return manifest.addPackInPlace(
	    describe, [&] { return index.factsOfRuns(own.begin, own.end); }, index.farthest());
}

} // namespace

void readVtkHdfPack(const hdf5::File& file, const VtkHdfPack& pack, const Request& request,
                    const WantsVtkHdfArray& wants, manifest::Writer& manifest)
{
	const PackIndex index(file, pack, wants);
	if (request.wants_places && addInPlace(index, file.name(), pack.root == "/VTKHDF", manifest))
		return;
	if (!index.source().empty())
		throw Refusal("the index of another file; open that file");
	PackReader(index, request, manifest).read();
}

} // namespace vp::reader::vtk
