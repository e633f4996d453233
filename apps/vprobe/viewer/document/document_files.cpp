#include "render/color/color_map_file.h"
#include "render/color/preset_text.h"
#include "view/state_file.h"
#include "viewer/document/document.h"
#include "viewer/document/mail.h"
#include "write/atomic_file.h"
#include "write/png.h"
#include "write/slice_file.h"
#include "write/trace_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace vp::app
{

namespace
{

constexpr std::chrono::seconds kRecoveryPause{2};

} // namespace

void Document::open(std::vector<std::string> inputs)
{
	if (inputs.size() == 1 && inputs[0].ends_with(".json"))
	{
		Result<view::ViewSpec> read = read_state_(inputs[0]);
		if (!read)
			return notify(read.error());
		state_file_ = inputs[0];
		return load(std::move(*read));
	}
	// Settings that belong to the old data are reset: places, arrays, times. Other settings of the look stay.
	view::ViewSpec next = state();
	next.probe = {};
	next.input = {};
	next.input.files = std::move(inputs);
	next.look.camera = {};
	next.look.range.reset();
	next.look.title.reset();
	load(std::move(next));
}

void Document::load(view::ViewSpec next)
{
	loader_.begin(next);
	loading_ = std::move(next);
	loads_own_data_ = false;
}

void Document::reload()
{
	if (facts_)
		load(state());
}

void Document::cancelLoading()
{
	loader_.cancel();
	loading_.reset();
	notify("Loading was cancelled");
}

void Document::takeLoaded()
{
	std::optional<Loader::Loaded> loaded = loader_.take();
	if (!loaded)
		return;
	view::ViewSpec next = std::move(*loading_);
	loading_.reset();
	if (!loaded->session)
		return notify(loaded->session.error());
	std::unique_ptr<session::Session> session = std::move(*loaded->session);
	const bool again = facts_ && facts_->inputs == next.input.files;
	facts_ = factsOf(*session, next.input.files);
	watcher_.watch(next.input.files);
	times_.setInputs(next.input.files);
	// Data that were read again keep the current state.
	if (again)
		notify(fmt::format("{} was read again", fmt::join(next.input.files, ", ")));
	else if (!loads_own_data_) // own data belong to the first state, or to one whose device was lost: its history
	                           // continues
		history_ = interact::History<view::ViewSpec>(std::move(next));
	sheet_ = 0;
	playback_.forgetFilm();
	for (const std::string& input : facts_->inputs)
		remember(settings, input);
	render_thread_.replaceSession(std::move(session));
	stateChanged();
}

void Document::saveState(const std::string& file)
{
	view::ViewSpec kept = state();
	if (asked_size_.width > 0)
		kept.look.size = {asked_size_.width, asked_size_.height};
	if (Status written = view::saveState(kept, file); !written)
		return notify(written.error());
	state_file_ = file;
	notify(fmt::format("Saved {}", file));
}

void Document::savePicture(const std::string& file, std::uint32_t width, std::uint32_t height)
{
	PictureRequest like = pictureRequest();
	like.spec.look.size = {width, height};
	mail_->expect(file);
	render_thread_.order(PictureJob{like, false,
	                                [file, mail = mail_](Result<render::Picture> picture)
	                                {
		                                const Status written =
		                                    picture ? write::writePng(*picture, file) : picture.error();
		                                mail->leave(file, noticeOf(written, fmt::format("Saved {}", file)));
	                                }});
}

void Document::saveSlice(const std::string& file)
{
	if (Result<write::SliceFormat> format = write::sliceFormatOf(file); !format)
		return notify(format.error());
	mail_->expect(file);
	render_thread_.order(CutJob{pictureRequest(), file, [file, mail = mail_](const Status& written) {
		                            mail->leave(file, noticeOf(written, fmt::format("Saved {}", file)));
	                            }});
}

void Document::saveTrace(const std::string& file)
{
	jobs_.run(file,
	          [file, &times = times_]
	          {
		          Result<write::TraceFile> trace = write::TraceFile::create(file);
		          if (!trace)
			          return noticeOf(trace.error(), {});
		          times.tell(*trace);
		          return noticeOf(trace->commit(), fmt::format("Saved {}", file));
	          });
}

std::string Document::colorMapName() const
{
	if (!state().look.colormap.empty())
		return state().look.colormap;
	return shown_ ? shown_->colormap : "viridis";
}

void Document::saveColorMap(const std::string& file)
{
	Result<render::ColorMap> map = render::chooseColorMap(colorMapName());
	if (!map)
		return notify(map.error());
	const render::OpacityPoints points = render::opacityPoints(state().look.opacity_points);
	render::ColorMap edited = render::withOpacity(std::move(*map), points);
	edited.name = std::filesystem::path(file).stem().string();
	jobs_.run(file,
	          [file, text = render::presetText(edited, points)]
	          {
		          Result<write::AtomicFile> written = write::AtomicFile::create(file);
		          if (!written)
			          return noticeOf(written.error(), {});
		          written->write(text);
		          return noticeOf(written->commit(), fmt::format("Saved {}", file));
	          });
}

void Document::takeWritten()
{
	std::vector<Notice> notices = jobs_.takeDone();
	{
		const std::lock_guard lock(mail_->mutex);
		std::ranges::move(mail_->take(), std::back_inserter(notices));
	}
	for (const Notice& notice : notices)
	{
		notify(notice.words, notice.is_error);
		if (quits_ && notice.is_error)
			failures_.push_back(notice.words);
	}
}

std::vector<std::string> Document::filesUnderWay() const
{
	std::vector<std::string> files = jobs_.files();
	const std::lock_guard lock(mail_->mutex);
	files.insert(files.end(), mail_->files.begin(), mail_->files.end());
	return files;
}

void Document::keepState()
{
	keeps_state_ = facts_ && !recovery_file_.empty() && view::saveState(state(), recovery_file_);
}

interact::History<view::ViewSpec> Document::historyToKeep() const
{
	interact::History<view::ViewSpec> kept = history_;
	if (loading_ && !loads_own_data_)
		kept.commit(*loading_, "Open");
	return kept;
}

// Saves the state every few seconds if anything changed, since a crash would lose it.
void Document::keepForRecovery()
{
	const Moment now = std::chrono::steady_clock::now();
	if (recovery_file_.empty() || !facts_ || recovery_version_ == version_ || now - recovery_time_ < kRecoveryPause)
		return;
	recovery_time_ = now;
	recovery_version_ = version_;
	if (Status kept = view::saveState(state(), recovery_file_); kept)
		return;
	notify("This window's state cannot be kept for recovery: there is no room in its folder", true);
	recovery_file_.clear();
}

void Document::recover(bool wanted)
{
	question = Question::none;
	const std::vector<std::string> left = leftRecoveryFiles();
	if (wanted && !left.empty())
	{
		Result<view::ViewSpec> read = read_state_(left.front());
		if (read)
			load(std::move(*read));
		else
			notify(read.error());
	}
	for (const std::string& file : left)
	{
		std::error_code ignored;
		std::filesystem::remove(file, ignored);
	}
}

void Document::watchFiles()
{
	if (!watches || loader_.isBusy() || !watcher_.changed(std::chrono::steady_clock::now()))
		return;
	notify("The input was written anew; reading it again");
	reload();
}

} // namespace vp::app
