// What the drawing's shaders and engine/render share. Four-byte fields, scalar layout.
#ifndef RENDER_TYPES_H
#define RENDER_TYPES_H

#include "portable.h"

VP_SHARED_BEGIN

VP_CONST uint kMaxLayers = 16u; // sheets in a picture

// A record's fan of triangles, unused ones without area.
VP_CONST uint kRecordTriangles = 4u;
VP_CONST uint kRecordCorners = 3u * kRecordTriangles;

// From a sheet's (u, v) to clip space: u * u_axis + v * v_axis + origin.
struct LayerPush
{
	float u_axis[4];
	float v_axis[4];
	float origin[4];
};

struct LineSegment
{
	float a[3];
	float b[3];
};

// Line vertices, drawn without instances: two triangles a segment.
VP_CONST uint kSegmentCorners = 6u;

struct LinePush
{
	float clip[16];     // columns
	float half_size[2]; // of the picture, pixels
	float half_width;   // of a line, pixels
	float near_w;       // w of the near plane
	float depth_bias;   // factor on near / w: lines in a sheet's rim win
};

struct ComposePush
{
	float jitter[2]; // pixels by which this sample's picture is moved
};

// Colours are encoded (sRGB), not multiplied by alpha; packed ones hold red in the lowest byte.
struct ComposeParams
{
	float height;
	float sample_weight; // 1 / samples
	uint last_layer;
	uint has_values;  // 0: all sheets have plain_color
	float below_from; // values below and above these have colours of their own
	float above_from;
	float range_lo;
	float range_scale; // t = (value - lo) * scale + offset
	float range_offset;
	uint nan_color;
	uint below_color;
	uint above_color;
	uint plain_color;
	float line_color[4];
	float top_color[4]; // of the background
	float bottom_color[4];
	float plane[4u * kMaxLayers]; // near / w = a x + b y + c in pixels; opacity
	uint colors[256];
};

struct OverlayPush
{
	float to_clip[2]; // 2 / size
};

VP_SHARED_END

#endif
