#pragma once

#include "profile/profile_log.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace vp::app
{

// Holds a measured sweep and what was swept.
struct Profile
{
	const session::Session& session;
	const ProfileLog& log;
	std::string path;                   // as the option gives it
	std::optional<std::string> picture; // size and samples, if whole frames were drawn
};

// Returns the profile as JSON. docs/PROFILE.md explains the keys. Scripts rely on them: add keys, but never rename one.
nlohmann::json profileJson(const Profile& profile);

// Returns the same as a table for people.
std::string profileTable(const nlohmann::json& document);

} // namespace vp::app
