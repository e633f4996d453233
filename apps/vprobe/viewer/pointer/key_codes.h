#pragma once

#include "interact/bindings.h"
#include "interact/drag.h"
#include "viewer/pointer/pointer_controller.h"

#include <optional>

namespace vp::app
{

// GLFW's numbers as the words of interact/.

std::optional<interact::Chord> chordOf(int key, int modifiers); // none for keys that mean nothing alone
std::optional<Button> buttonOf(int button);

// What is held, once `key` is down or up: Shift is fine, Ctrl snaps, Alt means one sheet alone.
interact::Modifiers modifiersOf(int key, bool down, int modifiers);

} // namespace vp::app
