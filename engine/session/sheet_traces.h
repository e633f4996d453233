#pragma once

#include "session/session.h"
#include "vectors/flux.h"
#include "vectors/traces.h"

#include <memory>
#include <optional>

namespace vp::session
{

// Traces the particles that start on a sheet. mesh: the polygons of the sheet. Returns null if nothing is launched.
// Fails if vectors of other times cannot be read. Section "trace" on the timeline.
using SharedTraces = std::shared_ptr<const vectors::Traces>;
Result<SharedTraces> traceSheet(const Session& session, const cut::Cut& slice, std::size_t sheet,
                                const mesh::SheetMesh& mesh);

// Returns the array whose flux through a sheet is told: the one that moves particles, or the shown array if it is a
// vector array, or nothing.
std::optional<grid::FieldChoice> fluxArray(const Session& session, const cut::SheetCut& sheet);

// Returns the flux of that array through the polygons of a sheet, along its normal.
std::optional<vectors::Flux> fluxThrough(const Session& session, const cut::Cut& slice, std::size_t sheet,
                                         const mesh::SheetMesh& mesh);

} // namespace vp::session
