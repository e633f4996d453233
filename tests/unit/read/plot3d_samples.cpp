#include "plot3d_samples.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace
{

constexpr std::array<std::array<int, 3>, 2> kBlocks = {{{5, 14, 3}, {3, 4, 6}}}; // whose part fits no other layout

// One file, made record by record.
class Plot3dFile
{
public:
	explicit Plot3dFile(const Plot3dForm& form) : form_(form) {}

	void integer(int value) { form_.binary ? raw(value) : word(std::to_string(value)); }
	void real(double value)
	{
		if (!form_.binary)
			word(std::to_string(value));
		else if (form_.doubles)
			raw(value);
		else
			raw(static_cast<float>(value));
	}
	void endRecord()
	{
		const std::string record = std::move(record_);
		record_.clear();
		if (form_.binary && form_.byte_counts)
		{
			raw(static_cast<int>(record.size()));
			text_ += record_ + record + record_;
			record_.clear();
		}
		else
			text_ += record;
	}
	void write(const std::string& path) const { writeContents(path, text_); }

private:
	template <class T>
	void raw(T value)
	{
		std::array<char, sizeof(T)> bytes;
		std::memcpy(bytes.data(), &value, sizeof(T));
		if (form_.big_endian)
			std::reverse(bytes.begin(), bytes.end());
		record_.append(bytes.data(), bytes.size());
	}
	void word(const std::string& text) { record_ += text + "\n"; }

	Plot3dForm form_;
	std::string text_;
	std::string record_;
};

vp::Vec3 pointOf(int block, int i, int j, int k)
{
	return {1 + i + 0.25 * j, j + 0.125 * k, k + 10.0 * block}; // density must not vanish
}

template <class Visit>
void forEachPoint(int block, Visit&& visit)
{
	for (int k = 0; k < kBlocks[block][2]; ++k)
		for (int j = 0; j < kBlocks[block][1]; ++j)
			for (int i = 0; i < kBlocks[block][0]; ++i)
				visit(pointOf(block, i, j, k));
}

void writeHeader(Plot3dFile& file, const Plot3dForm& form, int blocks)
{
	if (form.multi_grid)
	{
		file.integer(blocks);
		file.endRecord();
	}
	for (int b = 0; b < blocks; ++b)
		for (const int n : kBlocks[b])
			file.integer(n);
	file.endRecord();
}

} // namespace

void writePlot3d(const std::string& grid, const std::string& solution, const Plot3dForm& form)
{
	const int blocks = form.multi_grid ? 2 : 1;
	Plot3dFile xyz(form);
	writeHeader(xyz, form, blocks);
	for (int b = 0; b < blocks; ++b)
	{
		for (int axis = 0; axis < 3; ++axis)
			forEachPoint(b, [&](const vp::Vec3& point) { xyz.real(point[axis]); });
		if (form.blanking)
			forEachPoint(b, [&](const vp::Vec3&) { xyz.integer(1); });
		xyz.endRecord();
	}
	xyz.write(grid);

	Plot3dFile q(form);
	writeHeader(q, form, blocks);
	for (int b = 0; b < blocks; ++b)
	{
		for (const double condition : {2.0, 0.0, 1e4, 0.5}) // Mach number, angle, Reynolds number, time
			q.real(condition);
		q.endRecord();
		forEachPoint(b, [&](const vp::Vec3& point) { q.real(sampleValue(point)); });
		for (int quantity = 0; quantity < 4; ++quantity)
			forEachPoint(b, [&](const vp::Vec3& point) { q.real(quantity + point.x); });
		q.endRecord();
	}
	q.write(solution);
}

std::vector<SampleFile> plot3dSamples()
{
	std::vector<SampleFile> files;
	const auto add = [&](const std::string& name, const Plot3dForm& form)
	{
		const std::string solution = name.substr(0, name.rfind('.')) + ".q";
		const auto write = [form, solution](const std::string& path)
		{ writePlot3d(path, (std::filesystem::path(path).parent_path() / solution).string(), form); };
		const bool two = form.multi_grid;
		files.push_back(
		    {name, write, two ? "block-structured" : "curvilinear", two ? 134u : 104u, two ? 282u : 210u, false, ""});
	};
	add("c.xyz", {});
	add("big.xyz", {.big_endian = true});
	add("fortran.xyz", {.big_endian = true, .byte_counts = true, .multi_grid = true});
	add("doubles.g", {.byte_counts = true, .multi_grid = true, .doubles = true});
	add("blanked.p3d", {.multi_grid = true, .blanking = true});
	add("ascii.x", {.binary = false});
	add("ascii_multi.xyz", {.binary = false, .multi_grid = true});
	return files;
}
