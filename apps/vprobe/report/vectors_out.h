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

// --vectors-out: what is launched from the sheets, as .vtp.
void addVectorsOut(CLI::App& command, std::string& file);

// Told before a large file is read. others: what else may go to standard output, as their options name it ("-o").
struct OtherOutput
{
	const char* option;
	const std::string& file;
};
Status checkVectorsOut(const view::VectorSpec& vectors, const std::string& file,
                       const std::vector<OtherOutput>& others);

// Section "write". "" does nothing.
Status writeVectors(const session::Session& session, const std::vector<session::SheetStats>& sheets,
                    const std::string& file);

} // namespace vp::app
