#include "parts/stoppable.h"

namespace vp::parts
{

std::stop_token& Stoppable::current()
{
	static thread_local std::stop_token token;
	return token;
}

} // namespace vp::parts
