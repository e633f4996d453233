#include "prototypes.h"

#include "command_output.h"
#include "our_cuts.h"

#include <filesystem>
#include <thread>

namespace fs = std::filesystem;

namespace vp::bench
{

std::optional<std::string> prototypeOf(const std::string& grid)
{
	const std::size_t colon = grid.find(':');
	const std::string kind = grid.substr(0, colon);
	const fs::path program =
	    fs::canonical("/proc/self/exe").parent_path() / ("prototype_" + (kind == "shell" ? std::string("span") : kind));
	if (colon == std::string::npos || !fs::exists(program))
		return std::nullopt;
	// The prototypes know one thread or two.
	return program.string() + ' ' + grid.substr(colon + 1) + (std::thread::hardware_concurrency() > 1 ? " 2" : " 1");
}

void prototypeCut(benchmark::State& state, const std::string& grid, const std::string& command)
{
	const double cells = cutCellsOfPlane(grid);
	for (auto _ : state)
	{
		const std::string output = outputOf(command).value_or("");
		const std::size_t figure = output.find("ns/cell=");
		if (figure == std::string::npos)
			return state.SkipWithError("the prototype failed");
		constexpr double kNanosecond = 1e-9;
		state.SetIterationTime(std::stod(output.substr(figure + 8)) * kNanosecond * cells);
	}
}

} // namespace vp::bench
