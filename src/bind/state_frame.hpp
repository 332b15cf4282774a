#pragma once
// A model's state as pictures take it from the arguments of sg.picture and sg.frame.

#include "bind/frame.hpp"
#include "bind/functions.hpp"

#include <functional>
#include <variant>

namespace signorini::bind {

/// A state as it is drawn, and what its colours mean.
struct StateFrame {
  std::variant<view::Panel, view::SolidPanel> panel;
  std::string label;

  const std::string& title() const {
    return std::visit([](const auto& one) -> const std::string& { return one.title; }, panel);
  }
  void set_title(std::string title) {
    std::visit([&](auto& one) { one.title = std::move(title); }, panel);
  }
  std::size_t bodies() const {
    return std::visit([](const auto& one) { return one.bodies.size(); }, panel);
  }
  bool solid() const { return std::holds_alternative<view::SolidPanel>(panel); }
};

template <> struct Type<StateFrame> { static constexpr auto name = "frame"; };

/// The arguments that say what is shown of a state.
extern const std::vector<std::string> state_keys;

/// The arguments `field`, which is empty where none is given, and `fields`, or `field` where there is no list.
std::string read_field(const Options& o);
std::vector<std::string> read_fields(lua_State* L, const Options& o);

/// The argument `cut`.
std::optional<Cut> read_cut(lua_State* L, const Options& o);

/// What is shown larger than the whole, in the plane or in space.
using ReadWindows = std::function<std::vector<Window>(bool solid)>;

/// The state in which the argument `model` is, as each of the fields shows it.
std::vector<StateFrame> read_state(lua_State* L, const Options& o, const std::vector<std::string>& fields,
                                   const ReadWindows& windows);

/// The states of a run that the argument `states` lists, each with its title: by field, then by state. The models are
/// put back into their present states.
std::vector<std::vector<StateFrame>> read_states(lua_State* L, const Options& o, const std::vector<std::string>& fields,
                                                 const ReadWindows& windows);

} // namespace signorini::bind
