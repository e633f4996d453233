#include "foam_dictionary.h"

#include "foam_pattern.h"

#include <algorithm>
#include <utility>

namespace vp::reader::codes
{

namespace
{

// Each dot can end a name or be a part of it: so many ways to read them all are tried.
constexpr std::ptrdiff_t kMaxDots = 10;

} // namespace

const FoamEntry* FoamDictionary::named(std::string_view name) const
{
	const auto found = places_.find(name);
	return found == places_.end() ? nullptr : &entries_[found->second];
}

const FoamEntry* FoamDictionary::find(std::string_view name) const
{
	if (const FoamEntry* entry = named(name))
		return entry;
	if (patterns_ > 0)
		for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
			if (entry->pattern && entry->pattern->fits(name))
				return &*entry;
	return nullptr;
}

// A name with dots that is no name by itself goes from dictionary to dictionary.
const FoamEntry* FoamDictionary::below(std::string_view name, bool goes_up, bool with_patterns) const
{
	for (const FoamDictionary* at = this; at; at = goes_up ? at->parent_ : nullptr)
	{
		const auto found = [&](std::string_view part) { return with_patterns ? at->find(part) : at->named(part); };
		if (const FoamEntry* entry = found(name))
			return entry;
		for (std::size_t dot = name.find('.'); dot != name.npos; dot = name.find('.', dot + 1))
			if (const FoamEntry* entry = found(name.substr(0, dot)); entry && entry->dictionary)
				if (const FoamEntry* inside = entry->dictionary->below(name.substr(dot + 1), false, with_patterns))
					return inside;
	}
	return nullptr;
}

const FoamEntry* FoamDictionary::ofMacro(std::string_view name, bool with_patterns) const
{
	if (std::count_if(name.begin(), name.end(), [](char c) { return c == '.' || c == '/'; }) > kMaxDots)
		return nullptr;
	const FoamDictionary* at = this;
	std::string with_dots(name);
	if (name.find('/') != name.npos) // "../a/b", "!a/b" and "/a/b" are the later spelling
	{
		std::size_t ups = 0;
		while (name.starts_with("../"))
		{
			name.remove_prefix(3);
			++ups;
		}
		const bool from_top = name.starts_with('/') || name.starts_with('!');
		with_dots = (from_top ? ":" : ups > 0 ? std::string(ups + 1, '.') : "") + std::string(name.substr(from_top));
		for (std::size_t i = 0; i < with_dots.size(); ++i)
			if (with_dots[i] == '/')
				with_dots[i] = '.';
	}
	std::string_view rest = with_dots;
	if (rest.starts_with(':') || rest.starts_with('^') || rest.starts_with('!'))
	{
		while (at->parent_)
			at = at->parent_;
		return at->below(rest.substr(1), false, with_patterns);
	}
	if (!rest.starts_with('.'))
		return at->below(rest, true, with_patterns);
	for (rest.remove_prefix(1); rest.starts_with('.'); rest.remove_prefix(1))
	{
		at = at->parent_;
		if (!at)
			return nullptr;
	}
	return at->below(rest, false, with_patterns);
}

void FoamDictionary::put(FoamEntry entry)
{
	const auto [place, is_new] = places_.try_emplace(entry.key, entries_.size());
	patterns_ += is_new && entry.pattern;
	if (is_new)
		entries_.push_back(std::move(entry));
	else
		entries_[place->second] = std::move(entry);
}

void FoamDictionary::remove(std::string_view name)
{
	const auto found = places_.find(name);
	if (found == places_.end())
		return;
	entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(found->second));
	places_.clear();
	patterns_ = 0;
	for (std::size_t i = 0; i < entries_.size(); ++i)
	{
		places_[entries_[i].key] = i;
		patterns_ += entries_[i].pattern != nullptr;
	}
}

} // namespace vp::reader::codes
