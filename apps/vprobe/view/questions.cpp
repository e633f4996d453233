#include "view/panels.h"

namespace vp::app
{

void showQuestions(Desk&) {}

} // namespace vp::app
