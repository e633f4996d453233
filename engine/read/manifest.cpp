#include "read/manifest.h"

#include "base/ids.h"
#include "base/input_files.h"
#include "read/check_curved.h"
#include "read/check_mesh.h"
#include "read/collapsed_cells.h"
#include "read/manifest_values.h"
#include "read/packed_block.h"
#include "read/placed_cells.h"
#include "read/protocol.h"
#include "read/stored_array.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>

namespace vp::read
{

namespace
{

using grid::NumberType;
using nlohmann::json;

constexpr std::size_t kMaxWarnings = 20;

class Checker
{
public:
	Checker(const SharedBytes& arrays, const SharedBytes& cells, ReadableFiles files)
	    : arrays_(arrays), cells_(cells), files_(std::move(files))
	{
	}

	CheckedInput check(const json& manifest)
	{
		CheckedInput input;
		for (const json& time : manifest.at("times"))
			input.times.push_back(finiteOf(time));
		input.time_units = wordsOf(manifest.value("time_units", json("")));
		for (const json& warning : manifest.at("warnings"))
			if (input.warnings.size() < kMaxWarnings)
				input.warnings.push_back(warningOf(warning));
		for (const json& file : manifest.value("files", json::array()))
			input.files.push_back(file.get<std::string>());
		input.sandbox = wordsOf(manifest.value("sandbox", json("")));
		if (manifest.contains("levels"))
			input.levels = countOf(manifest.at("levels"));
		input.left_out = countOf(manifest.at("left_out"));
		checkBlocks(manifest.at("blocks"), input);
		for (CheckedBlock& block : input.blocks)
		{
			block.length_units = wordsOf(manifest.value("length_units", json("")));
			block.imaging = imagingOf(manifest);
		}
		checkParts(manifest, input);
		if (!input.parts.empty())
			takeParts(manifest.at("blocks"), input);
		if (input.blocks.empty() && input.parts.empty() && !none_placed_.empty())
			throw Unusable(none_placed_);
		if (manifest.contains("patches"))
			for (const json& patch : manifest.at("patches"))
				input.patches.push_back(checkPatch(patch));
		input.unplaced = unplaced_;
		if (unplaced_ > 0)
			input.warnings.push_back(unplacedWarning(unplaced_));
		return input;
	}

private:
	// Blocks of which no cell has a place are left out, as if the file had others alone.
	void checkBlocks(const json& blocks, CheckedInput& input)
	{
		for (std::size_t b = 0; b < blocks.size(); ++b)
			try
			{
				input.blocks.push_back(blocks.size() > 1 ? checkBlockOfSeveral(blocks[b]) : checkBlock(blocks[b]));
				taken_.push_back(b);
			}
			catch (const NonePlaced& none)
			{
				unplaced_ += none.cells;
				none_placed_ = none.what();
			}
	}

	static void checkParts(const json& manifest, CheckedInput& input)
	{
		input.bytes_read = countOf(manifest.value("bytes_read", json(0u)));
		if (!manifest.contains("parts"))
			return;
		for (const json& whole : manifest.at("wholes"))
			input.wholes.push_back(whole.is_null()
			                           ? WholeLattice{}
			                           : WholeLattice{wordsOf(whole.at("kind")), countOf(whole.at("points"))});
		for (const json& part : manifest.at("parts"))
		{
			input.parts.push_back({countOf(part.at("cells")), countOf(part.at("block"))});
			if (input.parts.back().block >= input.wholes.size())
				throw Unusable("a part is of no block");
		}
	}

	void takeParts(const json& blocks, CheckedInput& input) const
	{
		for (std::size_t b = 0; b < input.blocks.size(); ++b)
		{
			input.blocks[b].part = countOf(blocks.at(taken_[b]).at("part"));
			if (input.blocks[b].part >= input.parts.size() ||
			    (b > 0 && input.blocks[b].part < input.blocks[b - 1].part))
				throw Unusable("the parts of blocks are out of order");
		}
	}

	// Which of the file's cells each cell is part of.
	void checkSources(const json& lists, CellMesh& mesh)
	{
		const std::size_t cells = mesh.cells.types.size();
		mesh.source_cell_count = countOf(lists.at("source_cell_count"));
		mesh.cells.source_points = countOf(lists.at("source_point_count"));
		if (mesh.source_cell_count > cells || mesh.cells.source_points > mesh.points.size())
			throw Unusable("a file has more cells or points than were made of it");
		mesh.cells.source_cells = numbersOf<std::int64_t>(cells_, lists.at("source_cells"), NumberType::int64, cells);
		checkSourceCells(mesh.cells.source_cells, mesh.source_cell_count);
	}

	grid::IdArray idsOf(const json& array) const
	{
		if (array.at("type").get_ref<const std::string&>() == "int32")
			return numbersOf<std::int32_t>(cells_, array, NumberType::int32);
		return numbersOf<std::int64_t>(cells_, array, NumberType::int64);
	}

