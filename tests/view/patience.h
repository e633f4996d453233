#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace view
{

// Far more than anything here takes on a busy machine: what has not come by then does not come.
constexpr double kPatience = 30.0;

// Checks a condition again and again. Returns true if it becomes true within so many seconds.
inline bool eventually(const std::function<bool()>& holds, double seconds = kPatience)
{
	const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
	while (!holds())
	{
		if (std::chrono::steady_clock::now() > end)
			return false;
		std::this_thread::sleep_for(std::chrono::milliseconds(3));
	}
	return true;
}

} // namespace view
