// Types and constants that the drawing's shaders and engine/render share. Four-byte fields, scalar layout.
#ifndef RENDER_TYPES_H
#define RENDER_TYPES_H

#include "portable.h"

VP_SHARED_BEGIN

VP_CONST uint kMaxLayers = 16u;   // sheets in a picture
VP_CONST uint kMaxSurfaces = 64u; // and surfaces

// A record's fan of triangles, unused ones without area.
VP_CONST uint kRecordTriangles = 4u;
VP_CONST uint kRecordCorners = 3u * kRecordTriangles;

// From a sheet's (u, v) to clip space: u * u_axis + v * v_axis + origin. What of it is drawn beyond the values is known
// when the pipeline is made (kLayer bits).
struct LayerPush
{
	float u_axis[4];
	float v_axis[4];
	float origin[4];
	float window[4];       // u from, to, v from, to; with kLayerWindow
	float mesh_half_width; // pixels; with kLayerMesh
};

VP_CONST uint kLayerWindow = 1u; // what lies outside of the window is left out
VP_CONST uint kLayerMesh = 2u;   // how much of a line along the polygons' edges is at a pixel goes beside the values

// The compute rasterizer. Pixels are numbered from 0, and their centers lie at whole numbers.
VP_CONST uint kRasterGroupSize = 64u; // threads
VP_CONST uint kRasterRows = 8u;       // threads of a group that work on the rows of one large polygon
VP_CONST uint kRasterBands = 8u;      // groups that share the rows of a huge polygon
VP_CONST uint kSubpixels = 256u;      // a pixel's side has so many places for corners: as many as hardware has
// Corners beyond this are clipped away, in subpixels: differences of places stay below 2^24, so floats hold them.
VP_CONST float kFarOutside = 4194304.0;
VP_CONST float kHugeArea = 65536.0; // a polygon that covers more square pixels is huge
VP_CONST uint kMaxRasterSide = 64u; // pixels; of larger polygons the edges would not fit into 32 bits

// Its stages. Each takes the polygons that the first one left to it.
VP_CONST uint kRasterSmall = 0u;
VP_CONST uint kRasterLarge = 1u;
VP_CONST uint kRasterHuge = 2u;  // or reaching the near plane, or far outside of the picture
VP_CONST uint kRasterLists = 2u; // lists of a run, for the stages after the first one
// If a picture has more than one sample, the polygons near edges are listed, and replace all polygons in the first
// stage.
VP_CONST uint kRasterKeep = 3u;
VP_CONST uint kRasterKept = 4u;
VP_CONST uint kRasterStages = 5u;

struct RasterPush
{
	float u_axis[3]; // from (u, v) to a place in subpixels times w, and w: u * u_axis + v * v_axis + origin
	float v_axis[3];
	float origin[3];
	float u_of_pixel[3]; // from a pixel (x, y, 1) to (u, v, 1) times a factor
	float v_of_pixel[3];
	float w_of_pixel[3];
	float window[4]; // u from, to, v from, to; with kLayerWindow
	float near_w;    // w of the near plane
	float largest;   // side of a small polygon, subpixels
	float last_pixel[2];
	uint first;       // first record of the page
	uint count;       // number of records
	uint lists;       // place of the run's first RasterList
	uint listed_from; // place of the run's first number in the list
	uint kept_list;   // place of the RasterList of the kept polygons
	uint kept_from;   // place of the first number that it keeps
};

// The polygons that a run leaves to a later stage.
struct RasterList
{
	uint groups[3]; // VkDispatchIndirectCommand
	uint count;     // polygons
};

// Pixels at which a picture needs more samples than its first one: where a channel departs by more than this from the
// line between the pixels on both sides. A step of this height is off by at most its half.
VP_CONST float kEdgeFrom = 2.0f / 255.0f;
VP_CONST float kPictureEdgeFrom = 2.5f / 255.0f; // the same between colors of 8 bits: three steps are above it
VP_CONST uint kEdgeTile = 16u; // pixels a side of the squares that are drawn again where they hold an edge
VP_CONST uint kEdgeGroupSize = 64u;

struct EdgePush
{
	uint tiles_across;
	uint tiles_down;
	uint reach; // pixels around it that a pixel's color depends on
};

// The squares of pixels near edges: a VkDispatchIndirectCommand of a group each, and a VkDrawIndirectCommand of their
// corners. Their numbers follow.
struct TileList
{
	uint groups[3];
	uint corners;
	uint instances;
	uint firsts[2];
};
VP_CONST uint kTileCorners = 6u; // two triangles

struct TilesPush
{
	float to_clip[2]; // 2 / size of the picture
	uint across;      // squares
};

// Pixels at edges, two by two as the device colors them together: a VkDispatchIndirectCommand, and their number. What
// follows is a word each, x / 2 and above it y / 2.
struct QuadList
{
	uint groups[3];
	uint count;
};
VP_CONST uint kQuadGroupSize = 64u;      // threads, one a pixel
VP_CONST uint kQuadGroupsAcross = 4096u; // groups in a row of a dispatch; then the next row begins

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
	float half_size[2]; // half the picture's size, pixels
	float half_width;   // half a line's width, pixels
	float near_w;       // w of the near plane
	float depth_bias;   // factor on near / w: lines in a sheet's rim win
};

struct ComposePush
{
	float jitter[2]; // pixels by which this sample's picture is moved
	uint number;     // number of the sample, from 1 on; at edges only
	uint last_number;
	uint layers;   // number of layers that may be here, in the order of their numbers
	uint slots[2]; // their numbers, four bits each
};

struct ResolvePush
{
	int first_row; // the picture's row that is the first of the drawn part
};

