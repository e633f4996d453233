// Reads parts of data sets.
#include "hdf5_file.h"
#include "hdf5_parts.h"
#include "hdf5_stored.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <utility>

namespace vp::reader::hdf5
{

using grid::NumberType;

std::optional<NumberType> File::numberType(const std::string& path) const
{
	const Handle set(isSet(path) ? H5Dopen2(file_, path.c_str(), H5P_DEFAULT) : -1, H5Dclose);
	const Handle type(set < 0 ? -1 : H5Dget_type(set), H5Tclose);
	const H5T_class_t kind = type < 0 ? H5T_NO_CLASS : H5Tget_class(type);
	const std::size_t bytes = type < 0 ? 0 : H5Tget_size(type);
	if (kind == H5T_FLOAT)
		return bytes <= 4 ? NumberType::float32 : NumberType::float64;
	if (kind != H5T_INTEGER)
		return std::nullopt;
	const bool is_signed = H5Tget_sign(type) != H5T_SGN_NONE;
	switch (bytes)
	{
	case 1:
		return is_signed ? NumberType::int8 : NumberType::uint8;
	case 2:
		return is_signed ? NumberType::int16 : NumberType::uint16;
	case 4:
		return is_signed ? NumberType::int32 : NumberType::uint32;
	case 8:
		return is_signed ? NumberType::int64 : NumberType::uint64;
	default:
		return std::nullopt;
	}
}

void File::readSlab(const std::string& path, const std::vector<std::uint64_t>& begin,
                    const std::vector<std::uint64_t>& count, NumberType type, void* to) const
{
	const std::vector<std::uint64_t> sides = sidesOf(path);
	bool is_empty = false;
	bool fits = !sides.empty() && sides.size() == begin.size() && sides.size() == count.size();
	for (std::size_t i = 0; fits && i < sides.size(); ++i)
	{
		fits = begin[i] <= sides[i] && count[i] <= sides[i] - begin[i];
		is_empty |= count[i] == 0;
	}
	if (!fits || !numberType(path))
		throw damaged(fmt::format("{} has fewer values than are asked of it", path));
	if (is_empty)
		return;
	const Handle set = openedSet(file_, path);
	// A data set that was never written would read as zeros.
	H5D_space_status_t written = H5D_SPACE_STATUS_ERROR;
	if (H5Dget_space_status(set, &written) < 0 || written == H5D_SPACE_STATUS_NOT_ALLOCATED)
		throw damaged(fmt::format("{} was never written", path));
	refuseMissingParts(set, path);
	const std::vector<hsize_t> first(begin.begin(), begin.end());
	const std::vector<hsize_t> length(count.begin(), count.end());
	const Handle there(H5Dget_space(set), H5Sclose);
	const Handle here(H5Screate_simple(static_cast<int>(length.size()), length.data(), nullptr), H5Sclose);
	if (H5Sselect_hyperslab(there, H5S_SELECT_SET, first.data(), nullptr, length.data(), nullptr) < 0 ||
	    H5Dread(set, nativeType(type), here, there, H5P_DEFAULT, to) < 0)
		throw unreadSet(set, path);
}

std::optional<arrays::StoredPlace> File::storedPlace(const std::string& path, const arrays::ValueLayout& layout,
                                                     const std::vector<std::uint64_t>& front) const
{
	return storedPlaceOf(file_, name_, path, layout, front);
}

std::optional<std::uint64_t> File::plainOffset(const std::string& path, NumberType type) const
{
	return plainOffsetOf(file_, name_, path, type);
}

std::vector<std::int64_t> File::integersFrom(const std::string& path, std::uint64_t begin, std::uint64_t count) const
{
	const std::vector<std::uint64_t> sides = sidesOf(path);
	if (sides.empty() || begin > sides[0] || count > sides[0] - begin) // before memory is taken
		throw damaged(fmt::format("{} has fewer values than are asked of it", path));
	std::vector<std::int64_t> numbers(count);
	// A data set with one column counts as a list.
	std::vector<std::uint64_t> first(sides.size(), 0), length(sides.size(), 1);
	first[0] = begin;
	length[0] = count;
	readSlab(path, first, length, NumberType::int64, numbers.data());
	return numbers;
}

} // namespace vp::reader::hdf5
