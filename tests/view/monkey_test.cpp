#include "desktop.h"
#include "interact/bindings.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <random>

namespace view
{

namespace
{

using vp::interact::Action;
using vp::interact::Binding;

// These actions are left out: they would end the window, write files that the test does not check, or keep a film loop,
// whose pictures take more and more memory.
bool isLeftOut(Action action)
{
	switch (action)
	{
	case Action::quit:
	case Action::record:
	case Action::save_state:
	case Action::save_state_as:
	case Action::save_picture:
	case Action::save_film:
	case Action::save_slice:
	case Action::save_color_map:
		return true;
	default:
		return false;
	}
}

// xdotool's names of keys that it does not call as we do.
std::string keyNameOf(const Binding& binding)
{
	static const std::map<std::string, std::string> kOthers{
	    {"PageUp", "Prior"}, {"PageDown", "Next"}, {"Space", "space"},   {"Enter", "Return"},
	    {",", "comma"},      {".", "period"},      {"[", "bracketleft"}, {"]", "bracketright"},
	    {"=", "equal"},      {"+", "plus"},        {"-", "minus"},       {"?", "question"}};
	const std::string name = vp::interact::nameOf({binding.chord.key, false, false, false});
	std::string keys = std::string(binding.chord.ctrl ? "ctrl+" : "") + (binding.chord.shift ? "shift+" : "") +
	                   (binding.chord.alt ? "alt+" : "");
	if (const auto other = kOthers.find(name); other != kOthers.end())
		return keys + other->second;
	return keys + (name.size() == 1 ? std::string(1, static_cast<char>(std::tolower(name[0]))) : name);
}

// Hands, keys and sizes at random; the same for the same seed.
class Monkey
{
public:
	explicit Monkey(std::uint32_t seed) : random_(seed)
	{
		for (const Binding& binding : vp::interact::bindings())
			if (!isLeftOut(binding.action))
				keys_.push_back(keyNameOf(binding));
	}

	// A script of so many deeds.
	std::string script(int deeds)
	{
		std::string text;
		for (int i = 0; i < deeds; ++i)
			text += deed() + "sleep 0.01\n";
		return text + "keyup ctrl\nkeyup shift\nkeyup alt\nmouseup 1\nmouseup 2\nmouseup 3\n";
	}
	glm::ivec2 size() { return {640 + number(700), 400 + number(480)}; }

private:
	int number(int below) { return static_cast<int>(random_() % static_cast<std::uint32_t>(below)); }

	std::string move()
	{
		return "mousemove " + std::to_string(number(Size::kWidth)) + " " + std::to_string(number(Size::kHeight)) + "\n";
	}
	std::string drag()
	{
		const std::string button = std::to_string(1 + number(3)) + "\n";
		std::string text = move() + "mousedown " + button;
		for (int steps = number(8); steps >= 0; --steps)
			text += move() + "sleep 0.01\n";
		return text + "mouseup " + button;
	}
	std::string deed()
	{
		switch (number(5))
		{
		case 0:
			return move();
		case 1:
			return drag();
		case 2:
			return move() + "click --repeat " + std::to_string(1 + number(4)) + (number(2) ? " 4\n" : " 5\n");
		case 3:
			return "keydown " + std::string(modifier()) + drag() + "keyup " + modifier_ + "\n";
		default:
			return "key " + keys_[static_cast<std::size_t>(number(static_cast<int>(keys_.size())))] + "\n";
		}
	}
	std::string modifier()
	{
		modifier_ = std::array{"ctrl", "shift", "alt"}[static_cast<std::size_t>(number(3))];
		return modifier_ + "\n";
	}

	struct Size
	{
		static constexpr int kWidth = 1300;
		static constexpr int kHeight = 850;
	};
	std::mt19937 random_;
	std::vector<std::string> keys_;
	std::string modifier_;
};

std::uint32_t seedOfTheRun()
{
	const char* given = std::getenv("VPROBE_MONKEY_SEED");
	return given ? static_cast<std::uint32_t>(std::strtoul(given, nullptr, 10)) : 20'261'121u;
}

// Pictures of the largest window, of 16 sheets, come and go; what leaks with each of hundreds of deeds is far more.
constexpr std::size_t kMaxGrowth = std::size_t(160) << 20;

} // namespace

class MonkeyAtTheWindow : public Desktop, public testing::WithParamInterface<int> // seconds
{
};

TEST_P(MonkeyAtTheWindow, DoesNoHarm)
{
	const std::uint32_t seed = seedOfTheRun();
	RecordProperty("seed", static_cast<int>(seed));
	std::printf("VPROBE_MONKEY_SEED=%u repeats this\n", seed);
	Monkey monkey(seed);
	const cli::Arguments input{"demo:shell:32", "--normal", "0.3", "0.5", "0.8"};
	open(input);
	constexpr int kDeeds = 60;
	const auto start = std::chrono::steady_clock::now();
	const auto passed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
	std::size_t warm = 0;
	double warm_from = 0.4 * GetParam();
	do
	{
		xdotool(monkey.script(kDeeds));
		if (!program().runs()) // it has found Quit in the menu
		{
			ASSERT_EQ(program().waitFor(kPatience), 0) << err();
			std::filesystem::remove(path("commands"));
			open(input);
			warm = 0;
			warm_from = passed() + 0.4 * (GetParam() - passed());
		}
		const glm::ivec2 size = monkey.size();
		xdotool("windowsize " + window() + " " + std::to_string(size.x) + " " + std::to_string(size.y) + "\n");
		if (warm == 0 && passed() > warm_from)
			warm = program().residentBytes();
	} while (passed() < GetParam());

	// It answers. (Nobody waits for it to rest: a sweep may be playing.)
	EXPECT_TRUE(state().is_object());
	const std::size_t after = program().residentBytes();
	EXPECT_TRUE(warm == 0 || after < warm + kMaxGrowth) << "memory grew from " << warm << " to " << after << " bytes";
	std::printf("resident: %zu MiB after the warm-up, %zu MiB at the end\n", warm >> 20, after >> 20);
	close(err()); // what a key could not do is told
}

INSTANTIATE_TEST_SUITE_P(Seconds, MonkeyAtTheWindow, testing::Values(VPROBE_MONKEY_SECONDS));

} // namespace view
