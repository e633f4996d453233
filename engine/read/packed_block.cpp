#include "read/packed_block.h"

#include "read/check_mesh.h"
#include "read/manifest_values.h"
#include "read/packed_cells.h"
#include "read/source_stamp.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace vp::read
{

using grid::NumberType;
using nlohmann::json;

namespace
{

std::vector<std::uint64_t> countsOf(const SharedBytes& arrays, const json& list)
{
	const auto counts = numbersOf<std::uint64_t>(arrays, list, NumberType::uint64);
	return {counts.data(), counts.data() + counts.size()};
}

std::vector<grid::CellRuns::Run> runsOf(const SharedBytes& arrays, const json& lists)
{
	const std::vector<std::uint64_t> cells = countsOf(arrays, lists.at("cells"));
	const auto parts = numbersOf<std::uint64_t>(arrays, lists.at("parts"), NumberType::uint64, cells.size());
	const auto boxes = numbersOf<double>(arrays, lists.at("boxes"), NumberType::float64, 6 * cells.size());
	constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
	std::vector<grid::CellRuns::Run> runs;
	runs.reserve(cells.size());
	std::uint64_t first = 0;
	for (std::size_t r = 0; r < cells.size(); ++r)
	{
		if (cells[r] > most || parts[r] > most)
			throw Unusable("a run has more cells than there can be");
		const double* box = boxes.data() + 6 * r;
		runs.push_back({{{box[0], box[1], box[2]}, {box[3], box[4], box[5]}},
		                first,
		                static_cast<std::uint32_t>(cells[r]),
		                static_cast<std::uint32_t>(parts[r])});
		first += cells[r];
	}
	return runs;
}

// A camera sees them if the file does not say which points are farthest from the center.
std::vector<Vec3> cornersOf(std::span<const grid::CellRuns::Run> runs)
{
	std::vector<Vec3> corners;
	for (const grid::CellRuns::Run& run : runs)
		for (int i = 0; i < 8; ++i)
			corners.emplace_back(i & 1 ? run.box.hi.x : run.box.lo.x, i & 2 ? run.box.hi.y : run.box.lo.y,
			                     i & 4 ? run.box.hi.z : run.box.lo.z);
	return corners;
}

PackedCells::List listOf(const json& offset, std::size_t row_bytes)
{
	return {countOf(offset), row_bytes};
}

PackedCells::ArrayLists arrayOf(const json& array)
{
	grid::Field field;
	field.name = wordsOf(array.at("name"));
	field.units = wordsOf(array.value("units", json("")));
	field.association = associationOf(array.at("association"));
	field.components = componentsOf(array.at("components"), field.name);
	field.type = numberTypeOf(array.at("type").get<std::string>());
	PackedCells::ArrayLists lists{.field = field,
	                              .row_bytes = grid::byteSize(field.type) * static_cast<std::size_t>(field.components),
	                              .is_in_source = array.value("in_source", false),
	                              .swaps = array.value("swaps", false)};
	for (const json& time : array.at("times"))
	{
		lists.times.push_back(
		    {.offset = countOf(time.at("offset")), .facts = factsOf(time.at("facts"), field.components)});
		if (time.contains("ranges"))
			lists.times.back().ranges = countOf(time.at("ranges"));
	}
	return lists;
}

// Opens the file that an index is of. stamp: what the index knows it by; empty for a pack, which has its own values.
std::shared_ptr<const parts::OpenFile> openedSource(const json& stamp, const ReadableFiles& files)
{
	if (stamp.empty() && files.indexed.empty())
		return nullptr;
	if (stamp.empty())
		throw Unusable("it is no index");
	if (files.indexed.empty())
		throw Unusable("the index of another file; open that file");
	auto source = std::make_shared<const parts::OpenFile>(files.indexed);
	const SourceStamp known = {countOf(stamp.at(0)), countOf(stamp.at(1)), countOf(stamp.at(2)), countOf(stamp.at(3)),
	                           countOf(stamp.at(4))};
	if (!(stampOf(source->descriptor()) == known))
		throw Unusable("it was made before its file was changed, copied or moved to another disk");
	return source;
}

} // namespace

grid::WholeGrid wholeOf(const json& pack, const SharedBytes& arrays)
{
	grid::WholeGrid whole;
	whole.points = countOf(pack.at("points"));
	whole.cells = countOf(pack.at("cells"));
	const json& ends = pack.at("bounds");
	for (std::size_t axis = 0; axis < 3; ++axis)
	{
		whole.bounds.lo[static_cast<int>(axis)] = finiteOf(ends.at(axis));
		whole.bounds.hi[static_cast<int>(axis)] = finiteOf(ends.at(axis + 3));
	}
	whole.parts.all = countOf(pack.at("parts"));
	whole.parts.kept = whole.parts.met = whole.parts.read = countOf(pack.at("parts_read"));
	whole.parts.bytes_met = whole.parts.bytes_read = countOf(pack.at("bytes_read"));
	if (pack.contains("farthest"))
	{
		const auto numbers = numbersOf<double>(arrays, pack.at("farthest"), NumberType::float64);
		for (std::size_t i = 0; i + 3 <= numbers.size(); i += 3)
			whole.farthest.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
	}
	if (whole.bounds.empty() || whole.parts.read > whole.parts.all)
		throw Unusable("parts of a grid are more than the whole");
	return whole;
}

void takePackedBlock(const json& block, const SharedBytes& arrays, const ReadableFiles& files, CheckedBlock& checked)
{
	const json& runs = block.at("runs");
	const json& lists = block.at("lists");
	PackedCells::Contents contents{.file = openedFile(block.at("file").get<std::string>(), files),
	                               .source = openedSource(block.value("source", json::array()), files),
	                               .runs = runsOf(arrays, runs),
	                               .run_ids = countsOf(arrays, runs.at("ids")),
	                               .all_cells = countsOf(arrays, block.at("part_cells")),
	                               .points = countsOf(arrays, block.at("part_points")),
	                               .first_ids = countsOf(arrays, block.at("part_first_ids")),
	                               .first_ends = countsOf(arrays, block.at("part_first_ends")),
	                               .all_points = countOf(block.at("pack").at("points"))};
	if (block.contains("own_runs"))
		contents.own = {static_cast<std::uint32_t>(countOf(block.at("own_runs").at(0))),
		                static_cast<std::uint32_t>(countOf(block.at("own_runs").at(1)))};
	const std::uint64_t type = countOf(block.at("type"));
	if (type > std::numeric_limits<std::uint8_t>::max())
		throw Unusable("a cell has an unknown type");
	contents.type = static_cast<std::uint8_t>(type);
	const NumberType of_places = numberTypeOf(block.at("type_of_points").get<std::string>());
	if (of_places != NumberType::float32 && of_places != NumberType::float64)
		throw Unusable("coordinates are of another type");
	contents.places = listOf(lists.at("points"), 3 * grid::byteSize(of_places));
	contents.point_numbers = listOf(lists.at("point_numbers"), sizeof(std::uint32_t));
	contents.ids = listOf(lists.at("ids"), sizeof(std::int32_t));
	contents.cell_numbers = countOf(lists.at("cell_numbers"));
	if (contents.type == 0)
	{
		contents.types = listOf(lists.at("types"), 1);
		contents.ends = listOf(lists.at("ends"), sizeof(std::int32_t));
	}
	if (runs.contains("faces"))
	{
		contents.run_faces = countsOf(arrays, runs.at("faces"));
		contents.run_face_ids = countsOf(arrays, runs.at("face_ids"));
		contents.face_ids = listOf(lists.at("face_ids"), sizeof(std::int32_t));
		contents.face_ends = listOf(lists.at("face_ends"), sizeof(std::int32_t));
		contents.polyhedron_ends = listOf(lists.at("polyhedron_ends"), sizeof(std::int32_t));
	}
	contents.time = countOf(block.at("time"));
	for (const json& array : block.at("arrays"))
		if (array.contains("left_out"))
			checked.arrays_left_out.push_back(leftOutName(array));
		else
			contents.arrays.push_back(arrayOf(array));

	const auto cells = std::make_shared<PackedCells>(std::move(contents));
	grid::WholeGrid whole = wholeOf(block.at("pack"), arrays);
	whole.cell_numbers = cells->cellNumbers();
	if (whole.farthest.empty())
		whole.farthest = cornersOf(cells->runs());
	if (whole.cells != whole.cell_numbers.tuples())
		throw Unusable("its runs do not make up the whole");
	checked.whole = std::make_shared<const grid::WholeGrid>(std::move(whole));
	checked.mesh = CellMesh{cells->points(), cells->cells()};
	checked.fields = cells->fields();
	checked.runs = cells;
}

} // namespace vp::read
