#pragma once

#include "base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace vp::view
{

enum class ContextKind : std::uint8_t
{
	boundary, // the boundary of the domain
	i,        // a grid surface
	j,
	k,
	patch // a part of the boundary that the file names
};

/// A translucent surface around the sheets. As text: KIND[=ARGUMENT][:OPACITY].
struct ContextSpec
{
	ContextKind kind = ContextKind::boundary;
	std::string argument{}; // index of points for i, j and k; name of a patch; otherwise empty
	double opacity = 0.15;  // 0 to 1

	bool operator==(const ContextSpec&) const = default;
};

/// Returns a surface of this kind with the default opacity.
ContextSpec contextOf(ContextKind kind);

/// Returns the forms for a help text: boundary[:OPACITY], ...
std::string contextForms();

/// Parses the text. The usage error does not name the setting.
Result<ContextSpec> parseContext(std::string_view text);
std::string contextText(const ContextSpec& context); // parse() gives the same value again

} // namespace vp::view
