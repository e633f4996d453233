#pragma once

#include "interact/bindings.h"
#include "interact/history.h"
#include "interact/view.h"
#include "view/artist.h"
#include "view/facts.h"
#include "view/loader.h"
#include "view/view_state.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// A line for the user, shown for a while.
struct Notice
{
	std::string words;
	bool is_error = false;
	Moment since{};
};

// What of the window is open. None of it is the state's: it says nothing about the picture.
struct OpenParts
{
	bool panels = true;
	bool handles = true;
	bool magnifier = false;
	bool plane_pane = false;
	bool profile = false;
	bool help = false;
	bool dark = true;
	bool full_screen = false;
	bool plays_times = false;
};

// A question that waits for its answer.
enum class Question
{
	none,
	open,
	save_state,
	save_picture,
	save_film,
	save_slice
};

// All of a viewer but its window: the state and its history, the data, the artist. Panels and the hand read it and call
// it, on the window's thread.
class Workbench
{
public:
	Workbench(ViewState state, std::shared_ptr<gpu::Device> device, std::function<void()> wake);

	// --- The state. Each change is a step of the history; those with the same key, until endMerge(), are one.
	const ViewState& state() const { return history_.state(); }
	using Edit = std::function<void(ViewState&)>;
	void change(const std::string& label, const Edit& edit, const std::string& merge = {});
	void endMerge() { history_.endMerge(); }
	const interact::History<ViewState>& history() const { return history_; }

	probe::Probe probe() const; // as the state has it; without sheets before anything is loaded
	void setProbe(const std::string& label, const probe::Probe& probe, const std::string& merge = {});
	std::size_t sheet() const { return sheet_; } // the one that keys and panels mean
	void chooseSheet(std::size_t sheet);
	void setCamera(const std::string& label, const render::Camera& camera, const std::string& merge = {});
	std::optional<interact::View> view() const; // what is seen: the last picture's

	void perform(interact::Action action);

	// --- The data.
	// Loads them beside what is shown, which stays where they fail. One .json file is a state.
	void open(std::vector<std::string> inputs);
	void reload();
	const Loader& loader() const { return loader_; }
	void cancelLoading();
	int timeStep() const; // the one of the input's times that the state means
	void showTime(int step, const std::string& merge = {});
	const Facts::Array* shownArray() const; // the state's; null without arrays
	const std::optional<Facts>& facts() const { return facts_; }

	// --- The picture.
	// Once a frame, and after input: hands on what has changed. size: of the part of the window that shows the scene.
	void update(VkExtent2D size);
	void noteInput(Moment when); // what follows answers it
	const std::shared_ptr<const Shown>& shown() const { return shown_; }
	bool isIdle() const;
	bool isShown() const; // what is shown is of the state as it is

	// --- The window.
	OpenParts parts;
	Question question = Question::none;
	const std::vector<Notice>& notices() const { return notices_; }
	void notify(std::string words, bool is_error = false);
	void notify(const Error& error) { notify(error.message, true); }
	void dismiss(const std::string& words);
	bool wantsToQuit() const { return quits_; }
	void quit() { quits_ = true; }

private:
	void stateChanged();
	void takeLoaded();
	void takePicture();
	void ask(VkExtent2D size);
	void forgetOldNotices();

	// One group of actions each; false where it is none of theirs.
	bool performOnWindow(interact::Action action);
	bool performOnProbe(interact::Action action);
	bool performOnSheets(interact::Action action);
	bool performOnView(interact::Action action);
	bool performOnLook(interact::Action action);
	void setPreset(const char* name);
	void show(const render::Camera& camera, const char* label);
	void stepArray(int by);
	void stepTime(int by);

	interact::History<ViewState> history_;
	std::size_t sheet_ = 0;
	std::optional<Facts> facts_;
	std::shared_ptr<const Shown> shown_;
	std::vector<Notice> notices_;
	bool quits_ = false;

	std::uint64_t version_ = 1; // of all that a picture depends on
	std::uint64_t asked_ = 0;   // the version that was asked for last
	VkExtent2D asked_size_{};
	std::optional<Moment> input_; // the oldest that was not asked for yet
	bool takes_camera_ = true;    // the state's camera is to become the next picture's

	Loader loader_;
	Artist artist_;
};

} // namespace vp::app
