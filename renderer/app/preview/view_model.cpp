// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <preview/view_model.h>

namespace preview {

namespace {

constexpr double kMinZoom = 1.0 / 16.0;
constexpr double kMaxZoom = 128.0;
constexpr double kMaxExposure = 20.0;
constexpr double kBrightest = 0.99; ///< share of the pixels that normalize() leaves below white

std::string values(const nori::Color3f &value) {
    return fmt::format("{:.6g}  {:.6g}  {:.6g}", value[0], value[1], value[2]);
}

std::string duration(double seconds) {
    const auto s = static_cast<long>(std::lround(seconds));
    return s >= 3600 ? fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
                     : fmt::format("{}:{:02}", s / 60, s % 60);
}

} // namespace

ViewModel::ViewModel(std::string name, RenderJob *job) : m_name(std::move(name)), m_job(job) {}

void ViewModel::setImage(nori::Bitmap image) {
    const bool isOther = image.rows() != m_image.rows() || image.cols() != m_image.cols();
    m_image = std::move(image);
    if (isOther && m_original.size() > 0)
        m_reference = resized(m_original, m_image.rows(), m_image.cols());
    if (isOther)
        fit();
    update();
}

void ViewModel::setReference(nori::Bitmap image, std::string name) {
    m_original = std::move(image);
    m_referenceName = std::move(name);
    m_reference = m_original;
    if (hasImage())
        m_reference = resized(m_original, m_image.rows(), m_image.cols());
    m_history.clear();
    update();
}

void ViewModel::loadReference(const std::string &file) {
    try {
        setReference(nori::Bitmap(file), file);
        m_note = "compared with " + std::filesystem::path(file).filename().string();
    } catch (const std::exception &error) {
        m_note = error.what();
    }
}

void ViewModel::refresh() {
    if (m_job == nullptr || m_job->revision() == m_jobRevision)
        return;
    m_jobRevision = m_job->revision();
    const Progress progress = m_job->progress();
    setImage(m_job->image());
    if (m_error && progress.seconds > 0)
        m_history.push_back({progress.seconds, m_error->rmse});
}

void ViewModel::update() {
    m_summary = summarize(m_image);
    m_error = m_original.size() > 0 ? measureError(m_image, m_original) : std::nullopt;
    m_stale = true;
}

void ViewModel::setLook(const Look &look) {
    if (look == m_look)
        return;
    m_look = look;
    m_look.exposure = std::clamp(m_look.exposure, -kMaxExposure, kMaxExposure);
    m_look.split = std::clamp(m_look.split, 0.0, 1.0);
    m_stale = true;
}

void ViewModel::normalize() {
    std::vector<float> brightness;
    for (Eigen::Index i = 0; i < m_image.size(); ++i) {
        const float value = m_image.data()[i].maxCoeff();
        if (std::isfinite(value))
            brightness.push_back(value);
    }
    if (brightness.empty())
        return;
    const auto place =
        static_cast<std::ptrdiff_t>(kBrightest * static_cast<double>(brightness.size() - 1));
    std::nth_element(brightness.begin(), brightness.begin() + place, brightness.end());
    const float white = brightness[static_cast<size_t>(place)];
    Look look = m_look;
    look.exposure = white > 0 ? -std::log2(static_cast<double>(white)) : 0.0;
    setLook(look);
}

void ViewModel::reset() {
    Look look = m_look;
    look.exposure = 0;
    look.split = 0.5;
    setLook(look);
    fit();
}

void ViewModel::holdReference(bool hold) {
    m_stale = m_stale || hold != m_hold;
    m_hold = hold;
}

const std::vector<std::uint32_t> &ViewModel::colors() {
    if (m_stale) {
        Look look = m_look;
        if (m_hold)
            look.view = View::Reference;
        m_colors = colorize(m_image, hasReference() ? &m_reference : nullptr, look);
        m_stale = false;
        ++m_revision;
    }
    return m_colors;
}

void ViewModel::setArea(double width, double height) {
    m_width = std::max(width, 1.0);
    m_height = std::max(height, 1.0);
    if (m_fits)
        fit();
}

void ViewModel::fit() {
    m_fits = true;
    const auto columns = static_cast<double>(std::max<Eigen::Index>(m_image.cols(), 1));
    const auto rows = static_cast<double>(std::max<Eigen::Index>(m_image.rows(), 1));
    m_zoom = std::clamp(std::min(m_width / columns, m_height / rows), kMinZoom, kMaxZoom);
    m_center = {columns / 2, rows / 2};
}

void ViewModel::zoomBy(double factor, double x, double y) {
    const std::array<double, 2> before = toImage(x, y);
    m_fits = false;
    m_zoom = std::clamp(m_zoom * factor, kMinZoom, kMaxZoom);
    const std::array<double, 2> after = toImage(x, y);
    m_center = {m_center[0] + before[0] - after[0], m_center[1] + before[1] - after[1]};
    limitCenter();
}

void ViewModel::panBy(double dx, double dy) {
    m_fits = false;
    m_center = {m_center[0] - dx / m_zoom, m_center[1] - dy / m_zoom};
    limitCenter();
}

void ViewModel::limitCenter() {
    m_center = {std::clamp(m_center[0], 0.0, static_cast<double>(m_image.cols())),
                std::clamp(m_center[1], 0.0, static_cast<double>(m_image.rows()))};
}

std::array<double, 2> ViewModel::toArea(double column, double row) const {
    return {m_width / 2 + (column - m_center[0]) * m_zoom,
            m_height / 2 + (row - m_center[1]) * m_zoom};
}

std::array<double, 2> ViewModel::toImage(double x, double y) const {
    return {m_center[0] + (x - m_width / 2) / m_zoom, m_center[1] + (y - m_height / 2) / m_zoom};
}

std::array<double, 2> ViewModel::cursorInArea() const {
    if (!m_cursor)
        return {m_width / 2, m_height / 2};
    return toArea(m_cursor->x() + 0.5, m_cursor->y() + 0.5);
}

void ViewModel::pointAt(double x, double y) {
    const std::array<double, 2> at = toImage(x, y);
    const nori::Point2i pixel(static_cast<int>(std::floor(at[0])),
                              static_cast<int>(std::floor(at[1])));
    const bool isInside = pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < m_image.cols() &&
                          pixel.y() < m_image.rows();
    m_cursor = isInside ? std::optional<nori::Point2i>(pixel) : std::nullopt;
}

void ViewModel::moveCursor(int columns, int rows) {
    if (!hasImage())
        return;
    const nori::Point2i from =
        m_cursor ? *m_cursor
                 : nori::Point2i(static_cast<int>(m_center[0]), static_cast<int>(m_center[1]));
    m_cursor =
        nori::Point2i(std::clamp(from.x() + columns, 0, static_cast<int>(m_image.cols()) - 1),
                      std::clamp(from.y() + rows, 0, static_cast<int>(m_image.rows()) - 1));
    showCursor();
}

void ViewModel::showCursor() {
    const std::array<double, 2> at = toArea(m_cursor->x() + 0.5, m_cursor->y() + 0.5);
    const std::array<double, 2> size{m_width, m_height};
    for (size_t i = 0; i < 2; ++i) {
        const double margin = std::min(m_zoom, size[i] / 4);
        const double inside = std::clamp(at[i], margin, size[i] - margin);
        if (inside != at[i]) {
            m_fits = false;
            m_center[i] += (at[i] - inside) / m_zoom;
        }
    }
}

void ViewModel::findFaulty() {
    const auto number = [this](const nori::Point2i &p) {
        return p.y() * m_image.cols() + p.x();
    };
    const Eigen::Index here = m_cursor ? number(*m_cursor) : -1;
    for (Eigen::Index step = 1; step <= m_image.size(); ++step) {
        const Eigen::Index i = (here + step) % m_image.size();
        if (!isFaulty(m_image.data()[i]))
            continue;
        m_cursor = nori::Point2i(static_cast<int>(i % m_image.cols()),
                                 static_cast<int>(i / m_image.cols()));
        showCursor();
        return;
    }
    m_note = "no pixel is NaN, infinite or negative";
}

std::vector<std::string> ViewModel::pixelLines() const {
    if (!m_cursor || !hasImage())
        return {"point at a pixel, or walk with the arrow keys"};
    const nori::Color3f value = m_image.coeff(m_cursor->y(), m_cursor->x());
    std::vector<std::string> lines{fmt::format("({}, {})", m_cursor->x(), m_cursor->y()),
                                   "image  " + values(value)};
    if (hasReference()) {
        const nori::Color3f reference = m_reference.coeff(m_cursor->y(), m_cursor->x());
        lines.push_back("ref.   " + values(reference));
        lines.push_back(fmt::format("diff.  {:+.3g} %", 100 * signedDifference(value, reference)));
    }
    return lines;
}

std::string ViewModel::pixelText() const {
    if (!m_cursor || !hasImage())
        return "";
    const nori::Color3f value = m_image.coeff(m_cursor->y(), m_cursor->x());
    return fmt::format("({}, {}) = ({:.9g}, {:.9g}, {:.9g})", m_cursor->x(), m_cursor->y(),
                       value[0], value[1], value[2]);
}

std::string ViewModel::referenceLine() const {
    if (!hasReference())
        return "none: drop an .exr here, or give --reference FILE";
    std::string text = m_referenceName;
    if (hasImage() && (m_original.rows() != m_image.rows() || m_original.cols() != m_image.cols()))
        text +=
            fmt::format("\n{} x {} pixels, stretched: for numbers render with --size {}x{}",
                        m_original.cols(), m_original.rows(), m_original.cols(), m_original.rows());
    return text;
}

std::string ViewModel::title() const {
    if (m_job == nullptr)
        return m_name;
    const Progress progress = m_job->progress();
    return progress.phase == Phase::Finished
               ? m_name
               : fmt::format("{}: {:.0f} %", m_name, 100 * progress.fraction);
}

std::string ViewModel::statusLine() const {
    std::string text = m_name;
    if (hasImage())
        text += fmt::format("  {} x {}", m_image.cols(), m_image.rows());
    if (m_job != nullptr) {
        const Progress progress = m_job->progress();
        const std::string failure = m_job->error();
        if (!failure.empty())
            text += " · failed: " + failure;
        else if (progress.phase == Phase::Passes)
            text += fmt::format(" · preview, {} of {} spp", progress.passSamples,
                                progress.samplesPerPixel);
        else if (progress.phase == Phase::Blocks)
            text += fmt::format(" · {:.0f} % of the blocks have their {} spp",
                                100 * progress.blocks, progress.samplesPerPixel);
        else if (progress.phase == Phase::Finished)
            text += fmt::format(" · {} spp in {:.1f} s{}", progress.samplesPerPixel,
                                progress.seconds, progress.complete ? "" : ", stopped early");
        if (progress.phase != Phase::Finished && failure.empty()) {
            text += fmt::format(" · {}", duration(progress.seconds));
            if (progress.fraction > 0)
                text += fmt::format(", {} left", duration(progress.seconds / progress.fraction *
                                                          (1 - progress.fraction)));
            if (m_job->isPaused())
                text += " · paused";
        }
        if (progress.droppedSamples > 0)
            text += fmt::format(" · {} samples dropped (NaN, infinite or negative)",
                                progress.droppedSamples);
    }
    return m_note.empty() ? text : text + " · " + m_note;
}

} // namespace preview
