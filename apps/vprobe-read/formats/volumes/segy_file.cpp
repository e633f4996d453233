// The places of numbers are those of "SEG-Y r2.0: SEG-Y Data Exchange format" (SEG, 2017), which counts bytes from 1.
#include "segy_file.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <cmath>

namespace vp::reader::volumes
{

namespace
{

constexpr std::size_t kSegyTextBytes = 3200;
constexpr std::size_t kSegyBinaryBytes = 400;
constexpr std::size_t kSegyTraceHeaderBytes = 240;

// IBM's System/360: a sign, a power of 16 less 64, and 24 bits behind the point.
float ibmFloat(std::uint32_t bits)
{
	const int exponent = static_cast<int>(bits >> 24 & 0x7F) - 64;
	const double value = std::ldexp(static_cast<double>(bits & 0xFFFFFF), 4 * exponent - 24);
	return static_cast<float>(bits >> 31 ? -value : value);
}

} // namespace

const char* SegyFile::bytesAt(std::size_t at, std::size_t count) const
{
	if (at > bytes_.size() || bytes_.size() - at < count)
		throw damaged("it ends within a trace");
	return bytes_.data() + at;
}

template <class Number>
Number SegyFile::number(std::size_t at) const
{
	return numberAt<Number>(bytesAt(at, sizeof(Number)), order_);
}

// Revision 2 may have little endian numbers.
void SegyFile::chooseOrder()
{
	const auto is_format = [this]
	{
		const int format = number<std::int16_t>(3224);
		return format >= 1 && format <= 16;
	};
	if (is_format())
		return;
	order_ = ByteOrder::little;
	if (!is_format())
		throw damaged("no code of a format of samples");
}

void SegyFile::chooseWidth(int format)
{
	switch (format)
	{
	case 1:
	case 2:
	case 5:
	case 10:
		width_ = 4;
		break;
	case 3:
	case 11:
		width_ = 2;
		break;
	case 6:
	case 9:
	case 12:
		width_ = 8;
		break;
	case 7:
	case 15:
		width_ = 3;
		break;
	case 8:
	case 16:
		width_ = 1;
		break;
	default:
		throw Refusal(fmt::format("samples of SEG-Y format {}, which are not read; convert them to format 5", format));
	}
	format_ = format;
}

int SegyFile::revision() const
{
	return number<std::uint8_t>(3500);
}

// Revision 2 has room for larger counts.
void SegyFile::chooseLength()
{
	samples_ = number<std::uint16_t>(3220);
	if (revision() < 2)
		return;
	if (const auto more = number<std::int32_t>(3268); more > 0)
		samples_ = static_cast<std::size_t>(more);
	if (number<std::int32_t>(3506) > 0)
		throw Refusal("traces with more than one header, which are not read; write it as revision 1");
}

void SegyFile::chooseInterval()
{
	double microseconds = number<std::uint16_t>(3216);
	if (const double exact = revision() < 2 ? 0.0 : number<double>(3272); std::isfinite(exact) && exact > 0.0)
		microseconds = exact;
	const double of_trace = number<std::uint16_t>(start_ + 116);
	if (microseconds > 0.0 && of_trace > 0.0 && std::abs(microseconds - of_trace) >= 1.0)
		note_ = fmt::format("its samples are {} us apart by its header and {} us by its first trace; the header's are "
		                    "taken",
		                    microseconds, of_trace);
	if (microseconds <= 0.0)
		microseconds = of_trace;
	if (microseconds <= 0.0)
		throw damaged("its samples have no interval");
	interval_ = microseconds / 1000.0;
}

void SegyFile::checkTraces()
{
	for (std::size_t t = 0; t < traces_; ++t)
	{
		if (const auto samples = number<std::uint16_t>(placeOf(t) + 114); samples != 0 && samples != samples_ % 65536)
			throw Refusal(fmt::format("trace {} has {} samples where others have {}; give all the same length", t,
			                          samples, samples_));
		if (number<std::int16_t>(placeOf(t) + 88) == 4)
			throw Refusal("coordinates in degrees, minutes and seconds; convert them to lengths");
		has_cdp_ =
		    has_cdp_ || number<std::int32_t>(placeOf(t) + 180) != 0 || number<std::int32_t>(placeOf(t) + 184) != 0;
	}
	if (const auto unit = number<std::int16_t>(start_ + 88); unit == 2 || unit == 3)
		note_ += fmt::format("{}its coordinates are {}", note_.empty() ? "" : "; ",
		                     unit == 2 ? "seconds of arc" : "degrees");
}

SegyFile::SegyFile(std::string_view bytes) : bytes_(bytes)
{
	if (bytes_.size() <= kSegyTextBytes + kSegyBinaryBytes + kSegyTraceHeaderBytes)
		throw damaged("it ends within its headers");
	chooseOrder();
	chooseWidth(number<std::int16_t>(3224));
	chooseLength();
	if (samples_ < 2)
		throw damaged(fmt::format("its traces have {} samples", samples_));
	// Further headers in text; a count below 0 leaves their end to a mark in them.
	const int texts = number<std::uint8_t>(3500) > 0 ? number<std::int16_t>(3504) : 0;
	if (texts < 0)
		throw Refusal("an unknown number of text headers, which is not read");
	start_ = kSegyTextBytes + kSegyBinaryBytes + static_cast<std::size_t>(texts) * kSegyTextBytes;
	trace_bytes_ = kSegyTraceHeaderBytes + samples_ * width_;
	if (bytes_.size() <= start_ || (bytes_.size() - start_) % trace_bytes_ != 0)
		throw damaged("it ends within a trace, or its traces have different lengths");
	traces_ = (bytes_.size() - start_) / trace_bytes_;
	chooseInterval();
	checkTraces();
}

SegyTrace SegyFile::trace(std::size_t index) const
{
	const std::size_t at = placeOf(index);
	const auto scaled = [&](std::size_t place)
	{
		const double value = number<std::int32_t>(place);
		const double scale = number<std::int16_t>(at + 70);
		return scale < 0.0 ? value / -scale : scale > 0.0 ? value * scale : value;
	};
	// The middle of source and receiver, or else the source.
	const std::size_t x = has_cdp_ ? 180 : 72;
	SegyTrace trace;
	trace.in_line = number<std::int32_t>(at + 188);
	trace.cross_line = number<std::int32_t>(at + 192);
	trace.x = scaled(at + x);
	trace.y = scaled(at + x + 4);
	trace.delay = number<std::int16_t>(at + 108);
	if (const double scale = revision() < 1 ? 0.0 : number<std::int16_t>(at + 214); scale != 0.0)
		trace.delay = scale < 0.0 ? trace.delay / -scale : trace.delay * scale;
	return trace;
}

double SegyFile::threeBytes(std::size_t at, bool has_sign) const
{
	const auto value = static_cast<double>(integerAt(bytesAt(at, 3), 3, order_));
	return has_sign && value >= 1 << 23 ? value - (1 << 24) : value;
}

double SegyFile::sample(std::size_t trace, std::size_t index) const
{
	const std::size_t at = placeOf(trace) + kSegyTraceHeaderBytes + index * width_;
	switch (format_)
	{
	case 1:
		return ibmFloat(number<std::uint32_t>(at));
	case 2:
		return number<std::int32_t>(at);
	case 3:
		return number<std::int16_t>(at);
	case 6:
		return number<double>(at);
	case 7:
	case 15:
		return threeBytes(at, format_ == 7);
	case 8:
		return number<std::int8_t>(at);
	case 9:
		return static_cast<double>(number<std::int64_t>(at));
	case 10:
		return number<std::uint32_t>(at);
	case 11:
		return number<std::uint16_t>(at);
	case 12:
		return static_cast<double>(number<std::uint64_t>(at));
	case 16:
		return number<std::uint8_t>(at);
	default:
		return number<float>(at);
	}
}

} // namespace vp::reader::volumes
