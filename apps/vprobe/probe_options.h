#pragma once

#include "base/result.h"
#include "base/timeline.h"
#include "gpu/device.h"
#include "grid/block.h"
#include "probe/probe_file.h"
#include "read/read.h"
#include "slice/field_choice.h"
#include "slice/slicer.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// INPUT... and the PROBE options, as they stand on the command line.
struct ProbeOptions
{
	std::vector<std::string> inputs;
	std::string probe = "single"; // or another built-in one, or a .json file; empty: own_probe
	std::optional<probe::ProbeFile> own_probe{};
	std::vector<double> origin;        // three numbers, or none: the centre of the bounds
	std::optional<std::string> normal; // x, y, z or three numbers
	std::vector<double> up;            // three numbers, or none
	std::vector<double> window;        // none, or width and height
	std::optional<int> vanes;
	std::vector<double> offsets;
	std::optional<int> sheets;
	std::optional<std::string> corners; // keep where none is given
	std::string array;
	std::string component;
	std::vector<double> threshold; // none, or LO and HI
	std::string time = "last";
	std::string solution;
	int refine = 0;
	double displace = 0.0;
	std::string seeds = "auto";
	std::string outside = "nearest";
	std::string classify = "gpu";
	bool classify_given = false;
	std::string device;
	int threads = 0;
};

// Adds them to a command.
CLI::Option* addInputs(CLI::App& command, ProbeOptions& options);
void addProbeOptions(CLI::App& command, ProbeOptions& options); // with the device's
void addDeviceOptions(CLI::App& command, ProbeOptions& options);

// What a command cuts and by what, made ready from the options. The slicer refers to the blocks, the device serves
// slicer and drawing.
struct Session
{
	grid::BlockSet blocks;
	std::optional<slice::FieldChoice> field;
	probe::Probe probe; // without its hidden sheets
	std::vector<std::optional<slice::FieldChoice>> sheet_fields;
	slice::Corners corners = slice::Corners::keep;
	seed::SeedOptions seeds;
	std::optional<slice::Threshold> threshold;
	std::unique_ptr<gpu::Device> device; // null where the CPU does without
	std::unique_ptr<slice::Slicer> slicer;
	std::unique_ptr<Timeline> timeline;
};

enum class DeviceUse
{
	classify, // a device is wanted for the GPU classifier only
	draw      // a device is needed in any case
};

// Reads the inputs and builds the rest. Nothing is written before this has succeeded.
Result<std::unique_ptr<Session>> openSession(const ProbeOptions& options, DeviceUse use);

// How the inputs are read at one of their times.
read::ReadOptions readOptions(const ProbeOptions& options, const read::TimeChoice& time);

// A slicer for the blocks that the session has now.
Status makeSlicer(Session& session, const ProbeOptions& options);

Result<slice::Slice> cut(Session& session);

bool isEmpty(const slice::SheetSlice& sheet);

// Tells the user in a word what is empty or was moved; an error where a hot spot outside is to be one.
Status tellAbout(const Session& session, const slice::Slice& slice);

} // namespace vp::app
