#pragma once

namespace vp::reader::meshes
{

struct GmshMesh;

// Versions 1 and 2 write an element once for each of its physical groups. Such elements become one, with all groups.
void joinGmshTwins(GmshMesh& mesh);

} // namespace vp::reader::meshes
