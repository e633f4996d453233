#include "foam_blocks.h"

#include "foam_dictionary.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

namespace vp::reader::codes
{

namespace
{

constexpr std::string_view kInBlocks = "decomposedBlockData";

} // namespace

std::string_view foamFirstBlock(std::string_view text)
{
	FoamCursor at(text);
	if (parseFoamHead(at).type != kInBlocks)
		return text;
	at.integer();
	at.expect('(');
	return at.rest();
}

FoamFileText::FoamFileText(const std::filesystem::path& file, std::optional<std::size_t> block) : file_(file.string())
{
	if (!block)
		return;
	FoamCursor at(file_.text());
	if (parseFoamHead(at).type != kInBlocks)
		return;
	const std::string_view first = at.block();
	std::string_view wanted = first;
	for (std::size_t i = 0; i < *block; ++i)
	{
		if (at.peek() == 0)
			throw damaged(fmt::format("it has {} blocks, and no block {}", i + 1, *block));
		wanted = at.block();
	}
	if (*block > 0)
	{
		FoamCursor behind_head(first);
		parseFoamHead(behind_head);
		block_ = first.substr(0, first.size() - behind_head.rest().size());
	}
	block_ += wanted;
	has_block_ = true;
}

} // namespace vp::reader::codes
