#pragma once

#include "session/session.h"
#include "vectors/traces.h"

#include <memory>
#include <optional>

namespace vp::session
{

/// What launching needs beside the settings: the time of a step, which follows the fastest particle, and vectors of
/// other times. The fastest particle is looked up once for an array, until takeValuesAt().
Status prepareLaunch(Session& session);

// The arrays hold the values of a time now: the step of a session that chooses its own follows them.
void takeValuesAt(const read::TimeChoice& time, Session& session);

// Of the particles launched from a sheet, section "trace". mesh: its polygons. Null where nothing is to be launched.
// Fails where vectors of other times cannot be read.
using SharedTraces = std::shared_ptr<const vectors::Traces>;
Result<SharedTraces> traceSheet(const Session& session, const cut::Cut& slice, std::size_t sheet,
                                const mesh::SheetMesh& mesh);

// Through a sheet's polygons, along its normal: of the array that moves particles, else of the shown one where that is
// a vector; else none.
std::optional<double> fluxThrough(const Session& session, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh);

} // namespace vp::session
