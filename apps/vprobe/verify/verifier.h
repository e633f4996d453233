#pragma once

#include "picture/painter.h"
#include "session/frame.h"
#include "session/session.h"
#include "verify/cases.h"
#include "verify/verdict.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vp::app
{

struct VerifyOptions
{
	bool updates = false;        // write what is missing, or not as expected
	bool keeps_pictures = false; // in the judgments, for a report
};

// Judges cases one after the other, with one device. The cases of one input share a session, which reads it once.
class Verifier
{
public:
	using Tell = std::function<void(Judgment)>;

	Verifier(VerifyOptions options, Tell tell) : options_(options), tell_(std::move(tell)) {}

	void judge(std::span<const VerifyCase> cases);

private:
	void judgeGroup(std::span<const VerifyCase> group);
	Status prepare(const VerifyCase& one, bool draws, bool reads_all_arrays);
	Status open(const VerifyCase& one, bool draws, bool reads_all_arrays);
	Status needDevice();
	void judgeCase(const VerifyCase& one, bool reads_all_arrays);
	void judgePicture(const VerifyCase& one, const session::Frame& frame, const picture::PictureTolerance& tolerance);
	void judgeSweep(const VerifyCase& one, const picture::PictureTolerance& tolerance);
	void judgeFlat(const VerifyCase& one, const session::Frame& frame, const picture::PictureTolerance& tolerance);
	void judgeFigures(const VerifyCase& one, const session::Frame& frame, const Result<Tolerances>& tolerances);
	Status preparePainter(const VerifyCase& one);
	Result<render::Picture> draw(const VerifyCase& one, const session::Frame& frame);
	void compare(Judgment found, const render::Picture& drawn, const picture::PictureTolerance& tolerance);
	Judgment about(const std::string& file, bool on_device);
	void tell(Judgment judgment);
	void fail(Judgment judgment, const Error& error);
	void forget();

	VerifyOptions options_;
	Tell tell_;
	std::shared_ptr<gpu::Device> device_;
	std::optional<render::Renderer> renderer_; // that of the last session, whose pipelines are compiled
	std::optional<Error> no_device_;           // why there is none to draw with
	std::unique_ptr<session::Session> session_;
	std::optional<picture::Painter> painter_;
	double started_ = 0.0; // seconds of the steady clock, when the work for the next judgment began
};

} // namespace vp::app
