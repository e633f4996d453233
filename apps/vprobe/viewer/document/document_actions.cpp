#include "interact/camera_moves.h"
#include "interact/nudge.h"
#include "interact/placing.h"
#include "viewer/document/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vp::app
{

namespace
{

using interact::Action;

constexpr int kLines = 10;

std::string label(Action action)
{
	return std::string(interact::wordsOf(action));
}

template <class T, std::size_t Count>
T after(T value, const std::array<T, Count>& values)
{
	const auto found = std::ranges::find(values, value);
	return found == values.end() || found + 1 == values.end() ? values.front() : *(found + 1);
}

} // namespace

void Document::perform(Action action)
{
	if (action == Action::play)
		learned(kHintOfSweep);
	if (performOnWindow(action) || playback_.perform(action))
		return;
	for (const auto part :
	     {&Document::performOnSheets, &Document::performOnProbe, &Document::performOnView, &Document::performOnLook})
		if ((this->*part)(action))
			return;
}

void Document::undo()
{
	if (history_.canUndo())
		notify(fmt::format("Undone: {}", history_.undoLabel()));
	if (history_.undo())
		stateChanged();
}

void Document::redo()
{
	if (history_.canRedo())
		notify(fmt::format("Done again: {}", history_.redoLabel()));
	if (history_.redo())
		stateChanged();
}

bool Document::performOnWindow(Action action)
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
	case Action::save_color_map:
		return ask(Question::save_color_map);
	case Action::cancel:
		if (loader_.isBusy())
			cancelLoading();
		else if (!playback_.recording() && !notices_.all().empty())
			dismiss(std::string(notices_.all().back().words));
		parts.help = false;
		return false; // the sweep has something to cancel too
	case Action::undo:
		return undo(), true;
	case Action::redo:
		return redo(), true;
	case Action::quit:
		quit();
		return true;
	case Action::dark_theme:
		return toggle(settings.dark);
	case Action::handles:
		return toggle(parts.handles);
	case Action::contour:
		pointContour(std::nullopt);
		return toggle(parts.contour);
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
	case Action::text_larger:
		settings.text_size = std::min(settings.text_size * kTextStep, kMaxTextSize);
		return true;
	case Action::text_smaller:
		settings.text_size = std::max(settings.text_size / kTextStep, kMinTextSize);
		return true;
	case Action::find_command:
		learned(kHintOfSearch);
		return toggle(parts.command_search);
	case Action::hints:
		settings.hint = settings.hint ? std::nullopt : std::optional<std::size_t>(0);
		return true;
	case Action::help:
		learned(kHintOfSearch);
		return toggle(parts.help);
	case Action::menus:
		parts.opens_menu = 0;
		return true;
	case Action::panel_keys:
		parts.panels = parts.panels || !parts.panel_keys;
		return toggle(parts.panel_keys);
	case Action::color_map:
		parts.panels = parts.panel_keys = parts.opens_color_map = true;
		return true;
	default:
		return false;
	}
}

// The camera fits the scene into the window then.
bool Document::performOnView(Action action)
{
	const bool done = moveCamera(action);
	if (done)
		fitted_camera_ = state().look.camera;
	return done;
}

bool Document::moveCamera(Action action)
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

bool Document::performOnLook(Action action)
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
		return edit([](view::ViewSpec& state) { state.look.lines = state.look.lines > 0 ? 0 : kLines; });
	case Action::bands:
		return edit([](view::ViewSpec& state) { state.look.bands = state.look.bands > 0 ? 0 : kLines; });
	case Action::legend:
		return edit([](view::ViewSpec& state) { state.look.no_legend = !state.look.no_legend; });
	case Action::range_of_slice:
		return edit(
		    [](view::ViewSpec& state)
		    {
			    const bool on = !state.look.range && state.look.range_of == view::RangeOf::slice;
			    state.look.range.reset();
			    state.look.range_of = on ? view::RangeOf::automatic : view::RangeOf::slice;
		    });
	case Action::mesh:
		return edit([](view::ViewSpec& state) { state.look.mesh = !state.look.mesh; });
	case Action::outline:
		return edit(
		    [](view::ViewSpec& state)
		    {
			    state.look.outline = after(state.look.outline, std::array{render::Outline::box, render::Outline::edges,
			                                                              render::Outline::none});
		    });
	case Action::axes:
		return edit(
		    [](view::ViewSpec& state)
		    {
			    state.look.axes = after(
			        state.look.axes, std::array{view::AxesStyle::corner, view::AxesStyle::box, view::AxesStyle::none});
		    });
	default:
		return false;
	}
}

// If the state names no array, the first one is shown.
const DatasetInfo::Array* Document::shownArray() const
{
	if (!facts_ || facts_->arrays.empty())
		return nullptr;
	const std::string& name = state().probe.array;
	const auto at = std::ranges::find_if(facts_->arrays, [&](const DatasetInfo::Array& array)
	                                     { return array.word == name || array.name == name; });
	return at == facts_->arrays.end() ? &facts_->arrays.front() : &*at;
}

void Document::stepArray(int by)
{
	const DatasetInfo::Array* now = shownArray();
	if (!now)
		return;
	const auto& arrays = facts_->arrays;
	const auto count = static_cast<std::ptrdiff_t>(arrays.size());
	const DatasetInfo::Array& next = arrays[static_cast<std::size_t>((now - arrays.data() + by + count) % count)];
	change(fmt::format("Array {}", next.name),
	       [&](view::ViewSpec& state)
	       {
		       state.probe.array = next.word;
		       state.probe.component.reset();
		       state.look.range.reset();
	       });
}

void Document::stepTime(int by)
{
	if (!facts_ || facts_->times.empty())
		return;
	const int last = static_cast<int>(facts_->times.size()) - 1;
	showTime(std::clamp(timeStep() + by, 0, last));
}

void Document::showTime(int step, const std::string& merge)
{
	change(
	    "Time", [&](view::ViewSpec& state) { state.input.time = read::timeAt(static_cast<std::size_t>(step)); }, merge);
}

// Returns the index of the shown time among those of the input.
int Document::timeStep() const
{
	if (!facts_ || facts_->times.empty())
		return 0;
	return static_cast<int>(read::timeIndex(facts_->times, state().input.time));
}

} // namespace vp::app
