#pragma once

#include "ome_zarr.h"
#include "vprobe-read/base/request.h"

class ManifestWriter;

void readOmeZarr(const OmeZarr& image, const Request& request, ManifestWriter& manifest);
