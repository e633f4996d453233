// The data that the GPU classifier passes to its shader. Four-byte fields, scalar layout. A double is passed as its two
// halves, low first.
#ifndef CLASSIFY_TYPES_H
#define CLASSIFY_TYPES_H

#include "portable.h"

VP_SHARED_BEGIN

VP_CONST uint kClassifyGroupSize = 64u; // one thread per cell of the front

// Bindings of the classify shader.
VP_CONST uint kBindPoints = 0u;  // array, four words a point
VP_CONST uint kBindCells = 1u;   // array, four or eight ids a cell of an unstructured grid
VP_CONST uint kBindCases = 2u;   // array, four words a case
VP_CONST uint kBindValues = 3u;  // array of floats, see kValuesNone
VP_CONST uint kBindAxes = 4u;    // array, see kCellsAxes
VP_CONST uint kBindFront = 5u;   // cell ids in
VP_CONST uint kBindCodes = 6u;   // codes out
VP_CONST uint kBindRecords = 7u; // polygon records out
VP_CONST uint kBindSheet = 8u;   // ClassifyPlane

// Specialisation constants.
VP_CONST uint kConstantCells = 0u;
VP_CONST uint kConstantPoints = 1u;
VP_CONST uint kConstantValues = 2u;

// How a cell finds its points.
VP_CONST uint kCellsAxes = 0u;    // image and rectilinear grids: four words per coordinate of each axis and sheet, that
                                  // hold the coordinate's share in the distance (double), in u and in v
VP_CONST uint kCellsLattice = 1u; // curvilinear grids
VP_CONST uint kCellsRecord4 = 2u; // unstructured grids of tetrahedra
VP_CONST uint kCellsRecord8 = 3u; // other unstructured grids

VP_CONST uint kShapeMark = 0xFFFFFFF0u; // grid::UnstructuredGrid's: the last id of a cell of fewer than 8 points

// How a point is stored.
VP_CONST uint kPointsFloat = 0u; // three floats, as the source has them
VP_CONST uint kPointsFixed = 1u; // three signed numbers of 41 bits, from the block's center: 32 upper bits each in x,
                                 // y, z; in w 9 lower bits each, then three flags
VP_CONST uint kFixedLowBits = 9u;
VP_CONST uint kFixedInexactShift = 27u; // bit 27 + axis: the source is not exactly this number

// The elements that have values: one number each, or, to show the length of a tuple, as many groups of four numbers as
// hold it.
VP_CONST uint kValuesNone = 0u; // `no_value` everywhere
VP_CONST uint kValuesPoint = 1u;
VP_CONST uint kValuesCell = 2u;
VP_CONST uint kValuesPointTuple = 3u;
VP_CONST uint kValuesCellTuple = 4u;

// One sheet in a block, for the length of a cut.
struct ClassifyPlane
{
	uint normal[6];         // canonical unit normal of the plane
	uint origin[6];         // origin of the sheet
	uint center[6];         // center of the block's fixed-point numbers
	float unit[3];          // their unit, a power of two
	float single_normal[3]; // the same in floats, for devices without doubles
	float single_center[3]; // center - origin
	float single_origin_hi[3];
	float single_origin_lo[3];
	float x_axis[3]; // axes of the sheet
	float y_axis[3];
	float error;            // bound of |distance here - distance on the CPU|, see distanceError()
	float least_difference; // least difference of the distances at the ends of a cut edge
	uint inexact_mask;      // flags of the axes that the normal has a part in; a point without them is exact
	uint cells_i;           // lattices
	uint cells_j;
	uint inverse_i; // floor((2^32 - 1) / cells_i)
	uint inverse_j;
	uint points_i;
	uint points_layer;
	uint axis_start[3];
	uint table_start[4]; // start of each shape in the case tables
	uint tuple_texels;   // texels of a point or cell, of four numbers each
	float no_value;
	uint flipped; // 1: the plane's normal is not the sheet's, so the polygons turn the other way
	uint nearest; // 1: a vertex takes the value of the nearer end of its edge
};

struct ClassifyPush
{
	uint count;  // cells
	uint padded; // records written: those past `count` are empty
};

VP_SHARED_END

#endif
