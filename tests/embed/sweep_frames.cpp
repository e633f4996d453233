// Sweeps a probe through a data set, and looks at every frame until enough is seen.
#include <vprobe/vprobe.h>

#include <cstdio>

int main()
{
	const auto data = vprobe::Dataset::open("demo:shell:32");
	if (!data)
		return std::fprintf(stderr, "%s\n", data.error().message.c_str()), 1;

	vprobe::View view;
	view.normal({0.0, 0.0, 1.0});
	if (const auto set = view.set("frames", "10"); !set)
		return std::fprintf(stderr, "%s\n", set.error().message.c_str()), 1;
	int frames = 0;
	const auto swept =
	    data->sweep(view,
	                [&](const vprobe::SweepFrame& frame)
	                {
		                const vprobe::Figures figures = frame.cut.figures(0);
		                std::printf("%d of %d: z = %.3f, %zu cells, area %.4f\n", frame.index + 1, frame.count,
		                            frame.cut.origin(0)[2], figures.cut_cells, figures.area);
		                return ++frames < 8; // false ends the sweep
	                });
	if (!swept)
		return std::fprintf(stderr, "%s\n", swept.error().message.c_str()), 1;
	std::printf("%d frames were looked at\n", frames);
	return 0;
}
