#pragma once

// Defines VP_SANITIZED in builds with the address or the thread sanitizer, and VP_THREAD_SANITIZED with the latter,
// with gcc and clang.
#if defined(__SANITIZE_THREAD__)
#define VP_THREAD_SANITIZED
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define VP_THREAD_SANITIZED
#endif
#endif
#if defined(VP_THREAD_SANITIZED) || defined(__SANITIZE_ADDRESS__)
#define VP_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define VP_SANITIZED
#endif
#endif

namespace vp
{

#ifdef VP_SANITIZED
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#ifdef VP_THREAD_SANITIZED
constexpr bool kThreadSanitized = true;
#else
constexpr bool kThreadSanitized = false;
#endif

} // namespace vp
