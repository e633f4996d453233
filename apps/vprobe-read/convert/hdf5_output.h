#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace vp::reader::convert
{

// Functions that write into HDF5 files. All throw NoRoom if HDF5 cannot write.

hid_t checked(hid_t id);

// Closes what HDF5 opened.
class Handle
{
public:
	Handle(hid_t id, herr_t (*close)(hid_t)) : id_(checked(id)), close_(close) {}
	Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
	~Handle()
	{
		if (id_ >= 0)
			close_(id_);
	}
	// Writes the data that are still in memory. There may be no room for them.
	void close();
	Handle(const Handle&) = delete;
	Handle& operator=(const Handle&) = delete;
	operator hid_t() const { return id_; }

private:
	hid_t id_;
	herr_t (*close_)(hid_t);
};

// Returns the type in memory of the numbers of a VTK array, or -1 for texts and bits.
hid_t typeOf(int vtk_type);

// Returns a name for an array that no other one in the group has: without the characters that HDF5 takes for a way to
// another group, and with a number behind it where another array has become the same.
std::string nameInGroup(hid_t group, const std::string& name);

// Makes a group that keeps the order in which its arrays are written.
Handle groupInOrder(hid_t parent, const char* name);

template <class Number, std::size_t N>
void writeAttribute(hid_t group, const char* name, hid_t type, const std::array<Number, N>& numbers)
{
	const hsize_t size = N;
	const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
	const Handle attribute(H5Acreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
	checked(H5Awrite(attribute, type, numbers.data()));
}

// Writes an attribute, whose text is not empty.
void writeText(hid_t group, const char* name, const std::string& text);

void writeValues(hid_t group, const char* name, hid_t type, const std::vector<hsize_t>& sides, const void* values);

// A list of rows that is written from its beginning to its end, in one piece of the file.
class RowWriter
{
public:
	// sides: those of the whole list, the number of rows first.
	RowWriter(hid_t group, const char* name, hid_t type, std::vector<hsize_t> sides);

	void append(const void* values, hsize_t rows);

private:
	hid_t type_;
	std::vector<hsize_t> sides_;
	Handle space_;
	Handle set_;
	hsize_t written_ = 0;
};

} // namespace vp::reader::convert
