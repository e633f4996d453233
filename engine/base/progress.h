#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace vp
{

/// Receives what the library is doing, such as "reading FILE", and an empty text when that ends. It may be called from
/// any thread.
using ProgressSink = std::function<void(std::string_view)>;

/// While one lives, work that takes its time is told to its sink. The youngest one hears; without one nobody does.
/// Listeners end in the reverse order of their beginning.
class ProgressListener
{
public:
	explicit ProgressListener(ProgressSink sink);
	~ProgressListener();
	ProgressListener(const ProgressListener&) = delete;
	ProgressListener& operator=(const ProgressListener&) = delete;

private:
	ProgressSink previous_;
};

/// Work under way, told from beginning to end. One at a time.
class Progress
{
public:
	explicit Progress(std::string_view what) { say(what); }
	~Progress() { say({}); }
	Progress(const Progress&) = delete;
	Progress& operator=(const Progress&) = delete;

	void say(std::string_view what); // from now on
};

} // namespace vp
