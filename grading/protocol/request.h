// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// What the grader may ask a probe, and what comes back. The only code that runs on both sides of
/// the trust boundary: C++17, standard library only, and it believes nothing that it decodes.
namespace protocol {

/// The questions. `text`, `index`, `repeats`, `seed`, `parameter` and `values` are Request's
/// members; all arrays are row-major floats. Directions and points are in world space.
enum class Op : std::uint32_t {
    /// text: warp id of the catalogue (`triangle`); parameter: alpha where the warp has one;
    /// values: samples u [n, 2] -> points [n, 2] (planar warps) or [n, 3].
    WarpSample = 1,
    /// text, parameter as above; values: points [n, 2 or 3] -> densities [n].
    WarpDensity,
    /// text: scene file; index: mesh in document order; values: samples [n, 2]
    /// -> [n, 8]: p (3), n (3), uv (2).
    MeshSample,
    /// text: scene file; index: mesh; values: points [n, 3] -> Mesh::pdf [n].
    MeshDensity,
    /// text: scene file; index: emitter in the order of Scene::getLights(); values: [n, 6]: ref
    /// (3),
    /// sample (2), optional_u -> [n, 21]: returned value (3), then of the record after the call
    /// p (3), n (3), uv (2), wi (3), dist, pdf; then Emitter::pdf(record), Emitter::eval(record)
    /// (3), and 1 if record.emitter is this emitter (else 0). repeats: threads that share the rows.
    EmitterSample,
    /// text, index as above; values: [n, 11]: ref, p, n (3 each), uv (2), from which the record is
    /// made by its five-argument constructor -> [n, 4]: eval (3), pdf.
    EmitterEval,
    /// text: scene file; values: u [n] -> [n, 3]: position of the emitter that
    /// Scene::sampleEmitter returned in Scene::getLights() (-1: none of them), its pdf,
    /// Scene::pdfEmitter of it.
    EmitterPick,
    /// text: scene file; values: rays [n, 6] (origin, direction); repeats k; seed
    /// -> Integrator::Li [n, k, 3]. The sampler is seeded anew for each ray from (seed, its index).
    Radiance,
    /// text: scene file -> [5]: emitter count, mesh count, then 1/0: first emitter is delta,
    /// has an environment, integrator present. Tells whether the scene loads at all.
    SceneFacts,
    /// text: scene file; values: pixels [n], row by row from the top left one of the scene's
    /// camera;
    /// repeats k; seed -> Integrator::Li [n, k, 3] through points uniform in each pixel (a box
    /// filter). The sampler is seeded anew for each pixel from (seed, the pixel). index: threads
    /// that share the pixels, but for one; if any, each gives way before every number it draws.
    Image,
    /// text: scene file; values: points [n, 2] of the scene's camera's image, in pixels from its
    /// top left corner; repeats k; seed -> Integrator::Li [n, k, 3]. The sampler is seeded anew
    /// for each point from (seed, its index).
    Film,
};

constexpr std::uint32_t kPlanarDimension = 2;
constexpr std::uint32_t kDirectionDimension = 3;
constexpr std::uint32_t kMeshSampleSize = 8;
constexpr std::uint32_t kEmitterSampleInput = 6;
constexpr std::uint32_t kEmitterSampleSize = 21;
constexpr std::uint32_t kEmitterEvalSize = 4;
constexpr std::uint32_t kEmitterPickSize = 3;
constexpr std::uint32_t kSceneFactsSize = 5;

struct Request {
    Op op = Op::WarpSample;
    std::string text;
    std::uint32_t index = 0;
    std::uint32_t repeats = 1;
    std::uint64_t seed = 0;
    float parameter = 0;
    std::vector<float> values;

    /// Floats in the answer to this request.
    /// \throws std::invalid_argument  if `values` has not the shape that `op` asks for, or the warp
    ///                                is unknown.
    std::size_t resultSize() const;
};

/// 2 for planar warps, 3 for directions.
/// \throws std::invalid_argument  if `id` is none of the catalogue's
std::uint32_t warpDimension(const std::string &id);

/// A file that the probe writes below its private temporary folder before it answers; scene files
/// are named by `Request::text` relative to it.
struct File {
    std::string name; ///< plain name or relative path, `/` separates, no `..`
    std::string bytes;
};

/// What one probe process is asked: one process per group.
struct RequestGroup {
    std::vector<File> files;
    std::vector<Request> requests;
};

enum class State : std::uint32_t {
    Pending = 0x7fc01234u, ///< no answer: what the shared memory is filled with at first
    Done = 1,
    Threw = 2, ///< the submission threw; see message
};

struct Response {
    State state = State::Pending;
    std::string message;       ///< of the exception, capped
    double cpuSeconds = 0;     ///< as the probe says: for people, never for a verdict
    std::vector<float> values; ///< Request::resultSize() floats when Done, else empty
};

/// \throws std::length_error  beyond 4 GiB
std::string encode(const RequestGroup &group);

/// \throws std::runtime_error  on anything that encode() could not have written
RequestGroup decode(const char *data, std::size_t size);

/// Layout of the answers in shared memory: one slot per request, in order, at fixed offsets which
/// both sides compute from the requests. A slot is written value first, state last.
struct SlotLayout {
    std::vector<std::size_t> offsets; ///< of each slot [bytes]
    std::size_t size = 0;             ///< of all slots [bytes]
};

SlotLayout slotLayout(const RequestGroup &group);

/// Fills the memory with Pending states and NaN values. Trusted side, before the probe starts.
void clearSlots(const SlotLayout &layout, char *memory);

/// Writes one answer. Probe side.
void writeSlot(const SlotLayout &layout, std::size_t request, const Response &response,
               char *memory);

/// Reads one answer from the grader's own copy of the memory. Anything malformed reads as Pending.
Response readSlot(const SlotLayout &layout, const RequestGroup &group, std::size_t request,
                  const char *memory);

} // namespace protocol
