// Lets one header serve C++ and GLSL.
#ifdef __cplusplus
#pragma once
#include <cstdint>
#define VP_SHARED_BEGIN                                                                                                \
	namespace vp::shared                                                                                               \
	{
#define VP_SHARED_END }
#define VP_CONST constexpr
namespace vp::shared
{
using uint = std::uint32_t;
}
#else
#define VP_SHARED_BEGIN
#define VP_SHARED_END
#define VP_CONST const
#endif
