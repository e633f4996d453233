#include "hdf5_file.h"

#include "hdf5_parts.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::reader::hdf5
{

namespace
{

herr_t addName(hid_t, const char* name, const H5L_info_t*, void* names)
{
	static_cast<std::vector<std::string>*>(names)->emplace_back(name);
	return 0;
}

Refusal unreadAttribute(const std::string& object, const char* attribute)
{
	return damaged(fmt::format("the attribute {} of {} cannot be read", attribute, object));
}

} // namespace

File::File(const std::string& file) : name_(file)
{
	H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it would print its own stack of errors
	H5PLset_loading_state(0);                    // a file does not choose code to load
	file_ = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
	if (file_ < 0)
		throw damaged("HDF5 cannot open it");
}

File::~File()
{
	H5Fclose(file_);
}

bool File::hasLink(const std::string& path) const
{
	const htri_t there = H5Lexists(file_, path.c_str(), H5P_DEFAULT);
	if (there >= 0)
		return there > 0;
	// HDF5 would look into a data set as well, so the parent must be a group.
	const std::string group = path.substr(0, path.rfind('/'));
	const Handle opened(H5Oopen(file_, group.empty() ? "/" : group.c_str(), H5P_DEFAULT), H5Oclose);
	if (opened < 0 || H5Iget_type(opened) == H5I_GROUP)
		throw damaged(fmt::format("what {} holds cannot be listed", group.empty() ? "its root" : group));
	return false;
}

bool File::has(const std::string& path) const
{
	if (path == "/")
		return true;
	for (std::size_t end = path.find('/', 1); end != path.npos; end = path.find('/', end + 1))
		if (!hasLink(path.substr(0, end)))
			return false;
	return hasLink(path);
}

bool File::isSet(const std::string& path) const
{
	// H5Oget_info_by_name() differs between versions of HDF5, so it is not used.
	if (!has(path))
		return false;
	const Handle opened(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose);
	if (opened < 0)
		throw Refusal(fmt::format("its {} cannot be opened; keep the files that it names together", path));
	return H5Iget_type(opened) == H5I_DATASET;
}

bool File::leadsNowhere(const std::string& path) const
{
	return has(path) && Handle(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose) < 0;
}

std::vector<std::string> File::namesIn(const std::string& group, Order order) const
{
	std::vector<std::string> names;
	if (!has(group) || isSet(group))
		return names;
	const Handle opened(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
	if (opened < 0)
		throw damaged(fmt::format("{} cannot be listed", group));
	if (order == Order::creation && H5Literate(opened, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, addName, &names) >= 0)
		return names;
	names.clear();
	if (H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, addName, &names) < 0)
		throw damaged(fmt::format("{} cannot be listed", group));
	return names;
}

std::vector<std::uint64_t> File::sidesOf(const std::string& path) const
{
	const Handle set(has(path) ? H5Dopen2(file_, path.c_str(), H5P_DEFAULT) : -1, H5Dclose);
	const Handle space(set < 0 ? -1 : H5Dget_space(set), H5Sclose);
	const int rank = space < 0 ? -1 : H5Sget_simple_extent_ndims(space);
	if (rank < 0)
		throw damaged(fmt::format("{} is not there", path));
	std::vector<hsize_t> sides(static_cast<std::size_t>(rank));
	H5Sget_simple_extent_dims(space, sides.data(), nullptr);
	return {sides.begin(), sides.end()};
}

template <class Number>
std::vector<Number> File::values(const std::string& path, hid_t type) const
{
	std::uint64_t count = 1;
	for (const std::uint64_t side : sidesOf(path))
		if (__builtin_mul_overflow(count, side, &count) || count > std::uint64_t(1) << 40)
			throw damaged(fmt::format("{} has more values than there can be", path));
	const Handle set = openedSet(file_, path);
	const Handle given(H5Dget_type(set), H5Tclose);
	const H5T_class_t kind = H5Tget_class(given);
	if (kind != H5T_INTEGER && kind != H5T_FLOAT)
		throw damaged(fmt::format("{} holds no numbers", path));
	// A data set that was never written would read as zeros.
	H5D_space_status_t written = H5D_SPACE_STATUS_ERROR;
	if (H5Dget_space_status(set, &written) < 0 || (written == H5D_SPACE_STATUS_NOT_ALLOCATED && count > 0))
		throw damaged(fmt::format("{} was never written", path));
	refuseMissingParts(set, path);
	std::vector<Number> numbers(count);
	if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0)
		throw unreadSet(set, path);
	return numbers;
}

