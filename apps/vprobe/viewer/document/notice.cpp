#include "viewer/document/notice.h"

#include "report/console.h"

namespace vp::app
{

namespace
{

constexpr std::chrono::seconds kNoticeStays{6};
constexpr std::chrono::seconds kErrorStays{15};

} // namespace

void NoticeList::add(std::string words, bool is_error)
{
	dismiss(words);
	notices_.push_back({withOptionNames(words), is_error, std::chrono::steady_clock::now()});
}

void NoticeList::dismiss(const std::string& words)
{
	std::erase_if(notices_, [&](const Notice& notice) { return notice.words == words; });
}

void NoticeList::forgetOld(Moment now)
{
	std::erase_if(notices_, [&](const Notice& notice)
	              { return now - notice.since > (notice.is_error ? kErrorStays : kNoticeStays); });
}

} // namespace vp::app
