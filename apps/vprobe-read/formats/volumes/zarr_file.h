#pragma once

#include "vprobe-read/hdf5/netcdf_file.h"
#include "zarr_array.h"
#include "zarr_group.h"

#include <map>

namespace vp::reader::volumes
{

// A group of Zarr, or a lone array of it, as a netCDF file: what its JSON says stands in a netCDF file in memory, and
// values are read from its chunks.
class ZarrFile : public hdf5::NetcdfFile
{
public:
	// Throws a Refusal where there is nothing that can be read. `folder`: as it was named.
	ZarrFile(const ZarrGroup& group, const std::string& folder);
	~ZarrFile() override;

	void readSlab(int variable, const std::vector<std::size_t>& starts, const std::vector<std::size_t>& counts,
	              void* to) const override;
	std::optional<arrays::StoredPlace> storedPlace(int variable, const std::vector<std::size_t>& front) const override;
	arrays::StoredPlace placeOfParts(const std::string& words) const override;
	std::vector<std::size_t> chunkOf(int variable) const override { return arrays_.at(variable).chunk(); }
	bool marksUnwritten() const override { return false; }

	/// Returns true if OME-Zarr's attributes say that its arrays are labels.
	bool hasLabels() const { return has_labels_; }

private:
	void addArray(const std::string& name, const ZarrGroup::Array& given);
	std::vector<int> dimensionsOf(const ZarrArray& array, const std::vector<std::string>& names);

	std::string folder_;
	std::map<int, ZarrArray> arrays_; // by their variables
	bool has_labels_ = false;
};

} // namespace vp::reader::volumes
