#pragma once

#include <string>

namespace vp::reader
{

// As long as it lives, whoever opens a file for reading gets another one in its place (open_watch.cpp). HDF5 asks for
// the real path of what it opens, and a file in memory has none.
class StandIn
{
public:
	StandIn(const std::string& file, const std::string& other);
	~StandIn();
	StandIn(const StandIn&) = delete;
	StandIn& operator=(const StandIn&) = delete;
};

} // namespace vp::reader