std::vector<double> File::reals(const std::string& path) const
{
	return values<double>(path, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> File::integers(const std::string& path) const
{
	return values<std::int64_t>(path, H5T_NATIVE_INT64);
}

bool File::isFloat(const std::string& path) const
{
	const Handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
	const Handle type(set < 0 ? -1 : H5Dget_type(set), H5Tclose);
	return type >= 0 && H5Tget_class(type) == H5T_FLOAT;
}

std::array<double, 2> File::limitsOfType(const std::string& path) const
{
	const Handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
	const Handle type(set < 0 ? -1 : H5Dget_type(set), H5Tclose);
	if (type < 0 || H5Tget_class(type) != H5T_INTEGER)
		return {0.0, 0.0};
	const int bits = static_cast<int>(8 * H5Tget_size(type));
	if (H5Tget_sign(type) == H5T_SGN_NONE)
		return {0.0, std::ldexp(1.0, bits) - 1.0};
	return {-std::ldexp(1.0, bits - 1), std::ldexp(1.0, bits - 1) - 1.0};
}

// An attribute that exists must be readable: a default in its place would not be what the file means.
bool File::hasAttribute(const std::string& object, const char* attribute) const
{
	const htri_t there = has(object) ? H5Aexists_by_name(file_, object.c_str(), attribute, H5P_DEFAULT) : 0;
	if (there < 0)
		throw unreadAttribute(object, attribute);
	return there > 0;
}

std::vector<double> File::realsOr(const std::string& object, const char* attribute) const
{
	if (!hasAttribute(object, attribute))
		return {};
	const Handle opened(H5Aopen_by_name(file_, object.c_str(), attribute, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
	const Handle type(opened < 0 ? -1 : H5Aget_type(opened), H5Tclose);
	const Handle space(opened < 0 ? -1 : H5Aget_space(opened), H5Sclose);
	const hssize_t count = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
	if (type < 0 || count < 0)
		throw unreadAttribute(object, attribute);
	constexpr hssize_t most = 1 << 16;
	if (count < 1 || count > most || (H5Tget_class(type) != H5T_INTEGER && H5Tget_class(type) != H5T_FLOAT))
		return {};
	std::vector<double> numbers(static_cast<std::size_t>(count));
	if (H5Aread(opened, H5T_NATIVE_DOUBLE, numbers.data()) < 0)
		throw unreadAttribute(object, attribute);
	return numbers;
}

double File::realOr(const std::string& object, const char* attribute, double otherwise) const
{
	const std::vector<double> numbers = realsOr(object, attribute);
	return numbers.empty() ? otherwise : numbers[0];
}

std::string File::textOr(const std::string& object, const char* attribute) const
{
	if (!hasAttribute(object, attribute))
		return {};
	const Handle opened(H5Aopen_by_name(file_, object.c_str(), attribute, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
	const Handle type(opened < 0 ? -1 : H5Aget_type(opened), H5Tclose);
	if (type < 0)
		throw unreadAttribute(object, attribute);
	if (H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0)
	{
		const Handle space(H5Aget_space(opened), H5Sclose);
		char* elsewhere = nullptr;
		if (H5Sget_simple_extent_npoints(space) != 1)
			return {};
		if (H5Aread(opened, type, &elsewhere) < 0)
			throw unreadAttribute(object, attribute);
		if (!elsewhere)
			return {};
		std::string words(elsewhere);
		H5free_memory(elsewhere);
		return words;
	}
	const std::size_t bytes = H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0
	                              ? 0
	                              : static_cast<std::size_t>(H5Aget_storage_size(opened));
	if (bytes == 0 || bytes > 1 << 16)
		return {};
	std::string text(bytes, '\0');
	if (H5Aread(opened, type, text.data()) < 0)
		throw unreadAttribute(object, attribute);
	text.resize(std::min(text.find('\0'), text.size()));
	return text;
}

} // namespace vp::reader::hdf5
