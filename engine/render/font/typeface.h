#pragma once

#include "base/result.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

typedef struct FT_FaceRec_* FT_Face;

namespace vp::render
{

// From the top of DejaVu Sans' highest letter to the bottom of its lowest, in em. The sizes of FontAtlas and Layout are
// such heights, while type is measured in em.
constexpr double kLetterAscent = 1901.0 / 2048.0;
constexpr double kLetterDescent = 483.0 / 2048.0;
constexpr double kLetterHeight = kLetterAscent + kLetterDescent;

// A font of outlines, in memory. It lives as long as the program, since cairo may keep a face longer than a picture.
class Typeface
{
public:
	Typeface(const Typeface&) = delete;
	Typeface& operator=(const Typeface&) = delete;

	std::span<const std::byte> bytes() const { return bytes_; }
	int number() const { return number_; }      // in a collection
	double ascent() const { return ascent_; }   // em, above the baseline; as stb_truetype takes it
	double descent() const { return descent_; } // em, below the baseline
	bool has(char32_t letter) const;

	// Returns the font that comes with the program, DejaVu Sans.
	static const Typeface& builtIn();

	// Returns the font in a file, or the one that fontconfig gives for a family. The input error names neither the
	// setting nor the text.
	static Result<const Typeface*> find(const std::string& family_or_file);

	// Returns fonts of the system, each of which has some of these letters that no font before it has. A warning names
	// letters that no font has, each once in the life of the program.
	static std::vector<const Typeface*> having(const std::vector<char32_t>& letters);

private:
	Typeface(std::vector<std::byte> kept, std::span<const std::byte> bytes, int number, FT_Face face);
	static Result<const Typeface*> fromFile(const std::string& file, int number);

	std::vector<std::byte> kept_; // empty if it is built in
	std::span<const std::byte> bytes_;
	int number_;
	FT_Face face_;
	mutable std::mutex face_mutex_;
	double ascent_ = 0.0;
	double descent_ = 0.0;
};

// Returns true if a text names a font file rather than a family.
bool namesFontFile(std::string_view text);

} // namespace vp::render
