#pragma once

#include "view/view_spec.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vp::view
{

// The table of everything that can be set. A new setting is one line in settings_table.cpp and a member of ViewSpec.
// Options of the command line, the manual pages, completions, state files and their schema, setByKey() and the tips of
// the window come from the table.

/// Names of inputs. In the file they are relative to its folder; demo:NAME does not change.
struct Files
{
	std::vector<std::string>* names;
};

/// The name of one file, kept in the same way; empty for none.
struct File
{
	std::string* name;
};

/// The name of something that is built in or installed, or of a .json or font file, which is kept in the same way.
struct NameOrFile
{
	std::string* name;
};

/// A value that is written as text (words.h); empty if it is not set.
struct Text
{
	std::function<std::optional<std::string>()> get;
	std::function<Status(const std::string&)> set; // the error names neither the setting nor the text
	std::vector<std::string> words{};              // the possible texts; empty: there is no list of them
	std::string if_not_set{};                      // the value that an empty one stands for, if there is such a value
};

/// The largest number of texts or numbers in a setting that holds any number of them.
constexpr std::size_t kMaxListed = 64;

/// Several values of this kind.
struct Texts
{
	std::function<std::vector<std::string>()> get;
	std::function<Status(const std::vector<std::string>&)> set;
};

/// This number of finite numbers; empty if it is not set.
struct Numbers
{
	std::size_t count; // 0 means any number
	std::function<std::vector<double>()> get;
	std::function<void(const std::vector<double>&)> set;
};

/// A number of bytes. A command line may have 1G or 512M.
struct Bytes
{
	double* value;
};

/// A built-in thing by its name, or one that the user made, which the state contains as a whole.
struct ProbeChoice
{
	ProbeSpec* probe;
};
struct PathChoice
{
	SweepSpec* sweep;
};

/// Points to the value of a setting. An empty string or optional is not written. A key that the file lacks does not
/// change the value.
using Place =
    std::variant<std::string*, std::optional<std::string>*, int*, std::optional<int>*, double*, std::optional<double>*,
                 bool*, Bytes, Text, Texts, Numbers, Files, File, NameOrFile, ProbeChoice, PathChoice>;

/// The range of a number, ends included.
struct Limits
{
	double lo;
	double hi;
	const char* instead = ""; // what the user may have meant by a number below `lo`
};

/// The commands that have the option of a setting, among those that have its section.
enum class Offer : std::uint8_t
{
	always,
	in_space, // commands that draw pictures in space
	flat,     // commands that draw sheets flat
	with_cuts // commands that cut
};

struct Setting
{
	const char* key; // the name of the option, with _ for -
	Place place;
	std::string help;               // a sentence for people, without the point at its end
	std::string values{};           // the form of the values, such as "LO HI"; empty: it follows from the place
	std::optional<Limits> limits{}; // for numbers
	Offer offer = Offer::always;
};

struct Section
{
	const char* key;
	const char* title; // the group of the options; empty: they are in no group
	std::vector<Setting> settings;
};

/// Returns all settings except those of the machine. They point into `spec`.
std::vector<Section> sectionsOf(ViewSpec& spec);

/// Returns the settings of the machine, which no state file holds. They point into `spec`.
Section machineSection(ViewSpec& spec);

/// Returns all of them.
std::vector<Section> allSectionsOf(ViewSpec& spec);

/// Returns one of these sections by its key. The key must exist.
Section sectionOf(ViewSpec& spec, std::string_view key);

/// Returns a setting by its key. It points into `spec`. The key must exist.
Setting settingOf(ViewSpec& spec, std::string_view key);

/// Sets a setting by its key to a value as on a command line; several numbers or words have blanks between them. A
/// usage error names the key, or lists the known keys. validate() checks the limits of numbers.
Status setByKey(ViewSpec& spec, std::string_view key, const std::string& text);

/// The name of a path: one of probe::PathKind without keyframes, or "times".
std::vector<std::string> pathKindNames();
Status setPathKind(SweepSpec& sweep, std::string_view name);
std::string pathKindText(const SweepSpec& sweep);

/// Returns the reason why a number is impossible for a setting; empty if it is possible.
std::string refusal(const Setting& setting);

} // namespace vp::view
