#pragma once

#include "vprobe-read/base/bytes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace vp::reader::volumes
{

// Holds the facts in the header of a trace.
struct SegyTrace
{
	int in_line;
	int cross_line;
	double x;
	double y;
	double delay; // ms, of the first sample
};

// The traces of a SEG-Y file, all of one length. The bytes must outlive it.
class SegyFile
{
public:
	// Throws a Refusal unless it has traces, and ends behind one.
	explicit SegyFile(std::string_view bytes);

	std::size_t traceCount() const { return traces_; }
	std::size_t sampleCount() const { return samples_; }
	double interval() const { return interval_; } // ms
	// Tells the user which facts in the headers are doubtful; mostly empty.
	const std::string& note() const { return note_; }
	SegyTrace trace(std::size_t index) const;
	double sample(std::size_t trace, std::size_t index) const;
	// True if its samples do not fit into single precision.
	bool isDouble() const { return format_ == 2 || format_ == 6 || format_ == 9 || format_ == 10 || format_ == 12; }

private:
	const char* bytesAt(std::size_t at, std::size_t count) const;
	template <class Number>
	Number number(std::size_t at) const;
	std::size_t placeOf(std::size_t trace) const { return start_ + trace * trace_bytes_; }
	void chooseOrder();
	void chooseWidth(int format);
	void chooseLength();
	void chooseInterval();
	void checkTraces();
	int revision() const;
	double threeBytes(std::size_t at, bool has_sign) const;

	std::string_view bytes_;
	ByteOrder order_ = ByteOrder::big;
	int format_ = 0;
	std::size_t width_ = 4;
	std::size_t samples_ = 0;
	double interval_ = 0.0;
	std::size_t start_ = 0;
	std::size_t trace_bytes_ = 0;
	std::size_t traces_ = 0;
	bool has_cdp_ = false;
	std::string note_;
};

} // namespace vp::reader::volumes
