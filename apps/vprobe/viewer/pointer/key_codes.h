#pragma once

#include "interact/bindings.h"
#include "interact/drag.h"
#include "viewer/pointer/pointer_controller.h"

#include <optional>

namespace vp::app
{

// These functions convert GLFW's numbers to the types of interact/.

std::optional<interact::Chord> chordOf(int key, int modifiers); // returns nothing for keys that mean nothing alone
std::optional<Button> buttonOf(int button);

// Returns the modifiers that are held, after `key` went down or up: Shift is fine, Ctrl snaps, Alt means one sheet
// alone.
interact::Modifiers modifiersOf(int key, bool down, int modifiers);

} // namespace vp::app
