#pragma once

#include "viewer/document/document.h"

namespace vp::app
{

// Returns true if an action that switches something has it on.
bool isOn(const Document& document, interact::Action action);

// Returns true if an action can be done now. Menus, buttons and keys offer no others.
bool isPossible(const Document& document, interact::Action action);

} // namespace vp::app
