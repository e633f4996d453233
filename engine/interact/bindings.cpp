#include "interact/bindings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace vp::interact
{

namespace
{

constexpr Chord plain(char32_t c)
{
	return {key(c), false, false, false};
}

constexpr Chord plain(Key k)
{
	return {k, false, false, false};
}

constexpr Chord shift(char32_t c)
{
	return {key(c), false, true, false};
}

constexpr Chord shift(Key k)
{
	return {k, false, true, false};
}

constexpr Chord ctrl(char32_t c)
{
	return {key(c), true, false, false};
}

constexpr Chord ctrl(Key k)
{
	return {k, true, false, false};
}

constexpr Chord ctrlShift(char32_t c)
{
	return {key(c), true, true, false};
}

constexpr std::string_view kFile = "File";
constexpr std::string_view kFilm = "Film";
constexpr std::string_view kProbe = "Probe";
constexpr std::string_view kSheet = "Sheets";
constexpr std::string_view kView = "Camera";
constexpr std::string_view kLook = "Look";
constexpr std::string_view kWindow = "Window";

using enum Action;

// An action's name is its enumerator's.
#define VP_BINDING(action, ...)                                                                                        \
	{                                                                                                                  \
		action, #action, __VA_ARGS__                                                                                   \
	}

constexpr auto kBindings = std::to_array<Binding>({
    VP_BINDING(open, ctrl('o'), kFile, "Open files"),
    VP_BINDING(save_state, ctrl('s'), kFile, "Save the state"),
    VP_BINDING(save_state_as, ctrlShift('s'), kFile, "Save the state under another name"),
    VP_BINDING(save_picture, ctrl('p'), kFile, "Save the picture"),
    VP_BINDING(save_film, ctrl('m'), kFile, "Save the film"),
    VP_BINDING(save_slice, ctrl('e'), kFile, "Export the slice"),
    VP_BINDING(save_color_map, ctrlShift('m'), kFile, "Save the color map"),
    VP_BINDING(undo, ctrl('z'), kFile, "Undo"),
    VP_BINDING(redo, ctrlShift('z'), kFile, "Redo"),
    VP_BINDING(redo, ctrl('y'), kFile, "Redo"),
    VP_BINDING(quit, ctrl('q'), kFile, "Quit"),
    VP_BINDING(cancel, plain(Key::escape), kFile, "Cancel what is under way"),

    VP_BINDING(play, plain(Key::space), kFilm, "Play or pause the sweep"),
    VP_BINDING(faster, plain(']'), kFilm, "Play faster"),
    VP_BINDING(slower, plain('['), kFilm, "Play slower"),
    VP_BINDING(there_and_back, plain('b'), kFilm, "Play there and back"),
    VP_BINDING(loop, shift('l'), kFilm, "Play in a loop"),
    VP_BINDING(record, ctrl('r'), kFilm, "Record the sweep into a film loop"),
    VP_BINDING(next_frame, ctrl(Key::right), kFilm, "Next frame"),
    VP_BINDING(previous_frame, ctrl(Key::left), kFilm, "Previous frame"),
    VP_BINDING(first_frame, ctrl(Key::home), kFilm, "First frame"),
    VP_BINDING(last_frame, ctrl(Key::end), kFilm, "Last frame"),
    VP_BINDING(next_time, plain(Key::page_down), kFilm, "Next time step"),
    VP_BINDING(previous_time, plain(Key::page_up), kFilm, "Previous time step"),

    VP_BINDING(push_forward, plain('.'), kProbe, "Push forward along the normal"),
    VP_BINDING(push_back, plain(','), kProbe, "Push back along the normal"),
    VP_BINDING(push_forward_fine, shift('.'), kProbe, "Push forward by a tenth of a step"),
    VP_BINDING(push_back_fine, shift(','), kProbe, "Push back by a tenth of a step"),
    VP_BINDING(turn_x_plus, plain(Key::down), kProbe, "Turn about the x axis"),
    VP_BINDING(turn_x_minus, plain(Key::up), kProbe, "Turn about the x axis, the other way"),
    VP_BINDING(turn_up_plus, plain(Key::right), kProbe, "Turn about the up axis"),
    VP_BINDING(turn_up_minus, plain(Key::left), kProbe, "Turn about the up axis, the other way"),
    VP_BINDING(turn_normal_plus, shift(Key::left), kProbe, "Turn about the normal"),
    VP_BINDING(turn_normal_minus, shift(Key::right), kProbe, "Turn about the normal, the other way"),
    VP_BINDING(window_bigger, plain('='), kProbe, "Make the window bigger"),
    VP_BINDING(window_bigger, plain('+'), kProbe, "Make the window bigger"),
    VP_BINDING(window_smaller, plain('-'), kProbe, "Make the window smaller"),
    VP_BINDING(normal_x, plain('x'), kProbe, "Turn the normal to x"),
    VP_BINDING(normal_y, plain('y'), kProbe, "Turn the normal to y"),
    VP_BINDING(normal_z, plain('z'), kProbe, "Turn the normal to z"),
    VP_BINDING(normal_to_camera, plain('n'), kProbe, "Turn the normal to the camera"),
    VP_BINDING(snap_normal, shift('n'), kProbe, "Turn the normal to the nearest axis"),
    VP_BINDING(reset_place, plain(Key::home), kProbe, "Put the probe back to the middle"),

    VP_BINDING(next_sheet, plain(Key::tab), kSheet, "Choose the next sheet"),
    VP_BINDING(previous_sheet, shift(Key::tab), kSheet, "Choose the sheet before"),
    VP_BINDING(hide_sheet, plain('h'), kSheet, "Hide or show the sheet"),
    VP_BINDING(show_all_sheets, shift('h'), kSheet, "Show all sheets"),
    VP_BINDING(add_sheet, plain(Key::insert), kSheet, "Add a sheet"),
    VP_BINDING(remove_sheet, plain(Key::remove), kSheet, "Remove the sheet"),
    VP_BINDING(sheet_alone, plain('o'), kSheet, "Move the sheet alone, or the whole probe"),
    VP_BINDING(preset_single, ctrl('1'), kSheet, "Probe of one sheet"),
    VP_BINDING(preset_trihedral, ctrl('2'), kSheet, "Probe of three sheets at right angles"),
    VP_BINDING(preset_paddlewheel, ctrl('3'), kSheet, "Probe of vanes about an axis"),
    VP_BINDING(preset_stack, ctrl('4'), kSheet, "Probe of parallel sheets"),
    VP_BINDING(magnifier, plain('m'), kSheet, "Magnifier: wheel and drag within the sheet"),
    VP_BINDING(reset_magnifier, shift('m'), kSheet, "Take the magnifier away"),

    VP_BINDING(reset_camera, plain('r'), kView, "Fit the scene into the picture"),
    VP_BINDING(face_sheet, plain('f'), kView, "Face the sheet"),
    VP_BINDING(view_x, plain('1'), kView, "View from x"),
    VP_BINDING(view_minus_x, plain('2'), kView, "View from -x"),
    VP_BINDING(view_y, plain('3'), kView, "View from y"),
    VP_BINDING(view_minus_y, plain('4'), kView, "View from -y"),
    VP_BINDING(view_z, plain('5'), kView, "View from z"),
    VP_BINDING(view_minus_z, plain('6'), kView, "View from -z"),
    VP_BINDING(view_iso, plain('7'), kView, "View from x, y and z alike"),

    VP_BINDING(next_array, plain('a'), kLook, "Show the next array"),
    VP_BINDING(previous_array, shift('a'), kLook, "Show the array before"),
    VP_BINDING(range_of_slice, plain('c'), kLook, "Fit the colors to the slice"),
    VP_BINDING(color_map, plain('t'), kLook, "Color map: opacity by value"),
    VP_BINDING(lines, plain('l'), kLook, "Contour lines"),
    VP_BINDING(bands, shift('b'), kLook, "Colors in bands"),
    VP_BINDING(mesh, plain('e'), kLook, "Edges of the cells"),
    VP_BINDING(outline, shift('o'), kLook, "Outline of the grid"),
    VP_BINDING(legend, plain('k'), kLook, "Legend"),
    VP_BINDING(axes, shift('k'), kLook, "Axes"),
    VP_BINDING(dark_theme, plain('d'), kLook, "Dark or light theme"),

    VP_BINDING(handles, plain('g'), kWindow, "Handles of the probe"),
    VP_BINDING(contour, shift('c'), kWindow, "A contour follows the pointer over the sheets"),
    VP_BINDING(plane_pane, plain('p'), kWindow, "The sheet in a pane of its own, flat"),
    VP_BINDING(panels, plain(Key::f9), kWindow, "Panels"),
    VP_BINDING(profile_overlay, plain(Key::f2), kWindow, "What a frame's time is spent on"),
    VP_BINDING(full_screen, plain(Key::f11), kWindow, "Full screen"),
    VP_BINDING(text_larger, ctrl('='), kWindow, "Larger text"),
    VP_BINDING(text_larger, ctrl('+'), kWindow, "Larger text"),
    VP_BINDING(text_smaller, ctrl('-'), kWindow, "Smaller text"),
    VP_BINDING(find_command, ctrl('k'), kWindow, "Find a command or a setting by its name"),
    VP_BINDING(menus, plain(Key::f10), kWindow, "Open the menus, for the arrow keys"),
    VP_BINDING(panel_keys, plain(Key::f6), kWindow, "Move through the panel by keys"),
    VP_BINDING(hints, shift(Key::f1), kWindow, "Hints for the first steps"),
    VP_BINDING(help, plain('?'), kWindow, "This list"),
    VP_BINDING(help, plain(Key::f1), kWindow, "This list"),
});

#undef VP_BINDING

constexpr std::array<std::string_view, 14> kKeyNames{"Escape", "Enter",    "Tab",   "Backspace", "Insert",
                                                     "Delete", "Left",     "Right", "Up",        "Down",
                                                     "PageUp", "PageDown", "Home",  "End"};

std::string nameOf(Key key)
{
	const auto code = static_cast<char32_t>(key);
	if (key == Key::space)
		return "Space";
	if (key >= Key::f1)
		return fmt::format("F{}", code - static_cast<char32_t>(Key::f1) + 1);
	if (key >= Key::escape)
		return std::string(kKeyNames[code - static_cast<char32_t>(Key::escape)]);
	const char letter = static_cast<char>(code);
	return std::string(1, letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter);
}

bool isSign(Key key)
{
	const auto code = static_cast<char32_t>(key);
	const bool letter = code >= U'a' && code <= U'z';
	const bool digit = code >= U'0' && code <= U'9';
	return code > U' ' && key < Key::beyond_unicode && !letter && !digit;
}

const Binding* bindingOf(const Chord& chord)
{
	const auto found = std::ranges::find(kBindings, chord, &Binding::chord);
	return found == kBindings.end() ? nullptr : &*found;
}

} // namespace

std::span<const Binding> bindings()
{
	return kBindings;
}

std::optional<Action> actionOf(const Chord& chord)
{
	const Binding* binding = bindingOf(chord);
	// A sign typed with Shift where the table has it without, as ? is on most keyboards.
	if (!binding && chord.shift && isSign(chord.key))
		binding = bindingOf({chord.key, chord.ctrl, false, chord.alt});
	return binding ? std::optional(binding->action) : std::nullopt;
}

std::string nameOf(const Chord& chord)
{
	return fmt::format("{}{}{}{}", chord.ctrl ? "Ctrl+" : "", chord.alt ? "Alt+" : "", chord.shift ? "Shift+" : "",
	                   nameOf(chord.key));
}

std::string keysOf(Action action)
{
	std::string keys;
	for (const Binding& binding : kBindings)
		if (binding.action == action)
			keys += (keys.empty() ? "" : ", ") + nameOf(binding.chord);
	return keys;
}

std::string_view wordsOf(Action action)
{
	return std::ranges::find(kBindings, action, &Binding::action)->words;
}

std::optional<Action> actionNamed(std::string_view name)
{
	const auto found = std::ranges::find(kBindings, name, &Binding::name);
	return found == kBindings.end() ? std::nullopt : std::optional(found->action);
}

std::string bindingsText()
{
	std::size_t width = 0;
	std::size_t name_width = 0;
	for (const Binding& binding : kBindings)
	{
		width = std::max(width, keysOf(binding.action).size());
		name_width = std::max(name_width, binding.name.size());
	}
	std::string text;
	const Binding* last = nullptr;
	for (const Binding& binding : kBindings)
	{
		if (last && last->action == binding.action)
			continue;
		if (!last || last->group != binding.group)
			fmt::format_to(std::back_inserter(text), "{}{}\n", last ? "\n" : "", binding.group);
		fmt::format_to(std::back_inserter(text), "  {:<{}}  {:<{}}  {}\n", keysOf(binding.action), width, binding.name,
		               name_width, binding.words);
		last = &binding;
	}
	return text;
}

} // namespace vp::interact
