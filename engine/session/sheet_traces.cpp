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
void takeStep(const Session& session, LaunchState& launch)
{
	const view::LaunchChoice& choice = *session.view().launch;
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

// Returns an error if path lines that are launched now have no time to go to.
Status requireTimeToGo(const LaunchState& launch, vectors::Direction direction)
{
	const std::vector<double>& times = launch.stored->times;
	if (direction == vectors::Direction::forward && launch.time >= times.back())
		return Error{ErrorKind::usage,
		             "`path_lines`: after the last time nothing is known; launch at `time` first, or go "
		             "`vector_direction` backward"};
	if (direction == vectors::Direction::backward && launch.time <= times.front())
		return Error{ErrorKind::usage,
		             "`path_lines`: before the first time nothing is known; launch at `time` last, or go "
		             "`vector_direction` forward"};
	return Nothing{};
}

} // namespace

void Session::takeTime(const read::TimeChoice& time)
{
	launch_.time = blocks_.times.empty() ? 0.0 : blocks_.times[read::timeIndex(blocks_.times, time)];
}

// Finds the time of a step, and opens vectors of other times. The fastest particle of an array is looked up once, until
// the values change.
Status Session::prepareLaunch()
{
	launch_.stored.reset();
	if (!view_.launch)
		return Nothing{};
	takeStep(*this, launch_);
	if (!view_.launch->path_lines)
		return Nothing{};
	Result<vectors::StoredVectors> stored = storedVectors(*this, view_.launch->array);
	if (!stored)
		return stored.error();
	launch_.stored = std::move(*stored);
	takeTime(view_.time);
	return requireTimeToGo(launch_, view_.launch->direction);
}

// The arrays hold the values of another time. If the settings give no step, the step follows the new values.
void Session::takeValuesAt(const read::TimeChoice& time)
{
	takeTime(time);
	launch_.fastest.reset();
	if (view_.launch)
		takeStep(*this, launch_);
}

Result<SharedTraces> traceSheet(const Session& session, const cut::Cut& slice, std::size_t sheet,
                                const mesh::SheetMesh& mesh)
{
	if (!session.view().launch)
		return SharedTraces();
	const TimedSection section(session.timeline(), "trace");
	const view::LaunchChoice& choice = *session.view().launch;
	const probe::Sheet& content = slice.sheets[sheet].sheet;
	const std::vector<vectors::Launch> launches = ranks::launchLattice(session.ranks(), mesh, content, choice.lattice);
	const vectors::TraceOptions options{.steps = choice.steps,
	                                    .dt = session.launch().dt,
	                                    .direction = choice.direction,
	                                    .part = choice.part,
	                                    .normal = content.normal};
	Result<vectors::Traces> traces =
	    session.launch().stored ? vectors::tracePathLines(session.blocks(), *session.launch().stored,
	                                                      session.launch().time, launches, options)
	                            : ranks::trace(session.ranks(), session.blocks(), choice.array, launches, options);
	if (!traces)
		return traces.error();
	return std::make_shared<const vectors::Traces>(std::move(*traces));
}

std::optional<grid::FieldChoice> fluxArray(const Session& session, const cut::SheetCut& sheet)
{
	if (sheet.surface)
		return std::nullopt;
	if (session.view().vector_array)
		return session.view().vector_array;
	return sheet.field && hasVectors(session.blocks(), *sheet.field) ? sheet.field : std::nullopt;
}

std::optional<vectors::Flux> fluxThrough(const Session& session, const cut::Cut& slice, std::size_t number,
                                         const mesh::SheetMesh& mesh)
{
	const std::optional<grid::FieldChoice> array = fluxArray(session, slice.sheets[number]);
	if (!array)
		return std::nullopt;
	const vectors::FluxSums sums =
	    session.ranks().sum(vectors::fluxSums(slice.blocksOf(session.blocks()), mesh, *array),
	                        [](auto& sum, const auto& other) { sum.add(other); });
	return sums.flux();
}

} // namespace vp::session
