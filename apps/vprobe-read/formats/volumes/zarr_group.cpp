#include "zarr_group.h"

#include "zarr_array.h"

#include <algorithm>

namespace vp::reader::volumes
{

using nlohmann::json;

namespace
{

namespace fs = std::filesystem;

json jsonOrNone(const fs::path& file)
{
	std::error_code ignored;
	return fs::is_regular_file(file, ignored) ? zarrJson(file) : json::object();
}

json objectIn(const json& about, const char* key)
{
	json value = about.value(key, json());
	return value.is_object() ? value : json::object();
}

json attributesIn(const fs::path& folder, const json& about)
{
	return about.contains("attributes") ? objectIn(about, "attributes") : jsonOrNone(folder / ".zattrs");
}

// Metadata of all arrays in one file are a copy of theirs; theirs may be left out.
void takeCopies(ZarrGroup& group, const fs::path& folder, const json& of_group)
{
	const json third = objectIn(objectIn(of_group, "consolidated_metadata"), "metadata");
	for (const auto& [name, about] : third.items())
		if (name.find('/') == name.npos && about.is_object() && about.value("node_type", "") == "array")
			group.arrays.try_emplace(name, ZarrGroup::Array{folder / name, about, objectIn(about, "attributes")});
	const json second = objectIn(jsonOrNone(folder / ".zmetadata"), "metadata");
	for (const auto& [key, about] : second.items())
		if (const std::size_t slash = key.find('/');
		    slash != key.npos && key.substr(slash) == "/.zarray" && about.is_object())
		{
			const std::string name = key.substr(0, slash);
			const json attributes = objectIn(second, (name + "/.zattrs").c_str());
			const auto [array, is_new] =
			    group.arrays.try_emplace(name, ZarrGroup::Array{folder / name, about, attributes});
			if (array->second.attributes.empty())
				array->second.attributes = attributes;
		}
}

} // namespace

ZarrGroup ZarrGroup::of(const std::string& given)
{
	const fs::path folder = fs::absolute(given).lexically_normal();
	const std::string own = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
	ZarrGroup group;
	if (const auto about = zarrArrayJson(folder))
	{
		group.arrays.emplace(own, Array{folder, *about, attributesIn(folder, *about)});
		return group;
	}
	const json of_group = jsonOrNone(folder / "zarr.json");
	group.attributes = attributesIn(folder, of_group);
	for (const auto& entry : fs::directory_iterator(folder))
	{
		const std::string name = entry.path().filename().string();
		std::error_code ignored;
		if (const auto about = zarrArrayJson(entry.path()))
			group.arrays.emplace(name, Array{entry.path(), *about, attributesIn(entry.path(), *about)});
		else if (fs::is_regular_file(entry.path() / ".zgroup", ignored) ||
		         fs::is_regular_file(entry.path() / "zarr.json", ignored))
			group.groups.push_back(name);
	}
	takeCopies(group, folder, of_group);
	std::ranges::sort(group.groups);
	return group;
}

} // namespace vp::reader::volumes
