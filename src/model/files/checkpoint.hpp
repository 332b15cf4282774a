#pragma once
// Checkpoints: files with a model's scene and accepted state, from which it continues with bitwise equal results.

#include "model/steps/model.hpp"

#include <memory>
#include <string>
#include <variant>

namespace signorini::model {

/// Writes the scene, the accepted state and a text of the caller atomically; `durable`: the data are on disk on return,
/// so that the file survives a power failure, too. The model is settled first (settle() in model.hpp), so that it and
/// a model loaded from the file give bitwise equal results on the same kind of processor. No step may be pending.
/// Throws Error if the file cannot be written.
template <int D> void save(Model<D>& model, const std::string& file, const std::string& text = {}, bool durable = true);

/// A model's scene and a state of it as bytes, for comparison.
template <int D> std::string content(const Model<D>& model, const Snapshot<D>& state);

using AnyModel = std::variant<std::shared_ptr<Model<2>>, std::shared_ptr<Model<3>>>;
/// Makes the model of a file. Throws Error if the file is missing, not a checkpoint, of another format, or damaged.
AnyModel load(const std::string& file);
/// The text of a file. Throws like load().
std::string load_text(const std::string& file);
/// Restores a model to the state of a file; where layers have followed the contact, it becomes another model of the
/// same scene. Throws Error like load(), and if the file's scene differs, with the names of the parts that differ; the
/// model is then unchanged.
template <int D> void restore(std::shared_ptr<Model<D>>& model, const std::string& file);

} // namespace signorini::model
