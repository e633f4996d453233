#pragma once

#include "vprobe-read/base/refusal.h"
#include "vprobe-read/hdf5/hdf5_rows.h"
#include "vtkhdf_pack.h"
#include "vtkhdf_steps.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vp::reader::vtk
{

// Cells of a part that follow each other, some 512, with a box of their own.
struct PackRun
{
	std::uint64_t part;
	std::uint64_t first_cell; // in the file, as first_id
	std::uint64_t cells;
	std::uint64_t first_id;
	std::uint64_t ids;
	std::uint64_t first_face; // those of polyhedra
	std::uint64_t faces;
	std::uint64_t first_face_id;
	std::uint64_t face_ids;
};

// The different values of integers, and how often they change.
struct PackedValues
{
	std::vector<double> values{};
	std::uint64_t changes = 0;
	std::uint64_t changes_to_next = 0;
};

// The parts of a pack, a number for each.
struct PackParts
{
	std::vector<std::uint64_t> points, cells;
	std::vector<std::uint64_t> first_ids;               // with which the ids of its points begin
	std::vector<std::uint64_t> first_cells, first_ends; // where it begins in the lists of cells, and in Offsets
	std::uint64_t all_points = 0, all_cells = 0, all_ids = 0, all_ends = 0;
	std::uint64_t all_faces = 0, all_face_ids = 0, all_face_ends = 0;

	std::size_t count() const { return points.size(); }
	// Returns the partition of VTKHDF that a part is in. Each of those before it has one end more than cells.
	std::size_t partitionOf(std::size_t part) const { return first_ends[part] - first_cells[part]; }
};

struct PackedArray
{
	std::string association; // "Point" or "Cell"
	std::string name;
	std::string in_file; // its name there
	std::string units;
	grid::NumberType type = grid::NumberType::float32;
	std::uint64_t components = 1;
	// For each time of the pack:
	std::vector<std::uint64_t> first_rows{};
	std::vector<std::uint64_t> places{}; // where its values begin in the file that an index is of, in place of rows
	bool swaps = false;                  // likewise, whether the bytes of numbers are in the other order there
	std::vector<nlohmann::json> facts{}; // as of protocol.h
};

// Throws a Refusal for a number that is no count of what a file can hold. name: of the attribute or list.
std::uint64_t checkedCount(double count, const char* name);

// Holds what a pack tells of its parts, at all times. Throws a Refusal where it contradicts itself.
class PackIndex
{
public:
	PackIndex(const hdf5::File& file, const VtkHdfPack& pack, const WantsVtkHdfArray& wants);
	~PackIndex();
	PackIndex(const PackIndex&) = delete;
	PackIndex& operator=(const PackIndex&) = delete;

	std::uint64_t allPoints() const { return all_points_; } // each once
	const std::vector<PackRun>& runs() const { return runs_; }
	const std::vector<std::array<double, 6>>& boxes() const { return boxes_; } // one for each run
	const std::vector<PackedArray>& arrays() const { return arrays_; }         // that are wanted
	// Returns the points that are farthest from the center, empty if the file does not say them.
	const std::vector<std::array<double, 3>>& farthest() const { return farthest_; }
	// Returns the type of all cells, or 0 if they have several, or another number of points than it should have.
	std::uint8_t typeOfAll() const;
	bool hasPolyhedra() const;
	const PackParts& parts() const { return parts_; }

	// Returns a list of VTKHDF ("Points"), or one of ours ("own/PointNumbers"), that has so many rows.
	hdf5::Rows rowsOf(const std::string& list, grid::NumberType type, std::uint64_t rows,
	                  std::uint64_t components = 1) const;
	// Returns what an index knows its file by (read::SourceStamp), nothing if this is a pack.
	const std::vector<std::uint64_t>& source() const { return source_; }
	// Returns the values of an array of a pack at a time, which has a number from 0.
	hdf5::Rows rowsOf(const PackedArray& array, std::size_t time) const;
	// Returns the ranges of these values in each run (read::bytesOfRanges()); nothing if the pack has none.
	std::optional<hdf5::Rows> rangesOf(const PackedArray& array, std::size_t time) const;
	std::size_t times() const { return steps_.size(); }
	std::size_t time() const { return time_; } // the one that was asked for
	grid::NumberType typeOfPoints() const;

	// Returns the "pack" of its block (protocol.h), with what manifest::Writer::addPack() wants beside it, if all runs
	// were read.
	nlohmann::json facts(std::uint64_t bytes_read) const;
	// The same if some are read later. Cells that nobody sees count with the first run.
	nlohmann::json factsOfRuns(std::size_t begin, std::size_t end) const;

private:
	template <class Row>
	std::vector<Row> allRows(const std::string& name, grid::NumberType type, std::uint64_t size) const
	{
		const hdf5::Rows rows(file_, descriptor_, own_ + "/" + name, type);
		if (rows.size() != size || rows.rowBytes() != sizeof(Row))
			throw damaged("its " + name + " do not match its cells");
		std::vector<Row> values(size);
		rows.read(0, size, values.data());
		return values;
	}
	void listParts();
	void listRuns();
	void listFarthest();
	void refuseMovingGrid() const;
	void listArrays(const std::string& association, const WantsVtkHdfArray& wants);
	std::vector<std::string> namesOfArrays(const std::string& association) const;
	PackedArray arrayOf(const std::string& association, const std::string& in_file) const;
	void takeRows(PackedArray& array) const;
	void takePlaces(PackedArray& array) const;
	std::vector<nlohmann::json> factsOf(const std::string& association, const std::string& name,
	                                    std::uint64_t components) const;
	std::vector<PackedValues> valuesOf(const std::string& path) const;
	std::uint64_t countOf(const char* name) const;
	nlohmann::json factsOf(std::span<const std::array<double, 6>> boxes) const;

	const hdf5::File& file_;
	std::string root_, own_;         // its groups
	std::vector<std::size_t> steps_; // the file's, in the order of their times
	std::size_t time_;               // among them
	int descriptor_;
	VtkHdfParts partitions_;
	PackParts parts_;
	std::uint64_t all_points_ = 0;
	std::uint64_t all_cells_ = 0;
	std::vector<PackRun> runs_;
	std::vector<std::array<double, 6>> boxes_;
	std::vector<std::array<double, 3>> farthest_;
	std::vector<std::uint64_t> source_;
	std::vector<PackedArray> arrays_;
};

} // namespace vp::reader::vtk
