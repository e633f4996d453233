// Reads data sets of texts, and tables with columns, from HDF5 files.
#include "hdf5_file.h"
#include "hdf5_handle.h"
#include "vprobe-read/base/bytes.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace vp::reader::hdf5
{

namespace
{

// Limits for texts and rows: there are few of them, and none is long.
constexpr hssize_t kMaxRows = 1 << 16;
constexpr std::size_t kMaxBytesOfRow = 1 << 16;

std::string withoutBlanks(const char* text, std::size_t bytes)
{
	std::string words(text, bytes);
	words.resize(std::min(words.find('\0'), words.size()));
	words.resize(words.find_last_not_of(" \t\r\n") + 1);
	return words;
}

// A data set that may be read as a whole, if it exists.
struct Hdf5Rows
{
	Handle set;
	Handle type;
	std::size_t count = 0;

	Hdf5Rows(hid_t file, const std::string& path, bool is_there)
	    : set(is_there ? H5Dopen2(file, path.c_str(), H5P_DEFAULT) : -1, H5Dclose),
	      type(set < 0 ? -1 : H5Dget_type(set), H5Tclose)
	{
		if (is_there && set < 0)
			throw damaged(fmt::format("{} cannot be opened", path));
		const Handle space(set < 0 ? -1 : H5Dget_space(set), H5Sclose);
		const hssize_t points = space < 0 ? 0 : H5Sget_simple_extent_npoints(space);
		if (points < 0 || points > kMaxRows || (type >= 0 && H5Tget_size(type) > kMaxBytesOfRow))
			throw damaged(fmt::format("{} is larger than it can be", path));
		count = type < 0 ? 0 : static_cast<std::size_t>(points);
	}
	bool is(H5T_class_t kind) const { return type >= 0 && H5Tget_class(type) == kind; }
	// Returns -1 if there is no such column.
	int column(const char* name) const { return is(H5T_COMPOUND) ? H5Tget_member_index(type, name) : -1; }
	std::vector<char> read(hid_t as, std::size_t width, const std::string& path) const
	{
		std::vector<char> bytes(count * width);
		if (count > 0 && H5Dread(set, as, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0)
			throw damaged(fmt::format("{} cannot be read", path));
		return bytes;
	}
};

// Returns the type of the column if its values are texts of a fixed length, or numbers.
Handle columnType(const Hdf5Rows& rows, const char* name, bool is_text)
{
	const int at = rows.column(name);
	const hid_t type = at < 0 ? -1 : H5Tget_member_type(rows.type, static_cast<unsigned>(at));
	const H5T_class_t kind = type < 0 ? H5T_NO_CLASS : H5Tget_class(type);
	const bool fits =
	    is_text ? kind == H5T_STRING && H5Tis_variable_str(type) == 0 : kind == H5T_INTEGER || kind == H5T_FLOAT;
	if (type >= 0 && !fits)
		H5Tclose(type);
	return {fits ? type : -1, H5Tclose};
}

// Calls use(NAME, BYTES) for each row of a table with a "name" and a "value" of this type.
template <class Use>
void eachNamed(const Hdf5Rows& rows, const std::string& path, hid_t value_type, Use&& use)
{
	const Handle name_type = columnType(rows, "name", true);
	if (name_type < 0)
		return;
	const std::size_t name_bytes = H5Tget_size(name_type), value_bytes = H5Tget_size(value_type);
	const Handle both(H5Tcreate(H5T_COMPOUND, name_bytes + value_bytes), H5Tclose);
	H5Tinsert(both, "name", 0, name_type);
	H5Tinsert(both, "value", name_bytes, value_type);
	const std::vector<char> bytes = rows.read(both, name_bytes + value_bytes, path);
	for (std::size_t row = 0; row < rows.count; ++row)
	{
		const char* at = bytes.data() + row * (name_bytes + value_bytes);
		use(withoutBlanks(at, name_bytes), at + name_bytes);
	}
}

} // namespace

std::vector<std::string> File::texts(const std::string& path) const
{
	const Hdf5Rows rows(file_, path, has(path));
	std::vector<std::string> all;
	if (!rows.is(H5T_STRING))
		return all;
	const std::size_t width = H5Tget_size(rows.type);
	const std::vector<char> bytes = rows.read(rows.type, width, path);
	const bool is_variable = H5Tis_variable_str(rows.type) > 0;
	for (std::size_t row = 0; row < rows.count; ++row)
	{
		const char* at = bytes.data() + row * width;
		char* elsewhere = nullptr;
		if (is_variable)
			std::memcpy(&elsewhere, at, sizeof elsewhere);
		all.push_back(!is_variable ? withoutBlanks(at, width)
		                           : withoutBlanks(elsewhere ? elsewhere : "", elsewhere ? std::strlen(elsewhere) : 0));
		H5free_memory(elsewhere);
	}
	return all;
}

std::map<std::string, double> File::namedNumbers(const std::string& path) const
{
	const Hdf5Rows rows(file_, path, has(path));
	std::map<std::string, double> all;
	if (columnType(rows, "value", false) >= 0)
		eachNamed(rows, path, H5T_NATIVE_DOUBLE,
		          [&](std::string name, const char* at) { all[std::move(name)] = numberAt<double>(at); });
	return all;
}

std::map<std::string, std::string> File::namedTexts(const std::string& path) const
{
	const Hdf5Rows rows(file_, path, has(path));
	std::map<std::string, std::string> all;
	const Handle type = columnType(rows, "value", true);
	if (type >= 0)
		eachNamed(rows, path, type,
		          [&](std::string name, const char* at)
		          { all[std::move(name)] = withoutBlanks(at, H5Tget_size(type)); });
	return all;
}

double File::columnOr(const std::string& path, const char* column, double otherwise) const
{
	const Hdf5Rows rows(file_, path, has(path));
	if (rows.count == 0 || columnType(rows, column, false) < 0)
		return otherwise;
	const Handle one(H5Tcreate(H5T_COMPOUND, sizeof(double)), H5Tclose);
	H5Tinsert(one, column, 0, H5T_NATIVE_DOUBLE);
	const std::vector<char> bytes = rows.read(one, sizeof(double), path);
	return numberAt<double>(bytes.data());
}

} // namespace vp::reader::hdf5
