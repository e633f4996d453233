#include "sheet_traces.h"

#include "stored_vectors.h"
#include "vectors/flux.h"
#include "vectors/tracer.h"
#include "vectors/vector_array.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::app
{

namespace
{

TraceKind kindOf(const std::string& word)
{
	return word == "tufts"     ? TraceKind::tufts
	       : word == "ribbons" ? TraceKind::ribbons
	       : word == "tubes"   ? TraceKind::tubes
	                           : TraceKind::lines;
}

vectors::Direction directionOf(const std::string& word)
{
	return word == "backward" ? vectors::Direction::backward
	       : word == "both"   ? vectors::Direction::both
	                          : vectors::Direction::forward;
}

vectors::VectorPart partOf(const std::string& word)
{
	return word == "tangential" ? vectors::VectorPart::tangential
	       : word == "normal"   ? vectors::VectorPart::normal
	                            : vectors::VectorPart::whole;
}

// The longest side of what sheets show: of their windows, which may reach around everything, or of the bounds. It does
// not follow the cut, so that steps and widths stay what they are while a probe moves.
double longestSide(const Session& session)
{
	const Box bounds = session.blocks.bounds();
	const Vec3 size = bounds.empty() ? Vec3(0.0) : bounds.hi - bounds.lo;
	const double whole = std::max({size.x, size.y, size.z});
	double windows = 0.0;
	for (const probe::Sheet& sheet : session.probe.sheets)
	{
		if (!sheet.window)
			return whole;
		windows = std::max({windows, sheet.window->width(), sheet.window->height()});
	}
	return std::min(whole, windows);
}

bool hasVectors(const grid::BlockSet& blocks, const grid::FieldChoice& array)
{
	return std::ranges::any_of(array.inEach(blocks),
	                           [](const grid::Field* field) { return field && field->components == 3; });
}

// Anywhere in the blocks.
double fastest(const grid::BlockSet& blocks, const grid::FieldChoice& array)
{
	grid::ValueSpan span;
	for (const grid::Field* field : array.inEach(blocks))
		if (field)
			span.include(grid::valueSpan(*field, grid::kMagnitude));
	return span.range().second;
}

// The fastest particle goes as far as the lattice's points are apart.
void takeStep(Session& session)
{
	VectorChoice& choice = *session.vectors;
	if (!choice.own_dt)
		return;
	if (!session.fastest || session.fastest->first != *session.vector_array)
		session.fastest = {*session.vector_array, fastest(session.blocks, *session.vector_array)};
	const double dt = choice.spacing / session.fastest->second;
	choice.dt = std::isfinite(dt) && dt > 0.0 ? dt : 1.0;
}

void takeTime(const read::TimeChoice& time, Session& session)
{
	const std::vector<double>& times = session.blocks.times;
	session.time = times.empty() ? 0.0 : times[read::timeIndex(times, time)];
}

// Of path lines, which are launched now.
Status requireTimeToGo(const Session& session)
{
	const std::vector<double>& times = session.stored->times;
	const vectors::Direction direction = session.vectors->direction;
	if (direction == vectors::Direction::forward && session.time >= times.back())
		return Error{ErrorKind::usage,
		             "--path-lines: after the last time nothing is known; launch at --time first, or go "
		             "--vector-direction backward"};
	if (direction == vectors::Direction::backward && session.time <= times.front())
		return Error{ErrorKind::usage,
		             "--path-lines: before the first time nothing is known; launch at --time last, or go "
		             "--vector-direction forward"};
	return Nothing{};
}

Status choosePathLines(const ProbeOptions& options, Session& session)
{
	Result<vectors::StoredVectors> stored = storedVectors(options, session, *session.vector_array);
	if (!stored)
		return stored.error();
	session.stored = std::move(*stored);
	Result<read::TimeChoice> time = read::parseTime(options.time);
	if (!time)
		return time.error();
	takeTime(*time, session);
	return requireTimeToGo(session);
}

} // namespace

Status checkVectors(const ProbeOptions& options)
{
	if (options.vectors.on() && options.surface)
		return Error{ErrorKind::usage, fmt::format("--vectors: are launched from planes, and --surface {} is none; "
		                                           "leave one of the two out",
		                                           *options.surface)};
	return checkVectorOptions(options.vectors);
}

Status chooseVectors(const ProbeOptions& options, Session& session)
{
	const VectorOptions& words = options.vectors;
	session.vectors.reset();
	session.vector_array.reset();
	session.stored.reset();
	if (Status fits = checkVectors(options); !fits)
		return fits;
	if (!words.on() && words.array.empty())
		return Nothing{};
	Result<grid::FieldChoice> array = vectors::chooseVectors(session.blocks, words.array);
	if (!array)
		return array.error();
	session.vector_array = *array;
	if (!words.on())
		return Nothing{};
	const double spacing = longestSide(session) / words.lattice;
	session.vectors = VectorChoice{.kind = kindOf(words.kind),
	                               .lattice = {words.lattice, words.jitter},
	                               .steps = words.stepsOrDefault(),
	                               .dt = words.dt.value_or(1.0),
	                               .spacing = spacing > 0.0 ? spacing : 1.0,
	                               .direction = directionOf(words.direction),
	                               .part = partOf(words.part),
	                               .own_dt = !words.dt.has_value()};
	takeStep(session);
	return words.path_lines ? choosePathLines(options, session) : Nothing{};
}

void takeValuesAt(const read::TimeChoice& time, Session& session)
{
	takeTime(time, session);
	session.fastest.reset();
	if (session.vectors)
		takeStep(session);
}

Result<SharedTraces> traceSheet(const Session& session, const cut::Cut& slice, std::size_t sheet,
                                const mesh::SheetMesh& mesh)
{
	if (!session.vectors)
		return SharedTraces();
	const TimedSection section(session.timeline.get(), "trace");
	const VectorChoice& choice = *session.vectors;
	const probe::Sheet& content = slice.sheets[sheet].sheet;
	const vectors::SheetLattice lattice = vectors::launchLattice(mesh, content, choice.lattice);
	const vectors::TraceOptions options{.steps = choice.steps,
	                                    .dt = choice.dt,
	                                    .direction = choice.direction,
	                                    .part = choice.part,
	                                    .normal = content.normal};
	Result<vectors::Traces> traces =
	    session.stored
	        ? vectors::tracePathLines(session.blocks, *session.stored, session.time, lattice.launches, options)
	        : vectors::trace(session.blocks, *session.vector_array, lattice.launches, options);
	if (!traces)
		return traces.error();
	return std::make_shared<const vectors::Traces>(std::move(*traces));
}

std::optional<double> fluxThrough(const Session& session, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh)
{
	std::optional<grid::FieldChoice> array = session.vector_array;
	if (!array && sheet.field && hasVectors(session.blocks, *sheet.field))
		array = sheet.field;
	if (!array || sheet.surface)
		return std::nullopt;
	return vectors::fluxThrough(session.blocks, mesh, *array).through;
}

nlohmann::json tracesJson(const Session& session, const vectors::Traces& traces)
{
	std::array<std::size_t, vectors::kTraceEndWords.size()> counts{};
	const auto count = [&](const std::vector<vectors::TraceEnd>& of_traces)
	{
		for (const vectors::TraceEnd end : of_traces)
			++counts[static_cast<std::size_t>(end)];
	};
	if (session.vectors->direction != vectors::Direction::forward)
		count(traces.begins);
	if (session.vectors->direction != vectors::Direction::backward)
		count(traces.ends);
	nlohmann::json ends;
	for (std::size_t i = 0; i < counts.size(); ++i)
		ends[vectors::kTraceEndWords[i]] = counts[i];
	return {{"array", session.vector_array->name},
	        {"traces", traces.count()},
	        {"points", traces.points.size()},
	        {"dt", session.vectors->dt},
	        {"ends", ends}};
}

} // namespace vp::app
