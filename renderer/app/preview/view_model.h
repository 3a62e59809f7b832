// SPDX-License-Identifier: MIT
#pragma once

#include <nori/bitmap.h>

#include <optional>
#include <string>
#include <vector>

#include <preview/coloring.h>
#include <preview/image_summary.h>
#include <preview/render_job.h>

namespace preview {

/// A moment of a render, and how far the image was from the reference then.
struct ErrorPoint {
    double seconds = 0;
    double rmse = 0;
};

/// Everything the window shows, without any graphics.
class ViewModel {
public:
    /// \param name  of the image, for people
    /// \param job   whose image is shown, outlives the model; null: setImage() tells
    ViewModel(std::string name, RenderJob *job);

    void setImage(nori::Bitmap image);

    /// \param name  for people; an image of another size is stretched and gives no error numbers
    void setReference(nori::Bitmap image, std::string name);

    /// Reads an EXR as the reference; what is wrong with it becomes the note of the status line.
    void loadReference(const std::string &file);

    /// Takes over what the job has rendered since the last call.
    void refresh();

    RenderJob *job() const { return m_job; }

    bool hasImage() const { return m_image.size() > 0; }

    bool hasReference() const { return m_reference.size() > 0; }

    const nori::Bitmap &image() const { return m_image; }

    const Look &look() const { return m_look; }

    void setLook(const Look &look);

    /// Exposure that makes the image's brightest hundredth white.
    void normalize();

    /// Exposure 0, everything in the window.
    void reset();

    /// \param hold  true: the reference is shown in place of the image, as long as a key is held
    void holdReference(bool hold);

    /// The shown image in colours; shape [rows, columns].
    const std::vector<std::uint32_t> &colors();

    /// Changes with colors().
    unsigned revision() const { return m_revision; }

    // Where the image is: its pixel `center` in the middle of the area, `zoom` points of the
    // screen wide each.

    /// Size of the area that shows the image [points of the screen].
    void setArea(double width, double height);
    void fit();

    /// \param x, y  point of the area that stays where it is
    void zoomBy(double factor, double x, double y);
    void panBy(double dx, double dy);

    double zoom() const { return m_zoom; }

    /// From pixels of the image to points of the area.
    std::array<double, 2> toArea(double column, double row) const;
    std::array<double, 2> toImage(double x, double y) const;

    // The pixel that is looked at.

    const std::optional<nori::Point2i> &cursor() const { return m_cursor; }

    /// Where the cursor is in the area; its middle when there is none.
    std::array<double, 2> cursorInArea() const;

    /// Nothing when the point of the area is outside of the image.
    void pointAt(double x, double y);

    /// One step from the middle of what is seen if there is no cursor yet; what is left is scrolled
    /// after.
    void moveCursor(int columns, int rows);

    /// Goes to the next pixel that is not a number, infinite or negative.
    void findFaulty();

    const ImageSummary &summary() const { return m_summary; }

    const std::optional<ImageError> &error() const { return m_error; }

    const std::vector<ErrorPoint> &history() const { return m_history; }

    /// What is known of the pixel under the cursor.
    std::vector<std::string> pixelLines() const;
    /// The same, to be pasted: `(x, y) = (r, g, b)`.
    std::string pixelText() const;
    /// What is compared with what.
    std::string referenceLine() const;
    std::string title() const;
    std::string statusLine() const;

    void setNote(std::string note) { m_note = std::move(note); }

private:
    void update();
    void showCursor();
    void limitCenter();

    std::string m_name;
    RenderJob *m_job;
    unsigned m_jobRevision = 0;
    nori::Bitmap m_image;
    nori::Bitmap m_reference; ///< of the image's size
    nori::Bitmap m_original;  ///< as it was read
    std::string m_referenceName;
    ImageSummary m_summary;
    std::optional<ImageError> m_error;
    std::vector<ErrorPoint> m_history;
    Look m_look;
    bool m_hold = false;
    std::vector<std::uint32_t> m_colors;
    bool m_stale = true;
    unsigned m_revision = 0;
    double m_width = 1;
    double m_height = 1;
    bool m_fits = true;
    double m_zoom = 1;
    std::array<double, 2> m_center{};
    std::optional<nori::Point2i> m_cursor;
    std::string m_note;
};

} // namespace preview
