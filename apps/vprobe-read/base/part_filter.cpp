#include "part_filter.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace vp::reader
{

PartFilter::PartFilter(std::string_view text)
{
	if (text.empty())
		return;
	const auto numberIn = [](std::string_view digits)
	{
		std::size_t number = 0;
		const bool is_number = std::from_chars(digits.data(), digits.data() + digits.size(), number).ec == std::errc();
		return is_number ? std::optional(number) : std::nullopt;
	};
	if (const std::size_t slash = text.find('/'); slash != text.npos)
	{
		slabs_ = numberIn(text.substr(slash + 1)).value_or(1);
		text = text.substr(0, slash);
	}
	mode_ = text == "?" ? Mode::list : Mode::chosen;
	while (mode_ == Mode::chosen && !text.empty())
	{
		if (const std::optional<std::size_t> number = numberIn(text))
			chosen_.insert(*number);
		const std::size_t comma = text.find(',');
		text = comma == text.npos ? std::string_view() : text.substr(comma + 1);
	}
}

bool PartFilter::begin(std::size_t cells)
{
	if (!filters() || isInside())
		return true;
	number_ = parts_.size();
	if (!in_block_)
		blocks_.push_back(nullptr);
	parts_.push_back({{"cells", cells}, {"block", blocks_.size() - 1}});
	return mode_ == Mode::chosen && chosen_.contains(number_);
}

std::optional<CellLayers> PartFilter::beginLattice(nlohmann::json facts, std::size_t layers, std::size_t cells_of_layer)
{
	if (!splits() || layers < 2)
		return begin(layers * cells_of_layer) ? std::optional(CellLayers{0, layers}) : std::nullopt;
	const std::size_t slabs = std::min(slabs_, layers);
	std::optional<CellLayers> chosen;
	std::size_t first = 0;
	beginBlock(std::move(facts));
	for (std::size_t slab = 0; slab < slabs; ++slab)
	{
		const CellLayers own{layers / slabs * slab + std::min(slab, layers % slabs),
		                     layers / slabs * (slab + 1) + std::min(slab + 1, layers % slabs)};
		if (!begin(own.count() * cells_of_layer))
			continue;
		if (!chosen)
			first = number_;
		chosen = CellLayers{chosen ? chosen->begin : own.begin, own.end};
	}
	endBlock();
	number_ = chosen ? first : number_;
	return chosen;
}

void PartFilter::beginBlock(nlohmann::json facts)
{
	blocks_.push_back(std::move(facts));
	in_block_ = true;
}

} // namespace vp::reader
