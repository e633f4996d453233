// Returns the value that a polygon has everywhere: kNanValue, kInfiniteValue or its negative; else 0. If a corner is
// NaN, or if only some corners are infinite, nothing can be interpolated. low, high: its corners' least and largest
// value.
float wholeValue(float low, float high)
{
	if (!(low > -kNanFrom && high < kNanFrom))
		return kNanValue;
	if (low >= kInfiniteFrom || high <= -kInfiniteFrom)
		return high >= 0.75 * kInfiniteValue ? kInfiniteValue : low <= -0.75 * kInfiniteValue ? -kInfiniteValue : 0.0;
	return low <= -kInfiniteFrom || high >= kInfiniteFrom ? kNanValue : 0.0;
}
