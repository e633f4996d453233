#pragma once

#include "profile/turns.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// How much more time than with the first setting a stage may take.
struct TimeLimit
{
	std::string stage = "frame";
	double ratio = 1.0;
};

// Reads "[STAGE=]RATIO". An error does not name the option.
Result<TimeLimit> parseTimeLimit(const std::string& text);

// Returns an error if a limit is for a stage that was not measured. Call it after Turns::begin().
Status checkLimits(const Turns& turns, const std::vector<TimeLimit>& limits);

// Returns the figures of a measurement in turns as JSON. docs/PROFILE.md explains the keys. subject: keys and values
// that say what was measured.
nlohmann::json turnsJson(const Turns& turns, const std::vector<TimeLimit>& limits, const nlohmann::json& subject);

// Returns the same as a table for people.
std::string turnsTable(const nlohmann::json& document);

// Returns true if a limit is exceeded for certain.
bool exceedsLimit(const nlohmann::json& document);

} // namespace vp::app