// Features of the composing pass, known when its pipeline is made: what a picture does not use costs nothing.
VP_CONST uint kComposeLines = 1u;
VP_CONST uint kComposeSteps = 2u; // bands or categories
VP_CONST uint kComposeLog = 4u;
VP_CONST uint kComposeMesh = 8u;
VP_CONST uint kComposeGround = 64u;  // a part of the picture in which no layer has anything
VP_CONST uint kComposeWhole = 128u;  // the one sample of a picture, over its background
VP_CONST uint kComposeOpaque = 256u; // some surfaces hide all that is behind them

// A layer's plane, and how its values become colors. Values are scaled first: y is the value, or its log10. Places are
// those in the buffer of tables, four-byte words; colors are encoded (sRGB), not multiplied by alpha, red in the
// lowest byte.
struct SheetParams
{
	float plane[3]; // near / w = a x + b y + c in pixels
	float opacity;
	float below_from; // y below and above these have colors of their own
	float above_from;
	float range_lo;
	float range_scale; // t = (y - lo) * scale + offset
	float range_offset;
	float shade; // shade by the light on the sheet, a factor on colors
	uint is_log;
	uint is_stepped;  // values are constant in each polygon
	uint colors;      // place of kTableColors colors over t from 0 to 1
	uint step_bounds; // place of the bounds between steps, ascending y
	uint step_colors; // place of one color more than there are bounds
	uint step_count;  // bounds; 0: colors are continuous
	uint levels;      // place of the contour lines' y, ascending
	uint level_count;
	uint nan_color;
	uint below_color;
	uint above_color;
};

VP_CONST uint kTableColors = 256u;

// The colors of a layer, with its light and opacity taken in: places in its table. Steps, or so many colors over the
// range, are in the last; nearest ones are taken, which with a thousand is as good as to interpolate between 256.
VP_CONST uint kLayerBelow = 0u;
VP_CONST uint kLayerAbove = 1u;
VP_CONST uint kLayerNan = 2u;
VP_CONST uint kLayerRange = 3u;
VP_CONST uint kLayerRangeColors = 1024u;

// Colors here are encoded, not multiplied by alpha.
struct ComposeParams
{
	float height;
	float sample_weight;      // 1 / samples
	float contour_half_width; // pixels
	float line_color[4];
	float top_color[4]; // colors of the background
	float bottom_color[4];
	uint layer_colors[kMaxLayers]; // where a layer's colors begin
	SheetParams sheets[kMaxLayers];
};

// A triangle of a surface's polygon. Vertices are texels of their own: x, y, z from the surface's origin, and a value.
struct SurfaceTriangle
{
	uint corners[3]; // vertices; with kHiddenEdge the edge to the next corner is no edge of the polygon
	float value;     // the polygon's value; else wholeValue() of its corners (render_whole.glsl)
	uint normals[3]; // at the corners, unit, octahedral, two 16-bit snorms
	float width;     // factor from the triangle's width to the polygon's: 4 area / perimeter each
};

// Special values in pictures, beside kNanValue and kEmptyValue. Data are no larger than kInfiniteValue, which stands
// for infinity. Values from kInfiniteFrom on count as infinite, since an edge from a finite value to an infinite one
// may be cut near the finite one. Common marks for missing data, up to 1e37, are finite.
VP_CONST float kInfiniteValue = 2.0e38f;
VP_CONST float kInfiniteFrom = 1.0e37f;
VP_CONST float kNanFrom = 2.5e38f;
VP_CONST float kEmptyUpTo = -2.5e38f;

VP_CONST uint kHiddenEdge = 0x80000000u;
VP_CONST uint kSurfaceTexels = 2u; // a triangle, four words each

struct SurfacePush
{
	float clip[16]; // from places about the surface's origin, columns
	float eye[3];   // such a place
	uint surface;   // its number in the scene
	float near_w;   // w of the near plane, the least bit less: a sheet in the surface's plane is in front
	float mesh_half_width;
	uint counter;  // counter of this sample and strip
	uint capacity; // capacity for fragments
};

// The triangles of an opaque surface that later samples may show: a bit for each triangle, then the indices of their
// corners, and a VkDrawIndexedIndirectCommand.
VP_CONST uint kCullGroupSize = 64u;
VP_CONST uint kKeptGroupSize = 128u;

struct SurfaceCullPush
{
	float clip[16]; // from places about the surface's origin, columns
	float near_w;   // as in SurfacePush
	float width;    // size of the picture, pixels
	float height;
	uint count;       // number of triangles
	uint first_word;  // first word of the bits
	uint first_index; // first index of the corners
	uint draw;        // its number
};

struct IndexedDraw
{
	uint index_count;
	uint instances;
	uint first_index;
	uint vertex_offset;
	uint first_instance;
};

// Features of a surface beside those of the composing pass.
VP_CONST uint kSurfaceLit = 16u;
VP_CONST uint kSurfacePolygonValues = 32u; // values belong to polygons, not to vertices
VP_CONST uint kSurfaceThick = 64u;         // more opaque the more it is seen from the side

// The input of a surface's pass. kAmbient is the share of light that has no direction.
struct SurfaceColors
{
	float contour_half_width; // pixels
	float light[3];           // unit, to it
	SheetParams sheets[kMaxSurfaces];
};

VP_CONST float kAmbient = 0.45f;

// An element of a pixel's list of surface fragments.
struct SurfaceFragment
{
	uint next;   // 1 + its place, 0 at the end: what llvmpipe reads for lanes without a pixel must end a loop
	float depth; // near / w
	uint color;  // red, green, blue in 10 bits each, not multiplied by alpha
	uint order;  // the surface's number, and below it 16 bits of alpha
};

struct OverlayPush
{
	float to_clip[2]; // 2 / size
};

VP_SHARED_END

#endif
