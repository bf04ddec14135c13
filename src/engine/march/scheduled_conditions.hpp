// The conditions that a schedule prescribes: puts a model into those of a time.
//
// Motion is computed in axes at rest, where a turn brings in no forces of its own: held nodes move,
// and water stands still but for its current and waves.
#pragma once

#include <vector>

#include "../model/changing_model.hpp"
#include "conditions.hpp"
#include "schedule.hpp"

namespace codend {

class ScheduledConditions : public Conditions {
 public:
  // The model is changed as time goes (ChangingModel), the assembly over it told. It is given with all
  // growing elements at factor 1 and no rope broken. start: where held nodes are that the schedule does not move.
  // Throws InputError where the schedule does not fit the model (check_schedule()).
  ScheduledConditions(Model& model, Assembly& assembly, Schedule schedule, const Motion& start);

  void to_time(double time, Side side, Motion& motion) override;
  // A rope that breaks loses one bar; its weight stays on the nodes. The water behind netting
  // slows after the netting has moved, so that its speed is that of the step before.
  bool broken_at(const Motion& now) override;
  double longest_step() const override;

  Schedule& schedule() { return schedule_; }
  const Schedule& schedule() const { return schedule_; }
  // What others than the schedule change.
  ChangingModel& model() { return model_; }

 private:
  void swing_body(double time, Side side, const ScheduledValues& values, Motion& motion) const;
  void stick();
  void keep_anchors();
  void grow(const ScheduledValues& values);
  // What a controlled rope's weight and buoyancy pull at its end, N.
  Vector end_load(const GrowingGroup& group) const;
  void release(double time);
  void break_rope(Rupture& rope, int bar, double time);

  ChangingModel model_;
  Assembly& assembly_;
  Schedule schedule_;
  Motion start_;
  std::vector<double> mass_, load_, buoyancy_;  // without growing groups
  bool sticks_ = false;                         // something to the ground
  bool answers_ = false;                        // to the motion, after every step
  double wake_time_;                            // s
  std::vector<double> factor_, rate_;           // of the groups, as the model has them
  std::vector<char> held_back_;                 // per node: 1 until it is released
  double all_released_ = 0.0, time_ = 0.0;      // s
};

}  // namespace codend
