// Applies a schedule to a model over time.
//
// Motion is computed in a frame at rest, without inertial forces: fixed nodes move, and the water
// moves only by its current and waves.
#pragma once

#include <vector>

#include "../model/changing_model.hpp"
#include "conditions.hpp"
#include "schedule.hpp"

namespace codend {

class ScheduledConditions : public Conditions {
 public:
  // Changes the model and its assembly over time (ChangingModel). The model must have all growing
  // elements at factor 1 and no broken rope. start: positions of fixed nodes that the schedule does
  // not move. Throws InputError if the schedule does not fit the model (check_schedule()).
  ScheduledConditions(Model& model, Assembly& assembly, Schedule schedule, const Motion& start);

  void to_time(double time, Side side, Motion& motion) override;
  // A broken rope loses one bar but keeps its weight. The wake has a delay of one step.
  bool broken_at(const Motion& now) override;
  double longest_step() const override;

  Schedule& schedule() { return schedule_; }
  const Schedule& schedule() const { return schedule_; }
  // Returns the schedule with its controlled lengths at a time (s).
  Schedule schedule_at(double time) const;
  // For changes that are not part of the schedule.
  ChangingModel& model() { return model_; }

 private:
  void swing_body(double time, Side side, const ScheduledValues& values, Motion& motion) const;
  void stick();
  void keep_anchors();
  void grow(const ScheduledValues& values);
  // Returns the weight and buoyancy of a controlled rope at its end node, N.
  Vector end_load(const GrowingGroup& group) const;
  void release(double time);
  void break_rope(Rupture& rope, int bar, double time);

  ChangingModel model_;
  Assembly& assembly_;
  Schedule schedule_;
  Motion start_;
  std::vector<double> mass_, load_, buoyancy_;  // without growing groups
  bool sticks_ = false;                         // static friction is active
  bool answers_ = false;                        // conditions depend on the motion
  double wake_time_;                            // s
  std::vector<double> factor_, rate_;           // of the groups, as applied to the model
  std::vector<char> held_back_;                 // per node: 1 until its release
  double all_released_ = 0.0, time_ = 0.0;      // s
};

}  // namespace codend
