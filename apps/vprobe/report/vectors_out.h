#pragma once

#include "report/stats_json.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace vp::app
{

// Carries out --vectors-out: writes the paths of the launched particles as .vtp.
void addVectorsOut(CLI::App& command, std::string& file);

// Checks the option before a large file is read. others: other options that may write to standard output, and their
// values.
struct OtherOutput
{
	const char* option;
	const std::string& file;
};
Status checkVectorsOut(const view::VectorSpec& vectors, const std::string& file,
                       const std::vector<OtherOutput>& others);

// Section "write" on the timeline. An empty path does nothing.
Status writeVectors(const session::Session& session, const std::vector<session::SheetStats>& sheets,
                    const std::string& file);

} // namespace vp::app
