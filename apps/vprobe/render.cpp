#include "commands.h"
namespace vp::app { void addRender(CLI::App&, Run&) {} }
