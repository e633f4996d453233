#include "profile/profile_report.h"

#include "grid/check/memory.h"
#include "probe/probe_file.h"
#include "profile/spread.h"
#include "view/words.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <numeric>

#include <sys/resource.h>

namespace vp::app
{

namespace
{

double sumOf(const std::vector<double>& values)
{
	return std::accumulate(values.begin(), values.end(), 0.0);
}

double meanOf(const std::vector<double>& values)
{
	return values.empty() ? 0.0 : sumOf(values) / static_cast<double>(values.size());
}

nlohmann::json withFirst(const std::vector<double>& ms)
{
	nlohmann::json json = asJson(spreadOf(ms));
	json["first"] = ms.front();
	return json;
}

// Stages come in the order in which they begin. This is a list, since JSON objects have no order.
nlohmann::json stagesJson(const ProfileLog& log, Timeline::Track track)
{
	nlohmann::json list = nlohmann::json::array();
	for (const Stage& stage : log.stages())
		if (stage.track == track)
		{
			nlohmann::json json = asJson(spreadOf(stage.ms));
			json["stage"] = stage.name;
			json["depth"] = stage.depth;
			list.push_back(std::move(json));
		}
	return list;
}

nlohmann::json generationsJson(const ProfileLog& log)
{
	nlohmann::json list = nlohmann::json::array();
	for (const GenerationLog& generation : log.generations())
		list.push_back(
		    {{"generation", list.size()},
		     {"planes", generation.cells.size()},
		     {"cells", medianOf(generation.cells)},
		     {"classify_ms", medianOf(generation.classify_ms)},
		     {"expand_ms", medianOf(generation.expand_ms)},
		     {"gpu_ms", generation.gpu_ms.empty() ? nlohmann::json() : nlohmann::json(medianOf(generation.gpu_ms))}});
	return list;
}

double frontMax(const ProfileLog& log)
{
	double widest = 0.0;
	for (const GenerationLog& generation : log.generations())
		widest = std::max(widest, *std::ranges::max_element(generation.cells));
	return widest;
}

double frontMean(const ProfileLog& log)
{
	double cells = 0.0;
	for (const GenerationLog& generation : log.generations())
		cells += sumOf(generation.cells);
	const double fronts = sumOf(log.generationCounts());
	return fronts > 0.0 ? cells / fronts : 0.0;
}

// Takes the median over the planes that cut any cell, since the first planes also build what is built only once.
double nsPerCutCell(const ProfileLog& log)
{
	const std::vector<double> ms = log.msOf("cut");
	std::vector<double> per_cell;
	for (std::size_t k = 0; k < ms.size(); ++k)
		if (log.cutCells()[k] > 0.0)
			per_cell.push_back(1e6 * ms[k] / log.cutCells()[k]);
	return medianOf(per_cell);
}

nlohmann::json memoryJson(const session::Session& session, std::size_t peak_rss)
{
	const grid::Memory grid = grid::memoryOf(session.blocks());
	const cut::Cutter::Memory cutter = session.cutter().memory();
	return {{"grid", grid.read()},
	        {"extra", grid.built() + cutter.marks + cutter.device},
	        {"peak_rss", peak_rss},
	        {"parts",
	         {{"geometry", grid.geometry},
	          {"arrays", grid.arrays},
	          {"adjacency", grid.adjacency},
	          {"boundary", grid.boundary},
	          {"folds", grid.folds},
	          {"trees", grid.trees},
	          {"seams", grid.seams},
	          {"marks", cutter.marks},
	          {"device", cutter.device}}}};
}

// Says what was measured. Two profiles measured the same work if all of this is the same.
nlohmann::json subjectJson(const Profile& profile)
{
	const view::ProbeSpec& probe = profile.session.spec().probe;
	const probe::Probe& placed = profile.session.view().probe;
	nlohmann::json json = inputJson(profile.session);
	const bool has_planes = !view::replacesSheets(probe.surface);
	const std::string surface = view::surfaceText(probe.surface);
	const auto& threshold = probe.threshold;
	json.update({{"finder", profile.log.finder()},
	             {"probe", has_planes ? probe::toJson(placed) : nlohmann::json()},
	             {"surface", surface.empty() ? nlohmann::json() : nlohmann::json(surface)},
	             {"threshold", threshold ? nlohmann::json{threshold->lo, threshold->hi} : nlohmann::json()},
	             {"seeds", view::text(probe.seeds)},
	             {"crinkle", probe.crinkle},
	             {"sheets", has_planes ? placed.sheets.size() : 1},
	             {"path", profile.path},
	             {"planes", profile.log.planes()},
	             {"picture", profile.picture ? nlohmann::json(*profile.picture) : nlohmann::json()},
	             {"threads", tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)}});
	return json;
}

} // namespace

std::size_t peakResident()
{
	rusage usage{};
	getrusage(RUSAGE_SELF, &usage);
	return static_cast<std::size_t>(usage.ru_maxrss) * 1024; // Linux returns KiB
}

nlohmann::json profileJson(const Profile& profile)
{
	const ProfileLog& log = profile.log;
	const Timeline& timeline = *profile.session.timeline();
	const double ns = nsPerCutCell(log);
	nlohmann::json json = subjectJson(profile);
	json.update({{"cut_ms", withFirst(log.msOf("cut"))},
	             {"frame_ms", profile.picture ? withFirst(log.msOf("frame")) : nlohmann::json()},
	             {"gpu_ms", withFirst(log.gpuMs())},
	             {"setup_ms",
	              {{"read", timeline.total("read")},
	               {"build", timeline.total("build")},
	               {"adjacency", timeline.total("adjacency")},
	               {"upload", timeline.total("upload")}}},
	             {"cut_cells_mean", meanOf(log.cutCells())},
	             {"cells_touched_mean", meanOf(log.touchedCells())},
	             {"polygons_mean", meanOf(log.polygons())},
	             {"vertices_mean", meanOf(log.vertices())},
	             {"empty_planes", log.emptyPlanes()},
	             {"generations_median", medianOf(log.generationCounts())},
	             {"front_mean", frontMean(log)},
	             {"front_max", frontMax(log)},
	             {"ns_per_cut_cell", ns},
	             {"cells_per_second", ns > 0.0 ? 1e9 / ns : 0.0},
	             {"memory_bytes", memoryJson(profile.session, profile.peak_rss)},
	             {"stages", stagesJson(log, Timeline::Track::cpu)},
	             {"gpu_stages", stagesJson(log, Timeline::Track::gpu)},
	             {"generations", generationsJson(log)}});
	if (profile.work)
	{
		json["not_counted"] = nlohmann::json::object();
		profile.work->put(json, *profile.floor);
	}
	if (profile.device_work)
		profile.device_work->put(json, *profile.session.device());
	return json;
}

} // namespace vp::app
