#include "json_text.h"

#include "vprobe-read/base/nesting.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

namespace vp::reader::text
{

nlohmann::json parseJson(std::string_view text)
{
	using Event = nlohmann::json::parse_event_t;
	const auto limited = [](int depth, Event event, nlohmann::json&)
	{
		const bool begins = event == Event::object_start || event == Event::array_start;
		if (begins && depth >= kMaxNestedElements)
			throw damaged(fmt::format("its JSON is nested more than {} deep", kMaxNestedElements));
		return true;
	};
	return nlohmann::json::parse(text, limited, false);
}

} // namespace vp::reader::text
