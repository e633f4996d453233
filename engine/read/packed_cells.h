#pragma once

#include "base/array.h"
#include "base/sparse_memory.h"
#include "grid/cell_list.h"
#include "grid/cell_runs.h"
#include "grid/field.h"
#include "grid/points.h"
#include "parts/file_extents.h"
#include "read/paged_values.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace vp::read
{

// The cells of a pack (docs/FORMATS.md), whose lists lie in its file as they are. This process reads rows of them:
// plain numbers, which no library parses, and which are checked before they are used. If the pack is the index of
// another file, values of arrays that lie there as plain numbers are read from that one, in pages.
class PackedCells : public grid::CellRuns
{
public:
	// A list of rows in the file.
	struct List
	{
		std::uint64_t offset = 0;
		std::size_t row_bytes = 0;
	};
	// The values of all points or cells at a time.
	struct ValueList
	{
		std::uint64_t offset = 0;
		// Where the ranges of the values in each run lie, if the file tells them: RunRanges of docs/FORMATS.md.
		std::optional<std::uint64_t> ranges{};
		std::shared_ptr<const grid::ArrayFacts> facts{};
	};
	struct ArrayLists
	{
		grid::Field field; // without bytes and facts
		std::size_t row_bytes = 0;
		bool is_in_source = false; // its rows are those of `source`, in its order
		bool swaps = false;        // whether the bytes of numbers there are in the other order
		std::vector<ValueList> times{};

		List at(std::size_t time) const { return {times[time].offset, row_bytes}; }
	};
	// The file in its own words. Nothing of it is checked.
	struct Contents
	{
		std::shared_ptr<const parts::OpenFile> file{};
		std::shared_ptr<const parts::OpenFile> source{}; // if the file is its index; else null
		std::vector<Run> runs{};                         // with ascending parts
		std::optional<Range> own{};                      // those of this process; all if it is missing
		std::vector<std::uint64_t> run_ids{};            // point ids in each run
		std::vector<std::uint64_t> all_cells{};          // for each part, with those that have no run
		// For each part its points, the id with which they begin, and the row in the list of ends where it begins.
		std::vector<std::uint64_t> points{}, first_ids{}, first_ends{};
		std::uint64_t all_points = 0;   // those of several parts count once
		std::uint8_t type = 0;          // that all cells have; 0 if they have several
		List places{};                  // three floats or doubles a point
		List point_numbers{};           // uint32: in the whole
		List ids{};                     // int32: of points of the part
		std::uint64_t cell_numbers = 0; // offset; uint32: in the file that was packed
		List types{};                   // uint8; only if cells have several types
		List ends{};                    // int32, likewise: one more than cells
		// Where some cells are polyhedra. Each has faces of its own, which follow each other.
		std::vector<std::uint64_t> run_faces{}, run_face_ids{}; // for each run its faces, and the ids of their points
		List face_ids{};                                        // int32: of points of the part
		List face_ends{};                                       // int32: where the ids of each face end
		List polyhedron_ends{};                                 // int32: where the faces of each cell end
		std::vector<ArrayLists> arrays{};                       // all with as many times
		std::size_t time = 0;                                   // whose values are wanted
	};

	// Throws Unusable if the lists cannot be, or do not lie in the file.
	explicit PackedCells(Contents contents);

	// Views of the memory into which fetch() reads.
	grid::Points points() const;
	grid::CellList cells() const;
	// Numbers that stay in the file until somebody asks for them.
	grid::Field cellNumbers() const;
	std::vector<grid::Field> fields() const;

	std::vector<std::uint32_t> holding(const grid::Field& field, int component, double value) const override;
	std::size_t times() const override;
	void goTo(std::size_t time, std::optional<std::size_t> next, grid::Block& block) override;
	std::shared_ptr<const grid::ArrayFacts> factsAt(std::size_t time, const grid::Field& field) const override;
	void fetch(std::span<const std::uint32_t> runs) override;
	std::uint64_t bytesAfter(std::span<const std::uint32_t> runs) const override;
	void renew(grid::Block& block) const override;
	std::span<const std::uint32_t> pointsOf(std::uint32_t part) const override;
	parts::PartUse use() const override;
	void startCounting() override;

private:
	struct Part
	{
		std::uint64_t first_point = 0;
		std::uint64_t points = 0;
		std::uint64_t first_cell = 0;
	};
	// Runs that follow each other in a part.
	struct Piece
	{
		std::uint32_t first_run = 0;
		std::uint32_t runs = 0;
		std::uint64_t first_cell = 0;
		std::uint64_t cells = 0;
		std::uint64_t first_id = 0;
		std::uint64_t ids = 0;
	};
	// Where the faces of a run begin: among all, with their ids, and in memory, where each cell and face has a number
	// in front.
	struct FirstFace
	{
		std::uint64_t face = 0;
		std::uint64_t id = 0;
		std::uint64_t in_memory = 0;
	};
	// Runs and parts that are in memory.
	struct Kept
	{
		std::vector<bool> runs, parts;
	};
	// Runs and parts that are not, and the pieces that the runs make up.
	struct Missing
	{
		std::vector<std::uint32_t> runs{}, parts{};
		std::vector<Piece> pieces{};
	};
	// Bytes in the file for each point, cell and id.
	struct RowBytes
	{
		std::size_t point = 0;
		std::size_t cell = 0;
		std::size_t id = 0;
		std::size_t face = 0;
		std::size_t face_id = 0;
	};
	// The ranges of an array's values in each run, at the time that is wanted.
	struct Ranges
	{
		std::vector<float> ends{};       // for each run and column the least and the greatest
		std::vector<bool> are_checked{}; // for each run
	};
	using Memory = std::shared_ptr<SparseMemory>;
	using Extents = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

	bool isAlike() const { return contents_.type != 0; }
	bool hasFaces() const { return !contents_.run_faces.empty(); }
	void check();
	void checkFaces(std::uint64_t ends);
	void takeMemory();
	void takeMemoryOfValues();
	Kept nothing() const { return {std::vector<bool>(runs().size()), std::vector<bool>(contents_.points.size())}; }
	Missing missing(std::span<const std::uint32_t> runs, const Kept& kept) const;
	std::vector<Piece> piecesOf(std::span<const std::uint32_t> runs) const;
	void addCells(const Missing& missing, Extents& to) const;
	void addValues(const Missing& missing, std::size_t time, Extents& to) const;
	void announce(Extents extents) const;
	void announceNextTime();
	bool isIndex() const { return contents_.source != nullptr; }
	void readInPlace(const Missing& missing);
	void readSourceCells(const Piece& piece) const;
	void copyCellValues(const Piece& piece) const;
	std::uint64_t bytesInPlaceAfter(const std::vector<bool>& values) const;
	void readRows(const List& list, std::uint64_t first, std::uint64_t count, void* to) const;
	void readCells(const Missing& missing);
	void readValues(const Missing& missing);
	void readPoints(std::uint32_t part) const;
	void readPointValues(std::uint32_t part) const;
	void takePoints(const List& list, std::size_t number_bytes, std::uint32_t part, const Memory& there,
	                const Memory& to) const;
	void notePoints(std::uint32_t part, const Memory& there) const;
	void readPiece(const Piece& piece) const;
	void readCellValues(const Piece& piece) const;
	parts::Unreadable damaged(const char* reason) const;
	std::uint64_t firstEndOf(std::uint32_t run) const;
	std::uint64_t firstFaceEndOf(std::uint32_t run) const;
	void takeTypes(const Piece& piece) const;
	void takeIds(std::uint32_t run, std::span<std::int32_t> ids) const;
	void takeFaces(std::uint32_t run) const;
	std::uint64_t bytesOfPart(std::uint32_t part, const RowBytes& rows) const;
	std::uint64_t bytesOfRun(std::uint32_t run, const RowBytes& rows) const;
	std::uint64_t bytesOf(const std::vector<bool>& runs, const RowBytes& rows) const;
	void note(const Missing& read, const RowBytes& rows, Kept& kept);
	std::optional<std::size_t> arrayOf(const grid::Field& field) const;
	const Ranges* rangesOf(std::size_t array) const;
	void checkRanges(std::span<const std::uint32_t> runs);
	void checkRange(std::size_t array, std::uint32_t run, std::span<const float> ends) const;

	Contents contents_;
	std::vector<Part> parts_;
	std::vector<std::uint64_t> first_ids_; // for each run
	std::vector<FirstFace> first_faces_;   // likewise, and behind the last
	std::uint64_t cells_ = 0, ids_ = 0;    // in all runs
	std::uint64_t all_rows_ = 0;           // cells, with those that have no run
	RowBytes rows_of_cells_, rows_of_values_;
	RowBytes rows_in_place_;               // those of values in the file that an index is of
	std::optional<std::size_t> next_time_; // that is asked for when the values of this one were read

	Memory places_, point_numbers_, id_memory_, types_, ends_;
	Memory first_of_faces_, face_stream_; // those of grid::CellList
	std::vector<Memory> arrays_;
	Memory source_cells_;                             // for each cell its number in the file that an index is of
	std::vector<std::unique_ptr<PagedValues>> paged_; // for each array the values there, or null
	Memory has_point_, has_values_of_; // a bit for each point: it was read by an earlier fetch, and so were its values
	Kept has_cells_, has_values_;      // values of nothing without cells
	std::vector<bool> met_;
	mutable std::mutex ranges_mutex_;
	mutable std::map<std::size_t, Ranges> ranges_; // by the array; those that somebody asked for
	std::uint64_t read_ = 0, bytes_read_ = 0;
};

} // namespace vp::read