	CellMesh cellMeshOf(const json& block)
	{
		CellMesh mesh;
		mesh.points = coordinatesOf(cells_, block.at("coordinates"));
		const json& lists = block.at("cells");
		mesh.cells.types = numbersOf<std::uint8_t>(cells_, lists.at("types"), NumberType::uint8);
		const std::size_t cells = mesh.cells.types.size();
		if (cells == 0 || cells >= kMaxBlockIds)
			throw Unusable(fmt::format("a block of {} cells cannot be held", cells));
		if (lists.contains("offsets"))
			mesh.cells.offsets = numbersOf<std::int64_t>(cells_, lists.at("offsets"), NumberType::int64, cells + 1);
		mesh.cells.connectivity = idsOf(lists.at("connectivity"));
		if (lists.contains("face_offsets"))
		{
			mesh.cells.face_offsets =
			    numbersOf<std::int64_t>(cells_, lists.at("face_offsets"), NumberType::int64, cells + 1);
			mesh.cells.face_stream = numbersOf<std::int64_t>(cells_, lists.at("face_stream"), NumberType::int64);
		}
		mesh.curved = lists.contains("curved");
		checkCells(mesh.cells, mesh.points.size(), mesh.curved);
		orderCollapsed(mesh.cells);
		if (lists.contains("degrees"))
			mesh.degrees = numbersOf<std::int32_t>(cells_, lists.at("degrees"), NumberType::int32, 3 * cells);
		if (lists.contains("weights"))
			mesh.weights = numbersOf<double>(cells_, lists.at("weights"), NumberType::float64, mesh.points.size());
		if (mesh.curved)
			checkCurvedCells(mesh);
		if (lists.contains("source_cells"))
			checkSources(lists, mesh);
		return mesh;
	}

	grid::PatchPolygons checkPatch(const json& patch) const
	{
		grid::PatchPolygons polygons{wordsOf(patch.at("name")), coordinatesOf(cells_, patch.at("coordinates")),
		                             numbersOf<std::int64_t>(cells_, patch.at("starts"), NumberType::int64),
		                             numbersOf<std::int64_t>(cells_, patch.at("corners"), NumberType::int64)};
		checkPolygons(polygons);
		removeUnplaced(polygons);
		return polygons;
	}

	static std::array<std::uint32_t, 3> latticeOfBlock(const json& block)
	{
		const json& points = block.at("points");
		if (!points.is_array() || points.size() != 3)
			throw Unusable("a lattice does not have three axes");
		return latticeOf({countOf(points[0]), countOf(points[1]), countOf(points[2])});
	}

	// Sets the mesh, and how many tuples its point and cell arrays have.
	void checkMesh(const json& block, CheckedBlock& checked, std::uint64_t& points, std::uint64_t& cells)
	{
		const std::string kind = block.at("kind").get<std::string>();
		if (kind == "unstructured")
		{
			CellMesh mesh = cellMeshOf(block);
			points = mesh.points.size();
			cells = mesh.cells.source_cells.empty() ? mesh.cells.types.size() : mesh.source_cell_count;
			if (block.contains("points"))
			{
				checked.hidden_lattice = grid::Lattice(latticeOfBlock(block));
				checkLattice(*checked.hidden_lattice, mesh.points.size(), mesh.cells);
			}
			const std::size_t unplaced = leaveOutUnplaced(mesh);
			if (block.contains("pack"))
			{
				grid::WholeGrid whole = wholeOf(block.at("pack"), arrays_);
				whole.cell_numbers.type = NumberType::int64;
				whole.cell_numbers.bytes =
				    bytesOfType(cells_, block.at("pack").at("numbers"), NumberType::int64, mesh.cells.size());
				checked.whole = std::make_shared<const grid::WholeGrid>(std::move(whole));
			}
			unplaced_ += checked.whole ? countOf(block.at("pack").at("cells_without_place")) : unplaced;
			checked.mesh = std::move(mesh);
			return;
		}

		std::array<std::uint32_t, 3> lattice;
		if (kind == "image")
		{
			lattice = latticeOfBlock(block);
			const Vec3 origin = vectorOf(block.at("origin"));
			const Vec3 spacing = vectorOf(block.at("spacing"));
			checkImage(lattice, origin, spacing);
			checked.mesh = grid::UniformGrid(lattice, origin, spacing);
		}
		else if (kind == "rectilinear")
		{
			std::array<Array<double>, 3> axes;
			for (int axis = 0; axis < 3; ++axis)
			{
				axes[axis] = numbersOf<double>(arrays_, block.at("axes").at(static_cast<std::size_t>(axis)),
				                               NumberType::float64);
				checkAxis(axes[axis]);
			}
			lattice = latticeOf({axes[0].size(), axes[1].size(), axes[2].size()});
			checked.mesh = grid::RectilinearGrid(axes[0], axes[1], axes[2]);
		}
		else if (kind == "curvilinear")
		{
			lattice = latticeOfBlock(block);
			const std::uint64_t wanted = std::uint64_t(lattice[0]) * lattice[1] * lattice[2];
			unplaced_ += takePlacedLattice(lattice, coordinatesOf(arrays_, block.at("coordinates"), wanted), checked);
		}
		else
			throw Unusable("a block is of an unknown kind");
		points = std::uint64_t(lattice[0]) * lattice[1] * lattice[2];
		cells = std::uint64_t(lattice[0] - 1) * (lattice[1] - 1) * (lattice[2] - 1);
	}

