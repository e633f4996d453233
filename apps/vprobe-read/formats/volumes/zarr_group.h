#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// The JSON of a folder of Zarr, of version 2 or 3: of a group, or of an array by itself.
struct ZarrGroup
{
	struct Array
	{
		std::filesystem::path folder;
		nlohmann::json about;
		nlohmann::json attributes;
	};

	std::map<std::string, Array> arrays; // by their names
	std::vector<std::string> groups;     // in it, in the order of their names
	nlohmann::json attributes = nlohmann::json::object();

	// Reads it. Throws a Refusal that names a file which is no JSON.
	static ZarrGroup of(const std::string& folder);
};

} // namespace vp::reader::volumes
