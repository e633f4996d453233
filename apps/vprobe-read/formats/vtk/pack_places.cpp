#include "pack_places.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace vp::reader::vtk
{

using grid::NumberType;
using nlohmann::json;

namespace
{

json written(arrays::Writer& writer, std::span<const std::uint64_t> counts)
{
	return writer.write(NumberType::uint64, counts.data(), counts.size_bytes());
}

// Returns how many runs have cells that somebody sees, if these come first.
std::optional<std::size_t> seenRuns(const PackIndex& index)
{
	const auto isSeen = [](const std::array<double, 6>& box) { return box[0] <= box[3]; };
	const auto end = std::ranges::find_if_not(index.boxes(), isSeen);
	if (std::any_of(end, index.boxes().end(), isSeen) || end == index.boxes().begin())
		return std::nullopt;
	return static_cast<std::size_t>(end - index.boxes().begin());
}

json describeRuns(const PackIndex& index, std::size_t count, arrays::Writer& writer)
{
	std::vector<std::uint64_t> cells, ids, parts, faces, face_ids;
	for (const PackRun& run : std::span(index.runs()).first(count))
	{
		cells.push_back(run.cells);
		ids.push_back(run.ids);
		parts.push_back(run.part);
		faces.push_back(run.faces);
		face_ids.push_back(run.face_ids);
	}
	json boxes = writer.write(NumberType::float64, index.boxes().data(), count * sizeof(index.boxes()[0]));
	json runs = {{"boxes", std::move(boxes)},
	             {"cells", written(writer, cells)},
	             {"ids", written(writer, ids)},
	             {"parts", written(writer, parts)}};
	if (index.hasPolyhedra())
	{
		runs["faces"] = written(writer, faces);
		runs["face_ids"] = written(writer, face_ids);
	}
	return runs;
}

} // namespace

std::optional<json> describePlaces(const PackIndex& index, const std::string& file, const ChoosePackRuns& choose,
                                   arrays::Writer& writer)
{
	const std::optional<std::size_t> runs = seenRuns(index);
	if (!runs || index.allPoints() > std::numeric_limits<std::int32_t>::max())
		return std::nullopt;
	bool all_plain = true;
	const auto offsetOf = [&](const hdf5::Rows& rows)
	{
		all_plain = all_plain && rows.plainOffset();
		return rows.plainOffset().value_or(0);
	};
	const PackParts& parts = index.parts();
	json lists = {{"points", offsetOf(index.rowsOf("Points", index.typeOfPoints(), parts.all_points, 3))},
	              {"point_numbers", offsetOf(index.rowsOf("own/PointNumbers", NumberType::uint32, parts.all_points))},
	              {"ids", offsetOf(index.rowsOf("Connectivity", NumberType::int32, parts.all_ids))},
	              {"cell_numbers", offsetOf(index.rowsOf("own/CellNumbers", NumberType::uint32, parts.all_cells))}};
	const std::uint8_t type = index.typeOfAll();
	if (type == 0)
	{
		lists["types"] = offsetOf(index.rowsOf("Types", NumberType::uint8, parts.all_cells));
		lists["ends"] = offsetOf(index.rowsOf("Offsets", NumberType::int32, parts.all_ends));
	}
	if (index.hasPolyhedra())
	{
		lists["face_ids"] = offsetOf(index.rowsOf("FaceConnectivity", NumberType::int32, parts.all_face_ids));
		lists["face_ends"] = offsetOf(index.rowsOf("FaceOffsets", NumberType::int32, parts.all_face_ends));
		lists["polyhedron_ends"] = offsetOf(index.rowsOf("PolyhedronOffsets", NumberType::int32, parts.all_ends));
	}
	json arrays = json::array();
	for (const PackedArray& array : index.arrays())
	{
		if (array.name == "vtkGhostType") // its marks have done their work
			continue;
		json times = json::array();
		for (std::size_t time = 0; time < index.times(); ++time)
		{
			const std::uint64_t offset =
			    array.places.empty() ? offsetOf(index.rowsOf(array, time)) : array.places[time];
			times.push_back({{"offset", offset}, {"facts", array.facts[time]}});
			if (const std::optional<hdf5::Rows> ranges = index.rangesOf(array, time); ranges && ranges->plainOffset())
				times.back()["ranges"] = *ranges->plainOffset();
		}
		arrays.push_back({{"name", array.name},
		                  {"association", array.association == "Point" ? "point" : "cell"},
		                  {"components", array.components},
		                  {"units", array.units},
		                  {"type", grid::numberTypeName(array.type)},
		                  {"in_source", !array.places.empty()},
		                  {"swaps", array.swaps},
		                  {"times", std::move(times)}});
	}
	if (!all_plain)
		return std::nullopt;
	const PackRun& last = index.runs()[*runs - 1];
	const std::optional<PackRange> own = choose(*runs, last.first_cell + last.cells);
	if (!own)
		return json();
	json block = {{"kind", "packed"},
	              {"file", file},
	              {"source", index.source()},
	              {"runs", describeRuns(index, *runs, writer)},
	              {"part_cells", written(writer, parts.cells)},
	              {"part_points", written(writer, parts.points)},
	              {"part_first_ids", written(writer, parts.first_ids)},
	              {"part_first_ends", written(writer, parts.first_ends)},
	              {"time", index.time()},
	              {"type", type},
	              {"type_of_points", grid::numberTypeName(index.typeOfPoints())},
	              {"lists", std::move(lists)},
	              {"arrays", std::move(arrays)}};
	if (own->begin > 0 || own->end < *runs)
		block["own_runs"] = {own->begin, own->end};
	return block;
}

} // namespace vp::reader::vtk
