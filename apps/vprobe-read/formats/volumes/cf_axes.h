#pragma once

#include "vprobe-read/hdf5/netcdf_file.h"

namespace vp::reader::volumes
{

// The quantity that runs along a dimension, after the CF conventions, section 4.
enum class CfRole
{
	none,
	x,
	y,
	z,
	time
};

// By the attributes of a coordinate variable: `axis`, `units`, `standard_name` and `positive`.
CfRole cfRoleOf(const hdf5::NetcdfFile& file, int variable);
// By its name, for a dimension whose coordinates have no such attributes, or that has none.
CfRole cfRoleOfName(const std::string& name);
// Whether values that differ by 360 mean the same.
bool isLongitude(const hdf5::NetcdfFile& file, int variable);

struct CfDimension
{
	std::string name;
	std::size_t length = 0;
	int coordinate = -1; // the variable with its places; -1 where it has none
	CfRole role = CfRole::none;
};

CfDimension cfDimension(const hdf5::NetcdfFile& file, const std::string& name, std::size_t length);

} // namespace vp::reader::volumes
