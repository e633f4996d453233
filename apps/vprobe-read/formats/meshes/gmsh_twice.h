#pragma once

struct GmshMesh;

// Versions 1 and 2 write an element once for each of its physical groups. Such elements become one, with all groups.
void joinGmshTwins(GmshMesh& mesh);
