#include "viewer/cutting/watcher.h"

#include <algorithm>

namespace vp::app
{

void Watcher::watch(const std::vector<std::string>& inputs)
{
	files_.clear();
	for (const std::string& input : inputs)
		if (!input.starts_with("demo:"))
			files_.push_back(input);
	known_ = last_ = stamps();
}

std::vector<std::optional<Watcher::Stamp>> Watcher::stamps() const
{
	std::vector<std::optional<Stamp>> all;
	for (const std::string& file : files_)
	{
		std::error_code failed;
		Stamp stamp{std::filesystem::last_write_time(file, failed), 0};
		if (!failed && std::filesystem::is_regular_file(file, failed))
			stamp.size = std::filesystem::file_size(file, failed);
		all.push_back(failed ? std::nullopt : std::optional(stamp));
	}
	return all;
}

bool Watcher::changed(Moment now)
{
	if (files_.empty() || now - looked_ < std::chrono::seconds(1))
		return false;
	looked_ = now;
	std::vector<std::optional<Stamp>> seen = stamps();
	const bool rests = seen == last_ && std::ranges::all_of(seen, [](const auto& stamp) { return stamp.has_value(); });
	last_ = std::move(seen);
	if (!rests || last_ == known_)
		return false;
	known_ = last_;
	return true;
}

} // namespace vp::app
