#include "session/sheet_traces.h"

#include "ranks/particles/joined_traces.h"
#include "session/stored_vectors.h"
#include "session/value_scale.h"
#include "vectors/tracer.h"
#include "vectors/vector_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::session
{

namespace
{

bool hasVectors(const grid::BlockSet& blocks, const grid::FieldChoice& array)
{
	return std::ranges::any_of(array.inEach(blocks),
	                           [](const grid::Field* field) { return field && field->components == 3; });
}

// The fastest particle goes as far as the lattice's points are apart.
void takeStep(Session& session)
{
	const view::LaunchChoice& choice = *session.view.launch;
	LaunchState& launch = session.launch;
	if (choice.dt)
	{
		launch.dt = *choice.dt;
		return;
	}
	if (!launch.fastest || launch.fastest->first != choice.array)
		launch.fastest = {choice.array, spanOf(session, choice.array).range().second};
	const double dt = choice.spacing / launch.fastest->second;
	launch.dt = std::isfinite(dt) && dt > 0.0 ? dt : 1.0;
}

void takeTime(const read::TimeChoice& time, Session& session)
{
	const std::vector<double>& times = session.blocks.times;
	session.launch.time = times.empty() ? 0.0 : times[read::timeIndex(times, time)];
}

// Of path lines, which are launched now.
Status requireTimeToGo(const Session& session)
{
	const std::vector<double>& times = session.launch.stored->times;
	const vectors::Direction direction = session.view.launch->direction;
	if (direction == vectors::Direction::forward && session.launch.time >= times.back())
		return Error{ErrorKind::usage,
		             "`path_lines`: after the last time nothing is known; launch at `time` first, or go "
		             "`vector_direction` backward"};
	if (direction == vectors::Direction::backward && session.launch.time <= times.front())
		return Error{ErrorKind::usage,
		             "`path_lines`: before the first time nothing is known; launch at `time` last, or go "
		             "`vector_direction` forward"};
	return Nothing{};
}

Status preparePathLines(Session& session)
{
	Result<vectors::StoredVectors> stored = storedVectors(session, session.view.launch->array);
	if (!stored)
		return stored.error();
	session.launch.stored = std::move(*stored);
	takeTime(session.view.time, session);
	return requireTimeToGo(session);
}

} // namespace

Status prepareLaunch(Session& session)
{
	session.launch.stored.reset();
	if (!session.view.launch)
		return Nothing{};
	takeStep(session);
	return session.view.launch->path_lines ? preparePathLines(session) : Nothing{};
}

void takeValuesAt(const read::TimeChoice& time, Session& session)
{
	takeTime(time, session);
	session.launch.fastest.reset();
	if (session.view.launch)
		takeStep(session);
}

Result<SharedTraces> traceSheet(const Session& session, const cut::Cut& slice, std::size_t sheet,
                                const mesh::SheetMesh& mesh)
{
	if (!session.view.launch)
		return SharedTraces();
	const TimedSection section(session.timeline.get(), "trace");
	const view::LaunchChoice& choice = *session.view.launch;
	const probe::Sheet& content = slice.sheets[sheet].sheet;
	const std::vector<vectors::Launch> launches = ranks::launchLattice(session.ranks, mesh, content, choice.lattice);
	const vectors::TraceOptions options{.steps = choice.steps,
	                                    .dt = session.launch.dt,
	                                    .direction = choice.direction,
	                                    .part = choice.part,
	                                    .normal = content.normal};
	Result<vectors::Traces> traces =
	    session.launch.stored
	        ? vectors::tracePathLines(session.blocks, *session.launch.stored, session.launch.time, launches, options)
	        : ranks::trace(session.ranks, session.blocks, choice.array, launches, options);
	if (!traces)
		return traces.error();
	return std::make_shared<const vectors::Traces>(std::move(*traces));
}

std::optional<vectors::Flux> fluxThrough(const Session& session, const cut::Cut& slice, std::size_t number,
                                         const mesh::SheetMesh& mesh)
{
	const cut::SheetCut& sheet = slice.sheets[number];
	std::optional<grid::FieldChoice> array = session.view.vector_array;
	if (!array && sheet.field && hasVectors(session.blocks, *sheet.field))
		array = sheet.field;
	if (!array || sheet.surface)
		return std::nullopt;
	const vectors::FluxSums sums = session.ranks.sum(vectors::fluxSums(slice.blocksOf(session.blocks), mesh, *array),
	                                                 [](auto& sum, const auto& other) { sum.add(other); });
	return sums.flux();
}

} // namespace vp::session
