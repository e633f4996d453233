#pragma once

#include "base/result.h"
#include "probe/probe_file.h"
#include "probe_options.h"

#include <span>

namespace vp::app
{

// Reads the probe's file, where one is named, into own_probe.
Status readProbeFile(ProbeOptions& options);

// Tells, before any input is read, what of the options that make the probe cannot be.
Status checkProbeOptions(const ProbeOptions& options);

// The probe, its file read, where the options put it in the bounds.
Result<probe::Probe> makeProbe(const ProbeOptions& options, const Box& bounds);

// Usage error where a number is not finite.
Status requireFinite(std::span<const double> numbers, const char* option);

} // namespace vp::app
