#include "mpi_team.h"
#include "program.h"
#include "report/console.h"
#include "team.h"
#include "write/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace
{

// What is wrong with the command line or the input is often wrong at every rank. A rank that fails first ends all. So
// the others wait a little, and mostly one line is printed.
void endAll(const std::string& line, vp::app::ExitCode code)
{
	using namespace std::chrono_literals;
	const int rank = vp::app::team()->rank();
	std::this_thread::sleep_for(std::min(300ms * rank, 3000ms));
	vp::app::printLine(rank == 0 && code == vp::app::ExitCode::usage ? line : fmt::format("rank {}: {}", rank, line));
	vp::write::removeUnfinishedFiles();
	vp::app::MpiTeam::abort(static_cast<int>(code));
}

} // namespace

int main(int argc, char** argv)
{
	vp::app::MpiTeam team(&argc, &argv);
	vp::app::setTeam(&team);
	const vp::app::Program program{
	    "vprobe-mpi",
	    "Volume probes in data whose parts are spread over processes: mpiexec -n N vprobe-mpi COMMAND …",
	    "The commands and options are those of vprobe. Each process reads and cuts a share of the input's pieces or\n"
	    "blocks; the first one writes. What cannot be done so is refused.",
	    {vp::app::addSlice, vp::app::addRender, vp::app::addSweep, vp::app::addProfile},
	    endAll};
	return vp::app::runProgram(program, argc, argv);
}
