#include "viewer/document/user_files.h"

#include "base/user_folder.h"
#include "write/atomic_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include <unistd.h>

namespace vp::app
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* kRecovery = "recovery-";
constexpr const char* kEnding = ".json";

fs::path settingsFile()
{
	return userFolder("XDG_CONFIG_HOME", ".config") / "view.json";
}

// Returns the process to which a recovery file belongs. Returns nothing for other files.
std::optional<pid_t> processOf(const fs::path& file)
{
	const std::string name = file.filename();
	if (!name.starts_with(kRecovery) || !name.ends_with(kEnding))
		return std::nullopt;
	const std::string_view number = std::string_view(name).substr(std::string_view(kRecovery).size());
	pid_t process = 0;
	const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), process);
	return error == std::errc() && std::string_view(end) == kEnding ? std::optional(process) : std::nullopt;
}

} // namespace

Settings readSettings()
{
	Settings settings;
	std::ifstream file(settingsFile());
	const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
	if (!json.is_object())
		return settings;
	if (const auto dark = json.find("dark"); dark != json.end() && dark->is_boolean())
		settings.dark = *dark;
	if (const auto size = json.find("text_size"); size != json.end() && size->is_number())
		settings.text_size = std::clamp(size->get<double>(), kMinTextSize, kMaxTextSize);
	if (const auto hints = json.find("hints"); hints != json.end() && hints->is_boolean() && !hints->get<bool>())
		settings.hint.reset();
	if (const auto recent = json.find("recent"); recent != json.end() && recent->is_array())
		for (const nlohmann::json& name : *recent)
			if (name.is_string() && settings.recent.size() < kMaxRecent)
				settings.recent.push_back(name);
	return settings;
}

bool writeSettings(const Settings& settings)
{
	if (madeFolder(settingsFile().parent_path()).empty())
		return false;
	auto file = write::AtomicFile::create(settingsFile());
	if (!file)
		return false;
	const nlohmann::json json{{"dark", settings.dark},
	                          {"text_size", settings.text_size},
	                          {"hints", settings.hint.has_value()},
	                          {"recent", settings.recent}};
	file->write(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
	return bool(file->commit());
}

void remember(Settings& settings, const std::string& input)
{
	std::error_code failed;
	const std::string name = input.starts_with("demo:") ? input : fs::absolute(input, failed).string();
	std::erase(settings.recent, name);
	settings.recent.insert(settings.recent.begin(), name);
	settings.recent.resize(std::min(settings.recent.size(), kMaxRecent));
}

std::string recoveryFile()
{
	const fs::path place = madeFolder(userFolder("XDG_STATE_HOME", ".local/state"));
	return place.empty() ? std::string() : (place / fmt::format("{}{}{}", kRecovery, getpid(), kEnding)).string();
}

std::vector<std::string> leftRecoveryFiles()
{
	std::error_code failed;
	std::vector<fs::directory_entry> left;
	for (const fs::directory_entry& entry :
	     fs::directory_iterator(userFolder("XDG_STATE_HOME", ".local/state"), failed))
		if (const auto process = processOf(entry.path()); process && kill(*process, 0) != 0 && errno == ESRCH)
			left.push_back(entry);
	std::ranges::sort(left, std::greater(), [&](const auto& entry) { return entry.last_write_time(failed); });
	std::vector<std::string> names;
	for (const fs::directory_entry& entry : left)
		names.push_back(entry.path());
	return names;
}

} // namespace vp::app
