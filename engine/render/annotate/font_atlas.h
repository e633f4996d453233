#pragma once

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

// The font at a few sizes, with the letters of given texts only, and ImGui's draw lists without an ImGui context:
// pictures are made on any thread, beside a window or without one.
class FontAtlas
{
public:
	// `texts` is all that will be written, UTF-8; digits, ASCII letters and the ellipsis are there anyway.
	FontAtlas(const std::vector<double>& sizes, const std::vector<std::string>& texts);
	~FontAtlas();
	FontAtlas(const FontAtlas&) = delete;
	FontAtlas& operator=(const FontAtlas&) = delete;

	double width(std::string_view text, double size) const;
	// The text, or its beginning and an ellipsis where it is too wide.
	std::string elided(std::string_view text, double size, double most) const;
	// Lines no wider than `most`, broken after blanks and punctuation where there are any; the last of `lines` is
	// elided.
	std::vector<std::string> wrapped(std::string_view text, double size, double most, std::size_t lines) const;

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

	ImFontAtlas atlas_;
	std::map<int, ImFont*> fonts_; // by size in pixels
	std::unique_ptr<ImDrawListSharedData, SharedDeleter> shared_;
	unsigned char* texels_ = nullptr;
	glm::ivec2 texel_size_{0};
};

// The lettering that was asked for last, for pictures that are written with the same letters.
class KeptLettering
{
public:
	// As FontAtlas's.
	std::shared_ptr<const FontAtlas> get(const std::vector<double>& sizes, const std::vector<std::string>& texts);

private:
	std::vector<int> pixels_;
	std::set<unsigned> letters_; // beside those that are there anyway
	std::shared_ptr<const FontAtlas> kept_;
};

} // namespace vp::render
