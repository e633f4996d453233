#pragma once

#include <vulkan/vulkan.h>

// Vulkan's structures are written as their type with everything else zero; the warning would have all fields spelt out.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
