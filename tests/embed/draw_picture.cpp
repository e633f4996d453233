// Draws a file, or a built-in data set, cut by a paddlewheel of vanes that can be looked through.
#include <vprobe/vprobe.h>

#include <cstdio>

int main(int count, char** words)
{
	if (count != 3)
		return std::fprintf(stderr, "usage: draw_picture FILE PICTURE.png\n"), 1;
	const vprobe::MessageListener messages([](std::string_view line)
	                                       { std::fprintf(stderr, "%.*s\n", int(line.size()), line.data()); });
	const auto data = vprobe::Dataset::open(words[1]);
	if (!data)
		return std::fprintf(stderr, "%s\n", data.error().message.c_str()), 1;

	vprobe::View view;
	view.shape(vprobe::ProbeShape::paddlewheel).vanes(4).normal({0.3, 0.5, 0.8}).opacity(0.7).size(640, 400);
	if (const auto set = view.set("axes", "box"); !set) // any setting has a key
		return std::fprintf(stderr, "%s\n", set.error().message.c_str()), 1;
	const auto picture = data->render(view);
	if (!picture)
		return std::fprintf(stderr, "%s\n", picture.error().message.c_str()), 1;
	if (const auto saved = picture->save(words[2]); !saved)
		return std::fprintf(stderr, "%s\n", saved.error().message.c_str()), 1;
	std::printf("%u x %u pixels in %s\n", picture->width, picture->height, words[2]);
	return 0;
}
