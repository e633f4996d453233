#pragma once

#include "base/result.h"
#include "probe/probe_file.h"
#include "probe_options.h"

#include <optional>
#include <span>

namespace vp::app
{

// The --probe FILE.json, read; nothing where a built-in probe was asked for. Tells, before any input is read, what of
// the options that make the probe cannot be.
Result<std::optional<probe::ProbeFile>> checkProbeOptions(const ProbeOptions& options);

// The probe, where the options put it in the bounds.
Result<probe::Probe> makeProbe(const ProbeOptions& options, const std::optional<probe::ProbeFile>& file,
                               const Box& bounds);

// Usage error where a number is not finite.
Status requireFinite(std::span<const double> numbers, const char* option);

} // namespace vp::app
