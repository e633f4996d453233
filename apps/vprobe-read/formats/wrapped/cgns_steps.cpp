#include "cgns_steps.h"

#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/hdf5/hdf5_file.h"
#include "vprobe-read/hdf5/hdf5_handle.h"

#include <algorithm>
#include <numeric>
#include <string_view>

namespace vp::reader::wrapped
{

namespace
{

constexpr std::size_t kCopyChunk = std::size_t(1) << 24;

// The data sets with the times of all bases.
std::vector<std::string> timeSets(const hdf5::File& file)
{
	std::vector<std::string> sets;
	for (const std::string& base : cgnsChildren(file, "/", "CGNSBase_t"))
		for (const std::string& steps : cgnsChildren(file, base, "BaseIterativeData_t"))
			if (const std::string set = steps + "/TimeValues/ data"; file.isSet(set))
				sets.push_back(set);
	return sets;
}

Refusal doNotRise()
{
	return Refusal("its times (TimeValues) do not rise, which VTK's CGNS reader wants; write its steps in the order of "
	               "their times");
}

} // namespace

std::vector<std::string> cgnsChildren(const hdf5::File& file, const std::string& parent, std::string_view label)
{
	std::vector<std::string> found;
	for (const std::string& child : file.namesIn(parent))
		if (const std::string path = (parent == "/" ? "" : parent) + "/" + child;
		    !file.isSet(path) && file.textOr(path, "label") == label)
			found.push_back(path);
	return found;
}

std::vector<double> unsortedCgnsTimes(const hdf5::File& file)
{
	std::vector<std::vector<double>> all;
	for (const std::string& set : timeSets(file))
		all.push_back(file.reals(set));
	if (std::ranges::all_of(all, [](const auto& times) { return std::ranges::is_sorted(times); }))
		return {};
	if (std::ranges::any_of(all, [&](const auto& times) { return times != all.front(); }))
		throw doNotRise();
	return all.front();
}

std::unique_ptr<MemoryFile> withNumberedSteps(const hdf5::File& file, const std::string& path)
{
	auto copy = std::make_unique<MemoryFile>();
	{
		const MappedText mapped(path);
		for (std::string_view rest = mapped.text(); !rest.empty();
		     rest.remove_prefix(std::min(kCopyChunk, rest.size())))
			copy->append(rest.substr(0, kCopyChunk));
		copy->end();
	}
	const hdf5::Handle opened(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
	for (const std::string& set : timeSets(file))
	{
		const hdf5::Handle times(H5Dopen2(opened, set.c_str(), H5P_DEFAULT), H5Dclose);
		const hdf5::Handle type(H5Dget_type(times), H5Tclose);
		const haddr_t place = H5Dget_offset(times);
		if (place == HADDR_UNDEF || H5Tget_class(type) != H5T_FLOAT)
			throw doNotRise();
		std::vector<double> numbers(file.reals(set).size());
		std::iota(numbers.begin(), numbers.end(), 0.0);
		const std::size_t count = numbers.size();
		const std::size_t width = H5Tget_size(type);
		if (width > sizeof(double) ||
		    H5Tconvert(H5T_NATIVE_DOUBLE, type, count, numbers.data(), nullptr, H5P_DEFAULT) < 0)
			throw doNotRise();
		copy->overwrite(place, std::string_view(reinterpret_cast<const char*>(numbers.data()), count * width));
	}
	return copy;
}

} // namespace vp::reader::wrapped
