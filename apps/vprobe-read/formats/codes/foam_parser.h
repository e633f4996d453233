#pragma once

#include "foam_dictionary.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::codes
{

constexpr std::string_view kFoamHeadName = "FoamFile";
constexpr int kMaxFoamNesting = 64; // for braces and for included files

// A text and the file that it is of.
struct FoamInput
{
	FoamCursor& at;
	const std::filesystem::path& file;
};

// Reads entries with their macros, included files and conditions, as OpenFOAM does. foam_directives.cpp has what
// begins with a #.
class FoamParser
{
public:
	FoamParser(const FoamFiles& files, std::vector<FoamSource>& included, std::vector<std::string>& skipped)
	    : files_(files), included_(included), skipped_(skipped)
	{
	}

	// Up to the closing mark, which stays, or the end.
	void readEntries(FoamInput& in, FoamDictionary& into, char end);

private:
	enum class Mode
	{
		merge,
		overwrite,
		keep_first
	};

	void work(std::size_t steps);
	const FoamEntry* ofMacro(std::string_view name, const FoamDictionary& from, bool with_patterns = false);
	void put(FoamDictionary& into, FoamEntry entry);
	void readEntry(const std::string& key, bool is_pattern, FoamInput& in, FoamDictionary& into);
	// The dictionary that is all of a value, as in "outlet $inlet;".
	const FoamEntry* wholeDictionary(const FoamEntry& entry, const FoamDictionary& from);
	// The tokens up to the semicolon; of an included file those up to its end.
	void readValue(FoamInput& in, const FoamDictionary& from, FoamEntry& entry, bool to_end);
	void expand(const FoamToken& macro, const FoamDictionary& from, FoamEntry& entry);
	// An entry by itself that is a macro: the entries of a dictionary, or a key.
	void substitute(std::string_view name, FoamInput& in, FoamDictionary& into);
	void merge(FoamDictionary& into, FoamEntry entry);
	// The one that is there already, if dictionaries are merged.
	std::shared_ptr<FoamDictionary> dictionaryFor(const std::string& key, const FoamDictionary& in) const;
	std::shared_ptr<FoamDictionary> copyOf(const FoamDictionary& dictionary, const FoamDictionary* parent);

	void readDirective(std::string_view name, FoamInput& in, FoamDictionary& into);
	void setMode(std::string_view mode);
	void removeEntries(FoamCursor& at, FoamDictionary& into);
	// Returns the text that stands for one word of a condition.
	std::string wordOfCondition(FoamCursor& at, const FoamDictionary& from);
	void readCondition(std::string_view name, FoamCursor& at, const FoamDictionary& from);
	// Behind the #endif, or behind the #else if it is wanted.
	void skipBranch(FoamCursor& at, bool to_else);
	// Those that run code: the line with its block.
	void skipDirective(std::string_view name, FoamInput& in, const FoamDictionary& from);
	// The file that is named next; nothing if it is not there.
	std::optional<FoamSource> opened(std::string_view directive, FoamInput& in, const FoamDictionary& from);
	static std::string lackOf(std::string_view directive);
	std::filesystem::path pathOf(std::string name, const std::filesystem::path& file, const FoamDictionary& from);
	static FoamCursor inside(const FoamSource& source);
	void includeEntries(std::string_view directive, FoamInput& in, FoamDictionary& into);
	void includeValue(std::string_view directive, FoamInput& in, const FoamDictionary& from, FoamEntry& entry);

	const FoamFiles& files_;
	std::vector<FoamSource>& included_;
	std::vector<std::string>& skipped_;
	Mode mode_ = Mode::merge;
	int depth_ = 0;
	int conditions_ = 0; // open ones
	std::size_t work_ = 0;
};

} // namespace vp::reader::codes
