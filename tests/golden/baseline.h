#pragma once

#include "render/picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>

namespace vp::render::test
{

// A part of a picture, in pixels; the ends lie behind it.
struct PictureBox
{
	std::uint32_t x0, y0, x1, y1;
};

Picture partOf(const Picture& picture, const PictureBox& box);

Picture readPng(const std::string& path); // empty where it cannot be read

// Compares two pictures of eight samples a pixel as `vprobe verify` does, with its limits.
testing::AssertionResult passes(const Picture& expected, const Picture& drawn);

// Compares the picture with baselines/NAME.png. Where VPROBE_UPDATE_GOLDEN is 1, the baseline is written instead. A
// picture that differs is kept beside the test as NAME.png. part: only this part counts.
testing::AssertionResult looksLike(const Picture& picture, const std::string& name,
                                   const std::optional<PictureBox>& part = {});

} // namespace vp::render::test
