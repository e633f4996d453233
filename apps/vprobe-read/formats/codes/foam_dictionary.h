#pragma once

#include "foam_cursor.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vp::reader::codes
{

class FoamDictionary;
class FoamPattern;

struct FoamEntry
{
	std::string key;
	std::shared_ptr<const FoamPattern> pattern; // null if the key is a plain name
	std::vector<FoamToken> tokens;              // the value, with its macros resolved
	std::shared_ptr<FoamDictionary> dictionary; // null if it is a value
	std::string unknown;                        // why its value is not known; mostly empty
};

// A dictionary of OpenFOAM. Of two entries of one name the last counts, and dictionaries of one name are merged, unless
// its file says otherwise.
class FoamDictionary
{
public:
	explicit FoamDictionary(const FoamDictionary* parent = nullptr) : parent_(parent) {}

	// The entry of that name, else the last one whose pattern fits; null if there is none.
	const FoamEntry* find(std::string_view name) const;
	// The entry of that name. A pattern is its own name.
	const FoamEntry* named(std::string_view name) const;
	// The entry that a macro means: "a", "a.b", ":a.b" from the top, ".a" from here, "..a" from the dictionary around.
	// OpenFOAM takes patterns for macros that stand by themselves, and not for those in values.
	const FoamEntry* ofMacro(std::string_view name, bool with_patterns) const;

	const std::vector<FoamEntry>& entries() const { return entries_; }
	std::size_t patterns() const { return patterns_; }
	const FoamDictionary* parent() const { return parent_; }
	// Replaces an entry of that name.
	void put(FoamEntry entry);
	void remove(std::string_view name);

private:
	const FoamEntry* below(std::string_view name, bool goes_up, bool with_patterns) const;

	const FoamDictionary* parent_;
	std::vector<FoamEntry> entries_;
	std::map<std::string, std::size_t, std::less<>> places_;
	std::size_t patterns_ = 0;
};

// A file that another one includes. `keeper` keeps its text alive.
struct FoamSource
{
	std::filesystem::path path;
	std::shared_ptr<const void> keeper;
	std::string_view text;
};

struct FoamFiles
{
	std::filesystem::path file;        // the one that is read
	std::filesystem::path case_folder; // what $FOAM_CASE means
	// Nothing if there is no such file.
	std::function<std::optional<FoamSource>(const std::filesystem::path&)> open;
};

// A file of entries. Its tokens are views of the texts.
struct FoamDocument
{
	FoamHead head;
	FoamDictionary root;
	std::vector<FoamSource> included;
	std::vector<std::string> skipped; // directives without effect here, in words
};

// `text` has to outlive the document.
std::unique_ptr<FoamDocument> parseFoam(std::string_view text, const FoamFiles& files);

// Entries up to the closing mark, which stays. They include no files.
void parseFoamEntries(FoamCursor& at, FoamDictionary& into, char end);

// A file's head, which begins it.
FoamHead parseFoamHead(FoamCursor& at);

} // namespace vp::reader::codes
