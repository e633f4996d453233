#include "interact/camera_moves.h"
#include "interact/nudge.h"
#include "interact/placing.h"
#include "view/workbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr double kTurnDegrees = 5.0;
constexpr double kWindowFactor = 1.1;
constexpr int kLines = 10;

std::string label(Action action)
{
	return std::string(interact::wordsOf(action));
}

template <std::size_t Count>
std::string after(const std::string& word, const std::array<const char*, Count>& words)
{
	const auto found = std::ranges::find(words, word);
	return found == words.end() || found + 1 == words.end() ? words.front() : *(found + 1);
}

} // namespace

void Workbench::perform(Action action)
{
	for (const auto part : {&Workbench::performOnWindow, &Workbench::performOnSweep, &Workbench::performOnSheets,
	                        &Workbench::performOnProbe, &Workbench::performOnView, &Workbench::performOnLook})
		if ((this->*part)(action))
			return;
}

bool Workbench::performOnWindow(Action action)
{
	const auto toggle = [](bool& part) { return part = !part, true; };
	const auto ask = [this](Question asked) { return question = asked, true; };
	switch (action)
	{
	case Action::open:
		return ask(Question::open);
	case Action::save_state:
		return state_file_.empty() ? ask(Question::save_state) : (saveState(state_file_), true);
	case Action::save_state_as:
		return ask(Question::save_state);
	case Action::save_picture:
		return ask(Question::save_picture);
	case Action::save_film:
		return ask(Question::save_film);
	case Action::save_slice:
		return ask(Question::save_slice);
	case Action::cancel:
		if (loader_.isBusy())
			cancelLoading();
		parts.help = false;
		return false; // the sweep has something to cancel too
	case Action::undo:
		if (history_.canUndo())
			notify(fmt::format("Undone: {}", history_.undoLabel()));
		if (history_.undo())
			stateChanged();
		return true;
	case Action::redo:
		if (history_.canRedo())
			notify(fmt::format("Done again: {}", history_.redoLabel()));
		if (history_.redo())
			stateChanged();
		return true;
	case Action::quit:
		quit();
		return true;
	case Action::dark_theme:
		return toggle(settings.dark);
	case Action::handles:
		return toggle(parts.handles);
	case Action::plane_pane:
		return toggle(parts.plane_pane);
	case Action::panels:
		return toggle(parts.panels);
	case Action::profile_overlay:
		return toggle(parts.profile);
	case Action::full_screen:
		return toggle(parts.full_screen);
	case Action::sheet_alone:
		return toggle(parts.own);
	case Action::magnifier:
		return toggle(parts.magnifier);
	case Action::help:
		return toggle(parts.help);
	default:
		return false;
	}
}

bool Workbench::performOnProbe(Action action)
{
	const probe::Probe now = probe();
	if (!facts_ || now.sheets.empty())
		return false;
	const auto set = [&](const probe::Probe& next) { return setProbe(label(action), next), true; };
	const auto push = [&](double steps, bool fine)
	{ return set(interact::pushed(now, sheet_, steps, facts_->bounds, fine)); };
	const auto turn = [&](const Vec3& axis, double degrees)
	{ return set(interact::turned(now, std::nullopt, axis, degrees)); };
	const auto face = [&](const Vec3& normal) { return set(interact::withNormal(now, std::nullopt, normal)); };
	const auto scale = [&](double factor)
	{ return set(interact::withWindowScaled(now, sheet_, factor, facts_->bounds)); };
	switch (action)
	{
	case Action::push_forward:
		return push(1.0, false);
	case Action::push_back:
		return push(-1.0, false);
	case Action::push_forward_fine:
		return push(1.0, true);
	case Action::push_back_fine:
		return push(-1.0, true);
	case Action::turn_x_plus:
		return turn(now.frame.xAxis(), kTurnDegrees);
	case Action::turn_x_minus:
		return turn(now.frame.xAxis(), -kTurnDegrees);
	case Action::turn_up_plus:
		return turn(now.frame.up, kTurnDegrees);
	case Action::turn_up_minus:
		return turn(now.frame.up, -kTurnDegrees);
	case Action::turn_normal_plus:
		return turn(now.frame.normal, kTurnDegrees);
	case Action::turn_normal_minus:
		return turn(now.frame.normal, -kTurnDegrees);
	case Action::window_bigger:
		return scale(kWindowFactor);
	case Action::window_smaller:
		return scale(1.0 / kWindowFactor);
	case Action::normal_x:
		return face({1.0, 0.0, 0.0});
	case Action::normal_y:
		return face({0.0, 1.0, 0.0});
	case Action::normal_z:
		return face({0.0, 0.0, 1.0});
	case Action::normal_to_camera:
		return !shown_ || set(interact::withNormalToCamera(now, std::nullopt, shown_->camera));
	case Action::snap_normal:
		return set(interact::withNormalSnapped(now, std::nullopt));
	case Action::reset_place:
		return set(interact::resetPlace(now, facts_->bounds));
	case Action::reset_magnifier:
		return set(interact::withoutMagnifier(now, sheet_));
	default:
		return false;
	}
}

