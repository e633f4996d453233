#pragma once

#include "viewer/render_thread.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// Looks after the files that are shown: a solver may write them anew.
class Watcher
{
public:
	// From now on these; built-in data never change.
	void watch(const std::vector<std::string>& inputs);
	// True once after they have changed, when they have rested for a second: a file half written is no use. Looks at
	// most once a second.
	bool changed(Moment now);

private:
	struct Stamp
	{
		std::filesystem::file_time_type time;
		std::uintmax_t size = 0;

		bool operator==(const Stamp&) const = default;
	};

	std::vector<std::optional<Stamp>> stamps() const; // none of a file that is not there just now

	std::vector<std::string> files_;
	std::vector<std::optional<Stamp>> known_; // when they were read
	std::vector<std::optional<Stamp>> last_;
	Moment looked_{};
};

} // namespace vp::app
