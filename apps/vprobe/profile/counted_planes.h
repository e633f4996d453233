#pragma once

#include "profile/device_work.h"
#include "profile/floor.h"
#include "profile/swept_probe.h"

namespace vp::app
{

// Cuts some planes again and counts what their stages use. This is apart from the times, since counting takes time: on
// some systems the question for the CPU time alone takes milliseconds.
Status countUse(SweptProbe& swept, StageWork& work);

// The same for the memory that they touch.
Status countTouched(SweptProbe& swept, StageWork& work);

// The same for the shaders of the device.
Status countShaders(SweptProbe& swept, DeviceWork& work);

} // namespace vp::app
