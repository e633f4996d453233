#include "mpi_team.h"
#include "program.h"
#include "report/console.h"
#include "team.h"
#include "write/unfinished.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace
{

const vp::app::MpiTeam* processes = nullptr;

// An error in the command line or the input often occurs at every rank. The first rank that fails prints its line and
// ends all ranks. The ranks after it wait for that. An error in the command line is mostly the same everywhere, so in
// that case they wait longer.
void endAll(const std::string& line, vp::app::ExitCode code)
{
	using namespace std::chrono_literals;
	const vp::app::MpiTeam& team = *processes;
	const bool of_command = code == vp::app::ExitCode::usage;
	const auto patience = team.rank() == 0 ? 0ms : of_command ? 3000ms : std::min(300ms * team.rank(), 3000ms);
	if (team.failsFirst(patience))
		vp::app::printLine(team.rank() == 0 && of_command ? line : fmt::format("rank {}: {}", team.rank(), line));
	else
		std::this_thread::sleep_for(3s); // until then the other rank has ended this one
	vp::write::removeUnfinishedFiles();
	vp::app::MpiTeam::abort(static_cast<int>(code));
}

} // namespace

int main(int argc, char** argv)
{
	vp::app::MpiTeam team(&argc, &argv);
	vp::app::setTeam(&team);
	processes = &team;
	constexpr vp::app::Command kCommands[] = {{"slice", vp::app::addSlice},
	                                          {"render", vp::app::addRender},
	                                          {"sweep", vp::app::addSweep},
	                                          {"profile", vp::app::addProfile}};
	const vp::app::Program program{
	    "vprobe-mpi", "Volume probes in data whose parts are spread over processes: mpiexec -n N vprobe-mpi COMMAND …",
	    "The commands and options are those of vprobe. Each process reads and cuts a share of the input's pieces or\n"
	    "blocks; the first one writes. What cannot be done so is refused.",
	    kCommands, endAll};
	return vp::app::runProgram(program, argc, argv);
}
