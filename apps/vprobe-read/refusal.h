#pragma once

#include <stdexcept>
#include <string>

// Why an input cannot be used, in words that follow "FILE: " on the user's line.
class Refusal : public std::runtime_error
{
public:
	using std::runtime_error::runtime_error;
};

inline Refusal damaged(const std::string& reason)
{
	return Refusal("truncated or damaged: " + reason);
}
