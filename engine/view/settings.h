#pragma once

#include "view/view_spec.h"

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vp::view
{

// The one list of what a state file holds. A new setting is one line in settings.cpp, and a member of ViewSpec.

/// Names of inputs. In the file they are relative to its own folder; demo:NAME stays as it is.
struct Files
{
	std::vector<std::string>* names;
};

/// One file's name, kept in the same way; empty for none.
struct File
{
	std::string* name;
};

/// A built-in one's name, or a .json file's, which is kept in the same way.
struct NameOrFile
{
	std::string* name;
};

/// A value that has a text of its own (words.h). None where it is not set.
struct Text
{
	std::function<std::optional<std::string>()> get;
	std::function<Status(const std::string&)> set; // the error names neither the setting nor the text
};

/// Several of them.
struct Texts
{
	std::function<std::vector<std::string>()> get;
	std::function<Status(const std::vector<std::string>&)> set;
};

/// So many finite numbers, none where it is not set.
struct Numbers
{
	std::size_t count; // 0: any
	std::function<std::vector<double>()> get;
	std::function<void(const std::vector<double>&)> set;
};

/// A built-in one by its name, or one of the user's making, which stands in the state whole.
struct ProbeChoice
{
	ProbeSpec* probe;
};
struct PathChoice
{
	SweepSpec* sweep;
};

/// Where a setting's value lies. An empty string and an absent optional are not written; a key that is left out leaves
/// the value as it is.
using Place =
    std::variant<std::string*, std::optional<std::string>*, int*, std::optional<int>*, double*, std::optional<double>*,
                 bool*, Text, Texts, Numbers, Files, File, NameOrFile, ProbeChoice, PathChoice>;

/// What a number may be; both ends belong to it.
struct Limits
{
	double lo;
	double hi;
	const char* instead = ""; // what a number below `lo` may have meant
};

struct Setting
{
	const char* key; // the option's name, _ for -
	Place place;
	std::optional<Limits> limits{}; // of numbers
};

struct Section
{
	const char* key;
	std::vector<Setting> settings;
};

/// All of it but what belongs to the machine. The places lie in `spec`.
std::vector<Section> sectionsOf(ViewSpec& spec);

/// What belongs to the machine, and is none of a state file. The places lie in `spec`.
Section machineSection(ViewSpec& spec);

/// Sets any setting by its key, to a value as a command line has it; several numbers or words stand with blanks between
/// them. A usage error names the key, or the keys there are. The limits of numbers are for validate().
Status setByKey(ViewSpec& spec, std::string_view key, const std::string& text);

/// A name of a path: one of probe::PathKind's, or "times".
Status setPathKind(SweepSpec& sweep, std::string_view name);
std::string pathKindText(const SweepSpec& sweep);

/// The reason why a setting's number cannot be; empty where it can.
std::string refusal(const Setting& setting);

} // namespace vp::view
