#include "view/validate.h"
#include "view/words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace vp::test
{

using view::ViewSpec;

namespace
{

// The error names the setting by its key, and says what is wrong in one line.
void refused(const std::string& words, const std::function<void(ViewSpec&)>& spoil)
{
	ViewSpec spec;
	ASSERT_TRUE(view::validate(spec));
	spoil(spec);
	const Status fits = view::validate(spec);
	ASSERT_FALSE(fits) << words;
	EXPECT_EQ(fits.error().kind, ErrorKind::usage);
	EXPECT_NE(fits.error().message.find(words), std::string::npos) << fits.error().message;
	EXPECT_EQ(fits.error().message.find('\n'), std::string::npos);
}

} // namespace

TEST(Validate, NumbersHaveLimits)
{
	refused("`vanes` 0", [](ViewSpec& s) { s.probe.vanes = 0; });
	refused("`samples` 257", [](ViewSpec& s) { s.look.samples = 257; });
	refused("`opacity` nan", [](ViewSpec& s) { s.look.opacity = NAN; });
	refused("`refine` 7", [](ViewSpec& s) { s.input.refine = 7; });
	refused("`displace` inf", [](ViewSpec& s) { s.input.displace = INFINITY; });
	refused("`origin` nan", [](ViewSpec& s) { s.probe.origin = Vec3(0.0, NAN, 0.0); });
	refused("`offsets` inf",
	        [](ViewSpec& s)
	        {
		        s.probe.shape = view::ProbeShape::stack;
		        s.probe.offsets = {1.0, INFINITY};
	        });
	refused("`vector_dt` 0", [](ViewSpec& s) { s.probe.vectors.dt = 0.0; });
	refused("`frames` 0", [](ViewSpec& s) { s.sweep.frames = 0; });
	refused("`fps` 0", [](ViewSpec& s) { s.sweep.frames_per_second = 0.0; });
	refused("`contour_depth` -1", [](ViewSpec& s) { s.look.contour.depth = -1.0; });
	refused("`opacity_points` 1.5", [](ViewSpec& s) { s.look.opacity_points = {0.0, 0.0, 1.5, 1.0}; });
	refused("`opacity_points`: 3 numbers", [](ViewSpec& s) { s.look.opacity_points = {0.0, 0.0, 1.0}; });
	refused("`opacity_points`: the place 0.7", [](ViewSpec& s) { s.look.opacity_points = {0.7, 0.0, 0.2, 1.0}; });
	refused("`threads` -1", [](ViewSpec& s) { s.machine.threads = -1; });
}

TEST(Validate, SettingsThatDoNotGoTogether)
{
	refused("`normal`", [](ViewSpec& s) { s.probe.normal = Vec3(0.0); });
	refused("`window` 0 1", [](ViewSpec& s) { s.probe.window = probe::WindowSize{0.0, 1.0}; });
	refused("`vanes`: goes with `probe` paddlewheel", [](ViewSpec& s) { s.probe.vanes = 3; });
	refused("`corners`", [](ViewSpec& s) { s.probe.corners = mesh::Corners::skip; });
	refused("`probe`", [](ViewSpec& s) { s.probe.shape = view::ProbeShape::own; });
	refused("`sheets`: `offsets`",
	        [](ViewSpec& s)
	        {
		        s.probe.shape = view::ProbeShape::stack;
		        s.probe.offsets = {1.0};
		        s.probe.sheets = 3;
	        });
	refused("`origin`: belongs to planes, and `surface` i=2",
	        [](ViewSpec& s)
	        {
		        s.probe.surface = *view::parseSurface("i=2");
		        s.probe.origin = Vec3(0.0);
	        });
	refused("`vectors`",
	        [](ViewSpec& s)
	        {
		        s.probe.surface = *view::parseSurface("sphere:1");
		        s.probe.vectors.kind = view::TraceKind::lines;
	        });
	refused("`contour`: grows from planes, and `iso` 2",
	        [](ViewSpec& s)
	        {
		        s.probe.surface = *view::parseSurface("iso:2");
		        s.look.contour.values = {1.0};
	        });
	refused("`threshold` 2 1", [](ViewSpec& s) { s.probe.threshold = find::Threshold{2.0, 1.0}; });
	refused("`range` 1 1", [](ViewSpec& s) { s.look.range = std::pair{1.0, 1.0}; });
	refused("`range` -1 1: `log`",
	        [](ViewSpec& s)
	        {
		        s.look.range = std::pair{-1.0, 1.0};
		        s.look.logarithmic = true;
	        });
	refused("`symmetric`", [](ViewSpec& s) { s.look.symmetric = s.look.logarithmic = true; });
}

TEST(Validate, WhatACommandNeeds)
{
	ViewSpec spec;
	EXPECT_TRUE(view::requirePlanes(spec.probe));
	EXPECT_TRUE(view::requireOneSurface(spec.probe));
	EXPECT_TRUE(view::requirePathOfSurface(spec.probe, spec.sweep));
	spec.probe.surface = *view::parseSurface("j=1..4");
	EXPECT_FALSE(view::requirePlanes(spec.probe));
	EXPECT_FALSE(view::requireOneSurface(spec.probe));
	EXPECT_TRUE(view::requirePathOfSurface(spec.probe, spec.sweep));
	EXPECT_FALSE(view::refuseGenerations(spec.probe, view::ColorBy::generation));
	spec.sweep.kind = probe::PathKind::spin;
	EXPECT_FALSE(view::requirePathOfSurface(spec.probe, spec.sweep));
	spec.sweep.kind = probe::PathKind::translate;
	spec.probe.surface = *view::parseSurface("j=1");
	EXPECT_FALSE(view::requirePathOfSurface(spec.probe, spec.sweep));
}

} // namespace vp::test
