#include "probe/probe_file.h"

#include "grid/field_choice.h"
#include "probe/json_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::probe
{

namespace
{

using nlohmann::json;

Fx fxOf(const JsonReader& reader)
{
	reader.expectKeys({"magnification", "pan"});
	Fx fx;
	if (const auto magnification = reader.find("magnification"))
	{
		fx.magnification = magnification->number();
		if (fx.magnification < kMinMagnification || fx.magnification > kMaxMagnification)
			magnification->refuse(fmt::format("{} is not between {} and {}; 1 shows the content as it is",
			                                  fx.magnification, kMinMagnification, kMaxMagnification));
	}
	if (const auto pan = reader.find("pan"))
		fx.pan = pan->vector();
	return fx;
}

// One divided by it is a number too.
constexpr double kSmallestWindow = 1e-100;

double sizeOf(const JsonReader& reader)
{
	const double size = reader.length();
	if (size < kSmallestWindow)
		reader.refuse(fmt::format("{} is no size; give a number above 0", size));
	return size;
}

std::pair<double, double> sidesOf(const JsonReader& reader)
{
	const std::pair<double, double> sides = reader.ascending();
	if (reader.at(1).length() - reader.at(0).length() < kSmallestWindow)
		reader.refuse("too narrow for a window; give numbers that are farther apart");
	return sides;
}

// [W, H], centered, or the rectangle's sides.
Window windowOf(const JsonReader& reader)
{
	if (reader.isObject())
	{
		reader.expectKeys({"x", "y"});
		const auto [x0, x1] = sidesOf(reader["x"]);
		const auto [y0, y1] = sidesOf(reader["y"]);
		return {x0, x1, y0, y1};
	}
	if (!reader.isArray())
		reader.refuse("a window is [W, H] or {\"x\": [x0, x1], \"y\": [y0, y1]}; give one of them");
	reader.expectArray(2, 2, "numbers");
	return centeredWindow(sizeOf(reader.at(0)), sizeOf(reader.at(1)));
}

int componentOf(const JsonReader& reader)
{
	constexpr int kMaxComponent = (1 << 16) - 1;
	if (!reader.isString())
		return reader.whole(0, kMaxComponent);
	const std::optional<int> component = grid::parseComponent(reader.text());
	if (!component || *component > kMaxComponent)
		reader.refuse("not a component; use \"magnitude\", \"x\", \"y\", \"z\" or a number from 0");
	return *component;
}

SheetWishes wishesOf(const JsonReader& reader)
{
	SheetWishes wishes;
	if (const auto opacity = reader.find("opacity"))
	{
		wishes.opacity = opacity->number();
		if (*wishes.opacity < 0.0 || *wishes.opacity > 1.0)
			opacity->refuse(
			    fmt::format("{} is not between 0 and 1; 0 is clear, 1 hides what lies behind", *wishes.opacity));
	}
	if (const auto array = reader.find("array"))
		wishes.array = array->text();
	if (const auto component = reader.find("component"))
		wishes.component = componentOf(*component);
	if (const auto colormap = reader.find("colormap"))
		wishes.colormap = colormap->text();
	if (const auto range = reader.find("range"))
		wishes.range = range->ascending();
	if (const auto lines = reader.find("lines"))
		wishes.lines = lines->whole(0, kMaxLines);
	if (const auto hidden = reader.find("hidden"))
		wishes.hidden = hidden->flag();
	return wishes;
}

surface::ImplicitSurface formOf(const JsonReader& reader, const Fx& fx)
{
	if (fx != Fx())
		reader.refuse("fx magnifies planes; leave one of the two out");
	Result<surface::ImplicitSurface> form = surface::ImplicitSurface::parse(reader.text());
	if (!form)
		reader.refuse(form.error().message);
	return *form;
}

Sheet sheetOf(const JsonReader& reader)
{
	reader.expectKeys({"to_sheet", "fx", "window", "surface", "opacity", "array", "component", "colormap", "range",
	                   "lines", "hidden"});
	Sheet sheet;
	if (const auto to_sheet = reader.find("to_sheet"))
		static_cast<Frame&>(sheet) = to_sheet->frame();
	if (const auto fx = reader.find("fx"))
		sheet.fx = fxOf(*fx);
	if (const auto window = reader.find("window"))
		sheet.window = windowOf(*window);
	if (const auto form = reader.find("surface"))
		sheet.form = formOf(*form, sheet.fx);
	sheet.wishes = wishesOf(reader);
	return sheet;
}

ProbeFile probeOf(const JsonReader& reader)
{
	reader.expectKeys({"$schema", "name", "to_probe", "sheets"});
	ProbeFile file;
	if (const auto name = reader.find("name"))
		file.probe.name = name->text();
	if (const auto to_probe = reader.find("to_probe"))
	{
		file.probe.frame = to_probe->frame();
		file.placed = true;
	}
	const JsonReader sheets = reader["sheets"];
	sheets.expectArray(1, kMaxSheets, "sheets");
	for (std::size_t s = 0; s < sheets.size(); ++s)
		file.probe.sheets.push_back(sheetOf(sheets.at(s)));
	return file;
}

json sheetJson(const Sheet& sheet)
{
	json value{{"to_sheet", toJson(static_cast<const Frame&>(sheet))}};
	// Beside a form it shows nothing, and would not be read again.
	if (sheet.fx != Fx() && !sheet.form)
		value["fx"] = {{"magnification", sheet.fx.magnification}, {"pan", toJson(sheet.fx.pan)}};
	if (const auto& window = sheet.window)
		value["window"] = {{"x", {window->x0, window->x1}}, {"y", {window->y0, window->y1}}};
	if (sheet.form)
		value["surface"] = sheet.form->text();
	const SheetWishes& wishes = sheet.wishes;
	const auto put = [&](const char* key, const auto& wish)
	{
		if (wish)
			value[key] = *wish;
	};
	put("opacity", wishes.opacity);
	put("array", wishes.array);
	if (wishes.component)
		value["component"] = grid::componentText(*wishes.component);
	put("colormap", wishes.colormap);
	put("range", wishes.range);
	put("lines", wishes.lines);
	if (wishes.hidden)
		value["hidden"] = true;
	return value;
}

} // namespace

Result<ProbeFile> probeFromJson(const json& value, const std::string& source, const std::string& path)
{
	return readDocument<ProbeFile>(value, source, path, probeOf);
}

Result<ProbeFile> parseProbe(std::string_view text, const std::string& source)
{
	const Result<json> document = parseJson(text, source);
	if (!document)
		return document.error();
	return probeFromJson(*document, source, "");
}

Result<ProbeFile> readProbe(const std::string& file)
{
	return readFile<ProbeFile>(file, parseProbe);
}

json toJson(const Probe& probe)
{
	json value{{"to_probe", toJson(probe.frame)}, {"sheets", json::array()}};
	if (!probe.name.empty())
		value["name"] = probe.name;
	for (const Sheet& sheet : probe.sheets)
		value["sheets"].push_back(sheetJson(sheet));
	return value;
}

std::string probeText(const Probe& probe)
{
	return jsonText(toJson(probe));
}

} // namespace vp::probe
