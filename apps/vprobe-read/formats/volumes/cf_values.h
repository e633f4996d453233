#pragma once

#include "vprobe-read/hdf5/netcdf_file.h"

#include "grid/field.h"

#include <vtkSmartPointer.h>

#include <functional>
#include <optional>
#include <vector>

class vtkDataArray;

namespace vp::reader::volumes
{

// VTK's type for the numbers of a variable; 0 where it holds none.
int cfTypeOf(const hdf5::NetcdfFile& file, int variable);

// Turns values as they are stored in a variable into those that are meant: missing ones are NaN, packed ones are
// unpacked. It stays the same array where nothing is missing or packed. After the CF conventions, sections 2.5.1 and
// 8.1; `_Unsigned` after the NetCDF Users Guide. Any thread may call it: it needs the file no more.
using CfMeaning = std::function<vtkSmartPointer<vtkDataArray>(vtkSmartPointer<vtkDataArray> stored)>;
CfMeaning cfMeaning(const hdf5::NetcdfFile& file, int variable);

// Returns the type of the values that cfMeaning() makes. Nothing if it depends on the values: whole numbers that are
// not packed become floats where some are missing.
std::optional<grid::NumberType> cfTypeMeant(const hdf5::NetcdfFile& file, int variable);

// Returns true if cfMeaning() changes nothing, whatever the values are: none is packed, and nothing but NaN marks
// missing ones.
bool cfIsPlain(const hdf5::NetcdfFile& file, int variable);

// A part of a variable: where it begins along each dimension, and how many values it has there.
struct CfSlab
{
	std::vector<std::size_t> starts, counts;

	// All of a variable, or what it has at one index of one dimension.
	static CfSlab of(const hdf5::NetcdfFile& file, int variable);
	void fix(std::size_t dimension, std::size_t index);
	std::size_t count() const; // throws a Refusal for more than there can be
};

// Returns values in the order of the file: as they are stored, or as they are meant.
vtkSmartPointer<vtkDataArray> cfStored(const hdf5::NetcdfFile& file, int variable, const CfSlab& slab);
vtkSmartPointer<vtkDataArray> cfArray(const hdf5::NetcdfFile& file, int variable, const CfSlab& slab);
std::vector<double> cfNumbers(const hdf5::NetcdfFile& file, int variable, const CfSlab& slab);
std::vector<double> cfNumbers(const hdf5::NetcdfFile& file, int variable);

} // namespace vp::reader::volumes
