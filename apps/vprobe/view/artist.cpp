#include "view/artist.h"

#include "make_probe.h"
#include "render/targets.h"
#include "time_steps.h"
#include "view/view_state.h"
#include "write/slice_file.h"

#include <algorithm>
#include <new>
#include <utility>

namespace vp::app
{

namespace
{

// While the hand moves, pictures have one sample a pixel; the others are added once it has been still for so long.
constexpr std::chrono::milliseconds kStill{120};
// For a trace: some minute of dragging, 5 MiB.
constexpr std::size_t kKeptSections = 50'000;

double millisecondsSince(Moment start)
{
	return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Whether two cuts differ in no more than where their probes are.
bool differInPlace(ProbeOptions a, const ProbeOptions& b)
{
	takePlace(a, b);
	return a == b;
}

// The painter draws lines around windows by these.
bool haveSameRims(const ProbeOptions& a, const ProbeOptions& b)
{
	return a.probe == b.probe && a.window == b.window;
}

ProbeOptions withoutTime(ProbeOptions options)
{
	options.time.clear();
	return options;
}

} // namespace

Artist::Artist(std::shared_ptr<gpu::Device> device, std::function<void()> wake)
    : device_(std::move(device)), wake_(std::move(wake)), thread_(
                                                              [this]
                                                              {
	                                                              nameThreadRow("artist");
	                                                              work();
                                                              })
{
}

Artist::~Artist()
{
	{
		const std::lock_guard lock(mutex_);
		ends_ = true;
	}
	changed_.notify_all();
	thread_.join();
}

void Artist::ask(Wish wish)
{
	{
		const std::lock_guard lock(mutex_);
		if (wish_)
			wish.since = std::min(wish.since, wish_->since); // its input is answered by this one's picture
		wish_ = std::move(wish);
	}
	changed_.notify_all();
}

void Artist::replaceSession(std::unique_ptr<Session> session)
{
	const std::lock_guard lock(mutex_);
	next_session_ = std::move(session);
	wish_.reset();
}

std::shared_ptr<const Shown> Artist::shown() const
{
	const std::lock_guard lock(mutex_);
	return shown_;
}

std::optional<Error> Artist::takeError()
{
	const std::lock_guard lock(mutex_);
	return std::exchange(error_, std::nullopt);
}

bool Artist::isIdle() const
{
	const std::lock_guard lock(mutex_);
	return !wish_ && orders_.empty() && !busy_ && !rough_;
}

void Artist::order(Order order)
{
	{
		const std::lock_guard lock(mutex_);
		orders_.push_back(std::move(order));
	}
	changed_.notify_all();
}

bool Artist::waits() const
{
	const std::lock_guard lock(mutex_);
	return wish_ || ends_;
}

void Artist::work()
{
	std::unique_lock lock(mutex_);
	const auto woken = [this] { return wish_ || !orders_.empty() || ends_; };
	for (;;)
	{
		const bool still = rough_ ? !changed_.wait_for(lock, kStill, woken) : (changed_.wait(lock, woken), false);
		if (ends_)
			return;
		std::optional<Wish> wish = still ? std::optional(shown_->wish) : std::exchange(wish_, std::nullopt);
		std::optional<Order> order;
		if (!orders_.empty())
		{
			order = std::move(orders_.front());
			orders_.pop_front();
		}
		std::unique_ptr<Session> session = std::move(next_session_);
		busy_ = true;
		lock.unlock();
		if (session)
			install(std::move(session));
		if (wish)
			answer(*wish, still);
		if (order)
			answer(*order);
		wake_();
		lock.lock();
		keepSections();
		busy_ = false;
	}
}

// The mutex is held.
void Artist::keepSections()
{
	if (!session_)
		return;
	for (Timeline::Section& section : session_->timeline->takeSections())
		sections_.push_back(std::move(section));
	while (sections_.size() > kKeptSections)
		sections_.pop_front();
}

std::vector<Timeline::Section> Artist::sections() const
{
	const std::lock_guard lock(mutex_);
	return {sections_.begin(), sections_.end()};
}

void Artist::install(std::unique_ptr<Session> session)
{
	painter_.reset();
	cut_.reset();
	followed_.reset();
	rough_ = false;
	session_ = std::move(session);
}

// Of what works with all that memory has.
template <class Work>
auto Artist::tried(const Work& work) -> decltype(work())
{
	if (!session_)
		return Error{ExitCode::input, "nothing is shown yet; open a file first"};
	try
	{
		return work();
	}
	catch (const std::bad_alloc&)
	{
		return Error{ExitCode::output, "out of memory; show fewer sheets or a smaller input"};
	}
}

void Artist::answer(const Wish& wish, bool smooth)
{
	const Status done = tried([&] { return show(wish, smooth); });
	if (done)
		return;
	const std::lock_guard lock(mutex_);
	error_ = done.error();
}

void Artist::answer(Order& order)
{
	if (auto* picture = std::get_if<PictureOrder>(&order))
		return picture->take(tried([&] { return this->picture(*picture); }));
	auto& slice = std::get<SliceOrder>(order);
	slice.done(tried([&] { return writeSlice(slice); }));
}

Result<render::Picture> Artist::picture(const PictureOrder& order)
{
	if (Status followed = follow(order.wish); !followed)
		return followed.error();
	if (Result<double> cut = cutAsWished(); !cut)
		return cut.error();
	return order.empty ? painter_->drawEmpty(cut_->slice, cut_->sheets) : painter_->draw(cut_->slice, cut_->sheets);
}

Status Artist::writeSlice(const SliceOrder& order)
{
	if (Status followed = follow(order.wish); !followed)
		return followed;
	if (Result<double> cut = cutAsWished(); !cut)
		return cut.error();
	return write::writeSlice(session_->blocks, exportedMeshes(cut_->sheets), order.file);
}

Status Artist::show(const Wish& wish, bool smooth)
{
	if (smooth)
		return refine();
	Shown shown;
	shown.wish = wish;
	if (Status followed = follow(wish); !followed)
		return followed;
	Result<probe::Probe> probe = makeProbe(wish.probe, session_->blocks.bounds());
	if (!probe)
		return probe.error();
	shown.probe = std::move(*probe);
	Result<double> cut_ms = cutAsWished();
	if (!cut_ms)
		return cut_ms.error();
	shown.cut_ms = *cut_ms;
	shown.cut = cut_;
	shown.cuts = cuts_;
	shown.empty = std::ranges::all_of(cut_->slice.sheets, isEmpty);
	shown.memory = session_->slicer->memory();
	if (const auto before = this->shown(); before && before->cut == cut_)
		shown.lookups = before->lookups;
	Result<bool> drawn = draw(shown, false);
	if (!drawn)
		return drawn.error();
	publish(std::move(shown));
	rough_ = true;
	return Nothing{};
}

Status Artist::refine()
{
	rough_ = false;
	const Wish wish = shown()->wish;
	// An order may have led session and painter elsewhere.
	if (!followed_ || !(followed_->probe == wish.probe && followed_->look == wish.look))
		return show(wish, false);
	addLookups();
	Shown shown = *this->shown();
	if (shown.smooth || waits())
		return Nothing{};
	Result<bool> drawn = draw(shown, true);
	if (!drawn)
		return drawn.error();
	if (*drawn)
		publish(std::move(shown));
	return Nothing{};
}

void Artist::addLookups()
{
	Shown shown = *this->shown();
	if (shown.lookups)
		return;
	const bool by_generation = shown.wish.look.color_by == "generation";
	shown.lookups = std::make_shared<const SheetLookups>(*session_, shown.cut, by_generation);
	publish(std::move(shown));
	wake_();
}

Status Artist::follow(const Wish& wish)
{
	Status done = followAll(wish);
	if (!done)
		followed_.reset(); // some of it may have been done
	return done;
}

// Session and painter, as the wish has them. What has not changed is left as it is.
Status Artist::followAll(const Wish& wish)
{
	if (!followed_ || followed_->probe.time != wish.probe.time)
		if (Status moved = followTime(wish.probe); !moved)
			return moved;
	if (!followed_ || !(withoutTime(followed_->probe) == withoutTime(wish.probe)))
	{
		if (Status chosen = choose(*session_, wish.probe); !chosen)
			return chosen;
		only_moved_ = followed_ && differInPlace(followed_->probe, wish.probe);
		cut_is_old_ = true;
	}
	if (!followed_ || !(followed_->look == wish.look) || !haveSameRims(followed_->probe, wish.probe))
		if (Status looked = followLook(wish); !looked)
			return looked;
	followed_ = wish;
	return Nothing{};
}

Status Artist::followTime(const ProbeOptions& options)
{
	if (!followed_)
		return Nothing{}; // the session was opened at this time
	Result<read::TimeChoice> time = read::parseTime(options.time);
	if (!time)
		return time.error();
	cut_is_old_ = true;
	only_moved_ = false;
	cut_.reset();
	Result<bool> moved = moveToTime(*session_, options, *time, painter_ ? &*painter_ : nullptr);
	return moved ? Status(Nothing{}) : moved.error();
}

Status Artist::followLook(const Wish& wish)
{
	Result<LookChoice> look = parseLook(wish.look, wish.probe.inputs);
	if (!look)
		return look.error();
	const auto finder = look->by_generation           ? slice::Finder::traversal
	                    : session_->slicer->usesGpu() ? slice::Finder::direct
	                                                  : slice::Finder::automatic;
	if (finder != session_->finder)
	{
		session_->finder = finder;
		cut_is_old_ = true;
		only_moved_ = false;
	}
	if (look->range_of_slice && !session_->range_of_slice)
	{
		cut_is_old_ = true; // what it shows was not measured
		only_moved_ = false;
	}
	session_->range_of_slice = look->range_of_slice;
	if (painter_)
		return painter_->setLook(wish.probe, std::move(*look));
	Result<Painter> painter = Painter::create(*session_, wish.probe, std::move(*look));
	if (!painter)
		return painter.error();
	painter_.emplace(std::move(*painter));
	return Nothing{};
}

Result<double> Artist::cutAsWished()
{
	if (cut_ && !cut_is_old_)
		return 0.0;
	const Moment start = std::chrono::steady_clock::now();
	std::shared_ptr<const CutFrame> last = only_moved_ ? cut_ : nullptr;
	Result<slice::Slice> slice =
	    cut(*session_, last ? std::shared_ptr<const slice::Slice>(last, &last->slice) : nullptr);
	if (!slice)
		return slice.error();
	auto made = std::make_shared<CutFrame>();
	made->slice = std::move(*slice);
	made->sheets = statsSince(*session_, made->slice, last.get(), false);
	cut_ = std::move(made);
	cut_is_old_ = false;
	++cuts_;
	return millisecondsSince(start);
}

// False where a new wish came meanwhile.
Result<bool> Artist::draw(Shown& shown, bool smooth)
{
	const Moment start = std::chrono::steady_clock::now();
	Result<render::Scene> scene = painter_->sceneOf(shown.cut->slice, shown.cut->sheets);
	if (!scene)
		return scene.error();
	shown.smooth = smooth || scene->look.samples == 1;
	if (!smooth)
		scene->look.samples = 1;
	Result<std::shared_ptr<gpu::Image>> image = pictures_.take(*device_, {scene->look.width, scene->look.height});
	if (!image)
		return image.error();
	Result<bool> drawn = painter_->renderer().drawInto(
	    *scene, **image, [&] { return !smooth || !waits(); }, session_->timeline.get());
	if (!drawn || !*drawn)
		return drawn;
	shown.image = *image;
	shown.camera = scene->camera;
	shown.frame = render::pictureFrame(*scene);
	shown.values = scene->values;
	if (Status pane = drawPane(shown, *scene); !pane)
		return pane.error();
	shown.draw_ms = millisecondsSince(start);
	return true;
}

void Artist::publish(Shown shown)
{
	auto made = std::make_shared<const Shown>(std::move(shown));
	const std::lock_guard lock(mutex_);
	shown_ = std::move(made);
	error_.reset();
}

} // namespace vp::app
