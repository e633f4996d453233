#include "part_filter.h"

#include <charconv>

PartFilter::PartFilter(std::string_view text)
{
	if (text.empty())
		return;
	mode_ = text == "?" ? Mode::list : Mode::chosen;
	while (mode_ == Mode::chosen && !text.empty())
	{
		std::size_t number = 0;
		const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
		if (error == std::errc())
			chosen_.insert(number);
		const std::size_t comma = text.find(',');
		text = comma == text.npos ? std::string_view() : text.substr(comma + 1);
	}
}

bool PartFilter::begin(std::size_t cells)
{
	if (!filters() || isInside())
		return true;
	const std::size_t number = parts_.size();
	if (!in_block_)
		blocks_.push_back(nullptr);
	parts_.push_back({{"cells", cells}, {"block", blocks_.size() - 1}});
	return mode_ == Mode::chosen && chosen_.contains(number);
}

void PartFilter::beginBlock(nlohmann::json facts)
{
	blocks_.push_back(std::move(facts));
	in_block_ = true;
}
