#pragma once

#include "interact/bindings.h"
#include "sweep/exposure.h"
#include "viewer/cutting/render_thread.h"
#include "viewer/document/file_jobs.h"
#include "viewer/document/film_loop.h"
#include "viewer/document/sweep_player.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace vp::app
{

class Document;

// Plays the sweep in a window, and records a film loop of it. It moves the document's probe from frame to frame. Used
// by the window's thread only.
class Playback
{
public:
	// A film loop that is being recorded.
	struct Recording
	{
		std::shared_ptr<FilmLoop> film;
		int ordered = 0;
		PictureRequest like; // the size and the look of its pictures
	};

	// All arguments outlive this object.
	Playback(Document& document, RenderThread& render_thread, FileJobs& jobs, std::function<void()> wake);

	bool perform(interact::Action action); // returns false for an action that does not belong to a sweep
	void update();                         // once a frame
	void forgetFilm();                     // call this when the data change

	bool isPlaying() const { return path_.player.playing(seconds()); }
	int frame() const { return path_.player.frameAt(seconds()); }
	int frames() const { return path_.player.frames(); }
	void seek(int frame);
	bool loops() const { return path_.player.loops(); }
	bool hasExposure() const { return exposure_ != nullptr; }
	const std::optional<Recording>& recording() const { return recording_; }
	const std::shared_ptr<const FilmLoop>& film() const { return film_; } // a complete film loop, or null
	// The picture of the film loop to show instead of the scene, or null to show the scene.
	std::shared_ptr<const render::Picture> filmPicture() const;
	void saveFilm(const std::string& file); // a film, or pictures if the name contains {frame}
	void saveExposure(const std::string& file);

private:
	struct Mail;

	double seconds() const; // the sweep's clock
	Status followSweep();
	bool canSweep();
	void play();
	void setSpeed(double factor);
	void record();
	void cancelRecording();
	void orderFrames();
	bool filmIsGood() const;

	Document& document_;
	RenderThread& render_thread_;
	FileJobs& jobs_;
	std::function<void()> wake_;
	std::shared_ptr<Mail> mail_;
	SweepPlayer path_;
	std::optional<Recording> recording_;
	std::shared_ptr<const FilmLoop> film_;
	PictureRequest film_like_;
	std::shared_ptr<const render::Picture> exposure_;
};

} // namespace vp::app
