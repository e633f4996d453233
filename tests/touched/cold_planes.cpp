// Cuts planes of a built-in grid with cold caches, and prints how many lines of memory the stages touch by their own
// count. tests/touched/against_callgrind.py runs it under callgrind, which counts the same by simulating a cache.
// usage: cold_planes INPUT PLANES

#include "profile/swept_probe.h"
#include "profile/touched_lines.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cstdint>
#include <cstdlib>
#include <vector>

namespace
{

// More than the simulated cache holds, so that nothing of ours is left in it.
void emptyCaches()
{
	static std::vector<std::uint8_t> other(std::size_t(48) << 20, 1);
	static volatile std::uint64_t sum = 0;
	for (std::size_t i = 0; i < other.size(); i += 64)
		sum = sum + other[i];
}

using Stages = std::map<std::string, vp::app::Touched, std::less<>>;

} // namespace

// callgrind begins to count here.
[[gnu::noinline]] void beginPlanes()
{
	asm volatile("");
}

// callgrind counts what this function does, and find::findInBlock(), which the planes call.
[[gnu::noinline]] std::size_t emitCold(const vp::app::SweptProbe& swept)
{
	std::size_t polygons = 0;
	const vp::session::Frame& frame = swept.made();
	for (std::size_t sheet = 0; sheet < frame.slice.sheets.size(); ++sheet)
		polygons += frame.slice.mesh(swept.session().blocks(), sheet).polygons();
	return polygons;
}

int main(int argc, char** argv)
{
	if (argc != 3)
		return 2;
	const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
	vp::app::ProfileOptions options;
	options.common.spec.input.files = {argv[1]};
	options.common.spec.machine.classify = vp::view::Classify::cpu;
	options.planes = std::atoi(argv[2]) + 1;
	vp::Result<vp::app::SweptProbe> swept = vp::app::SweptProbe::open(options);
	if (!swept || !swept->measure(0)) // the first cut makes room for the others
		return 1;
	beginPlanes();
	Stages sum;
	for (std::size_t plane = 1; plane < swept->planes(); ++plane)
	{
		emptyCaches();
		if (!swept->measure(plane))
			return 1;
		emptyCaches();
		if (emitCold(*swept) == 0)
			return 1;
		for (const auto& [stage, touched] : vp::app::touchedBy(swept->session().blocks(), swept->made()))
			sum[stage] += touched;
	}
	for (const auto& [stage, touched] : sum)
		fmt::print("{} {}\n", stage, touched.lines);
	return 0;
}
