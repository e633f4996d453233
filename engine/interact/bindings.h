#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace vp::interact
{

// The actions that have keys.
enum class Action
{
	open,
	save_state,
	save_state_as,
	save_picture,
	save_film,
	save_slice,
	save_color_map,
	undo,
	redo,
	quit,
	cancel,

	play,
	faster,
	slower,
	there_and_back,
	loop,
	record,
	next_frame,
	previous_frame,
	first_frame,
	last_frame,
	next_time,
	previous_time,

	push_forward,
	push_back,
	push_forward_fine,
	push_back_fine,
	turn_x_plus,
	turn_x_minus,
	turn_up_plus,
	turn_up_minus,
	turn_normal_plus,
	turn_normal_minus,
	window_bigger,
	window_smaller,
	normal_x,
	normal_y,
	normal_z,
	normal_to_camera,
	snap_normal,
	reset_place,

	next_sheet,
	previous_sheet,
	hide_sheet,
	show_all_sheets,
	add_sheet,
	remove_sheet,
	sheet_alone,
	preset_single,
	preset_trihedral,
	preset_paddlewheel,
	preset_stack,
	magnifier,
	reset_magnifier,

	reset_camera,
	face_sheet,
	view_x,
	view_minus_x,
	view_y,
	view_minus_y,
	view_z,
	view_minus_z,
	view_iso,

	next_array,
	previous_array,
	range_of_slice,
	color_map,
	lines,
	bands,
	mesh,
	outline,
	legend,
	axes,
	dark_theme,

	handles,
	contour,
	plane_pane,
	panels,
	profile_overlay,
	full_screen,
	text_larger,
	text_smaller,
	find_command,
	menus,
	panel_keys,
	hints,
	help
};
constexpr int kActions = static_cast<int>(Action::help) + 1;

// A key, named by the character on it without Shift, as a small letter. Keys without a character have numbers beyond
// Unicode.
enum class Key : char32_t
{
	none = 0,
	space = U' ',
	beyond_unicode = 0x110000,
	escape,
	enter,
	tab,
	backspace,
	insert,
	remove, // Delete
	left,
	right,
	up,
	down,
	page_up,
	page_down,
	home,
	end,
	f1, // to f12 without a gap
	f2,
	f3,
	f4,
	f5,
	f6,
	f7,
	f8,
	f9,
	f10,
	f11,
	f12
};

// Returns the key of a printable character that is not a capital letter.
constexpr Key key(char32_t character)
{
	return static_cast<Key>(character);
}

struct Chord
{
	Key key = Key::none;
	bool ctrl = false;
	bool shift = false;
	bool alt = false;

	bool operator==(const Chord&) const = default;
};

struct Binding
{
	Action action;
	std::string_view name; // for scripts: the name of the enumerator
	Chord chord;
	std::string_view group; // heading of the list
	std::string_view words; // what it does; also used for tooltips
};

// The bindings in the order of the list. An action may have several chords, which follow each other. No two actions
// have the same chord.
std::span<const Binding> bindings();

// For a character that needs Shift on some keyboards, such as ?, give the typed character or the key.
std::optional<Action> actionOf(const Chord& chord);

std::string nameOf(const Chord& chord); // "Ctrl+Shift+Z"
std::string keysOf(Action action);      // all its chords: "Ctrl+Shift+Z, Ctrl+Y"
std::string_view wordsOf(Action action);

std::optional<Action> actionNamed(std::string_view name);

// Returns the table as text with one line for each action: its keys, name and words in columns, below the headings of
// the groups.
std::string bindingsText();

} // namespace vp::interact
