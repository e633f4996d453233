#include "render/annotate/titles.h"

namespace vp::render
{

namespace
{

// Signs in numbers, beyond the letters that the font always has.
constexpr const char* kSigns = "\u2212×⁰¹²³⁴⁵⁶⁷⁸⁹⁻";

} // namespace

void writeTitles(const Look& look, const Layout& layout, Canvas& pen)
{
	if (!look.title.empty())
		pen.text(layout.title.lo, layout.title_em, pen.inks().text,
		         pen.lettering().elided(look.title, layout.title_em, layout.title.size().x));
	if (!look.caption.empty())
		pen.text(layout.caption.lo, layout.small_em, pen.inks().faint,
		         pen.lettering().elided(look.caption, layout.small_em, layout.caption.size().x));
}

std::vector<std::string> writtenTexts(const Look& look, const std::vector<LegendContent>& legends)
{
	std::vector<std::string> texts{look.title, look.caption, look.length_units, kSigns};
	for (const LegendContent& legend : legends)
	{
		texts.push_back(legend.title);
		for (const Category& category : legend.style.colors->categories)
			texts.push_back(category.name);
	}
	return texts;
}

} // namespace vp::render
