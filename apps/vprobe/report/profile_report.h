#pragma once

#include "report/profile_log.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace vp::app
{

// A sweep that was measured, and what it was of.
struct Profile
{
	const session::Session& session;
	const ProfileLog& log;
	std::string path;                   // as the option says
	std::optional<std::string> picture; // size and samples, where whole frames were drawn
};

// docs/PROFILE.md explains the keys; scripts rely on them: add to them, never rename one.
nlohmann::json profileJson(const Profile& profile);

// The same for people, from the same document.
std::string profileTable(const nlohmann::json& document);

} // namespace vp::app
