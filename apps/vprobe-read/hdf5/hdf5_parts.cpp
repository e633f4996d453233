// HDF5 has data sets whose values lie elsewhere: "external storage" and "virtual data sets".
#include "hdf5_parts.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <vector>

namespace vp::reader::hdf5
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t kMaxLinks = 1 << 20;

fs::path fileOf(hid_t object)
{
	std::array<char, 4096> name = {};
	H5Fget_name(object, name.data(), name.size());
	return name.data();
}

bool isFile(const fs::path& path)
{
	std::error_code ignored;
	return fs::is_regular_file(path, ignored);
}

// Looks for a file beside the HDF5 file, and then in the current folder. Returns nothing if it is at neither place.
std::optional<fs::path> foundFile(const fs::path& name, hid_t object)
{
	for (const fs::path& path : {fileOf(object).parent_path() / name, name})
		if (isFile(path))
			return path;
	return std::nullopt;
}

std::string externalName(hid_t properties, unsigned index, off_t& offset, hsize_t& size)
{
	std::array<char, 4096> name = {};
	if (H5Pget_external(properties, index, name.size() - 1, name.data(), &offset, &size) < 0)
		throw damaged("the list of files with its values cannot be read");
	return name.data();
}

void refuseShortExternal(hid_t set, hid_t properties, const std::string& path)
{
	const int count = H5Pget_external_count(properties);
	if (count <= 0)
		return;
	const Handle type(H5Dget_type(set), H5Tclose);
	const Handle space(H5Dget_space(set), H5Sclose);
	const hssize_t values = H5Sget_simple_extent_npoints(space);
	auto left = static_cast<hsize_t>(std::max<hssize_t>(values, 0)) * H5Tget_size(type);
	for (int i = 0; i < count; ++i)
	{
		off_t offset = 0;
		hsize_t size = 0;
		const std::string name = externalName(properties, static_cast<unsigned>(i), offset, size);
		const auto file = foundFile(name, set);
		if (!file)
			throw Refusal(fmt::format("{} is in {}, which cannot be opened; keep the files together", path, name));
		const hsize_t wanted = std::min(size, left);
		const std::uintmax_t bytes = fs::file_size(*file);
		if (offset < 0 || static_cast<std::uintmax_t>(offset) > bytes ||
		    bytes - static_cast<std::uintmax_t>(offset) < wanted)
			throw damaged(fmt::format("{} ends before the values of {} do", file->string(), path));
		left -= wanted;
	}
}

using NameGetter = ssize_t (*)(hid_t, size_t, char*, size_t);

std::string virtualName(hid_t properties, std::size_t index, NameGetter get)
{
	std::array<char, 4096> name = {};
	if (get(properties, index, name.data(), name.size() - 1) < 0)
		throw damaged("the list of data sets with its values cannot be read");
	return name.data();
}

// The search for what a data set is made of. HDF5 follows virtual data sets in the same way, and a circle of them would
// fill its stack.
struct SourceSearch
{
	using Source = std::pair<fs::path, std::string>; // a file and the path of a set in it
	std::vector<Source> chain;                       // each is made of the next
	std::set<Source> sound;
};

void refuseMissingParts(hid_t set, const std::string& path, SourceSearch& search);

// Returns false if there is no such source.
bool lookAtSource(hid_t set, const std::string& name, const std::string& path, SourceSearch& search)
{
	constexpr std::size_t kMaxChain = 16;
	const auto file = name == "." ? fileOf(set) : foundFile(name, set);
	const Handle opened(file ? H5Fopen(file->c_str(), H5F_ACC_RDONLY, H5P_DEFAULT) : -1, H5Fclose);
	const Handle there(opened < 0 ? -1 : H5Dopen2(opened, path.c_str(), H5P_DEFAULT), H5Dclose);
	if (there < 0)
		return false;
	std::error_code ignored;
	const SourceSearch::Source source = {fs::weakly_canonical(*file, ignored), path};
	if (search.sound.contains(source))
		return true;
	if (std::ranges::find(search.chain, source) != search.chain.end())
		throw damaged(fmt::format("its virtual data set {} is made of itself", path));
	if (search.chain.size() == kMaxChain)
		throw damaged(fmt::format("its virtual data set {} leads on over more than {} others",
		                          search.chain.front().second, kMaxChain));
	search.chain.push_back(source);
	refuseMissingParts(there, path, search);
	search.chain.pop_back();
	search.sound.insert(source);
	return true;
}

