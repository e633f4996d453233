#include "hdf5_output.h"

#include "vprobe-read/base/refusal.h"

#include <vtkType.h>

namespace vp::reader::convert
{

hid_t checked(hid_t id)
{
	if (id < 0)
		throw NoRoom(kNoRoom);
	return id;
}

void Handle::close()
{
	if (close_(std::exchange(id_, -1)) < 0)
		throw NoRoom(kNoRoom);
}

hid_t typeOf(int vtk_type)
{
	switch (vtk_type)
	{
	case VTK_CHAR:
	case VTK_SIGNED_CHAR:
		return H5T_NATIVE_SCHAR;
	case VTK_UNSIGNED_CHAR:
		return H5T_NATIVE_UCHAR;
	case VTK_SHORT:
		return H5T_NATIVE_SHORT;
	case VTK_UNSIGNED_SHORT:
		return H5T_NATIVE_USHORT;
	case VTK_INT:
		return H5T_NATIVE_INT;
	case VTK_UNSIGNED_INT:
		return H5T_NATIVE_UINT;
	case VTK_LONG:
	case VTK_LONG_LONG:
	case VTK_ID_TYPE:
		return H5T_NATIVE_LLONG;
	case VTK_UNSIGNED_LONG:
	case VTK_UNSIGNED_LONG_LONG:
		return H5T_NATIVE_ULLONG;
	case VTK_FLOAT:
		return H5T_NATIVE_FLOAT;
	case VTK_DOUBLE:
		return H5T_NATIVE_DOUBLE;
	default:
		return -1;
	}
}

std::string nameInGroup(hid_t group, const std::string& name)
{
	std::string plain = name;
	for (char& c : plain)
		if (c == '/' || c == '.')
			c = '_';
	std::string free = plain;
	for (int number = 2; H5Lexists(group, free.c_str(), H5P_DEFAULT) > 0; ++number)
		free = plain + "_" + std::to_string(number);
	return free;
}

Handle groupInOrder(hid_t parent, const char* name)
{
	const Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
	checked(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
	return {H5Gcreate2(parent, name, H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose};
}

void writeText(hid_t group, const char* name, const std::string& text)
{
	const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
	H5Tset_size(type, text.size());
	const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
	const Handle attribute(H5Acreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
	checked(H5Awrite(attribute, type, text.c_str()));
}

void writeValues(hid_t group, const char* name, hid_t type, const std::vector<hsize_t>& sides, const void* values)
{
	const Handle space(H5Screate_simple(static_cast<int>(sides.size()), sides.data(), nullptr), H5Sclose);
	const Handle set(H5Dcreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
	checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
}

RowWriter::RowWriter(hid_t group, const char* name, hid_t type, std::vector<hsize_t> sides)
    : type_(type), sides_(std::move(sides)),
      space_(H5Screate_simple(static_cast<int>(sides_.size()), sides_.data(), nullptr), H5Sclose),
      set_(H5Dcreate2(group, name, type, space_, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose)
{
}

void RowWriter::append(const void* values, hsize_t rows)
{
	if (rows == 0)
		return;
	std::vector<hsize_t> begin(sides_.size(), 0), count(sides_);
	begin[0] = std::exchange(written_, written_ + rows);
	count[0] = rows;
	const Handle part(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
	checked(H5Sselect_hyperslab(space_, H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr));
	checked(H5Dwrite(set_, type_, part, space_, H5P_DEFAULT, values));
}

} // namespace vp::reader::convert
