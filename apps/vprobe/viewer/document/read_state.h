#pragma once

#include "base/result.h"
#include "view/view_spec.h"

#include <functional>
#include <string>

namespace vp::app
{

using ReadState = std::function<Result<view::ViewSpec>(const std::string& file)>;

} // namespace vp::app
