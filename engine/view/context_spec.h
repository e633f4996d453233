#pragma once

#include "base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace vp::view
{

enum class ContextKind : std::uint8_t
{
	boundary, // that of the domain
	i,        // grid surfaces
	j,
	k,
	patch // a part of the boundary that the file names
};

/// A translucent surface that is drawn around the sheets, written KIND[=ARGUMENT][:OPACITY].
struct ContextSpec
{
	ContextKind kind = ContextKind::boundary;
	std::string argument{}; // an index of points for i, j and k, the name of a patch; else empty
	double opacity = 0.15;  // 0 to 1

	bool operator==(const ContextSpec&) const = default;
};

/// One of that kind with the opacity that it has where none is given.
ContextSpec contextOf(ContextKind kind);

/// For a help text: boundary[:OPACITY], ...
std::string contextForms();

/// A usage error, which does not name the setting.
Result<ContextSpec> parseContext(std::string_view text);
std::string contextText(const ContextSpec& context); // read again it is the same

} // namespace vp::view
