#include "verify/report_page.h"

#include "version.h"
#include "write/xml_text.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace vp::app
{

namespace
{

using write::xmlText;

// RFC 4648, section 4.
std::string base64(const std::string& bytes)
{
	static constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	std::string text;
	text.reserve((bytes.size() + 2) / 3 * 4);
	for (std::size_t i = 0; i < bytes.size(); i += 3)
	{
		const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
		std::uint32_t bits = 0;
		for (std::size_t k = 0; k < 3; ++k)
			bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
		for (std::size_t k = 0; k < 4; ++k)
			text += k <= count ? kLetters[bits >> (18 - 6 * k) & 63] : '=';
	}
	return text;
}

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<title>vprobe verify</title>
<style>
body { font: 15px/1.5 sans-serif; margin: 2em; color: #222; background: #fff }
table { border-collapse: collapse }
th, td { text-align: left; padding: .2em 1em .2em 0; border-bottom: 1px solid #ddd; vertical-align: top }
.differs, .error { color: #a40000; font-weight: bold }
.updated { color: #7a5200 }
.passed { color: #1c6b1c }
figure { display: inline-block; margin: 0 1em 1em 0; width: 30% }
figure img { width: 100%; border: 1px solid #999;
	background: repeating-conic-gradient(#ddd 0 25%, #fff 0 50%) 0 0 / 16px 16px }
.over { position: relative; width: 62% }
.over img + img { position: absolute; left: 0; top: 0; clip-path: inset(0 50% 0 0) }
.over input { width: 100% }
</style>
)";

std::string image(const std::string& png, const char* title)
{
	return fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">", title, base64(png));
}

std::string figure(const std::string& png, const char* title)
{
	return png.empty() ? std::string()
	                   : fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", image(png, title), title);
}

// Both pictures one over the other, with a slider between them.
std::string slider(const Judgment& one)
{
	if (one.difference_png.empty())
		return {};
	return fmt::format("<figure class=\"over\"><div style=\"position: relative\">{}{}</div><input type=\"range\" "
	                   "aria-label=\"expected or drawn\" oninput=\"this.parentNode.querySelectorAll('img')[1].style."
	                   "clipPath='inset(0 '+(100-this.value)+'% 0 0)'\"><figcaption>drawn on the left, expected on the "
	                   "right</figcaption></figure>\n",
	                   image(one.expected_png, "expected"), image(one.drawn_png, "drawn"));
}

std::string movedTable(const std::vector<MovedFigure>& moved)
{
	if (moved.empty())
		return {};
	std::string rows = "<table><tr><th>figure<th>expected<th>drawn<th>tolerance</tr>\n";
	for (const MovedFigure& one : moved)
		rows += fmt::format("<tr><td>{}<td>{}<td>{}<td>{}</tr>\n", xmlText(one.place), xmlText(one.expected),
		                    xmlText(one.drawn), xmlText(one.why));
	return rows + "</table>\n";
}

} // namespace

std::string reportPage(const std::vector<Judgment>& judgments)
{
	std::string page = kHead;
	page += fmt::format("<h1>vprobe {} verify</h1>\n<table><tr><th>verdict<th>file<th>how far<th>device<th>driver"
	                    "<th>seconds</tr>\n",
	                    kVersion);
	for (const Judgment& one : judgments)
		page +=
		    fmt::format("<tr><td class=\"{0}\">{0}<td>{1}<td>{2}<td>{3}<td>{4}<td>{5:.3f}</tr>\n", word(one.verdict),
		                xmlText(one.file), xmlText(one.detail), xmlText(one.device), xmlText(one.driver), one.seconds);
	page += "</table>\n";
	for (const Judgment& one : judgments)
		if (!one.expected_png.empty() || !one.moved.empty())
			page +=
			    fmt::format("<h2>{}</h2>\n<p>{}</p>\n{}{}{}{}{}", xmlText(one.file), xmlText(one.detail),
			                figure(one.expected_png, "expected"), figure(one.drawn_png, "drawn"),
			                figure(one.difference_png, "difference, eightfold"), slider(one), movedTable(one.moved));
	return page + "</html>\n";
}

} // namespace vp::app
