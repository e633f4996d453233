#pragma once

#include "render/font/typeface.h"

#include <glm/vec2.hpp>
#include <imgui/imgui.h>

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

struct ImDrawListSharedData;

namespace vp::render
{

// The font at a few sizes, with only the letters of given texts, and draw lists of ImGui without an ImGui context. So
// pictures can be made on any thread, with or without a window.
class FontAtlas
{
public:
	// texts: everything that will be written, in UTF-8. Digits, ASCII letters and the ellipsis are always there.
	// Letters that the font lacks are taken from the one that is built in, then from others of the system.
	FontAtlas(const std::vector<double>& sizes, const std::vector<std::string>& texts,
	          const Typeface& font = Typeface::builtIn());
	~FontAtlas();
	FontAtlas(const FontAtlas&) = delete;
	FontAtlas& operator=(const FontAtlas&) = delete;

	double width(std::string_view text, double size) const;
	// Returns the text, or its beginning and an ellipsis if it is too wide.
	std::string elided(std::string_view text, double size, double most) const;
	// Returns lines no wider than `most`, broken after blanks and punctuation if there are any. If more than `lines`
	// are needed, the last one ends with an ellipsis.
	std::vector<std::string> wrapped(std::string_view text, double size, double most, std::size_t lines) const;

	// A part of a text whose letters are in one font.
	struct Run
	{
		const Typeface* font;
		std::string text;
	};
	std::vector<Run> runs(std::string_view text) const;

	ImDrawListSharedData* shared() const { return shared_.get(); }
	ImFont* font(double size) const;

	// Coverage, a byte a texel.
	const unsigned char* texels() const { return texels_; }
	glm::ivec2 texelSize() const { return texel_size_; }

private:
	struct SharedDeleter
	{
		void operator()(ImDrawListSharedData* data) const;
	};

	std::size_t builtIn() const; // its place in typefaces_
	void addSize(double size, std::vector<ImVector<ImWchar>>& ranges);

	std::vector<const Typeface*> typefaces_; // each letter is taken from the first one that has it
	ImFontAtlas atlas_;
	std::map<double, ImFont*> fonts_; // by size
	std::unique_ptr<ImDrawListSharedData, SharedDeleter> shared_;
	unsigned char* texels_ = nullptr;
	glm::ivec2 texel_size_{0};
};

// Keeps the last lettering, for pictures that need the same letters.
class KeptLettering
{
public:
	// The parameters are those of FontAtlas.
	std::shared_ptr<const FontAtlas> get(const std::vector<double>& sizes, const std::vector<std::string>& texts,
	                                     const Typeface& font = Typeface::builtIn());

private:
	std::vector<double> sizes_;
	const Typeface* font_ = nullptr;
	std::set<char32_t> letters_; // besides those that are always there
	std::shared_ptr<const FontAtlas> kept_;
};

} // namespace vp::render
