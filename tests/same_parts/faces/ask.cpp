// Asks the library for plans, and prints and saves what it answers. ask.py does the same through the Python module.
// usage: ask PLANS.txt INPUT cpu|gpu
// A plan is a line `plan NAME`, lines `set KEY VALUE`, and a line `ask` or `draw` or both.
#include <vprobe/vprobe.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace
{

std::string plan_name;
int plan_number = 0;

template <class... T>
void tell(const char* format, T... values)
{
	std::printf("[%s] ", plan_name.c_str());
	std::printf(format, values...);
	std::printf("\n");
}

void tellError(const char* what, const vprobe::Error& error)
{
	tell("%s: error %d: %s", what, static_cast<int>(error.kind), error.message.c_str());
}

// FNV-1a.
class Digest
{
public:
	template <class T>
	void add(std::span<const T> values)
	{
		addBytes(reinterpret_cast<const unsigned char*>(values.data()), values.size_bytes());
	}
	void addBytes(const unsigned char* bytes, std::size_t count)
	{
		for (std::size_t i = 0; i < count; ++i)
			value_ = (value_ ^ bytes[i]) * 1099511628211u;
	}
	unsigned long long value() const { return value_; }

private:
	unsigned long long value_ = 14695981039346656037u;
};

void tellMesh(const char* what, const vprobe::Mesh& mesh)
{
	Digest shape;
	shape.add(mesh.points());
	shape.add(mesh.offsets());
	shape.add(mesh.connectivity());
	Digest sources;
	sources.add(mesh.cells());
	sources.add(mesh.blocks());
	tell("%s: %zu polygons, %zu points, shape %016llx, cells %016llx", what, mesh.polygonCount(), mesh.pointCount(),
	     shape.value(), sources.value());
	for (const vprobe::MeshArray& array : mesh.arrays())
	{
		Digest values;
		for (std::size_t tuple = 0; tuple < array.tuples; ++tuple)
			for (int component = 0; component < array.components; ++component)
			{
				const double value = array.value(tuple, component);
				values.add(std::span(&value, 1));
			}
		tell("%s: array %s of %zu, %016llx", what, array.name.c_str(), array.tuples, values.value());
	}
}

void tellFigures(const vprobe::Figures& f)
{
	const auto number = [](const char* what, const std::optional<double>& value)
	{ value ? tell("figures: %s %.17g", what, *value) : tell("figures: no %s", what); };
	tell("figures: area %.17g, boundary area %.17g, area of NaN %.17g", f.area, f.boundary_area, f.nan_area);
	number("mean", f.mean);
	number("min", f.min);
	number("max", f.max);
	number("flux", f.flux);
	number("boundary mean", f.boundary_mean);
	number("boundary flux", f.boundary_flux);
	tell("figures: %zu components, %zu cells", f.components, f.cut_cells);
}

void tellCut(const vprobe::Cut& cut, const std::string& file)
{
	for (std::size_t sheet = 0; sheet < cut.sheetCount(); ++sheet)
	{
		const vprobe::Vector3 origin = cut.origin(sheet);
		const vprobe::Vector3 normal = cut.normal(sheet);
		tell("sheet %zu: at %.17g %.17g %.17g, normal %.17g %.17g %.17g", sheet, origin[0], origin[1], origin[2],
		     normal[0], normal[1], normal[2]);
		tellMesh("sheet", cut.mesh(sheet));
		tellFigures(cut.figures(sheet));
		const vprobe::Traces traces = cut.traces(sheet);
		Digest paths;
		paths.add(std::span<const double>(traces.points));
		paths.add(std::span<const double>(traces.times));
		tell("traces: %zu numbers, %016llx", traces.points.size(), paths.value());
	}
	for (std::size_t contour = 0; contour < cut.contourCount(); ++contour)
		tellMesh("contour", cut.contour(contour));
	if (const auto saved = cut.save(file); !saved)
		tellError("save", saved.error());
}

void tellPlan(const char* what, const vprobe::Dataset& data, const vprobe::View& view)
{
	const auto rows = data.plan(view);
	if (!rows)
		return tellError(what, rows.error());
	for (const vprobe::PlanRow& row : *rows)
		tell("%s: sheet %zu, block %zu: %s on %s, %s", what, row.sheet, row.block, row.strategy.c_str(),
		     row.classifier.c_str(), row.reason.c_str());
}

void tellImage(const vprobe::Image& image)
{
	Digest pixels;
	pixels.add(std::span<const std::uint8_t>(image.rgba));
	tell("picture: %u x %u, %016llx", image.width, image.height, pixels.value());
}

vprobe::Result<vprobe::Dataset> opened(const std::string& source, vprobe::Classify classify)
{
	vprobe::OpenOptions options;
	options.classify = classify;
	return vprobe::Dataset::open(source, options);
}

// Cuts twice, since the second cut may go another way.
void ask(const vprobe::Dataset& data, const vprobe::View& view)
{
	const std::string name = std::to_string(++plan_number);
	if (const auto fits = view.check(); !fits)
		tellError("check", fits.error());
	tell("state: %s", view.json().c_str());
	tellPlan("first plan", data, view);
	for (const char* which : {"first", "second"})
		if (const auto cut = data.cut(view); cut)
			tellCut(*cut, name + which + ".vtp");
		else
			tellError(which, cut.error());
	tellPlan("second plan", data, view);
}

void draw(const vprobe::Dataset& data, vprobe::View view)
{
	view.size(96, 64);
	if (const auto image = data.render(view); image)
		tellImage(*image);
	else
		tellError("render", image.error());
	for (const auto& [key, value] : {std::pair("frames", "2"), std::pair("samples", "1")})
		if (const auto set = view.set(key, value); !set)
			tellError(key, set.error());
	const auto on_frame = [](const vprobe::SweepFrame& frame)
	{
		tell("frame %d of %d", frame.index, frame.count);
		for (std::size_t sheet = 0; sheet < frame.cut.sheetCount(); ++sheet)
			tellMesh("sheet", frame.cut.mesh(sheet));
		tellImage(frame.image);
		return true;
	};
	if (const auto swept = data.sweep(view, on_frame, true); !swept)
		tellError("sweep", swept.error());
}

} // namespace

int main(int count, char** words)
{
	if (count != 4)
		return std::fprintf(stderr, "usage: ask PLANS.txt INPUT cpu|gpu\n"), 1;
	const vprobe::MessageListener messages([](std::string_view line)
	                                       { tell("message: %.*s", static_cast<int>(line.size()), line.data()); });
	std::ifstream plans(words[1]);
	const auto classify = std::string(words[3]) == "gpu" ? vprobe::Classify::gpu : vprobe::Classify::cpu;
	// Pictures share a device, since it takes its time to open.
	const auto drawn = opened(words[2], classify);
	if (!drawn)
		return std::fprintf(stderr, "%s\n", drawn.error().message.c_str()), 1;
	vprobe::View view;
	for (std::string line; std::getline(plans, line);)
	{
		const std::string rest = line.substr(std::min(line.find(' ') + 1, line.size()));
		if (line.starts_with("plan"))
		{
			plan_name = rest;
			view = {};
		}
		else if (line.starts_with("set "))
		{
			const std::size_t blank = rest.find(' ');
			if (const auto set = view.set(rest.substr(0, blank), rest.substr(blank + 1)); !set)
				tellError("set", set.error());
		}
		else if (line == "ask")
			ask(*opened(words[2], classify), view);
		else if (line == "draw")
			draw(*drawn, view);
	}
	return 0;
}
