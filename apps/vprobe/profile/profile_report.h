#pragma once

#include "profile/device_work.h"
#include "profile/floor.h"
#include "profile/profile_log.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace vp::app
{

// Returns the largest resident memory of this process until now, in bytes.
std::size_t peakResident();

// Holds a measured sweep and what was swept.
struct Profile
{
	const session::Session& session;
	const ProfileLog& log;
	std::string path;                        // as the option gives it
	std::optional<std::string> picture;      // size and samples, if whole frames were drawn
	std::size_t peak_rss = peakResident();   // measuring the floor takes memory that no cut needs
	const StageWork* work = nullptr;         // what the stages did; null if nobody asked
	const Floor* floor = nullptr;            // given with the work
	const DeviceWork* device_work = nullptr; // null if nobody asked, or without a device
};

// Returns the profile as JSON. docs/PROFILE.md explains the keys. Scripts rely on them: add keys, but never rename one.
nlohmann::json profileJson(const Profile& profile);

// Returns the same as a table for people.
std::string profileTable(const nlohmann::json& document);

} // namespace vp::app
