#pragma once

#include "session.h"
#include "vectors/traces.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <optional>

namespace vp::app
{

// Told before a large file is read.
Status checkVectors(const ProbeOptions& options);

// What is launched from the sheets, as the options say it of the session's blocks, field and probe; none where nothing
// is. The fastest particle is
// looked up once for an array, until takeValuesAt().
Status chooseVectors(const ProbeOptions& options, Session& session);

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

// For --stats.
nlohmann::json tracesJson(const Session& session, const vectors::Traces& traces);

} // namespace vp::app
