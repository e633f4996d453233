#include "viewer/cutting/render_thread.h"

#include "base/frame_scope.h"
#include "render/passes/targets.h"
#include "view/resolve.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace vp::app
{

namespace
{

// While the hand moves, pictures have one sample a pixel; the others are added once it has been still for so long.
constexpr std::chrono::milliseconds kStill{120};
constexpr std::string_view kFrameSection = "frame";

// A coarser level takes no more, since it is in memory beside the parts of the finest one.
constexpr std::uint64_t kDraftBytes = std::uint64_t(256) << 20;

// Returns the size of the arrays that stay in their files.
std::uint64_t bytesInFiles(const grid::BlockSet& blocks)
{
	std::uint64_t bytes = 0;
	for (const grid::Block& block : blocks.blocks)
		for (const grid::Field& field : block.fields)
			bytes += field.stored ? field.stored->layout().byteCount() : 0;
	return bytes;
}

} // namespace

RenderThread::RenderThread(std::shared_ptr<gpu::Device> device, std::function<void()> wake, WindowTimes& times)
    : device_(std::move(device)), wake_(std::move(wake)), times_(times), draft_loader_(
                                                                             device_, [] {}, times.keep()),
      thread_(
          [this]
          {
	          nameThreadRow("render");
	          work();
          })
{
}

RenderThread::~RenderThread()
{
	{
		const std::lock_guard lock(mutex_);
		ends_ = true;
		next_wish_.request_stop();
	}
	changed_.notify_all();
	thread_.join();
}

void RenderThread::ask(PictureRequest wish)
{
	{
		const std::lock_guard lock(mutex_);
		if (wish_)
			wish.since = std::min(wish.since, wish_->since); // its input is answered by this one's picture
		wish_ = std::move(wish);
		next_wish_.request_stop();
	}
	changed_.notify_all();
}

void RenderThread::replaceSession(std::unique_ptr<session::Session> session)
{
	const std::lock_guard lock(mutex_);
	next_session_ = std::move(session);
	wish_.reset();
}

std::shared_ptr<const PresentedFrame> RenderThread::shown() const
{
	const std::lock_guard lock(mutex_);
	return shown_;
}

std::optional<Error> RenderThread::takeError()
{
	const std::lock_guard lock(mutex_);
	return std::exchange(error_, std::nullopt);
}

bool RenderThread::isBusy() const
{
	const std::lock_guard lock(mutex_);
	return wish_ || busy_;
}

bool RenderThread::isIdle() const
{
	const std::lock_guard lock(mutex_);
	return !wish_ && orders_.empty() && !busy_ && !rough_;
}

void RenderThread::order(Job order)
{
	{
		const std::lock_guard lock(mutex_);
		orders_.push_back(std::move(order));
	}
	changed_.notify_all();
}

bool RenderThread::waits() const
{
	const std::lock_guard lock(mutex_);
	return wish_ || ends_;
}

void RenderThread::work()
{
	std::unique_lock lock(mutex_);
	const auto woken = [this] { return wish_ || !orders_.empty() || ends_; };
	for (;;)
	{
		const bool still = rough_ ? !changed_.wait_for(lock, kStill, woken) : (changed_.wait(lock, woken), false);
		if (ends_)
			return;
		std::optional<PictureRequest> wish = still ? std::optional(shown_->wish) : std::exchange(wish_, std::nullopt);
		std::optional<Job> order;
		if (!orders_.empty())
		{
			order = std::move(orders_.front());
			orders_.pop_front();
		}
		std::unique_ptr<session::Session> session = std::move(next_session_);
		busy_ = true;
		lock.unlock();
		if (session)
			install(std::move(session));
		if (wish)
			answer(*wish, still);
		if (order)
			answer(*order);
		keepTimes();
		wake_();
		lock.lock();
		busy_ = false;
	}
}

void RenderThread::keepTimes()
{
	if (!at_->session)
		return;
	std::vector<Timeline::Section> sections = times_.take(*at_->session->timeline(), at_->start_ms);
	const auto is_frame = [row = threadRow()](const Timeline::Section& section)
	{ return section.row == row && section.name == kFrameSection; };
	const auto frame = std::ranges::find_if(sections, is_frame);
	if (frame == sections.end())
		return;
	// The rest is what came before: reading, jobs, and samples of the picture before.
	const auto is_elsewhere = [frame = *frame](const Timeline::Section& section)
	{
		return section.track != Timeline::Track::gpu &&
		       (section.row != frame.row || section.start_ms < frame.start_ms ||
		        section.start_ms > frame.start_ms + frame.duration_ms);
	};
	std::erase_if(sections, is_elsewhere);
	times_.addFrame(stageTimes(std::move(sections)));
}

void RenderThread::Level::take(std::unique_ptr<session::Session> other, WindowTimes& times)
{
	painter.reset();
	cut.reset();
	cut_for.reset();
	grown = {};
	followed.reset();
	session = std::move(other);
	start_ms = session ? times.startOf(*session->timeline()) : 0.0;
}

void RenderThread::install(std::unique_ptr<session::Session> session)
{
	at_ = &finest_;
	rough_ = false;
	neighbors_.drop();
	draft_loader_.cancel();
	draft_.take(nullptr, times_);
	backdrop_ = {};
	finest_.take(std::move(session), times_);
	beginDraft();
}

void RenderThread::beginDraft()
{
	const grid::BlockSet& blocks = finest_.session->blocks();
	view::ViewSpec spec = finest_.session->spec();
	const std::uint64_t room = std::min(kDraftBytes, session::memoryForParts(spec) / 4);
	std::uint64_t bytes = bytesInFiles(blocks);
	// Levels commonly halve each side.
	for (; bytes > room && spec.input.level + 1 < static_cast<int>(blocks.levels); bytes /= 8)
		++spec.input.level;
	if (bytes > 0 && bytes <= room)
		draft_loader_.begin(std::move(spec));
}

bool RenderThread::wantsDraft(const PictureRequest& wish)
{
	// Where it cannot be opened there is none.
	if (std::optional<Loader::Loaded> loaded = draft_loader_.take(); loaded && loaded->session)
	{
		draft_.take(std::move(*loaded->session), times_);
		draft_.followed = PictureRequest{.spec = std::move(loaded->spec)};
		draft_.number = draft_.followed->spec.input.level;
	}
	if (!draft_.session || !finest_.cut || !finest_.cut_for)
		return false;
	const view::ViewSpec& had = finest_.cut_for->spec;
	return !(had.probe == wish.spec.probe) || !(had.input.time == wish.spec.input.time);
}

std::stop_token RenderThread::stopByNextWish()
{
	const auto before = shown();
	if (at_ == &draft_ || !before || !before->draft)
		return {};
	const std::lock_guard lock(mutex_);
	next_wish_ = {};
	if (wish_ || ends_)
		next_wish_.request_stop();
	return next_wish_.get_token();
}

void RenderThread::answer(const PictureRequest& wish, bool smooth)
{
	const Status done = tried([&] { return show(wish, smooth); });
	if (done || done.error().kind == ErrorKind::cancelled)
		return;
	const std::lock_guard lock(mutex_);
	error_ = done.error();
}

Status RenderThread::show(const PictureRequest& wish, bool smooth)
{
	if (smooth)
		return refine();
	if (wantsDraft(wish))
	{
		at_ = &draft_;
		if (show(wish))
			return Nothing{};
	}
	at_ = &finest_;
	return show(wish);
}

Status RenderThread::show(const PictureRequest& wish)
{
	const FrameScope scope(++frames_, FrameScope::Stop::picture);
	const TimedSection section(at_->session->timeline(), kFrameSection);
	PresentedFrame shown;
	shown.number = frames_;
	shown.wish = wish;
	shown.probe = view::makeProbe(wish.spec.probe, finest_.session->blocks().bounds());
	PictureRequest own = wish; // as the level has it
	if (at_ == &draft_)
	{
		shown.draft = draft_.number;
		own.spec.input.level = draft_.number;
		// The bounds of a coarser level are others, and so are their centers.
		if (!own.spec.probe.origin && !own.spec.probe.own)
			own.spec.probe.origin = shown.probe.frame.origin;
	}
	if (Status followed = follow(own); !followed)
		return followed;
	Result<double> cut_ms = cutAsWished(stopByNextWish());
	if (!cut_ms)
		return cut_ms.error();
	shown.cut_ms = *cut_ms;
	if (Status grown = growAsWished(own); !grown)
		return grown;
	shown.cut = at_->cut;
	shown.cuts = cuts_;
	shown.empty = std::ranges::all_of(at_->cut->slice.sheets, session::isEmpty);
	shown.memory = at_->session->cutter().memory();
	shown.vector_dt = at_->session->view().launch ? at_->session->launch().dt : 0.0;
	if (const auto before = this->shown(); before && before->cut == at_->cut)
		shown.lookups = before->lookups;
	Result<bool> drawn = draw(shown, false);
	if (!drawn)
		return drawn.error();
	publish(std::move(shown));
	rough_ = true;
	// The picture is there; now comes what makes a moved cut fast.
	if (const grid::BlockSet& blocks = at_->session->blocks();
	    !grid::hasNeighbors(blocks) && !grid::lacksParts(blocks)) // parts are read as they are cut
		neighbors_.begin(blocks);
	return Nothing{};
}

Status RenderThread::refine()
{
	rough_ = false;
	const PictureRequest wish = shown()->wish;
	at_ = &finest_;
	if (shown()->draft)
		return show(wish);
	// An order may have led session and painter elsewhere.
	if (!at_->followed || !(at_->followed->spec == wish.spec) || at_->grown.cut != at_->cut ||
	    !(at_->grown.pointed == wish.contour))
		return show(wish);
	addLookups();
	PresentedFrame shown = *this->shown();
	if (shown.smooth || waits())
		return Nothing{};
	const FrameScope scope(shown.number, FrameScope::Stop::picture);
	Result<bool> drawn = draw(shown, true);
	if (!drawn)
		return drawn.error();
	if (*drawn)
		publish(std::move(shown));
	return Nothing{};
}

void RenderThread::addLookups()
{
	PresentedFrame shown = *this->shown();
	if (shown.lookups)
		return;
	const bool by_generation = shown.wish.spec.look.color_by == view::ColorBy::generation;
	shown.lookups = std::make_shared<const SheetLookups>(*at_->session, shown.cut, by_generation);
	publish(std::move(shown));
	wake_();
}

// False where a new wish came meanwhile.
Result<bool> RenderThread::draw(PresentedFrame& shown, bool smooth)
{
	const Moment start = std::chrono::steady_clock::now();
	const TimedSection section(at_->session->timeline(), "render");
	FrameScope::comesTo(FrameScope::Stop::picture, at_->session->timeline());
	Result<render::Scene> scene = at_->painter->sceneOf(shown.cut->slice, shown.cut->sheets, at_->grown.contours);
	if (!scene)
		return scene.error();
	if (shown.draft)
		backdrop_.putInto(*scene, shown.wish.spec);
	else
		backdrop_ = Backdrop(*scene, shown.wish.spec);
	shown.smooth = smooth || scene->look.samples == 1;
	if (!smooth)
		scene->look.samples = 1;
	Result<std::shared_ptr<gpu::Image>> image = pictures_.take(*device_, {scene->look.width, scene->look.height});
	if (!image)
		return image.error();
	Result<bool> drawn = at_->painter->renderer().drawInto(
	    *scene, **image, [&] { return !smooth || !waits(); }, at_->session->timeline());
	if (!drawn || !*drawn)
		return drawn;
	shown.image = *image;
	shown.camera = scene->camera;
	shown.frame = render::pictureFrame(*scene);
	shown.values = scene->values;
	shown.colormap = scene->look.colors.name;
	if (Status pane = drawPane(shown, *scene); !pane)
		return pane.error();
	shown.draw_ms = millisecondsSince(start);
	return true;
}

void RenderThread::publish(PresentedFrame shown)
{
	auto made = std::make_shared<const PresentedFrame>(std::move(shown));
	const std::lock_guard lock(mutex_);
	shown_ = std::move(made);
	error_.reset();
}

} // namespace vp::app
