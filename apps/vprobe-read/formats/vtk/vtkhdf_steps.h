#pragma once

#include "vprobe-read/hdf5/hdf5_file.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vp::reader::vtk
{

// Which values of a data set of VTKHDF belong to one time. After the specification of VTKHDF 2: all times lie behind
// each other, and the group Steps says where each begins. Data sets without that group have one time.
class VtkHdfStep
{
public:
	// root: the group of the data set. Throws a Refusal where its steps are damaged.
	static std::vector<double> timesOf(const hdf5::File& file, const std::string& root);

	VtkHdfStep(const hdf5::File& file, std::string root, std::optional<std::uint64_t> step)
	    : file_(&file), root_(std::move(root)), step_(step)
	{
	}

	const std::string& root() const { return root_; }
	bool isOneOfSeveral() const { return step_.has_value(); }
	std::uint64_t number() const { return step_.value_or(0); }
	// An entry of a list in Steps; none where there is no such list.
	std::optional<std::uint64_t> entry(const std::string& list) const;
	// Where the values of an array begin. association: "Point" or "Cell".
	std::optional<std::uint64_t> arrayOffset(const std::string& association, const std::string& name) const
	{
		return entry(association + "DataOffsets/" + name);
	}

private:
	const hdf5::File* file_;
	std::string root_;
	std::optional<std::uint64_t> step_;
};

// The parts of an unstructured grid at one time. Lists of all parts follow each other in the file.
struct VtkHdfParts
{
	VtkHdfParts(const hdf5::File& file, const VtkHdfStep& step);

	std::uint64_t first = 0;                       // part
	std::vector<std::uint64_t> points, cells, ids; // a number for each part
	std::uint64_t first_point = 0, first_cell = 0, first_id = 0;
	std::uint64_t all_points = 0, all_cells = 0, all_ids = 0;

	std::size_t count() const { return points.size(); }
};

// Numbers of parts as they are in a list of a data set, from one part on, with their sum checked.
// list: its path in the file.
std::vector<std::uint64_t> vtkHdfCounts(const hdf5::File& file, const std::string& list, std::uint64_t first,
                                        std::uint64_t count);
// Their sum, up to before a part.
std::uint64_t vtkHdfSum(const std::vector<std::uint64_t>& counts, std::size_t end);

} // namespace vp::reader::vtk
