#pragma once

#include <optional>
#include <string_view>

namespace vp
{

// Returns the number that the whole word writes, or nothing if it is no number. The spellings are those that
// programs write into text files, in small and capital letters:
//   1, +1, -.5, 1e2, 1.E+2       C
//   1D2, 1Q2, 1.0-100, 1.0+100   Fortran, which drops the letter where an exponent has three digits
//   nan, -nan, nan(ind), nan(0x8000), nanq, nans, inf, -infinity
//   1.#QNAN, 1.#SNAN, 1.#IND, -1.#IND00, 1.#INF   Microsoft's C library before 2015
// A number too large for a double gives infinity, and one too small gives 0, with their signs. The locale does not
// matter.
std::optional<double> parseReal(std::string_view word);

} // namespace vp
