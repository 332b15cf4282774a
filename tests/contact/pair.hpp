#pragma once
// One contact with the state that a model holds for it, which can be evaluated, accepted and rolled back alone.

#include "contact/gauss/contact_area.hpp"
#include "contact/method/method.hpp"

namespace signorini::contact::test {

using Law = Method;

template <int D> class Pair {
public:
  Pair(Surface<D> slave, Master<D> master, const Law& law, int points, bool revolved = false,
       const Region<D>& where = {})
      : setting_{std::move(slave), std::move(master), points, revolved, where}, method_(law),
        formulation_(make_formulation(method_, setting_)), accepted_(initial_history(*formulation_)),
        present_(accepted_) {}
  Pair(Surface<D> slave, Surface<D> master, const Law& law, int points, bool revolved = false,
       const Region<D>& where = {})
      : Pair(std::move(slave), Master<D>(std::move(master)), law, points, revolved, where) {}
  Pair(Surface<D> slave, Obstacle<D> master, const Law& law, int points, bool revolved = false,
       const Region<D>& where = {})
      : Pair(std::move(slave), Master<D>(std::move(master)), law, points, revolved, where) {}
  Pair(const Pair& other)
      : setting_(other.setting_), method_(other.method_), formulation_(make_formulation(method_, setting_)),
        accepted_(other.accepted_), present_(other.present_), controls_(other.controls_), factor_(other.factor_),
        duration_(other.duration_), accepted_place_(other.accepted_place_), place_(other.place_) {
    for (History<D>* history : {&accepted_, &present_}) {
      for (auto& point : history->points) point.cleared = 0;
      for (auto& multiplier : history->multipliers) multiplier.cleared = 0;
    }
    go(accepted_place_);
    formulation_->return_to_accepted();
    go(place_);
  }
  Pair(Pair&&) = default;

  /// `extra`: values of the formulation's additional unknowns.
  void evaluate(const double* slave, const double* master, bool tangent = true, const double* extra = nullptr) {
    extra_ = extra;
    place_ = {copy(slave, formulation_->slave()), formulation_->master().rigid()
                                                      ? std::vector<double>(master, master + D)
                                                      : copy(master, *formulation_->master().surface())};
    formulation_->move(slave, master);
    evaluate_parts(tangent);
  }
  void evaluate_parts(bool tangent) {
    for (int part = 0; part < formulation_->parts(); ++part) formulation_->evaluate_part(part, trial(), tangent);
    formulation_->gather(trial(), tangent);
  }
  void accept() {
    formulation_->commit(present_, accepted_, factor_);
    accepted_ = present_;
    accepted_place_ = place_;
  }
  void rollback() {
    present_ = accepted_;
    go(accepted_place_);
    formulation_->return_to_accepted();
  }
  void fix_states(std::vector<FixedContactState> states) { controls_.fixed_states = std::move(states); }
  bool holds() const { return !controls_.fixed_states.empty(); }
  void guess(double distance, bool onward = false) {
    controls_.guessed = distance;
    controls_.onward = onward;
  }
  void land(bool landing) { controls_.all_stick = landing; }
  void scale_penalty(double factor) { factor_ = factor; }
  void take(double duration) { duration_ = duration; }
  const History<D>& history() const { return accepted_; }
  const History<D>& present() const { return present_; }
  void restore(const History<D>& history) {
    accepted_ = history;
    rollback();
  }

  const Formulation<D>& formulation() const { return *formulation_; }
  int extra_unknowns() const { return formulation_->extra_unknowns(); }
  const Surface<D>& slave() const { return formulation_->slave(); }
  const Master<D>& master() const { return formulation_->master(); }
  const std::vector<Block>& blocks() const { return formulation_->blocks(); }
  const std::vector<PointResult<D>>& results() const { return present_.results; }
  const std::vector<MultiplierResult<D>>& multipliers() const { return present_.multiplier_results; }
  const std::vector<PointResult<D>>& accepted_results() const { return accepted_.results; }
  const std::vector<Vec<D>>& reference_positions() const { return formulation_->points().reference; }
  Resultant<D> resultant() const { return contact::resultant(present_); }
  double area() const { return contact_area(*formulation_, present_, false, 1).area; }
  double stiffness() const { return formulation_->stiffness(present_, factor_); }
  double potential() const { return contact::potential(*formulation_, present_); }
  double dissipated() const { return accepted_.dissipated; }
  std::vector<double> gaps() const { return contact::gaps(*formulation_, present_); }

private:
  struct Place {
    std::vector<double> slave, master;
  };
  Trial<D> trial() { return {present_, accepted_, controls_, factor_, extra_, duration_}; }
  static std::vector<double> copy(const double* displacement, const Surface<D>& face) {
    int last = 0;
    for (int i = 0; i < face.functions(); ++i) last = std::max(last, face.body_function(i));
    return {displacement, displacement + D * (last + 1)};
  }
  void go(const Place& place) {
    if (!place.slave.empty()) formulation_->move(place.slave.data(), place.master.data());
  }

  ContactSetting<D> setting_;
  Method method_;
  std::unique_ptr<Formulation<D>> formulation_;
  History<D> accepted_, present_;
  Controls controls_;
  double factor_ = 1, duration_ = 0;
  const double* extra_ = nullptr;
  Place accepted_place_, place_;
};

} // namespace signorini::contact::test
