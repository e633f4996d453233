// The median time of a cut of demo:shell:16 by the library's face, in seconds: what python_cuts.py compares with.
#include <vprobe/vprobe.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

int main()
{
	const auto data = vprobe::Dataset::open("demo:shell:16", {.classify = vprobe::Classify::cpu});
	if (!data)
		return std::fprintf(stderr, "%s\n", data.error().message.c_str()), 1;
	constexpr int kCalls = 1000;
	std::vector<double> seconds;
	for (int i = -200; i < kCalls; ++i)
	{
		const auto begin = std::chrono::steady_clock::now();
		const auto cut = data->cut(vprobe::View().normal({0.3, 0.5, 0.8}));
		const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
		if (cut && i >= 0)
			seconds.push_back(spent.count());
	}
	std::nth_element(seconds.begin(), seconds.begin() + kCalls / 2, seconds.end());
	std::printf("%.9f\n", seconds[kCalls / 2]);
	return 0;
}
