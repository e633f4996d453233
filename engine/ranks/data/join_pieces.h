#pragma once

#include "read/read.h"

namespace vp::ranks
{

/// Puts the pieces of one unstructured grid that a rank holds together into one block, as a reader of the whole file
/// does: their points and cells one behind the other. Pieces stay apart where they know their neighbors already, where
/// cells are curved, or where their arrays differ. Throws grid::WrongPoint if a cell names a point that there is not.
void joinPieces(read::PartBlocks& read, const read::PartList& list);

} // namespace vp::ranks
