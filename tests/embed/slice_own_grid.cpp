// Cuts a grid that this program has in memory. Its arrays are shared, not copied.
#include <vprobe/vprobe.h>

#include <cmath>
#include <cstdio>

int main()
{
	constexpr std::size_t n = 33;
	std::vector<float> temperature;
	for (std::size_t k = 0; k < n; ++k)
		for (std::size_t j = 0; j < n; ++j)
			for (std::size_t i = 0; i < n; ++i)
				temperature.push_back(static_cast<float>(std::hypot(i, j, k)));
	const vprobe::Image3 grid{.points = {n, n, n}, .spacing = {0.1, 0.1, 0.1}};
	const auto data = vprobe::Dataset::wrap({{grid, {{"temperature", vprobe::Association::point, 1, temperature}}}});
	if (!data)
		return std::fprintf(stderr, "%s\n", data.error().message.c_str()), 1;

	const auto cut = data->cut(vprobe::View().normal({0.3, 0.5, 0.8}));
	if (!cut)
		return std::fprintf(stderr, "%s\n", cut.error().message.c_str()), 1;
	const vprobe::Mesh mesh = cut->mesh(0);
	const vprobe::Figures figures = cut->figures(0);
	std::printf("%zu polygons, area %.4f, mean %.4f\n", mesh.polygonCount(), figures.area, *figures.mean);
	const vprobe::MeshArray* values = mesh.array("temperature");
	std::printf("the first point: %.3f at %.3f %.3f %.3f\n", values->value(0), mesh.points()[0], mesh.points()[1],
	            mesh.points()[2]);
	return 0;
}
