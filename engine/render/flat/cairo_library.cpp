#include "render/flat/cairo_library.h"

#include <fmt/format.h>

#include <cassert>
#include <string>
#include <type_traits>

#include <dlfcn.h>

namespace vp::render
{

namespace
{

constexpr const char* kCairoLibrary = "libcairo.so.2";

struct LoadedCairo
{
	Cairo functions{};
	std::string failure; // empty if all functions were found
};

LoadedCairo openCairo()
{
	LoadedCairo loaded;
	void* library = dlopen(kCairoLibrary, RTLD_NOW | RTLD_LOCAL); // stays: cairo keeps what it knows of fonts
	const auto find = [&](auto& function, const char* name)
	{
		void* found = library ? dlsym(library, name) : nullptr;
		if (!found && loaded.failure.empty())
		{
			const char* reason = dlerror();
			loaded.failure = reason ? reason : name;
		}
		function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(found);
	};
#define VP_FIND(name) find(loaded.functions.name, "cairo_" #name);
	VP_CAIRO(VP_FIND)
#undef VP_FIND
	return loaded;
}

const LoadedCairo& loadedCairo()
{
	static const LoadedCairo loaded = openCairo();
	return loaded;
}

} // namespace

Status loadCairo()
{
	const std::string& failure = loadedCairo().failure;
	if (!failure.empty())
		return Error{
		    ErrorKind::output,
		    fmt::format("a flat picture needs cairo, which cannot be loaded ({}); install libcairo2", failure)};
	return Nothing{};
}

const Cairo& cairo()
{
	const LoadedCairo& loaded = loadedCairo();
	assert(loaded.failure.empty());
	return loaded.functions;
}

} // namespace vp::render
