#include "options/spec_options.h"

#include "read/file_index.h"
#include "read/sandbox.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace vp::app
{

// They are no settings: a state or a file of commands must not open the sandbox.
void addTrustOptions(CLI::App& command)
{
	const char* group = "Trust";
	command
	    .add_option_function<std::vector<std::string>>(
	        "--follow", [](const std::vector<std::string>& folders) { read::setFollow(folders); },
	        "Let INPUT name files in this folder, too, or anywhere; give it again for several (default: only in its "
	        "own folder)")
	    ->type_name("FOLDER|anywhere")
	    ->check(
	        [](const std::string& folder)
	        {
		        const Status fits = read::checkFollow(folder);
		        return fits ? std::string() : fits.error().message;
	        },
	        "")
	    ->expected(1)
	    ->take_all()
	    ->group(group);
	command
	    .add_option_function<std::string>(
	        "--sandbox", [](const std::string& word) { read::setSandbox(*read::parseSandbox(word)); },
	        "Read files in a sandbox: auto (what the system has), require or off (default: auto, or VPROBE_SANDBOX)")
	    ->check(CLI::IsMember({"auto", "require", "off"}))
	    ->group(group);
	command
	    .add_flag_callback(
	        "--no-index", [] { read::setUsesIndices(false); },
	        "Read INPUT as a whole, though vprobe index has made an index of it (default: VPROBE_INDEX=off does so, "
	        "too)")
	    ->group(group);
}

} // namespace vp::app