// "%b" stands for the number of a block.
std::string withNumber(const std::string& pattern, std::size_t number)
{
	std::string name;
	for (std::size_t at = 0; at < pattern.size(); ++at)
	{
		const char next = at + 1 < pattern.size() ? pattern[at + 1] : '\0';
		if (pattern[at] != '%' || (next != 'b' && next != '%'))
			name += pattern[at];
		else
		{
			name += next == 'b' ? std::to_string(number) : "%";
			++at;
		}
	}
	return name;
}

void refuseMissingSources(hid_t set, hid_t properties, const std::string& path, SourceSearch& search)
{
	constexpr std::size_t kMaxNumbered = 1 << 16;
	std::size_t count = 0;
	if (H5Pget_layout(properties) != H5D_VIRTUAL || H5Pget_virtual_count(properties, &count) < 0)
		return;
	std::set<std::pair<std::string, std::string>> known;
	for (std::size_t i = 0; i < count; ++i)
	{
		const std::string name = virtualName(properties, i, H5Pget_virtual_filename);
		const std::string source = virtualName(properties, i, H5Pget_virtual_dsetname);
		if (!known.emplace(name, source).second)
			continue;
		if ((name + source).find('%') == std::string::npos)
		{
			if (!lookAtSource(set, name, source, search))
				throw Refusal(fmt::format("{} is in {} of {}, which cannot be opened; keep the files together", path,
				                          source, name == "." ? "the same file" : name));
			continue;
		}
		// There are as many as there are.
		for (std::size_t n = 0; n < kMaxNumbered; ++n)
			if (!lookAtSource(set, withNumber(name, n), withNumber(source, n), search))
				break;
	}
}

void refuseMissingParts(hid_t set, const std::string& path, SourceSearch& search)
{
	const Handle properties(H5Dget_create_plist(set), H5Pclose);
	if (properties < 0)
		throw damaged(fmt::format("{} cannot be read", path));
	refuseShortExternal(set, properties, path);
	refuseMissingSources(set, properties, path, search);
}

herr_t addPath(hid_t, const char* name, const H5L_info_t*, void* paths)
{
	auto& all = *static_cast<std::vector<std::string>*>(paths);
	all.emplace_back(name);
	return all.size() < kMaxLinks ? 0 : -1;
}

} // namespace

Handle openedSet(hid_t file, const std::string& path)
{
	{
		const Handle plain(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
		const Handle properties(plain < 0 ? -1 : H5Dget_create_plist(plain), H5Pclose);
		off_t offset = 0;
		hsize_t size = 0;
		const bool is_elsewhere = properties >= 0 && H5Pget_external_count(properties) > 0;
		if (!is_elsewhere || !isFile(fileOf(file).parent_path() / externalName(properties, 0, offset, size)))
			return {H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose};
	}
	const Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose);
	H5Pset_efile_prefix(access, "${ORIGIN}");
	return {H5Dopen2(file, path.c_str(), access), H5Dclose};
}

void refuseMissingParts(hid_t set, const std::string& path)
{
	SourceSearch search;
	refuseMissingParts(set, path, search);
}

void refuseMissingParts(const std::string& file)
{
	H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it would print its own stack of errors
	if (H5Fis_hdf5(file.c_str()) <= 0)
		return;
	const Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
	std::vector<std::string> paths;
	if (opened < 0 || H5Lvisit(opened, H5_INDEX_NAME, H5_ITER_NATIVE, addPath, &paths) < 0)
		throw damaged("its contents cannot be listed");
	for (const std::string& path : paths)
	{
		const Handle object(H5Oopen(opened, path.c_str(), H5P_DEFAULT), H5Oclose);
		if (object < 0)
			throw Refusal(fmt::format("its /{} cannot be opened; keep the files that it names together", path));
		if (H5Iget_type(object) == H5I_DATASET)
			refuseMissingParts(object, "/" + path);
	}
}

Refusal unreadSet(hid_t set, const std::string& path)
{
	const Handle properties(H5Dget_create_plist(set), H5Pclose);
	const int count = properties < 0 ? 0 : H5Pget_nfilters(properties);
	for (int i = 0; i < count; ++i)
	{
		std::array<char, 80> name = {};
		unsigned flags = 0, about = 0;
		std::size_t values = 0;
		const H5Z_filter_t filter = H5Pget_filter2(properties, static_cast<unsigned>(i), &flags, &values, nullptr,
		                                           name.size() - 1, name.data(), &about);
		if (filter >= 0 && H5Zfilter_avail(filter) <= 0)
			return Refusal(
			    fmt::format("{} is packed by the filter {} ({}), which HDF5 does not bring; pack it by gzip, "
			                "with h5repack where that filter is installed",
			                path, filter, name[0] ? name.data() : "no name"));
	}
	return damaged(fmt::format("{} cannot be read", path));
}

} // namespace vp::reader::hdf5
