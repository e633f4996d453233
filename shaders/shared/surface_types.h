// The data that the classifier of curved surfaces passes to its shader. Bindings, specialization constants, push
// constants and formats are those of classify_types.h. Four-byte fields, scalar layout.
#ifndef SURFACE_TYPES_H
#define SURFACE_TYPES_H

#include "classify_types.h"

VP_SHARED_BEGIN

// The polynomial's coefficients of xx, yy, zz, xy, xz, yz, x, y, z, 1.
VP_CONST uint kQuadricCoefficients = 10u;

// A surface in a block for the length of a slice. A coordinate is what is stored and `shift`; of images and rectilinear
// grids it is stored as it is. Where `turned` is 1 the surface is a function of coordinates along the axes.
struct ClassifySurface
{
	float unit[3]; // unit of fixed-point numbers
	float shift[3];
	float place_error[3]; // error of a coordinate, before it is rounded here
	uint cells_i;         // lattices, as in ClassifyPlane
	uint cells_j;
	uint inverse_i;
	uint inverse_j;
	uint points_i;
	uint points_layer;
	uint axis_start[3];
	uint table_start[4];
	uint turned;
	float x_axis[3];
	float y_axis[3];
	float z_axis[3];
	float coefficient[kQuadricCoefficients];
	float coefficient_error[kQuadricCoefficients];
};

VP_SHARED_END

#endif
