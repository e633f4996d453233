#include "profile/device_work.h"
#include "profile/floor.h"
#include "profile/profile_report.h"
#include "report/duration.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::app
{

namespace
{

using nlohmann::json;

// The document lists more of them.
constexpr std::size_t kShownGenerations = 12;

std::string bytesText(double bytes)
{
	if (bytes < 1024.0)
		return fmt::format("{:.0f} B", bytes);
	for (const char* unit : {"KiB", "MiB"})
		if ((bytes /= 1024.0) < 1024.0)
			return fmt::format("{:.3g} {}", bytes, unit);
	return fmt::format("{:.3g} GiB", bytes / 1024.0);
}

std::string subject(const json& p)
{
	const json& grid = p["grid"];
	std::string text =
	    fmt::format("{}: {}, {} cells, {} points\n", p["input"].get<std::string>(), grid["kind"].get<std::string>(),
	                grid["cells"].get<std::size_t>(), grid["points"].get<std::size_t>());
	text += fmt::format("{} planes along {}, {} sheet{} each{}\n", p["planes"].get<int>(), p["path"].get<std::string>(),
	                    p["sheets"].get<int>(), p["sheets"] == 1 ? "" : "s",
	                    p["picture"].is_null() ? "" : fmt::format(", drawn: {}", p["picture"].get<std::string>()));
	text += fmt::format("classified on the {}, cells found by {}, {} thread{}, device {}\n\n",
	                    p["classifier"].get<std::string>(), p["finder"].get<std::string>(), p["threads"].get<int>(),
	                    p["threads"] == 1 ? "" : "s", p["device"].get<std::string>());
	return text;
}

std::string row(const std::string& name, const json& spread)
{
	std::string text =
	    fmt::format("{:<22} {:>10.3f} {:>10.3f}", name, spread["median"].get<double>(), spread["p95"].get<double>());
	if (spread.contains("cores"))
		text += fmt::format(
		    " {:>8.2f} {:>10} {:>8.0f}", spread["cores"].get<double>(),
		    spread["times_floor"].is_null() ? "-" : fmt::format("{:.1f} x", spread["times_floor"].get<double>()),
		    spread["page_faults"].get<double>() + spread["major_faults"].get<double>());
	if (spread.contains("instructions") && !spread["instructions"].is_null())
		text += fmt::format(" {:>12.0f} {:>9.0f}", spread["instructions"].get<double>(),
		                    spread["cache_misses"].get<double>());
	return text + "\n";
}

std::string stages(const json& p)
{
	std::string text = fmt::format("{:<22} {:>10} {:>10}", "ms a plane", "median", "p95");
	if (p.contains("floor"))
		text += fmt::format(" {:>8} {:>10} {:>8}", "cores", "floor", "faults");
	if (p.contains("not_counted") && !p["not_counted"].contains("instructions"))
		text += fmt::format(" {:>12} {:>9}", "instructions", "misses");
	text += "\n";
	for (const json& stage : p["stages"])
		text += row(std::string(2 * stage["depth"].get<std::size_t>(), ' ') + stage["stage"].get<std::string>(), stage);
	if (p["gpu_stages"].empty())
		return text;
	text += row("gpu", p["gpu_ms"]);
	for (const json& stage : p["gpu_stages"])
		text += row("  " + stage["stage"].get<std::string>(), stage);
	return text;
}

std::string work(const json& p)
{
	const double all = std::max(1.0, p["grid"]["linear_cells"].get<double>());
	const double cut = p["cut_cells_mean"].get<double>();
	const auto time = [](const json& ms) { return durationText(ms.get<double>()); };
	std::string text = fmt::format("\nfirst cut {}", time(p["cut_ms"]["first"]));
	if (!p["frame_ms"].is_null())
		text += fmt::format(", first frame {}", time(p["frame_ms"]["first"]));
	const json& setup = p["setup_ms"];
	text += fmt::format("; read {}, build {}, adjacency {}, upload {}\n", time(setup["read"]), time(setup["build"]),
	                    time(setup["adjacency"]), time(setup["upload"]));
	text +=
	    fmt::format("{:.0f} cells cut a plane ({:.3g} % of all), {:.0f} touched, {:.0f} polygons, {:.0f} vertices\n",
	                cut, 100.0 * cut / all, p["cells_touched_mean"].get<double>(), p["polygons_mean"].get<double>(),
	                p["vertices_mean"].get<double>());
	text += fmt::format("{:.3g} ns a cut cell, {:.3g} million cut cells a second\n", p["ns_per_cut_cell"].get<double>(),
	                    1e-6 * p["cells_per_second"].get<double>());
	return text;
}

std::string generations(const json& p)
{
	if (p["generations"].empty())
		return "";
	std::string text =
	    fmt::format("\n{:.0f} generations a plane, fronts of {:.0f} cells, the widest {:.0f}\n",
	                p["generations_median"].get<double>(), p["front_mean"].get<double>(), p["front_max"].get<double>());
	std::vector<json> shown = p["generations"];
	std::ranges::stable_sort(shown, [](const json& a, const json& b) { return a["cells"] > b["cells"]; });
	shown.resize(std::min(shown.size(), kShownGenerations));
	std::ranges::sort(shown, {}, [](const json& g) { return g["generation"].get<int>(); });
	text += fmt::format("{:<10} {:>7} {:>10} {:>12} {:>12} {:>10}\n", "generation", "planes", "cells", "classify ms",
	                    "expand ms", "gpu ms");
	for (const json& g : shown)
		text += fmt::format("{:<10} {:>7} {:>10.0f} {:>12.4f} {:>12.4f} {:>10}\n", g["generation"].get<int>(),
		                    g["planes"].get<int>(), g["cells"].get<double>(), g["classify_ms"].get<double>(),
		                    g["expand_ms"].get<double>(),
		                    g["gpu_ms"].is_null() ? "-" : fmt::format("{:.4f}", g["gpu_ms"].get<double>()));
	if (shown.size() < p["generations"].size())
		text += fmt::format("(the {} widest of {})\n", shown.size(), p["generations"].size());
	return text;
}

std::string memory(const json& p)
{
	const json& memory = p["memory_bytes"];
	std::string text =
	    fmt::format("\n{} as read, {} built besides, at most {} resident\n", bytesText(memory["grid"].get<double>()),
	                bytesText(memory["extra"].get<double>()), bytesText(memory["peak_rss"].get<double>()));
	std::string parts;
	for (const auto& [name, bytes] : memory["parts"].items())
		if (bytes.get<double>() > 0.0)
			parts += fmt::format("{}{} {}", parts.empty() ? "(" : ", ", name, bytesText(bytes.get<double>()));
	return text + (parts.empty() ? "" : parts + ")\n");
}

std::string notCounted(const json& p)
{
	std::string text;
	if (p.contains("not_counted"))
		for (const auto& [what, why] : p["not_counted"].items())
			text += fmt::format("{} are not told: {}\n", what, why.get<std::string>());
	return text;
}

} // namespace

std::string profileTable(const json& document)
{
	return subject(document) + stages(document) + deviceWorkText(document) + work(document) + generations(document) +
	       memory(document) + floorText(document) + notCounted(document);
}

} // namespace vp::app
