#pragma once

#include "base/result.h"
#include "probe/probe.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace vp::probe
{

// Reads and writes a probe as JSON. docs/PROBES.md explains the file, docs/probe.schema.json describes it to
// programs. Anything else is an input error: one line with the file, the place in it (a JSON pointer) and the remedy.

constexpr double kMinMagnification = 1e-6;
constexpr double kMaxMagnification = 1e6;
constexpr int kMaxLines = 1000; // contour lines of a sheet

struct ProbeFile
{
	Probe probe;         // at the origin of the world if the file does not place it
	bool placed = false; // the file places it

	bool operator==(const ProbeFile&) const = default;
};

Result<ProbeFile> readProbe(const std::string& file);
Result<ProbeFile> parseProbe(std::string_view text, const std::string& source);

// Reads a probe inside a larger document. `path` is the pointer to it, for errors.
Result<ProbeFile> probeFromJson(const nlohmann::json& value, const std::string& source, const std::string& path);

// Writes a probe. Reading it gives the same probe to the last bit.
nlohmann::json toJson(const Probe& probe);
std::string probeText(const Probe& probe);

} // namespace vp::probe