	CheckedBlock checkBlock(const json& block)
	{
		CheckedBlock checked;
		std::uint64_t points = 0;
		std::uint64_t cells = 0;
		checked.name = wordsOf(block.at("name"));
		if (block.at("kind") == "packed")
		{
			takePackedBlock(block, arrays_, files_, checked);
			unplaced_ += countOf(block.at("pack").at("cells_without_place"));
			return checked;
		}
		checkMesh(block, checked, points, cells);
		for (const json& array : block.at("arrays"))
		{
			if (array.contains("left_out"))
			{
				checked.arrays_left_out.push_back(leftOutName(array));
				continue;
			}
			grid::Field field;
			field.name = wordsOf(array.at("name"));
			field.units = wordsOf(array.value("units", json("")));
			field.association = associationOf(array.at("association"));
			field.components = componentsOf(array.at("components"), field.name);
			field.type = numberTypeOf(array.at("type").get<std::string>());
			if (array.contains("stored"))
				field.stored = storedArray(array.at("stored"), field, checked.mesh, arrays_, files_);
			else
				field.bytes = bytesOf(arrays_, array, field.type,
				                      static_cast<std::uint64_t>(field.components) *
				                          (field.association == grid::Association::point ? points : cells));
			if (array.contains("facts"))
				field.facts = factsOf(array.at("facts"), field.components);
			checked.fields.push_back(std::move(field));
		}
		return checked;
	}

	CheckedBlock checkBlockOfSeveral(const json& block)
	{
		try
		{
			return checkBlock(block);
		}
		catch (const NonePlaced&)
		{
			throw;
		}
		catch (const Unusable& unusable)
		{
			throw Unusable(fmt::format("in {}: {}", wordsOf(block.at("name")), unusable.what()));
		}
	}

	const SharedBytes& arrays_;
	const SharedBytes& cells_;
	ReadableFiles files_;
	std::vector<std::size_t> taken_{}; // places in the manifest of the blocks that have cells
	std::size_t unplaced_ = 0;         // cells left out, since a point has no place
	std::string none_placed_{};        // why the last block without cells has none
};

} // namespace

std::array<std::uint32_t, 3> latticeOf(const std::array<std::uint64_t, 3>& points)
{
	std::uint64_t product = 1;
	for (const std::uint64_t n : points)
	{
		if (n < 2)
			throw Unusable("a lattice has no cells");
		if (__builtin_mul_overflow(product, n, &product) || product >= kMaxBlockIds)
			throw Unusable(
			    fmt::format("a block of {} x {} x {} points is too large; split it", points[0], points[1], points[2]));
	}
	return {static_cast<std::uint32_t>(points[0]), static_cast<std::uint32_t>(points[1]),
	        static_cast<std::uint32_t>(points[2])};
}

void checkImage(const std::array<std::uint32_t, 3>& points, const Vec3& origin, const Vec3& spacing)
{
	for (int axis = 0; axis < 3; ++axis)
		if (spacing[axis] == 0.0 || !isPlace(origin[axis]) || !isPlace(origin[axis] + spacing[axis] * points[axis]))
			throw Unusable("the spacing of an image is zero or too large, or its origin is");
}

void checkField(const grid::Field& field, std::uint64_t points, std::uint64_t cells)
{
	if (field.components < 1 || field.components > kMaxComponents)
		throw Unusable(fmt::format("the array {} has {} components", field.name, field.components));
	const std::uint64_t tuples = field.association == grid::Association::point ? points : cells;
	const std::size_t bytes_of_tuple = grid::byteSize(field.type) * static_cast<std::size_t>(field.components);
	if (field.bytes.size() != tuples * bytes_of_tuple)
		throw Unusable(fmt::format("the array {} has {} bytes where {} tuples of {} belong", field.name,
		                           field.bytes.size(), tuples, bytes_of_tuple));
}

void noteFiles(const CheckedInput& input)
{
	for (const std::string& file : input.files)
		noteInput(file);
}

Error unusable(const std::string& file, const Error& error)
{
	if (error.kind != ErrorKind::input)
		return error;
	return {ErrorKind::input, fmt::format("{}: truncated or damaged: {}", file, error.message)};
}

Result<CheckedInput> checkManifest(std::string_view text, const SharedBytes& arrays, const SharedBytes& cells,
                                   const std::string& file, const std::string& follow, const std::string& indexed)
{
	try
	{
		const json manifest = parsedManifest(text);
		if (manifest.at("version") != kProtocolVersion)
			return Error{ErrorKind::internal, "vprobe-read is of another version; install both together"};
		return Checker(arrays, cells, {file, follow, indexed}).check(manifest);
	}
	catch (const Unusable& unusable)
	{
		return Error{ErrorKind::input, unusable.what()};
	}
	catch (const parts::Unreadable& unreadable)
	{
		return Error{ErrorKind::input, unreadable.what()};
	}
	catch (const json::exception&)
	{
		return Error{ErrorKind::input, "the manifest of its arrays cannot be read"};
	}
}

} // namespace vp::read
