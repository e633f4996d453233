#pragma once

#include "render/picture.h"
#include "session/frame.h"
#include "verify/verdict.h"

#include <vector>

namespace vp::app
{

// Draws a flat picture of each sheet, as `vprobe slice -o` writes it.
Result<std::vector<render::Picture>> drawFlat(const session::Session& session, const view::ViewSpec& spec,
                                              const session::Frame& frame);

// Puts the expected picture, the drawn one and their difference into a judgment, as PNG files.
Status keepPictures(const render::Picture& expected, const render::Picture& drawn, Judgment& found);

} // namespace vp::app
