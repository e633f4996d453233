#include "render/annotate/font_atlas.h"

#include <imgui/imgui_internal.h>

#include <algorithm>
#include <iterator>
#include <numeric>

namespace vp::render
{

namespace
{

constexpr const char* kEllipsis = "…";
constexpr char32_t kEllipsisLetter = 0x2026;
constexpr char32_t kSoftHyphen = 0xAD; // nobody sees one
constexpr char32_t kFirstDefaultLetter = 0x20;
constexpr char32_t kLastDefaultLetter = 0xFF;

bool startsLetter(char c)
{
	return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
}

// The start of the letter before `end`.
std::size_t before(std::string_view text, std::size_t end)
{
	do
		--end;
	while (end > 0 && !startsLetter(text[end]));
	return end;
}

std::set<char32_t> lettersOf(const std::vector<std::string>& texts)
{
	std::set<char32_t> letters;
	for (const std::string& text : texts)
		for (const char* at = text.data(); at < text.data() + text.size();)
		{
			unsigned letter = 0;
			at += ImTextCharFromUtf8(&letter, at, text.data() + text.size());
			letters.insert(letter);
		}
	return letters;
}

std::size_t firstWith(const std::vector<const Typeface*>& typefaces, char32_t letter)
{
	const auto found = std::ranges::find_if(typefaces, [&](const Typeface* each) { return each->has(letter); });
	return static_cast<std::size_t>(found - typefaces.begin());
}

bool breaksAfter(char c)
{
	return std::string_view(" _-:./,;").find(c) != std::string_view::npos;
}

} // namespace

void FontAtlas::SharedDeleter::operator()(ImDrawListSharedData* data) const
{
	delete data;
}

FontAtlas::FontAtlas(const std::vector<double>& sizes, const std::vector<std::string>& texts, const Typeface& font)
    : typefaces_{&font}
{
	if (&font != &Typeface::builtIn())
		typefaces_.push_back(&Typeface::builtIn());
	const std::set<char32_t> letters = lettersOf(texts);
	std::vector<char32_t> missing;
	std::ranges::copy_if(letters, std::back_inserter(missing),
	                     [&](char32_t letter) { return firstWith(typefaces_, letter) == typefaces_.size(); });
	if (!missing.empty())
		std::ranges::copy(Typeface::having(missing), std::back_inserter(typefaces_));

	std::vector<ImFontGlyphRangesBuilder> builders(typefaces_.size());
	const auto add = [&](char32_t letter)
	{
		const std::size_t at = firstWith(typefaces_, letter);
		builders[at < typefaces_.size() ? at : 0].AddChar(static_cast<ImWchar>(letter));
	};
	for (char32_t letter = kFirstDefaultLetter; letter <= kLastDefaultLetter; ++letter)
		add(letter);
	add(kEllipsisLetter);
	for (const char32_t letter : letters)
		if (letter <= IM_UNICODE_CODEPOINT_MAX)
			add(letter);
	builders[builtIn()].AddChar(static_cast<ImWchar>(kSoftHyphen));
	std::vector<ImVector<ImWchar>> ranges(typefaces_.size());
	for (std::size_t i = 0; i < typefaces_.size(); ++i)
		builders[i].BuildRanges(&ranges[i]);
	for (const double size : sizes)
		if (!fonts_.contains(size))
			addSize(size, ranges);
	atlas_.GetTexDataAsAlpha8(&texels_, &texel_size_.x, &texel_size_.y);

	shared_.reset(new ImDrawListSharedData);
	shared_->TexUvWhitePixel = atlas_.TexUvWhitePixel;
	shared_->TexUvLines = atlas_.TexUvLines;
	shared_->Font = fonts_.begin()->second;
	shared_->FontSize = shared_->Font->FontSize;
	shared_->CurveTessellationTol = 0.5f;
	shared_->SetCircleTessellationMaxError(0.2f);
	shared_->InitialFlags = ImDrawListFlags_AntiAliasedLines | ImDrawListFlags_AntiAliasedLinesUseTex |
	                        ImDrawListFlags_AntiAliasedFill | ImDrawListFlags_AllowVtxOffset;
	shared_->ClipRectFullscreen = ImVec4(-1e6f, -1e6f, 1e6f, 1e6f);
}

FontAtlas::~FontAtlas() = default;

std::size_t FontAtlas::builtIn() const
{
	return typefaces_.front() == &Typeface::builtIn() ? 0 : 1;
}

// All fonts are equally large by their em, and stand on the baseline of the font that is built in, so that text of any
// font has its place in a line. That one comes first: ImGui takes a line from the first one, which must have a letter
// that it finds, and a file of the user's may lie about its letters.
void FontAtlas::addSize(double size, std::vector<ImVector<ImWchar>>& ranges)
{
	const double em = size / kLetterHeight;
	std::vector<std::size_t> order(typefaces_.size());
	std::iota(order.begin(), order.end(), std::size_t(0));
	std::swap(order[0], order[builtIn()]);
	for (const std::size_t i : order)
	{
		if (ranges[i].Size <= 1)
			continue; // the end of a list without letters
		const Typeface& typeface = *typefaces_[i];
		ImFontConfig config;
		config.FontDataOwnedByAtlas = false;
		config.FontNo = typeface.number();
		config.OversampleH = 2;
		config.OversampleV = 1;
		config.PixelSnapH = false;
		config.MergeMode = fonts_.contains(size);
		const auto bytes = typeface.bytes();
		// ImGui's interface is not const; the data is only read.
		fonts_[size] = atlas_.AddFontFromMemoryTTF(const_cast<std::byte*>(bytes.data()), static_cast<int>(bytes.size()),
		                                           static_cast<float>(em * (typeface.ascent() + typeface.descent())),
		                                           &config, ranges[i].Data);
	}
}

ImFont* FontAtlas::font(double size) const
{
	return fonts_.at(size);
}

std::vector<FontAtlas::Run> FontAtlas::runs(std::string_view text) const
{
	std::vector<Run> runs;
	for (const char* at = text.data(); at < text.data() + text.size();)
	{
		unsigned letter = 0;
		const int length = ImTextCharFromUtf8(&letter, at, text.data() + text.size());
		const std::size_t with = firstWith(typefaces_, letter);
		const Typeface* font = typefaces_[with < typefaces_.size() ? with : 0];
		if (runs.empty() || runs.back().font != font)
			runs.push_back({font, {}});
		runs.back().text.append(at, static_cast<std::size_t>(length));
		at += length;
	}
	return runs;
}

double FontAtlas::width(std::string_view text, double size) const
{
	const ImFont* found = font(size);
	return found->CalcTextSizeA(found->FontSize, 1e6f, 0.0f, text.data(), text.data() + text.size()).x;
}

std::string FontAtlas::elided(std::string_view text, double size, double most) const
{
	if (width(text, size) <= most)
		return std::string(text);
	for (std::size_t end = text.size(); end > 0;)
	{
		end = before(text, end);
		const std::string shorter = std::string(text.substr(0, end)) + kEllipsis;
		if (width(shorter, size) <= most)
			return shorter;
	}
	return {};
}

std::vector<std::string> FontAtlas::wrapped(std::string_view text, double size, double most, std::size_t lines) const
{
	std::vector<std::string> result;
	while (!text.empty())
	{
		if (result.size() + 1 == lines || width(text, size) <= most)
		{
			result.push_back(elided(text, size, most));
			return result;
		}
		std::size_t fits = text.size();
		while (fits > 0 && width(text.substr(0, fits), size) > most)
			fits = before(text, fits);
		if (fits == 0)
			fits = text.size(); // not even a letter: elided to nothing on the last line
		std::size_t end = fits;
		while (end > 0 && !breaksAfter(text[end - 1]))
			end = before(text, end);
		if (end == 0)
			end = fits;
		result.push_back(std::string(text.substr(0, end)));
		text.remove_prefix(end);
	}
	return result;
}

std::shared_ptr<const FontAtlas> KeptLettering::get(const std::vector<double>& sizes,
                                                    const std::vector<std::string>& texts, const Typeface& font)
{
	std::set<char32_t> letters = lettersOf(texts);
	std::erase_if(letters, [](char32_t letter) { return letter <= kLastDefaultLetter; });
	if (!kept_ || sizes != sizes_ || letters != letters_ || font_ != &font)
	{
		kept_ = std::make_shared<const FontAtlas>(sizes, texts, font);
		sizes_ = sizes;
		font_ = &font;
		letters_ = std::move(letters);
	}
	return kept_;
}

} // namespace vp::render
