#pragma once

#include "ome_zarr.h"
#include "vprobe-read/base/request.h"

namespace vp::reader::manifest
{
class Writer;
}

namespace vp::reader::volumes
{

void readOmeZarr(const OmeZarr& image, const Request& request, manifest::Writer& manifest);

} // namespace vp::reader::volumes
