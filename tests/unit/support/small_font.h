#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace vp::test
{

// The bytes of a TrueType font, which has the high byte of a number first.
class FontBytes
{
public:
	FontBytes& u16(std::uint32_t value)
	{
		text_ += static_cast<char>(value >> 8 & 255u);
		text_ += static_cast<char>(value & 255u);
		return *this;
	}
	FontBytes& u32(std::uint32_t value) { return u16(value >> 16).u16(value & 0xffffu); }
	FontBytes& many(std::initializer_list<std::uint32_t> values)
	{
		for (const std::uint32_t value : values)
			u16(value);
		return *this;
	}
	FontBytes& add(const std::string& text)
	{
		text_ += text;
		return *this;
	}
	const std::string& text() const { return text_; }

private:
	std::string text_;
};

inline constexpr std::uint32_t kFontEm = 1000;

// Format 4: a segment for each letter, and one that ends the list.
inline std::string cmapTable(const std::vector<std::uint16_t>& letters)
{
	const auto count = static_cast<std::uint32_t>(letters.size());
	const std::uint32_t segments = count + 1;
	std::uint32_t power = 1;
	std::uint32_t shift = 0;
	for (; 2 * power <= segments; power *= 2)
		++shift;
	FontBytes cmap;
	cmap.many({0, 1, 3, 1}).u32(12);
	cmap.many({4, 16 + 8 * segments, 0, 2 * segments, 2 * power, shift, 2 * (segments - power)});
	for (const std::uint32_t letter : letters)
		cmap.u16(letter);
	cmap.many({0xffff, 0});
	for (const std::uint32_t letter : letters)
		cmap.u16(letter);
	cmap.u16(0xffff);
	for (std::uint32_t i = 0; i < count; ++i)
		cmap.u16((i + 1u - letters[i]) & 0xffffu);
	cmap.u16(1);
	for (std::uint32_t i = 0; i < segments; ++i)
		cmap.u16(0);
	return cmap.text();
}

// One contour of four points, whose coordinates are words: from the baseline up, as wide as it is high.
inline std::string boxGlyph()
{
	FontBytes box;
	box.many({1, 0, 0, kFontEm, kFontEm, 3, 0}).add("\x01\x01\x01\x01");
	return box.many({0, kFontEm, 0, 0x10000u - kFontEm, 0, 0, kFontEm, 0}).text();
}

inline std::string nameTable(const std::string& family)
{
	const auto wide = [](const std::string& text)
	{
		FontBytes made;
		for (const char c : text)
			made.u16(static_cast<unsigned char>(c));
		return made.text();
	};
	const std::pair<std::uint32_t, std::string> names[] = {{1, wide(family)}, {2, wide("Regular")}, {4, wide(family)}};
	FontBytes table;
	table.many({0, 3, 6 + 3 * 12});
	std::uint32_t at = 0;
	for (const auto& [kind, text] : names)
	{
		table.many({3, 1, 0x409, kind, static_cast<std::uint32_t>(text.size()), at});
		at += static_cast<std::uint32_t>(text.size());
	}
	for (const auto& [kind, text] : names)
		table.add(text);
	return table.text();
}

// Returns a TrueType font with few letters, in ascending order, each a box that fills its em. Its lines reach from 1 em
// above the baseline to 0.2 em below. FreeType, stb_truetype and fontconfig take it.
inline std::string smallFont(const std::string& family, const std::vector<std::uint16_t>& letters)
{
	const auto glyphs = static_cast<std::uint32_t>(letters.size() + 1); // the first one stands for what is missing
	FontBytes glyf;
	FontBytes loca;
	FontBytes hmtx;
	loca.u32(0);
	for (std::uint32_t g = 0; g < glyphs; ++g)
	{
		glyf.add(boxGlyph());
		loca.u32(static_cast<std::uint32_t>(glyf.text().size()));
		hmtx.many({kFontEm, 0});
	}
	FontBytes head;
	head.u32(0x10000).u32(0x10000).u32(0).u32(0x5F0F3CF5).many({0, kFontEm}).u32(0).u32(0).u32(0).u32(0);
	head.many({0, 0, kFontEm, kFontEm, 0, 8, 2, 1, 0});
	FontBytes hhea;
	hhea.u32(0x10000).many({kFontEm, 0x10000u - 200, 0, kFontEm, 0, 0, kFontEm, 1, 0, 0, 0, 0, 0, 0, 0, glyphs});
	FontBytes maxp;
	maxp.u32(0x10000).many({glyphs, 4, 1, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0});

	const std::pair<const char*, std::string> tables[] = {
	    {"cmap", cmapTable(letters)}, {"glyf", glyf.text()}, {"head", head.text()}, {"hhea", hhea.text()},
	    {"hmtx", hmtx.text()},        {"loca", loca.text()}, {"maxp", maxp.text()}, {"name", nameTable(family)}};
	constexpr std::uint32_t kTables = 8;
	FontBytes file;
	file.u32(0x10000).many({kTables, 128, 3, 0});
	std::string bodies;
	for (const auto& [tag, body] : tables)
	{
		file.add(tag).u32(0).u32(12 + 16 * kTables + static_cast<std::uint32_t>(bodies.size()));
		file.u32(static_cast<std::uint32_t>(body.size()));
		bodies += body + std::string((4 - body.size() % 4) % 4, '\0');
	}
	return file.add(bodies).text();
}

} // namespace vp::test