void Workbench::setPreset(const char* name)
{
	change(fmt::format("Probe: {}", name),
	       [&](ViewState& state)
	       {
		       state.probe.probe = name;
		       state.probe.own_probe.reset();
		       state.probe.surface.reset();
		       state.probe.vanes.reset();
		       state.probe.offsets.clear();
		       state.probe.sheets.reset();
		       state.probe.corners.reset();
	       });
	sheet_ = 0;
}

bool Workbench::performOnSheets(Action action)
{
	probe::Probe next = probe();
	const auto done = [&] { return setProbe(label(action), next), true; };
	switch (action)
	{
	case Action::preset_single:
		return setPreset("single"), true;
	case Action::preset_trihedral:
		return setPreset("trihedral"), true;
	case Action::preset_paddlewheel:
		return setPreset("paddlewheel"), true;
	case Action::preset_stack:
		return setPreset("stack"), true;
	case Action::next_sheet:
		return chooseSheet(sheet_ + 1), true;
	case Action::previous_sheet:
		return chooseSheet(sheet_ + std::max<std::size_t>(next.sheets.size(), 1) - 1), true;
	default:
		break;
	}
	if (next.sheets.empty())
		return false;
	probe::Sheet& sheet = next.sheets[std::min(sheet_, next.sheets.size() - 1)];
	switch (action)
	{
	case Action::hide_sheet:
		sheet.wishes.hidden = !sheet.wishes.hidden;
		return done();
	case Action::show_all_sheets:
		for (probe::Sheet& each : next.sheets)
			each.wishes.hidden = false;
		return done();
	case Action::add_sheet:
	{
		if (next.sheets.size() >= probe::kMaxSheets)
			return notify(fmt::format("A probe has at most {} sheets", probe::kMaxSheets), true), true;
		// At right angles to the one that is chosen, through the same place: that is what it cannot show itself.
		probe::Sheet added = sheet;
		static_cast<probe::Frame&>(added) = probe::turned(sheet, sheet.origin, sheet.up, 90.0);
		added.wishes.hidden = false;
		next.sheets.push_back(added);
		setProbe(label(action), next);
		chooseSheet(next.sheets.size() - 1);
		return true;
	}
	case Action::remove_sheet:
		if (next.sheets.size() == 1)
			return notify("The last sheet stays: hide it, or choose another probe", true), true;
		next.sheets.erase(next.sheets.begin() + static_cast<std::ptrdiff_t>(std::min(sheet_, next.sheets.size() - 1)));
		setProbe(label(action), next);
		chooseSheet(std::min(sheet_, next.sheets.size() - 1));
		return true;
	default:
		return false;
	}
}

bool Workbench::performOnView(Action action)
{
	const std::optional<interact::View> seen = view();
	if (!seen || !facts_)
		return false;
	const auto named = [&](interact::NamedView name)
	{ return setCamera(label(action), interact::namedView(*seen, name, facts_->extent)), true; };
	switch (action)
	{
	case Action::reset_camera:
		return setCamera(label(action), interact::fitted(*seen, facts_->extent)), true;
	case Action::face_sheet:
	{
		const probe::Probe placed = probe::placed(probe());
		if (sheet_ < placed.sheets.size())
			setCamera(label(action), interact::faceSheet(*seen, placed.sheets[sheet_], facts_->extent));
		return true;
	}
	case Action::view_x:
		return named(interact::NamedView::x);
	case Action::view_minus_x:
		return named(interact::NamedView::minus_x);
	case Action::view_y:
		return named(interact::NamedView::y);
	case Action::view_minus_y:
		return named(interact::NamedView::minus_y);
	case Action::view_z:
		return named(interact::NamedView::z);
	case Action::view_minus_z:
		return named(interact::NamedView::minus_z);
	case Action::view_iso:
		return named(interact::NamedView::iso);
	default:
		return false;
	}
}

