#pragma once

#include "base/result.h"
#include "render/picture.h"
#include "write/atomic_file.h"

#include <string>

namespace vp::write
{

// `path` may be "-" for standard output. A file appears whole or not at all: it is written beside its place and then
// renamed. Opaque pictures are stored without alpha.
Status writePng(const render::Picture& picture, const std::string& path);

// The bytes of such a file.
Result<std::string> pngBytes(const render::Picture& picture);

// The same into a file that is committed later; errors name the path.
Status encodePng(const render::Picture& picture, const std::string& path, AtomicFile& file);

} // namespace vp::write
