#pragma once
// Checkpoints: files that hold a model, its scene and its accepted state, from which it goes on with the same bits.

#include "model/model.hpp"

#include <memory>
#include <string>
#include <variant>

namespace signorini::model {

/// Writes the scene and the accepted state, with a text for the caller's own use; the file is whole or the old one;
/// `durable`: on the disk on return, so that it outlives the machine's power, not only the process. The model is
/// settled first (Model::settle): from here on it and one that is loaded from the file give the same bits on one kind
/// of processor. Call it when no step is pending. Throws Error when the file cannot be written.
template <int D> void save(Model<D>& model, const std::string& file, const std::string& text = {}, bool durable = true);

/// A model's scene and a state of it, as bytes to compare.
template <int D> std::string content(const Model<D>& model, const Snapshot<D>& state);

using AnyModel = std::variant<std::shared_ptr<Model<2>>, std::shared_ptr<Model<3>>>;
/// The model of a file, made anew. Throws Error when the file is missing, foreign, of another format, or damaged.
AnyModel load(const std::string& file);
/// The text of a file. Throws as load() does.
std::string load_text(const std::string& file);
/// Brings a model to the state of a file. Throws Error as load() does, and when the file is of another scene: it says
/// what differs. The model is then as it was.
template <int D> void restore(Model<D>& model, const std::string& file);

} // namespace signorini::model
