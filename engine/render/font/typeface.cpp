#include "render/font/typeface.h"

#include "base/messages.h"
#include "base/sanitized.h"
#include "render/font/font.h"

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <utf8.h>
#include FT_FREETYPE_H
#include FT_TRUETYPE_TABLES_H

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#ifdef VP_SANITIZED
// fontconfig loses some 300 bytes where it reads its configuration.
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_suppressions()
{
	return "leak:libfontconfig.so\n";
}
extern "C" __attribute__((visibility("default"))) const char* __lsan_default_options()
{
	return "print_suppressions=0"; // a program says nothing of it
}
#endif

namespace vp::render
{

namespace
{

// Fonts that were asked for, by file and number.
struct Shelf
{
	std::mutex mutex;
	std::map<std::pair<std::string, int>, std::unique_ptr<const Typeface>> fonts;
	std::map<std::string, const Typeface*> families; // as they were asked for
	std::set<char32_t> without_font;                 // letters that a warning has named
};

Shelf& shelf()
{
	static Shelf the_shelf;
	return the_shelf;
}

FT_Library freeType()
{
	static FT_Library library = []
	{
		FT_Library made = nullptr;
		if (FT_Init_FreeType(&made) != 0)
			throw std::logic_error("FreeType cannot start");
		return made;
	}();
	return library;
}

// Opens a font that both FreeType and stb_truetype can draw: with the outlines of TrueType or CFF. Null for others.
FT_Face openFace(std::span<const std::byte> bytes, int number)
{
	static std::mutex of_library;
	const std::lock_guard lock(of_library);
	FT_Face face = nullptr;
	if (FT_New_Memory_Face(freeType(), reinterpret_cast<const FT_Byte*>(bytes.data()),
	                       static_cast<FT_Long>(bytes.size()), number, &face) != 0)
		return nullptr;
	const auto* measures = static_cast<const TT_HoriHeader*>(FT_Get_Sfnt_Table(face, FT_SFNT_HHEA));
	if (FT_IS_SCALABLE(face) && FT_IS_SFNT(face) && face->charmap && measures &&
	    measures->Ascender > measures->Descender && face->units_per_EM > 0)
		return face;
	FT_Done_Face(face);
	return nullptr;
}

struct FcDestroyer
{
	void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
	void operator()(FcFontSet* fonts) const { FcFontSetDestroy(fonts); }
	void operator()(FcCharSet* letters) const { FcCharSetDestroy(letters); }
};
using Pattern = std::unique_ptr<FcPattern, FcDestroyer>;
using FontSet = std::unique_ptr<FcFontSet, FcDestroyer>;

std::string textOf(const FcPattern* font, const char* key)
{
	FcChar8* text = nullptr;
	return FcPatternGetString(font, key, 0, &text) == FcResultMatch ? reinterpret_cast<const char*>(text) : "";
}

struct FontPlace
{
	std::string family;
	std::string file;
	int number = 0;
};

bool hasOneOf(const FcPattern* font, const std::vector<char32_t>& letters)
{
	FcCharSet* of_font = nullptr;
	if (FcPatternGetCharSet(font, FC_CHARSET, 0, &of_font) != FcResultMatch)
		return false;
	return std::ranges::any_of(letters, [&](char32_t letter) { return FcCharSetHasChar(of_font, letter) == FcTrue; });
}

// Returns the fonts of the system with outlines, the best for a pattern first. letters: if there are any, only fonts
// that have one of them.
std::vector<FontPlace> sortedFonts(FcPattern* pattern, const std::vector<char32_t>& letters = {})
{
	std::vector<FontPlace> places;
	FcPatternAddBool(pattern, FC_SCALABLE, FcTrue);
	if (!FcConfigSubstitute(nullptr, pattern, FcMatchPattern))
		return places;
	FcDefaultSubstitute(pattern);
	FcResult result = FcResultNoMatch;
	const FontSet fonts(FcFontSort(nullptr, pattern, FcFalse, nullptr, &result));
	for (int i = 0; fonts && i < fonts->nfont; ++i)
	{
		const FcPattern* font = fonts->fonts[i];
		const std::string format = textOf(font, FC_FONTFORMAT);
		FontPlace place{textOf(font, FC_FAMILY), textOf(font, FC_FILE)};
		FcPatternGetInteger(font, FC_INDEX, 0, &place.number);
		place.number &= 0xffff; // the rest says which instance of a variable font
		if ((format == "TrueType" || format == "CFF") && !place.file.empty() &&
		    (letters.empty() || hasOneOf(font, letters)))
			places.push_back(std::move(place));
	}
	return places;
}

std::vector<FontPlace> fontsOfFamily(const std::string& family)
{
	const Pattern pattern(FcPatternCreate());
	FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
	return sortedFonts(pattern.get());
}

bool isGenericFamily(const std::string& family)
{
	static constexpr std::array kGeneric{"sans", "sans-serif", "serif", "monospace", "mono", "cursive", "fantasy"};
	return std::ranges::find(kGeneric, family) != kGeneric.end();
}

bool hasEnding(std::string_view text, std::string_view ending)
{
	return text.size() > ending.size() &&
	       std::equal(ending.rbegin(), ending.rend(), text.rbegin(),
	                  [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
}

// Letters that are drawn: not blanks, and nothing that only controls other letters.
bool isDrawn(char32_t letter)
{
	return letter > 0x20 && !(letter >= 0x7f && letter <= 0xa0) && !(letter >= 0x2000 && letter <= 0x200f) &&
	       !(letter >= 0x2028 && letter <= 0x202f) && letter != 0x3000 && !(letter >= 0xfe00 && letter <= 0xfe0f) &&
	       letter != 0xfeff && letter != 0xfffd;
}

void warnOfLetters(const std::vector<char32_t>& letters)
{
	std::string names;
	std::string codes;
	{
		const std::lock_guard lock(shelf().mutex);
		for (const char32_t letter : letters)
			if (shelf().without_font.insert(letter).second)
			{
				utf8::append(letter, std::back_inserter(names));
				codes += fmt::format("{}U+{:04X}", codes.empty() ? "" : ", ", static_cast<std::uint32_t>(letter));
			}
	}
	if (!names.empty())
		warn(
		    "no installed font has the letters '{}' ({}), so other marks are drawn; install one that has them, or name "
		    "its file by `font`",
		    names, codes);
}

} // namespace

Typeface::Typeface(std::vector<std::byte> kept, std::span<const std::byte> bytes, int number, FT_Face face)
    : kept_(std::move(kept)), bytes_(bytes), number_(number), face_(face)
{
	const auto* measures = static_cast<const TT_HoriHeader*>(FT_Get_Sfnt_Table(face, FT_SFNT_HHEA));
	ascent_ = measures->Ascender / static_cast<double>(face->units_per_EM);
	descent_ = -measures->Descender / static_cast<double>(face->units_per_EM);
}

bool Typeface::has(char32_t letter) const
{
	const std::lock_guard lock(face_mutex_);
	return FT_Get_Char_Index(face_, letter) != 0;
}

const Typeface& Typeface::builtIn()
{
	static const Typeface* const font = []
	{
		const auto bytes = fontFile();
		const FT_Face face = openFace(bytes, 0);
		if (!face)
			throw std::logic_error("the font that is built in cannot be read");
		return new Typeface({}, bytes, 0, face);
	}();
	return *font;
}

Result<const Typeface*> Typeface::fromFile(const std::string& file, int number)
{
	const std::lock_guard lock(shelf().mutex);
	auto& known = shelf().fonts[{file, number}];
	if (known)
		return known.get();
	std::error_code failed;
	if (!std::filesystem::is_regular_file(file, failed))
		return Error{ErrorKind::input, "no such file; name a font file, or an installed family"};
	std::ifstream stream(file, std::ios::binary | std::ios::ate);
	std::vector<std::byte> bytes(stream ? static_cast<std::size_t>(stream.tellg()) : 0);
	stream.seekg(0);
	stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
	if (!stream)
		return Error{ErrorKind::input, "the file cannot be read; look at its permissions"};
	const std::span<const std::byte> view(bytes); // moving a vector leaves its bytes in their place
	const FT_Face face = openFace(view, number);
	if (!face)
		return Error{ErrorKind::input, "is no TrueType or OpenType font with outlines; name another file"};
	known.reset(new Typeface(std::move(bytes), view, number, face));
	return known.get();
}

Result<const Typeface*> Typeface::find(const std::string& family_or_file)
{
	if (family_or_file.empty())
		return &builtIn();
	if (namesFontFile(family_or_file))
		return fromFile(family_or_file, 0);
	{
		const std::lock_guard lock(shelf().mutex);
		if (const auto known = shelf().families.find(family_or_file); known != shelf().families.end())
			return known->second;
	}
	const std::vector<FontPlace> fonts = fontsOfFamily(family_or_file);
	const auto isAsked = [&](const FontPlace& font)
	{
		return FcStrCmpIgnoreCase(reinterpret_cast<const FcChar8*>(font.family.c_str()),
		                          reinterpret_cast<const FcChar8*>(family_or_file.c_str())) == 0;
	};
	// fontconfig names a font for every family. It knows a family, as another name of one that is installed, if that
	// differs from the font for a name that nobody knows.
	const auto isOtherName = [&]
	{
		const std::vector<FontPlace> unknown = fontsOfFamily("a family that nobody knows");
		return !fonts.empty() && (unknown.empty() || unknown.front().file != fonts.front().file);
	};
	if (fonts.empty() || !(isAsked(fonts.front()) || isGenericFamily(family_or_file) || isOtherName()))
		return Error{ErrorKind::input, "no such family is installed; fc-list : family lists them, or name a file"};
	Result<const Typeface*> font = fromFile(fonts.front().file, fonts.front().number);
	if (font)
	{
		const std::lock_guard lock(shelf().mutex);
		shelf().families[family_or_file] = *font;
	}
	return font;
}

std::vector<const Typeface*> Typeface::having(const std::vector<char32_t>& letters)
{
	std::vector<char32_t> missing;
	std::ranges::copy_if(letters, std::back_inserter(missing), isDrawn);
	std::vector<const Typeface*> found;
	if (missing.empty())
		return found;
	const Pattern pattern(FcPatternCreate());
	const std::unique_ptr<FcCharSet, FcDestroyer> wanted(FcCharSetCreate());
	for (const char32_t letter : missing)
		FcCharSetAddChar(wanted.get(), letter);
	FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted.get());
	FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
	for (const FontPlace& place : sortedFonts(pattern.get(), missing))
	{
		if (missing.empty())
			break;
		const Result<const Typeface*> font = fromFile(place.file, place.number);
		if (!font)
			continue;
		if (std::erase_if(missing, [&](char32_t letter) { return (*font)->has(letter); }) > 0)
			found.push_back(*font);
	}
	warnOfLetters(missing);
	return found;
}

bool namesFontFile(std::string_view text)
{
	return text.find('/') != std::string_view::npos || hasEnding(text, ".ttf") || hasEnding(text, ".otf") ||
	       hasEnding(text, ".ttc") || hasEnding(text, ".otc");
}

} // namespace vp::render
