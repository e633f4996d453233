#include "profile/swept_probe.h"

#include "base/frame_scope.h"
#include "team.h"
#include "view/settings.h"
#include "view/validate.h"

#include <fmt/format.h>

namespace vp::app
{

namespace
{

constexpr int kMaxPlanes = 10'000; // a profile keeps some dozens of numbers for each generation of each

Result<probe::Path> sweptPath(const ProfileOptions& options)
{
	view::SweepSpec sweep;
	if (Status chosen = choosePath(sweep, options.path); !chosen)
		return Error{chosen.error().kind, fmt::format("`path` {}: {}", options.path, chosen.error().message)};
	if (sweep.over_times)
		return Error{ErrorKind::usage, "--path times: a profile moves a probe; choose another path"};
	if (Status fits = view::requirePathOfSurface(options.common.spec.probe, sweep); !fits)
		return fits.error();
	return view::pathOf(sweep);
}

// A state brings a look, too; if nothing is drawn, it has no say.
view::ViewSpec sweptSpec(const ProfileOptions& options)
{
	view::ViewSpec spec = options.common.spec;
	if (!options.draw)
		spec.look = {};
	return spec;
}

} // namespace

Status checkSweep(const ProfileOptions& options)
{
	if (const Result<probe::Path> path = sweptPath(options); !path)
		return path.error();
	if (options.planes < 1 || options.planes > kMaxPlanes)
		return Error{ErrorKind::usage,
		             fmt::format("--planes {}: give a number from 1 to {}", options.planes, kMaxPlanes)};
	const view::ViewSpec spec = sweptSpec(options);
	if (Status fits = view::refuseGenerations(spec.probe, spec.look.color_by); !fits)
		return fits;
	const Result<view::ResolvedLook> look = view::resolveLook(spec);
	return look ? Status(Nothing{}) : look.error();
}

Result<SweptProbe> SweptProbe::open(const ProfileOptions& options)
{
	SweptProbe swept;
	const view::ViewSpec spec = sweptSpec(options);
	Result<probe::Path> path = sweptPath(options);
	if (!path)
		return path.error();
	swept.path_ = std::move(*path);
	Result<std::unique_ptr<session::Session>> session =
	    session::Session::open(spec, {.use = options.draw ? session::DeviceUse::draw : session::DeviceUse::classify,
	                                  .keep = options.trace.empty() ? Timeline::Keep::sections : Timeline::Keep::trace,
	                                  .ranks = processes()});
	if (!session)
		return session.error();
	swept.session_ = std::move(*session);
	if (options.draw)
	{
		Result<view::ResolvedLook> look = view::resolveLook(spec);
		if (!look)
			return look.error();
		swept.picture_ = fmt::format("{}x{}, {} samples", look->look.width, look->look.height, look->look.samples);
		swept.pixels_ = static_cast<std::size_t>(look->look.width) * static_cast<std::size_t>(look->look.height);
		Result<picture::Painter> painter = picture::Painter::create(*swept.session_, std::move(*look));
		if (!painter)
			return painter.error();
		swept.painter_.emplace(std::move(*painter));
	}
	swept.poses_ =
	    probe::poses(swept.path_, swept.session_->view().probe, swept.session_->blocks().bounds(), options.planes);
	return swept;
}

Status SweptProbe::measure(std::size_t plane)
{
	using Figures = session::Wants::Figures;
	const session::FrameRequest request{
	    .pose = poses_[plane],
	    .done = probe::progress(path_, static_cast<int>(plane), static_cast<int>(planes())),
	    .wants = {.figures = painter_ ? Figures::for_picture : Figures::none, .contours = false, .warns = false},
	    .expect = session::Expect::more};
	const FrameScope scope(static_cast<int>(plane), painter_ ? FrameScope::Stop::picture : FrameScope::Stop::cut);
	const TimedSection section(session_->timeline(), "frame");
	Result<std::shared_ptr<const session::Frame>> made = session_->frame(request);
	if (!made)
		return made.error();
	made_ = std::move(*made);
	if (!painter_)
		return Nothing{};
	const Result<render::Picture> picture = painter_->draw(made_->slice, made_->sheets);
	return picture ? Status(Nothing{}) : picture.error();
}

} // namespace vp::app
