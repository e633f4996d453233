#pragma once

#include "cf_values.h"
#include "cf_volumes.h"
#include "vprobe-read/arrays/stored_place.h"
#include "vprobe-read/arrays/value_image.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

class vtkDataArray;

namespace vp::reader::volumes
{

// Values in the order of a file become values with x running fastest, then y, then z. sides: the dimensions along x, y
// and z; the later one runs faster in the file. lengths: along x, y and z.
vtkSmartPointer<vtkDataArray> withXFastest(vtkSmartPointer<vtkDataArray> array, const std::array<std::size_t, 3>& sides,
                                           const std::array<std::size_t, 3>& lengths);

// Returns where a slab of a variable stays that CfParts reads. Nothing if it cannot stay there: the type of its values
// depends on them (cfTypeMeant()), or its chunks are too large.
std::optional<arrays::StoredPlace> cfStoredPlace(const hdf5::NetcdfFile& file, const CfVolume& volume,
                                                 const CfSlab& slab, const std::array<std::size_t, 3>& lengths);

// Parts of a variable on a lattice, with its values as they are meant.
class CfParts
{
public:
	// words: what cfStoredPlace() says behind the name of the reader. Throws a Refusal if they do not fit the file.
	CfParts(std::unique_ptr<hdf5::NetcdfFile> file, const std::string& words);

	// Reads a part by its number. Any thread may call it. While netCDF reads, they wait for each other.
	void read(std::uint64_t number, std::span<std::byte> to) const;

private:
	std::unique_ptr<hdf5::NetcdfFile> file_;
	int variable_ = -1;
	CfMeaning meaning_;
	CfSlab slab_;                                             // all of it
	std::array<std::size_t, 3> sides_{}, lengths_{}, part_{}; // along x, y, z
	static std::mutex one_at_a_time_;
};

} // namespace vp::reader::volumes
