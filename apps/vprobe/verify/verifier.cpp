#include "verify/verifier.h"

#include "gpu/driver_name.h"
#include "picture/compare.h"
#include "picture/plane_pictures.h"
#include "picture/read_png.h"
#include "report/stats_json.h"
#include "session/times_seen.h"
#include "verify/flat_pictures.h"
#include "verify/sweep_frames.h"
#include "view/validate.h"
#include "write/atomic_file.h"
#include "write/png.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace vp::app
{

namespace
{

double secondsNow()
{
	return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool isThere(const std::string& file)
{
	std::error_code unknown;
	return std::filesystem::exists(file, unknown);
}

bool wantsPicture(const VerifyCase& one)
{
	return one.has_picture || !one.hasAny(); // a state alone gets one
}

bool wantsFrames(const VerifyCase& one, bool updates)
{
	const view::SweepSpec& sweep = one.spec.sweep;
	return one.has_frames || (updates && (sweep.frames || sweep.own || sweep.over_times));
}

// Figures find what pictures do not show, so an update writes them beside each state.
bool wantsFigures(const VerifyCase& one, bool updates)
{
	return one.has_figures || updates;
}

Status writeText(const std::string& text, const std::string& file)
{
	Result<write::AtomicFile> out = write::AtomicFile::create(file, true);
	if (!out)
		return out.error();
	out->write(text);
	return out->commit();
}

} // namespace

void Verifier::judge(std::span<const VerifyCase> cases)
{
	started_ = secondsNow();
	while (!cases.empty())
	{
		std::size_t count = 1;
		while (count < cases.size() && cases[count].spec.input == cases.front().spec.input)
			++count;
		judgeGroup(cases.first(count));
		cases = cases.subspan(count);
	}
}

void Verifier::judgeGroup(std::span<const VerifyCase> group)
{
	// A session that was read for one case alone would lack the arrays of another.
	const bool reads_all_arrays = group.size() > 1 || wantsFigures(group.front(), options_.updates);
	for (const VerifyCase& one : group)
		if (one.wrong)
			fail(about(one.state, false), *one.wrong);
		else
			judgeCase(one, reads_all_arrays);
	forget();
}

void Verifier::forget()
{
	if (painter_)
		renderer_.emplace(std::move(*painter_).takeRenderer());
	painter_.reset();
	session_.reset();
}

Status Verifier::open(const VerifyCase& one, bool draws, bool reads_all_arrays)
{
	session::OpenOptions how{.use = draws && !no_device_ ? session::DeviceUse::draw : session::DeviceUse::classify,
	                         .expect = session::Expect::one_cut,
	                         .reads_all_arrays = reads_all_arrays,
	                         .time_may_change = false};
	how.device = device_;
	Result<std::unique_ptr<session::Session>> opened = session::Session::open(one.spec, how);
	if (!opened && opened.error().kind == ErrorKind::device && how.use == session::DeviceUse::draw)
	{
		// Figures need no device.
		no_device_ = opened.error();
		how.use = session::DeviceUse::classify;
		opened = session::Session::open(one.spec, how);
	}
	if (!opened)
		return opened.error();
	session_ = std::move(*opened);
	if (session_->device())
		device_ = session_->device();
	return Nothing{};
}

Status Verifier::needDevice()
{
	if (no_device_)
		return *no_device_;
	if (session_->device())
		return Nothing{};
	Status opened = device_ ? session_->takeDevice(device_) : session_->openDevice();
	if (!opened)
		no_device_ = opened.error();
	else
		device_ = session_->device();
	return opened;
}

Status Verifier::prepare(const VerifyCase& one, bool draws, bool reads_all_arrays)
{
	if (Status single = view::requireOneSurface(one.spec.probe); !single)
		return single;
	if (!session_)
		return open(one, draws, reads_all_arrays);
	return session_->set(one.spec);
}

void Verifier::judgeCase(const VerifyCase& one, bool reads_all_arrays)
{
	const bool draws = wantsPicture(one);
	const bool sweeps = wantsFrames(one, options_.updates);
	if (Status ready = prepare(one, draws || sweeps, reads_all_arrays); !ready)
		return fail(about(one.state, false), ready.error());
	const Status device = draws || sweeps ? needDevice() : Nothing{};
	const Result<std::shared_ptr<const session::Frame>> made = session_->frame({});
	if (!made)
	{
		fail(about(one.state, false), made.error());
		return forget();
	}
	const session::Frame& frame = **made;

	Result<Tolerances> tolerances = Tolerances{};
	if (one.has_figures)
	{
		const Result<nlohmann::json> expected = readFigures(one.figures());
		tolerances = expected ? tolerancesOf(*expected, one.figures()) : expected.error();
	}
	picture::PictureTolerance in_space = picture::toleranceOf(one.spec.look.samples);
	picture::PictureTolerance flat;
	if (tolerances && tolerances->picture)
		in_space = flat = *tolerances->picture;
	if (draws && !device)
		fail(about(one.picture(), false), device.error());
	else if (draws)
		judgePicture(one, frame, in_space);
	if (one.has_flat)
		judgeFlat(one, frame, flat);
	if (wantsFigures(one, options_.updates))
		judgeFigures(one, frame, tolerances);
	if (sweeps && !device)
		fail(about(one.beside(SweepFrames::kEndings[0]), false), device.error());
	else if (sweeps)
		judgeSweep(one, in_space);
}

Status Verifier::preparePainter(const VerifyCase& one)
{
	if (Status known = view::refuseGenerations(one.spec.probe, one.spec.look.color_by); !known)
		return known;
	Result<view::ResolvedLook> look = view::resolveLook(one.spec);
	if (!look)
		return look.error();
	if (painter_)
	{
		if (Status taken = painter_->setLook(std::move(*look)); !taken)
			return taken;
	}
	else
	{
		Result<picture::Painter> painter =
		    renderer_ ? picture::Painter::create(*session_, std::move(*look), std::move(*renderer_))
		              : picture::Painter::create(*session_, std::move(*look));
		renderer_.reset();
		if (!painter)
			return painter.error();
		painter_.emplace(std::move(*painter));
	}
	return Nothing{};
}

Result<render::Picture> Verifier::draw(const VerifyCase& one, const session::Frame& frame)
{
	if (Status ready = preparePainter(one); !ready)
		return ready.error();
	return painter_->draw(frame.slice, frame.sheets, frame.contours);
}

// All three frames are drawn: the camera is that of the first one. Over times, the session ends with this case.
void Verifier::judgeSweep(const VerifyCase& one, const picture::PictureTolerance& tolerance)
{
	const Result<SweepFrames> frames = SweepFrames::of(*session_);
	Status ready = frames ? preparePainter(one) : frames.error();
	if (ready && frames->isOverTimes())
		ready = painter_->fitTimes(session::firstMiddleAndLast(session_->blocks().times.size()));
	const bool is_over_times = frames && frames->isOverTimes();
	for (std::size_t which = 0; ready && which < SweepFrames::kEndings.size(); ++which)
	{
		ready = frames->goTo(*session_, which);
		if (!ready)
			break;
		const Result<std::shared_ptr<const session::Frame>> made = session_->frame(frames->request(which));
		Result<render::Picture> drawn =
		    made ? painter_->draw((*made)->slice, (*made)->sheets, (*made)->contours) : made.error();
		if (!drawn)
			ready = drawn.error();
		else if (isThere(one.beside(SweepFrames::kEndings[which])) || options_.updates)
			compare(about(one.beside(SweepFrames::kEndings[which]), true), *drawn, tolerance);
	}
	if (!ready)
		fail(about(one.beside(SweepFrames::kEndings[0]), true), ready.error());
	if (!ready || is_over_times)
		forget();
}

void Verifier::judgePicture(const VerifyCase& one, const session::Frame& frame,
                            const picture::PictureTolerance& tolerance)
{
	Result<render::Picture> drawn = draw(one, frame);
	Judgment found = about(one.picture(), true);
	if (!drawn)
		return fail(std::move(found), drawn.error());
	compare(std::move(found), *drawn, tolerance);
}

void Verifier::judgeFlat(const VerifyCase& one, const session::Frame& frame, const picture::PictureTolerance& tolerance)
{
	Result<std::vector<render::Picture>> drawn = drawFlat(*session_, one.spec, frame);
	if (!drawn)
		return fail(about(one.flat(), false), drawn.error());
	for (std::size_t s = 0; s < drawn->size(); ++s)
		compare(about(drawn->size() == 1 ? one.flat() : one.beside(fmt::format(".flat.{}.png", s)), false), (*drawn)[s],
		        tolerance);
}

// Compares a drawn picture with the file, or writes the file.
void Verifier::compare(Judgment found, const render::Picture& drawn, const picture::PictureTolerance& tolerance)
{
	const bool is_there = isThere(found.file);
	if (is_there)
	{
		const Result<render::Picture> expected = picture::readPng(found.file);
		if (!expected)
			return fail(std::move(found), expected.error());
		const Result<picture::PictureDifference> difference = picture::comparePictures(*expected, drawn);
		found.detail = difference ? difference->text() : difference.error().message;
		if (difference && difference->isWithin(tolerance))
			return tell(std::move(found));
		if (options_.keeps_pictures)
			if (Status kept = keepPictures(*expected, drawn, found); !kept)
				return fail(std::move(found), kept.error());
	}
	else
		found.detail = "was missing";
	if (!options_.updates && !is_there)
		return fail(std::move(found),
		            {ErrorKind::input, fmt::format("{}: is missing; --update writes it", found.file)});
	found.verdict = options_.updates ? Verdict::updated : Verdict::differs;
	if (Status written = options_.updates ? write::writePng(drawn, found.file) : Nothing{}; !written)
		return fail(std::move(found), written.error());
	tell(std::move(found));
}

void Verifier::judgeFigures(const VerifyCase& one, const session::Frame& frame, const Result<Tolerances>& tolerances)
{
	const nlohmann::json figures = nlohmann::json::parse(statsJson(*session_, frame));
	Judgment found = about(one.figures(), false);
	if (!tolerances)
		return fail(std::move(found), tolerances.error());
	std::string update;
	if (one.has_figures)
	{
		Result<nlohmann::json> expected = readFigures(one.figures());
		if (!expected)
			return fail(std::move(found), expected.error());
		found.moved = movedFigures(*expected, figures, *tolerances);
		found.detail = found.moved.empty() ? "" : text(found.moved);
		if (found.moved.empty())
			return tell(std::move(found));
		update = updatedFigures(std::move(*expected), figures);
	}
	else
	{
		found.detail = "was missing";
		update = newFigures(figures);
	}
	found.verdict = options_.updates ? Verdict::updated : Verdict::differs;
	if (Status written = options_.updates ? writeText(update, found.file) : Nothing{}; !written)
		return fail(std::move(found), written.error());
	tell(std::move(found));
}

Judgment Verifier::about(const std::string& file, bool on_device)
{
	Judgment found{.file = file, .detail = {}};
	found.device = "cpu";
	if (session_ && session_->device() && (on_device || session_->cutter().usesGpu()))
	{
		found.device = session_->device()->name();
		found.driver = gpu::driverName(*session_->device());
	}
	return found;
}

void Verifier::tell(Judgment judgment)
{
	const double now = secondsNow();
	judgment.seconds = now - started_;
	started_ = now;
	tell_(std::move(judgment));
}

void Verifier::fail(Judgment judgment, const Error& error)
{
	judgment.verdict = Verdict::failed;
	judgment.detail = error.message;
	judgment.error = error;
	tell(std::move(judgment));
	if (error.kind == ErrorKind::device && session_ && session_->device())
	{
		// A lost device draws no more; the next case opens another.
		forget();
		renderer_.reset();
		device_.reset();
	}
}

} // namespace vp::app
