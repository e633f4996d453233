#pragma once

#include "exit_code.h"
#include "session/session.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdio>
#include <memory>
#include <string>
#include <utility>

namespace vp::write
{
class AtomicFile;
}

namespace vp::app
{

// The figures of a sweep's frames, for --stats. Until the document is written they lie in a file without a name, so
// that a sweep of any length needs no more memory.
class FrameFigures
{
public:
	// stats: what --stats says. The file lies in the folder for temporary files.
	static Result<FrameFigures> create(std::string stats);

	// Adds what a frame's object in the document says. All ranks call it.
	void add(const session::Session& session, nlohmann::json frame);

	// Ends the command as writeStats() does. A failure of add() is reported here.
	Result<ExitCode> write(const session::Session& session);

private:
	struct Closing
	{
		void operator()(std::FILE* file) const { std::fclose(file); }
	};

	explicit FrameFigures(std::string stats) : stats_(std::move(stats)) {}
	Status copyTo(write::AtomicFile& file);

	std::string stats_;
	std::unique_ptr<std::FILE, Closing> file_;
	bool is_empty_ = true;
	int error_ = 0; // errno of the first failure
};

} // namespace vp::app