bool Workbench::performOnLook(Action action)
{
	const auto edit = [&](const Edit& what) { return change(label(action), what), true; };
	switch (action)
	{
	case Action::next_array:
		return stepArray(1), true;
	case Action::previous_array:
		return stepArray(-1), true;
	case Action::next_time:
		return stepTime(1), true;
	case Action::previous_time:
		return stepTime(-1), true;
	case Action::lines:
		return edit([](ViewState& state) { state.look.lines = state.look.lines > 0 ? 0 : kLines; });
	case Action::bands:
		return edit([](ViewState& state) { state.look.bands = state.look.bands > 0 ? 0 : kLines; });
	case Action::legend:
		return edit([](ViewState& state) { state.look.no_legend = !state.look.no_legend; });
	case Action::range_of_slice:
		return edit(
		    [](ViewState& state)
		    {
			    const bool on = state.look.range.empty() && state.look.range_of == "slice";
			    state.look.range.clear();
			    state.look.range_of = on ? "data" : "slice";
		    });
	case Action::mesh:
		return edit([](ViewState& state) { state.look.mesh = !state.look.mesh; });
	case Action::outline:
		return edit(
		    [](ViewState& state) {
			    state.look.outline = after(state.look.outline, std::array{"box", "edges", "none"});
		    });
	case Action::axes:
		return edit(
		    [](ViewState& state) {
			    state.look.axes = after(state.look.axes, std::array{"corner", "box", "none"});
		    });
	default:
		return false;
	}
}

// Without a name the first array is shown.
const Facts::Array* Workbench::shownArray() const
{
	if (!facts_ || facts_->arrays.empty())
		return nullptr;
	const std::string& name = state().probe.array;
	const auto at = std::ranges::find_if(facts_->arrays, [&](const Facts::Array& array)
	                                     { return array.word == name || array.name == name; });
	return at == facts_->arrays.end() ? &facts_->arrays.front() : &*at;
}

void Workbench::stepArray(int by)
{
	const Facts::Array* now = shownArray();
	if (!now)
		return;
	const auto& arrays = facts_->arrays;
	const auto count = static_cast<std::ptrdiff_t>(arrays.size());
	const Facts::Array& next = arrays[static_cast<std::size_t>((now - arrays.data() + by + count) % count)];
	change(fmt::format("Array {}", next.name),
	       [&](ViewState& state)
	       {
		       state.probe.array = next.word;
		       state.probe.component.clear();
		       state.look.range.clear();
	       });
}

void Workbench::stepTime(int by)
{
	if (!facts_ || facts_->times.empty())
		return;
	const int last = static_cast<int>(facts_->times.size()) - 1;
	showTime(std::clamp(timeStep() + by, 0, last));
}

void Workbench::showTime(int step, const std::string& merge)
{
	change(
	    "Time", [&](ViewState& state) { state.probe.time = fmt::format("#{}", step); }, merge);
}

// Of the input's times, the one that is shown.
int Workbench::timeStep() const
{
	const Result<read::TimeChoice> choice = read::parseTime(state().probe.time);
	if (!facts_ || facts_->times.empty() || !choice)
		return 0;
	const auto& times = facts_->times;
	switch (choice->kind)
	{
	case read::TimeChoice::Kind::first:
		return 0;
	case read::TimeChoice::Kind::index:
		return static_cast<int>(std::min(choice->index, times.size() - 1));
	case read::TimeChoice::Kind::value:
	{
		const auto nearer = [&](double a, double b)
		{ return std::abs(a - choice->value) < std::abs(b - choice->value); };
		return static_cast<int>(std::min_element(times.begin(), times.end(), nearer) - times.begin());
	}
	default:
		return static_cast<int>(times.size()) - 1;
	}
}

} // namespace vp::app
