#pragma once

#include "viewer/cutting/render_thread.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// Watches the files that are shown, because a solver may write them anew.
class Watcher
{
public:
	// Watches these files from now on. Built-in data never change.
	void watch(const std::vector<std::string>& inputs);
	// Returns true once after the files changed and then rested for a second, since a half-written file is useless.
	// Looks at the files at most once a second.
	bool changed(Moment now);

private:
	struct Stamp
	{
		std::filesystem::file_time_type time;
		std::uintmax_t size = 0;

		bool operator==(const Stamp&) const = default;
	};

	std::vector<std::optional<Stamp>> stamps() const; // no stamp for a file that does not exist at the moment

	std::vector<std::string> files_;
	std::vector<std::optional<Stamp>> known_; // when they were read
	std::vector<std::optional<Stamp>> last_;
	Moment looked_{};
};

} // namespace vp::app
