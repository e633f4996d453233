#include "render/annotate/font_atlas.h"

#include "render/font/font.h"

#include <imgui/imgui_internal.h>

#include <cmath>

namespace vp::render
{

namespace
{

constexpr const char* kEllipsis = "…";
constexpr unsigned kLastDefaultLetter = 0xFF; // last letter of GetGlyphRangesDefault()

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

bool breaksAfter(char c)
{
	return std::string_view(" _-:./,;").find(c) != std::string_view::npos;
}

} // namespace

void FontAtlas::SharedDeleter::operator()(ImDrawListSharedData* data) const
{
	delete data;
}

FontAtlas::FontAtlas(const std::vector<double>& sizes, const std::vector<std::string>& texts)
{
	ImFontGlyphRangesBuilder builder;
	builder.AddRanges(atlas_.GetGlyphRangesDefault());
	builder.AddText(kEllipsis);
	for (const std::string& text : texts)
		builder.AddText(text.data(), text.data() + text.size());
	ImVector<ImWchar> ranges;
	builder.BuildRanges(&ranges);

	const auto file = fontFile();
	for (const double size : sizes)
	{
		const int pixels = static_cast<int>(std::lround(size));
		if (fonts_.contains(pixels))
			continue;
		ImFontConfig config;
		config.FontDataOwnedByAtlas = false;
		config.OversampleH = 2;
		config.OversampleV = 1;
		config.PixelSnapH = false;
		// ImGui's interface is not const; the data is only read.
		fonts_[pixels] = atlas_.AddFontFromMemoryTTF(const_cast<std::byte*>(file.data()), static_cast<int>(file.size()),
		                                             static_cast<float>(pixels), &config, ranges.Data);
	}
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

ImFont* FontAtlas::font(double size) const
{
	return fonts_.at(static_cast<int>(std::lround(size)));
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
                                                    const std::vector<std::string>& texts)
{
	std::vector<int> pixels;
	for (const double size : sizes)
		pixels.push_back(static_cast<int>(std::lround(size)));
	std::set<unsigned> letters;
	for (const std::string& text : texts)
		for (const char* at = text.data(); at < text.data() + text.size();)
		{
			unsigned letter = 0;
			at += ImTextCharFromUtf8(&letter, at, text.data() + text.size());
			if (letter > kLastDefaultLetter)
				letters.insert(letter);
		}
	if (!kept_ || pixels != pixels_ || letters != letters_)
	{
		kept_ = std::make_shared<const FontAtlas>(sizes, texts);
		pixels_ = std::move(pixels);
		letters_ = std::move(letters);
	}
	return kept_;
}

} // namespace vp::render
