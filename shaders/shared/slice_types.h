// Types and constants that the classify shader, the traversal and the drawing share. Four-byte fields, scalar layout.
#ifndef SLICE_TYPES_H
#define SLICE_TYPES_H

#include "portable.h"

VP_SHARED_BEGIN

// The code a classifier returns per cell: bits 0..7 the case index (bit v: vertex v is positive), bits 8..15 the cut
// faces.
VP_CONST uint kCodeFacesShift = 8u;
VP_CONST uint kCodeCut = 0x10000u;  // the cell is cut
VP_CONST uint kCodeWalk = 0x20000u; // undecided here: the CPU classifies and walks the cell in double

VP_CONST uint kMaxRecordVertices = 6u;
VP_CONST uint kRecordVertices = 0xFFu;    // the bits of a record's vertices that count them
VP_CONST uint kHiddenRecordEdge = 0x100u; // << i: the edge from vertex i to the next one is none of the cell's polygon
// Bits from here on: the width of the whole cell's cut as a multiple of the record's, 2 to the power of 1/256 of them.
VP_CONST uint kRecordWidthShift = 16u;
VP_CONST float kRecordWidthSteps = 256.0;

// One polygon as it is drawn. Record i of a sheet in a block belongs to the i-th cell of its traversal, so nothing is
// allocated on the GPU. A cell that emits nothing has no vertices.
struct PolygonRecord
{
	uint cell;                        // in its block
	uint vertices;                    // 0, or 3..6; with the edges that are not drawn, and the width of the cell
	float uv[2 * kMaxRecordVertices]; // in the sheet's frame, from its origin, grid units
	float value[kMaxRecordVertices];  // values of the shown array; NaN data are kNanValue
};

// Values cannot be told apart by NaN safely in shaders: fast-math drivers may drop the test.
VP_CONST float kNanValue = 3.0e38f;    // the array holds NaN here
VP_CONST float kEmptyValue = -3.0e38f; // a pixel of a value layer with no polygon

VP_SHARED_END

#endif
