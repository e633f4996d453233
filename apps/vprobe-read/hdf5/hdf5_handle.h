#pragma once

#include "grid/number_types.h"

#include <hdf5.h>

namespace vp::reader::hdf5
{

// Closes what HDF5 has opened. The handle is less than 0 if HDF5 could not open it.
class Handle
{
public:
	Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
	~Handle()
	{
		if (id_ >= 0)
			close_(id_);
	}
	Handle(const Handle&) = delete;
	Handle& operator=(const Handle&) = delete;
	operator hid_t() const { return id_; }

private:
	hid_t id_;
	herr_t (*close_)(hid_t);
};

// Returns the type in which HDF5 delivers numbers on this machine.
inline hid_t nativeType(grid::NumberType type)
{
	using grid::NumberType;
	switch (type)
	{
	case NumberType::int8:
		return H5T_NATIVE_INT8;
	case NumberType::uint8:
		return H5T_NATIVE_UINT8;
	case NumberType::int16:
		return H5T_NATIVE_INT16;
	case NumberType::uint16:
		return H5T_NATIVE_UINT16;
	case NumberType::int32:
		return H5T_NATIVE_INT32;
	case NumberType::uint32:
		return H5T_NATIVE_UINT32;
	case NumberType::int64:
		return H5T_NATIVE_INT64;
	case NumberType::uint64:
		return H5T_NATIVE_UINT64;
	case NumberType::float32:
		return H5T_NATIVE_FLOAT;
	default:
		return H5T_NATIVE_DOUBLE;
	}
}

} // namespace vp::reader::hdf5
