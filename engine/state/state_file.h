#pragma once

#include "base/result.h"
#include "probe/path_file.h"
#include "probe/probe_file.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vp::state
{

// Everything a user set, kept in a JSON file of a known version. docs/PROBES.md explains the file,
// docs/state.schema.json describes it to programs.

constexpr int kVersion = 1;

// Names of inputs. In the file they are relative to its own folder; demo:NAME stays as it is.
struct Files
{
	std::vector<std::string>* names;
};

// One file's name, kept in the same way; empty for none.
struct File
{
	std::string* name;
};

// A built-in one's name, or a .json file's, which is kept in the same way.
struct NameOrFile
{
	std::string* name;
};

// A built-in one by its name, or one of the user's making, which stands in the state whole. Read from there it is
// `own`, and the name is empty.
struct ProbeChoice
{
	std::string* name;
	std::optional<probe::ProbeFile>* own;
};
struct PathChoice
{
	std::string* name;
	std::optional<probe::Path>* own;
};

// Where a setting's value lies. An empty string or vector and an absent optional are not written; a key that is left
// out leaves the value as it is.
using Place = std::variant<std::string*, std::optional<std::string>*, int*, std::optional<int>*, double*,
                           std::optional<double>*, bool*, std::vector<double>*, std::vector<std::string>*, Files, File,
                           NameOrFile, ProbeChoice, PathChoice>;

struct Setting
{
	const char* key;
	Place place;
};

struct Section
{
	const char* key;
	std::vector<Setting> settings;
};

using Sections = std::vector<Section>;

// Writes the file, whole or not at all. Read and written again it is the same to the last bit. An output error.
Status save(const Sections& sections, const std::string& file);

// Reads it into the places. An input error names the file, where in it (a JSON pointer) and the remedy; unknown keys
// and other versions are such.
Status load(const Sections& sections, const std::string& file);

// A setting's value as words, one a number; none where it has no value, or one of its own making.
std::vector<std::string> valuesOf(const Setting& setting);

} // namespace vp::state
