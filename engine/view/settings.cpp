#include "view/settings.h"

#include "grid/field_choice.h"
#include "probe/path_file.h"
#include "read/formats.h"
#include "render/scene/levels.h"
#include "view/words.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string_view>

namespace vp::view
{

namespace
{

constexpr double kAny = std::numeric_limits<double>::max();
constexpr double kMaxSteps = 1e6;
constexpr Limits kShare{0.0, 1.0};
constexpr Limits kSheets{1, probe::kMaxSheets};

template <Named T>
Text word(T* value)
{
	return {[value] { return std::optional<std::string>(text(*value)); },
	        [value](const std::string& words) -> Status
	        {
		        Result<T> parsed = parse<T>(words);
		        if (!parsed)
			        return parsed.error();
		        *value = *parsed;
		        return Nothing{};
	        }};
}

template <Named T>
Text word(std::optional<T>* value)
{
	return {[value] { return *value ? std::optional<std::string>(text(**value)) : std::nullopt; },
	        [value](const std::string& words) -> Status { return word(&value->emplace()).set(words); }};
}

template <class T, class Parse, class Write>
Text written(T* value, Parse parse, Write write)
{
	return {[=]() -> std::optional<std::string> { return write(*value); },
	        [=](const std::string& words) -> Status
	        {
		        auto parsed = parse(words);
		        if (!parsed)
			        return parsed.error();
		        *value = std::move(*parsed);
		        return Nothing{};
	        }};
}

Text format(std::string* name)
{
	return {[name] { return name->empty() ? std::nullopt : std::optional(*name); },
	        [name](const std::string& words) -> Status
	        {
		        if (!read::findFormat(words))
			        return Error{ErrorKind::usage, "no such format; use one of " + read::formatNames()};
		        *name = words;
		        return Nothing{};
	        }};
}

// Set where the size is.
template <class T, class Parse, class Write>
Text ofRaw(const InputSpec& input, T* value, Parse parse, Write write)
{
	Text text = written(value, parse, write);
	text.get = [&raw = input.raw, get = text.get] { return raw.size[0] == 0 ? std::nullopt : get(); };
	return text;
}

Text direction(std::optional<Vec3>* value)
{
	return {[value] { return *value ? std::optional(directionText(**value)) : std::nullopt; },
	        [value](const std::string& words) -> Status
	        {
		        Result<Vec3> parsed = parseDirection(words);
		        if (!parsed)
			        return parsed.error();
		        *value = *parsed;
		        return Nothing{};
	        }};
}

Text surface(SurfaceSpec* value)
{
	return {[value]
	        {
		        std::string words = surfaceText(*value);
		        return words.empty() ? std::nullopt : std::optional(std::move(words));
	        },
	        [value](const std::string& words) -> Status
	        {
		        Result<SurfaceSpec> parsed = parseSurface(words);
		        if (!parsed)
			        return parsed.error();
		        *value = std::move(*parsed);
		        return Nothing{};
	        }};
}

Text component(std::optional<int>* value)
{
	return {[value] { return *value ? std::optional(grid::componentText(**value)) : std::nullopt; },
	        [value](const std::string& words) -> Status
	        {
		        const std::optional<int> parsed = grid::parseComponent(words);
		        if (!parsed)
			        return Error{ErrorKind::usage, "not a component; use magnitude, x, y, z or a number from 0"};
		        *value = *parsed;
		        return Nothing{};
	        }};
}

Texts contexts(std::vector<ContextSpec>* value)
{
	return {[value]
	        {
		        std::vector<std::string> words;
		        for (const ContextSpec& context : *value)
			        words.push_back(contextText(context));
		        return words;
	        },
	        [value](const std::vector<std::string>& words) -> Status
	        {
		        value->clear();
		        for (const std::string& each : words)
		        {
			        Result<ContextSpec> parsed = parseContext(each);
			        if (!parsed)
				        return Error{parsed.error().kind, fmt::format("{}: {}", each, parsed.error().message)};
			        value->push_back(std::move(*parsed));
		        }
		        return Nothing{};
	        }};
}

Numbers vector(std::optional<Vec3>* value)
{
	return {3,
	        [value] {
		        return *value ? std::vector{(*value)->x, (*value)->y, (*value)->z} : std::vector<double>();
	        },
	        [value](const std::vector<double>& n) {
		        *value = {n[0], n[1], n[2]};
	        }};
}

template <class T>
Numbers pair(std::optional<T>* value)
{
	return {2,
	        [value]
	        {
		        if (!*value)
			        return std::vector<double>();
		        const auto& [a, b] = **value;
		        return std::vector{a, b};
	        },
	        [value](const std::vector<double>& n) {
		        *value = T{n[0], n[1]};
	        }};
}

Numbers list(std::vector<double>* value)
{
	return {0, [value] { return *value; }, [value](const std::vector<double>& n) { *value = n; }};
}

} // namespace

std::vector<Section> sectionsOf(ViewSpec& spec)
{
	InputSpec& input = spec.input;
	ProbeSpec& probe = spec.probe;
	VectorSpec& vectors = probe.vectors;
	LookSpec& look = spec.look;
	SweepSpec& sweep = spec.sweep;
	return {{"input",
	         {{"files", Files{&input.files}},
	          {"time", written(&input.time, read::parseTime, read::timeText)},
	          {"solution", File{&input.solution}},
	          {"refine", &input.refine, Limits{0, read::kMaxRefine}},
	          {"displace", &input.displace},
	          {"format", format(&input.format)},
	          {"raw_size", ofRaw(input, &input.raw.size, read::parseRawSize, read::rawSizeText)},
	          {"raw_type", ofRaw(input, &input.raw.type, read::parseRawType, read::rawTypeText)},
	          {"raw_spacing", ofRaw(input, &input.raw.spacing, read::parseRawSpacing, read::rawSpacingText)},
	          {"raw_order", ofRaw(input, &input.raw.is_big_endian, read::parseRawOrder, read::rawOrderText)}}},
	        {"probe",
	         {{"probe", ProbeChoice{&probe}},
	          {"origin", vector(&probe.origin)},
	          {"normal", direction(&probe.normal)},
	          {"up", vector(&probe.up)},
	          {"window", pair(&probe.window)},
	          {"surface", surface(&probe.surface)},
	          {"crinkle", &probe.crinkle},
	          {"vanes", &probe.vanes, kSheets},
	          {"offsets", list(&probe.offsets)},
	          {"sheets", &probe.sheets, kSheets},
	          {"corners", word(&probe.corners)},
	          {"hanging", word(&probe.hanging)},
	          {"array", &probe.array},
	          {"component", component(&probe.component)},
	          {"threshold", pair(&probe.threshold)},
	          {"seeds", word(&probe.seeds)},
	          {"outside", word(&probe.outside)}}},
	        {"look",
	         {{"size", written(&look.size, parseSize, sizeText)},
	          {"samples", &look.samples, Limits{1, render::kMaxSamples}},
	          {"colormap", NameOrFile{&look.colormap}},
	          {"color_by", word(&look.color_by)},
	          {"range", pair(&look.range)},
	          {"range_of", word(&look.range_of)},
	          {"symmetric", &look.symmetric},
	          {"log", &look.logarithmic},
	          {"opacity", &look.opacity, kShare},
	          {"lines", &look.lines, Limits{0, render::kMaxLevels}},
	          {"no_legend", &look.no_legend},
	          {"no_labels", &look.no_labels},
	          {"bands", &look.bands, Limits{0, render::kMaxLevels}},
	          {"mesh", &look.mesh},
	          {"lit", &look.lit},
	          {"background", written(&look.background, render::parseBackground, render::backgroundText)},
	          {"camera", written(&look.camera, render::parseCamera, [](const auto& choice) { return choice.text; })},
	          {"outline", word(&look.outline)},
	          {"context", contexts(&look.context)},
	          {"axes", word(&look.axes)},
	          {"units", &look.units},
	          {"length_units", &look.length_units},
	          {"title", &look.title}}},
	        {"vectors",
	         {{"vectors", word(&vectors.kind)},
	          {"vector_array", &vectors.array},
	          {"vector_lattice", &vectors.lattice, Limits{1, kMaxLattice}},
	          {"vector_jitter", &vectors.jitter, kShare},
	          {"vector_steps", &vectors.steps,
	           Limits{0.0, kMaxSteps, "; `vector_direction` backward goes against the flow"}},
	          {"vector_dt", &vectors.dt, Limits{std::numeric_limits<double>::min(), kAny}},
	          {"vector_direction", word(&vectors.direction)},
	          {"vector_part", word(&vectors.part)},
	          {"path_lines", &vectors.path_lines},
	          {"vector_color", &look.vectors.color},
	          {"vector_colormap", NameOrFile{&look.vectors.colormap}},
	          {"vector_width", &look.vectors.width, Limits{std::numeric_limits<double>::min(), kAny}},
	          {"vector_opacity", &look.vectors.opacity, kShare}}},
	        {"contours",
	         {{"contour", list(&look.contour.values)},
	          {"contour_at", pair(&look.contour.at)},
	          {"contour_depth", &look.contour.depth, Limits{0.0, kAny}},
	          {"contour_opacity", &look.contour.opacity, kShare}}},
	        {"sweep",
	         {{"path", PathChoice{&sweep}},
	          {"frames", &sweep.frames, Limits{1, probe::kMaxFrames}},
	          {"fps", &sweep.frames_per_second, Limits{std::numeric_limits<double>::min(), kAny}},
	          {"there_and_back", &sweep.there_and_back}}}};
}

Section machineSection(ViewSpec& spec)
{
	MachineSpec& machine = spec.machine;
	return {"machine",
	        {{"classify", word(&machine.classify)},
	         {"device", &machine.device},
	         {"device_memory", &machine.device_memory, Limits{0.0, kAny}},
	         {"threads", &machine.threads, Limits{0, 4096}},
	         {"strategy", word(&machine.strategy)},
	         {"visited", word(&machine.visited)}}};
}

namespace
{

struct NumbersOf
{
	std::vector<double> operator()(int* number) const { return {static_cast<double>(*number)}; }
	std::vector<double> operator()(double* number) const { return {*number}; }
	std::vector<double> operator()(std::optional<int>* number) const
	{
		return *number ? (*this)(&**number) : std::vector<double>();
	}
	std::vector<double> operator()(std::optional<double>* number) const
	{
		return *number ? (*this)(&**number) : std::vector<double>();
	}
	std::vector<double> operator()(const Numbers& numbers) const { return numbers.get(); }
	template <class T>
	std::vector<double> operator()(const T&) const
	{
		return {};
	}
};

std::string limitsText(const Limits& limits)
{
	if (limits.hi < kAny)
		return fmt::format("from {:g} to {}", limits.lo, limits.hi);
	return limits.lo > 0.0 ? "above 0" : fmt::format("of {:g} or more", limits.lo);
}

} // namespace

std::string refusal(const Setting& setting)
{
	for (const double number : std::visit(NumbersOf(), setting.place))
	{
		if (setting.limits && !(number >= setting.limits->lo && number <= setting.limits->hi))
			return fmt::format("{}: give a number {}{}", number, limitsText(*setting.limits),
			                   number < setting.limits->lo ? setting.limits->instead : "");
		if (!std::isfinite(number))
			return fmt::format("{} is not a finite number", number);
	}
	return {};
}

Status setPathKind(SweepSpec& sweep, std::string_view name)
{
	const std::optional<probe::PathKind> kind = probe::pathKind(name);
	if (name != "times" && (!kind || *kind == probe::PathKind::keyframes))
		return Error{ErrorKind::usage, name == "keyframes"
		                                   ? "keys come from a file; give its name, FILE.json (docs/PROBES.md)"
		                                   : "takes translate, rotate, spin, revolve, profile, times or a .json file"};
	sweep.own.reset();
	sweep.over_times = name == "times";
	sweep.kind = kind.value_or(probe::PathKind::translate);
	return Nothing{};
}

std::string pathKindText(const SweepSpec& sweep)
{
	return sweep.over_times ? "times" : std::string(probe::nameOf(sweep.own ? sweep.own->kind : sweep.kind));
}

} // namespace vp::view
