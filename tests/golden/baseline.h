#pragma once

#include "render/picture.h"

#include <gtest/gtest.h>

#include <string>

namespace vp::render::test
{

Picture readPng(const std::string& path); // empty where it cannot be read

// Compares the picture with baselines/NAME.png: letters and edges may differ a little between devices, in few
// pixels. A pixel may have a color of the other picture up to `reach` pixels away. Where VPROBE_UPDATE_GOLDEN is 1, the
// baseline is written instead. A picture that differs is kept beside the test as NAME.png.
testing::AssertionResult looksLike(const Picture& picture, const std::string& name, int reach = 0);

} // namespace vp::render::test
