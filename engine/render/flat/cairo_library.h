#pragma once

#include "base/result.h"

#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

namespace vp::render
{

// The functions of cairo that are called here, without their prefix.
#define VP_CAIRO(X)                                                                                                    \
	X(arc)                                                                                                             \
	X(clip)                                                                                                            \
	X(close_path)                                                                                                      \
	X(create)                                                                                                          \
	X(destroy)                                                                                                         \
	X(fill)                                                                                                            \
	X(fill_preserve)                                                                                                   \
	X(font_options_create)                                                                                             \
	X(font_options_destroy)                                                                                            \
	X(font_options_set_antialias)                                                                                      \
	X(font_options_set_hint_metrics)                                                                                   \
	X(font_options_set_hint_style)                                                                                     \
	X(ft_font_face_create_for_ft_face)                                                                                 \
	X(image_surface_create)                                                                                            \
	X(image_surface_get_data)                                                                                          \
	X(image_surface_get_height)                                                                                        \
	X(image_surface_get_stride)                                                                                        \
	X(image_surface_get_width)                                                                                         \
	X(line_to)                                                                                                         \
	X(move_to)                                                                                                         \
	X(new_path)                                                                                                        \
	X(new_sub_path)                                                                                                    \
	X(pattern_add_color_stop_rgb)                                                                                      \
	X(pattern_add_color_stop_rgba)                                                                                     \
	X(pattern_create_linear)                                                                                           \
	X(pattern_destroy)                                                                                                 \
	X(pdf_surface_create_for_stream)                                                                                   \
	X(pdf_surface_set_metadata)                                                                                        \
	X(rectangle)                                                                                                       \
	X(restore)                                                                                                         \
	X(rotate)                                                                                                          \
	X(save)                                                                                                            \
	X(scale)                                                                                                           \
	X(set_dash)                                                                                                        \
	X(set_fill_rule)                                                                                                   \
	X(set_font_face)                                                                                                   \
	X(set_font_options)                                                                                                \
	X(set_font_size)                                                                                                   \
	X(set_line_cap)                                                                                                    \
	X(set_line_join)                                                                                                   \
	X(set_line_width)                                                                                                  \
	X(set_source)                                                                                                      \
	X(set_source_rgba)                                                                                                 \
	X(show_text)                                                                                                       \
	X(status)                                                                                                          \
	X(status_to_string)                                                                                                \
	X(stroke)                                                                                                          \
	X(stroke_preserve)                                                                                                 \
	X(surface_destroy)                                                                                                 \
	X(surface_finish)                                                                                                  \
	X(surface_flush)                                                                                                   \
	X(surface_status)                                                                                                  \
	X(svg_surface_create_for_stream)                                                                                   \
	X(svg_surface_set_document_unit)                                                                                   \
	X(text_extents)                                                                                                    \
	X(text_path)                                                                                                       \
	X(translate)

// cairo is loaded when the first flat picture is drawn, and not with the program: it brings twelve libraries, among
// them those of X11, which take longer to load than a small cut takes.
struct Cairo
{
#define VP_MEMBER(name) decltype(&cairo_##name) name;
	VP_CAIRO(VP_MEMBER)
#undef VP_MEMBER
};

/// Loads cairo, unless it is loaded. Returns an error that says what to install if it is not there.
Status loadCairo();

/// Returns the functions of cairo. loadCairo() must have succeeded before.
const Cairo& cairo();

} // namespace vp::render
