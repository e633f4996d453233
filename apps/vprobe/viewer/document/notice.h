#pragma once

#include "viewer/cutting/meter.h"

#include <string>
#include <vector>

namespace vp::app
{

// A line of text that the user sees for a while.
struct Notice
{
	std::string words;
	bool is_error = false;
	Moment since{};
};

// Holds the notices that are shown. Used by the window's thread only.
class NoticeList
{
public:
	void add(std::string words, bool is_error); // replaces a notice with the same text
	void dismiss(const std::string& words);
	void forgetOld(Moment now);
	const std::vector<Notice>& all() const { return notices_; }

private:
	std::vector<Notice> notices_;
};

} // namespace vp::app
